# SPDX-License-Identifier: Apache-2.0
"""What `ddt` prints, and standard streams that are closed, full or not read."""

import os
import unittest

from process_case import ProcessCase
from support import DDT


class Streams(ProcessCase):
    def test_progress_lines(self):
        code, text = self.run_to_end("resize", "photo.png", "200%", "out.png", "--progress",
                                     "lines")
        self.assertEqual(code, 0)
        shares = [int(line.split()[2].rstrip("%")) for line in text.splitlines()]
        self.assertEqual(shares, sorted(set(shares)))
        self.assertEqual(shares[-1], 100)

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


if __name__ == "__main__":
    unittest.main()
