#!/usr/bin/python3
"""plot_growth.py ROWS.json PICTURE.svg: seconds and memory of `enfilade bench build` over the number of rooms."""
import json
import math
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "enfilade"  # the same rows give the same file
from matplotlib import pyplot  # noqa: E402


def points(rows, name):
    chosen = [row for row in rows if row["bench"] == "build" and row["row"] == name]
    return sorted((int(row["scene"].split()[0]), row["value"]) for row in chosen)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = json.load(file)["rows"]
    seconds = points(rows, "plan to scene")
    memory = points(rows, "peak memory of the program")
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    left.loglog(*zip(*seconds), "o-", label="measured")
    first, start = seconds[0]
    left.loglog([n for n, _ in seconds], [start * n * math.log(n) / (first * math.log(first)) for n, _ in seconds], "--", label="n log n")
    left.set(xlabel="rooms", ylabel="seconds, one core", title="Plan to scene")
    left.legend()
    right.semilogx(*zip(*memory), "o-")
    right.set(xlabel="rooms", ylabel="GB", ylim=(0, None), title="Peak memory of the program")
    for axes in (left, right):
        axes.grid(True, which="both", alpha=0.3)
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
