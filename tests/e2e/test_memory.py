# SPDX-License-Identifier: Apache-2.0
"""What `ddt` does without memory: one line, its own exit code, and no file."""

import bisect
import os
import resource
import signal
import struct
import unittest
import zlib

from process_case import ProcessCase
from support import DDT


class Memory(ProcessCase):
    def run_within(self, mebibytes, *arguments):
        def small():
            resource.setrlimit(resource.RLIMIT_AS, (mebibytes << 20, mebibytes << 20))
        return self.run_to_end(*arguments, preexec_fn=small)

    def loaded(self):
        """The mebibytes that the libraries take when they are loaded, which is not ours."""
        sizes = range(200, 8000, 50)
        return sizes[bisect.bisect_left(sizes, True,
                                        key=lambda n: self.run_within(n, "--version")[0] == 0)]

    def test_no_memory(self):
        code, text = self.run_within(self.loaded() + 400, "resize", "photo.png", "16000x12800",
                                     "out.tif", "--threads", "1")
        self.assertEqual(code, 3, text)
        self.assertIn("memory", text)
        self.assertFalse(os.path.exists(self.path("out.tif")))

    def run_in_group(self, mebibytes, *arguments):
        """Run ddt where a control group allows that, as the kernel's files say it."""
        for name in ("memory.max", "memory/memory.limit_in_bytes"):
            os.makedirs(os.path.dirname(self.path(f"groups/{name}")), exist_ok=True)
            with open(self.path(f"groups/{name}"), "w", encoding="ascii") as file:
                file.write(f"{mebibytes << 20}\n")
        mount = ("unshare", "-rm", "sh", "-c", 'mount --bind groups /sys/fs/cgroup && eval "$0"')
        done = self.attempt(*mount, "true")
        if done.returncode != 0:
            self.skipTest("no folder can be mounted here: " + done.stderr)
        done = self.attempt(*mount, f"ulimit -v 12000000; '{DDT}' {' '.join(arguments)}")
        return done.returncode, done.stderr

    def test_what_a_control_group_has_no_memory_for(self):
        """In which the kernel would kill the process."""
        code, text = self.run_in_group(64, "resize", "photo.png", "4000x4000", "out.tif")
        self.assertEqual((code, text), (0, ""))
        code, text = self.run_in_group(64, "resize", "photo.png", "6000x6000", "out.tif")
        self.assertEqual(code, 3, text)
        self.assertIn("would need 103 MB; allowed are 64 MB", text)
        self.assertIn("control groups", text)

    def test_a_part_with_more_tiles_than_memory(self):
        """OpenEXR's writer keeps the place of each, here 14 GB."""
        def chunk(name, data):
            return (struct.pack(">I", len(data)) + name + data +
                    struct.pack(">I", zlib.crc32(name + data)))

        with open(self.path("large.png"), "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n" +
                       chunk(b"IHDR", struct.pack(">IIBBBBB", 200000, 150000, 8, 0, 0, 0, 0)) +
                       chunk(b"IDAT", zlib.compress(b"")) + chunk(b"IEND", b""))
        code, text = self.run_in_group(8000, "resize", "large.png", "800%", "out.exr", "--part", "1/1")
        self.assertEqual(code, 3, text)
        self.assertIn("a part of 1600000 x 1200000 pixels", text)

    def test_no_memory_for_a_part(self):
        """Whichever allocation is the first to fail, of the threads' or of the image cache's."""
        self.succeed("oiiotool", "--pattern", "noise", "900x900", "3", "-d", "half", "--tile", "64",
                     "64", "-o", "tiled.exr")

        loaded = self.loaded()
        codes = set()
        for mebibytes in range(loaded + 75, loaded + 500, 50):
            code, text = self.run_within(mebibytes, "resize", "tiled.exr", "200%", "part.exr",
                                         "--part", "1/1", "--threads", "4")
            # OpenEXR 3.4 says itself what its compressor had no memory for, and then that the file
            # cannot be written; its reader, as OpenImageIO 3 uses it, that tiles are missing.
            # OpenEXR 3.1 says of a zlib without memory what it says of a broken tile.
            lines = text.splitlines()
            own = [line for line in lines if "(EXR_ERR_OUT_OF_MEMORY)" not in line]
            unsaid = own != lines or any(words in text for words in (
                "Some tiles were missing or corrupted", "Data decompression (zlib) failed"))
            self.assertIn(code, (0, 1, 3) if unsaid else (0, 3), text)
            if not unsaid:
                codes.add(code)
            self.assertEqual(len(own), int(code != 0), text)
            self.assertEqual([n for n in os.listdir(self.folder) if ".ddt-" in n], [])
            self.assertEqual(os.path.exists(self.path("part.exr")), code == 0)
            if code == 0:
                os.remove(self.path("part.exr"))
        self.assertEqual(codes, {0, 3})

    def test_no_memory_from_any_request_on(self):
        """For one of the requests, or from it on."""
        preloaded = os.environ.get("DDT_NO_MEMORY")
        if not preloaded:
            self.skipTest("there is no module that makes requests fail")

        def resize(**variables):
            done = self.attempt(DDT, "resize", "photo.png", "150%", "out.exr", "--threads", "2",
                                plugin=False, LD_PRELOAD=preloaded, **variables)
            return done.returncode, done.stderr

        code, count = resize()
        self.assertEqual(code, 0, count)
        count = int(count)
        os.rename(self.path("out.exr"), self.path("whole.exr"))
        codes = set()
        for i in range(40):
            for lacking in (1, 10 ** 9):
                # More of them at the end, where what was written is looked at.
                number = int(count * (1 - (i / 40) ** 2))
                code, text = resize(NO_MEMORY_AFTER=str(number), NO_MEMORY_FOR=str(lacking))
                told = f"{lacking} after {number} of {count}: {text}"
                # OpenImageIO 2.5 and 3.1 go on where OpenColorIO 2.5 had no memory for a config.
                if code == -signal.SIGSEGV and self.release() >= (2, 5):
                    continue
                self.assertIn(code, (0, 3), told)
                # libpng says itself what it has no memory for, as where others are looked for.
                own = [line for line in text.splitlines() if not line.startswith("libpng error")]
                self.assertEqual(len(own), int(code != 0), told)
                self.assertEqual([n for n in os.listdir(self.folder) if ".ddt-" in n], [], told)
                codes.add(code)
                # It may run out of it once the file is written.
                there = os.path.exists(self.path("out.exr"))
                self.assertTrue(there or code == 3, told)
                if there:
                    self.assert_same("out.exr", "whole.exr")
                    os.remove(self.path("out.exr"))
        self.assertEqual(codes, {0, 3})

    def test_no_memory_to_fill(self):
        """Of a TIFF whose colour is not multiplied by alpha: three times as much as it takes."""
        self.succeed("oiiotool", "--pattern", "noise", "2000x2000", "4", "--chnames", "R,G,B,A",
                     "--attrib:type=int", "oiio:UnassociatedAlpha", "1", "-d", "uint8", "-o",
                     "straight.tif")
        loaded = self.loaded()
        codes = set()
        for mebibytes in range(loaded + 100, loaded + 400, 20):
            code, text = self.run_within(mebibytes, "fill", "straight.tif", "filled.tif")
            codes.add(code)
            self.assertIn(code, (0, 3), text)
            self.assertEqual(os.path.exists(self.path("filled.tif")), code == 0)
            if code == 0:
                os.remove(self.path("filled.tif"))
        self.assertEqual(codes, {0, 3})


if __name__ == "__main__":
    unittest.main()
