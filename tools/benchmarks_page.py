#!/usr/bin/python3
"""benchmarks_page.py ROWS.json COMMAND: the text of docs/benchmarks.md, from what `enfilade bench --json` wrote."""
import itertools
import json
import sys

TITLES = {
    "build": "From a plan to a scene",
    "check": "Proving a model sound",
    "gmap": "The topological kernel",
    "scene": "Loading a scene",
    "cells": "Tracing through cells",
    "dial": "What each option costs",
}
NOTES = {
    "build": "![Seconds and memory over rooms](growth.svg)\n\nOn one core; *plan to scene* is all that `enfilade build` does "
             "between reading the plan and writing the file, the check included.",
    "scene": "Opening maps the file and validates every index in it. The reference reads all its bytes and checks nothing.",
    "cells": "The same rays, in the same run, in turn. A ratio over 1: faster than the reference.",
    "dial": "![Error over time of each option](dial.svg)\n\nAn error is measured on the same rays against the finest value of "
            "the option, or against the oracle where the row says so.",
}


def number(value):
    if value is None:
        return ""
    if value != 0 and (abs(value) >= 1e6 or abs(value) < 1e-3):
        return f"{value:.2e}"
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def table(rows):
    lines = ["| what | on | threads | value | reference | ratio | goal | |", "|---|---|--:|--:|---|--:|---|---|"]
    for row in rows:
        reference = f"{row['reference']}: {number(row['reference_value'])}" if row["reference"] else ""
        verdict = {True: "met", False: "**not met**", None: ""}[row["met"]]
        lines.append(f"| {row['row']} | {row['scene']} | {row['threads']} | {number(row['value'])} {row['unit']} | {reference} "
                     f"| {number(row['ratio'])} | {row['goal'] or ''} | {verdict} |")
    return "\n".join(lines)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        data = json.load(file)
    goals = [row for row in data["rows"] if row["goal"]]
    print("# Benchmarks\n")
    print(f"Made by `{sys.argv[2]}` with Enfilade {data['version']} on {data['machine']['processor']}, "
          f"{data['machine']['cores']} cores{', quick runs' if data['quick'] else ''}. Do not edit: run it again.\n")
    print("Times differ from machine to machine; ratios compare two programs in one run, in turn, and travel better. "
          "*Ratio* is how many times better the value is than the reference.\n")
    print(f"{sum(row['met'] is True for row in goals)} of {len(goals)} goals are met.")
    for bench, rows in itertools.groupby(data["rows"], key=lambda row: row["bench"]):
        print(f"\n## {TITLES.get(bench, bench)} (`enfilade bench {bench}`)\n")
        if bench in NOTES:
            print(NOTES[bench] + "\n")
        print(table(list(rows)))


if __name__ == "__main__":
    main()
