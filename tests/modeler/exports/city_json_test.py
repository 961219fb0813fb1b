#!/usr/bin/python3
"""city_json_test.py WRITE_EXPORTS FOLDER PLAN...: CityJSON exports are sound for a reader that knows nothing of ours.

Objects and links (CityJSON 2.0, chapters 2 and 6), closed outward shells (ISO 19107), volumes against the model.
"""
import json
import pathlib
import subprocess
import sys
from collections import Counter

import numpy

WRITER, FOLDER, PLANS = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
TYPES = {"Building", "BuildingStorey", "BuildingRoom", "BuildingConstructiveElement", "BuildingInstallation"}
SURFACES = {"RoofSurface", "GroundSurface", "WallSurface", "ClosureSurface", "OuterCeilingSurface", "OuterFloorSurface",
            "Window", "Door", "InteriorWallSurface", "CeilingSurface", "FloorSurface"}


def newell(ring):
    """Twice the vector area of a ring of points."""
    return numpy.cross(ring, numpy.roll(ring, -1, axis=0)).sum(axis=0)


def check_shell(shell, points, name):
    """Each edge once each way, no repeated corner in a ring, faces flat to 1 mm; returns the volume."""
    edges = Counter()
    volume = 0.0
    middle = points[shell[0][0][0]]
    for surface in shell:
        normal = sum(newell(points[ring] - middle) for ring in surface)
        length = numpy.linalg.norm(normal)
        assert length > 1e-9, f"{name}: a surface without area"
        plane = normal / length
        for ring in surface:
            assert len(ring) >= 3 and len(set(ring)) == len(ring), f"{name}: a ring visits a corner twice: {ring}"
            assert numpy.ptp((points[ring] - middle) @ plane) < 1e-3, f"{name}: a surface is not flat"
            edges.update(zip(ring, ring[1:] + ring[:1]))
        for ring in surface[1:]:
            assert newell(points[ring] - middle) @ plane < 0, f"{name}: a hole runs the wrong way"
        volume += float((points[surface[0][0]] - middle) @ normal) / 6
    for (a, b), count in edges.items():
        assert count == 1 and edges[(b, a)] == 1, f"{name}: the shell is open or not 2-manifold at edge {a} {b}"
    return volume


def check(city, facts):
    assert city["type"] == "CityJSON" and city["version"] == "2.0"
    assert all(isinstance(c, int) for v in city["vertices"] for c in v)
    assert len({tuple(v) for v in city["vertices"]}) == len(city["vertices"]), "a vertex is there twice"
    scale, shift = numpy.array(city["transform"]["scale"]), numpy.array(city["transform"]["translate"])
    points = numpy.array(city["vertices"]) * scale + shift
    extent = city["metadata"]["geographicalExtent"]
    assert numpy.allclose(extent, [*points.min(axis=0), *points.max(axis=0)], atol=1e-12)
    objects, used = city["CityObjects"], set()
    expected = {s["id"]: s for s in facts["spaces"]}
    for key, item in objects.items():
        assert item["type"] in TYPES, item["type"]
        for child in item.get("children", []):
            assert key in objects[child]["parents"], f"{child} does not know its parent {key}"
        assert (item["type"] == "Building") == ("parents" not in item)
        for parent in item.get("parents", []):
            assert key in objects[parent]["children"], f"{parent} does not know its child {key}"
        volume = 0.0
        for geometry in item["geometry"]:
            solids = [geometry["boundaries"]] if geometry["type"] == "Solid" else geometry["boundaries"]
            values = [geometry["semantics"]["values"]] if geometry["type"] == "Solid" else geometry["semantics"]["values"]
            kinds = geometry["semantics"]["surfaces"]
            assert len(values) == len(solids)
            for kind in kinds:
                assert kind["type"] in SURFACES, kind
                assert kind.get("adjacent") is None or kind["adjacent"] in objects
            for solid, solid_values in zip(solids, values):
                assert len(solid) == len(solid_values) == 1
                assert [v is None or 0 <= v < len(kinds) for v in solid_values[0]] == [True] * len(solid[0])
                volume += check_shell(solid[0], points, key)
                used.update(corner for surface in solid[0] for ring in surface for corner in ring)
        if item["geometry"]:
            assert volume > 0, f"{key} is turned inside out"
            assert abs(volume - item["attributes"]["volume"]) < 1e-3 * volume + 1e-4, f"{key}: {volume}"
            assert abs(item["attributes"]["volume"] - expected[key]["volume"]) < 1e-9 if key in expected else True
    assert used == set(range(len(points))), "vertices that nothing uses"
    rooms = [o for o in objects.values() if o["type"] == "BuildingRoom" and o["attributes"]["class"] == "room"]
    assert len(rooms) == sum(s["label"] == "room" for s in facts["spaces"])
    return len(objects), len(points)


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for plan in PLANS:
        if "/" in plan and not pathlib.Path(plan).exists():
            print(f"skipped: {plan} is not on this machine")
            sys.exit(77)
        stem = str(FOLDER / pathlib.Path(plan).stem)
        subprocess.run([WRITER, plan, stem], check=True)
        with open(stem + ".city.json", encoding="utf-8") as city, open(stem + ".facts.json", encoding="utf-8") as facts:
            objects, points = check(json.load(city), json.load(facts))
        print(f"{plan}: {objects} objects, {points} vertices")


if __name__ == "__main__":
    main()
