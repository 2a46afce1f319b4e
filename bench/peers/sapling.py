"""A tree by Sapling, the add-on of Blender, as an OBJ: blender -b -P sapling.py -- OUT.obj LEVELS SHOOTS"""

import ast
import sys
import time
from pathlib import Path

import addon_utils
import bpy

out, levels, shoots = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
folder = Path(addon_utils.enable("add_curve_sapling").__file__).parent

start = time.process_time()
text = (folder / "presets" / "quaking_aspen.py").read_text(encoding="utf-8")
preset = ast.literal_eval(text[text.index("{") :])
preset.update(levels=int(levels), branches=(*preset["branches"][:3], int(shoots)), showLeaves=True, do_update=True)
bpy.ops.curve.tree_add(**preset)
bpy.ops.wm.obj_export(filepath=out, export_materials=False, export_triangulated_mesh=True)
seconds = time.process_time() - start

grown = [len(thing.data.polygons) for thing in bpy.data.objects if thing.type == "MESH"]
print("measured", seconds, sum(grown) // 2)  # two quads a leaf
