# SPDX-License-Identifier: Apache-2.0
"""The filter module in Debian's `convert`, against oiiotool with the plugin."""

import os
import shutil
import unittest

import support

CONVERT = os.environ["DDT_CONVERT"]  # Debian's, whose library the module was built for
FOLDER = os.path.join(support.BUILD, "hosts", "imagemagick")
# As ImageMagick before some 7.1.2 calls it, and since.
FOUND_IN = {"MAGICK_CODER_FILTER_PATH": FOLDER, "MAGICK_FILTER_MODULE_PATH": FOLDER}
# ImageMagick's memory has floats.
HDRI = os.environ["DDT_MAGICK"].endswith("HDRI")
FLOATS = ("-define", "quantum:format=floating-point", "-depth", "32")


class ImageMagick(support.Case):
    # A photograph, a drawing with alpha, a lamp in linear light; ImageMagick has 16 bits in
    # memory, and with HDRI floats.
    IMAGES = {
        **support.Case.IMAGES,
        "deep.png": "photo.png -d uint16",
        "grey.png": "photo.png --ch 0 --chnames Y -d uint16",
        "straight.tif": "--pattern fill:topleft=0.9,0.1,0.2,0:topright=0.1,0.7,0.3,1:"
                        "bottomleft=0.2,0.3,0.8,0.5:bottomright=1,1,0,1 48x40 4 "
                        "--box:color=1,0,0,0:fill=1 10,6,20,30 "
                        "--attrib:type=int oiio:UnassociatedAlpha 1 -d uint16",
        "lamp.png": "scene.exr --clamp:min=0:max=1 -d uint16",
        "bright.tif": "scene.exr -d float",
    }

    def convert(self, *arguments):
        return self.attempt(CONVERT, *arguments, **FOUND_IN)

    def enlarge(self, source, out, arguments, *before):
        done = self.convert(source, *before, "-process", f"ddt {arguments}", "-depth", "16", out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_the_filters_bits(self):
        # ImageMagick takes the PNG's gamma of 1 as the colorspace RGB.
        for name, light in (("deep.png", "sRGB"), ("grey.png", "sRGB"), ("photo.png", "sRGB"),
                            ("lamp.png", "linear")):
            for filter in ("ddt", "ddt-sharp,cost=scf"):
                self.enlarge(name, "out.png", f"3 {filter}")
                self.succeed("oiiotool", name, f"--resize:filter={filter},light={light}",
                             "300%", "-d", "uint16", "-o", "wanted.png")
                self.assert_same("out.png", "wanted.png")

    def test_linear_images_stay_linear(self):
        for name in ("deep.png", "lamp.png"):
            # Numbers that are said to be linear, and numbers that -colorspace made linear.
            self.enlarge(name, "out.tif", "2", "-set", "colorspace", "RGB")
            self.succeed("oiiotool", name, "--resize:filter=ddt,light=linear", "200%", "-d",
                         "uint16", "-o", "wanted.tif")
            self.assert_same("out.tif", "wanted.tif")
        self.succeed(CONVERT, "deep.png", "-colorspace", "RGB", *(FLOATS if HDRI else ()),
                     "linear.tif")
        self.enlarge("deep.png", "out.tif", "2", "-colorspace", "RGB")
        self.succeed("oiiotool", "linear.tif", "--resize:filter=ddt,light=linear", "200%", "-d",
                     "uint16", "-o", "wanted.tif")
        self.assert_same("out.tif", "wanted.tif")

    def test_linear_greys_stay_linear(self):
        for alpha in ((), ("-alpha", "set")):
            told = self.succeed(CONVERT, "grey.png", "-set", "colorspace", "LinearGray", *alpha,
                                "-process", "ddt 2", "-format", "%[colorspace]", "info:",
                                **FOUND_IN)
            self.assertEqual(told, "LinearGray")
        self.succeed("oiiotool", "grey.png", "--resize:filter=ddt,light=linear", "200%", "-d",
                     "uint16", "-o", "wanted.tif")
        self.enlarge("grey.png", "out.tif", "2", "-set", "colorspace", "LinearGray")
        self.assert_same("out.tif", "wanted.tif")

    def test_alpha_is_multiplied_in_floats(self):
        # oiiotool by itself would multiply codes of 16 bits while it reads, and lose some of them.
        self.enlarge("straight.tif", "out.tif", "2")
        self.succeed("oiiotool", "--iconfig", "oiio:UnassociatedAlpha", "1", "straight.tif", "-d",
                     "float", "--eraseattrib", "oiio:UnassociatedAlpha", "--premult",
                     "-o", "product.exr")
        self.succeed("oiiotool", "product.exr", "--resize:filter=ddt,light=sRGB", "200%",
                     "--unpremult", "-d", "float", "-o", "float.exr")
        self.succeed("oiiotool", "float.exr", "-d", "uint16", "-o", "wanted.tif")
        # The same, read as the numbers they are.
        self.succeed("oiiotool", "--iconfig", "oiio:UnassociatedAlpha", "1", "out.tif",
                     "--eraseattrib", "oiio:UnassociatedAlpha", "-o", "numbers.tif")
        self.assert_same("numbers.tif", "wanted.tif")

    @unittest.skipUnless(HDRI, "this ImageMagick's memory has integers")
    def test_highlights_stay(self):
        done = self.convert("bright.tif", "-set", "colorspace", "RGB", "-process", "ddt 2",
                            *FLOATS, "out.tif")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.succeed("oiiotool", "bright.tif", "--resize:filter=ddt,light=linear", "200%", "-d",
                     "float", "-o", "wanted.tif")
        self.assertGreater(max(high for _, high in self.extrema("wanted.tif")), 10)
        # On the way ImageMagick multiplies floats by 65535 and divides them by it.
        self.succeed("oiiotool", "out.tif", "wanted.tif", "--absdiff", "-o", "difference.tif")
        self.assertLess(max(high for _, high in self.extrema("difference.tif")), 1e-4)

    def test_all_images_of_a_list(self):
        self.enlarge("deep.png", "out.tif", "2", "grey.png")
        self.succeed("oiiotool", "deep.png", "--resize:filter=ddt,light=sRGB", "200%", "-d",
                     "uint16", "-o", "wanted.png")
        self.assertEqual(self.hashes("out.tif")[:1], self.hashes("wanted.png"))
        self.assertEqual(len(self.hashes("out.tif")), 2)

    def test_its_limit_of_threads_counts(self):
        def most(limit):
            return self.most_threads(CONVERT, "-limit", "thread", limit, "photo.png", "-sample",
                                     "1500x1000!", "-process", "ddt 2", "null:", **FOUND_IN)
        if most("2") == 1:
            self.skipTest("this machine, or its quota, has one processor")
        self.assertEqual(most("1"), 1)

    def test_errors_end_with_1_and_a_line(self):
        for arguments, says in (("", "scale"), ("0.5", "scale"), ("2 ddtx", "unknown filter"),
                                ("2 ddt,blur=7", "blur=7")):
            done = self.convert("photo.png", "-process", f"ddt {arguments}", "out.png")
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn(says, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)

    def test_other_colorspaces_are_refused(self):
        done = self.convert("photo.png", "-colorspace", "Lab", "-process", "ddt 2", "out.tif")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the colorspace CIELab is not allowed", done.stderr)

    def test_the_delegates(self):
        home = self.path("home")
        os.makedirs(os.path.join(home, ".config", "ImageMagick"))
        shutil.copy(os.path.join(FOLDER, "delegates.xml"),
                    os.path.join(home, ".config", "ImageMagick"))
        path = os.pathsep.join([os.path.join(support.BUILD, "bin"), os.environ["PATH"]])
        done = self.attempt(CONVERT, "ddt4:deep.png", "-depth", "16", "out.png", HOME=home,
                            PATH=path, XDG_CONFIG_HOME=os.path.join(home, ".config"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.succeed("oiiotool", "deep.png", "--resize:filter=ddt,light=sRGB", "400%", "-d",
                     "uint16", "-o", "wanted.png")
        self.assert_same("out.png", "wanted.png")


if __name__ == "__main__":
    unittest.main()
