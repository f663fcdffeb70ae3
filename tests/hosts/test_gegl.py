# SPDX-License-Identifier: Apache-2.0
"""The operation gegl:ddt in Debian's `gegl` and in GIMP's console, against oiiotool with the plugin."""

import os
import shutil
import subprocess
import sys
import unittest

import OpenImageIO

import support

FOLDER = os.path.join(support.BUILD, "hosts", "gegl")


def gegl_environment():
    system = subprocess.run(["pkg-config", "--variable=pluginsdir", "gegl-0.4"], check=True,
                            capture_output=True, text=True).stdout.strip()
    # Babl takes the way from one format to another that is quickest today, and allows itself some
    # error unless it is told not to.
    return {"GEGL_PATH": f"{system}:{FOLDER}", "GEGL_USE_OPENCL": "no", "BABL_TOLERANCE": "0"}


# Programs of GEGL's C functions, which Debian has no Python module for.
GRAPH = """
import ctypes, sys
from ctypes import POINTER, Structure, byref, c_char_p, c_double, c_int, c_void_p
gegl, babl = ctypes.CDLL("libgegl-0.4.so.0"), ctypes.CDLL("libbabl-0.1.so.0")
class Rectangle(Structure):
    _fields_ = [(name, c_int) for name in ("x", "y", "width", "height")]
for name in ("gegl_node_new", "gegl_node_new_child", "gegl_buffer_new"):
    getattr(gegl, name).restype = c_void_p
gegl.gegl_node_get_bounding_box.restype = Rectangle
babl.babl_format.restype = c_void_p
gegl.gegl_init(None, None)
graph = c_void_p(gegl.gegl_node_new())
def node(operation, key, value):
    return c_void_p(gegl.gegl_node_new_child(graph, c_char_p(b"operation"), c_char_p(operation),
                                             c_char_p(key), value, None))
def blit(node, rectangle):
    pixels = (ctypes.c_float * (rectangle.width * rectangle.height * 4))()
    gegl.gegl_node_blit(node, c_double(1), byref(rectangle),
                        c_void_p(babl.babl_format(b"RGBA float")), pixels, 0, 0)
    return pixels
"""

# Enlarges a file threefold in pieces of 64 x 64 pixels; prints how many those were.
PIECES = GRAPH + """
load = node(b"gegl:load", b"path", c_char_p(sys.argv[1].encode()))
ddt = node(b"gegl:ddt", b"scale", c_double(3))
gegl.gegl_node_link_many(load, ddt, None)
box = gegl.gegl_node_get_bounding_box(ddt)
pieces = 0
for y in range(0, min(box.height, 128), 64):
    for x in range(0, min(box.width, 192), 64):
        blit(ddt, Rectangle(box.x + x, box.y + y, 64, 64))
        pieces += 1
print(pieces)
"""

# Enlarges a file; prints how many threads it was seen to begin.
THREADS = GRAPH + """
import os, threading
load = node(b"gegl:load", b"path", c_char_p(sys.argv[1].encode()))
ddt = node(b"gegl:ddt", b"scale", c_double(2))
gegl.gegl_node_link_many(load, ddt, None)
blit(load, Rectangle(0, 0, 64, 64))  # GEGL begins its own
done, before, begun = threading.Event(), set(), set()
def watch():
    while not done.is_set():
        begun.update(os.listdir("/proc/self/task"))
watcher = threading.Thread(target=watch)
watcher.start()
before.update(os.listdir("/proc/self/task"))
box = gegl.gegl_node_get_bounding_box(ddt)
blit(ddt, box)
done.set()
watcher.join()
print(len(begun - before))
"""

# Enlarges a file so many times, a corner of it or all, and prints what progress was told.
PROGRESS = GRAPH + """
load = node(b"gegl:load", b"path", c_char_p(sys.argv[1].encode()))
ddt = node(b"gegl:ddt", b"scale", c_double(float(sys.argv[2])))
gegl.gegl_node_link_many(load, ddt, None)
told = []
note = ctypes.CFUNCTYPE(None, c_void_p, c_double, c_char_p, c_void_p)(
    lambda node, share, text, data: told.append(share))
ctypes.CDLL("libgobject-2.0.so.0").g_signal_connect_data(ddt, c_char_p(b"progress"), note, None,
                                                         None, 0)
blit(ddt, Rectangle(0, 0, 64, 64))
print(*told)
"""

