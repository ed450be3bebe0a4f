"""The answers of a pose: motions, forces, and mappings that read each of them on demand."""
from __future__ import annotations

from typing import Any, Callable, Generic, Iterator, Mapping, NamedTuple, TypeVar

from ._core import nearest
from ._problems import UnknownName, refusal

T = TypeVar("T")


class Motion(NamedTuple):
    """Motion of a coordinate or of a body's angle, m or rad; rates are NaN where they are undefined."""

    position: float
    velocity: float
    acceleration: float


class PointMotion(NamedTuple):
    """Motion of a point in world axes, m."""

    position: tuple[float, float]
    velocity: tuple[float, float]
    acceleration: tuple[float, float]


class Reaction(NamedTuple):
    """The force and moment of a joint's first body on its second, in world axes, N and N m."""

    by: str
    on: str
    force: tuple[float, float]
    moment: float
    is_determinate: bool


class Effort(NamedTuple):
    """The effort along a coordinate, N m or N; `low` and `high` differ if dry friction at rest leaves it open."""

    value: float
    low: float
    high: float


class Energy(NamedTuple):
    """Energies, J."""

    kinetic: float
    potential: float


class Named(Mapping[str, T], Generic[T]):
    """Answers by name, each read on demand."""

    __slots__ = ("_names", "_read", "_kind", "_keep")

    def __init__(self, names: Mapping[str, Any], read: Callable[[Any], T], kind: str, keep: object) -> None:
        self._names, self._read, self._kind = names, read, kind
        self._keep = keep  # the pose, whose memory is reused once it is gone

    def __getitem__(self, name: str) -> T:
        try:
            key = self._names[name]
        except (KeyError, TypeError):
            near = nearest(str(name), self._names)
            raise refusal(UnknownName, "E0814", f"the machine has no {self._kind} `{name}`",
                          f"did you mean `{near}`?" if near else None) from None
        return self._read(key)

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {self[name]!r}" for name in self) + "}"
