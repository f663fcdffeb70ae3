# SPDX-License-Identifier: Apache-2.0
"""Sequences and parts: `ddt resize --frames`, `--part` and `ddt join`."""

import os
import subprocess
import unittest

import OpenImageIO as oiio

from support import DDT, Case, environment

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "slurm")

# In place of Slurm's: runs the tasks at once, one after the other.
SBATCH = """#!/bin/bash
tasks=0
while [[ $1 = -* ]]; do
    case $1 in --array=*) tasks=${1#*=} ;; esac
    shift
done
for ((i = ${tasks%-*}; i <= ${tasks#*-}; ++i)); do
    SLURM_ARRAY_TASK_ID=$i bash "$@" || exit
done >&2
echo 1
"""


class Farm(Case):
    def ddt(self, *arguments, code=0, says="", plugin=False):
        done = subprocess.run([DDT, *arguments], cwd=self.folder, env=environment(plugin),
                              capture_output=True, text=True, timeout=240)
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, code, text)
        self.assertIn(says, text)
        return text

    def there(self, *names):
        return [os.path.exists(self.path(name)) for name in names]


class Sequences(Farm):
    def setUp(self):
        super().setUp()
        for frame in (-1, 0, 1, 2, 4):
            self.succeed("oiiotool", "scene.exr", "--addc", str(frame), "-o", f"in.{frame:04d}.exr")

    def test_frames(self):
        self.ddt("resize", "in.#.exr", "200%", "out.%04d.exr", "--frames", "-1-4x5,0-2",
                 "--jobs", "3", says="5 frames: 5 written, 0 skipped, 0 failed")
        for frame in (-1, 0, 1, 2, 4):
            self.ddt("resize", f"in.{frame:04d}.exr", "200%", "one.exr")
            self.assert_same("one.exr", f"out.{frame:04d}.exr")
        # Those that are there, without being told.
        self.ddt("resize", "in.#.exr", "200%", "all.#.exr", says="5 frames: 5 written")
        self.assert_same("all.-001.exr", "out.-001.exr")

    def test_oiiotool_does_the_same_frames(self):
        self.ddt("resize", "in.#.exr", "200%", "ours.#.exr", "--frames", "0-2")
        self.succeed("oiiotool", "--frames", "0-2", "in.#.exr", "--resize:filter=ddt", "200%",
                     "-o", "theirs.#.exr")
        for frame in range(3):
            self.assert_same(f"ours.{frame:04d}.exr", f"theirs.{frame:04d}.exr")

    def test_oiiotool_does_the_same_images(self):
        """Of a file; those of every frame of a sequence, too."""
        for frame in (0, 1):
            self.succeed("oiiotool", f"in.{frame:04d}.exr", "--attrib", "oiio:subimagename", "all",
                         f"in.{frame:04d}.exr", "--crop", "20x15+9+4", "--siappend",
                         "-o", f"two.{frame:04d}.exr")
        self.ddt("resize", "two.#.exr", "200%", "ours.#.exr", "--all-images",
                 says="2 frames: 2 written")
        self.succeed("oiiotool", "-a", "--frames", "0-1", "two.#.exr", "--resize:filter=ddt",
                     "200%", "-o", "theirs.#.exr")
        for frame in (0, 1):
            self.assert_same(f"ours.{frame:04d}.exr", f"theirs.{frame:04d}.exr")
        self.assertEqual(len(self.hashes("ours.0000.exr")), 2)

    def test_images_with_tiles_and_without(self):
        """OpenImageIO's writer of EXR has tiles in all images of a file, or in none."""
        image = self.load("in.0000.exr")
        file = oiio.ImageOutput.create(self.path("mixed.tif"))
        for tile, mode in ((16, "Create"), (0, "AppendSubimage")):
            spec = oiio.ImageSpec(image.spec())
            spec.tile_width = spec.tile_height = tile
            self.assertTrue(file.open(self.path("mixed.tif"), spec, mode), file.geterror())
            self.assertTrue(file.write_image(image.get_pixels(oiio.FLOAT)), file.geterror())
        file.close()
        self.ddt("resize", "mixed.tif", "200%", "ours.exr", "--all-images")
        self.assertEqual([self.load("ours.exr", i).nativespec().tile_width for i in (0, 1)], [0, 0])
        self.assertEqual(len(set(self.hashes("ours.exr"))), 1)

    def test_views(self):
        for view in ("left", "right"):
            os.rename(self.path("in.0001.exr" if view == "left" else "in.0002.exr"),
                      self.path(f"in.{view}.0001.exr"))
        self.ddt("resize", "in.%V.#.exr", "2", "out.%v.#.exr", "--views", "left,right",
                 says="2 frames: 2 written")
        self.assert_different("out.l.0001.exr", "out.r.0001.exr")

    def test_a_failure_ends_it_or_not(self):
        self.ddt("resize", "in.#.exr", "2", "out.#.exr", "--frames", "1-4", code=1,
                 says="in.0003.exr")
        self.assertEqual(self.there("out.0002.exr", "out.0003.exr", "out.0004.exr"),
                         [True, False, False])
        self.ddt("resize", "in.#.exr", "2", "out.#.exr", "--frames", "1-4", "--keep-going",
                 "--skip-existing", code=1, says="4 frames: 1 written, 2 skipped, 1 failed")
        self.assertEqual(self.there("out.0003.exr", "out.0004.exr"), [False, True])

    def test_progress_of_all_frames(self):
        text = self.ddt("resize", "in.#.exr", "2", "out.#.exr", "--progress", "lines")
        shares = [int(line.split()[2].rstrip("%")) for line in text.splitlines()
                  if line.startswith("ddt progress ")]
        self.assertEqual(shares, sorted(set(shares)))
        self.assertEqual(shares[-1], 100)


