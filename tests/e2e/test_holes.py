# SPDX-License-Identifier: Apache-2.0
"""The filter's option holes=: what is missing is filled, the same by every way in."""

import unittest

import OpenImageIO as oiio

from support import DDT, Case


class Holes(Case):
    def setUp(self):
        super().setUp()
        image = oiio.ImageBuf(oiio.ImageSpec(40, 30, 4, "float"))
        image.specmod().attribute("oiio:ColorSpace", "Linear")
        for y in range(30):
            for x in range(40):
                hole, v = 15 <= x < 23 and 8 <= y < 18, 1.0 if 2 * y > x + 9 else 0.0
                image.setpixel(x, y, (float("nan"),) * 4 if hole else (v, v, v, 1.0))
                if (x, y) == (30, 5):
                    image.setpixel(x, y, (0.0,) * 4)
        self.assertTrue(image.write(self.path("holes.exr")))

    def pixels(self, name):
        image = self.load(name)
        return [image.getpixel(x, y) for y in range(image.spec().height)
                for x in range(image.spec().width)]

    def test_by_every_way_in(self):
        spec = "ddt,holes=fill"
        self.succeed("oiiotool", "holes.exr", f"--resize:filter={spec}", "400%", "-o", "a.exr")
        self.succeed(DDT, "resize", "holes.exr", "400%", "b.exr", "--filter", spec)
        self.succeed("iconvert", "holes.exr.ddt?scale=4&holes=fill", "c.exr")
        self.assert_same("a.exr", "b.exr")
        self.assert_same("a.exr", "c.exr")
        self.succeed(DDT, "resize", "holes.exr", "400%", "p.exr", "--filter", spec, "--part", "1/1")
        self.succeed(DDT, "join", "p.exr", "d.exr")
        self.assert_same("a.exr", "d.exr")
        kept = self.path("kept.exr")
        self.succeed("oiiotool", "holes.exr", "--resize:filter=ddt", "400%", "-o", kept)
        self.assertTrue(any(v != v for p in self.pixels(kept) for v in p))
        for p in self.pixels("a.exr"):
            for v in p:
                self.assertTrue(0 <= v <= 1.0001, p)
        # The transparent pixel is one, and by the other choice it is not.
        at = 4 * 5 * 160 + 4 * 30
        self.assertLess(min(p[3] for p in self.pixels("a.exr")[at:at + 4]), 0.5)
        self.succeed("oiiotool", "holes.exr", f"--resize:filter={spec}-alpha", "400%", "-o",
                     "e.exr")
        self.assertGreater(min(p[3] for p in self.pixels("e.exr")), 0.999)


if __name__ == "__main__":
    unittest.main()
