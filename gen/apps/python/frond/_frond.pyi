"""The types of the shared module. Arrays are read-only views; lengths are metres."""

import os
from typing import Any, Callable, Dict, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

Path = Union[str, "os.PathLike[str]"]
__version__: str

def limit_threads(count: int) -> None:
    """How many threads growing uses from now on; 0: as many as there are processors."""

def set_home(folder: Path) -> None:
    """Where presets that come with Frond are found by their names, unless $FROND_HOME says it."""

class Skeleton:
    """Branches, an entry a node; `len()` is their number. A segment runs from a node's parent to the node."""

    def __len__(self) -> int: ...
    @property
    def position(self) -> NDArray[np.float32]:
        """(nodes, 3), metres."""
    @property
    def radius(self) -> NDArray[np.float32]:
        """(nodes,), metres."""
    @property
    def parent(self) -> NDArray[np.int32]:
        """(nodes,), before the node itself; -1 at a root."""
    @property
    def distance(self) -> NDArray[np.float32]:
        """(nodes,), metres along the branches from the root."""
    @property
    def to_tip(self) -> NDArray[np.float32]:
        """(nodes,), metres along the branches to the farthest tip above."""
    @property
    def birth(self) -> NDArray[np.float32]:
        """(nodes,), 0..1: the share of growth after which the node is there."""
    @property
    def order(self) -> NDArray[np.uint16]:
        """(nodes,), depth of branching: 0 on the trunk."""

class Mesh:
    """Triangles with a normal at each vertex, counter-clockwise seen from outside; `len()` is their number."""

    def __len__(self) -> int: ...
    @property
    def position(self) -> NDArray[np.float32]:
        """(vertices, 3), metres."""
    @property
    def normal(self) -> NDArray[np.float32]:
        """(vertices, 3), of length 1."""
    @property
    def triangle(self) -> NDArray[np.uint32]:
        """(triangles, 3), indices of vertices."""
    @property
    def uv(self) -> Optional[NDArray[np.float32]]:
        """(vertices, 2), or None."""

class Organs:
    """Leaves, flowers, berries: an entry an organ."""

    def __len__(self) -> int: ...
    @property
    def prototype(self) -> NDArray[np.uint16]:
        """(organs,), index into the organism's `prototypes`."""
    @property
    def position(self) -> NDArray[np.float32]:
        """(organs, 3), metres."""
    @property
    def turn(self) -> NDArray[np.float32]:
        """(organs, 4), quaternions x, y, z, w from the prototype's axes to the world's."""
    @property
    def scale(self) -> NDArray[np.float32]:
        """(organs, 3), along the prototype's axes."""
    @property
    def node(self) -> NDArray[np.int32]:
        """(organs,), the node that it is attached to, or -1."""
    @property
    def birth(self) -> NDArray[np.float32]:
        """(organs,), 0..1, as that of a node."""
    @property
    def color(self) -> NDArray[np.int32]:
        """(organs,), index of a colour, taken cyclically."""

class Bodies:
    """Bodies without branches: each shape once, and where it is placed; `len()` is the number of placements."""

    def __len__(self) -> int: ...
    @property
    def shapes(self) -> List[Mesh]: ...
    @property
    def shape(self) -> NDArray[np.uint16]:
        """(placements,), index into `shapes`."""
    @property
    def position(self) -> NDArray[np.float32]:
        """(placements, 3), metres."""
    @property
    def turn(self) -> NDArray[np.float32]:
        """(placements, 4), quaternions x, y, z, w."""
    @property
    def scale(self) -> NDArray[np.float32]:
        """(placements, 3)."""
    def merged(self) -> Mesh:
        """All placements as one mesh."""

class Pose:
    """An organism's branches at one time."""

    @property
    def skeleton(self) -> Skeleton:
        """The branches at rest as they have grown by then; the arrays below have an entry for each of its nodes."""
    @property
    def position(self) -> NDArray[np.float32]:
        """(nodes, 3), metres. Nodes that growth has not reached lie at the tip of their branch."""
    @property
    def radius(self) -> NDArray[np.float32]:
        """(nodes,), metres."""
    @property
    def turn(self) -> NDArray[np.float32]:
        """(nodes, 4), quaternions x, y, z, w from the shape at rest to the pose."""
    @property
    def front(self) -> float:
        """Nodes whose `birth` is less have been reached."""

class Organism:
    """A plant, a coral or a body at its place, fully grown and at rest."""

    @property
    def name(self) -> str: ...
    @property
    def entry(self) -> Optional[int]:
        """Which of the preset's `organisms` it is of; None: of the setting."""
    @property
    def skeleton(self) -> Skeleton: ...
    @property
    def organs(self) -> Organs: ...
    @property
    def prototypes(self) -> List[str]:
        """Names of the shapes of its organs."""
    @property
    def bodies(self) -> Bodies: ...
    @property
    def blades(self) -> Mesh:
        """Filled outlines of the turtle."""
    def pose(self, time: float) -> Pose:
        """Its branches at a time, in seconds from the first frame."""

