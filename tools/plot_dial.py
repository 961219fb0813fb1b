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
CURVES = [("distance, median", "median error of the distance"), ("distance, 99 of 100", "99 of 100 below")]


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
    figure, axes = pyplot.subplots(2, len(options), figsize=(4.6 * len(options), 6), layout="constrained", squeeze=False)
    for (upper, lower), (option, named) in zip(axes.T, options.items()):
        for name, legend in CURVES:
            points = [(x, y) for x, y in named[name] if y > 0]
            if points:
                upper.loglog(*zip(*points), "o-", label=legend)
        upper.set(title=TITLES[option], ylabel="mm")
        upper.legend()
        lower.semilogx(*zip(*named["time"]), "o-", label="time (s)")
        lower.semilogx(*zip(*named["memory"]), "s-", label="scene (MB)")
        lower.set(xlabel=TITLES[option], ylim=(0, None))
        lower.legend()
        for panel in (upper, lower):
            panel.grid(True, which="both", alpha=0.3)
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
