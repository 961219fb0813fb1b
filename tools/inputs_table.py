#!/usr/bin/python3
"""inputs_table.py ENFILADE DATA_FOLDER: the text of docs/inputs.md: what becomes of each real plan file.

Runs `enfilade import` and `enfilade build --keep-going` on every .sh3d and .dxf and every FloorspaceJS file under the
folder. What people counted in the pictures of drawings and floor plans stands in inputs_counted.json beside this file.
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


class Result:
    """A plan read and built: counts of the plan as read, the report, the scene's info; or why it was refused."""

    def __init__(self, enfilade, file, name, scratch, flags=()):
        self.refused = ""
        imported, scene = scratch / "plan.json", scratch / "scene.enf"
        for words in (("import", file, "-o", imported), ("build", file, "-o", scene, "--keep-going")):
            code, out, error = run(enfilade, *words, *flags, "--json")
            if code > 1:
                self.refused = "refused: " + error.removeprefix("enfilade: ").replace(str(file), name)
                return
            if words[0] == "import":
                self.plan = json.loads(out)["as_read"]
            else:
                self.built = json.loads(out)
        self.info = json.loads(run(enfilade, "info", scene, "--json")[1])
        storeys = json.loads(imported.read_text())["storeys"]
        asked = {opening["id"] for storey in storeys for opening in storey.get("openings", [])}
        self.placed = len(asked & {opening["id"] for opening in self.info["openings"]})

    def count(self, label):
        return sum(opening["label"] == label for opening in self.info["openings"])

    def defects(self):
        findings = self.built["check"]["findings"]
        errors = Counter(f["code"] for f in findings if f["severity"] == "error")
        return ", ".join(f"{code} x{n}" if n > 1 else code for code, n in sorted(errors.items())) or "none: sound"

    def repairs(self):
        return sum(f["code"].startswith("P") and f["severity"] != "error" for f in self.built["check"]["findings"])

    def sizes(self):
        return [f"{self.built['volumes']:,}", f"{self.built['scene']['cells']:,}", f"{self.built['seconds'] * 1000:.0f} ms"]


def print_table(header, left, rows):
    print("| " + " | ".join(header) + " |")
    print("|" + "|".join("---" if column in left else "--:" for column in header) + "|")
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print()


def home_row(enfilade, file, name, scratch):
    result = Result(enfilade, file, name, scratch)
    if result.refused:
        return [name] + [""] * 8 + [result.refused]
    rooms = result.info["rooms"]
    named = sum(room["name"] != "" for room in rooms)
    return [name, result.plan["walls"], f"{len(rooms)} ({named})", f"{result.placed} of {result.plan['openings']}",
            result.repairs(), result.defects(), *result.sizes(), "built"]


def counted_row(enfilade, file, name, scratch, counted):
    result = Result(enfilade, file, name, scratch, counted.get("flags", []))
    if result.refused:
        return [name] + [""] * 8 + [result.refused]
    found = [f"{n} of {counted[kind]}" if kind in counted else n
             for kind, n in (("rooms", len(result.info["rooms"])), ("doors", result.count("door")),
                             ("windows", result.count("window")))]
    return [name, result.plan["walls"], *found, result.count("opening"), result.defects(), *result.sizes(),
            " ".join(counted.get("flags", [])) + (": " if "flags" in counted else "") + counted.get("remark", "")]


def main():
    enfilade, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    counted = json.loads((pathlib.Path(__file__).parent / "inputs_counted.json").read_text(encoding="utf-8"))
    print("# Real plans\n")
    print("What becomes of each of the plan files that the developers have at hand (drawn by other people, so not part of this "
          "repository). Made by `tools/inputs.sh`. Do not edit: run it again.\n")
    print("*Repairs* are the notes and warnings of reading and cleaning; *defects* the errors, by code: `enfilade check FILE` "
          "names each with its place and what to do.\n")
    with tempfile.TemporaryDirectory() as temporary:
        scratch = pathlib.Path(temporary)
        print("## Sweet Home 3D homes\n")
        header = ["file", "walls", "rooms found (named)", "openings placed", "repairs", "defects", "volumes", "cells",
                  "build time", "verdict"]
        homes = [home_row(enfilade, file, str(file.relative_to(folder / "sh3d")), scratch)
                 for file in sorted((folder / "sh3d").rglob("*.sh3d"))]
        print_table(header, {"file", "defects", "verdict"}, homes)
        header = ["file", "walls", "rooms found of present", "doors", "windows", "plain openings", "defects", "volumes",
                  "cells", "build time", "remark"]
        for title, pattern, where in (("DXF drawings", "dxf/*.dxf", "their pictures"),
                                      ("FloorspaceJS floor plans", "other/floorspace_*.json", "their pictures")):
            print(f"## {title}\n\nFound, of what a person counts in {where}.\n")
            rows = [counted_row(enfilade, file, file.name, scratch, counted.get(str(file.relative_to(folder)), {}))
                    for file in sorted(folder.glob(pattern))]
            print_table(header, {"file", "defects", "remark"}, rows)


if __name__ == "__main__":
    main()
