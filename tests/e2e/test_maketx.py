# SPDX-License-Identifier: Apache-2.0
"""maketx and oiiotool's texture output with the filter."""

import os
import unittest

import OpenImageIO as oiio
from OpenImageIO import ImageBufAlgo as iba

from support import Case, is_symbolic


class MakeTx(Case):
    def setUp(self):
        super().setUp()
        if is_symbolic() and "refused" not in self.id():
            self.skipTest("OpenImageIO is linked with -Bsymbolic-functions")

    def test_refused_where_calls_cannot_be_redirected(self):
        if not is_symbolic():
            self.skipTest("they can")
        self.fail_with("oiiotool", "photo.tif", "-otex:filter=ddt", "out.tx", says=('"ddt"',),
                       out="out.tx")
        self.fail_with("maketx", "--filter", "ddt", "photo.tif", "-o", "out.tx", says=('"ddt"',),
                       out="out.tx")

    def test_filter_enlarges_to_a_power_of_two(self):
        self.succeed("maketx", "--filter", "ddt", "--resize", "--nomipmap", "photo.tif", "-o",
                     "out.tx")
        self.assertEqual(self.size("out.tx"), (64, 32))
        self.succeed("oiiotool", "photo.tif", "--resize:filter=ddt", "64x32", "-d", "uint16", "-o",
                     "out.tif")
        self.assertLess(iba.compare(self.load("out.tx"), self.load("out.tif"), 0, 0).maxerror,
                        1.1 / 65535)
        self.succeed("maketx", "--filter", "triangle", "--resize", "--nomipmap", "photo.tif", "-o",
                     "other.tx")
        self.assert_different("out.tx", "other.tx")

    def levels(self, name):
        """How many a file has, which ImageBuf does not know of every format."""
        file = oiio.ImageInput.open(self.path(name))
        level = 1
        while file.seek_subimage(0, level):
            level += 1
        return level

    def test_every_level_has_an_image(self):
        self.succeed("maketx", "--filter", "ddt", "photo.tif", "-o", "ours.tx")
        self.succeed("maketx", "--filter", "lanczos3", "photo.tif", "-o", "stock.tx")
        # Shrinking is OpenImageIO's own, by its default filter.
        self.assertEqual(self.levels("ours.tx"), self.levels("stock.tx"))
        self.assertGreater(self.levels("ours.tx"), 4)
        for level in range(1, 4):
            spot = oiio.ImageBuf(self.path("ours.tx"), 0, level)
            same = oiio.ImageBuf(self.path("stock.tx"), 0, level)
            self.assertLess(iba.compare(spot, same, 0, 0).maxerror, 0.1, level)
            self.assertGreater(max(iba.computePixelStats(spot).max), 0.3)

    def test_no_options(self):
        """It looks for the whole text among the names that are listed."""
        for filter in "ddt,nonsense=1", "ddt,light=encoded":
            self.fail_with("maketx", "--filter", filter, "photo.tif", "-o", "out.tx",
                           says=(filter,), out="out.tx")

    def test_oiiotool_writes_textures(self):
        self.succeed("oiiotool", "photo.tif", "-otex:filter=ddt", "out.tx")
        self.assertTrue(os.path.exists(self.path("out.tx")))


if __name__ == "__main__":
    unittest.main()
