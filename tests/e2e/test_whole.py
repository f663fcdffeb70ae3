# SPDX-License-Identifier: Apache-2.0
"""`ddt resize` writes its result whole or not at all, and says by its exit code what went wrong."""

import bisect
import os
import resource
import signal
import struct
import subprocess
import unittest
import zlib

from support import BUILD, Case, environment

DDT = os.path.join(BUILD, "bin", "ddt")
KILLS = 30


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
        command = ("resize", "large.png", "300%", "out.png", "--progress", "lines")
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
                self.assertIn("progress", process.stderr.readline())
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
            lines = text.splitlines()
            own = [line for line in lines if "(EXR_ERR_OUT_OF_MEMORY)" not in line]
            unsaid = own != lines or "Some tiles were missing or corrupted" in text
            self.assertIn(code, (0, 1, 3) if unsaid else (0, 3), text)
            if not unsaid:
                codes.add(code)
            self.assertEqual(len(own), int(code != 0), text)
            self.assertEqual([n for n in os.listdir(self.folder) if ".ddt-" in n], [])
            self.assertEqual(os.path.exists(self.path("part.exr")), code == 0)
            if code == 0:
                os.remove(self.path("part.exr"))
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

    def test_exit_codes(self):
        for code, arguments in ((1, ("missing.png", "200%", "out.png")),
                                (1, ("photo.png", "200%", "no/folder.png")),
                                (2, ("photo.png", "large", "out.png")),
                                (2, ("photo.png", "200%", "out.png", "--progress", "loud")),
                                (3, ("photo.png", "1000000x1000000", "out.png"))):
            got, text = self.run_to_end("resize", *arguments)
            self.assertEqual(got, code, text)
            self.assertTrue(text.startswith("ddt: "), text)
        with open(self.path("points.csv"), "w", encoding="utf-8") as file:
            file.write("x,y,z\n0,0,1\n4,0,2\n0,4,3\n4,4,4\n")
        for command in (("resize", "photo.png", "200%", "out.png", "--filter", "ddt,device=egl"),
                        ("scatter", "points.csv", "out.exr", "--filter", "ddt,device=egl")):
            done = self.attempt(DDT, *command, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("is unavailable", done.stderr)

    def test_an_unknown_device_is_told_before_anything_is_opened(self):
        """Whose writer would complain by itself."""
        done = self.attempt(DDT, "resize", "photo.png", "250%", "out.png", DDT_DEVICE="voodoo")
        self.assertEqual((done.returncode, done.stderr), (
            1, "ddt: DDT_DEVICE=voodoo is not one of auto, cpu, egl, osmesa\n"))

    def test_closed_streams(self):
        """What is meant for a terminal does not get into a file."""
        self.assertEqual(self.run_to_end("resize", "photo.png", "150%", "wanted.exr"), (0, ""))
        for closed in ("2>&-", ">&- 2>&-", "<&- >&- 2>&-", "<&- 2>told"):
            self.succeed("sh", "-c",
                         f"'{DDT}' resize photo.png 150% out.exr --progress lines {closed}")
            self.assert_same("out.exr", "wanted.exr")

    def test_what_is_printed_must_arrive(self):
        for command in ("compare --csv photo.png photo.png", "info", "--help", "compare --help"):
            done = self.attempt("sh", "-c", f"'{DDT}' {command} > /dev/full")
            self.assertEqual(done.returncode, 3, command)
            self.assertEqual(done.stderr, "ddt: the standard output cannot be written: "
                                          "No space left on device\n")
            self.assertEqual(self.attempt("bash", "-o", "pipefail", "-c",
                                          f"'{DDT}' {command} | true").stderr, "")

    def test_what_is_printed_beside_a_file_may_get_lost(self):
        """That is said, and the file is there."""
        self.succeed("cp", "photo.png", "in.0001.png")
        for command, out in (("resize in.#.png 150% out.#.png", "out.0001.png"),
                             ("mesh --verbose photo.png mesh.ply", "mesh.ply")):
            for lost in "> /dev/full", ">&-":
                done = self.attempt("sh", "-c", f"'{DDT}' {command} {lost}")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("standard output cannot be written", done.stderr)
                os.remove(self.path(out))

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

    def test_progress_lines(self):
        code, text = self.run_to_end("resize", "photo.png", "200%", "out.png", "--progress",
                                     "lines")
        self.assertEqual(code, 0)
        shares = [int(line.split()[2].rstrip("%")) for line in text.splitlines()]
        self.assertEqual(shares, sorted(set(shares)))
        self.assertEqual(shares[-1], 100)


if __name__ == "__main__":
    unittest.main()
