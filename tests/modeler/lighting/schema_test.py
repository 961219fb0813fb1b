"""The published schema of lamp rules says what the reader does: same keys, and it accepts the page's example."""
import json
import pathlib
import re
import sys

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

SOURCES = pathlib.Path(__file__).resolve().parents[3]
SCHEMA = json.loads((SOURCES / "docs/lamps.schema.json").read_text())


def reader_keys():
    text = (SOURCES / "modeler/lighting/lamp_keys.h").read_text()
    return {name: set(re.findall(r'"([^"]+)"', body))
            for name, body in re.findall(r"(\w+)_list\[\] = \{(.*?)\};", text, re.S)}


def main():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    validator = jsonschema.Draft202012Validator(SCHEMA)
    keys = reader_keys()
    assert len(keys) == 4
    for name, known in keys.items():
        part = SCHEMA if name == "lamp_rules" else SCHEMA["$defs"][name]
        assert set(part["properties"]) == known, (name, set(part["properties"]) ^ known)
    page = (SOURCES / "docs/lamps.md").read_text()
    for word in sorted(set().union(*keys.values())):
        assert word in page, f"docs/lamps.md does not tell of {word}"
    plan, rules = [json.loads(text) for text in re.findall(r"```json\n(.*?)```", page, re.S)]
    validator.validate(rules)
    plan_schema = json.loads((SOURCES / "docs/plan.schema.json").read_text())
    jsonschema.Draft202012Validator(plan_schema).validate(plan)
    rules["rooms"][0]["lxu"] = 1
    assert not validator.is_valid(rules)


main()
