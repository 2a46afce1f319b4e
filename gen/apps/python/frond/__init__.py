"""Frond grows plants and corals from presets and films them with POV-Ray.

    import frond

    preset = frond.read("presets/trees/birch.json")
    young = preset.changed({"/organisms/0/years": 12})
    scene = young.grow()
    birch = scene.organisms[0]
    birch.skeleton.position        # (nodes, 3) float32, metres, y up: a view of the grown tree, no copy
    scene.export("birch.glb", frame=1)
    frond.render(young, "out/birch", size=(640, 360))

    grammar = frond.Grammar.read("presets/grammars/algae.json")
    str(grammar.derive(steps=6))

Lengths are metres, angles of presets degrees, times seconds. Arrays are of numpy and read-only: they share the memory
of what they were taken from, and keep it alive. A turn is a quaternion (x, y, z, w) of length 1.
"""

from ._frond import Bodies, CpfgModel, CpfgWord, Figure, Mesh, Organism, Organs, Pose, Skeleton, Word, __version__, kinds, limit_threads, settings
from ._frond import set_home as _set_home
from .faults import Fault, FrondError
from .grammars import Grammar
from .home import home as _home
from .presets import Part, Preset, Scene, check, read, schema
from .rendering import Render, render

if _folder := _home():
    _set_home(_folder)

__all__ = [
    "Bodies", "CpfgModel", "CpfgWord", "Fault", "Figure", "FrondError", "Grammar", "Mesh", "Organism", "Organs", "Part",
    "Pose", "Preset", "Render", "Scene", "Skeleton", "Word", "__version__", "check", "kinds", "limit_threads", "read", "render", "schema", "settings",
]
