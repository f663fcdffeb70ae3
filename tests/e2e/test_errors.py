# SPDX-License-Identifier: Apache-2.0
"""Bad input: one line that names the thing and what is allowed, a failing exit, no file."""

import unittest

from support import Case

# Those whose failure oiiotool passes on; --fit is not among them.
COMMANDS = (("--resize:filter=FILTER", "200%"), ("--pixelaspect:filter=FILTER", "0.5"),
            ("--rotate:filter=FILTER", "30"), ("--warp:filter=FILTER", "2,0,0,0,2,0,0,0,1"))


class Errors(Case):
    def refuse(self, filter, *says, commands=COMMANDS[:1]):
        for command, argument in commands:
            with self.subTest(command=command):
                self.fail_with("oiiotool", "photo.png", command.replace("FILTER", filter),
                               argument, "-o", "out.png", says=("ddt", *says), out="out.png")

    def test_unknown_option(self):
        self.refuse("ddt,nonsense=1", '"nonsense"', "allowed", "light", "scheme",
                    commands=COMMANDS)

    def test_unknown_value(self):
        self.refuse("ddt-linear,scheme=magic", '"scheme=magic"', "allowed", "one-round", "lawson")

    def test_option_without_value(self):
        self.refuse("ddt,scheme", '"scheme"', "allowed", "one-round")

    def test_number_out_of_range(self):
        self.refuse("ddt,iterations=1000", '"iterations=1000"', "400")

    def test_unknown_colour_space(self):
        self.refuse("ddt,light=nosuchspace", '"nosuchspace"', commands=COMMANDS)

    def test_missing_colour_config(self):
        self.fail_with("oiiotool", "photo.png", "--resize:filter=ddt,light=sRGB", "200%", "-o",
                       "out.png", says=("ddt", "nosuch.ocio"), out="out.png", OCIO="nosuch.ocio")

    def test_fit_survives_a_failure(self):
        done = self.attempt("oiiotool", "photo.png", "--fit:filter=ddt,nonsense=1", "90x90", "-o",
                            "out.png")
        self.assertGreaterEqual(done.returncode, 0, "killed by a signal")

    def test_deep_image(self):
        self.succeed("oiiotool", "scene.exr", "--ch", "R,G,B,A=0.5,Z=1", "--deepen", "-o",
                     "deep.exr", plugin=False)
        self.fail_with("oiiotool", "deep.exr", "--resize:filter=ddt", "200%", "-o", "out.exr",
                       says=("ddt", "deep"), out="out.exr")

    def test_absurd_size(self):
        if self.attempt("oiiotool", "photo.png", "--resize", "1000000x1000000", "-o", "out.png",
                        plugin=False).returncode < 0:
            self.skipTest("oiiotool itself aborts before it calls a filter (3.1)")
        self.fail_with("oiiotool", "photo.png", "--resize:filter=ddt", "1000000x1000000", "-o",
                       "out.png", says=("1000000 x 1000000", "allowed"), out="out.png")

    def test_zero_size(self):
        self.fail_with("oiiotool", "photo.png", "--resize:filter=ddt", "0x0", "-o", "out.png",
                       says=("ERROR",), out="out.png")

    def test_matrix_without_inverse(self):
        self.fail_with("oiiotool", "photo.png", "--warp:filter=ddt", "1,1,0,1,1,0,0,0,1", "-o",
                       "out.png", says=("ddt", "inverse"), out="out.png")

    def test_missing_file(self):
        self.fail_with("oiiotool", "nosuch.png", "--resize:filter=ddt", "200%", "-o", "out.png",
                       says=("nosuch.png",), out="out.png")


if __name__ == "__main__":
    unittest.main()
