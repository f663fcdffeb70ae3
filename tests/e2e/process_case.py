# SPDX-License-Identifier: Apache-2.0
"""`ddt` as a process whose signals and limits a test chooses."""

import signal
import subprocess

from support import DDT, Case, environment


def heed_signals():
    """A shell's background jobs ignore SIGINT, and so would theirs."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class ProcessCase(Case):
    def ddt(self, *arguments, **how):
        how.setdefault("preexec_fn", heed_signals)
        return subprocess.Popen([DDT, *arguments], cwd=self.folder, env=environment(False),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **how)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_to_end(self, *arguments, **how):
        process = self.ddt(*arguments, **how)
        out, err = process.communicate(timeout=120)
        return process.returncode, out + err
