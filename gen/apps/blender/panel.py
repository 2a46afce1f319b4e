# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Frond of the 3D view's sidebar, its operators, and the add-on's preferences."""
import os
import subprocess
import textwrap

import bpy

from . import jobs, presets, schema, scene, state


def reload(_preferences=None, _context=None):
    """Looks for the program and its presets anew."""
    schema.unregister()
    try:
        schema.register()
        state.refresh()
    except (OSError, ValueError, subprocess.SubprocessError) as error:
        bpy.context.window_manager.frond.message = f"The program frond cannot be used: {error}"


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: bpy.props.StringProperty(name="Program", subtype="FILE_PATH", update=reload,
                                      description="The program frond; empty: $FROND_BIN, or that of the search path")
    folder: bpy.props.StringProperty(name="My presets", subtype="DIR_PATH", update=reload, description="A folder with presets of your own")

    def draw(self, _context):
        self.layout.prop(self, "program")
        self.layout.prop(self, "folder")
        if not state.program():
            self.layout.label(text="No program frond is found there", icon="ERROR")


def active_root(context):
    return state.root_of(context.object) if context.object else None


class OfRoot:
    """An operator on what is selected."""
    @classmethod
    def poll(cls, context):
        return active_root(context) is not None


class FROND_OT_add(bpy.types.Operator):
    """Grows the preset and puts it at the 3D cursor"""
    bl_idname, bl_label, bl_options = "frond.add", "Add", {"REGISTER", "UNDO"}

    preset: bpy.props.StringProperty(name="Preset")
    only: bpy.props.StringProperty(name="Only")

    def execute(self, context):
        browser = context.window_manager.frond
        browser.message = ""
        file, only = (self.preset, self.only) if self.preset else (browser.preset, browser.only)
        if file in ("", state.NONE) or not state.program():
            self.report({"ERROR"}, "A preset is missing" if state.program() else "The program frond was not found")
            return {"CANCELLED"}
        root = make_root(context, file, "" if only == state.ALL else only, film=browser.film)
        jobs.ask(root, 0)
        return {"FINISHED"}


def absolute(file):
    return os.path.abspath(bpy.path.abspath(file))


def make_root(context, file, only="", **values):
    """The root of what is to grow from a preset, selected alone."""
    file = absolute(file)
    name = only or os.path.basename(file).rsplit(".", 1)[0]
    root = scene.make_root(name, file)
    root.frond.only = only
    for key, value in values.items():
        setattr(root.frond, key, value)
    if only in state.names(file):
        root.frond.entry = str(state.names(file).index(only))
    for thing in [*context.view_layer.objects.selected]:
        thing.select_set(False)
    root.select_set(True)
    context.view_layer.objects.active = root
    return root


class FROND_OT_put(bpy.types.Operator):
    """Takes in what has grown"""
    bl_idname, bl_label, bl_options = "frond.put", "Grow", {"UNDO", "INTERNAL"}

    root: bpy.props.StringProperty()
    file: bpy.props.StringProperty()

    def execute(self, _context):
        scene.put(bpy.data.objects[self.root], self.file)
        return {"FINISHED"}


class FROND_OT_reset(OfRoot, bpy.types.Operator):
    """Takes the value of the preset again"""
    bl_idname, bl_label, bl_options = "frond.reset", "Reset", {"REGISTER", "UNDO"}

    pointer: bpy.props.StringProperty(description="Where in the preset; empty: all values")

    def execute(self, context):
        state.reset(active_root(context), self.pointer)
        return {"FINISHED"}


def make_operator(name, label, doc, run, *, of_root=True, undo=False):
    """One that hands `run` the root of what is selected, or nothing."""
    def execute(_self, context):
        run(*([active_root(context)] if of_root else []))
        return {"FINISHED"}

    bases = (OfRoot, bpy.types.Operator) if of_root else (bpy.types.Operator,)
    return type(f"FROND_OT_{name}", bases, {"__doc__": doc, "bl_idname": f"frond.{name}", "bl_label": label, "execute": execute,
                                            "bl_options": {"REGISTER", "UNDO"} if undo else {"REGISTER"}})


OPERATORS = [
    make_operator("grow", "Grow Again", "Grows what is selected again", lambda root: jobs.ask(root, 0)),
    make_operator("cancel", "Cancel", "Ends the growing; what stands stays as it was", jobs.cancel),
    make_operator("dice", "Another Seed", "Another seed", state.throw_dice, undo=True),
    make_operator("reload", "Reload", "Lists the presets anew", reload, of_root=False),
    make_operator("preferences", "Preferences of Frond", "Opens the preferences, where the program is named",
                  lambda: bpy.ops.preferences.addon_show(module=__package__), of_root=False),
]


def say(layout, text):
    box = layout.box()
    box.alert = True
    for i, line in enumerate(textwrap.wrap(text, 44)):
        box.label(text=line, icon="ERROR" if i == 0 else "BLANK1")


class Panel:
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Frond"