# Prints alpha of the ends of a row of 8 x 8 pixels of a palette, the left half of which is
# transparent, enlarged twofold.
PALETTE = GRAPH + """
plain, with_alpha = c_void_p(), c_void_p()
babl.babl_new_palette(b"colours", byref(plain), byref(with_alpha))
babl.babl_palette_set_palette(with_alpha, c_void_p(babl.babl_format(b"R'G'B' u8")),
                              bytes([255, 0, 0, 0, 255, 0]), 2)
box = Rectangle(0, 0, 8, 8)
buffer = c_void_p(gegl.gegl_buffer_new(byref(box), with_alpha))
row = bytes([1, 0] * 4 + [1, 255] * 4)
gegl.gegl_buffer_set(buffer, byref(box), 0, with_alpha, row * 8, 0)
source = node(b"gegl:buffer-source", b"buffer", buffer)
ddt = node(b"gegl:ddt", b"scale", c_double(2))
gegl.gegl_node_link_many(source, ddt, None)
pixels = blit(ddt, Rectangle(0, 7, 16, 1))
print(pixels[3], pixels[4 * 15 + 3])
"""


# Prints alpha of the corner of 8 x 8 pixels of 50 % alpha in a format, enlarged twofold.
HALF_THERE = GRAPH + """
form = c_void_p(babl.babl_format(sys.argv[1].encode()))
box = Rectangle(0, 0, 8, 8)
buffer = c_void_p(gegl.gegl_buffer_new(byref(box), form))
gegl.gegl_buffer_set(buffer, byref(box), 0, form, (ctypes.c_float * 256)(*[0.5] * 256), 0)
source = node(b"gegl:buffer-source", b"buffer", buffer)
ddt = node(b"gegl:ddt", b"scale", c_double(2))
gegl.gegl_node_link_many(source, ddt, None)
print(round(blit(ddt, Rectangle(0, 0, 16, 16))[3], 3))
"""

