# SPDX-License-Identifier: Apache-2.0
"""Enlarged images under names of their own, and sidecar files."""

import os
import re
import socket
import unittest

import OpenImageIO as oiio

from support import PLUGINS, Case

oiio.attribute("plugin_searchpath", PLUGINS)


class Reader(Case):
    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def test_equals_resize(self):
        for image, options in (("photo.png", ""), ("photo.tif", "&filter=ddt-linear"),
                               ("scene.exr", "&scheme=pixel"), ("window.exr", "")):
            with self.subTest(image=image):
                filter = ("ddt-linear" if "linear" in options else "ddt")
                filter += ",scheme=pixel" if "pixel" in options else ""
                extension = image[-4:]
                self.succeed("iconvert", "--scanline", f"{image}.ddt?scale=4{options}", "reader" + extension)
                self.succeed("oiiotool", "--native", image, f"--resize:filter={filter}", "400%",
                             "-o", "resize" + extension)
                self.assert_same("reader" + extension, "resize" + extension)

    def test_sizes(self):
        for query, size in (("scale=2", (80, 64)), ("scale=2.5", (100, 80)),
                            ("width=120", (120, 96)), ("height=64", (80, 64)),
                            ("width=50&height=70", (50, 70)), ("scale=2&width=60", (60, 48)),
                            ("width=60&scale=3", (120, 96)), ("scale=0.5", (20, 16))):
            with self.subTest(query=query):
                self.assertEqual(self.size(f"photo.png.ddt?{query}"), size)

    def test_pixel_type_and_metadata_stay(self):
        for image, type in (("photo.png", oiio.UINT8), ("photo.tif", oiio.UINT16),
                            ("scene.exr", oiio.HALF), ("window.exr", oiio.FLOAT)):
            source = oiio.ImageInput.open(self.path(image) + ".ddt?scale=2")
            self.assertEqual(source.spec().format, oiio.TypeDesc(type))
        space = re.search("oiio:ColorSpace: .*", self.succeed("iinfo", "-v", "photo.png"))
        self.assertIn(space[0], self.succeed("iinfo", "-v", "photo.png.ddt?scale=2"))

    def test_oiiotool_reads_it(self):
        self.succeed("oiiotool", "photo.png.ddt?scale=3&light=encoded", "-o", "out.png")
        self.succeed("iconvert", "--scanline", "photo.png.ddt?scale=3&light=encoded", "same.png")
        self.assert_same("out.png", "same.png")

    def test_channels_of_several_types_by_many_threads(self):
        """The cache converts them, which OpenImageIO shares with threads that wait for us."""
        self.succeed("oiiotool", "--pattern", "noise", "1000x900", "6", "--chnames", "R,G,B,A,Z,W",
                     "-d", "half", "-d", "Z=float", "--scanline", "-o", "mix.exr")
        self.succeed("oiiotool", "mix.exr", "--resize:filter=ddt", "200%", "-d", "float",
                     "-o", "wanted.exr")
        for device in ("cpu", "auto"):
            self.succeed("oiiotool", "mix.exr.ddt?scale=2", "-d", "float", "-o", "out.exr",
                         DDT_DEVICE=device)
            self.assert_same("out.exr", "wanted.exr")

    def test_image_cache_with_small_tiles(self):
        self.succeed("oiiotool", "--autotile", "16", "--cache", "1", "scene.exr.ddt?scale=5", "-d",
                     "half", "-o", "tiles.exr")
        self.succeed("iconvert", "scene.exr.ddt?scale=5", "whole.exr")
        self.assert_same("tiles.exr", "whole.exr")

    def test_subimages(self):
        self.succeed("oiiotool", "scene.exr", "scene.exr", "--flip", "--mulc", "0.5", "--siappend",
                     "-o", "two.exr")
        self.succeed("oiiotool", "-a", "--native", "two.exr", "--resize:filter=ddt", "300%", "-o",
                     "expected.exr")
        self.succeed("oiiotool", "-a", "--native", "two.exr.ddt?scale=3", "-o", "out.exr")
        self.assertEqual(len(set(self.hashes("out.exr"))), 2)
        self.assert_same("out.exr", "expected.exr")

    def test_sidecar(self):
        os.mkdir(self.path("sub"))
        self.write("sub/big.ddt", "# enlarged for print\n../photo.png\r\n\nwidth=100\n"
                                  "filter=ddt-linear\nlight=encoded\n")
        self.succeed("oiiotool", "sub/big.ddt", "-o", "out.png")
        self.succeed("oiiotool", "photo.png.ddt?width=100&filter=ddt-linear,light=encoded", "-o",
                     "same.png")
        self.assert_same("out.png", "same.png")
        self.assertEqual(self.size("sub/big.ddt?scale=3"), (120, 96))

    def test_sidecar_with_an_absolute_path(self):
        self.write("big.ddt", f"{self.path('photo.png')}\nscale=2\n")
        self.assertEqual(self.size("big.ddt"), (80, 64))

    def refuse(self, name, *says):
        # In this process; test_programs_refuse shows that the programs do alike.
        self.assertIsNone(oiio.ImageInput.open(self.path(name)))
        error = oiio.geterror()
        for word in says:
            self.assertIn(word, error)
        self.assertNotIn("\n", error)

    def test_programs_refuse(self):
        name = "photo.png.ddt?scale=2&nonsense=1"
        self.fail_with("iinfo", name, says=("nonsense", "allowed"))
        self.fail_with("iconvert", name, "out.png", says=("nonsense", "allowed"), out="out.png")
        self.fail_with("oiiotool", name, "-o", "out.png", says=("ERROR",), out="out.png")

    def test_bad_names(self):
        for name, *says in (
                ("photo.png.ddt", "scale=", "width=", "height="),
                ("photo.png.ddt?scale=0", '"scale=0"', "above 0"),
                ("photo.png.ddt?scale=nan", '"scale=nan"'),
                ("photo.png.ddt?scale=inf", '"scale=inf"'),
                ("photo.png.ddt?scale=2x", '"scale=2x"'),
                ("photo.png.ddt?width=-3", '"width=-3"', "whole numbers"),
                ("photo.png.ddt?scale=2&nonsense=1", '"nonsense"', "allowed", "light", "width"),
                ("photo.png.ddt?scale=2&scheme=magic", '"scheme=magic"', "lawson"),
                ("photo.png.ddt?scale=2&filter=lanczos3", '"lanczos3"', "ddt-linear"),
                ("nosuch.png.ddt?scale=2", "nosuch.png"),
                ("photo.png.ddt.ddt?scale=2", "photo.png.ddt"),
                ("photo.png.ddt?scale=1e9", '"scale=1e9"'),
                ("photo.png.ddt?scale=1e6", "too large"),
                ("photo.png.ddt?scale=20000", "MB")):
            with self.subTest(name=name):
                self.refuse(name, *says)

    def test_bad_sidecars(self):
        for text, *says in (("", "empty", "path of an image"), ("# nothing\n", "empty"),
                            ("nosuch.png\nscale=2\n", "nosuch.png"),
                            ("bad.ddt\nscale=2\n", "bad.ddt"),
                            ("photo.png\nnonsense=1\n", '"nonsense"', "bad.ddt"),
                            ("photo.png\n", "scale="), ("\0\1\2\3", "not a sidecar"),
                            ("x" * 70000, "not a sidecar")):
            with self.subTest(text=text[:20]):
                self.write("bad.ddt", text)
                self.refuse("bad.ddt", *says)

    def test_special_files_and_recursion(self):
        os.mkfifo(self.path("pipe.png"))
        self.fail_with("iinfo", "pipe.png.ddt?scale=2", says=("ddt: ", "not a regular file"))
        for source, *says in (("pipe.png", "not a regular file"), ("/dev/zero", "not a regular"),
                              (".", "not a regular file"), ("chain.ddt", "not itself a .ddt"),
                              ("other.ddt", "not itself a .ddt"),
                              ("photo.png.ddt?scale=2", "not itself a .ddt")):
            with self.subTest(source=source):
                self.write("chain.ddt", f"{source}\nscale=2\n")
                self.refuse("chain.ddt", *says)

    def test_addresses_reach_nobody(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            server.setblocking(False)
            address = f"127.0.0.1:{server.getsockname()[1]}"
            for source in (f"http://{address}/film.mp4", f"tcp://{address}/film.mp4"):
                self.write("a.ddt", f"{source}\nscale=2\n")
                for name in ("a.ddt", f"{source}.ddt?scale=2"):
                    self.fail_with("iinfo", name, says=("ddt: ", "not a regular file", "allowed"))
                    with self.assertRaises(BlockingIOError):
                        server.accept()

    def test_sizes_that_no_machine_has(self):
        self.refuse("photo.png.ddt?scale=20000", "ddt: ", "800000 x 640000", "allowed")
        self.refuse("photo.png.ddt?scale=1e6", "ddt: ", "16777216")

    def test_errors_at_reading(self):
        self.fail_with("iconvert", "--scanline", "photo.png.ddt?scale=2&light=nosuchspace", "out.png",
                       says=("nosuchspace",))

    def test_a_hidden_file_without_a_name(self):
        # Has no extension, so all readers are tried, under a mutex that opening a file takes.
        os.mkdir(self.path("sub"))
        for name in (".ddt", ".ddt?scale=2", "sub/.ddt?scale=2"):
            self.fail_with("iinfo", name, says=(name,))

    def test_deep_images(self):
        self.succeed("oiiotool", "scene.exr", "--ch", "R,G,B,A=0.5,Z=1", "--deepen", "-o",
                     "deep.exr", plugin=False)
        self.refuse("deep.exr.ddt?scale=2", "deep")

    def test_foreign_names_are_not_ours(self):
        # All readers are tried on these; none may hang or take them.
        for name in ("nosuch.zzz", "photo.png.ddtx", "ddt.zzz"):
            self.write("ddt.zzz", "not an image")
            self.fail_with("iinfo", name, says=(name,))
        # A wrong extension, found by its content.
        os.rename(self.path("photo.png"), self.path("photo.zzz"))
        self.assertEqual(self.size("photo.zzz"), (40, 32))
        self.assertEqual(self.size("photo.zzz.ddt?scale=2"), (80, 64))


if __name__ == "__main__":
    unittest.main()