class FROND_PT_add(Panel, bpy.types.Panel):
    bl_label = "Frond"

    def draw(self, context):
        layout, browser = self.layout, context.window_manager.frond
        if not state.program():
            say(layout, "The program frond was not found. Name it in the preferences")
            layout.operator("frond.preferences", icon="PREFERENCES")
            return
        row = layout.row(align=True)
        row.prop(browser, "filter", text="", icon="VIEWZOOM")
        row.operator("frond.reload", text="", icon="FILE_REFRESH")
        layout.template_icon_view(browser, "preset", show_labels=True, scale=7, scale_popup=6)
        layout.prop(browser, "preset", text="")
        layout.prop(browser, "only")
        row = layout.row()
        row.prop(browser, "film")
        row.operator("frond.add", icon="ADD")
        if browser.message:
            say(layout, browser.message)


class FROND_PT_root(Panel, bpy.types.Panel):
    bl_label = "Selected"

    @classmethod
    def poll(cls, context):
        return active_root(context) is not None

    def draw(self, context):
        layout, root = self.layout, active_root(context)
        p, doing = root.frond, jobs.progress(root)
        row = layout.row()
        row.label(text=doing or os.path.basename(p.preset))
        row.operator("frond.cancel" if doing else "frond.grow", text="Cancel" if doing else "", icon="X" if doing else "FILE_REFRESH")
        if p.fault:
            say(layout, "; ".join(f"{at} {message}".strip() for at, message in presets.faults(p.fault)))
        try:
            state.document(root)
        except (OSError, ValueError) as error:
            say(layout, f"The preset cannot be read: {error}")
            return
        row = layout.row(align=True)
        row.prop(p, "seed")
        row.operator("frond.dice", text="", icon="FILE_REFRESH")
        for name in "frame", "detail", "texture":
            layout.prop(p, name)
        row = layout.row()
        row.prop(p, "film")
        if bpy.app.version >= (3, 6):
            row.prop(p, "instances")
        draw_organism(layout, context, root)


def draw_organism(layout, context, root):
    """The properties of the organism that is shown, or those whose names hold the words that are looked for."""
    layout.prop(root.frond, "entry")
    kind = presets.value_at(state.document(root), f"/organisms/{int(root.frond.entry or 0)}/kind")
    if kind not in schema.KINDS:
        return
    browser, group = context.window_manager.frond, getattr(root, f"frond_{kind}")
    row = layout.row()
    row.prop(browser, "find", text="", icon="VIEWZOOM")
    row.operator("frond.reset", text="Reset all").pointer = ""
    words = browser.find.lower().replace(" ", "_").split()
    found = [one for one in schema.all_of(schema.KINDS[kind]) if not one.parts and all(word in one.name for word in words)]
    column = layout.column()
    column.use_property_split, column.use_property_decorate = True, False
    for one in found if words else schema.KINDS[kind]:
        draw_property(column, group, one)


def draw_property(layout, group, one):
    """A control, with a button where its value was changed and what the program says of it; of a group or a list, all it holds."""
    whole = schema.pointer(group, one, whole=True)
    if whole is None:
        return
    name, folds = one.name, bool(one.parts)
    is_open = not folds or getattr(group, name + "__open")
    inner = layout.box() if folds or one.many else layout
    row = inner.row(align=True)
    if folds:
        row.prop(group, name + "__open", icon="TRIA_DOWN" if is_open else "TRIA_RIGHT", emboss=False)
    elif one.many:
        row.label(text=one.label)
    elif schema.shows(group, one):
        row.prop(group, name)
    else:
        draw_text(row, group, one, "__text")
    draw_marks(row, inner, group, whole, not (folds and is_open))
    if is_open and one.many:
        draw_text(inner, group, one, "__text")
        if schema.pointer(group, one):
            inner.prop(group, name + "__index")
    if not is_open or not schema.pointer(group, one):
        return
    if folds and schema.shows(group, one):
        for part in one.parts:
            draw_property(inner, group, part)
    elif one.many and schema.shows(group, one):
        inner.prop(group, name)
    elif folds or one.many:
        draw_text(inner, group, one, "__element" if one.many else "__text")


def draw_text(layout, group, one, which):
    if len(getattr(group, one.name + which)) < 400:  # longer ones are cut by Blender's field
        layout.prop(group, one.name + which)
    else:
        layout.label(text=f"{one.label}: too long for a field")


def draw_marks(row, layout, group, pointer, tells):
    changed = state.changes(group.id_data)
    if any(at == pointer or at.startswith(pointer + "/") for at in changed):
        row.operator("frond.reset", text="", icon="LOOP_BACK").pointer = pointer
    said = state.fault_at(group.id_data, pointer) if tells else ""
    if said:
        row.alert = True
        say(layout, said)


CLASSES = [Preferences, FROND_OT_add, FROND_OT_put, FROND_OT_reset, *OPERATORS, FROND_PT_add, FROND_PT_root]


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)


def unregister():
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
