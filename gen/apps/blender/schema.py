# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of Blender's own, made of what `frond describe --json` tells: for each kind of organism a group, at `object.frond_<kind>`.

They hold nothing: what they show is the preset with the root's changes, and what is set is recorded there. A property's name is its
path, as in grammar__angle. Below a list it is that of the element that `<list>__index` chooses; as JSON it is
`<list>__element`, and the whole `<list>__text`.
"""
import dataclasses
import json
import math
import re

import bpy

from . import presets, state

NUMBERS = {"number", "whole number", "[a, b]", "[x, y, z]"}
SIMPLE = NUMBERS | {"colour", "name", "text", "true or false"}
LISTED = {"colours": "colour", "texts": "text", "numbers": "number", "whole numbers": "whole number", "names": "text"}
COMMON = "organism"  # what all kinds have


@dataclasses.dataclass
class Property:
    path: tuple  # of names; a list's element is "*"
    kind: str  # one of SIMPLE, "object", or "json" for all else
    sentence: str = ""
    low: float = -1e6
    high: float = 1e6
    unit: str = ""
    default: object = None
    choices: dict = dataclasses.field(default_factory=dict)
    many: bool = False  # a list, of which one element is shown
    text: bool = False  # whether it may be something else than its kind, and then is shown as JSON
    parts: list = dataclasses.field(default_factory=list)

    @property
    def name(self):
        return "__".join(step for step in self.path if step != "*")

    @property
    def label(self):
        words = next(step for step in reversed(self.path) if step != "*").replace("_", " ").capitalize()
        return f"{words} ({self.unit})" if self.unit not in ("", "m", "degrees") else words

    @property
    def factor(self):
        """By which Blender's values differ: its angles are radians."""
        return math.pi / 180 if self.unit == "degrees" else 1


def read_one(entry, path):
    """A Property of what the program tells of it."""
    kind, many = entry["kind"], entry["kind"].startswith("list of ")
    of = kind[len("list of "):] if many else kind.split(" or keyframes")[0]
    of = LISTED.get(of, "object" if of == "objects" else of)
    found = Property(path + (("*",) if many else ()), of if of in SIMPLE or of == "object" else "json", entry["sentence"],
                     unit=entry.get("unit", ""), choices=entry.get("choices", {}), many=many,
                     text=many or of != kind, default=json.loads(entry["default"]) if "default" in entry else None)
    numbers = re.findall(r"-?[\d.]+(?:e[+-]?\d+)?", entry.get("range", ""))
    if len(numbers) == 2:
        found.low, found.high = map(float, numbers)
    return found


def read_kinds(described):
    """The properties of each kind of organism, by its name: a tree of those that it shows at its top."""
    tops, trees = {}, {}
    for entry in described:
        kind, *names = entry["path"].split("/")
        if not names or kind in ("film", "scene", "events", "plan", "stand", "reef") or names in (["kind"], ["species"], ["name"]):
            continue
        above = trees.get((kind, *names[:-1]))
        one = read_one(entry, (above.path if above else ()) + (names[-1],))
        trees[(kind, *names)] = one
        (above.parts if above else tops.setdefault(kind, [])).append(one)
    common = tops.pop(COMMON, [])
    return {kind: own + common for kind, own in tops.items()}


def all_of(properties):
    for one in properties:
        yield one
        yield from all_of(one.parts)


def pointer(group, one, whole=False):
    """Where a property of the organism that is shown stands in its preset; None in a list without elements."""
    root = group.id_data
    found, path = f"/organisms/{int(root.frond.entry or 0)}", one.path
    for i, step in enumerate(path[:-1] if whole and one.many else path):
        if step == "*":
            there = presets.value_at(state.document(root), found)
            if not isinstance(there, list) or not there:
                return None
            index = getattr(group, "__".join(s for s in path[:i] if s != "*") + "__index")
            step = str(min(index, len(there) - 1))
        found += "/" + step
    return found


def value_of(group, one, whole=False):
    at = pointer(group, one, whole)
    found = presets.value_at(state.document(group.id_data), at) if at else None
    return one.default if found is None and not (one.many and not whole) else found


