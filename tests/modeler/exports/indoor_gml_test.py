#!/usr/bin/python3
"""indoor_gml_test.py WRITE_EXPORTS FOLDER PLAN...: IndoorGML exports hold what the standard asks for.

The content models of OGC 19-011r4 and GML 3.2.1 for the elements in use, links, closed cells that do not overlap, and
what val3dity checks of a dual graph (701 overlap, 702 states inside their cells, 703 links, 704 adjacency).
"""
import json
import pathlib
import re
import subprocess
import sys
from collections import Counter

try:
    import numpy
    from lxml import etree
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

WRITER, FOLDER, PLANS = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
SPACES = {"http://www.opengis.net/indoorgml/1.1/core": "core", "http://www.opengis.net/indoorgml/1.1/navigation": "navi",
          "http://www.opengis.net/gml/3.2": "gml"}
GML_ID, HREF = "{http://www.opengis.net/gml/3.2}id", "{http://www.w3.org/1999/xlink}href"
NAVIGABLE = "gml:description? gml:name* core:cellSpaceGeometry? core:duality? core:externalReference* " \
            "core:partialboundedBy* navi:class navi:function navi:usage"
BOUNDARY = "gml:description? gml:name* core:duality? core:cellSpaceBoundaryGeometry? core:externalReference*"
CELLS = ["navi:GeneralSpace", "navi:TransitionSpace", "navi:ConnectionSpace", "navi:AnchorSpace"]
BOUNDARIES = ["navi:ConnectionBoundary", "navi:AnchorBoundary"]
# The children that each element may have, in order, as the schemas have them; "" for texts and links.
CONTENT = {
    "core:IndoorFeatures": "gml:name* gml:boundedBy? core:primalSpaceFeatures? core:multiLayeredGraph?",
    "gml:boundedBy": "gml:Envelope", "gml:Envelope": "gml:lowerCorner gml:upperCorner",
    "core:primalSpaceFeatures": "core:PrimalSpaceFeatures",
    "core:PrimalSpaceFeatures": "core:cellSpaceMember* core:cellSpaceBoundaryMember*",
    "core:cellSpaceMember": "|".join(CELLS), "core:cellSpaceBoundaryMember": "|".join(BOUNDARIES),
    **{cell: NAVIGABLE for cell in CELLS}, **{boundary: BOUNDARY for boundary in BOUNDARIES},
    "core:cellSpaceGeometry": "core:Geometry3D", "core:Geometry3D": "gml:Solid", "gml:Solid": "gml:exterior gml:interior*",
    "gml:Shell": "gml:surfaceMember+", "gml:surfaceMember": "gml:Polygon", "gml:Polygon": "gml:exterior gml:interior*",
    "gml:exterior": "gml:Shell|gml:LinearRing", "gml:interior": "gml:LinearRing", "gml:LinearRing": "gml:posList",
    "core:externalReference": "core:informationSystem? core:externalObject", "core:externalObject": "core:name|core:uri",
    "core:cellSpaceBoundaryGeometry": "core:geometry3D", "core:geometry3D": "gml:Polygon",
    "core:multiLayeredGraph": "core:MultiLayeredGraph", "core:MultiLayeredGraph": "core:spaceLayers+ core:interEdges*",
    "core:spaceLayers": "core:spaceLayerMember+", "core:spaceLayerMember": "core:SpaceLayer",
    "core:SpaceLayer": "core:usage* core:class? core:nodes+ core:edges*", "core:nodes": "core:stateMember+",
    "core:edges": "core:transitionMember*", "core:stateMember": "core:State", "core:transitionMember": "core:Transition",
    "core:State": "gml:name* core:duality? core:connects* core:geometry?",
    "core:Transition": "gml:name* core:weight? core:connects core:connects core:duality? core:geometry?",
    "core:geometry": "gml:Point|gml:LineString", "gml:Point": "gml:pos", "gml:LineString": "gml:posList",
}
WITH_ID = {"core:IndoorFeatures", "core:PrimalSpaceFeatures", "core:MultiLayeredGraph", "core:spaceLayers", "core:SpaceLayer",
           "core:nodes", "core:edges", "core:State", "core:Transition", "gml:Solid", "gml:Polygon", "gml:Point",
           "gml:LineString", *CELLS, *BOUNDARIES}


def name_of(element):
    tag = etree.QName(element)
    return f"{SPACES[tag.namespace]}:{tag.localname}"


def check_grammar(root):
    for element in root.iter():
        name = name_of(element)
        children = "".join(f"{name_of(child)} " for child in element)
        model = CONTENT.get(name, "")
        pattern = "".join(f"(?:(?:{part.rstrip('*+?')}) ){part[-1] if part[-1] in '*+?' else ''}" for part in model.split())
        assert re.fullmatch(pattern, children), f"{name} holds {children!r}, not {model!r}"
        assert (GML_ID in element.attrib) == (name in WITH_ID), f"{name}: gml:id"


def numbers(element):
    return numpy.array(element.text.split(), float).reshape(-1, 3)


def find(element, path):
    return element.findall(path, {short: long for long, short in SPACES.items()})


def rings(polygon):
    found = [numbers(p) for p in find(polygon, ".//gml:posList")]
    for ring in found:
        assert (ring[0] == ring[-1]).all(), "a ring is not closed"
    return [ring[:-1] for ring in found]


def newell(ring):
    return numpy.cross(ring, numpy.roll(ring, -1, axis=0)).sum(axis=0)


