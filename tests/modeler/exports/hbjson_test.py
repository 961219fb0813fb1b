#!/usr/bin/python3
"""hbjson_test.py WRITE_EXPORTS FOLDER PLAN...: Honeybee models are closed, paired and complete.

What honeybee-core checks of a model (closed rooms, planar faces, sub-faces inside of their faces, mutual adjacencies of
equal area, air boundaries that are paired, no zero areas), and volumes against the model.
"""
import json
import pathlib
import re
import subprocess
import sys
from collections import Counter

import numpy

WRITER, FOLDER, PLANS = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
TOLERANCE = 0.01  # metres, Honeybee's default


def newell(points):
    return numpy.cross(points, numpy.roll(points, -1, axis=0)).sum(axis=0) / 2


def vector_area(geometry):
    """Of a Face3D, holes taken out; its plane is checked."""
    outer = numpy.array(geometry["boundary"])
    area = newell(outer - outer[0])
    normal = area / numpy.linalg.norm(area)
    for hole in geometry.get("holes", []):
        ring = numpy.array(hole) - outer[0]
        assert newell(ring) @ normal < 0, "a hole runs the wrong way"
        area = area + newell(ring)
        assert numpy.abs(ring @ normal).max() < TOLERANCE
    assert numpy.abs((outer - outer[0]) @ normal).max() < TOLERANCE, "a face is not flat"
    return outer[0], area


def inside(child, face):
    """Whether a rectangle lies in a rectangle of the same plane."""
    a, b = numpy.array(child["boundary"]), numpy.array(face["boundary"])
    normal = newell(b - b[0])
    normal /= numpy.linalg.norm(normal)
    flat = numpy.abs((a - b[0]) @ normal).max() < TOLERANCE
    return flat and (a.min(axis=0) >= b.min(axis=0) - 1e-5).all() and (a.max(axis=0) <= b.max(axis=0) + 1e-5).all() \
        and newell(a - a[0]) @ normal > 0


def check(model, facts):
    assert model["type"] == "Model" and model["units"] == "Meters"
    owner, things, kinds = {}, {}, Counter()
    for room in model["rooms"]:
        for face in room["faces"]:
            for thing in [face, *face.get("doors", []), *face.get("apertures", [])]:
                assert re.fullmatch(r"[.A-Za-z0-9_-]{1,100}", thing["identifier"]) and thing["identifier"] not in things
                things[thing["identifier"]] = thing
                owner[thing["identifier"]] = [face["identifier"], room["identifier"]]
    assert len({room["identifier"] for room in model["rooms"]}) == len(model["rooms"])
    volumes = 0.0
    for room in model["rooms"]:
        total, volume, perimeter = numpy.zeros(3), 0.0, 0.0
        for face in room["faces"]:
            point, area = vector_area(face["geometry"])
            total, volume = total + area, volume + float(point @ area) / 3
            size = numpy.linalg.norm(area)
            perimeter += size
            assert size > 1e-6, "a face without area"
            kinds[face["boundary_condition"]["type"]] += 1
            z = area[2] / size
            assert face["face_type"] in ("AirBoundary", "Wall" if abs(z) < 0.5 else "Floor" if z < 0 else "RoofCeiling")
            if face["face_type"] == "AirBoundary":
                assert face["boundary_condition"]["type"] == "Surface", "an air boundary that is not paired"
            children = [*face.get("doors", []), *face.get("apertures", [])]
            for child in children:
                assert inside(child["geometry"], face["geometry"]), f"{child['identifier']} is not inside of its face"
                assert child["boundary_condition"]["type"] == face["boundary_condition"]["type"]
            assert sum(numpy.linalg.norm(vector_area(c["geometry"])[1]) for c in children) < size
        # Closed: all outward areas cancel. What is missing is under a square centimetre a face.
        assert numpy.linalg.norm(total) < 2e-3 * perimeter, f"{room['identifier']} is open: {total}"
        assert volume > 0, f"{room['identifier']} is turned inside out"
        volumes += volume
    expected = sum(s["volume"] for s in facts["spaces"] if s["label"] in ("room", "stair", "shaft"))
    assert abs(volumes - expected) < 2e-3 * expected, f"{volumes} m3 of {expected}"
    for identifier, thing in things.items():
        condition = thing["boundary_condition"]
        if condition["type"] != "Surface":
            continue
        other = things[condition["boundary_condition_objects"][0]]
        is_face = thing["type"] == "Face"
        owners = owner[other["identifier"]]
        assert condition["boundary_condition_objects"][1:] == (owners[1:] if is_face else owners), identifier
        assert other["boundary_condition"]["boundary_condition_objects"][0] == identifier, f"{identifier} is not mutual"
        assert other["type"] == thing["type"] and owners[1] != owner[identifier][1]
        (point, area), (other_point, other_area) = vector_area(thing["geometry"]), vector_area(other["geometry"])
        size, other_size = numpy.linalg.norm(area), numpy.linalg.norm(other_area)
        assert abs(size - other_size) <= size ** 0.5 * TOLERANCE, f"{identifier}: {size} and {other_size} m2"
        assert area @ other_area / size / other_size < -0.98, f"{identifier} does not face {other['identifier']}"
        gap = abs((other_point - point) @ area / size)
        assert gap < 1.6, f"{identifier} is {gap} m from {other['identifier']}"
        assert (other_point - point) @ area > -1e-3 * size, f"{identifier} looks away from {other['identifier']}"
    return len(model["rooms"]), dict(kinds)


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for plan in PLANS:
        if "/" in plan and not pathlib.Path(plan).exists():
            print(f"skipped: {plan} is not on this machine")
            sys.exit(77)
        stem = str(FOLDER / pathlib.Path(plan).stem)
        subprocess.run([WRITER, plan, stem], check=True)
        with open(stem + ".hbjson", encoding="utf-8") as model, open(stem + ".facts.json", encoding="utf-8") as facts:
            rooms, kinds = check(json.load(model), json.load(facts))
        print(f"{plan}: {rooms} rooms, faces: {kinds}")


if __name__ == "__main__":
    main()
