"""Opens an animated export and one with levels of detail in Blender: vertices move and are where single frames have them.

  blender -b --python-exit-code 1 --python moves.py -- FROND PRESET FOLDER
"""
import os
import subprocess
import sys

import numpy

for name, kind in (("bool", bool), ("int", int), ("float", float), ("object", object)):  # Blender 3.4 wants them
    setattr(numpy, name, kind)

import bpy


def opened(frond, preset, folder, *options):
    file = f"{folder}/scene.glb"
    subprocess.run([frond, "export", preset, "-o", file, "-q", "--texture", "0", *options], check=True)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=file)
    return sorted((thing for thing in bpy.data.objects if thing.type == "MESH"), key=lambda thing: thing.name)


def places(thing):
    mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    values = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
    mesh.vertices.foreach_get("co", values)
    return values.reshape(-1, 3)


def top(thing):
    here = places(thing)
    return here[here[:, 2].argmax()]


def main(frond, preset, folder):
    os.makedirs(folder, exist_ok=True)
    alone = [top(thing) for frame in (3, 6) for thing in opened(frond, preset, folder, "--frame", str(frame))[:1]]
    thing = opened(frond, preset, folder, "--frames", "3-6")[0]
    fps = bpy.context.scene.render.fps
    shown = []
    for frame in (3, 6):  # the film has 6 a second, and begins at its third
        seconds = (frame - 3) / 6
        bpy.context.scene.frame_set(round(seconds * fps))
        shown.append(top(thing))
    print(f"tops {alone} alone, {shown} in the film")
    assert numpy.linalg.norm(shown[0] - shown[1]) > 0.05, "nothing moves"
    for one, other in zip(alone, shown):
        assert numpy.linalg.norm(one - other) < 0.02, "the film is elsewhere than its frames"
    faces = {thing.name: len(thing.data.polygons) for thing in opened(frond, preset, folder, "--frame", "6", "--lods", "3")}
    print(faces)
    full = [name for name in faces if "_LOD" not in name]
    assert full and all(faces[name + "_LOD1"] < 0.3 * faces[name] for name in full), "levels are not coarser"


main(*sys.argv[sys.argv.index("--") + 1:])
