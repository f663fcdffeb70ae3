# SPDX-License-Identifier: Apache-2.0
"""`ddt stream`: pictures one after the other through pipes."""

import os
import shutil
import subprocess
import threading
import unittest

import OpenImageIO as oiio

import support


def pfm(width, height, value):
    """A PFM of one colour, low byte first."""
    import struct
    return b"PF\n%d %d\n-1.0\n" % (width, height) + struct.pack("<f", value) * (3 * width * height)


class Stream(support.Case):
    def stream(self, data, *arguments):
        return subprocess.run([support.DDT, "stream", *arguments], input=data, capture_output=True,
                              env=support.environment(False), timeout=120)

    def file(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def ppm(self, name):
        """The picture of a file. (oiiotool of 3.1 writes it upside down.)"""
        image = self.load(name)
        return (b"P6\n%d %d\n255\n" % self.size(name) +
                image.get_pixels(oiio.UINT8, image.roi).tobytes())

    def test_the_filters_bits_for_every_frame(self):
        done = self.stream(self.ppm("photo.png") * 3, "--scale", "2", "--filter", "ddt-sharp")
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt-sharp", "200%", "-o",
                     "wanted.png")
        self.assertEqual(done.stdout, self.ppm("wanted.png") * 3)

    def test_floats_keep_their_order_of_bytes(self):
        done = self.stream(pfm(5, 4, 0.75) + pfm(3, 3, 2.0), "--scale", "3")
        self.assertEqual(done.stdout, pfm(15, 12, 0.75) + pfm(9, 9, 2.0))

    def test_the_end_of_the_stream_is_no_failure(self):
        done = self.stream(b"")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"", b""))

    def test_what_cannot_be_read_is_no_end(self):
        # Of a process's memory nothing is there at address 0: an error of input.
        for stdin, code in ((f"< '{self.folder}'", 1), ("<&-", 1), ("< /proc/self/mem", 3)):
            done = self.attempt("sh", "-c", f"'{support.DDT}' stream {stdin}")
            self.assertEqual(done.returncode, code, stdin)
            self.assertIn("frame 1: the stream cannot be read: ", done.stderr)

    def test_a_full_disk_may_pass(self):
        done = self.attempt("sh", "-c", f"printf 'P5\\n2 2\\n255\\nabcd' | '{support.DDT}' stream > /dev/full")
        self.assertEqual(done.returncode, 3)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_nobody_to_write_to_is_a_failure(self):
        done = self.attempt("sh", "-c", f"printf 'P5\n2 2\n255\nabcd' | '{support.DDT}' stream >&-")
        self.assertEqual(done.returncode, 1)
        self.assertIn("frame 1: the result cannot be written: ", done.stderr)

    def test_a_header_alone_takes_no_memory(self):
        """A gigabyte and a half by its header, of which hardly a page is touched."""
        with open(self.path("header"), "wb") as header:
            header.write(b"P5\n40000 40000\n255\nabc")
        with open(self.path("header"), "rb") as header:
            child = subprocess.Popen([support.DDT, "stream"], stdin=header, stdout=subprocess.DEVNULL,
                                     stderr=subprocess.PIPE, env=support.environment(False))
        with child.stderr as said:
            self.assertIn(b"it ends after 3 of 1600000000 bytes", said.read())
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(child.returncode, 1)
        self.assertLess(usage.ru_maxrss, 400 << 10)
        done = self.stream(b"PF\n16777216 16777216\n-1.0\n")
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"this machine's memory", done.stderr)

    def test_a_short_frame_ends_with_a_line_after_those_before(self):
        frame = b"P6\n4 4\n255\n" + bytes(48)
        done = self.stream(frame + frame[:-7])
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, b"ddt: frame 2: it ends after 41 of 48 bytes\n")
        self.assertEqual(done.stdout, b"P6\n8 8\n255\n" + bytes(192))

    def test_what_is_no_picture_is_named(self):
        for data, says in ((b"GIF89a", b"frame 1: no picture begins here"),
                           (b"P6\n4 x\n", b'height "x" is not allowed in a header; allowed are 1 to'),
                           (b"P6\n4 0\n", b'height "0" is not allowed'),
                           (b"P6\n4 4\n65536\n", b'largest value "65536" is not allowed in a header; '
                            b"allowed are 1 to 65535"),
                           (b"P5\n4 4", b"the header ends before its largest value"),
                           (b"P7\nWIDTH 4\n", b"the header ends before ENDHDR"),
                           (b"P7\nWIDTH 4\nENDHDR\n", b"there is no HEIGHT in the header"),
                           (b"P7\nDEPTH 5\n", b'DEPTH "5" is not allowed in a header; allowed are 1 to 4'),
                           (b"P7\nCOLOR 5\n", b'"COLOR" is not allowed in the header'),
                           (b"Pf\n1 1\nnan\n0000", b'scale "nan" is not allowed'),
                           (b"P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE CMYK\nENDHDR\n0000",
                            b"CMYK is not allowed")):
            done = self.stream(data)
            self.assertEqual(done.returncode, 1)
            self.assertIn(says, done.stderr)
            self.assertEqual(done.stderr.count(b"\n"), 1)
        self.assertEqual(self.stream(b"", "--filter", "ddtx").returncode, 2)

    def test_an_unknown_device_is_told_before_a_frame_is_read(self):
        done = subprocess.run([support.DDT, "stream"], input=b"no picture", capture_output=True,
                              env={**support.environment(False), "DDT_DEVICE": "voodoo"}, timeout=120)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (
            1, b"", b"ddt: DDT_DEVICE=voodoo is not one of auto, cpu, egl, osmesa\n"))

    def test_help_names_the_lights(self):
        """Those of the error line, and that $OCIO has no others."""
        allowed = self.stream(b"", "--filter", "ddt,light=dark").stderr.decode().strip()
        names = allowed.partition("allowed are ")[2]
        self.assertIn("auto, linear, ", names)
        told = " ".join(self.succeed(support.DDT, "stream", "--help").split())
        self.assertIn(f"here it may be {names};", told)
        self.assertIn("$OCIO is not looked at", told)

    def test_other_largest_values_become_16_bits(self):
        pam = "P7\nWIDTH 2\nHEIGHT 1\nDEPTH 1\nMAXVAL {}\nTUPLTYPE {}\nENDHDR\n"
        for sent, wanted in (
                (pam.format(1, "BLACKANDWHITE").encode() + b"\0\1",
                 pam.format(65535, "GRAYSCALE").encode() + b"\0\0\xff\xff"),
                (b"P5\n2 1\n1000\n\1\xf4\3\xe8", b"P5\n2 1\n65535\n\x80\0\xff\xff")):
            done = self.stream(sent, "--scale", "1")
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, wanted, b""))

    def test_a_closed_pipe_ends_it(self):
        frame = b"P6\n300 300\n255\n" + bytes(270000)
        with open(self.path("in.ppm"), "wb") as file:
            file.write(frame * 20)
        done = self.attempt("sh", "-c", f"'{support.DDT}' stream --scale 4 < in.ppm | head -c 100 > /dev/null")
        self.assertIn("the reader of the result has gone", done.stderr)

    def started(self):
        return subprocess.Popen([support.DDT, "stream", "--scale", "2"], stdin=subprocess.PIPE,
                                stdout=subprocess.PIPE, env=support.environment(False))

    def test_a_frame_comes_out_before_the_next_goes_in(self):
        frame, large = b"P6\n4 4\n255\n" + bytes(48), b"P6\n8 8\n255\n" + bytes(192)
        with self.started() as process:
            for _ in range(3):
                process.stdin.write(frame)
                process.stdin.flush()
                self.assertEqual(process.stdout.read(len(large)), large)
            process.stdin.close()
            self.assertEqual(process.wait(timeout=60), 0)

    def test_frames_are_read_while_one_cannot_be_written(self):
        # None of these fits into a pipe: whoever reads only after he has written stops at the first.
        frame = b"P6\n400 300\n255\n" + bytes(360000)
        with self.started() as process:
            writing = threading.Thread(target=lambda: process.stdin.write(frame * 3), daemon=True)
            writing.start()
            writing.join(60)
            held_up = writing.is_alive()
            process.kill()
        self.assertFalse(held_up)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not there")
    def test_between_two_ffmpegs(self):
        done = self.attempt(
            "bash", "-c", "set -o pipefail; ffmpeg -v error -f lavfi -i testsrc=size=64x48:rate=5 "
            f"-frames:v 5 -f image2pipe -c:v pam - | '{support.DDT}' stream --scale 2 | "
            "ffmpeg -v error -f image2pipe -c:v pam -i - -f rawvideo -pix_fmt rgb24 out.rgb")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(os.path.getsize(self.path("out.rgb")), 5 * 128 * 96 * 3)


if __name__ == "__main__":
    unittest.main()
