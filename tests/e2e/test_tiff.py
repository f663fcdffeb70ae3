# SPDX-License-Identifier: Apache-2.0
"""TIFFs as other programs write them, and OpenImageIO does not."""

import array
import struct
import unittest
import zlib

from support import DDT, Case


def separate_tiff(path, width, height, rows, code, pixel):
    """A TIFF of three channels with zipped strips of `rows` rows of their own. code: array's."""
    bits = 8 * array.array(code).itemsize
    body, places, sizes = b"II*\0    ", [], []
    for channel in range(3):
        for top in range(0, height, rows):
            strip = array.array(code, (pixel(x, y, channel)
                                       for y in range(top, min(top + rows, height))
                                       for x in range(width)))
            packed = zlib.compress(strip.tobytes(), 1)
            places.append(len(body))
            sizes.append(len(packed))
            body += packed + b"\0" * (len(packed) % 2)
    entries = {256: [width], 257: [height], 258: [bits] * 3, 259: [8], 262: [2], 273: places,
               277: [3], 278: [rows], 279: sizes, 284: [2], 339: [3 if code == "f" else 1] * 3}
    directory = struct.pack("<H", len(entries))
    after = len(body) + 2 + 12 * len(entries) + 4
    beyond = b""
    for tag, values in sorted(entries.items()):
        data = struct.pack(f"<{len(values)}I", *values)
        if len(data) > 4:
            data, beyond = struct.pack("<I", after + len(beyond)), beyond + data
        directory += struct.pack("<HHI", tag, 4, len(values)) + data
    body = body[:4] + struct.pack("<I", len(body)) + body[8:]
    with open(path, "wb") as file:
        file.write(body + directory + struct.pack("<I", 0) + beyond)


class Separate(Case):
    """libtiff reads compressed strips of one channel only whole."""

    def read_by_all(self, name):
        self.succeed(DDT, "compare", name, name)
        self.succeed(DDT, "fill", name, "filled.tif")
        self.succeed(DDT, "resize", name, "150%", "whole.tif")
        parts = ["part.1.exr", "part.2.exr", "part.3.exr"]
        for number, part in enumerate(parts, 1):
            self.succeed(DDT, "resize", name, "150%", part, "--part", f"{number}/3")
        self.succeed(DDT, "join", *parts, "joined.tif")
        self.assert_same("joined.tif", "whole.tif")
        self.succeed("oiiotool", name, "--attrib", "planarconfig", "contig", "-o", "contig.tif")
        self.succeed(DDT, "resize", "contig.tif", "150%", "enlarged.tif")
        self.assert_same("enlarged.tif", "whole.tif")

    def test_bytes(self):
        separate_tiff(self.path("bytes.tif"), 60, 700, 16, "B",
                      lambda x, y, c: (x * 7 + y * 5 * (c + 1)) % 256)
        self.read_by_all("bytes.tif")

    def test_floats_more_than_are_read_at_once(self):
        separate_tiff(self.path("floats.tif"), 1000, 900, 64, "f",
                      lambda x, y, c: (x + y * (c + 1)) % 64 / 64)
        self.read_by_all("floats.tif")


if __name__ == "__main__":
    unittest.main()
