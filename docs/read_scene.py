#!/usr/bin/env python3
"""Reads a scene file (.enf) with numpy alone, and prints what is in it: the format's executable description.

    python3 docs/read_scene.py SCENE.enf

As a module: `scene = read_scene(path)` gives a dict of numpy arrays by section name, mapped, not copied.
The words are those of docs/scene-format.md."""

import hashlib
import sys

import numpy as np

HEADER = np.dtype([("magic", "S8"), ("version", "<u4"), ("byte_order", "<u4"), ("file_bytes", "<u8"),
                   ("section_count", "<u4"), ("section_entry_bytes", "<u4"), ("unit", "<f8"), ("origin", "<f8", 3),
                   ("header_sha256", "V32"), ("reserved", "V32")])
ENTRY = np.dtype([("name", "S16"), ("id", "<u4"), ("group", "<u4"), ("element_bytes", "<u4"), ("reserved", "<u4"),
                  ("offset", "<u8"), ("bytes", "<u8"), ("sha256", "V32"), ("reserved2", "V16")])
ELEMENTS = {
    "cells": [("first_section", "<u4"), ("section_count", "<u2"), ("label", "u1"), ("reserved", "u1"),
              ("z_floor", "<f4"), ("z_ceiling", "<f4"), ("floor", "<u4"), ("ceiling", "<u4"), ("space", "<u4"),
              ("volume", "<u4")],
    "cell_portals": [("floor", "<u4"), ("ceiling", "<u4")],
    "section_x": "<f4",
    "section_y": "<f4",
    "section_tails": [("first_face", "<u4")],
    "side_faces": [("z_top", "<f4"), ("target", "<u4")],
    "side_face_ports": "<u4",
    "portals": [("front", "<u4"), ("back", "<u4"), ("kind_and_tint", "<u4")],
    "tints": ("<f4", 3),
    "source_faces": [("first_vertex", "<u4"), ("surface", "u1"), ("reserved", "u1", 3), ("space", "<u4"),
                     ("material", "<u4")],
    "vertices": ("<f4", 3),
    "materials": [("colour", "<f4", 3), ("name", "<u4")],
    "spaces": [("label", "u1"), ("reserved", "u1", 3), ("id", "<u4"), ("name", "<u4"), ("storey", "<u4"),
               ("storey_index", "<u4"), ("reserved2", "<u4"), ("area_m2", "<f8")],
    "text_offsets": "<u4",
    "text": "u1",
    "locator_nodes": [("low", "<f4", 3), ("high", "<f4", 3), ("skip", "<u4"), ("first_and_count", "<u4")],
    "locator_cells": "<u4",
    "meshes": [("first_vertex", "<u4"), ("first_triangle", "<u4"), ("vertex_count", "<u4"), ("triangle_count", "<u4"),
               ("low", "<f4", 3), ("high", "<f4", 3), ("name", "<u4"), ("texcoords", "<u4")],
    "mesh_vertices": ("<f4", 3),
    "mesh_triangles": [("corners", "<u4", 3), ("material", "<u4")],
    "objects": [("scene_from_object", "<f4", (3, 4)), ("object_from_scene", "<f4", (3, 4)), ("low", "<f4", 3),
                ("high", "<f4", 3), ("mesh", "<u4"), ("material", "<u4"), ("space", "<u4"), ("id", "<u4"),
                ("name", "<u4"), ("reserved", "<u4")],
    "cell_object_off": "<u4",
    "cell_objects": "<u4",
    "lights": [("position", "<f4", 3), ("radius", "<f4"), ("intensity", "<f4", 3), ("cell", "<u4"), ("carrier", "<u4"),
               ("id", "<u4"), ("name", "<u4"), ("reserved", "<u4")],
    "material_looks": [("mirror", "<f4"), ("through", "<f4", 3), ("texture", "<u4"),
                       ("texture_from_face", "<f4", (2, 3)), ("reserved", "<u4")],
    "textures": [("first_texel", "<u4"), ("width", "<u2"), ("height", "<u2"), ("level_count", "<u4"), ("name", "<u4")],
    "texels": ("u1", 4),
    "mesh_texcoords": ("<f4", 2),
    "face_frames": [("x_u", "<f4"), ("y_u", "<f4"), ("u_0", "<f4"), ("v_0", "<f4")],
}
LABELS = ["room", "wall", "slab", "door", "window", "opening", "stair", "shaft", "object", "exterior", "ground",
          "outside"]


