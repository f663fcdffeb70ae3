"""maketx and oiiotool's texture output with the filter."""

import os
import unittest

from support import Case


class MakeTx(Case):
    def test_filter_enlarges_to_a_power_of_two(self):
        self.succeed("maketx", "--filter", "ddt", "--resize", "--nomipmap", "photo.tif", "-o",
                     "out.tx")
        self.assertEqual(self.size("out.tx"), (64, 32))
        self.succeed("oiiotool", "photo.tif", "--resize:filter=ddt", "64x32", "-d", "uint16", "-o",
                     "out.tif")
        self.succeed("idiff", "-fail", "0", "-hardfail", "0.00002", "out.tx", "out.tif")
        self.succeed("maketx", "--filter", "triangle", "--resize", "--nomipmap", "photo.tif", "-o",
                     "other.tx")
        self.assert_different("out.tx", "other.tx")

    def test_every_level_has_an_image(self):
        self.succeed("maketx", "--filter", "ddt", "photo.tif", "-o", "ours.tx")
        self.succeed("maketx", "--filter", "lanczos3", "photo.tif", "-o", "stock.tx")
        # Shrinking is OpenImageIO's own.
        self.assertEqual(self.succeed("iinfo", "-v", "ours.tx").count("MIP"),
                         self.succeed("iinfo", "-v", "stock.tx").count("MIP"))
        for level in "1", "2":
            self.succeed("oiiotool", "ours.tx", "--selectmip", level, "-o", "level.tif")
            self.assertGreater(self.extrema("level.tif")[0][1], 0.3)

    def test_bad_option(self):
        self.fail_with("maketx", "--filter", "ddt,nonsense=1", "photo.tif", "-o", "out.tx",
                       says=("ddt,nonsense=1",), out="out.tx")

    def test_oiiotool_writes_textures(self):
        self.succeed("oiiotool", "photo.tif", "-otex:filter=ddt", "out.tx")
        self.assertTrue(os.path.exists(self.path("out.tx")))


if __name__ == "__main__":
    unittest.main()
