"""The published schema of rules says what the reader does: same keys, same relations, and it accepts our own rules."""
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
SCHEMA = json.loads((SOURCES / "docs/furnishing.schema.json").read_text())


def reader_keys():
    text = (SOURCES / "modeler/furnishing/rule_keys.h").read_text()
    return {name: set(re.findall(r'"([^"]+)"', body))
            for name, body in re.findall(r"(\w+)_list\[\] = \{(.*?)\};", text, re.S)}


def relations():
    text = (SOURCES / "modeler/furnishing/rules.cpp").read_text()
    return re.findall(r'case Relation::\w+: return "(\w+)"', text)


def main():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    validator = jsonschema.Draft202012Validator(SCHEMA)
    keys = reader_keys()
    assert len(keys) == 5
    for name, known in keys.items():
        part = SCHEMA if name == "rules" else SCHEMA["$defs"][name]
        assert set(part["properties"]) == known, (name, set(part["properties"]) ^ known)
    assert SCHEMA["$defs"]["object"]["properties"]["place"]["enum"] == relations()
    page = (SOURCES / "docs/furnishing.md").read_text()
    for word in relations() + sorted(set().union(*keys.values())):
        assert f"`{word}`" in page, f"docs/furnishing.md does not tell of {word}"
    text = (SOURCES / "modeler/furnishing/own_rules.json").read_text()
    rules = json.loads(re.sub(r"^//.*$", "", text, flags=re.M))
    validator.validate(rules)
    for example in re.findall(r"```json\n(.*?)```", page, re.S):
        validator.validate(json.loads(example))
    rules["rooms"][0]["objects"][0]["cuont"] = 1
    assert not validator.is_valid(rules)


main()
