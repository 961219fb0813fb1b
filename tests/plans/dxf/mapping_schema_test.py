"""The published schema of mapping files says what the reader does: same keys, same roles; the page's examples fit it."""
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
SCHEMA = json.loads((SOURCES / "docs/drawing-mapping.schema.json").read_text())


def reader_keys():
    text = (SOURCES / "plans/dxf/mapping.cpp").read_text()
    return {name: set(re.findall(r'"([^"]+)"', body))
            for name, body in re.findall(r"(\w+)_list\[\] = \{(.*?)\};", text, re.S)}


def reader_roles():
    return re.findall(r'RoleName\{Role::\w+, "([^"]+)"\}', (SOURCES / "plans/dxf/role.cpp").read_text())


def main():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    validator = jsonschema.Draft202012Validator(SCHEMA)
    rule = SCHEMA["$defs"]["rule"]
    keys = reader_keys()
    assert set(keys) == {"file", "rule"}, keys
    assert set(SCHEMA["properties"]) == keys["file"], keys
    assert set(rule["properties"]) == keys["rule"], keys
    assert sorted(rule["properties"]["is"]["enum"]) == sorted(reader_roles()), reader_roles()
    page = (SOURCES / "docs/dxf.md").read_text()
    examples = re.findall(r"```json\n(.*?)```", page, re.S)
    assert examples
    for example in examples:
        validator.validate(json.loads(example))
    for broken in ({"layer": []}, {"layers": [{"name": "a"}]}, {"layers": [{"name": "a", "is": "tree"}]},
                   {"blocks": [{"name": "a", "is": "door", "head": 2100}]}):
        assert not validator.is_valid(broken), broken


main()
