# SPDX-License-Identifier: Apache-2.0
"""The build's folders, and what is installed of the plugin."""

import glob
import os
import unittest

from support import BUILD, PLUGINS, Case


class Install(Case):
    def test_the_plugin_is_alone_in_its_folder(self):
        self.assertEqual(os.listdir(PLUGINS), ["ddt.imageio.so"])

    def test_installed_tree_works_wherever_it_is(self):
        self.succeed(os.environ["DDT_CMAKE"], "--install", BUILD, "--prefix", self.path("one"))
        os.rename(self.path("one"), self.path("two"))
        found = glob.glob(self.path("two/lib/**/ddt.imageio.so"), recursive=True)
        self.assertEqual(len(found), 1, found)
        self.assertEqual(os.listdir(os.path.dirname(found[0])), ["ddt.imageio.so"])
        self.succeed(self.path("two/bin/ddt-oiiotool"), "--create", "8x8", "3",
                     "--resize:filter=ddt", "200%", "-o", "out.png", plugin=False)
        self.succeed("oiiotool", "photo.png", "--resize:filter=ddt", "200%", "-o", "out.png",
                     plugin=False, OIIO_LIBRARY_PATH=os.path.dirname(found[0]))


if __name__ == "__main__":
    unittest.main()
