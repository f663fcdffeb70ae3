# SPDX-License-Identifier: Apache-2.0
"""ddt-oiiotool: what the plugin path alone does not cover."""

import os
import shutil
import unittest

from support import PLUGINS, WRAPPER, Case


class Wrapper(Case):
    def test_pattern_before_any_file(self):
        pattern = ("--pattern", "checker:width=3", "16x16", "3", "--resize:filter=ddt", "400%")
        self.succeed(WRAPPER, *pattern, "-d", "float", "-o", "out.exr", plugin=False)
        self.assertEqual(self.size("out.exr"), (64, 64))
        self.assertEqual(self.extrema("out.exr")[0], (0.0, 1.0))

    def test_create_before_any_file(self):
        self.succeed(WRAPPER, "--create", "16x16", "3", "--resize:filter=ddt,light=encoded",
                     "200%", "-o", "out.png", plugin=False)
        self.assertEqual(self.size("out.png"), (32, 32))

    def test_same_result_as_with_the_path(self):
        command = ("photo.png", "--resize:filter=ddt", "300%", "-o")
        self.succeed(WRAPPER, *command, "wrapper.png", plugin=False)
        self.succeed("oiiotool", *command, "path.png")
        self.assert_same("wrapper.png", "path.png")

    def test_maketx_help_lists_the_filters(self):
        text = self.succeed(WRAPPER, "--tool", "maketx", "--help", plugin=False)
        self.assertIn(" ddt-linear", text)

    def test_reader(self):
        self.assertIn("80 x", self.succeed(WRAPPER, "--tool", "iinfo", "photo.png.ddt?scale=2",
                                           plugin=False))

    def test_exit_status_and_errors_pass_through(self):
        self.fail_with(WRAPPER, "photo.png", "--resize:filter=ddt,nonsense=1", "200%", "-o",
                       "out.png", says=("nonsense",), out="out.png", plugin=False)

    def test_programs_started_by_the_program_are_left_alone(self):
        text = self.succeed(WRAPPER, "--tool", "env", "sh", "-c", "echo \"<$LD_PRELOAD>\"",
                            plugin=False)
        self.assertEqual(text.strip(), "<>")

    def test_other_preloads_stay(self):
        text = self.succeed(WRAPPER, "--tool", "env", plugin=False, LD_PRELOAD="libm.so.6")
        self.assertIn("LD_PRELOAD=libm.so.6\n", text)

    def test_another_build_in_the_path(self):
        """Is left out, or OpenImageIO would say that there are two; what else is there stays."""
        plugin = os.path.join(PLUGINS, "ddt.imageio.so")
        for folder in "another build", "with others", "*":
            os.mkdir(self.path(folder))
            shutil.copy(plugin, self.path(folder))
        shutil.copy(plugin, self.path("with others/more.imageio.so"))
        alone, others, star = (self.path(name) for name in ("another build", "with others", "*"))
        path = f"{alone}:/no folder::{others}:{star}"
        text = self.succeed(WRAPPER, "--tool", "env", plugin=False, OIIO_LIBRARY_PATH=path,
                            OPENIMAGEIO_PLUGIN_PATH=path)
        for name in "OIIO_LIBRARY_PATH", "OPENIMAGEIO_PLUGIN_PATH":
            self.assertIn(f"{name}={os.path.realpath(PLUGINS)}:/no folder::{others}\n", text)
        self.succeed(WRAPPER, "photo.png", "--resize:filter=ddt", "200%", "-o", "out.png",
                     plugin=False, OIIO_LIBRARY_PATH=alone, OPENIMAGEIO_PLUGIN_PATH=alone)

    def test_bad_tools(self):
        self.fail_with(WRAPPER, "--tool", "nosuchprogram", says=("nosuchprogram",), plugin=False)
        self.fail_with(WRAPPER, "--tool", says=("--tool needs",), plugin=False)
        with open(self.path("script"), "w") as file:
            file.write("#!/bin/sh\n")
        os.chmod(self.path("script"), 0o755)
        self.fail_with(WRAPPER, "--tool", "./script", says=("is a script",), plugin=False)

    def test_by_a_link(self):
        os.symlink(WRAPPER, self.path("link"))
        self.succeed("./link", "photo.png", "--resize:filter=ddt", "200%", "-o", "out.png",
                     plugin=False)


if __name__ == "__main__":
    unittest.main()
