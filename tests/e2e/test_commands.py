# SPDX-License-Identifier: Apache-2.0
"""Every oiiotool command that takes a filter, with nothing but the plugin path set."""

import os
import unittest

from support import DDT, PLUGINS, Case, is_symbolic

# Command with FILTER in place of the filter, its argument, and the size of a 40x32 image's result.
COMMANDS = {
    "resize": ("--resize:filter=FILTER", "160x128", (160, 128)),
    "percent": ("--resize:filter=FILTER", "250%x400%", (100, 128)),
    "fit": ("--fit:filter=FILTER", "200x200", (200, 160)),
    "exact": ("--fit:exact=1:filter=FILTER", "201x203", (201, 203)),
    "aspect": ("--pixelaspect:filter=FILTER", "0.5", (80, 32)),
    "rotate": ("--rotate:filter=FILTER", "30", (40, 32)),
    "turn": ("--rotate:recompute_roi=1:filter=FILTER", "45", (50, 50)),
    "warp": ("--warp:recompute_roi=1:filter=FILTER", "2,0.3,0,-0.2,2.5,0,0,0,1", (85, 90)),
}


class Commands(Case):
    def make_all(self, image, filter, extension):
        """Run every command on the image, in one process; return the files' names."""
        arguments, made = [], {}
        for name, (command, argument, _) in COMMANDS.items():
            made[name] = name + extension
            # PNG and TIFF cannot hold pixels left of or above 0.
            arguments += ["--dup", command.replace("FILTER", filter), argument, "--origin", "+0+0",
                          "--fullpixels", "-o", made[name], "--pop"]
        self.succeed("oiiotool", image, *arguments)
        return made

    def test_each_command_on_each_format(self):
        for image in ("photo.png", "photo.tif", "scene.exr"):
            source = self.extrema(image)
            for name, out in self.make_all(image, "ddt", image[-4:]).items():
                with self.subTest(command=name, image=image):
                    self.assertEqual(self.size(out), COMMANDS[name][2])
                    # Within the source's range and black: no ringing, but something there.
                    for (low, high), (least, most) in zip(self.extrema(out), source):
                        self.assertGreaterEqual(low, min(least, 0.0))
                        self.assertLessEqual(high, most)
                        self.assertGreater(high, 0.3 * most)

    def check_all_differ(self, image, filters):
        made = {}
        for filter in filters:
            for name, out in self.make_all(image, filter, image[-4:]).items():
                made.setdefault(name, {})[filter] = tuple(self.hashes(out))
        for name, hashes in made.items():
            with self.subTest(command=name):
                self.assertEqual(len(set(hashes.values())), len(filters), hashes)

    def test_the_filter_is_ours(self):
        self.check_all_differ("photo.tif", ("ddt", "ddt-linear", "ddt-sharp", "triangle",
                                          "lanczos3"))

    def test_options_reach_the_filter(self):
        self.check_all_differ("photo.png",
                              ("ddt", "ddt,scheme=pixel", "ddt,scheme=pixel,light=encoded"))

    def test_info_tells_what_is_redirected(self):
        done = self.succeed(DDT, "info")
        self.assertRegex(done, r"plugin +/.*ddt\.imageio\.so\n")
        self.assertRegex(done, r"plugin +(\d+) of \1 filter functions redirected in \d+ places?")
        self.assertRegex(done, r"plugin +(\d+) of \1 ImageBufAlgo functions redirected in \d+ places?")
        for line in done.splitlines():
            if "missed" in line:
                self.assertIn("which is linked with -Bsymbolic-functions", line)

    def test_info_tells_how_many_threads_a_job_has(self):
        done = self.succeed(DDT, "info", OPENIMAGEIO_THREADS="1")
        self.assertRegex(done, "(?m)^cpu +1 thread$")
        many = os.cpu_count() + 3
        done = self.succeed(DDT, "info", OPENIMAGEIO_THREADS=str(many))
        self.assertRegex(done, f"(?m)^cpu +{many} threads$")

    def test_info_says_why_a_device_is_not_used(self):
        done = self.succeed(DDT, "info",
                            **{"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"})
        self.assertRegex(done, r"(?m)^egl +not used: (?!egl)\S")

    def test_plugin_path_by_attribute(self):
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "300%", "-o", "a.png")
        self.succeed("oiiotool", "--oiioattrib", "plugin_searchpath", PLUGINS, "photo.png",
                     "--resize:filter=ddt", "300%", "-o", "b.png", plugin=False)
        self.assert_same("a.png", "b.png")

    def test_help_lists_the_filters(self):
        # Wrapped at a terminal's width, where there is one.
        listed = self.succeed("oiiotool", "--help").partition("Filters available:")[2]
        names = listed.partition(":")[0].replace(",", " ").split()
        for name in ("ddt", "ddt-linear", "ddt-sharp"):
            self.assertIn(name, names)

    def test_fit_matches_resize(self):
        self.succeed("oiiotool", "photo.png", "--fit:filter=ddt", "160x200", "--fullpixels", "-o",
                     "fit.png")
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "160x128", "-o", "resize.png")
        self.assert_same("fit.png", "resize.png")

    def test_windows(self):
        for filter in ("ddt", "lanczos3"):
            self.succeed("oiiotool", "window.exr", f"--resize:filter={filter}", "300%", "-o",
                         f"{filter}.exr")
        ours, stock = (self.load(f).spec() for f in ("ddt.exr", "lanczos3.exr"))
        self.assertEqual(ours.roi, stock.roi)
        self.assertEqual(ours.roi_full, stock.roi_full)
        self.assertEqual(ours.full_width, 108)

    def test_subimages(self):
        self.succeed("oiiotool", "scene.exr", "scene.exr", "--flip", "--mulc", "0.5", "--siappend",
                     "-o", "two.exr")
        self.succeed("oiiotool", "-a", "two.exr", "--resize:filter=ddt", "200%", "-o", "out.exr")
        for i in (0, 1):
            self.succeed("oiiotool", "-a", "two.exr", "--subimage", str(i),
                         "--resize:filter=ddt", "200%", "-o", f"{i}.exr")
        self.assertEqual(self.hashes("out.exr"), self.hashes("0.exr") + self.hashes("1.exr"))
        self.assertEqual(len(set(self.hashes("out.exr"))), 2)

    def test_threads_change_nothing(self):
        for threads in ("1", "2", "7"):
            # TBB may say that there are fewer processors.
            done = self.attempt("oiiotool", "--threads", threads, "scene.exr",
                                "--resize:filter=ddt", "700%", "-o", f"{threads}.exr")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same("1.exr", "2.exr")
        self.assert_same("1.exr", "7.exr")

    def test_same_size_gives_the_same_pixels(self):
        self.succeed("oiiotool", "photo.tif", "--resize:filter=ddt", "40x32", "-o", "out.tif")
        self.assert_same("out.tif", "photo.tif")

    def test_several_operations_in_one_run(self):
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "200%", "--rotate:filter=ddt",
                     "10", "--resize:filter=lanczos3", "50%", "--fit:filter=ddt-linear",
                     "100x100", "--fullpixels", "-o", "out.png")
        self.assertEqual(self.size("out.png"), (100, 80))

    def test_from_to(self):
        release = self.release()
        if release < (2, 5):
            self.skipTest("--resize:from=:to= came with OpenImageIO 2.5")
        done = self.attempt("oiiotool", "photo.png",
                            "--resize:filter=ddt:from=10x8+4+4:to=100x80+0+0", "100x80", "-o",
                            "out.png")
        if is_symbolic() and release == (2, 5):
            # It looks for the filter itself then.
            self.assertEqual(done.returncode, 1)
            self.assertIn('Filter "ddt" not recognized', done.stderr)
            return
        self.assertEqual(done.returncode, 0, done.stderr)
        # 2.5 warps there, which is said.
        warps = ("ddt: a filter of ddt is evaluated pixel by pixel, as a tent: nothing is "
                 "triangulated here\n")
        self.assertEqual(done.stderr, warps if release == (2, 5) else "")
        self.assertEqual(self.size("out.png"), (100, 80))

    def test_verbose_talks_on_stderr_only_when_asked(self):
        done = self.attempt("oiiotool", "photo.png", "--resize:filter=ddt", "200%", "-o", "o.png",
                            DDT_VERBOSE="1")
        self.assertIn("filter functions redirected", done.stderr)
        self.assertNotIn("could not", done.stderr)


if __name__ == "__main__":
    unittest.main()
