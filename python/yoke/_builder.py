"""The builder: a machine made by calls, with the contents of a model file."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence, TypeVar, Union

from ._guard import Guarded
from ._native import ffi, lib
from ._problems import Problems, RequestError, refusal, text_of
from ._values import CData, Value, encoded, named, number, words

Self = TypeVar("Self", bound="Builder")
Point = Union[Sequence[Value], "tuple[Value, Value]"]


def scalar(value: Any, name: str) -> str:
    """Returns a value as a model file writes it: SI numbers, expressions with units, lists, maps."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str) and not isinstance(value[0], str):
        return words((value[0], value[1]), name)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{k}: {scalar(v, name)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(scalar(v, name) for v in value) + "]"
    return repr(number(value, name))


class Builder(Guarded):
    """The calls that make a machine. Each returns the machine, so that calls can be chained.

    Numbers are in the machine's own units, SI and radians unless `units` says otherwise; strings are expressions of
    parameters with units, as in a model file: "30 deg", "l1 + l2", "20 rpm * t".
    """

    __slots__ = ("_builder",)

    def __init__(self, name: Optional[str]) -> None:
        super().__init__()
        self._builder: CData = ffi.NULL
        if name is not None:
            c = lib.yk_builder_new(encoded(name, "name") if name else ffi.NULL)
            if c == ffi.NULL:
                raise MemoryError("out of memory")
            self._builder = ffi.gc(c, lib.yk_builder_free)

    def _changed(self) -> None:
        """Forgets what was computed from the machine before a change."""
        raise NotImplementedError

    def _edit(self) -> CData:
        """Returns the builder of a machine that calls can change."""
        if self._gone:
            self._refuse()
        if self._builder == ffi.NULL:
            raise refusal(RequestError, "E0806", "a machine that was loaded is not changed by calls",
                          "yoke.load and replace take parameters; yoke.Machine() begins an empty machine")
        self._changed()
        return self._builder

    def set(self: Self, path: str, value: Any) -> Self:
        """Sets any key of the format by its path, for example set("springs/k/damping", "5 N*s/m")."""
        with self._lock:
            builder = self._edit()
            if not isinstance(value, (bool, str)) and hasattr(value, "__float__"):
                lib.yk_builder_set_number(builder, encoded(path, "path"), number(value, path))
            else:
                lib.yk_builder_set(builder, encoded(path, "path"), encoded(scalar(value, path)))
        return self

    def remove(self: Self, path: str) -> Self:
        """Removes a key with everything in it, if it exists."""
        with self._lock:
            lib.yk_builder_remove(self._edit(), encoded(path, "path"))
        return self

    def _set_all(self: Self, path: str, values: Mapping[str, Any]) -> Self:
        for key, value in values.items():
            if value is not None:
                self.set(f"{path}/{key}", value)
        return self

    def units(self: Self, **units: str) -> Self:
        """Sets the units of bare numbers, for example units(length="mm", angle="deg")."""
        return self._set_all("units", units)

    def parameter(self: Self, name: str, value: Value) -> Self:
        """Gives a parameter its value."""
        return self.set(f"parameters/{name}", value)

    def gravity(self: Self, x: Value, y: Value) -> Self:
        """Sets the acceleration of gravity in world axes."""
        return self.set("gravity", [x, y])

    def body(self: Self, name: str, points: Optional[Mapping[str, Point]] = None, *, mass: Optional[Value] = None,
             center: Optional[Point] = None, inertia: Optional[Value] = None,
             rod: Optional[Sequence[str]] = None) -> Self:
        """Adds a body, or adds to one: points in its axes, mass, and centre with inertia or a uniform rod."""
        with self._lock:
            lib.yk_builder_body(self._edit(), encoded(name))
            for point, place in named(points, "points").items():
                if not hasattr(place, "__len__") or len(place) != 2:
                    raise refusal(RequestError, "E0806", f"point `{point}` takes (x, y), not {place!r}")
                self.point(name, point, *place)
            return self._set_all(f"bodies/{name}", {"mass": mass, "center": center, "inertia": inertia, "rod": rod})

    def point(self: Self, body: str, name: str, x: Value, y: Value) -> Self:
        """Adds a point to a body, in its axes."""
        return self.set(f"bodies/{body}/points/{name}", [x, y])

    def _joint(self: Self, name: str, kind: str, first: str, second: str, **keys: Any) -> Self:
        keys = {"from" if key == "from_" else key: value for key, value in keys.items() if value is not None}
        return self.set(f"joints/{name}", {kind: [first, second], **keys})

    def pin(self: Self, name: str, first: str, second: str, *, at: Optional[str] = None,
            angle: Optional[str] = None) -> Self:
        """Pins two bodies at the point `at` of both, or at the points of the joint's own name."""
        return self._joint(name, "pin", first, second, at=at, angle=angle)

    def weld(self: Self, name: str, first: str, second: str, *, at: Optional[str] = None,
             turned: Optional[Value] = None) -> Self:
        """Fixes two bodies to each other."""
        return self._joint(name, "weld", first, second, at=at, turned=turned)

    def slide(self: Self, name: str, first: str, second: str, along: Value, *, from_: Optional[str] = None,
              to: Optional[str] = None, distance: Optional[str] = None, turned: Optional[Value] = None) -> Self:
        """Lets the second body move along a line of the first: along "x", "y" or an angle, through `from_`."""
        return self._joint(name, "slide", first, second, along=along, from_=from_, to=to, distance=distance,
                           turned=turned)

    def slot(self: Self, name: str, first: str, second: str, along: Value, *, from_: Optional[str] = None,
             at: Optional[str] = None, distance: Optional[str] = None, angle: Optional[str] = None) -> Self:
        """Lets the point `at` of the second body move along a line of the first, free to turn."""
        return self._joint(name, "pin-slot", first, second, along=along, from_=from_, at=at, distance=distance,
                           angle=angle)

    def free(self: Self, name: str, first: str, second: str, *, from_: Optional[str] = None, to: Optional[str] = None,
             x: Optional[str] = None, y: Optional[str] = None, angle: Optional[str] = None) -> Self:
        """Leaves two bodies free of each other; names all three coordinates, or none."""
        names = [x, y, angle]
        given = [one is not None for one in names]
        if any(given) and not all(given):
            raise refusal(RequestError, "E0806", f"free joint `{name}`: name x, y and angle together, or none")
        return self._joint(name, "free", first, second, at=names if any(given) else None, from_=from_, to=to)

    def drive(self: Self, coordinate: str, value: Value) -> Self:
        """Drives a coordinate by an expression of time, such as "20 rpm * t"."""
        return self.set(f"drives/{coordinate}", value)

    def start(self: Self, coordinate: str, value: Value) -> Self:
        """Gives a coordinate at the place where the machine is put together; "theta.rate" gives a rate."""
        return self.set(f"start/{coordinate}", value)

    def effort(self: Self, coordinate: str, value: Value) -> Self:
        """Lets an effort act along a coordinate: an expression of time, coordinates and rates."""
        return self.set(f"efforts/{coordinate}", value)

    def force(self: Self, name: str, body: str, x: Value, y: Value, *, at: Optional[str] = None) -> Self:
        """Lets a force act on a body's point, or its origin, in world axes."""
        keys = {"at": at} if at else {}
        return self.set(f"forces/{name}", {"body": body, **keys, "value": [x, y]})

    def spring(self: Self, name: str, first: str, second: Optional[str] = None, *, stiffness: Optional[Value] = None,
               length: Optional[Value] = None, damping: Optional[Value] = None, **more: Any) -> Self:
        """Adds a spring and damper between two points "body.point", or along one coordinate."""
        where: Any = {"along": first} if second is None else {"between": [first, second]}
        keys = {"stiffness": stiffness, "length": length, "damping": damping, **more}
        return self.set(f"springs/{name}", {**where, **{k: v for k, v in keys.items() if v is not None}})

    def stop(self: Self, coordinate: str, low: Value, high: Value) -> Self:
        """Stops a coordinate at both ends of a range."""
        return self.set(f"stops/{coordinate}", [low, high])

    def gear(self: Self, name: str, first: str, second: str, teeth: Sequence[Value], **more: Any) -> Self:
        """Meshes two gears; more keys as in a file: module, pressure_angle, carrier, internal."""
        return self.set(f"gears/{name}", {"mesh": [first, second], "teeth": [*teeth], **more})

    def rack(self: Self, name: str, pinion: str, rack: str, radius: Value, **more: Any) -> Self:
        """Meshes a pinion with a rack."""
        return self.set(f"racks/{name}", {"pinion": pinion, "rack": rack, "radius": radius, **more})

    def belt(self: Self, name: str, first: str, second: str, radii: Sequence[Value], **more: Any) -> Self:
        """Lays a belt round two pulleys."""
        return self.set(f"belts/{name}", {"between": [first, second], "radii": [*radii], **more})

    def _said(self) -> str:
        """Returns the machine so far as a model file."""
        text = lib.yk_builder_text(self._builder)
        if text == ffi.NULL:
            raise MemoryError("out of memory")
        return text_of(text)

    def _check_builder(self) -> Problems:
        """Returns the machine's problems, in which `where` names bodies and joints; raises nothing."""
        problems = Problems()
        model = lib.yk_builder_model(self._builder, ffi.NULL, problems.c)
        if model != ffi.NULL:
            lib.yk_model_free(model)
        return problems
