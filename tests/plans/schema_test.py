"""The published schema says what the reader does: same keys, and it accepts the examples and what the writer writes."""
import json
import pathlib
import re
import sys

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

SOURCES = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = json.loads((SOURCES / "docs/plan.schema.json").read_text())


def reader_keys():
    text = (SOURCES / "plans/json_keys.h").read_text()
    return {name: set(re.findall(r'"([^"]+)"', body))
            for name, body in re.findall(r"(\w+)_list\[\] = \{(.*?)\};", text, re.S)}


def main():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    validator = jsonschema.Draft202012Validator(SCHEMA)
    for name, keys in reader_keys().items():
        part = SCHEMA if name == "plan" else SCHEMA["$defs"][name]
        assert set(part["properties"]) == keys, (name, set(part["properties"]) ^ keys)
    examples = sorted(p for p in (SOURCES / "plans/examples").glob("*.json") if not p.name.endswith(".views.json"))
    assert len(examples) >= 3
    for example in examples:
        validator.validate(json.loads(example.read_text()))
    broken = json.loads(examples[0].read_text())
    broken["storeys"][0]["walls"][0]["thicknes"] = 1
    assert not validator.is_valid(broken)


main()
