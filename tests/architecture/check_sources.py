#!/usr/bin/python3
"""Says where the sources break a rule of the house that can be seen without compiling them (README.md of this folder).

check_sources.py [ROOT]: prints one line a fault and ends with 1 where there is any.
"""
import pathlib
import re
import subprocess
import sys

# What each folder may include of ours.
MAY_INCLUDE = {
    "base": {"base"},
    "gmap": {"gmap"},
    "plans": {"base", "plans"},
    "accel": {"base", "accel"},
    "modeler": {"base", "gmap", "plans", "accel", "modeler"},
    "render": {"base", "accel", "render"},
    "tools": {"base", "gmap", "plans", "accel", "modeler", "render", "tools"},
}
LIBRARIES = set(MAY_INCLUDE) - {"tools"}
# Folders whose sources see no CGAL: their build on a bare machine has none.
WITHOUT_CGAL = {"base", "accel", "render"}
CGAL_HEADERS = {"gmap/cgal.h"}  # the conversion for users of CGAL
PRINTS = re.compile(r"std::(cout|cerr|clog)\b|(?<![\w:])(std::)?(printf|puts|putchar)\s*\(|\bf(printf|puts|write)\s*\(\s*[^;]*std(out|err)\b|(?<![\w:.])(std::)?exit\s*\(")
MAY_PRINT = {"base/check.h"}  # says which of our own checks failed before it aborts
UNDONE = re.compile("TO" + r"DO|FIX" + r"ME|\bXX" + r"X\b|\bHA" + r"CK\b")
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
LONGEST = 500


def sources(root):
    """The C++ and CUDA files of the tree: those that git knows, or all where there is no git."""
    try:
        listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True, check=True)
        names = listed.stdout.splitlines()
    except (FileNotFoundError, subprocess.CalledProcessError):
        names = [str(p.relative_to(root)) for p in root.rglob("*") if p.is_file()]
    suffixes = {".h", ".cpp", ".cu", ".cuh", ".inl"}
    return sorted(n for n in names if pathlib.PurePath(n).suffix in suffixes and (root / n).is_file())


def include_faults(name, folder, number, quote, target):
    first = target.split("/")[0]
    if quote == '"' or first in MAY_INCLUDE:
        if folder in MAY_INCLUDE and first in MAY_INCLUDE and first not in MAY_INCLUDE[folder]:
            yield f"{name}:{number}: {folder} may not include {first} (\"{target}\")"
        if quote == '"' and "/" not in target and folder != "tests":
            yield f"{name}:{number}: include \"{target}\" from the root of the tree, with its folder"
    if first == "CGAL":
        if name.endswith(".h") and name not in CGAL_HEADERS and folder != "tests":
            yield f"{name}:{number}: CGAL in a header costs each of its includers 7-20 s"
        if folder in WITHOUT_CGAL:
            yield f"{name}:{number}: {folder} is built without CGAL"
    if first == "CLI" and name != "tools/flags.h":
        yield f"{name}:{number}: CLI11 is included by tools/flags.h alone"


def faults(root):
    for name in sources(root):
        folder = name.split("/")[0]
        lines = (root / name).read_text(encoding="utf-8").splitlines()
        head = " ".join(line.strip("/ ") for line in lines[:12])
        if name.endswith(".h") and "#pragma once" not in head and "include guard" not in head:
            yield f"{name}:1: a header starts with #pragma once, or with a comment that says why not"
        if len(lines) > LONGEST and not any("long because" in line.lower() for line in lines[:12]):
            yield f"{name}:1: {len(lines)} lines; over {LONGEST}, the reason stands at the top (\"Long because ...\")"
        for number, line in enumerate(lines, 1):
            include = INCLUDE.match(line)
            if include:
                yield from include_faults(name, folder, number, include[1], include[2])
            if UNDONE.search(line):
                yield f"{name}:{number}: an undone thing is finished or an issue, not a comment"
            if folder in LIBRARIES and name not in MAY_PRINT and PRINTS.search(line.split("//")[0]):
                yield f"{name}:{number}: libraries neither print nor exit"
    for name in ("CMakeLists.txt", *(str(p.relative_to(root)) for p in root.glob("*/CMakeLists.txt"))):
        if (root / name).is_file() and re.search(r"-ffast-math|-Ofast|-march=native", (root / name).read_text()):
            yield f"{name}:1: no fast-math and no code for this machine alone"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    found = list(faults(root))
    print("\n".join(found) if found else f"{len(sources(root))} source files keep the rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
