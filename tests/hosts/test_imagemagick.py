# SPDX-License-Identifier: Apache-2.0
"""The filter module in Debian's `convert`, against oiiotool with the plugin."""

import os

import support

FOLDER = os.path.join(support.BUILD, "hosts", "imagemagick")


class ImageMagick(support.Case):
    IMAGES = {
        **support.Case.IMAGES,
        "deep.png": "photo.png -d uint16",
        "grey.png": "photo.png --ch 0 --chnames Y -d uint16",
    }

    def convert(self, *arguments):
        return self.attempt("convert", *arguments, MAGICK_CODER_FILTER_PATH=FOLDER)

    def enlarge(self, source, out, arguments, *before):
        done = self.convert(source, *before, "-process", f"ddt {arguments}", "-depth", "16", out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_the_filters_bits(self):
        for name in ("deep.png", "grey.png"):
            self.enlarge(name, "out.png", "3 ddt-sharp")
            self.succeed("oiiotool", name, "--resize:filter=ddt-sharp,light=sRGB", "300%", "-d",
                         "uint16", "-o", "wanted.png")
            self.assert_same("out.png", "wanted.png")

    def test_alpha_is_multiplied_in_floats(self):
        self.enlarge("photo.tif", "out.png", "2")
        self.assertEqual(self.size("out.png"), (80, 64))
        self.succeed("oiiotool", "--iconfig", "oiio:UnassociatedAlpha", "1", "out.png", "-o",
                     "straight.tif")
        # Nowhere out of the range of the picture's own alpha.
        self.assertEqual(len(self.extrema("straight.tif")), 4)

    def test_linear_images_stay_linear(self):
        self.enlarge("deep.png", "out.png", "2", "-set", "colorspace", "RGB")
        self.succeed("oiiotool", "deep.png", "--resize:filter=ddt,light=linear", "200%", "-d",
                     "uint16", "-o", "wanted.png")
        self.succeed("oiiotool", "deep.png", "--resize:filter=ddt,light=sRGB", "200%", "-d",
                     "uint16", "-o", "other.png")
        self.assert_different("out.png", "other.png")

    def test_errors_leave_no_picture(self):
        for arguments, says in (("", "scale"), ("0.5", "scale"), ("2 ddtx", "unknown filter"),
                                ("2 ddt,blur=7", "blur=7")):
            done = self.convert("photo.png", "-process", f"ddt {arguments}", "out.png")
            self.assertNotEqual(done.returncode, 0, arguments)
            self.assertIn(says, done.stderr)
            self.assertFalse(os.path.exists(self.path("out.png")))

    def test_other_colorspaces_are_refused(self):
        done = self.convert("photo.png", "-colorspace", "Lab", "-process", "ddt 2", "out.tif")
        self.assertIn("colorspace Lab", done.stderr)


if __name__ == "__main__":
    import unittest
    unittest.main()
