"""Opens what a preset is exported to in Blender, and holds its picture against POV-Ray's from the preset's camera.

  blender -b --python-exit-code 1 --python overlap.py -- FROND PRESET FOLDER LEAST DETAIL [--set POINTER=VALUE]...

Runs where povinc/ is.
Both stand in an empty studio. The silhouettes must overlap by LEAST, 0 to 1, and the pictures in the file must be
seen. DETAIL is that of the export. Both renders stay in FOLDER, blender.png with light and colours. Debian's Blender 3.4
has three traps: its importer of glTF uses names that numpy no longer has, its Cycles has no denoiser, and without a display
nothing but Cycles renders.
"""
import json
import math
import os
import re
import struct
import subprocess
import sys

import numpy

for name, kind in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    setattr(numpy, name, kind)

import bpy
from mathutils import Vector

LONGER_SIDE = 480  # pixels
SUN = (-0.5, 0.7, 0.6)


def run(*words, **options):
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, **options)


def pov_silhouette(frond, preset, folder, sets, frame, size):
    """Renders black organisms before nothing; returns the camera's place, target and angle, in metres."""
    run(frond, "generate", preset, "-o", folder, "--frames", f"{frame}-{frame}", "--no-resolve", "-q", *sets)
    path = f"{folder}/frames/frame_{frame:04}.pov"
    with open(path, encoding="utf-8") as file:
        text = file.read()
    unit = float(re.search(r"Frond_Unit = ([\d.]+)", text)[1])
    camera = re.search(r"camera\{location<(.*?)>.*?angle ([\d.]+) look_at<(.*?)>", text)
    text = re.sub(r"^Studio_(Globals|Room|Lamp)\(.*\)$", "", text, flags=re.MULTILINE)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace("#version 3.7;", "#version 3.7; global_settings{assumed_gamma 1}", 1))
    run("povray", "+Lpovinc", f"+L{folder}/frames", f"+W{size[0]}", f"+H{size[1]}", "+A0.3",
        "+UA", "-D", f"+I{path}", f"+O{folder}/povray.png", stderr=subprocess.DEVNULL)
    place = [[float(x) / unit for x in camera[i].split(",")] for i in (1, 3)]
    for p in place:
        p[2] = -p[2]
    return place[0], place[1], float(camera[2])


def to_blender(p):
    return Vector((p[0], -p[2], p[1]))


def stage(location, target, angle, size):
    """Sky, a sun and the camera."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 12
    scene.cycles.seed = 1
    scene.cycles.use_denoising = False
    scene.render.film_transparent = True
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.6, 0.75, 1, 1)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy = 3
    sun.rotation_euler = to_blender(SUN).to_track_quat("Z", "Y").to_euler()
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = to_blender(location)
    camera.rotation_euler = (to_blender(target) - camera.location).to_track_quat("-Z", "Y").to_euler()
    camera.data.sensor_fit = "HORIZONTAL"
    camera.data.angle = math.radians(angle)
    camera.data.clip_start, camera.data.clip_end = 0.005, 2000
    for thing in (sun, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera


def render(path):
    bpy.context.scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    return pixels_of(path)


def pixels_of(path):
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    values = numpy.empty(len(image.pixels), dtype=numpy.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)


def without_pictures():
    """Takes the colour pictures out of all materials; returns how many there were."""
    count = 0
    for material in bpy.data.materials:
        if not material.use_nodes:
            continue
        for link in list(material.node_tree.links):
            if link.from_node.type == "TEX_IMAGE" and link.from_socket.name == "Color" and link.to_node.type != "NORMAL_MAP":
                assert link.from_node.image.size[0] > 0, link.from_node.image.name
                material.node_tree.links.remove(link)
                count += 1
    return count


def said_by(model):
    """The JSON of a .glb."""
    with open(model, "rb") as file:
        (size,) = struct.unpack("<12xI4x", file.read(20))
        return json.loads(file.read(size))


def main(frond, preset, folder, least, detail, *sets):
    os.makedirs(folder, exist_ok=True)
    with open(preset, encoding="utf-8") as file:
        given = json.loads(re.sub(r'("(?:[^"\\]|\\.)*")|//[^\n]*', lambda m: m[1] or "", file.read()))  # no comments
    camera = given.get("scene", {}).get("camera", {})
    # Exports have each twig as it is.
    sets = ["--set", "/scene=" + json.dumps({"setting": "studio", "camera": camera}), "--set", "/film/twigs=0", *sets]
    info = json.loads(subprocess.run([frond, "info", preset, "--json", *sets], check=True, capture_output=True).stdout)
    frame = info["frames"]
    wide, high = given.get("film", {}).get("size", (4, 3))
    size = [round(LONGER_SIDE * side / max(wide, high)) for side in (wide, high)]
    where = pov_silhouette(frond, preset, folder, sets, frame, size)

    model = f"{folder}/model.glb"
    run(frond, "export", preset, "--frame", str(frame), "--detail", detail, "-q", "-o", model, *sets)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=model)
    said = said_by(model)
    meshes = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    faces = sum(len(thing.data.polygons) for thing in meshes)
    stage(*where, size)
    shown = render(f"{folder}/blender.png")
    theirs = pixels_of(f"{folder}/povray.png")[..., 3] > 0.5
    ours = shown[..., 3] > 0.5
    overlap = 2 * (ours & theirs).sum() / max(1, ours.sum() + theirs.sum())
    pictures = without_pictures()
    change = 0.0
    if pictures:
        bare = render(f"{folder}/bare.png")
        change = float(numpy.abs(shown - bare)[ours][:, :3].mean())
    print(f"{preset}: overlap {overlap:.4f}, {len(meshes)} objects, {faces} faces, {len(bpy.data.materials)} materials, "
          f"{pictures} pictures of colours, which change the picture by {change:.3f}")
    textured = sum("baseColorTexture" in m["pbrMetallicRoughness"] for m in said["materials"])
    assert (pictures > 0) == (textured > 0), "pictures are missing"
    assert not textured or change > 0.01, "pictures are not seen"
    assert theirs.sum() > 500, "POV-Ray shows nothing"
    assert overlap >= float(least), f"silhouettes overlap by {overlap:.4f} only"


main(*sys.argv[sys.argv.index("--") + 1:])
