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
    "octree": "Octrees over single meshes",
    "furnished": "Tracing furnished floors",
    "lights": "Pictures lit by many lamps",
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
    "octree": "One mesh at a time, ours of the default options; the same rays in the same run, in turn, on one thread. Mrays/s, in "
              "brackets how many times faster than Embree: rtcIntersect1 for one ray, rtcOccluded1 for any hit, rtcIntersect16 for "
              "16, always through the faster of its trees of medium and of highest quality. *Coherent* rays are those of eight views, "
              "in tiles of 4 x 4; *incoherent* ones leave what the views see as light leaves a white surface, or are chords of the "
              "sphere about the mesh, in random order. *Wrong* counts answers that a judge in double refuses, of those that "
              "Embree answers otherwise and of some at random; 16 and any hit are compared with one ray bit by bit. **!**: below "
              "the goal (one ray 1.3 coherent and 0.7 incoherent, 16 coherent 0.6, 120 B and 2.5 references a triangle).",
    "furnished": "Floors furnished by our own rules with our own pieces at detail 4; one thread; the same rays in the same run. Embree "
                 "holds each mesh as a scene of its own and each object as an instance beside the faces, at its highest quality; "
                 "*16, coherent* is what ratios of pictures are against, of triangles or quads, whichever is faster. The faces as an "
                 "instance, too, and all triangles in one structure are slower. Its shadow rays are never said to be coherent: with "
                 "instances Embree 3.13 may then never return.",
    "lights": "![Walks, lists and trees, and speed over the number of lamps](lights.svg)\n\nThe paper's three floors with their 8, 55 and "
              "200 lamps, and 2,500 lamps around the last one; one thread but for building lists and trees. A shadow ray is a pair of a "
              "pixel and a lamp that its cell may see (its list), whether or not the pixel faces it; naive walks ask for every lamp. "
              "In brackets: how many times faster than Embree at its best of 24 ways to ask (1, 8 or 16 rays, coherent or not, from lamps "
              "or from places, triangles or quads), which is given the same lists, the cell of each pixel for nothing, and the same "
              "light in lanes; *shadow rays and shading* is a lit picture less the same picture without lamps, against Embree from "
              "first hits that it is given for nothing. *Lit pictures* by lists and by trees in pictures/s are against the row above; *primary and shadow "
              "rays* against the same tracer without lamps. **!**: below the goal.",
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


OCTREE_COLUMNS = {"build": "build, s", "leaves": "leaves", "leaves, balanced": "balanced", "depth": "levels",
                  "references": "references a triangle", "structure": "B a triangle", "one ray, coherent": "one, coherent",
                  "one ray, incoherent": "one, incoherent", "any hit, incoherent": "any hit, incoherent",
                  "16 rays, coherent": "16, coherent", "16 rays, incoherent": "16, incoherent",
                  "other answers than Embree's": "unlike Embree, ppm",
                  "16 and any hit: other answers than one ray": "unlike one ray", "wrong": "wrong"}
STUDY_COLUMNS = {"build": "build, s", "structure": "B a triangle", "one ray, incoherent": "one, incoherent",
                 "16 rays, coherent": "16, coherent", "other answers than the default's": "other answers, ppm"}
OCTREE_NOTES = {
    "paper": "### The paper's tables 1 and 3\n\nIts octrees over our meshes, as deep as it says, split by count alone. It has 69k "
             "leaves free and 83k balanced (120 %) for the bunny, 855k and 1144k (133 %) for the dragon, 123 % for an armadillo of "
             "346k triangles that is not at hand; 6 triangles and 7 neighbours a leaf; 268 B a triangle for the bunny (1.5 MB of "
             "cube map, 3.6 of octree, 12.2 of triangles, 1.3 of boxes), 285 for the dragon.",
    "exits": "### Wrong exits\n\nBy the signs of single edges, of a million crossings of leaves: *wrong* faces, and *invalid* signs "
             "(the paper's 7), by depth and by the mesh's distance from the origin in its own sizes; and what walks make of them: "
             "*came back* to a leaf behind; *unrecovered* walks pass over a place of the ray, where a triangle might be missed.",
    "limit": "### The limit\n\nOne ray at a time. *Time* is that of a long stream, whose leaves come from wherever they lie; *in caches* "
             "that of 32 rays asked again and again in random order; *branches known* that of one ray again and again. What lies "
             "between the first two is waiting for memory: the paper's question what a walk costs without. Instructions are counted "
             "one by one on some of the rays.",
    "study": "### Depth and leaf size\n\n![Depth and leaf size against time, memory and answers](octree.svg)\n\nMrays/s, in brackets how "
             "many times faster than the default, which stops by what a walk is expected to cost.",
}


