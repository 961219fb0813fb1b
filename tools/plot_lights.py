#!/usr/bin/python3
"""plot_lights.py ROWS.json PICTURE.svg: walks, lists and trees; against Embree; and speed over lamps, from `enfilade bench lights`."""
import json
import re
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "enfilade"  # the same rows give the same file
from matplotlib import pyplot  # noqa: E402

SEARCHES = {"scalar naive, lit pictures": "all lamps", "scalar pvs, lit pictures": "lamps of lists", "scalar tree, lit pictures": "light trees"}
RIVALS = {"simd tree, shadow rays and shading": "16 points at once", "packet tree, shadow rays and shading": "tiles by their corners"}
COUNT = re.compile(r"(\d+) lamps: (scalar|packet) tree")


def draw_grouped(panel, rows, names, quantity, title, label):
    """Bars side by side for each scene, on a scale of powers of ten."""
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    width = 0.8 / len(names)
    for k, (name, legend) in enumerate(names.items()):
        values = {row["scene"]: quantity(row) for row in rows if row["row"] == name}
        bars = panel.bar([place + (k - (len(names) - 1) / 2) * width for place in range(len(scenes))],
                         [values.get(scene, 0) for scene in scenes], width=width, label=legend)
        heights = [bar.get_height() for bar in bars]
        panel.bar_label(bars, [f"{value:.0f}" if value >= 100 else f"{value:.2g}" if value else "" for value in heights], fontsize=7)
    panel.set_xticks(range(len(scenes)), [scene.replace(", ", ",\n") for scene in scenes], fontsize=8)
    panel.set_yscale("log")
    lowest = min(quantity(row) for row in rows if row["row"] in names)
    panel.set_ylim(min(1, lowest / 2), panel.get_ylim()[1] * 4)
    panel.set(title=title, ylabel=label)
    panel.legend(fontsize=8, loc="upper right", ncols=len(names))
    panel.grid(True, axis="y", alpha=0.3)


def draw_counts(panel, rows):
    for tracer, style in (("packet", "o-"), ("scalar", "s-")):
        points = sorted((int(match[1]), row["value"]) for row in rows
                        if (match := COUNT.fullmatch(row["row"])) and match[2] == tracer)
        if points:
            panel.loglog(*zip(*points), style, label=f"{tracer} tree")
    panel.set(title="lamps on one floor", xlabel="lamps", ylabel="primary and shadow rays (Mrays/s)")
    panel.legend(fontsize=8)
    panel.grid(True, which="both", alpha=0.3)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = [row for row in json.load(file)["rows"] if row["bench"] == "lights"]
    searched = [row for row in rows if row["row"] in SEARCHES and row["unit"].startswith("pictures/s")]
    against = [row for row in rows if row["row"] in RIVALS]
    if not searched or not against:
        sys.exit(f"{sys.argv[1]} has no rows of lit pictures: run enfilade bench lights.")
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(15, 4.4), layout="constrained", width_ratios=(5, 5, 3))
    draw_grouped(left, searched, SEARCHES, lambda row: row["value"], "the same tracer, ray by ray", searched[0]["unit"].replace("^2", "²"))
    draw_grouped(middle, against, RIVALS, lambda row: row["ratio"], "shadow rays and shading, against Embree",
                 "times Embree's best, same lists")
    draw_counts(right, rows)
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
