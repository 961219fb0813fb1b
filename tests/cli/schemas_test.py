#!/usr/bin/python3
"""schemas_test.py ENFILADE SOURCES: what the program prints as JSON follows the schemas of docs/, and the schemas refuse
what is wrong."""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

ENFILADE, SOURCES = sys.argv[1], pathlib.Path(sys.argv[2])


def run(*words):
    done = subprocess.run([ENFILADE, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


def validator(name):
    schema = json.loads((SOURCES / "docs" / f"{name}.schema.json").read_text())
    return jsonschema.Draft202012Validator(schema)


class Schemas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        run("generate", "--rooms", 8, "-o", cls.folder / "plan.json")
        run("build", cls.folder / "plan.json", "-o", cls.folder / "scene.enf", "--report", cls.folder / "report.json")

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_check_of_a_plan(self):
        validator("check").validate(json.loads(run("check", self.folder / "plan.json", "--json")))

    def test_check_of_a_scene(self):
        validator("check").validate(json.loads(run("check", self.folder / "scene.enf", "--json")))

    def test_report_of_a_build(self):
        validator("check").validate(json.loads((self.folder / "report.json").read_text()))

    def test_check_of_real_plans(self):
        homes = sorted((SOURCES / "../shared/data/sh3d").glob("*.sh3d"))
        if not homes:
            self.skipTest("../shared is not on this machine")
        found = 0
        for home in homes[:4]:
            report = json.loads(run("check", home, "--json"))
            validator("check").validate(report)
            found += len(report["findings"])
        self.assertGreater(found, 0, "real plans have findings")

    def test_info(self):
        info = json.loads(run("info", self.folder / "scene.enf", "--json"))
        validator("info").validate(info)
        broken = copy.deepcopy(info)
        del broken["rooms"][0]["area_m2"]
        self.assertFalse(validator("info").is_valid(broken))
        broken = copy.deepcopy(info)
        broken["rooms"][0]["cut_area_m2"] = -1
        self.assertFalse(validator("info").is_valid(broken))

    def test_info_of_a_room_and_what_it_sees(self):
        rooms = json.loads(run("info", self.folder / "scene.enf", "--json"))["rooms"]
        info = json.loads(run("info", self.folder / "scene.enf", "--json", "--visible-from", rooms[0]["id"]))
        validator("info").validate(info)
        self.assertGreater(len(info["visible_from"]["spaces"]), 1)
        info["visible_from"]["spaces"][0]["view_share"] = 1.5
        self.assertFalse(validator("info").is_valid(info))

    def test_bench(self):
        run("bench", "gmap", "--quick", "--json", self.folder / "rows.json")
        rows = json.loads((self.folder / "rows.json").read_text())
        validator("bench").validate(rows)
        self.assertGreaterEqual(len(rows["rows"]), 4)
        broken = copy.deepcopy(rows)
        broken["rows"][0]["goal"] = "fast"
        self.assertFalse(validator("bench").is_valid(broken))

    def test_check_schema_refuses_unknown_severities(self):
        report = json.loads(run("check", self.folder / "plan.json", "--json"))
        report["findings"].append({"code": "P1", "severity": "grave", "sentence": "x", "hint": "", "point": None, "storey": "", "elements": [], "moved_mm": 0})
        self.assertFalse(validator("check").is_valid(report))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