class Parts(Farm):
    #                          "tiled.exr": five tiles of 256 pixels across and three down
    IMAGES = {
        **Case.IMAGES,
        "tiled.exr": "--pattern noise:type=uniform:min=0.1:max=0.9 1100x700 3 --blur 5x5 "
                     "--origin -20+30 --fullsize 1060x760+0+0 --tile 32 32 -d half",
        "deep.png": "--pattern noise:type=uniform 600x300 3 --blur 3x3 -d uint16",
        # Their names in another order than their numbers: channel10 before channel4.
        "twelve.tif": "--pattern noise:type=uniform 40x30 12 --attrib DateTime 2001:02:03 -d half",
        "wide.exr": "--pattern noise:type=uniform 300x20 3 --origin -7+5 --fullsize 290x30-3+0 -d half",
        "ten.dpx": "--pattern noise:type=uniform:mono=1 40x30 3 -d uint10",
        "rated.dpx": "--pattern noise:type=uniform:mono=1 40x30 3 --attrib dpx:FrameRate 23.5 -d uint10",
    }

    def parts(self, image, size, count, *options):
        for i in range(1, count + 1):
            self.ddt("resize", image, size, f"part.{i}.exr", "--part", f"{i}/{count}", *options)
        return [f"part.{i}.exr" for i in range(1, count + 1)]

    def check_same(self, image, size, count, out, *options):
        names = self.parts(image, size, count, *options)
        self.ddt("join", *reversed(names), out)
        self.ddt("resize", image, size, "whole" + out[-4:], *options)
        self.assert_same(out, "whole" + out[-4:])
        ours, theirs = self.load(out).spec(), self.load("whole" + out[-4:]).spec()
        self.assertEqual((ours.roi, ours.roi_full, ours.format, ours.tile_width),
                         (theirs.roi, theirs.roi_full, theirs.format, theirs.tile_width))
        self.assertEqual(self.metadata(ours), self.metadata(theirs))
        return names

    @staticmethod
    def metadata(spec):
        """Without what a writer at another second makes."""
        return sorted((a.name, str(a.type), str(a.value)) for a in spec.extra_attribs
                      if a.name != "DateTime")

    def test_the_same_bits(self):
        self.check_same("tiled.exr", "170%x230%", 7, "joined.exr", "--filter", "ddt-sharp")

    def test_rows(self):
        names = self.check_same("tiled.exr", "300%", 3, "joined.exr")
        self.assertEqual([self.size(name)[0] for name in names], [3300] * 3)

    def test_integers_come_back(self):
        self.check_same("deep.png", "200%", 2, "joined.png")
        self.check_same("photo.png", "300%", 1, "joined.tif")

    def test_channels_keep_their_order(self):
        self.check_same("twelve.tif", "200%", 1, "joined.tif")
        ours, theirs = self.load("joined.tif").spec(), self.load("whole.tif").spec()
        self.assertEqual(ours.channelnames, theirs.channelnames)
        self.assertEqual(ours["DateTime"], theirs["DateTime"])

    def test_formats_without_windows(self):
        self.check_same("wide.exr", "130%", 2, "joined.tif", "--type", "float")  # none negative
        self.check_same("wide.exr", "130%", 2, "joined.png", "--type", "uint16")  # no windows
        self.check_same("wide.exr", "130%", 2, "joined.iff", "--type", "uint8")  # nor rows

    def test_parts_outside_what_the_format_keeps(self):
        """Two of four, each left of the display window."""
        self.succeed("oiiotool", "--pattern", "noise:type=uniform:min=0:max=1", "1300x400", "3",
                     "--origin", "-900+10", "--fullsize", "300x300+0+0", "-d", "half", "-o", "far.exr")
        self.check_same("far.exr", "200%", 4, "joined.png", "--type", "uint8")

    def test_what_compression_loses(self):
        """It is lost in the same rows."""
        for compression in "dwaa:60", "dwab", "b44":
            self.check_same("tiled.exr", "170%", 2, "joined.exr", "--compression", compression)

    def test_bits_come_back(self):
        self.check_same("ten.dpx", "200%", 1, "joined.dpx")
        self.assertEqual(self.load("joined.dpx").spec()["oiio:BitsPerSample"], 10)

    def test_metadata_of_other_formats_come_back(self):
        """Of which OpenEXR keeps none."""
        self.check_same("rated.dpx", "200%", 1, "joined.dpx")
        self.assertEqual(self.load("joined.dpx").spec()["dpx:FrameRate"], 23.5)
        self.succeed("oiiotool", "photo.png", "--attrib", "jpeg:subsampling", "4:4:4", "-o", "photo.jpg")
        self.check_same("photo.jpg", "200%", 1, "joined.jpg")
        self.assertEqual(self.load("joined.jpg").spec()["jpeg:subsampling"], "4:4:4")

    def test_formats_whose_tiles_could_not_be_read(self):
        """TIFF of CMYK, and in JPEG: OpenImageIO's reader fails, or writes beyond its memory."""
        self.succeed("oiiotool", "photo.png", "--attrib", "tiff:ColorSpace", "CMYK", "-o", "cmyk.tif")
        self.succeed("oiiotool", "photo.png", "--compression", "jpeg", "-o", "jpeg.tif")
        for image in "cmyk.tif", "jpeg.tif":
            self.check_same(image, "200%", 1, "joined.tif")

    def test_what_is_rounded_twice_is_told(self):
        """And how it is not."""
        self.parts("photo.png", "200%", 1)
        said = self.attempt(DDT, "join", "part.1.exr", "joined.exr")
        self.assertEqual(said.returncode, 0)
        self.assertIn("--type half", said.stderr)
        self.parts("photo.png", "200%", 1, "--type", "half")
        self.ddt("join", "part.1.exr", "joined.exr")
        self.ddt("resize", "photo.png", "200%", "whole.exr")
        self.assert_same("joined.exr", "whole.exr")
        # TIFF has no halfs: one run's are floats there.
        said = self.attempt(DDT, "join", "part.1.exr", "joined.tif")
        self.assertEqual(said.returncode, 0)
        self.assertIn('"joined.tif" has float, and the parts were rounded to half; --type float',
                      said.stderr)
        self.parts("photo.png", "200%", 1, "--type", "float")
        self.assertEqual(self.ddt("join", "part.1.exr", "joined.tif"), "")
        self.ddt("resize", "photo.png", "200%", "whole.tif", "--type", "float")
        self.assert_same("joined.tif", "whole.tif")

    def test_halfs_among_floats_that_are_rounded_twice_are_told(self):
        self.succeed("oiiotool", "scene.exr", "photo.png", "--ch", "Z=R", "--siappend", "--sisplit",
                     "--chappend", "-d", "R=half,G=half,B=half,Z=float", "-o", "mixed.exr")
        self.parts("mixed.exr", "200%", 1)
        self.assertEqual(self.ddt("join", "part.1.exr", "joined.exr"), "")
        self.ddt("join", "part.1.exr", "joined.tif", says="the parts were rounded to half")

    def test_another_source_is_refused_wherever_it_differs(self):
        self.succeed("oiiotool", "--pattern", "noise", "900x800", "3", "-d", "uint8", "-o", "a.ppm")
        with open(self.path("a.ppm"), "rb") as file:
            data = bytearray(file.read())
        data[len(data) // 9] ^= 1
        with open(self.path("b.ppm"), "wb") as file:
            file.write(data)
        self.ddt("resize", "a.ppm", "120%", "1.exr", "--part", "1/2")
        self.ddt("resize", "b.ppm", "120%", "2.exr", "--part", "2/2")
        self.ddt("join", "1.exr", "2.exr", "out.ppm", code=1, says="different jobs")

    def test_options_may_name_devices(self):
        self.ddt("resize", "deep.png", "200%", "part.1.exr", "--part", "1/2", "--filter",
                 "ddt,device=cpu")
        self.ddt("resize", "deep.png", "200%", "part.2.exr", "--part", "2/2", "--filter", "ddt")
        self.ddt("join", "part.1.exr", "part.2.exr", "out.exr")

    def test_wrong_parts_are_refused(self):
        names = self.parts("deep.png", "200%", 3)
        out = "out.exr"
        self.ddt("join", names[0], names[2], out, code=1, says="missing: 2")
        self.ddt("join", *names, names[1], out, code=1, says="part 2 is there twice")
        for other in (("deep.png", "200%", "--filter", "ddt-linear"), ("deep.png", "201%"),
                      ("deep.png", "200%", "--compression", "piz"), ("photo.tif", "200%")):
            count = "2/3" if other[0] == "deep.png" else "1/1"
            self.ddt("resize", *other[:2], "other.exr", "--part", count, *other[2:])
            self.ddt("join", names[0], "other.exr", names[2], out, code=1, says="different jobs")
        self.ddt("join", "scene.exr", out, code=1, says="no part")
        self.ddt("join", names[0], out, code=1, says="missing: 2, 3")
        # A part of another width: somebody cropped it.
        self.succeed("oiiotool", names[1], "--crop", "600x100+0+300", "--tile", "64", "64", "-o",
                     names[1])
        self.ddt("join", *names, out, code=1)
        self.assertEqual(self.there(out), [False])

    def test_what_cannot_be_a_part(self):
        for arguments, says in ((("photo.png", "200%", "p.exr", "--part", "1/2"), "at most 1 part"),
                                (("tiled.exr", "50%", "p.exr", "--part", "1/2"), "enlarging"),
                                (("tiled.exr", "200%", "p.png", "--part", "1/2"), ".exr"),
                                (("tiled.exr", "200%", "p.exr", "--part", "3/2"), "K <= N")):
            self.ddt("resize", *arguments, code=2, says=says)

    def test_what_asks_for_another_image_cannot_be_a_part(self):
        """Nobody would see that the other image has changed."""
        with open(self.path("request.ddt"), "w") as file:
            file.write("deep.png\nscale=2\n")
        self.ddt("resize", "request.ddt", "100%", "p.exr", plugin=True)
        self.ddt("resize", "request.ddt", "100%", "q.exr", "--part", "1/2", plugin=True, code=2,
                 says="asks for another image")

    def test_reads_its_own_share_alone(self):
        """Tiles of the source that a part does not need may be broken."""
        self.succeed("oiiotool", "tiled.exr", "--ch", "R,G", "-d", "uint32", "--tile", "32", "48",
                     "-o", "ids.exr")
        for image in "tiled.exr", "ids.exr":
            names = self.check_same(image, "200%", 3, "joined.exr")
            before = self.hashes(names[0])
            with open(self.path(image), "r+b") as file:
                size = os.path.getsize(self.path(image))
                # The last rows of tiles come last in the file.
                file.seek(size * 3 // 4)
                file.write(b"\xff" * (size // 4))
            self.ddt("resize", image, "200%", names[0], "--part", "1/3")
            self.assertEqual(self.hashes(names[0]), before)
            self.ddt("resize", image, "200%", names[2], "--part", "3/3", code=1)

    def test_joining_takes_256_MiB_at_most(self):
        """Of an image of 322 MiB."""
        self.succeed("oiiotool", "--pattern", "fill:topleft=0,1,0:bottomright=1,0,1", "1500x1500",
                     "3", "-d", "half", "--tile", "64", "64", "-o", "large.exr")
        names = self.parts("large.exr", "500%", 3, "--filter", "ddt-linear")
        pid = os.fork()
        if pid == 0:
            os.chdir(self.folder)
            os.execve(DDT, [DDT, "join", *names, "joined.exr"], environment(False))
        _, status, usage = os.wait4(pid, 0)
        self.assertEqual(status, 0)
        self.assertLess(usage.ru_maxrss, 256 << 10)


class Scripts(Farm):
    """Those of docs/slurm, on a Slurm that is none (tests/farm has one)."""

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("bin"))
        with open(self.path("bin/sbatch"), "w") as file:
            file.write(SBATCH)
        os.chmod(self.path("bin/sbatch"), 0o755)
        os.symlink(DDT, self.path("bin/ddt"))
        self.programs = self.path("bin") + ":" + os.environ["PATH"]

    def test_names_that_begin_with_a_hyphen(self):
        self.succeed("oiiotool", "--pattern", "noise", "300x520", "3", "-d", "half", "-o", "in.exr")
        os.rename(self.path("in.exr"), self.path("-in.exr"))
        os.symlink("-in.exr", self.path("-in.0002.exr"))
        self.ddt("resize", "--", "-in.exr", "200%", "one.exr")
        before = sorted(os.listdir(self.folder))

        for command, out in (
                ([SCRIPTS + "/parts.sh", "3", "-in.exr", "200%", "-out.exr"], "-out.exr"),
                (["sbatch", "--array=2-2", SCRIPTS + "/frames.sbatch", "-in.#.exr", "200%",
                  "-out.#.exr"], "-out.0002.exr")):
            done = self.attempt(*command, "--threads", "1", PATH=self.programs)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assert_same("one.exr", out)
            os.remove(self.path(out))
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_a_first_frame_that_is_no_number(self):
        for first in "abc", " 2", "1e3", "-", "1 2", "9999999999", "a[$(touch made)]":
            done = self.attempt("sbatch", "--array=2-2", SCRIPTS + "/frames.sbatch", "in.#.png",
                                "200%", "out.#.png", PATH=self.programs, FIRST=first)
            self.assertEqual((done.returncode, done.stderr), (
                2, f'frames.sbatch: FIRST="{first}" is not allowed; allowed are whole numbers '
                   'of up to nine digits, such as 1000 and -5\n'))
        self.assertNotIn("made", os.listdir(self.folder))


if __name__ == "__main__":
    unittest.main()
