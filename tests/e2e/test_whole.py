# SPDX-License-Identifier: Apache-2.0
"""`ddt resize` writes its result whole or not at all, and says by its exit code what went wrong."""

import os
import random
import resource
import signal
import subprocess
import time
import unittest

from support import BUILD, Case, environment

DDT = os.path.join(BUILD, "bin", "ddt")
KILLS = 50


def heed_signals():
    """A shell's background jobs ignore SIGINT, and so would theirs."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class Whole(Case):
    def ddt(self, *arguments, **how):
        how.setdefault("preexec_fn", heed_signals)
        return subprocess.Popen([DDT, *arguments], cwd=self.folder, env=environment(False),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **how)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_to_end(self, *arguments, **how):
        process = self.ddt(*arguments, **how)
        out, err = process.communicate(timeout=120)
        return process.returncode, out + err

    def test_killed_at_any_moment(self):
        """The old file or the whole new one."""
        self.succeed("oiiotool", "photo.png", "--resize", "160x128", "--noise", "-o", "large.png")
        begin = time.monotonic()
        self.assertEqual(self.run_to_end("resize", "large.png", "300%", "new.png"), (0, ""))
        took = time.monotonic() - begin
        new, old = self.read("new.png"), self.read("photo.png")
        random.seed(1)
        seen = {"old": 0, "new": 0}
        for i in range(KILLS):
            with open(self.path("out.png"), "wb") as file:
                file.write(old)
            process = self.ddt("resize", "large.png", "300%", "out.png")
            time.sleep(random.uniform(0, 1.1 * took))
            process.send_signal((signal.SIGKILL, signal.SIGTERM, signal.SIGINT)[i % 3])
            process.communicate(timeout=60)
            what = {old: "old", new: "new"}.get(self.read("out.png"))
            self.assertIsNotNone(what, f"half a file after kill {i}")
            seen[what] += 1
            if i % 3:
                self.assertIn(process.returncode, (0, -signal.SIGTERM, -signal.SIGINT))
        self.assertGreater(seen["old"], 0)
        # What SIGKILL left is the next run's, and goes with it.
        self.assertEqual(self.run_to_end("resize", "large.png", "300%", "out.png"), (0, ""))
        self.assertEqual([n for n in os.listdir(self.folder) if ".ddt-" in n], [])

    def test_signals_leave_nothing(self):
        self.succeed("oiiotool", "photo.png", "--resize", "1500x1200", "-o", "large.png")
        for number in (signal.SIGTERM, signal.SIGINT):
            process = self.ddt("resize", "large.png", "400%", "out.png", "--type", "uint16")
            while process.poll() is None:
                if any(".ddt-" in n for n in os.listdir(self.folder)):
                    process.send_signal(number)
                    break
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, -number)
            self.assertEqual([n for n in os.listdir(self.folder) if "out" in n], [])

    def test_every_format(self):
        """What is written by way of a stream of our own is what OpenImageIO writes by name."""
        # oiiotool has floats in between; so these hold more than the picture's 8 bits.
        types = {"exr": "half", "hdr": "float"}
        for extension in ("png", "jpg", "tif", "exr", "bmp", "sgi", "dpx", "hdr", "tga", "ppm", "iff",
                          "webp", "gif", "rla", "fits", "zfile", "ico"):
            ours, theirs = f"ours.{extension}", f"theirs.{extension}"
            with self.subTest(format=extension):
                size = "200%"
                stock = self.attempt("oiiotool", "photo.png", "--resize:filter=ddt", size, "-o",
                                     theirs)
                code, text = self.run_to_end("resize", "photo.png", size, ours, "--type",
                                             types.get(extension, "uint8"))
                self.assertEqual(code == 0, stock.returncode == 0, text)
                if code == 0:
                    self.assert_same(ours, theirs)

    def test_no_room(self):
        """Of every format; those whose writers ignore failed writes included."""
        def small():
            resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))

        self.succeed("oiiotool", "photo.png", "--noise", "-o", "noise.png")
        for name in ("out.png", "out.jpg", "out.tif", "out.exr", "out.bmp", "out.sgi", "out.dpx",
                     "out.hdr", "out.tga", "out.ppm", "out.ply", "out.svg"):
            if name[-3:] not in ("ply", "svg") and self.attempt(
                    "oiiotool", "photo.png", "-o", "try." + name[-3:]).returncode:
                continue  # this OpenImageIO does not write it
            with self.subTest(name=name):
                with open(self.path(name), "w", encoding="ascii") as file:
                    file.write("before")
                command = (("mesh", "photo.png", name) if name[-3:] in ("ply", "svg") else
                           ("resize", "noise.png", "600%", name, "--type", "uint8"))
                code, text = self.run_to_end(*command, preexec_fn=small)
                self.assertEqual(code, 3, text)
                self.assertEqual(self.read(name), b"before")
                self.assertEqual(len(text.splitlines()), 1, text)
                self.assertIn(name, text)
                self.assertEqual([n for n in os.listdir(self.folder) if ".ddt-" in n], [])

    def test_strips(self):
        """What is large is written while it is made: the same pixels, and whole or not at all."""
        self.succeed("oiiotool", "--pattern", "noise", "300x2600", "3", "-d", "uint8", "-o", "long.png")
        for extension in ("png", "tif", "exr"):
            ours, theirs = f"ours.{extension}", f"theirs.{extension}"
            kind = "half" if extension == "exr" else "uint8"
            code, text = self.run_to_end("resize", "long.png", "150%", ours, "--type", kind,
                                         "--threads", "1")
            self.assertEqual(code, 0, text)
            self.succeed("oiiotool", "long.png", "--resize:filter=ddt", "150%", "-d", kind, "-o",
                         theirs)
            self.assert_same(ours, theirs)
            room = os.path.getsize(self.path(ours)) // 3

            def small():
                resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

            code, text = self.run_to_end("resize", "long.png", "150%", ours, "--threads", "1",
                                         "--type", kind, preexec_fn=small)
            self.assertEqual(code, 3, text)
            self.assertEqual(len(text.splitlines()), 1, text)
            self.assert_same(ours, theirs)

    def test_no_memory(self):
        def small():
            resource.setrlimit(resource.RLIMIT_AS, (600 << 20, 600 << 20))

        code, text = self.run_to_end("resize", "photo.png", "16000x12800", "out.tif",
                                     "--threads", "1", preexec_fn=small)
        self.assertEqual(code, 3, text)
        self.assertIn("memory", text)
        self.assertFalse(os.path.exists(self.path("out.tif")))

    def test_exit_codes(self):
        for code, arguments in ((1, ("missing.png", "200%", "out.png")),
                                (1, ("photo.png", "200%", "no/folder.png")),
                                (2, ("photo.png", "large", "out.png")),
                                (2, ("photo.png", "200%", "out.png", "--progress", "loud")),
                                (3, ("photo.png", "1000000x1000000", "out.png"))):
            got, text = self.run_to_end("resize", *arguments)
            self.assertEqual(got, code, text)
            self.assertTrue(text.startswith("ddt: "), text)

    def test_onto_the_input(self):
        self.assertEqual(self.run_to_end("resize", "photo.png", "200%", "two.png"), (0, ""))
        self.assertEqual(self.run_to_end("resize", "photo.png", "200%", "photo.png"), (0, ""))
        self.assertEqual(self.read("photo.png"), self.read("two.png"))

    def test_progress_lines(self):
        code, text = self.run_to_end("resize", "photo.png", "200%", "out.png", "--progress",
                                     "lines")
        self.assertEqual(code, 0)
        shares = [int(line.split()[2].rstrip("%")) for line in text.splitlines()]
        self.assertEqual(shares, sorted(set(shares)))
        self.assertEqual(shares[-1], 100)


if __name__ == "__main__":
    unittest.main()
