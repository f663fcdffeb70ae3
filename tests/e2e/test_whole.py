# SPDX-License-Identifier: Apache-2.0
"""`ddt` writes its result whole or not at all."""

import os
import resource
import signal
import unittest

from process_case import ProcessCase
from support import DDT

KILLS = 30


class Whole(ProcessCase):
    def test_killed_at_any_moment(self):
        """The old file or the whole new one."""
        # Of many tiles, so that there are lines, and kills, while they are worked on.
        self.succeed("oiiotool", "photo.png", "--resize", "800x640", "--noise", "-o", "large.png")
        command = ("resize", "large.png", "150%", "out.png", "--progress", "lines")
        code, told = self.run_to_end(*command)
        self.assertEqual(code, 0, told)
        lines = len(told.splitlines())
        new, old = self.read("out.png"), self.read("photo.png")
        seen = {"old": 0, "new": 0}
        for i in range(KILLS):
            with open(self.path("out.png"), "wb") as file:
                file.write(old)
            process = self.ddt(*command)
            for _ in range(i * lines // (KILLS - 1)):
                line = process.stderr.readline()
                if not line:
                    break  # rows may be ready sooner than they are told of: then a line is left out
                self.assertIn("progress", line)
            process.send_signal((signal.SIGKILL, signal.SIGTERM, signal.SIGINT)[i % 3])
            process.communicate(timeout=60)
            what = {old: "old", new: "new"}.get(self.read("out.png"))
            self.assertIsNotNone(what, f"half a file after kill {i}")
            seen[what] += 1
            if i % 3:
                self.assertIn(process.returncode, (0, -signal.SIGTERM, -signal.SIGINT))
        self.assertGreater(seen["old"], 0)
        # What SIGKILL left is the next run's, and goes with it.
        self.assertEqual(self.run_to_end("resize", "large.png", "150%", "out.png"), (0, ""))
        self.assertEqual([n for n in os.listdir(self.folder) if ".ddt-" in n], [])

    def test_signals_leave_nothing(self):
        self.succeed("oiiotool", "photo.png", "--resize", "1500x1200", "-o", "large.png")
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1, signal.SIGALRM):
            process = self.ddt("resize", "large.png", "400%", "out.png", "--type", "uint16")
            while process.poll() is None:
                if any(".ddt-" in n for n in os.listdir(self.folder)):
                    process.send_signal(number)
                    break
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, -number)
            self.assertEqual([n for n in os.listdir(self.folder) if "out" in n], [])

    def is_turned_over(self, extension):
        self.succeed("oiiotool", "photo.png", "-o", f"copy.{extension}")
        return self.hashes(f"copy.{extension}") != self.hashes("photo.png")

    def test_every_format(self):
        """What is written by way of a stream of our own is what OpenImageIO writes by name."""
        for extension in ("png", "jpg", "tif", "exr", "bmp", "sgi", "dpx", "hdr", "tga", "ppm", "iff",
                          "webp", "gif", "rla", "fits", "zfile", "ico"):
            if extension == "ppm" and self.is_turned_over(extension):
                continue  # by oiiotool of 3.1
            ours, theirs = f"ours.{extension}", f"theirs.{extension}"
            with self.subTest(format=extension):
                size = "200%"
                stock = self.attempt("oiiotool", "photo.png", "--resize:filter=ddt", size, "-o",
                                     theirs)
                code, text = self.run_to_end("resize", "photo.png", size, ours)
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

    def test_no_room_for_the_last_bytes(self):
        """Which some writers do not look at, and without which a file may be read all the same."""
        self.succeed("oiiotool", "photo.png", "--noise", "-o", "noise.png")
        for name in ("out.rla", "out.ico", "out.tif"):
            with self.subTest(name=name):
                command = ("resize", "noise.png", "500%", name)
                self.assertEqual(self.run_to_end(*command), (0, ""))
                size = os.path.getsize(self.path(name))
                os.remove(self.path(name))
                for less in (1, 150, 450, 900):
                    def small():
                        resource.setrlimit(resource.RLIMIT_FSIZE, (size - less, size - less))

                    code, text = self.run_to_end(*command, preexec_fn=small)
                    self.assertEqual(code, 3, text)
                    self.assertEqual(len(text.splitlines()), 1, text)
                    self.assertFalse(os.path.exists(self.path(name)))

    def test_no_room_for_tiles(self):
        """After one that could not be written OpenEXR waits for ever for the next."""
        def small():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100000, 100000))

        self.succeed("oiiotool", "--pattern", "noise:type=uniform:min=0:max=1", "640x480", "3",
                     "--tile", "32", "32", "-d", "half", "-o", "tiled.exr")
        self.assertEqual(self.run_to_end("resize", "tiled.exr", "150%", "part.exr", "--part", "1/1"),
                         (0, ""))
        self.assertEqual(self.run_to_end("join", "part.exr", "whole.exr"), (0, ""))
        for command in (("resize", "tiled.exr", "150%", "out.exr"), ("fill", "tiled.exr", "out.exr"),
                        ("resize", "tiled.exr", "150%", "out.exr", "--part", "1/1"),
                        ("join", "part.exr", "out.exr"), ("resize", "tiled.exr", "150%", "out.tif")):
            with self.subTest(command=command):
                code, text = self.run_to_end(*command, preexec_fn=small)
                self.assertEqual(code, 3, text)
                self.assertEqual(len(text.splitlines()), 1, text)
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

    def test_what_a_format_cannot_hold(self):
        """GIF's writer takes any size and writes another; JPEG's ends the program."""
        for name, size in (("out.gif", "66000x2"), ("out.jpg", "65501x2")):
            if self.attempt("oiiotool", "photo.png", "-o", "try" + name[-4:]).returncode:
                continue  # this OpenImageIO does not write it
            code, text = self.run_to_end("resize", "photo.png", size, name)
            self.assertEqual((code, os.path.exists(self.path(name))), (1, False), text)
            self.assertIn("allowed are ", text)
            self.assertEqual(len(text.splitlines()), 1, text)

    def run_on_a_tiny_disk(self, kilobytes, command, formats):
        """Run a command for each of the formats; exit codes, and what is there afterwards."""
        os.mkdir(self.path("tiny"))
        done = self.attempt("unshare", "-rm", "sh", "-c",
                            f"mount -t tmpfs -o size={kilobytes}k tmpfs tiny || exit 77; "
                            f"for f in {formats}; do {command} tiny/out.$f; "
                            "echo $? $(ls -A tiny); done")
        if done.returncode:
            self.skipTest("no disk can be mounted here: " + done.stderr)
        return done

    def test_a_full_disk_leaves_no_holes(self):
        """Writers that go from row to row do not notice, and what is missing reads as zeros."""
        done = self.run_on_a_tiny_disk(200, f"'{DDT}' resize --type uint8 photo.png 1000%",
                                       "sgi fits")
        self.assertEqual(done.stdout, "3\n3\n", done.stderr)

    def test_a_full_disk_among_several_images(self):
        """Their writers open the file by its name, so that we do not see what a write says."""
        self.succeed("oiiotool", "photo.png", "photo.png", "--siappend", "-o", "two.tif")
        done = self.run_on_a_tiny_disk(60, f"'{DDT}' resize --all-images two.tif 1000%",
                                       "exr tif gif")
        self.assertEqual(done.stdout, "3\n3\n3\n", done.stderr)

    def test_what_is_no_file(self):
        os.symlink("/dev/null", self.path("nothing.sgi"))
        self.assertEqual(self.run_to_end("resize", "photo.png", "150%", "nothing.sgi"), (0, ""))
        self.succeed("oiiotool", "photo.png", "--resize", "2x2", "-o", "tiny.png")
        self.assertEqual(self.run_to_end("resize", "tiny.png", "1", "tiny.ico"), (0, ""))

    def test_onto_the_input(self):
        self.assertEqual(self.run_to_end("resize", "photo.png", "200%", "two.png"), (0, ""))
        self.assertEqual(self.run_to_end("resize", "photo.png", "200%", "photo.png"), (0, ""))
        self.assertEqual(self.read("photo.png"), self.read("two.png"))


if __name__ == "__main__":
    unittest.main()
