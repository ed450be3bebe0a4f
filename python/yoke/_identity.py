"""The names and values of a machine, and its life: from a file or from calls until it is closed."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Mapping, Optional, TypeVar, Union

from . import _designs
from ._builder import Builder
from ._core import Core
from ._native import ffi, lib
from ._problems import ModelError, Problems, RequestError, refusal, text_of
from ._values import Value, encoded, named, si
from ._watch import check

PathLike = Union[str, "os.PathLike[str]"]
Values = Optional[Mapping[str, Value]]
Self = TypeVar("Self", bound="Identity")

_given_up: "list[Optional[Core]]" = []


class Identity(Builder):
    """A machine without its analyses: names, parameters, text, and everything that is computed from them once."""

    __slots__ = ("_kept", "_source")

    def __init__(self, name: str = "") -> None:
        super().__init__(name)
        self._kept: Optional[Core] = None
        self._source: Optional[tuple[str, str, dict[str, Value], Optional[str]]] = None

    @classmethod
    def _loaded(cls: "type[Self]", text: str, name: str, parameters: Mapping[str, Value], lock: Optional[str]) -> Self:
        machine = cls.__new__(cls)
        Builder.__init__(machine, None)
        machine._source, machine._kept = (text, name, dict(parameters), lock), None
        machine._ready()
        return machine

    # --- its life

    def _give_up(self, why: str) -> None:
        super()._give_up(why)
        _given_up.append(self._kept)  # half changed, so it is neither used nor freed
        self._kept = None

    def _changed(self) -> None:
        self._kept = None

    def _ready(self) -> Core:
        """Returns what was computed from the machine; loads it if that has not been done. The lock is held."""
        if self._kept is not None:
            return self._kept
        if self._gone:
            self._refuse()
        problems = Problems()
        if self._source is None:
            said = self._check_builder()
            if lib.yk_problems_error_count(said.c) > 0:
                raise said.fail(ModelError)
            core = Core(self._said(), "machine", {}, None, problems)
        else:
            text, name, parameters, lock = self._source
            core = Core(text, name, parameters, lock, problems)
        check()
        problems.warn(4)
        self._kept = core
        return core

    def close(self) -> None:
        """Frees the machine; every later use raises ClosedError. Poses and simulations made before stay as they are."""
        with self._lock:
            self._gone, self._kept, self._source, self._builder = "was closed", None, None, ffi.NULL

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __reduce__(self) -> Any:
        with self._lock:
            if self._source is not None:
                return type(self)._loaded, self._source
            if self._gone:
                self._refuse()
            return type(self)._loaded, (self._said(), "machine", {}, None)

    # --- what it is

    @property
    def name(self) -> str:
        """The machine's name."""
        with self._lock:
            return text_of(lib.yk_model_name(self._ready().model))

    @property
    def text(self) -> str:
        """The machine as a model file: read back, it is the same machine to the last bit."""
        with self._lock:
            return self._said() if self._source is None and not self._gone else text_of(
                lib.yk_model_text(self._ready().model))

    def write(self, path: PathLike) -> Path:
        """Writes the machine as a model file, which appears whole or not at all."""
        with self._lock:
            problems = Problems()
            status = lib.yk_model_write(self._ready().model, encoded(os.fspath(path)), problems.c)
            if status < 0:
                raise problems.fail(RequestError, status)
            return Path(path)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Names of the bodies, the ground first."""
        with self._lock:
            return tuple(self._ready().bodies)

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints."""
        with self._lock:
            return tuple(self._ready().joints)

    @property
    def points(self) -> tuple[str, ...]:
        """Names of the points, as "body.point"."""
        with self._lock:
            return tuple(self._ready().points)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        with self._lock:
            return tuple(self._ready().coordinates)

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of the coordinates that are inputs: driven, held or free."""
        with self._lock:
            return tuple(c.name for c in self._ready().coordinates.values() if c.input >= 0)

    @property
    def freedom(self) -> int:
        """Degrees of freedom, by rank if the machine could be assembled."""
        with self._lock:
            f = lib.yk_mechanism_freedom(self._ready().base)
            return int(f.by_rank if f.by_rank >= 0 else f.gruebler)

    def parameter_value(self, name: str) -> float:
        """Returns a parameter's value in SI."""
        with self._lock:
            return _designs.parameter(self._ready().model, name, lib.yk_model_parameter(self._ready().model,
                                                                                     encoded(name)))

    def value(self, text: str, kind: str = "length") -> float:
        """Returns a value with a unit in SI: value("30 deg", "angle"); other kinds are "length", "time", "force"."""
        quantity = getattr(lib, f"YK_QUANTITY_{str(kind).upper().replace('-', '_')}", None)
        if quantity is None:
            raise refusal(RequestError, "E0806", f"there is no kind of value `{kind}`")
        with self._lock:
            return si(self._ready().model, text, quantity, "text")

    def replace(self: Self, parameters: Values = None, **values: Value) -> Self:
        """Returns the machine with other values of its parameters, put together in the same configuration."""
        more = named(parameters, "parameters", values)
        with self._lock:
            self._ready()
            if self._source is None:
                return type(self)._loaded(self._said(), "machine", more, None)
            text, name, old, lock = self._source
            return type(self)._loaded(text, name, {**old, **more}, lock)

    def __repr__(self) -> str:
        if self._gone:
            return f"<yoke.Machine: {self._gone}>"
        try:
            return (f"<yoke.Machine {self.name!r}: {len(self.bodies) - 1} bodies, {len(self.joints)} joints, "
                    f"freedom {self.freedom}, inputs {', '.join(self.inputs) or 'none'}>")
        except Exception as error:
            return f"<yoke.Machine, not yet whole: {str(error).splitlines()[0]}>"
