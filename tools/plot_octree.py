#!/usr/bin/python3
"""plot_octree.py ROWS.json PICTURE.svg: depth and leaf size of octrees against time and memory, from `enfilade bench octree`."""
import json
import re
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "enfilade"  # the same rows give the same file
from matplotlib import pyplot  # noqa: E402

ROW = re.compile(r"(depth|leaf size) (\d+): (.+)")
DEFAULT_ROW = re.compile(r"default: (.+)")
ONE, SIXTEEN = "one ray, incoherent", "16 rays, coherent"
OTHERS = "other answers than the default's"
OPTIONS = ["depth", "leaf size"]


def studies(rows):
    """scene -> option -> quantity -> sorted [(value of the option, row)], and scene -> quantity of the default"""
    found, defaults = {}, {}
    for row in rows:
        if row["bench"] != "octree":
            continue
        match = ROW.fullmatch(row["row"])
        if match:
            found.setdefault(row["scene"], {}).setdefault(match[1], {}).setdefault(match[3], []).append((int(match[2]), row))
        match = DEFAULT_ROW.fullmatch(row["row"])
        if match:
            defaults.setdefault(row["scene"], {})[match[1]] = row["value"]
    for options in found.values():
        for quantities in options.values():
            for points in quantities.values():
                points.sort(key=lambda point: point[0])
    return found, defaults


def draw_option(panels, quantities, default, option):
    """A column of panels: time of both kinds of ray, memory, answers. The default is the dashed line, its place the star."""
    time, memory, error = panels
    place = default["depth"] if option == "depth" else None
    for name, style in ((ONE, "o-"), (SIXTEEN, "s-")):
        time.plot([x for x, _ in quantities[name]], [1 / row["ratio"] for _, row in quantities[name]], style, markersize=4, label=name)
    time.set_ylim(0, min(4, max(1.5, 1.1 * max(1 / row["ratio"] for name in (ONE, SIXTEEN) for _, row in quantities[name]))))
    memory.plot([x for x, _ in quantities["structure"]], [row["value"] for _, row in quantities["structure"]], "o-", markersize=4)
    error.plot([x for x, _ in quantities[OTHERS]], [row["value"] for _, row in quantities[OTHERS]], "o-", markersize=4)
    error.set_ylim(0, max(1, 1.1 * max(row["value"] for _, row in quantities[OTHERS])))
    for panel, value in ((time, 1), (memory, default["structure"]), (error, 0)):
        panel.axhline(value, color="black", linestyle="--", linewidth=0.8, label="default")
        if place is not None:
            panel.plot([place], [value], "k*", markersize=12, label="where the default ends")
        if option == "leaf size":
            panel.set_xscale("log", base=2)
        values = [x for x, _ in quantities["structure"]]
        panel.set_xticks(values, [str(value) for value in values])
        panel.grid(True, alpha=0.3)
    memory.set_ylim(0, 1.15 * max(default["structure"], *(row["value"] for _, row in quantities["structure"])))
    error.set_xlabel({"depth": "levels at most", "leaf size": "triangles of leaves that are not split"}[option])


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        found, defaults = studies(json.load(file)["rows"])
    pairs = [(scene, option) for option in OPTIONS for scene in found if option in found[scene]]
    if not pairs:
        sys.exit(f"{sys.argv[1]} has no rows of depth and leaf size: run enfilade bench octree.")
    columns = len(found)
    figure, axes = pyplot.subplots(6, columns, figsize=(3.3 * columns, 13), layout="constrained", squeeze=False)
    for scene, option in pairs:
        first = 3 * OPTIONS.index(option)
        column = list(found).index(scene)
        draw_option(axes[first:first + 3, column], found[scene][option], defaults[scene], option)
        axes[first, column].set_title(scene)
    for first in (0, 3):
        for row, label in enumerate(("time, of the default's", "structure (B a triangle)", "other answers (per million)")):
            axes[first + row, 0].set_ylabel(label)
        axes[first, 0].legend(fontsize=7)
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
