#!/usr/bin/python3
"""plot_convexify.py ROWS.json PICTURE.svg: every plan under every way to cut rooms, from `enfilade bench convexify`."""
import json
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "enfilade"  # the same rows give the same file
from matplotlib import pyplot  # noqa: E402

MARKS = {"sah": ("o", "tab:blue"), "hertel-mehlhorn": ("s", "tab:orange"), "diagonals": ("x", "tab:green")}
PANELS = [
    ("cells a room", "cells a room", "log"),
    ("sections a cell", "sections a cell", "linear"),
    ("SAH sum", "SAH sum (visits)", "linear"),
    ("virtual portals", "virtual portals (m2)", "log"),
    ("bytes a cell", "bytes a cell", "linear"),
    ("cut", "cutting (ms)", "log"),
    ("random rays", "random rays (Mrays/s)", "linear"),
    ("primary rays and Lambert", "primary rays (Mrays/s)", "linear"),
]


def measured(rows):
    """quantity -> way -> plan -> value, and the plans in order"""
    found, plans = {}, []
    for row in rows:
        way, separator, quantity = row["row"].partition(": ")
        if row["bench"] != "convexify" or way not in MARKS or not separator:
            continue
        found.setdefault(quantity, {}).setdefault(way, {})[row["scene"]] = row["value"]
        if quantity == "sections a cell" and row["scene"] not in plans:
            plans.append(row["scene"])
    return found, plans


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        found, plans = measured(json.load(file)["rows"])
    figure, axes = pyplot.subplots(2, 4, figsize=(15, 2.5 + 0.36 * len(plans)), layout="constrained", sharey=True)
    for panel, (quantity, title, scale) in zip(axes.flat, PANELS):
        for way, (marker, colour) in MARKS.items():
            values = found.get(quantity, {}).get(way, {})
            points = [(values[plan], k) for k, plan in enumerate(plans) if values.get(plan, 0) > 0]
            if points:
                panel.plot(*zip(*points), marker, color=colour, label=way, markersize=5, alpha=0.8)
        panel.set(title=title, xscale=scale)
        panel.set_yticks(range(len(plans)), [plan[:34] for plan in plans], fontsize=7)
        panel.grid(True, alpha=0.3)
        if scale == "linear":
            panel.set_xlim(0, None)
    axes[0, 0].invert_yaxis()
    axes[0, 0].legend(fontsize=8)
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
