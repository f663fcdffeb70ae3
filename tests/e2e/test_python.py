# SPDX-License-Identifier: Apache-2.0
"""Python's OpenImageIO module with the plugin on its path."""

import os
import sys
import unittest

import OpenImageIO as oiio
from OpenImageIO import ROI, ImageBuf
from OpenImageIO import ImageBufAlgo as iba

from support import PLUGINS, WRAPPER, Case

oiio.attribute("plugin_searchpath", PLUGINS)

LARGE = ROI(0, 160, 0, 128, 0, 1, 0, 3)


class Python(Case):
    def check(self, image):
        self.assertFalse(image.has_error, image.geterror())
        return image

    def photo(self):
        return self.check(ImageBuf(self.path("photo.png")))

    def difference(self, a, b):
        self.assertEqual((a.spec().width, a.spec().height), (b.spec().width, b.spec().height))
        return iba.compare(a, b, 0, 0).maxerror

    def test_resize(self):
        result = self.check(iba.resize(self.photo(), "ddt", 0.0, LARGE))
        self.succeed("oiiotool", "--native", "photo.png", "--resize:filter=ddt", "400%", "-o",
                     "out.png")
        self.assertEqual(self.difference(result, ImageBuf(self.path("out.png"))), 0)
        other = self.check(iba.resize(self.photo(), "triangle", 0.0, LARGE))
        self.assertGreater(self.difference(result, other), 0.01)

    def test_resize_into_an_image(self):
        result = ImageBuf()
        self.assertTrue(iba.resize(result, self.photo(), "ddt,scheme=pixel", 0.0, LARGE))
        plain = iba.resize(self.photo(), "ddt", 0.0, LARGE)
        self.assertGreater(self.difference(result, plain), 0.01)

    def test_fit_rotate_warp(self):
        fit = self.check(iba.fit(self.photo(), "ddt", 0.0, "letterbox", True, LARGE))
        self.assertEqual(fit.spec().width, 160)
        about = self.check(iba.rotate(self.photo(), 0.5, "ddt,light=encoded"))
        matrix = (2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0)
        warped = self.check(iba.warp(self.photo(), matrix, "ddt,light=encoded", 0.0, True))
        self.assertGreater(warped.spec().width, 70)
        other = iba.rotate(self.photo(), 0.5, "triangle")
        self.assertGreater(self.difference(about, other), 0.01)

    def test_errors(self):
        result = iba.resize(self.photo(), "ddt,nonsense=1", 0.0, LARGE)
        self.assertTrue(result.has_error)
        error = result.geterror()
        self.assertIn('"nonsense"', error)
        self.assertNotIn("\n", error)
        result = ImageBuf()
        self.assertFalse(iba.resize(result, self.photo(), "ddt,scheme=magic", 0.0, LARGE))
        self.assertIn('"scheme=magic"', result.geterror())

    def test_volume(self):
        spec = oiio.ImageSpec(8, 8, 3, oiio.FLOAT)
        spec.depth = spec.full_depth = 4
        result = iba.resize(ImageBuf(spec), "ddt", 0.0, ROI(0, 16, 0, 16, 0, 1, 0, 3))
        self.assertTrue(result.has_error)

    def test_reader(self):
        source = oiio.ImageInput.open(self.path("photo.tif") + ".ddt?scale=4")
        self.assertIsNotNone(source, oiio.geterror())
        self.assertEqual(source.format_name(), "ddt")
        self.assertEqual(source.spec().width, 160)
        self.assertEqual(source.spec().format, oiio.UINT16)
        self.assertFalse(source.seek_subimage(1, 0))
        self.assertFalse(source.seek_subimage(0, 1))
        source.close()
        self.assertIsNone(oiio.ImageInput.open(self.path("photo.tif") + ".ddt?scale=no"))
        self.assertIn('"scale=no"', oiio.geterror())
        enlarged = self.check(ImageBuf(self.path("photo.png") + ".ddt?scale=4"))
        direct = self.check(iba.resize(self.photo(), "ddt", 0.0, LARGE))
        self.assertEqual(self.difference(enlarged, direct), 0)

    def test_module_loaded_after_the_plugin(self):
        # The very first call, with options, before any file is opened.
        program = ("import OpenImageIO as o\n"
                   "a = o.ImageBuf(o.ImageSpec(8, 8, 3, 'float'))\n"
                   "o.ImageBufAlgo.fill(a, (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1))\n"
                   "r = o.ImageBufAlgo.resize(a, 'ddt,light=encoded', 0.0,\n"
                   "                          o.ROI(0, 16, 0, 16, 0, 1, 0, 3))\n"
                   "assert not r.has_error, r.geterror()\n"
                   "assert o.ImageBufAlgo.computePixelStats(r).max[0] > 0.5\n")
        python = os.path.realpath(sys.executable)
        self.succeed(WRAPPER, "--tool", python, "-c", program, plugin=False)


if __name__ == "__main__":
    unittest.main()