def check_cell(cell):
    """The shell is closed; returns (low z, high z, floor rings, volume, faces)."""
    edges, volume, faces = Counter(), 0.0, []
    polygons = [rings(p) for p in find(cell, ".//gml:Shell//gml:Polygon")]
    middle = polygons[0][0][0]
    for polygon in polygons:
        normal = sum(newell(ring - middle) for ring in polygon)
        volume += float((polygon[0][0] - middle) @ normal) / 6
        faces.append((polygon, normal / numpy.linalg.norm(normal)))
        for ring in polygon:
            corners = [tuple(p) for p in ring]
            edges.update(zip(corners, corners[1:] + corners[:1]))
    assert all(count == 1 and edges[(b, a)] == 1 for (a, b), count in edges.items()), "a shell is open"
    floors = [p for p, n in faces if n[2] < -0.5]
    z = numpy.concatenate([p[0][:, 2] for p, _ in faces])
    return z.min(), z.max(), floors, volume, faces


def holds(shape, points):
    """Which points lie inside a prism."""
    low, high, floors, _, _ = shape
    inside = numpy.zeros(len(points), bool)
    for floor in floors:
        for ring in floor:
            a, b = ring[:, None, :2], numpy.roll(ring, -1, axis=0)[:, None, :2]
            x, y = points[None, :, 0], points[None, :, 1]
            with numpy.errstate(divide="ignore", invalid="ignore"):
                crosses = ((a[..., 1] > y) != (b[..., 1] > y)) & \
                    (x < (b[..., 0] - a[..., 0]) * (y - a[..., 1]) / (b[..., 1] - a[..., 1]) + a[..., 0])
            inside ^= crosses.sum(axis=0) % 2 == 1
    return inside & (points[:, 2] > low) & (points[:, 2] < high)


def touches(shape, polygon):
    """Whether a polygon lies in a face of a cell."""
    low, high = polygon[0].min(axis=0) - 1e-6, polygon[0].max(axis=0) + 1e-6
    return any((f[0].min(axis=0) <= low + 2e-6).all() and (f[0].max(axis=0) >= high - 2e-6).all() and
               numpy.abs((polygon[0] - f[0][0]) @ n).max() < 1e-3 for f, n in shape[4])


def check(root, facts):
    check_grammar(root)
    ids = {}
    for element in root.iter():
        key = element.get(GML_ID)
        if key is not None:
            assert re.fullmatch(r"[A-Za-z_][\w.-]*", key), f"{key} is no NCName"
            assert key not in ids, f"{key} is there twice"
            ids[key] = element

    def target(element):
        return ids[element.get(HREF)[1:]]

    for element in root.iter():
        if HREF in element.attrib:
            assert element.get(HREF)[0] == "#" and element.get(HREF)[1:] in ids, f"{element.get(HREF)} leads nowhere"
    for solid in find(root, ".//gml:Solid"):
        assert solid.get("srsName") and solid.get("srsDimension") == "3"

    cells = [member[0] for member in find(root, ".//core:cellSpaceMember")]
    shapes = {cell.get(GML_ID): check_cell(cell) for cell in cells}
    walkable = {"room", "stair", "shaft", "door"}
    expected = sum(s["volume"] for s in facts["spaces"] if s["label"] in walkable)
    of_openings = sum(s["volume"] for s in facts["spaces"] if s["label"] == "opening")
    total = sum(shape[3] for shape in shapes.values())
    assert expected * 0.9999 < total < (expected + of_openings) * 1.0001, f"{total} m3 of {expected}"

    points = numpy.concatenate([s[4][0][0][0] for s in shapes.values()])
    low, high = points.min(axis=0), points.max(axis=0)
    random = numpy.random.default_rng(1).uniform(low, high, (4000, 3))
    assert sum(holds(s, random).astype(int) for s in shapes.values()).max() <= 1, "cells overlap (701)"
    for cell in cells:
        assert target(find(target(find(cell, "core:duality")[0]), "core:duality")[0]) is cell, "703"
        for boundary in find(cell, "core:partialboundedBy"):
            polygon = rings(find(target(boundary), ".//gml:Polygon")[0])
            assert touches(shapes[cell.get(GML_ID)], polygon), "a boundary lies beside its cell"
    states = find(root, ".//core:State")
    assert len(states) == len(cells)
    for state in states:
        cell = target(find(state, "core:duality")[0])
        assert holds(shapes[cell.get(GML_ID)], numbers(find(state, ".//gml:pos")[0]))[0], "a state outside its cell (702)"
        for link in find(state, "core:connects"):
            assert state in [target(end) for end in find(target(link), "core:connects")], "703"
    for transition in find(root, ".//core:Transition"):
        ends = [target(end) for end in find(transition, "core:connects")]
        boundary = target(find(transition, "core:duality")[0])
        assert ends[0] is not ends[1] and target(find(boundary, "core:duality")[0]) is transition
        for end in ends:
            cell = target(find(end, "core:duality")[0])
            assert boundary in [target(b) for b in find(cell, "core:partialboundedBy")], "not adjacent (704)"
            assert transition in [target(t) for t in find(end, "core:connects")], "703"
        path = numbers(find(transition, ".//gml:posList")[0])
        length = numpy.linalg.norm(numpy.diff(path, axis=0), axis=1).sum()
        assert abs(length - float(find(transition, "core:weight")[0].text)) < 1e-6
    return len(cells), len(find(root, ".//core:Transition")), len(find(root, ".//navi:AnchorSpace"))


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for plan in PLANS:
        if "/" in plan and not pathlib.Path(plan).exists():
            print(f"skipped: {plan} is not on this machine")
            sys.exit(77)
        stem = str(FOLDER / pathlib.Path(plan).stem)
        subprocess.run([WRITER, plan, stem], check=True)
        with open(stem + ".facts.json", encoding="utf-8") as facts:
            found = check(etree.parse(stem + ".gml").getroot(), json.load(facts))
        print(f"{plan}: {found[0]} cells, {found[1]} transitions, {found[2]} ways out")


if __name__ == "__main__":
    main()
