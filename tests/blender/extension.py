"""Installs the extension for Blender and does with it what a user does: adds, changes, resets, cancels, gets messages.

  blender -b --python-exit-code 1 --python extension.py -- FROND FOLDER

Runs in the folder of Frond. Blender has no loop of events in the background, so the timer of the extension is called from here.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import tomllib
import zipfile

import addon_utils
import bpy

SMALL = "tests/presets/tiny_vases.json"


def install(folder):
    """The zip, unpacked as an add-on; tests what it holds."""
    shutil.rmtree(folder, ignore_errors=True)
    addons = pathlib.Path(folder, "scripts", "addons")
    addons.mkdir(parents=True)
    archives = [pathlib.Path(folder, name) for name in ("one.zip", "other.zip")]
    for archive in archives:
        subprocess.run(["scripts/blender_extension.sh", "-o", archive], check=True)
    assert archives[0].read_bytes() == archives[1].read_bytes()
    with zipfile.ZipFile(archives[0]) as archive:
        files = set(archive.namelist())
        manifest = tomllib.loads(archive.read("blender_manifest.toml").decode())
        archive.extractall(addons / "frond_blender")
    assert files == {"LICENSE", "blender_manifest.toml", *(file.name for file in pathlib.Path("gen/apps/blender").glob("*.py"))}, files
    sys.path.insert(0, str(addons))
    module = addon_utils.enable("frond_blender", default_set=True, handle_error=None)
    assert module and ".".join(map(str, module.bl_info["version"])) == manifest["version"]
    return module


def pump(frond, until=lambda: False, seconds=120):
    """Calls the timer until nothing is left to do."""
    end = time.monotonic() + seconds
    while frond.jobs.busy() and not until():
        assert time.monotonic() < end, "the program does not end"
        frond.jobs.tick()
        time.sleep(0.05)


def height(thing):
    return max(vertex.co.z for vertex in thing.data.vertices) - min(vertex.co.z for vertex in thing.data.vertices)


def counts():
    return [len(getattr(bpy.data, kind)) for kind in ("objects", "meshes", "materials", "images", "actions")]


def browse(frond):
    """Presets with pictures, and those that hold a word."""
    browser = bpy.context.window_manager.frond
    items = frond.state.browser_items(browser)
    assert len(items) > 100 and any(name == "trees/oak" for _, name, *_ in items)
    browser.filter = "sunflower"
    assert [name for _, name, *_ in frond.state.browser_items(browser)] == ["garden/wilting", "lsystems/sunflower-4", "species/plants/sunflower"]
    browser.filter = ""
    picture = frond.presets.pictures(pathlib.Path.cwd())["lsystems/sunflower-4"]
    assert picture.endswith("sunflower-4.jpg") and os.path.exists(picture)


def add(frond):
    """What was added, with its materials, at the cursor."""
    bpy.context.scene.cursor.location = (1, 2, 3)
    assert bpy.ops.frond.add(preset=SMALL) == {"FINISHED"}
    root = bpy.context.object
    root.frond.texture = 32
    assert frond.jobs.busy() and not root.children
    pump(frond)
    assert not root.frond.fault, root.frond.fault
    parts = {thing["frond_part"]: thing for thing in frond.scene.parts_of(root)}
    assert set(parts) == {"banded_body", "glass_body", "turned_body"}, parts.keys()
    assert tuple(root.location) == (1, 2, 3) and [c.name for c in root.users_collection] == ["tiny_vases"]
    for thing in parts.values():
        assert thing.data.materials[0] and thing.users_collection == root.users_collection
    textured = parts["turned_body"].data.materials[0].node_tree.nodes
    assert any(node.type == "TEX_IMAGE" and node.image.size[0] for node in textured)
    return root, parts


def change(frond, root, parts):
    """A slider that is drawn grows once; what was moved and given a material of one's own keeps both."""
    vase, group, own = parts["banded_body"], root.frond_vase, bpy.data.materials.new("mine")
    root.frond.texture = 0
    pump(frond)
    was, before = height(vase), counts()
    vase.location.x += 0.5
    vase.rotation_mode, vase.rotation_euler.z = "XYZ", 1
    bpy.context.view_layer.update()
    place, other = vase.matrix_world.copy(), parts["glass_body"].matrix_world.copy()
    vase.data.materials[0] = own
    group.height = 0.7
    group.height = 0.6
    assert abs(group.height - 0.6) < 1e-6 and frond.state.changes(root) == {"/organisms/0/height": 0.6}
    pump(frond)
    assert abs(height(vase) - 0.6) < 0.02 and abs(was - 0.6) > 0.05, (was, height(vase))
    bpy.context.view_layer.update()
    assert vase.matrix_world == place and parts["glass_body"].matrix_world == other
    assert vase.data.materials[0] == own
    now = counts()
    assert now[:2] == before[:2] and now[3:] == before[3:], f"data stays behind: {before}, {now}"
    return was