class Gegl(support.Case):
    # GEGL reads and writes floats as they are: a photograph, a drawing with alpha, light beyond 1.
    IMAGES = {
        **support.Case.IMAGES,
        "float.exr": "photo.png --iscolorspace Linear -d float",
        "alpha.exr": "photo.tif --iscolorspace Linear -d float",
        "large.exr": "--pattern fill:topleft=1,0,0:bottomright=0,3,2 700x300 3 "
                     "--line:color=1,1,1 3,2,690,288 -d float",
        "deep.png": "photo.png -d uint16",
        "grey.png": "photo.png --ch 0 --chnames Y -d uint8",
        "straight.png": "--pattern fill:topleft=0.9,0.1,0.2,0:topright=0.1,0.7,0.3,1:"
                        "bottomleft=0.2,0.3,0.8,0.5:bottomright=1,1,0,1 48x40 4 "
                        "--box:color=1,0,0,0:fill=1 10,6,20,30 "
                        "--attrib:type=int oiio:UnassociatedAlpha 1 -d uint16",
    }

    def gegl(self, source, out, *properties):
        # The program ends with 0 whatever happens: what counts is the picture.
        done = self.attempt("gegl", source, "-o", out, "--", "ddt", *properties,
                            **gegl_environment())
        # It complains at its end about whatever operation has a cache, as its own blurs.
        return "".join(line for line in (done.stdout + done.stderr).splitlines(True)
                       if line.strip() and "GeglBuffers leaked" not in line
                       and "gegl_tile_cache_destroy" not in line)

    def same_floats(self, a, b):
        pixels = [self.load(name).get_pixels("float") for name in (a, b)]
        self.assertEqual(pixels[0].shape, pixels[1].shape, f"{a} and {b}")
        self.assertEqual(pixels[0].tobytes(), pixels[1].tobytes(), f"{a} and {b}")

    def test_the_filters_bits(self):
        for name in ("float.exr", "alpha.exr", "large.exr"):
            for spec, properties in (("ddt", ()),
                                     ("ddt-sharp,cost=scf,meshes=2",
                                      ("filter=ddt-sharp", "cost=scf", "meshes=2")),
                                     ("ddt-sharp,clipped=1,fitted=0,min_gain=auto",
                                      ("filter=ddt-sharp", "clipped=1", "fitted=0",
                                       "min-gain=-2"))):
                said = self.gegl(name, "out.exr", "scale=3", *properties)
                self.assertEqual(said, "", name)
                self.succeed("oiiotool", name, f"--resize:filter={spec},light=linear", "300%",
                             "-o", "wanted.exr")
                self.same_floats("out.exr", "wanted.exr")

    def test_the_filters_bits_of_numbers_that_are_encoded(self):
        for name in ("photo.png", "deep.png", "grey.png"):
            for spec, properties in (("ddt", ()), ("ddt,light=encoded", ("light=encoded",))):
                if properties and name != "photo.png":
                    continue
                self.assertEqual(self.gegl(name, "out.tif", "scale=2.5", *properties), "")
                self.succeed("oiiotool", name, f"--resize:filter={spec}", "250%", "-d", "float",
                             "-o", "wanted.tif")
                self.same_floats("out.tif", "wanted.tif")

    def test_codes_in_a_file_are_at_most_one_apart(self):
        # Babl rounds in double, OpenImageIO in float: the middle of two codes may become either.
        self.assertEqual(self.gegl("photo.png", "out.png", "scale=2.5"), "")
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "250%", "-d", "uint16", "-o",
                     "wanted.png")
        self.succeed("oiiotool", "--fail", "0.0000153", "--diff", "out.png", "wanted.png")

    def test_alpha_is_multiplied_in_floats(self):
        # oiiotool by itself would multiply codes of 16 bits while it reads, and lose some of them.
        numbers = ("oiiotool", "--iconfig", "oiio:UnassociatedAlpha", "1")
        self.assertEqual(self.gegl("straight.png", "out.tif", "scale=2"), "")
        self.succeed(*numbers, "straight.png", "-d", "float", "--eraseattrib",
                     "oiio:UnassociatedAlpha", "--premult", "-o", "product.exr")
        self.succeed("oiiotool", "product.exr", "--resize:filter=ddt,light=sRGB", "200%",
                     "--unpremult", "-d", "float", "-o", "wanted.exr")
        # It complains about GEGL's profile of colours.
        self.attempt(*numbers, "out.tif", "--eraseattrib", "oiio:UnassociatedAlpha", "-d", "float",
                     "-o", "numbers.exr")
        self.assert_same("numbers.exr", "wanted.exr")

    def test_a_scale_of_one_changes_nothing(self):
        self.gegl("float.exr", "out.exr", "scale=1")
        self.same_floats("out.exr", "float.exr")

    def test_a_scale_of_one_fills_holes(self):
        image = self.load("float.exr")
        pixels = image.get_pixels("float")
        pixels[11:18, 20:29] = float("nan")
        holed = OpenImageIO.ImageBuf(image.spec())
        holed.set_pixels(image.roi, pixels)
        self.assertTrue(holed.write(self.path("holes.exr")))
        self.succeed("oiiotool", "holes.exr.ddt?scale=1&holes=fill", "-d", "float", "-o",
                     "wanted.exr")
        self.assertEqual(self.gegl("holes.exr", "out.exr", "scale=1", "holes=fill"), "")
        self.same_floats("out.exr", "wanted.exr")
        self.assert_different("out.exr", "holes.exr")

    def test_pieces_are_of_one_enlargement(self):
        # As GIMP asks: piece after piece of one graph.
        done = self.attempt("python3", "-c", PIECES, self.path("float.exr"), DDT_VERBOSE="1",
                            **gegl_environment())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(int(done.stdout), 1)
        self.assertEqual(done.stderr.count("ddt: "), 1, done.stderr)

    def test_of_a_large_result_no_more_is_made_than_is_near_what_is_asked_for(self):
        # 77 gigabytes, of which a corner is wanted; and what lies on both sides of a border.
        for name, scale, cut in (("float.exr", 1024, (0, 0, 96, 64)),
                                 ("large.exr", 24, (1900, 5800, 400, 500))):
            x, y, width, height = cut
            said = self.gegl(name, "out.exr", f"scale={scale}", "crop", f"x={x}", f"y={y}",
                             f"width={width}", f"height={height}")
            self.assertEqual(said, "", name)
            self.succeed("oiiotool", f"{name}.ddt?scale={scale}", "--cut",
                         f"{width}x{height}+{x}+{y}", "-d", "float", "-o", "wanted.exr")
            self.same_floats("out.exr", "wanted.exr")

    def test_progress_neither_begins_nor_ends_at_a_piece(self):
        # GIMP would begin or end a progress of the operation's own, and forget the one that users
        # can cancel.
        for scale, pieces in (8, False), (24, True):
            done = self.attempt("python3", "-c", PROGRESS, self.path("large.exr"), str(scale),
                                **gegl_environment())
            self.assertEqual(done.returncode, 0, done.stderr)
            told = [float(share) for share in done.stdout.split()]
            self.assertEqual(told == [], pieces, scale)
            self.assertTrue(all(0 < share < 1 for share in told), told)

    def test_palettes_keep_their_alpha(self):
        done = self.attempt("python3", "-c", PALETTE, **gegl_environment())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.split(), ["0.0", "1.0"])

    def test_formats_of_other_models_keep_their_alpha(self):
        for form in ("HSVA float", "HSLA float", "CIE LCH(ab) alpha float", "RGBA float"):
            done = self.attempt("python3", "-c", HALF_THERE, form, **gegl_environment())
            self.assertEqual((done.returncode, done.stdout), (0, "0.5\n"), form + done.stderr)

    def test_grey_with_alpha_is_blended_encoded(self):
        # A blur makes associated linear light, and of opaque and transparent pixels some of each.
        self.succeed("oiiotool", "--pattern", "fill:topleft=0.9,1:topright=0.1,1:bottomleft=0.2,1:"
                     "bottomright=1,1", "64x48", "2", "--box:color=0.5,0:fill=1", "8,6,40,40",
                     "--chnames", "Y,A", "--attrib:type=int", "oiio:UnassociatedAlpha", "1", "-d",
                     "uint8", "-o", "veil.png")
        numbers = ("--iconfig", "oiio:UnassociatedAlpha", "1")
        self.succeed("oiiotool", *numbers, "veil.png", "--ch", "0,0,0,1", "--chnames", "R,G,B,A",
                     "--attrib:type=int", "oiio:UnassociatedAlpha", "1", "-d", "uint8", "-o",
                     "colour.png")
        pixels = {}
        # As users have it: where babl is told to be exact it takes another way between formats.
        usual = gegl_environment()
        del usual["BABL_TOLERANCE"]
        for name in ("veil", "colour"):
            self.attempt("gegl", f"{name}.png", "-o", f"{name}.exr", "--", "gaussian-blur",
                         "std-dev-x=2", "std-dev-y=2", "filter=fir", "ddt", "scale=2", "light=encoded",
                         **usual)
            pixels[name] = self.load(f"{name}.exr").get_pixels("float")
        self.assertEqual(pixels["veil"].shape, (96, 128, 2))
        self.assertEqual(pixels["veil"].min(), 0)
        self.assertGreater(pixels["veil"][..., 1].max(), 0.999)
        self.assertLess(abs(pixels["veil"] - pixels["colour"][..., 2:]).max(), 1e-4)

    def test_what_is_cut_off_does_not_move_the_rest(self):
        # Values tell where they come from: 41 and 42 columns from column 1 and 2 on, 1.5 times.
        ramp = "--pattern fill:left=0,0,0:right=64,64,64 64x8 3 -d float"
        self.succeed("oiiotool", *ramp.split(), "-o", "ramp.exr")
        self.succeed("oiiotool", "ramp.exr", "--resize:filter=ddt-linear", "96x12", "-d", "float",
                     "-o", "wanted.exr")
        for x, width in (1, 41), (2, 42), (3, 40):
            self.attempt("gegl", "ramp.exr", "-o", "out.exr", "--", "crop", f"x={x}",
                         f"width={width}", "height=8", "ddt", "scale=1.5", "filter=ddt-linear",
                         **gegl_environment())
            # Columns that are whole, not of the rim; GEGL writes the corner as 0, 0.
            first, last = -(-3 * x // 2) + 2, 3 * (x + width) // 2 - 3
            corner = 3 * x // 2
            self.succeed("oiiotool", "out.exr", "--origin", f"+{corner}+0", "--cut",
                         f"{last - first}x12+{first}+0", "-o", "a.exr")
            self.succeed("oiiotool", "wanted.exr", "--cut", f"{last - first}x12+{first}+0",
                         "-o", "b.exr")
            self.same_floats("a.exr", "b.exr")

    def test_its_number_of_threads_counts(self):
        self.succeed("oiiotool", "photo.png", "--resize", "900x600", "-o", "large.png")

        def begun(threads):
            return int(self.succeed(sys.executable, "-c", THREADS, self.path("large.png"),
                                    **gegl_environment(), GEGL_THREADS=threads))
        if begun("2") == 0:
            self.skipTest("this machine, or its quota, has one processor")
        self.assertEqual(begun("1"), 0)

    def test_what_has_no_end_is_told(self):
        done = self.attempt("gegl", "-o", "out.png", "--", "checkerboard", "ddt", "scale=2", "crop",
                            "width=10", "height=10", **gegl_environment())
        self.assertIn("crop it first", done.stdout + done.stderr)

    def test_what_is_not_allowed_is_told(self):
        said = self.gegl("photo.png", "out.png", "scale=2", "device=nonsense")
        self.assertIn("nonsense\naccepted values: auto cpu egl osmesa", said)


# Operations with one of these categories GIMP 2.10's tool "GEGL Operation" leaves out of its list.
NOT_IN_GIMP = {"compositors", "core", "debug", "display", "hidden", "input", "output", "programming",
               "transform", "video"}


class Gimp(support.Case):
    PROGRAM = shutil.which("gimp-console-2.10") or shutil.which("gimp-console")
    IMAGES = {"small.png": "--create 40x32 3 -d uint8"}

    # GIMP 2.10 runs operations of others by its GEGL tool alone, which a script cannot use: what can
    # be seen of it is that the tool would offer the operation, and that GIMP takes the module in.
    def test_its_tool_would_offer_it(self):
        about = subprocess.run(["gegl", "--info", "gegl:ddt"], capture_output=True, check=True,
                               env={**os.environ, **gegl_environment()}).stdout
        said = dict(line.split(None, 1) for line in about.decode(errors="replace").splitlines()
                    if len(line.split(None, 1)) == 2)
        # GIMP adds the name: "Enlarge (ddt)".
        self.assertEqual(said["title"], "Enlarge")
        self.assertTrue(NOT_IN_GIMP.isdisjoint(said["categories"].split(":")), said["categories"])

    def is_gimp_2(self):
        return " 2." in self.succeed(self.PROGRAM, "--version", HOME=self.folder)

    def run_script(self, script, *more, **environment):
        return self.attempt(self.PROGRAM, "-idf", "--batch-interpreter", "plug-in-script-fu-eval",
                            "-b", script, *more, HOME=self.folder, **environment, **gegl_environment())

    @unittest.skipUnless(PROGRAM, "skipped: GIMP's console is not there")
    def test_scripts_enlarge_a_layer(self):
        if self.is_gimp_2():
            self.skipTest("scripts of GIMP 2 cannot call operations of others")
        self.succeed("oiiotool", "--pattern", "checker:width=7:height=5", "40x32", "3", "-d",
                     "uint8", "-o", "checks.png")
        script = """(let* ((image (car (gimp-file-load RUN-NONINTERACTIVE "checks.png")))
            (layer (vector-ref (car (gimp-image-get-layers image)) 0)))
            (gimp-drawable-merge-new-filter layer "gegl:ddt" 0 LAYER-MODE-REPLACE 1.0 "scale" 2.0)
            (gimp-image-resize-to-layers image)
            (gimp-file-save RUN-NONINTERACTIVE image "out.png"))"""
        self.run_script(script, "--quit")
        self.succeed("oiiotool", "checks.png", "--resize:filter=ddt", "200%", "-o", "wanted.png")
        self.assert_same("out.png", "wanted.png")

    @unittest.skipUnless(PROGRAM, "skipped: GIMP's console is not there")
    def test_it_takes_the_module_in(self):
        file, width = (('"small.png" "small.png"', "gimp-image-width") if self.is_gimp_2() else
                       ('"small.png"', "gimp-image-get-width"))
        script = (f"(let* ((image (car (gimp-file-load RUN-NONINTERACTIVE {file}))))"
                  f'(gimp-message (string-append "width " '
                  f"(number->string (car ({width} image))))) (gimp-quit 0))")
        done = self.run_script(script, LD_DEBUG="files", LD_DEBUG_OUTPUT=self.path("loaded"))
        said = done.stdout + done.stderr
        self.assertIn("width 40", said)
        self.assertNotIn("ddt.so", said)
        loaded = ""
        for name in os.listdir(self.folder):
            if name.startswith("loaded."):
                with open(self.path(name), encoding="utf-8", errors="replace") as file:
                    loaded += file.read()
        self.assertIn(f"calling init: {FOLDER}/ddt.so", loaded)


if __name__ == "__main__":
    unittest.main()
