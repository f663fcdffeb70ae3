"""Every oiiotool command that takes a filter, with nothing but the plugin path set."""

import unittest

from support import PLUGINS, Case

# Command with FILTER in place of the filter, its arguments, and the size of a 40x32 image's result.
COMMANDS = {
    "resize": ("--resize:filter=FILTER", "160x128", (160, 128)),
    "resize by percent": ("--resize:filter=FILTER", "250%x400%", (100, 128)),
    "fit": ("--fit:filter=FILTER", "200x200", (200, 160)),
    "exact fit": ("--fit:exact=1:filter=FILTER", "201x203", (201, 203)),
    "pixelaspect": ("--pixelaspect:filter=FILTER", "0.5", (80, 32)),
    "rotate": ("--rotate:filter=FILTER", "30", (40, 32)),
    "recomputed rotate": ("--rotate:recompute_roi=1:filter=FILTER", "45", (51, 51)),
    "warp": ("--warp:recompute_roi=1:filter=FILTER", "2,0.3,0,-0.2,2.5,0,0,0,1", (85, 90)),
}


class Commands(Case):
    def make(self, out, image, command, size, filter):
        self.succeed("oiiotool", image, command.replace("FILTER", filter), size, "-o", out)

    def test_each_command_on_each_format(self):
        for name, (command, size, expected) in COMMANDS.items():
            for image in ("photo.png", "photo.tif", "scene.exr"):
                with self.subTest(command=name, image=image):
                    out = image.replace(".", "-out.")
                    self.make(out, image, command, size, "ddt")
                    self.assertEqual(self.size(out), expected)
                    # Within the source's range and black: no ringing, but something there.
                    for (low, high), (least, most) in zip(self.extrema(out), self.extrema(image)):
                        self.assertGreaterEqual(low, min(least, 0.0))
                        self.assertLessEqual(high, most)
                        self.assertGreater(high, 0.3 * most)

    def test_the_filter_is_ours(self):
        for name, (command, size, _) in COMMANDS.items():
            with self.subTest(command=name):
                made = {}
                for filter in ("ddt", "ddt-linear", "triangle", "lanczos3"):
                    self.make("out.tif", "photo.tif", command, size, filter)
                    made[filter] = tuple(self.hashes("out.tif"))
                self.assertEqual(len(set(made.values())), 4, made)

    def test_options_reach_the_filter(self):
        for name, (command, size, _) in COMMANDS.items():
            with self.subTest(command=name):
                made = set()
                for filter in ("ddt", "ddt,scheme=pixel", "ddt,scheme=pixel,light=encoded"):
                    self.make("out.tif", "photo.png", command, size, filter)
                    made.add(tuple(self.hashes("out.tif")))
                self.assertEqual(len(made), 3)

    def test_plugin_path_by_attribute(self):
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "300%", "-o", "a.png")
        self.succeed("oiiotool", "--oiioattrib", "plugin_searchpath", PLUGINS, "photo.png",
                     "--resize:filter=ddt", "300%", "-o", "b.png", plugin=False)
        self.assert_same("a.png", "b.png")

    def test_help_lists_the_filters(self):
        for line in self.succeed("oiiotool", "--help").splitlines():
            if "Filters available" in line:
                names = line.replace(",", " ").split()
                break
        self.assertIn("ddt", names)
        self.assertIn("ddt-linear", names)

    def test_fit_matches_resize(self):
        self.succeed("oiiotool", "photo.png", "--fit:filter=ddt", "160x200", "-o", "fit.png")
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "160x128", "-o", "resize.png")
        self.assert_same("fit.png", "resize.png")

    def test_windows(self):
        how = ("window.exr", "--resize:filter=FILTER", "300%")
        self.make("ours.exr", *how, "ddt")
        self.make("stock.exr", *how, "lanczos3")
        ours, stock = (self.succeed("iinfo", "-v", f) for f in ("ours.exr", "stock.exr"))
        for text in ("pixel data origin", "full/display size", "full/display origin"):
            find = [line for line in stock.splitlines() if text in line]
            self.assertTrue(find, stock)
            self.assertIn(find[0], ours)

    def test_subimages(self):
        self.succeed("oiiotool", "scene.exr", "window.exr", "--siappend", "-o", "two.exr")
        self.succeed("oiiotool", "-a", "two.exr", "--resize:filter=ddt", "200%", "-o", "out.exr")
        self.assertEqual(len(self.hashes("out.exr")), 2)
        for i in (0, 1):
            self.succeed("oiiotool", "-a", "two.exr", "--subimage", str(i),
                         "--resize:filter=ddt", "200%", "-o", f"{i}.exr")
            self.succeed("oiiotool", "-a", "out.exr", "--subimage", str(i), "-o", f"of{i}.exr")
            self.assert_same(f"{i}.exr", f"of{i}.exr")

    def test_threads_change_nothing(self):
        for threads in ("1", "2", "7"):
            self.succeed("oiiotool", "--threads", threads, "scene.exr", "--resize:filter=ddt",
                         "700%", "-o", f"{threads}.exr")
        self.assert_same("1.exr", "2.exr")
        self.assert_same("1.exr", "7.exr")

    def test_same_size_gives_the_same_pixels(self):
        self.succeed("oiiotool", "photo.tif", "--resize:filter=ddt", "40x32", "-o", "out.tif")
        self.assert_same("out.tif", "photo.tif")

    def test_several_operations_in_one_run(self):
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "200%", "--rotate:filter=ddt",
                     "10", "--resize:filter=lanczos3", "50%", "--fit:filter=ddt-linear",
                     "100x100", "-o", "out.png")
        self.assertEqual(self.size("out.png"), (100, 80))

    def test_from_to(self):
        version = self.succeed("oiiotool", "--version").split(".")
        if (int(version[0]), int(version[1])) < (2, 5):
            self.skipTest("--resize:from=:to= came with OpenImageIO 2.5")
        self.succeed("oiiotool", "photo.png",
                     "--resize:filter=ddt:from=10x8+4+4:to=100x80+0+0", "100x80", "-o", "out.png")
        self.assertEqual(self.size("out.png"), (100, 80))

    def test_verbose_talks_on_stderr_only_when_asked(self):
        done = self.attempt("oiiotool", "photo.png", "--resize:filter=ddt", "200%", "-o", "o.png",
                            DDT_VERBOSE="1")
        self.assertIn("ddt: redirected", done.stderr)
        self.assertNotIn("could not", done.stderr)


if __name__ == "__main__":
    unittest.main()