def read_scene(path):
    """The arrays of a scene file by name, plus "unit" and "origin". Raises ValueError for a damaged file."""
    data = np.memmap(path, dtype=np.uint8, mode="r")
    if data.size < HEADER.itemsize:
        raise ValueError("shorter than a header")
    header = data[: HEADER.itemsize].view(HEADER)[0]
    if header["magic"] != b"ENFILADE" or header["version"] != 1 or header["byte_order"] != 0x01020304:
        raise ValueError("no scene file of version 1")
    if header["file_bytes"] != data.size:
        raise ValueError("cut short or grown")
    table_end = HEADER.itemsize + int(header["section_count"]) * ENTRY.itemsize
    signed = bytearray(data[:table_end].tobytes())
    start = HEADER.fields["header_sha256"][1]
    signed[start:start + 32] = bytes(32)
    if hashlib.sha256(signed).digest() != bytes(header["header_sha256"]):
        raise ValueError("header or section table damaged")
    scene = {"unit": float(header["unit"]), "origin": header["origin"].copy()}
    for entry in data[HEADER.itemsize: table_end].view(ENTRY):
        raw = data[int(entry["offset"]): int(entry["offset"]) + int(entry["bytes"])]
        if hashlib.sha256(raw).digest() != bytes(entry["sha256"]):
            raise ValueError("section %s damaged" % entry["name"].decode())
        name = entry["name"].decode()
        element = np.dtype(ELEMENTS.get(name, "V%d" % entry["element_bytes"]))
        if element.itemsize != entry["element_bytes"]:
            raise ValueError("section %s has elements of another size" % name)
        base, shape = element.subdtype if element.subdtype else (element, ())
        scene[name] = raw.view(base).reshape((-1,) + shape)
    return scene


def text(scene, i):
    """String number i."""
    begin, end = scene["text_offsets"][i: i + 2]
    return scene["text"][begin:end].tobytes().decode()


def floor_areas(scene):
    """Area of each cell's floor polygon in square metres, by the shoelace formula."""
    x, y = scene["section_x"].astype(float), scene["section_y"].astype(float)
    areas = []
    for cell in scene["cells"]:
        ring = slice(cell["first_section"], cell["first_section"] + cell["section_count"])
        px, py = x[ring], y[ring]
        areas.append(0.5 * float(np.dot(px, np.roll(py, -1)) - np.dot(np.roll(px, -1), py)))
    return np.array(areas)


def object_vertices(scene, k):
    """Vertices of object k where they stand, n x 3."""
    placed = scene["objects"][k]
    mesh = scene["meshes"][placed["mesh"]]
    own = scene["mesh_vertices"][mesh["first_vertex"]: mesh["first_vertex"] + mesh["vertex_count"]].astype(float)
    rows = placed["scene_from_object"].astype(float)
    return own @ rows[:, :3].T + rows[:, 3]


def main():
    scene = read_scene(sys.argv[1])
    cells, spaces = scene["cells"], scene["spaces"]
    print("unit %g m, origin %s" % (scene["unit"], " ".join("%g" % v for v in scene["origin"])))
    print("%d cells, %d sections, %d side faces, %d portals, %d source faces" %
          (cells.size, scene["section_x"].size - 1, scene["side_faces"].size, scene["portals"].size,
           scene["source_faces"].size - 1))
    areas = floor_areas(scene)
    for i, space in enumerate(spaces):
        mine = cells["space"] == i
        if LABELS[space["label"]] == "room":
            print("room %-24s %3d cells %8.2f m2" % (text(scene, space["name"]), mine.sum(), areas[mine].sum()))
    if "objects" in scene:
        counts = scene["meshes"]["triangle_count"]
        print("%d objects of %d meshes, %d triangles, %d where they stand" %
              (scene["objects"].size, counts.size, counts.sum(), counts[scene["objects"]["mesh"]].sum()))
        for k, placed in enumerate(scene["objects"]):
            points = object_vertices(scene, k)
            if points.size and ((points < placed["low"]).any() or (points > placed["high"]).any()):
                raise ValueError("object %s is not in its box" % text(scene, placed["id"]))


if __name__ == "__main__":
    main()