def to_blender(one, value):
    """A value as Blender's property has it; what does not fit becomes the least one."""
    def number(v):
        fits = isinstance(v, (int, float)) and not isinstance(v, bool)
        return min(max(v if fits else 0, one.low), one.high) * one.factor
    if one.kind in ("number", "whole number"):
        return int(max(min(number(value), 2**31 - 1), -2**31)) if one.kind == "whole number" else number(value)
    if one.kind == "true or false":
        return value is True
    if one.kind == "name":
        return list(one.choices).index(value) if value in one.choices else 0
    if one.kind == "text":
        return value if isinstance(value, str) else ""
    if one.kind == "colour" and isinstance(value, str) and re.fullmatch("#[0-9a-fA-F]{6}", value):
        return [int(value[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    size = 2 if one.kind == "[a, b]" else 3
    return [number(v) for v in value] if isinstance(value, list) and len(value) == size else [0.0] * size


def from_blender(one, value):
    def rounded(v):
        return float(f"{v / one.factor:.6g}")
    if one.kind == "name":
        return list(one.choices)[value]
    if one.kind == "number":
        return rounded(value)
    if one.kind == "colour":
        return "#" + "".join(f"{round(255 * v):02x}" for v in value)
    return [rounded(v) for v in value] if one.kind in NUMBERS - {"whole number"} else value


def shows(group, one):
    """Whether the value that counts is of the property's own kind, so that its control can show it."""
    value = value_of(group, one)
    if one.kind == "object":
        return bool(one.parts) and (value is None or isinstance(value, dict))
    if one.kind in SIMPLE and one.text:  # a list's element, or what may be keyframes
        numbers = value if isinstance(value, list) else [value]
        return one.kind not in NUMBERS or value is None or all(isinstance(v, (int, float)) for v in numbers) and (
            isinstance(value, list) == one.kind.startswith("["))
    return one.kind in SIMPLE


def control(one):
    """The property of Blender for a value of a simple kind."""
    def get(self):
        return to_blender(one, value_of(self, one))

    def set_(self, value):
        at = pointer(self, one)
        if at:
            state.record(self.id_data, at, from_blender(one, value))

    said = {"name": one.label, "description": one.sentence, "get": get, "set": set_}
    unit = {"m": "LENGTH", "degrees": "ROTATION"}.get(one.unit, "NONE")
    low, high = one.low * one.factor, one.high * one.factor
    if one.kind == "number":
        slides = "FACTOR" if (one.low, one.high) == (0, 1) else "NONE"
        return bpy.props.FloatProperty(**said, min=low, max=high, unit=unit, subtype=slides, precision=3, step=step(one))
    if one.kind == "whole number":
        return bpy.props.IntProperty(**said, min=int(max(low, -2**31)), max=int(min(high, 2**31 - 1)))
    if one.kind == "true or false":
        return bpy.props.BoolProperty(**said)
    if one.kind == "name":
        return bpy.props.EnumProperty(**said, items=[(choice, choice, doc) for choice, doc in one.choices.items()])
    if one.kind == "text":
        return bpy.props.StringProperty(**said)
    if one.kind == "colour":
        return bpy.props.FloatVectorProperty(**said, size=3, subtype="COLOR_GAMMA", min=0, max=1)
    return bpy.props.FloatVectorProperty(**said, size=2 if one.kind == "[a, b]" else 3, min=low, max=high, unit=unit, precision=3)


def step(one):
    """Of a click on a control's arrow, in hundredths as Blender wants it: a tenth of what the default is about."""
    usual = abs(one.default) if isinstance(one.default, (int, float)) and one.default else 0.1
    return max(1, round(100 * one.factor * 10 ** (math.floor(math.log10(usual)) - 1)))


def text_control(one, whole):
    """A value as JSON, for what no control of Blender's shows. What is no JSON is taken as text, and the program tells."""
    def get(self):
        value = value_of(self, one, whole)
        return value if isinstance(value, str) else "" if value is None else json.dumps(value)

    def set_(self, text):
        at = pointer(self, one, whole)
        try:
            value = json.loads(text)
        except ValueError:
            value = text
        if at:
            state.record(self.id_data, at, value)

    return bpy.props.StringProperty(name=one.label, description=one.sentence, get=get, set=set_)


def make_class(kind, properties):
    made = {}
    for one in all_of(properties):
        if one.kind in SIMPLE:
            made[one.name] = control(one)
        if one.text or one.kind in ("object", "json"):
            made[one.name + "__text"] = text_control(one, whole=True)
        if one.kind == "object" or one.parts:
            made[one.name + "__open"] = bpy.props.BoolProperty(name=one.label, description=one.sentence)
        if one.many:
            made[one.name + "__element"] = text_control(one, whole=False)
            made[one.name + "__index"] = bpy.props.IntProperty(name="Number", description=f"Which is shown. {one.sentence}", min=0)
    return type(f"FROND_{kind}", (bpy.types.PropertyGroup,), {"__annotations__": made})


KINDS = {}  # properties by name of the kind
_classes = {}


def register():
    """Makes the groups of the program that there is now; nothing without one."""
    program = state.program()
    if not program or KINDS:
        return
    KINDS.update(read_kinds(presets.descriptions(program)))
    for kind, properties in KINDS.items():
        _classes[kind] = make_class(kind, properties)
        bpy.utils.register_class(_classes[kind])
        setattr(bpy.types.Object, f"frond_{kind}", bpy.props.PointerProperty(type=_classes[kind]))


def unregister():
    for kind, one in _classes.items():
        delattr(bpy.types.Object, f"frond_{kind}")
        bpy.utils.unregister_class(one)
    KINDS.clear()
    _classes.clear()
