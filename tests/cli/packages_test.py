#!/usr/bin/python3
"""packages_test.py SOURCES: where packages are missing and may not be installed, the scripts name them and end with 3."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv[1])


def run_with(commands):
    """install-packages.sh on a machine that has these commands besides the shell's own; name -> text of the script."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("bash", "dirname", "env", "cat"):
            os.symlink(f"/usr/bin/{name}", f"{folder}/{name}")
        for name, text in commands.items():
            file = pathlib.Path(folder) / name
            file.write_text("#!/usr/bin/bash\n" + text)
            file.chmod(0o755)
        return subprocess.run(["/usr/bin/bash", SOURCES / "tools/install-packages.sh"], env={"PATH": folder},
                              capture_output=True, text=True, check=False)


INSTALLED = 'case "$*" in *libcgal-dev* | *ninja-build*) exit 1 ;; *) printf "install ok installed" ;; esac\n'


class Packages(unittest.TestCase):
    def test_without_root(self):
        done = run_with({"dpkg-query": INSTALLED, "apt-get": "exit 99\n", "id": "echo 1000\n"})
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("These packages are missing: ninja-build libcgal-dev\n", done.stderr)
        self.assertIn("root", done.stderr)

    def test_without_apt(self):
        done = run_with({"dpkg-query": INSTALLED, "id": "echo 0\n"})
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("libcgal-dev", done.stderr)

    def test_without_dpkg(self):
        done = run_with({"id": "echo 0\n"})
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("libcgal-dev", done.stderr)

    def test_installs_only_what_is_missing(self):
        done = run_with({"dpkg-query": INSTALLED, "id": "echo 0\n", "apt-get": 'echo "apt-get $*" >&2\n'})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stderr.splitlines()[-1].endswith("install -y --no-install-recommends ninja-build libcgal-dev"), done.stderr)

    def test_nothing_to_do(self):
        done = run_with({"dpkg-query": 'printf "install ok installed"\n', "id": "echo 1000\n"})
        self.assertEqual((done.returncode, done.stdout + done.stderr), (0, ""))

    def test_a_failed_install_is_a_failure(self):
        done = run_with({"dpkg-query": INSTALLED, "id": "echo 0\n", "apt-get": "exit 100\n"})
        self.assertNotEqual(done.returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
