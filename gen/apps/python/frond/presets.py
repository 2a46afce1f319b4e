"""Presets, and the scenes that grow from them."""

import json
import os
import pathlib
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Tuple, Union

from . import _frond
from .faults import Fault, FrondError
from .grammars import Grammar
from .home import cache, home

Path = Union[str, "os.PathLike[str]"]
Progress = Callable[[str, int, int], None]


class Part(NamedTuple):
    """A mesh of one material, where it stands."""

    organism: str
    """The name of what it belongs to."""
    material: str
    color: Tuple[float, float, float]
    """sRGB, 0..1."""
    mesh: _frond.Mesh


class Scene:
    """All that stands before the camera of a preset, grown."""

    def __init__(self, grown: _frond.Scene) -> None:
        self._grown = grown
        self.organisms: List[_frond.Organism] = grown.organisms
        """Plants, corals and bodies, each where it stands; of what is sown only the copies are drawn, so it is not here."""
        self.notes: List[str] = grown.notes

    def __getitem__(self, name: str) -> List[_frond.Organism]:
        """The organisms of that name."""
        found = [organism for organism in self.organisms if organism.name == name]
        if not found:
            raise KeyError(name)
        return found

    @property
    def nodes(self) -> int:
        """The number of nodes of all skeletons."""
        return self._grown.nodes

    def time(self, frame: int) -> float:
        """Seconds from the first frame, which is number 1."""
        return self._grown.time(frame)

    def meshes(self, frame: Optional[int] = None, *, detail: float = 250_000, sides: int = 10) -> List[Part]:
        """Everything at a frame (the last unless it is given) as triangle meshes, as an export has them.

        `detail` is about how many triangles one organism may have, `sides` how many a tube has.
        """
        return [Part(*part) for part in self._grown.meshes(frame, detail, sides)]

    def export(self, path: Path, *, frame: Optional[int] = None, detail: float = 250_000, sides: int = 10,
               texture: int = 512, voxel: float = 0, instances: bool = False, levels: int = 1) -> List[str]:
        """Writes a .glb, .obj, .ply or .vdb; returns the names of what has not grown by then.

        The arguments are the options of `frond export`. Pictures need the files of Frond, see `FROND_HOME`.
        """
        files = home()
        return self._grown.write(path, frame, detail, sides, texture if files else 0, voxel, instances, levels,
                                 files or "", cache() / "materials")


class Preset:
    """A preset as it was read: checked, with every default in its place. It does not change; see `changed`."""

    def __init__(self, preset: Union[str, Mapping[str, Any]], name: Path = "preset.json", *,
                 values: Optional[Mapping[str, Any]] = None, assets: Optional[Path] = None) -> None:
        """`preset` is JSON text, or the same as a mapping; `name` tells messages, and where files are that it names."""
        self._source = preset if isinstance(preset, str) else json.dumps(preset)
        self._name = os.fspath(name)
        self._values: Dict[str, Any] = dict(values or {})
        self._assets = assets
        sets = [f"{pointer}={json.dumps(value)}" for pointer, value in self._values.items()]
        self._read = _frond.ReadPreset(self._source, self._name, sets, assets)
        self.title: str = self._read.title
        self.seed: int = self._read.seed
        self.frames: int = self._read.frames
        self.fps: float = self._read.fps
        self.size: Tuple[int, int] = self._read.size
        self.notes: List[Fault] = [Fault(*note) for note in self._read.notes]
        """What its author should know, although nothing is wrong."""
        self.document: Dict[str, Any] = json.loads(self._read.text)
        """What is written in it, as plain dictionaries and lists."""

    def __repr__(self) -> str:
        return f"<frond.Preset {self._name!r}: {self.title!r}, {self.frames} frames>"

    def __getitem__(self, pointer: str) -> Any:
        """The value at a JSON pointer (RFC 6901), as in `preset["/film/fps"]`."""
        value: Any = self.document
        for name in pointer.split("/")[1:]:
            name = name.replace("~1", "/").replace("~0", "~")
            value = value[int(name)] if isinstance(value, list) else value[name]
        return value

    def changed(self, values: Mapping[str, Any]) -> "Preset":
        """The same with other values at JSON pointers, as `--set` has it; read and checked anew."""
        return Preset(self._source, self._name, values={**self._values, **values}, assets=self._assets)

    def grow(self, progress: Optional[Progress] = None) -> Scene:
        """Grows the scene on all processors; other threads of Python go on.

        `progress(phase, done, all)` is called as it goes, from several threads; an exception in it ends the growing.
        """
        return Scene(_frond.grow(self._read, progress))

    def grammars(self) -> List[_frond.Grammar]:
        """Those of its plants, in their order."""
        return _frond.grammars_in(self._read)

    def save(self, path: Path) -> None:
        """Writes it with its changes. Files that it names are looked for from the new folder."""
        target = pathlib.Path(path)
        part = target.with_name(target.name + ".part")
        part.write_text(_frond.pretty(self._read.text), encoding="utf-8")
        part.replace(target)

    def source(self) -> Tuple[Optional[str], str, Dict[str, Any], Optional[Path]]:
        """What it was read from: its text, or None where that is in its file; the file; other values; the assets."""
        file = pathlib.Path(self._name)
        on_disk = file.is_file() and file.read_text(encoding="utf-8") == self._source
        return None if on_disk else self._source, self._name, self._values, self._assets


def read(path: Path, values: Optional[Mapping[str, Any]] = None, *, assets: Optional[Path] = None) -> Preset:
    """The preset of a file, with other values at JSON pointers.

    With `assets` no file is read but below the preset's own folder and this one.
    """
    return Preset(_frond.read_text(path), path, values=values, assets=assets)


def check(path: Path) -> List[Fault]:
    """What is wrong with a preset; empty where nothing is."""
    try:
        read(path)
    except FrondError as error:
        return error.faults
    return []


def schema() -> Dict[str, Any]:
    """The JSON Schema (draft-07) of presets."""
    found: Dict[str, Any] = json.loads(_frond.schema())
    return found
