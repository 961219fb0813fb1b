#!/usr/bin/python3
"""views_schema_test.py ENFILADE SOURCES: docs/views.schema.json says what the reader of view files does: the same keys, and
it accepts what `enfilade tour` writes and the tours of the examples."""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

ENFILADE, SOURCES = sys.argv[1], pathlib.Path(sys.argv[2])
SCHEMA = json.loads((SOURCES / "docs/views.schema.json").read_text())


def reader_keys():
    text = (SOURCES / "tools/view_file.cpp").read_text()
    return {name: set(re.findall(r'"([^"]+)"', body)) for name, body in re.findall(r"(\w+)_list\[\] = \{(.*?)\};", text, re.S)}


def made_tour():
    with tempfile.TemporaryDirectory() as folder:
        for words in (["generate", "--rooms", "8", "-o", "plan.json"], ["build", "plan.json", "-o", "scene.enf"],
                      ["tour", "scene.enf", "-o", "tour.json", "--views", "6"]):
            subprocess.run([ENFILADE, *words, "--quiet"], cwd=folder, check=True)
        return json.loads((pathlib.Path(folder) / "tour.json").read_text())


def main():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    validator = jsonschema.Draft202012Validator(SCHEMA)
    keys = reader_keys()
    assert set(SCHEMA["properties"]) == keys["file"], keys
    assert set(SCHEMA["$defs"]["view"]["properties"]) == keys["view"], keys
    tours = sorted((SOURCES / "plans/examples").glob("*.views.json"))
    assert len(tours) >= 4, tours
    for tour in tours:
        validator.validate(json.loads(tour.read_text()))
    tour = made_tour()
    validator.validate(tour)
    breaks = {
        "no view": lambda t: t["views"].clear(),
        "two coordinates": lambda t: t["views"][0]["eye"].pop(),
        "a key of no one": lambda t: t["views"][0].update(roll=1),
        "half a cell": lambda t: t["views"][0].update(cell=0.5),
        "too wide": lambda t: t["views"][0].update(fov_deg=180),
        "no target": lambda t: t["views"][0].pop("target"),
        "another version": lambda t: t.update(format_version=2),
    }
    for what, change in breaks.items():
        broken = copy.deepcopy(tour)
        change(broken)
        assert not validator.is_valid(broken), what


main()
