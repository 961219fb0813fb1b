"""The closed rooms of tests/support/lit_rooms.cpp (`closed_rooms`) with the lamps of tests/render/path_cycles_test.cpp,
rendered by Blender's Cycles: a path tracer that shares nothing with ours. Prints the mean luminance of 8 x 8 blocks of the
picture, which the test compares with. By hand only; needs Debian's `blender`:

    blender --background --factory-startup --python tools/cycles_room.py -- [samples [threads [bounces]]]
"""

import math
import os
import sys
import tempfile

import bpy

# x0, y0, x1, y1, height: metres
BOXES = [
    (0, 0, 4, 3, 2.5),
    (4, 1, 4.25, 2, 2),
    (4.25, 0, 7, 5, 3.25),
    (5, 5, 6, 5.25, 2),
    (4.5, 5.25, 6.5, 8, 2.25),
]
REFLECTANCE = 0.6
# place, candela, radius
LAMPS = [((1.2, 1.7, 2.0), (60, 60, 60), 0.0), ((5.4, 2.4, 2.6), (80, 60, 40), 0.2), ((4.9, 6.9, 1.4), (50, 50, 50), 0.1)]
EYE, TARGET, FOV = (0.4, 2.6, 1.5), (4.6, 1.3, 1.0), 75
SIDE = 64
EXPOSURE = 0.02


def add_quad(mesh, corners):
    first = len(mesh["points"])
    mesh["points"] += corners
    mesh["faces"].append([first, first + 1, first + 2, first + 3])


def add_wall(mesh, at, axis, low, high, top, doors):
    """An upright wall in the plane axis = at, from low to high of the other axis; doors: (low, high, top), without faces."""
    def quad(a, b, z0, z1):
        if b - a > 1e-9 and z1 - z0 > 1e-9:
            ends = [(at, a), (at, b)] if axis == 0 else [(a, at), (b, at)]
            add_quad(mesh, [(*ends[0], z0), (*ends[1], z0), (*ends[1], z1), (*ends[0], z1)])

    where = low
    for a, b, door_top in sorted(doors):
        quad(where, a, 0, top)
        quad(a, b, door_top, top)
        where = b
    quad(where, high, 0, top)


def add_boxes(mesh):
    for box in BOXES:
        x0, y0, x1, y1, top = box
        for z in (0, top):
            add_quad(mesh, [(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)])
        for axis, at, low, high in ((0, x0, y0, y1), (0, x1, y0, y1), (1, y0, x0, x1), (1, y1, x0, x1)):
            doors = []
            for other in BOXES:
                faces = (other[0], other[2]) if axis == 0 else (other[1], other[3])
                a, b = (other[1], other[3]) if axis == 0 else (other[0], other[2])
                if other is not box and at in faces and max(a, low) < min(b, high):
                    doors.append((max(a, low), min(b, high), min(other[4], top)))
            add_wall(mesh, at, axis, low, high, top, doors)


def add_rooms():
    mesh = {"points": [], "faces": []}
    add_boxes(mesh)
    data = bpy.data.meshes.new("rooms")
    data.from_pydata(mesh["points"], [], mesh["faces"])
    rooms = bpy.data.objects.new("rooms", data)
    material = bpy.data.materials.new("dull")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    dull, out = nodes.new("ShaderNodeBsdfDiffuse"), nodes.new("ShaderNodeOutputMaterial")
    dull.inputs["Color"].default_value = (REFLECTANCE, REFLECTANCE, REFLECTANCE, 1)
    material.node_tree.links.new(dull.outputs[0], out.inputs["Surface"])
    data.materials.append(material)
    bpy.context.collection.objects.link(rooms)


def add_lamps():
    for number, (place, candela, radius) in enumerate(LAMPS):
        light = bpy.data.lights.new(f"lamp {number}", "POINT")
        light.energy = 4 * math.pi  # of one candela in all directions
        light.color = candela
        light.shadow_soft_size = radius
        light.cycles.max_bounces = 1024
        lamp = bpy.data.objects.new(f"lamp {number}", light)
        lamp.location = place
        lamp.visible_camera = False  # our lamps light, but are not seen
        bpy.context.collection.objects.link(lamp)


def add_camera():
    import mathutils

    data = bpy.data.cameras.new("eye")
    data.angle = math.radians(FOV)
    data.clip_start = 0.001
    camera = bpy.data.objects.new("eye", data)
    camera.location = EYE
    way = mathutils.Vector(TARGET) - mathutils.Vector(EYE)
    camera.rotation_euler = way.to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def render(samples, threads, bounces):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = samples, False, False
    cycles.max_bounces = cycles.diffuse_bounces = bounces
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.light_sampling_threshold = 0
    scene.world = bpy.data.worlds.new("dark")
    scene.world.use_nodes = False
    scene.world.color = (0, 0, 0)
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.view_settings.view_transform = "Raw"
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGB", "32"
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "room.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        return list(image.pixels), image.channels


def main():
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    samples = int(arguments[0]) if arguments else 4096
    threads = int(arguments[1]) if len(arguments) > 1 else 1
    bounces = int(arguments[2]) if len(arguments) > 2 else 256
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    add_rooms()
    add_lamps()
    add_camera()
    pixels, channels = render(samples, threads, bounces)
    side = SIDE // 8
    for row in range(8):  # rows of the file go upward
        means = []
        for column in range(8):
            total = 0.0
            for y in range(SIDE - (row + 1) * side, SIDE - row * side):
                for x in range(column * side, (column + 1) * side):
                    p = (y * SIDE + x) * channels
                    total += 0.2126 * pixels[p] + 0.7152 * pixels[p + 1] + 0.0722 * pixels[p + 2]
            means.append(f"{EXPOSURE * total / side**2:.6f}")
        print("block row:", ", ".join(means))


main()
