#!/usr/bin/env python3
"""Asks `enfilade trace` about rays, with numpy: the executable part of docs/queries.md.

    python3 docs/trace_rays.py ENFILADE SCENE.enf

As a module: `nearest`, `blocked` and `passages` take arrays and give arrays. Numbers are metres of the plan."""

import os
import subprocess
import sys
import tempfile

import numpy as np

from read_scene import LABELS, read_scene, text

NONE = 2**32 - 1
HIT, SKY, REACHED, WALL, REFUSED, LEAK = range(6)  # status of `--query nearest`
FREE, BLOCKED = range(2)  # of `--query any`, then 2: starts in a wall, 3: refused, 4: leak
CLEAR, VIRTUAL, GLASS, FACE, INSIDE, END = range(6)  # borders of passages
SURFACES = ["wall paper", "floor", "ceiling", "facade", "jamb", "sill", "lintel", "leaf", "pane", "terrain", "roof",
            "sky"]


def trace(enfilade, scene, rays, query, *flags):
    """The arrays that `enfilade trace` writes: one, or passages and offsets."""
    with tempfile.TemporaryDirectory() as folder:
        rays_file, out = os.path.join(folder, "rays.npy"), os.path.join(folder, "out.npy")
        np.save(rays_file, np.ascontiguousarray(rays))
        subprocess.run([enfilade, "trace", scene, rays_file, "-o", out, "--query", query, "--quiet", *flags], check=True)
        if query == "all":
            return np.load(out), np.load(os.path.join(folder, "out.offsets.npy"))
        return np.load(out)


def segments(starts, ends):
    """Rays from points to points: (n, 7)."""
    way = np.asarray(ends, float) - starts
    return np.hstack([starts, way, np.linalg.norm(way, axis=1, keepdims=True)])


def nearest(enfilade, scene, rays, *flags):
    """One record a ray: distance, normal, face, cell, space, material, object, triangle, surface, label, status."""
    return trace(enfilade, scene, rays, "nearest", *flags)


def blocked(enfilade, scene, starts, ends):
    """Whether something opaque stands between points; one that lies in a wall is blocked."""
    return trace(enfilade, scene, segments(starts, ends), "any") != FREE


def passages(enfilade, scene, rays, *flags):
    """Everything the rays pass: records, and offsets of length n + 1 into them."""
    return trace(enfilade, scene, rays, "all", *flags)


def sum_per_ray(values, offsets):
    """Sums of a column of passages, ray by ray; 0 where a ray has none."""
    sums = np.concatenate([[0], np.cumsum(values)])
    return sums[offsets[1:]] - sums[offsets[:-1]]


def loss_db(enfilade, scene, starts, ends, db_per_metre):
    """What solids take from straight links, by a table of decibels a metre by label."""
    rows, offsets = passages(enfilade, scene, segments(starts, ends))
    rates = np.array([db_per_metre.get(label, 0) for label in LABELS], float)
    solid = rows["cell"] == NONE
    return sum_per_ray(np.where(solid, rates[rows["label"]] * (rows["leave"] - rows["enter"]), 0), offsets)


def room_points(scene):
    """A point inside the first cell of every room, and the rooms' names."""
    points, names = [], []
    for number, space in enumerate(scene["spaces"]):
        mine = np.flatnonzero(scene["cells"]["space"] == number)
        if LABELS[space["label"]] != "room" or mine.size == 0:
            continue
        cell = scene["cells"][mine[0]]
        ring = slice(cell["first_section"], cell["first_section"] + cell["section_count"])
        middle = [scene["section_x"][ring].mean(dtype=float), scene["section_y"][ring].mean(dtype=float),
                  float(cell["z_floor"]) + min(1.2, 0.5 * (float(cell["z_ceiling"]) - float(cell["z_floor"])))]
        points.append(middle + scene["origin"])
        names.append(text(scene, space["name"]) or text(scene, space["id"]))
    return np.array(points), names


def main():
    enfilade, path = sys.argv[1:3]
    scene = read_scene(path)
    points, names = room_points(scene)

    # What one sees from the first room, in ten thousand directions.
    directions = np.random.default_rng(1).normal(size=(10000, 3))
    hits = nearest(enfilade, path, np.hstack([np.tile(points[0], (10000, 1)), directions]))
    print("from %s: mean free path %.2f m, sky in %.1f %% of all directions" %
          (names[0], hits["distance"].mean(), 100 * (hits["status"] == SKY).mean()))
    if (hits["object"] != NONE).any():
        print("  %-10s %5.1f %%" % ("furniture", (hits["object"] != NONE).mean() * 100))
    for surface, count in enumerate(np.bincount(hits["surface"][(hits["status"] == HIT) & (hits["face"] != NONE)],
                                            minlength=len(SURFACES))):
        if count:
            print("  %-10s %5.1f %%" % (SURFACES[surface], count / 100))

    # Straight radio links from there to every other room.
    starts, ends = np.repeat(points[:1], len(points) - 1, axis=0), points[1:]
    losses = loss_db(enfilade, path, starts, ends, {"wall": 40, "slab": 60, "door": 100})
    rows, offsets = passages(enfilade, path, segments(starts, ends))
    walls = sum_per_ray((rows["cell"] == NONE).astype(int), offsets)
    for name, loss, count, hidden in list(zip(names[1:], losses, walls, blocked(enfilade, path, starts, ends)))[:8]:
        print("to %-20s %2d solids, %5.1f dB, %s" % (name, count, loss, "hidden" if hidden else "in sight"))


if __name__ == "__main__":
    main()
