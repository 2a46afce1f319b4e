"""What is wrong with a preset or a grammar."""

from typing import NamedTuple


class Fault(NamedTuple):
    """One mistake: `file:line:column: /json/pointer`, or empty, and what was found and expected."""

    where: str
    what: str

    def __str__(self) -> str:
        return f"{self.where}: {self.what}" if self.where else self.what


class FrondError(ValueError):
    """A preset, a grammar or a call that cannot be used, with all its faults."""

    def __init__(self, faults: "list[Fault]") -> None:
        super().__init__("\n".join(map(str, faults)))
        self.faults = faults
