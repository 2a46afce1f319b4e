# SPDX-License-Identifier: GPL-3.0-or-later
"""What grew as objects: a root, and below it the nodes of the .glb that the program wrote.

When it has grown again, objects stay and get new meshes. Each remembers, as properties of its own, its name in the file, where it stood
as imported and which materials it had then, so what the user has moved or given another material is known and kept.
"""
import re

import bpy
from mathutils import Matrix

PART, PLACE, MATERIALS = "frond_part", "frond_place", "frond_materials"
KINDS = "objects", "meshes", "materials", "images", "actions"


def make_root(name, preset):
    """An empty at the 3D cursor, in a collection of its own."""
    collection = bpy.data.collections.new(name)
    bpy.context.scene.collection.children.link(collection)
    root = bpy.data.objects.new(name, None)
    root.empty_display_size = 0.1
    root.location = bpy.context.scene.cursor.location
    root["frond_collection"] = collection.name
    root.frond.preset = preset
    collection.objects.link(root)
    return root


def collection_of(root):
    return next((c for c in root.users_collection if c.name == root.get("frond_collection")), root.users_collection[0])


def parts_of(root):
    return [thing for thing in root.children_recursive if PART in thing]


def remove(root):
    """Takes a root and all that grew below it away."""
    collection = collection_of(root)
    things = [*parts_of(root), root]
    unused = data_of(things)
    for thing in things:
        bpy.data.objects.remove(thing)
    drop(unused)
    if not collection.all_objects:
        bpy.data.collections.remove(collection)


def base_name(name):
    return re.sub(r"\.\d{3,}$", "", name)


def import_glb(file):
    """The objects of a file. What is selected stays so."""
    layer = bpy.context.view_layer
    selected, active, before = [*layer.objects.selected], layer.objects.active, set(bpy.data.objects)
    if bpy.app.version < (3, 6):  # its importer uses names that numpy no longer has
        import numpy
        for name, kind in (("bool", bool), ("int", int), ("float", float), ("object", object)):
            if name not in vars(numpy):
                setattr(numpy, name, kind)
    bpy.ops.import_scene.gltf(filepath=file)
    for thing in [*layer.objects.selected]:
        thing.select_set(False)
    for thing in selected:
        thing.select_set(True)
    layer.objects.active = active
    return [thing for thing in bpy.data.objects if thing not in before]


def put(root, file):
    """Takes in what grew, in place of what stood there; returns its objects."""
    old = {thing[PART]: thing for thing in parts_of(root)}
    unused = data_of(old.values())
    into, fresh = collection_of(root), import_glb(file)
    became = {}  # the object that stays, by the one that was imported
    for new in fresh:
        part = base_name(new.name)
        there = old.get(part)
        keeps = there is not None and there.type == new.type
        became[new] = old.pop(part) if keeps else new
        new[PART] = part
    places = {new: new.matrix_local.copy() for new in fresh}
    parents = {new: became.get(new.parent, root) for new in fresh}
    for new in fresh:
        kept = became[new]
        if kept is new:
            link_to(new, into)
            set_materials(new, [])
        else:
            take_over(kept, new)
        stand(kept, parents[new], places[new], kept is new)
    for thing in [*old.values(), *(new for new in fresh if became[new] is not new)]:
        bpy.data.objects.remove(thing)
    drop(unused)
    root.frond.fault = ""
    return sorted(became.values(), key=lambda thing: thing[PART])


def link_to(thing, collection):
    for other in thing.users_collection:
        other.objects.unlink(thing)
    collection.objects.link(thing)


def take_over(kept, new):
    """Gives an object the mesh that was imported, with the materials that the user had given it."""
    if new.type != "MESH":
        return
    theirs = overrides(kept)
    kept.data = new.data
    set_materials(kept, theirs)


def overrides(thing):
    """The user's own materials, by the names of those in whose place they are: those of other names than were imported."""
    was = thing.get(MATERIALS, [])
    slots = [slot.material if slot.link == "DATA" else None for slot in thing.material_slots]
    return [(base_name(name), theirs) for name, theirs in zip(was, slots) if theirs and theirs.name != name]


def set_materials(thing, theirs):
    if thing.type != "MESH":
        return
    imported = thing.data.get(MATERIALS) or [m.name if m else "" for m in thing.data.materials]
    thing.data[MATERIALS] = imported  # of a mesh that several share
    thing[MATERIALS] = imported
    for i, name in enumerate(imported):
        for instead_of, material in theirs:
            if instead_of == base_name(name):
                thing.data.materials[i] = material


def stand(thing, parent, place, is_new):
    """Where it stood as imported it follows what grew; what was moved stays where it is."""
    was = thing.get(PLACE)
    moved = not is_new and was is not None and any(abs(a - b) > 1e-5 for a, b in zip(was, flat(thing.matrix_basis)))
    if thing.parent is not parent:
        thing.parent = parent
        thing.matrix_parent_inverse = Matrix()
    if not moved:
        thing.matrix_basis = place
    thing[PLACE] = flat(place)


def flat(matrix):
    return [value for row in matrix for value in row]


def data_of(things):
    """Meshes of objects, with their materials, pictures and motion."""
    found = {kind: set() for kind in KINDS}
    for thing in things:
        if thing.type != "MESH":
            continue
        mesh, names = thing.data, set(thing.get(MATERIALS, []))
        found["meshes"].add(mesh)
        found["materials"] |= {m for m in mesh.materials if m and m.name in names}
        keys = mesh.shape_keys
        if keys and keys.animation_data:
            strips = [strip.action for track in keys.animation_data.nla_tracks for strip in track.strips]
            found["actions"] |= {action for action in (keys.animation_data.action, *strips) if action}
    for material in found["materials"]:
        nodes = material.node_tree.nodes if material.use_nodes else []
        found["images"] |= {node.image for node in nodes if node.type == "TEX_IMAGE" and node.image}
    return found


def drop(data):
    """Removes what nothing uses any more."""
    for kind in KINDS:
        for one in data[kind]:
            if one.users == 0:
                getattr(bpy.data, kind).remove(one)

