#!/usr/bin/python3
"""commands_page.py ENFILADE [--compare PAGE]: the text of docs/commands.md, from what --help says.

With --compare it ends with 1 where PAGE says something else.
"""
import pathlib
import subprocess
import sys

COMMANDS = ["import", "generate", "build", "check", "place", "info", "render", "tour", "trace", "export", "bench"]
HEAD = """# Commands

What `enfilade COMMAND --help` prints. Made by `tools/commands_page.py build/release/tools/enfilade >docs/commands.md`; do not
edit.

## What every command has in common

- Results go to standard output, everything else (the progress bar, what went wrong) to standard error.
- `--quiet` keeps back all but errors and what was asked for; `--json` prints one JSON value instead of text. The values of
  `check`, `info` and `bench` have schemas: [check](check.schema.json), [info](info.schema.json), [bench](bench.schema.json).
- A file is written under another name first and renamed at the end: it is there whole, or not at all.

| exit code | means |
|--:|---|
| 0 | all is well; warnings and notes may have been printed |
| 1 | the plan or the model has errors (with `--strict`: or warnings) |
| 2 | a file, a plan or a flag is wrong: one sentence says which and where |
| 3 | a file or a device would not do its part: not readable, not writable, no memory |
"""


def help_of(*words):
    done = subprocess.run([*words, "--help"], capture_output=True, text=True, check=True)
    return "\n".join(line.rstrip() for line in done.stdout.strip().splitlines())


def page(enfilade):
    parts = [HEAD]
    for command in COMMANDS:
        parts.append(f"## {command}\n\n```text\n{help_of(enfilade, command)}\n```\n")
    return "\n".join(parts)


def main():
    text = page(sys.argv[1])
    if len(sys.argv) < 4:
        sys.stdout.write(text)
        return 0
    if pathlib.Path(sys.argv[3]).read_text(encoding="utf-8") == text:
        return 0
    print(f"{sys.argv[3]} is not what --help says: make it again (its head says how)", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