def kinds_of_properties(frond, root):
    """Each kind of property shows what counts, and records what it is set to."""
    group = root.frond_vase
    assert group.sides == 5 and group.material == "ceramic" and not group.body__open
    assert group.bands__motif == "meander"
    group.bands__index = 1
    assert group.bands__motif == "dots" and abs(group.bands__at - 0.2) < 1e-6
    group.bands__at = 0.4
    group.color = (1, 0.5, 0)
    group.profile__text = "[[0.05, 0], [0.1, 0.1]]"
    group.place__lean = 0.25
    changes = frond.state.changes(root)
    assert changes["/organisms/0/bands/1/at"] == 0.4 and changes["/organisms/0/color"] == "#ff8000", changes
    assert changes["/organisms/0/profile"] == [[0.05, 0], [0.1, 0.1]]
    assert abs(changes["/organisms/0/place/lean"] - 14.3239) < 1e-3, changes  # angles are radians in Blender
    for at in list(changes):
        if at != "/organisms/0/height":
            bpy.ops.frond.reset(pointer=at)
    assert frond.state.changes(root) == {"/organisms/0/height": 0.6}
    assert group.bands__index == 1 and abs(group.bands__at - 0.2) < 1e-6
    seed = root.frond.seed
    bpy.ops.frond.dice()
    assert root.frond.seed != seed and frond.state.changes(root)["/seed"] == root.frond.seed
    pump(frond)
    assert not root.frond.fault, root.frond.fault


def wrong_value(frond, root, parts):
    """The program's message at the property, the mesh as it was; a reset takes both back."""
    mesh = parts["banded_body"].data
    root.frond_vase.profile__text = "[]"
    pump(frond)
    assert "expected a list of 2" in frond.state.fault_at(root, "/organisms/0/profile"), root.frond.fault
    assert not frond.state.fault_at(root, "/organisms/0/height") and parts["banded_body"].data == mesh
    bpy.ops.frond.reset(pointer="")
    pump(frond)
    assert not root.frond.fault and frond.state.changes(root) == {}


def cancel(frond, root):
    """A job that is ended leaves all as it was; one of a first growing leaves nothing."""
    before = counts()
    bpy.ops.frond.grow()
    frond.jobs.tick()
    assert frond.jobs.progress(root).startswith("Growing")
    bpy.ops.frond.cancel()
    assert not frond.jobs.busy() and counts() == before
    browser = bpy.context.window_manager.frond
    browser.preset = os.path.abspath("presets/garden/vases.json")
    assert browser.only == frond.state.ALL
    browser.only = "pot"
    browser.preset = os.path.abspath("presets/lsystems/sunflower-4.json")  # which has no pot
    assert browser.only == frond.state.ALL
    browser.only = "sunflower"
    bpy.ops.frond.add()
    assert bpy.context.object.frond.only == "sunflower"
    frond.jobs.tick()
    bpy.ops.frond.cancel()
    assert not frond.jobs.busy() and counts() == before


