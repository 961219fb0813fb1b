#!/usr/bin/python3
"""gpu_scripts_test.py SOURCES: the bundle for machines with a card holds all that its sources include, and the script that
runs there says in one sentence what is missing."""
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv.pop(1))
OURS = ("accel/", "base/", "render/", "tools/", "plans/", "modeler/", "gmap/")
# What a file includes where a build has that library: these builds have none of them.
OPTIONAL = re.compile(r"embree|lanes/|image_file|\bhwy\b")


def bundle(folder):
    scenes = pathlib.Path(folder) / "scenes"
    scenes.mkdir()
    (scenes / "bare-9.enf").write_bytes(b"not read here")
    archive = pathlib.Path(folder) / "bundle.tar.gz"
    subprocess.run([SOURCES / "tools/gpu-bundle.sh", archive], env={**os.environ, "SCENES": str(scenes)}, check=True,
                   capture_output=True)
    with tarfile.open(archive) as packed:
        packed.extractall(folder, filter="data") if hasattr(tarfile, "data_filter") else packed.extractall(folder)
    return pathlib.Path(folder) / "enfilade-gpu"


def check_with(commands, arguments, root):
    """gpu-check.sh where there are these commands besides the shell's own; name -> text of the script."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("bash", "dirname", "basename", "readlink", "sed", "head", "tr", "env", "cat", "grep", "nproc", "awk"):
            os.symlink(f"/usr/bin/{name}", f"{folder}/{name}")
        for name, text in commands.items():
            file = pathlib.Path(folder) / name
            file.write_text("#!/usr/bin/bash\n" + text)
            file.chmod(0o755)
        # nvcc is looked for where CUDA puts it, too: a script of that name stands before it.
        return subprocess.run(["/usr/bin/bash", root / "tools/gpu-check.sh", *arguments], env={"PATH": folder},
                              capture_output=True, text=True, check=False)


CMAKE = 'echo "cmake version 3.25.1"\n'
CARD = {"cmake": CMAKE, "c++": "", "nvcc": "exit 1\n", "nvidia-smi": 'echo "9.0"\n'}


class Bundle(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = bundle(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_holds_all_that_is_included(self):
        missing = set()
        for file in self.root.rglob("*"):
            if file.suffix not in {".h", ".cpp", ".cu"} or OPTIONAL.search(str(file)):
                continue
            for name in re.findall(r'^\s*#\s*include\s*"([^"]+)"', file.read_text(encoding="utf-8"), re.M):
                if name.startswith(OURS) and not OPTIONAL.search(name) and not (self.root / name).is_file():
                    missing.add(f"{file.relative_to(self.root)} includes {name}")
        self.assertEqual(missing, set())

    def test_needs_no_library(self):
        used = set()
        for file in self.root.rglob("*"):
            if file.suffix in {".h", ".cpp", ".cu"} and not OPTIONAL.search(str(file)):
                used.update(re.findall(r"#\s*include\s*<((?:glm|tbb|CGAL|nlohmann|CLI|gtest|OpenEXR)/[^>]+)>",
                                       file.read_text(encoding="utf-8")))
        used = {name for name in used if not name.startswith("tbb/")}  # executor.cpp, where TBB was found
        self.assertEqual(used, set())

    def test_takes_scenes_and_scripts_along(self):
        for name in ("scenes/bare-9.enf", "tools/gpu-check.sh", "tools/gpu/main.cpp", "CMakePresets.json"):
            self.assertTrue((self.root / name).is_file(), name)
        self.assertTrue(os.access(self.root / "tools/gpu-check.sh", os.X_OK))

    def test_says_what_is_missing(self):
        for commands, word in (({}, "cmake"), ({"cmake": 'echo "cmake version 3.20.0"\n'}, "3.25"), ({"cmake": CMAKE}, "compiler"),
                               ({**CARD, "nvidia-smi": "exit 9\n"}, "knows no card"),
                               (CARD, "neither ninja nor make")):
            done = check_with(commands, [], self.root)
            self.assertEqual(done.returncode, 3, (word, done.stderr))
            self.assertIn(word, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_says_that_the_build_failed(self):
        done = check_with({**CARD, "cmake": f'case $1 in --version) {CMAKE};; *) echo "CMake Error: no such luck"; exit 1;; esac\n',
                           "make": "", "mkdir": '/usr/bin/mkdir "$@"\n', "rm": '/usr/bin/rm "$@"\n'}, [], self.root)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("no such luck", done.stderr)
        self.assertIn("The build failed", done.stderr)

    def test_refuses_wrong_flags(self):
        for arguments in (["--fast"], ["--only"], ["--only", "tea"], ["--on", "mars"], ["--device", "x"], ["nowhere.tar.gz"]):
            done = check_with(CARD, arguments, self.root)
            self.assertEqual(done.returncode, 2, (arguments, done.stderr))
            self.assertIn("--help", done.stderr)

    def test_helps(self):
        for script in ("gpu-check.sh", "gpu-bundle.sh"):
            done = subprocess.run([SOURCES / "tools" / script, "--help"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("tools/" + script, done.stdout)


if __name__ == "__main__":
    unittest.main()
