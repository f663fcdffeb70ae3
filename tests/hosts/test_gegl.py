# SPDX-License-Identifier: Apache-2.0
"""The operation gegl:ddt in Debian's `gegl` and in GIMP's console, against oiiotool with the plugin."""

import os
import shutil
import subprocess
import unittest

import support

FOLDER = os.path.join(support.BUILD, "hosts", "gegl")


def gegl_environment():
    system = subprocess.run(["pkg-config", "--variable=pluginsdir", "gegl-0.4"], check=True,
                            capture_output=True, text=True).stdout.strip()
    return {"GEGL_PATH": f"{system}:{FOLDER}", "GEGL_USE_OPENCL": "no"}


class Gegl(support.Case):
    # GEGL reads and writes floats as they are: a photograph, a drawing with alpha, light beyond 1.
    IMAGES = {
        **support.Case.IMAGES,
        "float.exr": "photo.png --iscolorspace Linear -d float",
        "alpha.exr": "photo.tif --iscolorspace Linear -d float",
        "large.exr": "--pattern fill:topleft=1,0,0:bottomright=0,3,2 700x300 3 "
                     "--line:color=1,1,1 3,2,690,288 -d float",
    }

    def gegl(self, source, out, *properties):
        # The program ends with 0 whatever happens: what counts is the picture.
        done = self.attempt("gegl", source, "-o", out, "--", "ddt", *properties,
                            **gegl_environment())
        return done.stdout + done.stderr

    def same_floats(self, a, b):
        self.succeed("oiiotool", a, "-d", "float", "-o", "a.tif")
        self.succeed("oiiotool", b, "-d", "float", "-o", "b.tif")
        self.assert_same("a.tif", "b.tif")

    def test_the_filters_bits(self):
        for name in ("float.exr", "alpha.exr", "large.exr"):
            for spec, properties in (("ddt", ()), ("ddt-sharp,cost=scf,meshes=2",
                                                   ("filter=ddt-sharp", "cost=scf", "meshes=2"))):
                said = self.gegl(name, "out.exr", "scale=3", *properties)
                self.assertEqual(said, "", name)
                self.succeed("oiiotool", name, f"--resize:filter={spec},light=linear", "300%",
                             "-o", "wanted.exr")
                self.same_floats("out.exr", "wanted.exr")

    def test_a_photograph_grows(self):
        self.assertEqual(self.gegl("photo.png", "out.png", "scale=2.5"), "")
        self.assertEqual(self.size("out.png"), (100, 80))

    def test_a_scale_of_one_changes_nothing(self):
        self.gegl("float.exr", "out.exr", "scale=1")
        self.same_floats("out.exr", "float.exr")

    def test_what_is_not_allowed_is_told(self):
        said = self.gegl("photo.png", "out.png", "scale=2", "device=nonsense")
        self.assertIn("device", said)

    @unittest.skipUnless(shutil.which("gimp-console-2.10"), "GIMP's console is not there")
    def test_gimp(self):
        script = ('(let* ((image (car (gimp-file-load RUN-NONINTERACTIVE "photo.png" "photo.png"))))'
                  '(gimp-message (number->string (car (gimp-image-width image)))) (gimp-quit 0))')
        done = self.attempt("gimp-console-2.10", "-idf", "--batch-interpreter",
                            "plug-in-script-fu-eval", "-b", script, HOME=self.folder,
                            **gegl_environment())
        self.assertIn("40", done.stdout + done.stderr)
        self.assertNotIn("ddt.so", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
