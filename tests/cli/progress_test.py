#!/usr/bin/python3
"""progress_test.py ENFILADE: work over a second shows a bar on a terminal, and nowhere else."""
import os
import pathlib
import pty
import subprocess
import sys
import tempfile
import unittest

ENFILADE = sys.argv[1]
# An oracle's picture: as slow as is asked for, on any machine.
SLOW = ["render", "office.enf", "-o", "slow.png", "--camera", "exterior", "--tracer", "oracle", "--spp", "1", "--size"]


def stderr_on_terminal(folder, words):
    """Exit code, and what the program wrote to a terminal as its standard error."""
    master, slave = pty.openpty()
    env = dict(os.environ, TERM="xterm")
    with subprocess.Popen([ENFILADE, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=slave, env=env) as process:
        os.close(slave)
        text = b""
        while True:
            try:
                part = os.read(master, 4096)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            text += part
    os.close(master)
    return process.returncode, text.decode()


class ProgressBar(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        for words in (["generate", "--rooms", "200", "-o", "office.json"], ["build", "office.json", "-o", "office.enf"]):
            subprocess.run([ENFILADE, *words], cwd=cls.folder, check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_long_work_shows_a_bar_and_takes_it_away(self):
        code, text = stderr_on_terminal(self.folder, [*SLOW, "800x600"])
        self.assertEqual(code, 0, text)
        self.assertIn("] Rendering, ", text)
        self.assertTrue(text.endswith("\r\x1b[K"), repr(text[-40:]))

    def test_short_work_shows_none(self):
        self.assertEqual(stderr_on_terminal(self.folder, [*SLOW, "8x8"]), (0, ""))

    def test_quiet_shows_none(self):
        self.assertEqual(stderr_on_terminal(self.folder, [*SLOW, "480x360", "--quiet"]), (0, ""))

    def test_no_bar_without_a_terminal(self):
        done = subprocess.run([ENFILADE, *SLOW, "480x360"], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
