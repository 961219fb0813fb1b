#!/usr/bin/python3
"""inputs_table.py ENFILADE PLANS_FOLDER: the text of docs/inputs.md: what becomes of each real plan file.

Runs `enfilade import` and `enfilade build --keep-going` on every .sh3d under the folder.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
from collections import Counter


def run(*words):
    """Exit code, standard output, last line of the errors."""
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, (done.stderr.strip().splitlines() or [""])[-1]


def row_of(enfilade, file, name, scratch):
    imported = scratch / "plan.json"
    code, out, error = run(enfilade, "import", file, "-o", imported, "--json")
    if code > 1:
        return [name] + [""] * 8 + [f"refused: {error.removeprefix('enfilade: ').replace(str(file), name)}"]
    plan = json.loads(out)["as_read"]
    scene = scratch / "scene.enf"
    code, out, error = run(enfilade, "build", file, "-o", scene, "--keep-going", "--json")
    if code > 1:
        return [name, plan["walls"]] + [""] * 7 + [f"refused: {error.removeprefix('enfilade: ').replace(str(file), name)}"]
    built = json.loads(out)
    findings = built["check"]["findings"]
    info = json.loads(run(enfilade, "info", scene, "--json")[1])
    rooms = info["rooms"]
    asked = {opening["id"] for storey in json.loads(imported.read_text())["storeys"] for opening in storey.get("openings", [])}
    placed = len(asked & {opening["id"] for opening in info["openings"]})
    repairs = sum(f["code"].startswith("P") and f["severity"] != "error" for f in findings)
    errors = Counter(f["code"] for f in findings if f["severity"] == "error")
    defects = ", ".join(f"{code} x{count}" if count > 1 else code for code, count in sorted(errors.items())) or "none: sound"
    named = sum(room["name"] != "" for room in rooms)
    return [name, plan["walls"], f"{len(rooms)} ({named})", f"{placed} of {plan['openings']}", repairs, defects,
            f"{built['volumes']:,}", f"{built['scene']['cells']:,}", f"{built['seconds'] * 1000:.0f} ms", "built"]


def main():
    enfilade, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    print("# Real plans\n")
    print("What becomes of each of the Sweet Home 3D files that the developers have at hand (drawn by other people, so not part "
          "of this repository). Made by `tools/inputs.sh`. Do not edit: run it again.\n")
    print("*Repairs* are the notes and warnings of reading and cleaning; *defects* the errors, by code: `enfilade check FILE` "
          "names each with its place and what to do.\n")
    header = ["file", "walls", "rooms found (named)", "openings placed", "repairs", "defects", "volumes", "cells", "build time", "verdict"]
    print("| " + " | ".join(header) + " |")
    print("|---|" + "--:|" * 4 + "---|" + "--:|" * 3 + "---|")
    with tempfile.TemporaryDirectory() as scratch:
        for file in sorted(folder.rglob("*.sh3d")):
            row = row_of(enfilade, file, str(file.relative_to(folder)), pathlib.Path(scratch))
            print("| " + " | ".join(str(cell) for cell in row) + " |")


if __name__ == "__main__":
    main()
