# SPDX-License-Identifier: Apache-2.0
"""By its exit code `ddt` says what went wrong."""

import unittest

from process_case import ProcessCase
from support import DDT


class ExitCodes(ProcessCase):
    def test_exit_codes(self):
        for code, arguments in ((1, ("missing.png", "200%", "out.png")),
                                (1, ("photo.png", "200%", "no/folder.png")),
                                (2, ("photo.png", "large", "out.png")),
                                (2, ("photo.png", "200%", "out.png", "--progress", "loud")),
                                (3, ("photo.png", "1000000x1000000", "out.png"))):
            got, text = self.run_to_end("resize", *arguments)
            self.assertEqual(got, code, text)
            self.assertTrue(text.startswith("ddt: "), text)
        with open(self.path("points.csv"), "w", encoding="utf-8") as file:
            file.write("x,y,z\n0,0,1\n4,0,2\n0,4,3\n4,4,4\n")
        for command in (("resize", "photo.png", "200%", "out.png", "--filter", "ddt,device=egl"),
                        ("scatter", "points.csv", "out.exr", "--filter", "ddt,device=egl")):
            done = self.attempt(DDT, *command, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("is unavailable", done.stderr)

    def test_an_unknown_device_is_told_before_anything_is_opened(self):
        """Whose writer would complain by itself."""
        done = self.attempt(DDT, "resize", "photo.png", "250%", "out.png", DDT_DEVICE="voodoo")
        self.assertEqual((done.returncode, done.stderr), (
            1, "ddt: DDT_DEVICE=voodoo is not one of auto, cpu, egl, osmesa\n"))

    def test_a_light_that_there_is_not_is_wrong_usage(self):
        """Of `ddt stream` too, which knows others."""
        for command in (("resize", "photo.png", "250%", "out.png"), ("mesh", "photo.png", "out.ply"),
                        ("fill", "photo.png", "out.png"), ("stream",)):
            done = self.attempt(DDT, *command, "--filter", "ddt,light=dark")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn('light "dark" is not ', done.stderr)
            self.assertRegex(done.stderr, "(are|,) linear, ")


if __name__ == "__main__":
    unittest.main()
