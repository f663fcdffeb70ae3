# SPDX-License-Identifier: Apache-2.0
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
    def check(self, image, commands):
        """Run each command on the image, without the plugin and with it, in one process each."""
        for plugin in (False, True):
            arguments = []
            for i, command in enumerate(commands):
                arguments += ["--dup", *command.split(), "-o", f"{plugin}-{i}{image[-4:]}", "--pop"]
            # The image is read first, so the plugin is there when filters are chosen.
            self.succeed("oiiotool", image, *arguments, plugin=plugin)
        for i, command in enumerate(commands):
            with self.subTest(image=image, command=command):
                self.assert_same(f"False-{i}{image[-4:]}", f"True-{i}{image[-4:]}")

    def test_filters(self):
        for image in ("photo.png", "scene.exr"):
            self.check(image, [f"--{command}:filter={filter} {size}" for filter in FILTERS
                               for command, size in (("resize", "250%"), ("resize", "50%"),
                                                     ("rotate", "20"), ("fit", "70x70"))])

    def test_commands(self):
        for image in ("photo.tif", "window.exr"):
            self.check(image, COMMANDS)

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
