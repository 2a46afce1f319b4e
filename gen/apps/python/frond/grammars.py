"""Grammars: L-systems, and what their turtle draws."""

import json
import os
from typing import Any, Mapping, Optional, Union

from . import _frond
from ._frond import CpfgModel


class Grammar(_frond.Grammar):
    """An L-system, compiled.

    `Grammar({"axiom": "A", "rules": ["A -> AB", "B -> A"], "steps": 5})` takes the properties of a grammar file as a
    mapping or as JSON text; `Grammar.read` takes a file.
    """

    def __init__(self, grammar: Union[str, Mapping[str, Any]], name: str = "grammar.json",
                 assets: Optional["os.PathLike[str]"] = None) -> None:
        super().__init__(grammar if isinstance(grammar, str) else json.dumps(grammar), name, assets)

    @classmethod
    def read(cls, path: Union[str, "os.PathLike[str]"]) -> Any:
        """The grammar of a file: JSON, or of LParser (.ls) or Houdini (.txt); of a .l the model of cpfg, with what it names."""
        if os.fspath(path).endswith(".l"):
            return CpfgModel(path)
        return cls(_frond.read_text(path), os.fspath(path))
