#!/usr/bin/python3
"""gltf_validator_test.py ENFILADE FOLDER: Khronos' validator finds no fault in an exported .glb.

The validator is an npm package, installed into FOLDER; where npm or its registry cannot be reached, the test says so and
ends with 77 (skipped).
"""
import json
import pathlib
import shutil
import subprocess
import sys

ENFILADE, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
PACKAGE = "gltf-validator@2.0.0-dev.3.10"
SCRIPT = """
const fs = require('fs'), validator = require('gltf-validator');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])), {maxIssues: 20})
  .then(report => console.log(JSON.stringify(report.issues)), fault => { console.error(fault); process.exit(1); });
"""


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def install():
    if not shutil.which("node") or not shutil.which("npm"):
        skip("there is no npm on this machine")
    if (FOLDER / "node_modules/gltf-validator").is_dir():
        return
    done = subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", FOLDER, PACKAGE],
                          capture_output=True, text=True, timeout=120, check=False)
    if done.returncode != 0:
        skip(f"npm cannot install {PACKAGE}: {done.stderr.strip()[-200:]}")


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    try:
        install()
    except subprocess.TimeoutExpired:
        skip("the npm registry does not answer")
    for words in (["generate", "--rooms", "12", "--storeys", "2", "--curved", "0.3", "-o", "a.json"],
                  ["build", "a.json", "-o", "a.enf", "-q"], ["export", "a.enf", "-o", "a.glb"]):
        subprocess.run([ENFILADE, *words], cwd=FOLDER, check=True)
    done = subprocess.run(["node", "-e", SCRIPT, "a.glb"], cwd=FOLDER, capture_output=True, text=True, check=True)
    issues = json.loads(done.stdout)
    print(json.dumps(issues, indent=1))
    return 1 if issues["numErrors"] or issues["numWarnings"] else 0


if __name__ == "__main__":
    sys.exit(main())
