# SPDX-License-Identifier: Apache-2.0
"""A libOpenImageIO linked with -Bsymbolic-functions, as some distributions build it: its own calls
reach the plugin nowhere."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest

import own_calls
import support


def libraries():
    """The OpenImageIO libraries that oiiotool uses: paths by name."""
    text = subprocess.run(["ldd", shutil.which("oiiotool")], capture_output=True, text=True,
                          check=True).stdout
    return dict(re.findall(r"(libOpenImageIO\S*) => (\S+)", text))


class OwnCalls(support.Case):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder_of_libraries = tempfile.mkdtemp(prefix="ddt-own-calls-")
        cls.addClassCleanup(shutil.rmtree, cls.folder_of_libraries)
        for name, path in libraries().items():
            changed = own_calls.bind(path, os.path.join(cls.folder_of_libraries, name))
            if changed < 100:
                raise unittest.SkipTest(f"{name} is linked so already")
        cls.bound = {"LD_LIBRARY_PATH": cls.folder_of_libraries, "LD_BIND_NOW": "1"}

    def test_every_command_gives_the_same_pixels(self):
        for number, command in enumerate((
                "--resize:filter=ddt 300%", "--fit:filter=ddt 100x90",
                "--fit:filter=ddt:exact=1 100x90", "--rotate:filter=ddt 5",
                "--warp:filter=ddt 3,0.4,0,-0.4,3,0,0,0,1", "--pixelaspect:filter=ddt 0.5")):
            with self.subTest(command):
                usual, bound = f"usual{number}.tif", f"bound{number}.tif"
                self.succeed("oiiotool", "photo.png", *command.split(), "-o", usual)
                self.succeed("oiiotool", "photo.png", *command.split(), "-o", bound, **self.bound)
                self.assert_same(usual, bound)

    def test_what_is_not_reached_fails_and_gives_no_tent(self):
        self.fail_with("maketx", "--filter", "ddt", "photo.png", "-o", "photo.tx", says=["ddt"],
                       out="photo.tx", **self.bound)

    def test_that_is_told(self):
        done = self.attempt("oiiotool", "photo.png", "--resize:filter=ddt", "200%", "-o", "a.tif",
                            DDT_VERBOSE="1", **self.bound)
        self.assertIn("missed: calls within OpenImageIO", done.stderr)


if __name__ == "__main__":
    unittest.main()
