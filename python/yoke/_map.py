"""Maps: the whole motion of a machine with one freedom, on all its circuits, with proof."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence

import numpy as np

from ._core import Core
from ._guard import Guarded
from ._native import ffi, lib
from ._pose import Svg
from ._problems import PoseError, Problems, RequestError, UnknownName, refusal, text_of
from ._reach import Plan
from ._start import new_state
from ._sweep import Holding
from ._values import ANGLE, LENGTH, CData, Value, named, si, unit_of
from ._watch import check

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._machine import Machine


class Range(NamedTuple):
    """A range of a coordinate, rad or m."""

    low: float
    high: float


class Turn(NamedTuple):
    """How a joint's angle moves on a circuit; `full` if it can turn for ever in one direction."""

    full: bool
    range: Range


class Branch(NamedTuple):
    """A branch, from one limit to the next or round: poses in the order of the mapped coordinate, about 0.05 rad apart."""

    start: float
    end: float
    closed: bool  # its last row is its first pose again
    coordinates: "NDArray[np.float64]"  # [row, coordinate]
    points: "NDArray[np.float64]"  # [row, point, 2], m


class MapEvent(NamedTuple):
    """An event of a circuit: "limit", "change-point", "dead-point" or "end", with the coordinates there."""

    kind: str
    at: float  # the mapped coordinate, to 1e-10
    of: Optional[str]  # the joint whose configurations meet, or the coordinate that turns back
    branch: int
    coordinates: dict[str, float]


class Circuit(NamedTuple):
    """All poses between which the machine can move without being taken apart."""

    contains_start: bool
    ranges: tuple[Range, ...]
    branches: tuple[Branch, ...]
    events: tuple[MapEvent, ...]
    joints: dict[str, Turn]  # of joints that turn


class Way(list):  # type: ignore[type-arg]
    """The coordinates at both ends of a way and beside each limit or change point; empty, and so false, without a way.

    `proved` says whether the answer is certain, `reason` why the machine cannot get there.
    """

    proved: bool = True
    reason: str = ""


