"""What is not ours is bit for bit what it is without the plugin."""

import unittest

from support import Case

FILTERS = ("box", "triangle", "gaussian", "catmull-rom", "blackman-harris", "lanczos3",
           "radial-lanczos3", "nuke-lanczos6", "mitchell", "disk", "rifman")

COMMANDS = (
    "--resize 300%", "--resize 37x50", "--fit 99x99", "--fit:exact=1 99x99", "--pixelaspect 0.4",
    "--rotate 17", "--warp 1.2,0.1,0,-0.2,1.4,0,3,1,1", "--resample 100x90", "--blur 5x5",
    "--blur:kernel=lanczos3 5x5", "--resize:highlightcomp=1 200%", "--unsharp",
)


class Stock(Case):
    def both(self, image, *arguments):
        out = f"out{image[-4:]}"
        for plugin in (False, True):
            # Something is read before, so that the plugin is there when the filter is chosen.
            self.succeed("oiiotool", image, *arguments, "-o", f"{plugin}-{out}", plugin=plugin)
        self.assert_same(f"False-{out}", f"True-{out}")

    def test_filters(self):
        for filter in FILTERS:
            with self.subTest(filter=filter):
                self.both("photo.png", f"--resize:filter={filter}", "250%",
                          f"--rotate:filter={filter}", "20", f"--fit:filter={filter}", "70x70")

    def test_commands(self):
        for command in COMMANDS:
            for image in ("photo.tif", "window.exr"):
                with self.subTest(command=command, image=image):
                    self.both(image, *command.split())

    def test_st_warp(self):
        self.succeed("oiiotool", "--pattern", "fill:topleft=0,0:topright=1,0:bottomleft=0,1:"
                     "bottomright=1,1", "50x40", "2", "-d", "float", "-o", "st.exr", plugin=False)
        for plugin in (False, True):
            self.succeed("oiiotool", "photo.tif", "st.exr", "--st_warp", "-o", f"{plugin}.tif",
                         plugin=plugin)
        self.assert_same("False.tif", "True.tif")

    def test_maketx(self):
        for arguments in ((), ("--filter", "lanczos3"), ("--resize",),
                          ("--filter", "catmull-rom", "--resize"), ("--sharpen", "0.5")):
            with self.subTest(arguments=arguments):
                for plugin in (False, True):
                    self.succeed("maketx", *arguments, "photo.tif", "-o", f"{plugin}.tx",
                                 plugin=plugin)
                self.assert_same("False.tx", "True.tx")

    def test_unknown_filter_says_the_same(self):
        said = [self.attempt("oiiotool", "photo.png", "--resize:filter=ddtx", "200%", "-o", "o.png",
                             plugin=plugin) for plugin in (False, True)]
        self.assertEqual(said[0].stderr, said[1].stderr)
        self.assertEqual(said[0].returncode, said[1].returncode)
        self.assertNotEqual(said[1].returncode, 0)


if __name__ == "__main__":
    unittest.main()
