# SPDX-License-Identifier: Apache-2.0
"""What the modules show of themselves and what they need: a host has its own oneTBB, Highway,
OpenImageIO, and none may be taken from it or given to it. OpenImageIO's plugin, which may need what
the host has, shows no more of itself than they do."""

import glob
import os
import subprocess
import unittest

HOSTS = os.path.join(os.environ["DDT_BUILD"], "hosts")
PLUGIN = os.path.join(os.environ["DDT_BUILD"], "plugins", "ddt.imageio.so")
PLUGIN_SHOWS = {"ddt_imageio_version", "ddt_imageio_library_version", "ddt_input_imageio_create",
                "ddt_input_extensions", "ddt_redirects"}
BASE = {"libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6", "libpthread.so.0",
        "libdl.so.2", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
# File: the symbols shown, the beginnings of the names of further libraries.
MODULES = {
    "openfx/oiio-ddt.ofx.bundle/Contents/*/oiio-ddt.ofx":
        ({"OfxGetNumberOfPlugins", "OfxGetPlugin"}, ()),
    "gegl/ddt.so": ({"gegl_module_query", "gegl_module_register"},
                    ("libgegl-0.4", "libbabl-0.1", "libglib-2.0", "libgobject-2.0",
                     "libgmodule-2.0", "libgio-2.0", "libjson-glib-1.0")),
    "imagemagick/ddt.so": ({"ddtImage"}, (f"libMagickCore-{os.environ['DDT_MAGICK']}.",)),
    "python/oiio_ddt/_ddt.*.so": ({"PyInit__ddt"}, ()),
}


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Modules(unittest.TestCase):
    def setUp(self):
        self.found = [(path, *what) for pattern, what in MODULES.items()
                      for path in glob.glob(os.path.join(HOSTS, pattern))]
        self.assertTrue(self.found)

    def test_nothing_is_shown_but_the_entry_points(self):
        shown = [(path, entries) for path, entries, _ in self.found]
        if os.path.exists(PLUGIN):
            shown.append((PLUGIN, PLUGIN_SHOWS))
        for path, entries in shown:
            with self.subTest(path):
                lines = output_of("nm", "-D", "--defined-only", path).split("\n")
                self.assertEqual({line.split()[-1] for line in lines if line}, entries)

    def test_only_libraries_of_the_host_and_of_the_language_are_needed(self):
        for path, _, allowed in self.found:
            with self.subTest(path):
                needed = [line.split("[")[1].rstrip("]")
                          for line in output_of("readelf", "-dW", path).split("\n")
                          if "(NEEDED)" in line]
                self.assertEqual([name for name in needed
                                  if name not in BASE and not name.startswith(allowed or ("\0",))],
                                 [])

    def test_nothing_of_tbb_or_highway_is_taken_from_the_host(self):
        for path, _, _ in self.found:
            with self.subTest(path):
                undefined = output_of("nm", "-DC", "--undefined-only", path)
                for word in ("tbb::", "hwy::", "OpenImageIO", "OpenColorIO"):
                    self.assertNotIn(word, undefined)

    def test_a_module_stays_where_it_is(self):
        for path, _, _ in self.found:
            with self.subTest(path):
                self.assertIn("NODELETE", output_of("readelf", "-dW", path))


if __name__ == "__main__":
    unittest.main()
