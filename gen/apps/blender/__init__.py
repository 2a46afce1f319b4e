# SPDX-License-Identifier: GPL-3.0-or-later
"""Frond in Blender: presets of plants and corals in the sidebar of the 3D view, grown by the program frond.

From scripts: `grow("presets/trees/oak.json", {"/organisms/0/years": 20})`; in Blender 4.2 and later this module is
bl_ext.user_default.frond_blender, before that frond_blender.
"""
import json

import bpy

from . import jobs, panel, scene, schema, state

bl_info = {
    "name": "Frond",
    "description": "Plants and corals that grow from presets",
    "author": "The Frond authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Frond",
    "category": "Add Mesh",
}


def grow(preset, sets=None, frame=0, root=None, **options):
    """Grows a preset and waits for it; returns the objects, of which the first is the root of all others.

    `sets` are values by JSON pointer, `frame` counts from 1, 0 being the last. `root` has what it holds replaced. `options` are
    only (the name of the one organism that grows), film, detail, texture and instances. Raises ValueError with what the program
    says; then what stood there stays as it was.
    """
    made = root is None
    if made:
        root = panel.make_root(bpy.context, str(preset))
    root.frond.preset, root.frond.changes = panel.absolute(str(preset)), json.dumps(sets or {})
    for name, value in {**options, "frame": frame}.items():
        setattr(root.frond, name, value)
    try:
        job = jobs.grow_now(root)
    except (OSError, ValueError):
        if made:
            scene.remove(root)
        raise
    try:
        return [root, *scene.put(root, job.file)]
    finally:
        job.close()


def load_later():
    """Not while Blender starts: the program is asked for what presets hold."""
    panel.reload()


def register():
    state.register()
    panel.register()
    bpy.app.timers.register(load_later, first_interval=0.1, persistent=True)
    bpy.app.handlers.load_pre.append(jobs.stop_all)


def unregister():
    if bpy.app.timers.is_registered(load_later):
        bpy.app.timers.unregister(load_later)
    bpy.app.handlers.load_pre.remove(jobs.stop_all)
    jobs.stop_all()
    schema.unregister()
    panel.unregister()
    state.unregister()