class Figure:
    """What the turtle draws of a word."""

    @property
    def skeleton(self) -> Skeleton: ...
    @property
    def color(self) -> NDArray[np.int32]:
        """(nodes,), index of a colour."""
    @property
    def outlines(self) -> List[NDArray[np.float32]]:
        """Filled polygons, (points, 3) each."""
    @property
    def sites(self) -> Dict[str, List[Any]]:
        """Where organs belong: lists of `name`, `position`, `heading` and `node`."""

class Word:
    """A word of modules; `len()` is their number and `str()` its text."""

    def __len__(self) -> int: ...
    @property
    def symbols(self) -> NDArray[np.uint8]:
        """(modules,), index into `names`."""
    @property
    def parameters(self) -> NDArray[np.float64]:
        """Those of all modules, one after another."""
    @property
    def names(self) -> List[str]:
        """Names of the symbols."""
    @property
    def counts(self) -> Dict[str, int]:
        """How often each name occurs."""

class Grammar:
    def __init__(self, text: str, name: str = ..., assets: Optional[Path] = ...) -> None: ...
    @property
    def steps(self) -> int:
        """Derivation steps that it asks for."""
    @property
    def angle(self) -> float:
        """Degrees, of a turn that has no parameter."""
    def derive(self, steps: Optional[int] = ..., seed: Optional[int] = ...) -> Word:
        """The word after so many steps, those of the grammar unless they are given."""
    def draw(self, steps: Optional[float] = ..., seed: Optional[int] = ...) -> Figure:
        """What the turtle draws; a fractional number of steps gives a shape in between."""
    def picture(self, steps: Optional[float] = ..., seed: Optional[int] = ...) -> str:
        """The drawing seen along z, as SVG."""
    def tree(self, steps: Optional[int] = ..., seed: Optional[int] = ...) -> str:
        """The derivation tree, as SVG."""

class CpfgWord:
    """A word of a model of cpfg."""
    def __len__(self) -> int: ...
    def __str__(self) -> str: ...
    @property
    def counts(self) -> Dict[str, int]:
        """How often each letter occurs."""

class CpfgModel:
    """A model of the program cpfg, derived as it derives it: its seed, angle and colours are in its own files."""
    def __init__(self, path: Path) -> None: ...
    @property
    def steps(self) -> int:
        """Its derivation length."""
    @property
    def notes(self) -> List[str]:
        """What has no effect, as a rule that can never match."""
    def derive(self, steps: Optional[int] = ...) -> CpfgWord:
        """The word after so many steps, those of the model unless they are given."""
    def draw(self, steps: Optional[int] = ...) -> Figure:
        """What its turtle draws, in its own units: branches, polygons as outlines, and where its surfaces stand as sites."""
    def picture(self, steps: Optional[int] = ...) -> str:
        """What its turtle draws, seen along the z axis, as SVG."""

class Scene:
    organisms: List[Organism]
    notes: List[str]
    nodes: int
    def time(self, frame: int) -> float: ...
    def meshes(self, frame: Optional[int], detail: float, sides: int) -> List[Tuple[str, str, Tuple[float, float, float], Mesh]]: ...
    def write(self, path: Path, frame: Optional[int], detail: float, sides: int, texture: int, voxel: float, instances: bool,
              levels: int, home: Path, cache: Path) -> List[str]: ...

class ReadPreset:
    title: str
    seed: int
    text: str
    frames: int
    fps: float
    size: Tuple[int, int]
    notes: List[Tuple[str, str]]
    def __init__(self, text: str, name: str, sets: List[str], assets: Optional[Path]) -> None: ...

def grow(preset: ReadPreset, progress: Optional[Callable[[str, int, int], None]]) -> Scene: ...
def grammars_in(preset: ReadPreset) -> List[Grammar]: ...
def read_text(path: Path) -> str: ...
def pretty(text: str) -> str: ...
def schema() -> str: ...
def kinds() -> Dict[str, str]:
    """The kinds of organisms, with a sentence on each."""

def settings() -> Dict[str, str]:
    """The settings, with a sentence on each."""

class Render:
    def next(self) -> Optional[Tuple[str, int, int]]: ...
    def stop(self) -> None: ...
    @property
    def files(self) -> "List[os.PathLike[str]]": ...
    @property
    def fault(self) -> str: ...

def render(text: Optional[str], file: str, sets: List[Tuple[str, str]], assets: Optional[Path], folder: str,
           frames: Optional[List[int]], format: str, jobs: int, program: Path) -> Render: ...