class Map(Guarded):
    """The map of a machine over one coordinate.

    coordinate   the mapped one; `domain` is the range that was searched
    circuits     the one that contains the start first
    complete     whether nothing can be missing; `because` says why, or what is not proved
    """

    __slots__ = ("machine", "coordinate", "domain", "circuits", "complete", "because", "_request", "_plan", "_c")

    def __init__(self, machine: "Machine", core: Core, over: Optional[str], time: Value, at: Mapping[str, Value]) -> None:
        super().__init__()
        self.machine, self._request = machine, {"over": over, "time": time, "at": dict(at)}
        hold = Holding(core, time, None, None, None)
        plan = core.plan(list(at), swept=over)
        hold.fill(plan, at)
        mapped = plan.coordinates[over] if over is not None else self._first_free(plan, at)
        self._refuse_freedoms(plan, mapped.name, at)
        if over is not None and plan.entry is not None:
            value = lib.yk_state_coordinate(plan.entry, mapped.number).position
            plan.holds[plan.hold_count - 1].value = value
        state = new_state(plan.mech)
        plan.reach(state, hold.time)
        problems = Problems()
        made = lib.yk_map_new(state, mapped.number, problems.c)
        if made == ffi.NULL:
            raise problems.fail(PoseError)

        def free(c: CData, keep: Any = state) -> None:
            lib.yk_map_free(c)

        self._plan, self._c = plan, ffi.gc(made, free)
        status = lib.yk_map_add_drives(self._c, state, problems.c)
        if status < 0:
            raise problems.fail(PoseError, status)
        check()
        self.coordinate, self.domain = mapped.name, _range(lib.yk_map_domain(self._c))
        self.complete, self.because = bool(lib.yk_map_is_complete(self._c)), text_of(lib.yk_map_message(self._c))
        self.circuits = tuple(self._circuit(core, k) for k in range(lib.yk_map_circuit_count(self._c)))

    @staticmethod
    def _first_free(plan: Plan, at: Mapping[str, Value]) -> Any:
        inputs = [c for c in plan.coordinates.values() if c.input >= 0 and c.name not in at]
        if not inputs:
            raise refusal(PoseError, "E0850", "a map is made over one freedom, and this machine has 0",
                          "m.configurations() lists the configurations of a machine without freedom", "no-map")
        return min(inputs, key=lambda c: c.input)

    @staticmethod
    def _refuse_freedoms(plan: Plan, mapped: str, at: Mapping[str, Value]) -> None:
        if mapped in at:
            raise refusal(RequestError, "E0806", f"`{mapped}` is mapped, so `at` cannot hold it")
        inputs = [c.name for c in plan.coordinates.values() if c.input >= 0 and c.name not in at]
        if len(inputs) > 1:
            raise refusal(PoseError, "E0850", f"a map is made over one freedom, and this machine has {len(inputs)}",
                          f"hold all inputs but one, as in at={{\"{inputs[-1]}\": ...}}", "no-map")

    def __reduce__(self) -> Any:
        return _again, (self.machine, self._request)

    # --- read once

    def _circuit(self, core: Core, k: int) -> Circuit:
        c = lib.yk_map_circuit(self._c, k)
        joints = {name: Turn(bool(turn.is_full), _range(turn.range)) for name, turn in
                  ((name, lib.yk_map_turn(self._c, k, j)) for j, name in enumerate(core.joints))
                  if turn.range.to > getattr(turn.range, "from")}
        return Circuit(bool(c.contains_start), tuple(_range(lib.yk_map_range(self._c, k, j)) for j in range(c.ranges)),
                       tuple(self._branch(k, j) for j in range(c.branches)),
                       tuple(self._event(k, j) for j in range(c.events)), joints)

    def _branch(self, circuit: int, k: int) -> Branch:
        c, width = lib.yk_map_branch(self._c, circuit, k), len(self._plan.coordinates)
        points = len(self._plan.core.points)
        rows, places = np.empty((c.rows, width)), np.empty((c.rows, points, 2))
        for row in range(c.rows):
            rows[row] = np.frombuffer(ffi.buffer(lib.yk_map_row(self._c, circuit, k, row), 8 * width))
            if points:
                data = ffi.buffer(lib.yk_map_points(self._c, circuit, k, row), 16 * points)
                places[row] = np.frombuffer(data).reshape(points, 2)
        return Branch(getattr(c, "from"), c.to, bool(c.is_closed), rows, places)

    def _event(self, circuit: int, k: int) -> MapEvent:
        e = lib.yk_map_event(self._c, circuit, k)
        of: Optional[str] = None
        names = {c.number: name for name, c in self._plan.coordinates.items()}
        if e.block >= 0:
            of = text_of(lib.yk_block_info(self._plan.mech, e.block).label)
        elif e.coordinate != lib.YK_NOT_FOUND:
            of = names[e.coordinate]
        there = {name: lib.yk_map_event_value(self._c, circuit, k, c.number)
                 for name, c in self._plan.coordinates.items()}
        return MapEvent(text_of(lib.yk_map_event_kind_name(e.kind)), e.at, of, e.branch, there)

    # --- questions

    def _values(self, at: Mapping[str, Value], name: str) -> CData:
        values = ffi.new("double[]", [math.nan] * (len(self._plan.coordinates) or 1))
        for coordinate, value in named(at, name).items():
            c = self._plan.core.coordinate(coordinate)
            values[self._plan.coordinates[coordinate].number] = si(self._plan.core.model, value, c.quantity(0), coordinate)
        if self.coordinate not in at:
            raise refusal(RequestError, "E0806", f"`{name}` must give the mapped coordinate `{self.coordinate}` too")
        return values

    def _places(self, at: Mapping[str, Value], name: str) -> tuple[CData, int, str]:
        values = self._values(at, name)
        count = lib.yk_map_find(self._c, values, ffi.NULL, 0)
        if count == lib.YK_NOT_FOUND:
            raise MemoryError("out of memory")
        places = ffi.new("YkMapPlace[]", count + 1)
        if lib.yk_map_find(self._c, values, places, count) != count:
            raise MemoryError("out of memory")
        closed = count or lib.yk_map_places(self._c, values[self._plan.coordinates[self.coordinate].number], ffi.NULL, 0)
        reason = "" if count else (f"no configuration has the values of `{name}`" if closed else
                                   f"no configuration closes at the {self.coordinate} of `{name}`")
        return places, count, reason  # elements live as long as their array

    def reach(self, to: Mapping[str, Value], pose: Optional[Mapping[str, Value]] = None) -> Way:
        """Finds how the machine gets to coordinates without being taken apart, past the fewest limits and change points.

        pose   coordinates from which it begins, by default those of its start
        """
        with self._lock:
            if self._gone:
                self._refuse()
            ends, end_count, reason = self._places(to, "to")
            if pose is None:
                starts = ffi.new("YkMapPlace[]", [lib.yk_map_start(self._c)])
                start_count = int(starts[0].strand != lib.YK_NOT_FOUND)
                reason = reason or ("" if start_count else "the start was not found on the map")
            else:
                starts, start_count, other = self._places(pose, "pose")
                reason = other or reason
                if start_count > 1:
                    raise refusal(RequestError, "E0806", f"`pose` has several configurations at this {self.coordinate}",
                                  "give another coordinate too; m.configurations() lists them")
            found: list[tuple[int, CData]] = []
            for a in range(start_count):
                for b in range(end_count):
                    found += self._way(starts[a], ends[b])
            result = Way()
            if found:
                count, way = min(found, key=lambda f: f[0])
                result.extend(self._coordinates(way[k]) for k in range(count))
            else:
                result.proved = self.complete
                result.reason = reason or (f"the pose is on circuit {starts[0].circuit + 1}, and what is to be reached on "
                                           f"circuit {ends[0].circuit + 1}: no motion joins them")
            return result

    def _way(self, a: CData, b: CData) -> list[tuple[int, CData]]:
        count = lib.yk_map_way(self._c, a, b, ffi.NULL, 0)
        if count == 0:
            return []
        way = ffi.new("YkMapPlace[]", count if count != lib.YK_NOT_FOUND else 1)
        if count == lib.YK_NOT_FOUND or lib.yk_map_way(self._c, a, b, way, count) == lib.YK_NOT_FOUND:
            raise MemoryError("out of memory")
        return [(count, way)]

    def _coordinates(self, place: CData) -> dict[str, float]:
        row = ffi.new("double[]", len(self._plan.coordinates) or 1)
        if not lib.yk_map_coordinates_at(self._c, place, row):
            raise MemoryError("out of memory")
        return {name: row[c.number] for name, c in self._plan.coordinates.items()}

    def svg(self, of: Optional[str] = None, trace: Sequence[str] = ()) -> Svg:
        """Draws a coordinate over the mapped one, with a colour for each circuit, and the curves of points beside it.

        of      the coordinate on the vertical axis, by default the first that is not mapped, declared ones first
        trace   points, such as "coupler.P"
        """
        with self._lock:
            if self._gone:
                self._refuse()
            core, others = self._plan.core, [c for c in self._plan.coordinates.values() if c.name != self.coordinate]
            chosen = (core.coordinate(of).name if of is not None else
                      next((c.name for c in sorted(others, key=lambda c: not c.is_declared)), self.coordinate))
            unknown = [point for point in trace if point not in core.points]
            if unknown:
                raise refusal(UnknownName, "E0815", f"the machine has no point `{unknown[0]}`",
                              "a point is written body.point, as in `coupler.P`")
            options = ffi.new("YkMapPicture *")
            angle, length = unit_of(core.model, ANGLE[0]), unit_of(core.model, LENGTH[0])
            points = ffi.new("size_t[]", [core.points[point] for point in trace] or 1)
            kept = ffi.new("char[]", angle[0].encode()), ffi.new("char[]", length[0].encode())
            options.coordinate, options.points = self._plan.coordinates[chosen].number, points
            options.point_count, options.angle_unit, options.length_unit = len(trace), kept[0], kept[1]
            options.angle, options.length = 1 / angle[1], 1 / length[1]
            drawn = lib.yk_map_picture(self._c, options)
            if drawn == ffi.NULL:
                raise MemoryError("out of memory")
            return Svg(text_of(drawn))

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        proof = "complete" if self.complete else "not complete"
        return f"<yoke.Map of {self.machine.name!r} over {self.coordinate}: {len(self.circuits)} circuits, {proof}>"


def _range(c: CData) -> Range:
    return Range(getattr(c, "from"), c.to)


def _again(machine: "Machine", request: "dict[str, Any]") -> Map:
    return machine.map(**request)