def pivoted(rows, heads, split):
    """A line for each (scene, line) and a column for each quantity: split(row text) -> (line, quantity)."""
    found = {}
    for row in rows:
        line, quantity = split(row["row"])
        found.setdefault((row["scene"], line), {})[quantity] = row
    columns = list(dict.fromkeys(quantity for line in found.values() for quantity in line))
    units = {quantity: row["unit"] for line in found.values() for quantity, row in line.items()}
    titles = heads or {quantity: quantity if units[quantity] in quantity.replace(",", "").split() else f"{quantity}, {units[quantity]}" for quantity in columns}
    used = [quantity for quantity in titles if quantity in columns]
    has_line = any(line for _, line in found)
    lines = ["| on | " + ("what | " if has_line else "") + " | ".join(titles[quantity] for quantity in used) + " |",
             "|---|" + ("---|" if has_line else "") + "--:|" * len(used)]
    for (scene, line), quantities in found.items():
        lines.append(f"| {scene} | " + (f"{line} | " if has_line else "") +
                     " | ".join(cell(quantities.get(quantity)) for quantity in used) + " |")
    return "\n".join(lines)


def octree_part(row):
    for part in ("paper", "exits", "limit"):
        if row["row"].startswith(part):
            return part
    is_studied = row["row"].startswith(("default: ", "depth ", "leaf size "))
    return "study" if is_studied and ":" in row["row"] else ""


def octree_tables(rows):
    """Meshes by question, the paper's tables, the limit, depth and leaf size."""
    parts = {}
    for row in rows:
        parts.setdefault(octree_part(row), []).append(row)
    texts = []
    if "" in parts:
        texts.append(pivoted(parts[""], OCTREE_COLUMNS, lambda name: ("", "wrong" if name.startswith("wrong") else name)))
    sums = [row for row in parts.get("exits", []) if row["row"].startswith("exits: ")]
    if sums:
        parts["exits"] = [row for row in parts["exits"] if row not in sums]
    if "paper" in parts:
        texts += [OCTREE_NOTES["paper"], pivoted(parts["paper"], {}, lambda name: ("", name.partition(": ")[2]))]
    for part in ("exits", "limit"):
        if part in parts:
            texts.append(OCTREE_NOTES[part])
        # What is asked of a scene alone makes a table of its own: others have other columns.
        by_kind = {}
        for row in parts.get(part, []):
            by_kind.setdefault(row["scene"].partition(",")[0] if part == "exits" else "", []).append(row)
        texts += [pivoted(kind, {}, lambda name: (name.partition(": ")[0].partition(", ")[2], name.partition(": ")[2]))
                  for kind in by_kind.values()]
    if sums:
        texts.append(table(sums))
    if "study" in parts:
        told = [row for row in parts["study"] if row["row"].partition(": ")[2] in STUDY_COLUMNS]
        left = [row for row in parts["study"] if row not in told]
        texts += [OCTREE_NOTES["study"], pivoted(told, STUDY_COLUMNS, lambda name: name.partition(": ")[::2]),
                  "Where the default ends, and what its leaves hold:", pivoted(left, {}, lambda name: ("", name))]
    return "\n\n".join(texts)


def lights_tables(rows):
    """A line for each quantity and a column for each scene; growth and the number of lamps apart."""
    def part(row):
        return "growth" if row["row"].startswith("growth: ") else "counts" if " lamps: " in row["row"] else ""

    def tabled(chosen, title):
        scenes = list(dict.fromkeys(row["scene"] for row in chosen))
        found = {}
        for row in chosen:
            unit = "" if row["unit"].startswith("of ") else f", {row['unit']}"
            goal = f" (goal {row['goal']})" if row["goal"] else ""
            line = found.setdefault((title(row), unit), {"goal": ""})
            line["goal"] = line["goal"] or goal
            line[row["scene"]] = row
        lines = ["| what | " + " | ".join(scenes) + " |", "|---|" + "--:|" * len(scenes)]
        lines += [f"| {name}{unit}{line['goal']} | " + " | ".join(cell(line.get(scene)) for scene in scenes) + " |"
                  for (name, unit), line in found.items()]
        return "\n".join(lines)

    parts = {}
    for row in rows:
        parts.setdefault(part(row), []).append(row)
    texts = [tabled(parts.get("", []), lambda row: row["row"])]
    if "counts" in parts:
        texts += ["### More and more lamps on one floor (the paper's figure 13)",
                  tabled(parts["counts"], lambda row: row["row"].partition(": ")[2])]
    if "growth" in parts:
        texts += ["### Lists and trees of larger and larger floors", tabled(parts["growth"], lambda row: row["row"].partition(": ")[2])]
    return "\n\n".join(texts)


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
        print({"convexify": convexify_tables, "cells": cells_tables, "octree": octree_tables, "lights": lights_tables}.get(bench, table)(rows))


if __name__ == "__main__":
    main()
