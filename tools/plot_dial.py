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
NAMED_ROW = re.compile(r"(convexify|real|tracer|detail|object-triangles|objects|object-accel|scope|octree-[a-z]+|lights|light-[a-z-]+|samples|path-[a-z]+|device-[a-z]+) (\S+): (.+)")
PACKET_ROW = re.compile(r"packet (\d+) to (\d+): speed")
TITLES = {"snap_mm": "snap grid (mm)", "sagitta_mm": "sagitta of curves (mm)"}
# What furniture's options cost: their first panel's quantity, its label, and the panel's title.
FURNITURE = {
    "detail": ("other pixels", "unlike detail 4 (per million)", "detail of own pieces"),
    "object-triangles": ("surface moved at most", "surface moved (mm)", "triangles a mesh"),
    "objects": ("speed", "pictures (Mrays/s)", "how cells know objects"),
    "object-accel": ("speed", "pictures (Mrays/s)", "inside objects"),
    "scope": ("rooms", "rooms furnished", "what is furnished"),
}
# Options of octrees, on one mesh: their panels stand below the others.
OCTREES = {
    "octree-depth": "levels at most",
    "octree-leaf": "triangles of leaves that are not split",
    "octree-balance": "2:1 between neighbours",
    "octree-layout": "what rays walk",
    "octree-real": "the paper's walk",
}
# Options of light, on one picture: beside those of octrees.
LIGHTS = {
    "lights": "which lamps are walked to",
    "light-real": "light trees in",
    "light-clusters": "lamps that stand for others",
    "light-clusters-pvs": "lamps that stand for others, walks",
    "samples": "samples a pixel",
    "path-samples": "samples of paths a pixel",
    "path-lamps": "lamps asked at each place of a path",
}
# Options of the cuda tracer, where a card measured them: beside those of light.
DEVICES = {
    "device-order": "which thread draws which pixel",
    "device-work": "how warps share the work",
    "device-start": "how a frame is started",
    "device-shape": "threads of a block, registers",
    "device-packets": "tiles by corner rays",
    "device-inside": "inside objects",
    "device-real": "a card walks in",
}
CURVES = [("distance, median", "median"), ("distance, 99 of 100", "99 of 100 below")]


def curves(rows):
    """option -> quantity -> sorted [(value of the option, measured)]"""
    found = {}
    for row in rows:
        match = ROW.fullmatch(row["row"]) if row["bench"] == "dial" else None
        if match:
            found.setdefault(match[1], {}).setdefault(match[3], []).append((float(match[2]), row["value"]))
    return {option: {name: sorted(points) for name, points in named.items()} for option, named in found.items()}


def bars(rows):
    """option -> quantity -> value of the option -> measured (on the last scene), for options that are chosen by name"""
    found = {}
    for row in rows:
        match = NAMED_ROW.fullmatch(row["row"]) if row["bench"] == "dial" else None
        if match:
            found.setdefault(match[1], {}).setdefault(match[3], {})[match[2]] = row["value"]
    return found


def packets(rows):
    """smallest packet -> sorted [(largest packet, Mrays/s)]"""
    found = {}
    for row in rows:
        match = PACKET_ROW.fullmatch(row["row"]) if row["bench"] == "dial" else None
        if match:
            found.setdefault(int(match[2]), []).append((int(match[1]), row["value"]))
    return {smallest: sorted(points) for smallest, points in found.items()}


def draw_bars(panel, named, label, scale=1):
    panel.bar([name.replace("-", "-\n") for name in named], [value * scale for value in named.values()], width=0.6)
    panel.set(ylabel=label, ylim=(0, None))
    panel.grid(True, axis="y", alpha=0.3)


def draw_tracing(panels, named_bars, sizes):
    """Who traces, in which precision, by packets of which sizes: these change no scene."""
    real, tracer, packet = panels
    if "real" in named_bars:
        draw_bars(real, named_bars["real"]["speed"], "random rays, scalar (Mrays/s)")
        errors = named_bars["real"]["largest error of the distance"]
        for place, error in enumerate(errors.values()):
            real.annotate(f"{error:.1g} mm", (place, 0), ha="center", va="bottom", color="white")
        real.set(title="how rays are traced")
    if "tracer" in named_bars:
        draw_bars(tracer, named_bars["tracer"]["speed"], "pictures (Mrays/s)")
    for smallest, points in sorted(sizes.items()):
        packet.semilogx(*zip(*points), "o-", base=2, label=f"smallest {smallest}")
    if sizes:
        packet.set(xlabel="largest packet (pixels a side)", ylabel="pictures by packets (Mrays/s)", ylim=(0, None))
        values = sorted({largest for points in sizes.values() for largest, _ in points})
        packet.set_xticks(values, [str(value) for value in values])
        packet.legend()
        packet.grid(True, which="both", alpha=0.3)