class Layout:
    """In place of Blender's layout, which needs a window: draws nothing, but finds each property and its value."""
    def __init__(self, drawn):
        self.drawn = drawn

    def prop(self, owner, name, **_):
        assert owner.bl_rna.properties[name].name, name
        self.drawn[name] = getattr(owner, name)

    def __getattr__(self, name):
        return lambda *_, **__: Layout(self.drawn)


def panels(frond):
    """All that the sidebar draws of some presets, with every group open and one property found by its name."""
    for name in ("reef", "trees/oak", "garden/garden", "lsystems/sunflower-4", "ivy/column", "shells"):
        root = frond.panel.make_root(bpy.context, os.path.abspath(f"presets/{name}.json"))
        for entry, organism in enumerate(frond.presets.organisms(root.frond.preset)):
            root.frond.entry = str(entry)
            group, drawn = getattr(root, f"frond_{organism['kind']}"), {}
            for one in frond.schema.all_of(frond.schema.KINDS[organism["kind"]]):
                if one.parts:
                    setattr(group, f"{one.name}__open", True)
            panel = type("Panel", (), {"layout": Layout(drawn)})
            for kind in (frond.panel.FROND_PT_add, frond.panel.FROND_PT_root):
                kind.draw(panel, bpy.context)
            assert {"preset", "seed", "count"} < drawn.keys() and len(drawn) > 50, drawn.keys()
            if name == "lsystems/sunflower-4":
                assert drawn["grammar__steps"] == 520 and drawn["organs__shape"] == "ball" and "A(1)" in drawn["grammar__rules__element"]
        frond.jobs.stop_all()
        frond.scene.remove(root)


def from_scripts(frond):
    """The function: one organism, what defaults bring, a film, a preset that is wrong."""
    before = counts()
    root, *grown = frond.grow(SMALL, {"/organisms/1/height": 0.5}, only="glass", texture=0)
    assert [thing["frond_part"] for thing in grown] == ["glass_body"] and abs(height(grown[0]) - 0.5) < 0.02
    frond.scene.remove(root)
    root, *grown = frond.grow("tests/presets/tiny_film.json", frame=6, film=True, texture=0)
    assert any(thing.type == "MESH" and thing.data.shape_keys for thing in grown)
    again = frond.grow(root.frond.preset, {"/film/fps": 5}, frame=6, film=True, texture=0, root=root)
    assert again == [root, *grown]
    frond.scene.remove(root)
    try:
        frond.grow(SMALL, {"/organisms/0/height": 99}, texture=0)
        raise AssertionError("a wrong value is taken")
    except ValueError as error:
        assert "/organisms/0/height: found 99" in str(error)
    assert counts() == before, (counts(), before)


def without_program(frond, found):
    """The preference wins; a program that is not there is told of."""
    settings = frond.state.preferences()
    settings.program = "/nowhere/frond"
    assert frond.state.program() is None and not frond.schema.KINDS
    try:
        bpy.ops.frond.add(preset=SMALL)
        raise AssertionError("grows without the program")
    except RuntimeError as error:
        assert "program frond" in str(error)
    settings.program = found
    assert frond.state.program() == found and "vase" in frond.schema.KINDS


def main(program, folder):
    os.environ["FROND_BIN"], os.environ["FROND_HOME"] = os.path.abspath(program), os.getcwd()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    frond = install(folder)
    frond.load_later()
    browse(frond)
    root, parts = add(frond)
    change(frond, root, parts)
    kinds_of_properties(frond, root)
    wrong_value(frond, root, parts)
    cancel(frond, root)
    panels(frond)
    from_scripts(frond)
    without_program(frond, os.path.abspath(program))
    addon_utils.disable("frond_blender", default_set=True)
    assert not hasattr(bpy.types.Object, "frond") and not hasattr(bpy.types.Object, "frond_vase")
    assert not hasattr(bpy.types, "FROND_PT_add")


main(*sys.argv[sys.argv.index("--") + 1:])
