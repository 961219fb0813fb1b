#!/usr/bin/python3
"""plot_dial.py ROWS.json PICTURE.svg: what each value of an option costs and errs, from `enfilade bench dial`."""
import json
import re
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "enfilade"  # the same rows give the same file
from matplotlib import pyplot  # noqa: E402

ROW = re.compile(r"(snap_mm|sagitta_mm) ([0-9.e+-]+): (.+)")
TITLES = {"snap_mm": "snap grid (mm)", "sagitta_mm": "sagitta of curves (mm)"}
CURVES = [("distance, median", "median"), ("distance, 99 of 100", "99 of 100 below")]


def curves(rows):
    """option -> quantity -> sorted [(value of the option, measured)]"""
    found = {}
    for row in rows:
        match = ROW.fullmatch(row["row"]) if row["bench"] == "dial" else None
        if match:
            found.setdefault(match[1], {}).setdefault(match[3], []).append((float(match[2]), row["value"]))
    return {option: {name: sorted(points) for name, points in named.items()} for option, named in found.items()}


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        options = curves(json.load(file)["rows"])
    figure, axes = pyplot.subplots(3, len(options), figsize=(4.6 * len(options), 8), layout="constrained", squeeze=False)
    for (error, time, memory), (option, named) in zip(axes.T, options.items()):
        for name, legend in CURVES:
            points = [(x, y) for x, y in named[name] if y > 1e-6]
            if points:
                error.loglog(*zip(*points), "o-", label=legend)
        error.set(title=TITLES[option], ylabel="error of the distance (mm)")
        error.legend()
        time.semilogx([x for x, _ in named["time"]], [y * 1000 for _, y in named["time"]], "o-")
        time.set(ylabel="plan to scene (ms)", ylim=(0, None))
        memory.semilogx(*zip(*named["memory"]), "o-")
        memory.set(xlabel=TITLES[option], ylabel="scene (MB)", ylim=(0, None))
        for panel in (error, time, memory):
            panel.grid(True, which="both", alpha=0.3)
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
