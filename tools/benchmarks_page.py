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
    "queries": "Files of rays",
    "convexify": "Cutting rooms into cells",
    "edit": "Boxes put into buildings, and taken out",
    "furniture": "Furnishing by rule",
    "furnished": "Tracing furnished floors",
    "dial": "What each option costs",
}
NOTES = {
    "build": "![Seconds and memory over rooms](growth.svg)\n\nOn one core; *plan to scene* is all that `enfilade build` does "
             "between reading the plan and writing the file, the check included.",
    "scene": "Opening maps the file and validates every index in it. The reference reads all its bytes and checks nothing.",
    "cells": "The same rays, in the same run, in turn; Mrays/s, in brackets how many times faster than Embree's best way to do the "
             "same: its one ray at a time for *scalar* pictures, else whatever is fastest of rtcIntersect1, 8 and 16 (rtcOccluded "
             "for shadow rays), coherent or not, over triangles or quads, with the shading in lanes. **!**: below the goal.",
    "queries": "`enfilade trace` as a whole, on one core: reading float64, locating origins, tracing, writing records; the "
               "reference has its columns of floats and their cells already ([queries.md](queries.md)).",
    "convexify": "![Every plan under every way to cut](convexify.svg)\n\nThe ways to cut rooms (`--convexify`), on generated plans "
                 "and on those of other people that the developers have at hand. Cells, sections, faces and bytes count "
                 "openings and the exterior. *SAH* is the sum that `sah` minimises: the visits' worth that a ray pays "
                 "(modeler/cutting/README.md). *Pieces* are those of rooms without holes over the sum of ceil(r/2)+1 (r = corners "
                 "that turn right, between different lines): nothing can do with fewer than 1. *Cut* is the time to cut all "
                 "regions, on one core. Rays are the same for all three, in turn; in brackets how many times faster than "
                 "hertel-mehlhorn.",
    "furniture": "Our own rules and pieces. *Guarantees* are told by a verifier that shares nothing with the placing "
                 "(modeler/furnishing/verify_furnished.h); of what rules ask for, the rest found no place and is reported.",
    "furnished": "Floors furnished by our own rules with our own pieces at detail 4; one thread; the same rays in the same run. Embree "
                 "holds each mesh as a scene of its own and each object as an instance beside the faces, at its highest quality; "
                 "*16, coherent* is what ratios of pictures are against, of triangles or quads, whichever is faster. The faces as an "
                 "instance, too, and all triangles in one structure are slower. Its shadow rays are never said to be coherent: with "
                 "instances Embree 3.13 may then never return.",
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


WAYS = ["sah", "hertel-mehlhorn", "diagonals"]
PLAN_COLUMNS = {"cells": "cells", "cells a room": "a room", "sections a cell": "sections a cell", "faces a section":
                "faces a section", "SAH sum": "SAH", "virtual portals": "portals, m2", "bytes a cell": "B a cell",
                "cut": "cut, ms", "pieces of rooms without holes, over ceil(r/2)+1": "pieces",
                "pieces of rooms without holes, over the bound": "over bound",
                "cells a ray": "cells a ray", "random rays": "random, Mrays/s", "primary rays and Lambert": "primary, Mrays/s"}
ROOM_COLUMNS = {"one room": "s", "one room, a corner": "us a corner", "one room, pieces": "pieces"}


def is_met(rows):
    return "**not met**" if any(row["met"] is False for row in rows) else "met" if any(row["goal"] for row in rows) else ""


def cell(row):
    if row is None:
        return ""
    ratio = f" ({number(row['ratio'])})" if row["ratio"] is not None else ""
    return number(row["value"]) + ratio + (" **!**" if row["met"] is False else "")


def pivot(rows, columns):
    """A line for each scene and way to cut, a column for each quantity."""
    found = {}
    for row in rows:
        way, _, quantity = row["row"].partition(": ")
        found.setdefault((row["scene"], way), {})[quantity] = row
    used = {name: title for name, title in columns.items() if any(name in line for line in found.values())}
    lines = ["| on | way | " + " | ".join(used.values()) + " | goals |", "|---|---|" + "--:|" * len(used) + "---|"]
    for (scene, way), line in found.items():
        lines.append(f"| {scene} | {way} | " + " | ".join(cell(line.get(name)) for name in used) + f" | {is_met(line.values())} |")
    return "\n".join(lines)


def convexify_tables(rows):
    """Plans by way to cut, rooms by way to cut, and what is left as in other benchmarks."""
    by_plan, by_room, left = [], [], []
    compared = {row["scene"] for row in rows if row["row"].endswith(": sections a cell")}
    for row in rows:
        way, _, quantity = row["row"].partition(": ")
        if way in WAYS and row["scene"] in compared:
            by_plan.append(row)
        elif way in WAYS and quantity in ROOM_COLUMNS:
            by_room.append(row)
        else:
            left.append(row)
    shown = [row for row in by_plan if row["row"].partition(": ")[2] in PLAN_COLUMNS]
    left += [row for row in by_plan if row not in shown and row["met"] is False]
    return "\n\n".join([pivot(shown, PLAN_COLUMNS), pivot(by_room, ROOM_COLUMNS), table(left)])


TRACED = {"primary rays and Lambert": "Pictures of 1024x1024, Lambert into the framebuffer, 8 views in rooms",
          "diffuse bounces in image order": "Diffuse bounces from what the pictures show, in their order",
          "diffuse bounces, shuffled": "The same in random order",
          "shadow rays to points": "Shadow rays from what the pictures show to lamps under ceilings"}


def against(rows):
    """'44 (16, coherent, quads)' for each reference, Embree's single rays first, the fill limit last."""
    named = {row["reference"]: row for row in rows if row["reference"]}
    texts = [f"{number(row['reference_value'])} ({name.removeprefix('Embree rtcIntersect').removeprefix('Embree rtcOccluded')})"
             for name, row in named.items()]
    return "; ".join(texts)


def traced_table(what, rows):
    """A line for each building and number of threads, a column for each tracer."""
    ends = ", " + what
    tracers = list(dict.fromkeys(row["row"].removesuffix(ends) for row in rows))
    goals = {row["row"].removesuffix(ends): row["goal"].removeprefix("ratio >= ") for row in rows if row["goal"]}
    has_one = len(set(goals.values())) == 1  # of whoever is fastest, or for each
    heads = [name + (f" (goal {goals[name]})" if name in goals and not has_one else "") for name in tracers]
    title = TRACED[what] + (f" (goal of our fastest: {next(iter(goals.values()))} times as fast)" if has_one else "")
    lines = [f"### {title}\n", "| on | threads | " + " | ".join(heads) + " | against |", "|---|--:|" + "--:|" * len(heads) + "---|"]
    for (scene, threads), line in itertools.groupby(rows, key=lambda row: (row["scene"], row["threads"])):
        line = list(line)
        named = {row["row"].removesuffix(ends): row for row in line}
        lines.append(f"| {scene} | {threads} | " + " | ".join(cell(named.get(name)) for name in tracers) + f" | {against(line)} |")
    return "\n".join(lines)


def cells_tables(rows):
    """Speeds by kind of ray, then what is left as in other benchmarks."""
    texts, shown = [], []
    for what in TRACED:
        kind = [row for row in rows if row["row"].endswith(", " + what)]
        if kind:
            texts.append(traced_table(what, kind))
            shown += kind
    spreads = sorted(row["spread"] for row in rows if row["spread"] is not None)
    if spreads:
        texts.append(f"Between the rounds of the run the ratios differ by {100 * spreads[len(spreads) // 2]:.0f} % (median of the "
                     f"rows), at most by {100 * spreads[-1]:.0f} %.")
    return "\n\n".join(texts + ["### Agreement and growth", table([row for row in rows if row not in shown])])


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
        rows = list(rows)
        print({"convexify": convexify_tables, "cells": cells_tables}.get(bench, table)(rows))


if __name__ == "__main__":
    main()
