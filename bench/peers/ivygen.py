"""Ivy on a wall by IvyGen, the add-on of Blender, as an OBJ: blender -b -P ivygen.py -- OUT.obj METRES"""

import sys
import time

import addon_utils
import bpy

out, metres = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
addon_utils.enable("add_curve_ivygen")

start = time.process_time()
face = bpy.data.meshes.new("wall")
face.from_pydata([(-20, 0, 0), (20, 0, 0), (20, 0, 20), (-20, 0, 20)], [], [(0, 1, 2, 3)])
wall = bpy.data.objects.new("wall", face)
bpy.context.collection.objects.link(wall)
bpy.context.view_layer.objects.active = wall
bpy.context.scene.cursor.location = (0, -0.01, 0.05)
bpy.context.window_manager.ivy_gen_props.maxIvyLength = float(metres)
bpy.ops.curve.ivy_gen(updateIvy=True)
bpy.ops.wm.obj_export(filepath=out, export_materials=False, export_triangulated_mesh=True)
seconds = time.process_time() - start

print("measured", seconds, len(bpy.data.objects["IvyLeaf"].data.polygons))