def draw_furniture(axes, named_bars):
    """A column of panels for each option of furniture: what it errs or gains, time and memory."""
    found = [option for option in FURNITURE if option in named_bars]
    for (first, time, memory), option in zip(axes.T, found):
        quantity, label, title = FURNITURE[option]
        draw_bars(first, named_bars[option][quantity], label)
        first.set(title=title)
        has_structure_only = option == "object-accel"
        draw_bars(time, named_bars[option]["time"], "structure (ms)" if has_structure_only else "to scene (ms)", 1000)
        draw_bars(memory, named_bars[option]["memory"], "structure (MB)" if has_structure_only else "scene (MB)")


def draw_octrees(axes, named_bars):
    """A column of panels for each option of octrees: speed of both kinds of ray, building, memory; answers in the title."""
    for (speed, time, memory), option in zip(axes.T, [option for option in OCTREES if option in named_bars]):
        named = named_bars[option]
        places = range(len(named["speed"]))
        for shift, quantity, legend in ((-0.2, "speed", "one, incoherent"), (0.2, "speed, 16 coherent", "16, coherent")):
            speed.bar([place + shift for place in places], named[quantity].values(), width=0.4, label=legend)
        speed.set_xticks(places, [name.replace("automatic", "auto") for name in named["speed"]])
        others = sum(named["other answers"].values())
        speed.set(title=f"octrees: {OCTREES[option]}", ylabel="rays (Mrays/s)", xlabel=f"other answers: {others:.3g} per million")
        speed.set_ylim(0, 1.35 * max(*named["speed"].values(), *named["speed, 16 coherent"].values()))
        speed.legend(fontsize=8, loc="upper right", ncols=2)
        speed.grid(True, axis="y", alpha=0.3)
        draw_bars(time, {name.replace("automatic", "auto"): value for name, value in named["time"].items()}, "structure (ms)", 1000)
        draw_bars(memory, {name.replace("automatic", "auto"): value for name, value in named["memory"].items()}, "structure (MB)")


def draw_lights(axes, named_bars):
    """A column of panels for each option of light: error of the picture, time, and memory where the option has any."""
    for (error, time, memory), option in zip(axes.T, [option for option in LIGHTS if option in named_bars]):
        named = named_bars[option]
        places = range(len(named["time"]))
        for shift, quantity, legend in ((-0.2, "error, mean", "mean"), (0.2, "error, 999 of 1000", "999 of 1000 below")):
            error.bar([place + shift for place in places], named[quantity].values(), width=0.4, label=legend)
        error.set_xticks(places, list(named["time"]))
        error.set(title=f"light: {LIGHTS[option]}", ylabel="error of the picture (of white)")
        error.set_ylim(0, max(1e-6, 1.3 * max(*named["error, mean"].values(), *named["error, 999 of 1000"].values())))
        error.legend(fontsize=8, loc="upper right", ncols=2)
        error.grid(True, axis="y", alpha=0.3)
        draw_bars(time, named["time"], "picture (ms)", 1000)
        if any(named["memory"].values()):
            draw_bars(memory, named["memory"], "lists and trees (MB)")


def draw_devices(axes, named_bars, options):
    """A column of panels for each option of the cuda tracer: unlike pixels, time, memory."""
    for (error, time, memory), option in zip(axes.T, options):
        named = named_bars[option]
        draw_bars(error, named["pixels unlike the scalar ones"], "unlike the scalar tracer's (per million)")
        error.set(title=f"cuda: {DEVICES[option]}")
        draw_bars(time, named["time"], "picture (ms)", 1000)
        draw_bars(memory, named["memory"], "on the card (MB)")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = json.load(file)["rows"]
    options, named_bars, sizes = curves(rows), bars(rows), packets(rows)
    ways = named_bars.get("convexify")
    tracing = {"real", "tracer"} & set(named_bars) or sizes
    furniture = sum(option in named_bars for option in FURNITURE)
    columns = len(options) + bool(ways) + bool(tracing) + furniture
    octrees = sum(option in named_bars for option in OCTREES)
    lights = sum(option in named_bars for option in LIGHTS)
    devices = [option for option in DEVICES if "time" in named_bars.get(option, {})]
    columns = max(columns, octrees + lights + len(devices))
    lines = 6 if octrees or lights or devices else 3
    figure, all_axes = pyplot.subplots(lines, columns, figsize=(4.6 * columns, 2.7 * lines), layout="constrained", squeeze=False)
    axes = all_axes[:3]
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
    if ways:
        speed, time, memory = axes[:, len(options)]
        draw_bars(speed, ways["speed"], "random rays (Mrays/s)")
        speed.set(title="how rooms are cut")
        draw_bars(time, ways["time"], "plan to scene (ms)", 1000)
        draw_bars(memory, ways["memory"], "scene (MB)")
    if tracing:
        draw_tracing(axes[:, len(options) + bool(ways)], named_bars, sizes)
    if furniture:
        draw_furniture(axes[:, len(options) + bool(ways) + bool(tracing):], named_bars)
    if octrees:
        draw_octrees(all_axes[3:, :octrees], named_bars)
    if lights:
        draw_lights(all_axes[3:, octrees:octrees + lights], named_bars)
    if devices:
        draw_devices(all_axes[3:, octrees + lights:], named_bars, devices)
    for panel in all_axes.flat:
        panel.set_visible(panel.has_data())
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
