# SPDX-License-Identifier: GPL-3.0-or-later
"""What a root remembers: an empty object whose `frond` holds the preset and the values that were changed.

What grew is below it, in a collection of its own. `changes` is JSON of values by pointer, as `frond export --set` takes them.
"""
import copy
import json
import random

import bpy

from . import jobs, presets

ALL, NONE = "*", "-"  # in lists of names and of files


def preferences():
    found = bpy.context.preferences.addons.get(__package__)
    return found.preferences if found else None


def program():
    """The path of the program frond, None where it is not found."""
    return presets.find_program(getattr(preferences(), "program", ""))


def root_of(thing):
    """The root of what an object belongs to, None where that is not Frond's."""
    while thing and not thing.frond.preset:
        thing = thing.parent
    return thing


def document(root):
    return presets.changed_document(root.frond.preset, root.frond.changes)


def changes(root):
    return json.loads(root.frond.changes)


def record(root, pointer, value):
    """Marks a value as changed, and has the root grown again after a pause."""
    kept = {at: v for at, v in changes(root).items() if at != pointer and not at.startswith(pointer + "/")}
    above = list_to_write_out(root, pointer, kept)
    if above:  # elements of a list can be changed in the file that holds the list only
        whole = {above: copy.deepcopy(presets.value_at(document(root), above))}
        presets.put(whole[above], pointer[len(above):], value)
        kept.update(whole)
    else:
        kept[pointer] = value
    root.frond.changes = json.dumps(kept)
    jobs.ask(root)


def list_to_write_out(root, pointer, changed):
    """The pointer of the outermost list on the way that a species or the defaults bring, "" where there is none."""
    parts = pointer.split("/")
    for i in range(4, len(parts)):
        above = "/".join(parts[:i])
        if isinstance(presets.value_at(document(root), above), list) and above not in changed:
            return "" if presets.value_at(presets.read(root.frond.preset), above) is not None else above
    return ""


def throw_dice(root):
    root.frond.seed = random.randrange(1, 2**31)


def reset(root, pointer):
    """Takes back what was changed at a pointer and below it; "" takes back all."""
    kept = {at: value for at, value in changes(root).items() if at != pointer and not at.startswith(pointer + "/")}
    root.frond.changes = json.dumps(kept)
    jobs.ask(root)


def fault_at(root, pointer):
    """What the program said of a property or of a part of it, "" where it said nothing."""
    said = presets.faults(root.frond.fault)
    return "; ".join(message for at, message in said if at == pointer or at.startswith(pointer + "/"))


def ask(of_root, _context):
    jobs.ask(of_root.id_data)


_names = []  # Blender keeps no reference to them


def names(file):
    try:
        return presets.names(file)
    except (OSError, ValueError):  # of a file that is gone; the panel tells
        return []


def entry_items(of_root, _context):
    _names[:] = [(str(i), name, "") for i, name in enumerate(names(of_root.preset))] or [("0", "", "")]
    return _names


_choices = []


def only_items(browser, _context):
    _choices[:] = [(ALL, "All", "")] + [(name, name, "") for name in dict.fromkeys(names(browser.preset))]
    return _choices


def get_seed(of_root):
    return min(int(document(of_root.id_data).get("seed", 1)), 2**31 - 1)


class Root(bpy.types.PropertyGroup):
    preset: bpy.props.StringProperty(name="Preset", description="The file that this grew from")
    changes: bpy.props.StringProperty(default="{}")
    fault: bpy.props.StringProperty(description="What the program said last, where it could not grow this")
    entry: bpy.props.EnumProperty(name="Organism", description="Whose properties are shown", items=entry_items)
    only: bpy.props.StringProperty(description="The only organism that grows, and what it creeps on; empty: all")
    seed: bpy.props.IntProperty(name="Seed", description="Another number gives another plant by the same rules", min=0,
                                get=get_seed, set=lambda self, value: record(self.id_data, "/seed", value))
    frame: bpy.props.IntProperty(name="Frame", description="Which frame of the preset's film, which tells its age; 0: the last",
                                 min=0, soft_max=500, update=ask)
    film: bpy.props.BoolProperty(name="As a film", description="Growth and motion up to the frame, as shape keys", update=ask)
    detail: bpy.props.StringProperty(
        name="Detail", description="Triangles of one organism, about, or as fine as it is seen so many pixels high, as in 400px",
        default="100000", update=ask)  # coarser than the program's, as Blender waits while it imports
    texture: bpy.props.IntProperty(name="Pictures", description="How many pixels wide pictures are; 0: none", default=512, min=0,
                                   max=4096, update=ask)
    instances: bpy.props.BoolProperty(name="Instances", description="Each leaf and copy once, with all its places", update=ask)


class Browser(bpy.types.PropertyGroup):
    filter: bpy.props.StringProperty(name="Filter", description="Words that names or titles of presets hold",
                                     options={"TEXTEDIT_UPDATE"}, update=lambda self, _: choose_shown(self))
    preset: bpy.props.EnumProperty(name="Preset", items=lambda self, _: browser_items(self),
                                   update=lambda self, _: setattr(self, "only", ALL))
    only: bpy.props.EnumProperty(name="Only", description="The organism that is added, with what it creeps on", items=only_items)
    find: bpy.props.StringProperty(name="Find", description="Words that names of properties hold", options={"TEXTEDIT_UPDATE"})
    film: bpy.props.BoolProperty(name="As a film", description="With its growth and motion, as shape keys")
    message: bpy.props.StringProperty()


_previews, _listed, _shown = None, [], []


def refresh():
    """Lists the presets anew."""
    global _listed
    found = program()
    _listed = presets.list_presets(presets.find_home(found), getattr(preferences(), "folder", "")) if found else []


def browser_items(browser):
    """Presets that hold all words of the filter, with their pictures. Numbers stay, so the chosen one does."""
    global _shown
    words = browser.filter.lower().split()
    _shown = [(file, name, title, icon(picture), i) for i, (file, name, title, picture) in enumerate(_listed)
              if all(word in f"{name} {title}".lower() for word in words)]
    return _shown or [(NONE, "None", "No preset holds these words", 0, -1)]


def choose_shown(browser):
    items = browser_items(browser)
    if browser.preset not in [item[0] for item in items]:
        browser.preset = items[0][0]


def icon(picture):
    if not picture:
        return 0
    known = _previews.get(picture) or _previews.load(picture, picture, "IMAGE")
    return known.icon_id


CLASSES = Root, Browser


def register():
    global _previews
    import bpy.utils.previews
    _previews = bpy.utils.previews.new()
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Object.frond = bpy.props.PointerProperty(type=Root)
    bpy.types.WindowManager.frond = bpy.props.PointerProperty(type=Browser)


def unregister():
    del bpy.types.Object.frond, bpy.types.WindowManager.frond
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
    bpy.utils.previews.remove(_previews)
    _listed.clear()
