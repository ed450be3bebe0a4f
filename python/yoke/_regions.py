"""Regions of two freedoms in which a machine has equally many configurations, with proof."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional

import numpy as np

from ._core import Core, names_of
from ._guard import Guarded
from ._map import Range
from ._native import ffi, lib
from ._pose import Svg
from ._problems import PoseError, Problems, RequestError, refusal, text_of
from ._reach import Plan
from ._start import new_state
from ._sweep import Holding
from ._values import ANGLE, LENGTH, CData, Value, number, unit_of
from ._watch import check

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._core import Coordinate
    from ._machine import Machine


class Bound(NamedTuple):
    """A boundary: the joint whose configurations meet there, None at the end of the map; its part of the outlines."""

    of: Optional[str]
    part: float


class Region(NamedTuple):
    """A region of the plane of two coordinates, in which the machine has equally many configurations."""

    configurations: int
    contains_start: bool
    area: float  # rad^2, rad m or m^2
    ranges: tuple[Range, Range]
    outlines: "tuple[NDArray[np.float64], ...]"  # [corner, 2]: around the region, then around its holes
    bounds: tuple[Bound, ...]


class Regions(Guarded):
    """The map of a machine over two coordinates, rad or m.

    coordinates   the two; `domain` has the ranges that were searched
    regions       in which the machine closes: the one that contains the start, then the others, the largest first
    tolerance     regions that are narrower, over either coordinate, may be missing
    proved        which part of the domain is proved
    complete      whether the rest lies along the curves; `because` says what is proved, or what is not
    """

    __slots__ = ("machine", "coordinates", "domain", "tolerance", "regions", "proved", "complete", "because", "_request", "_core",
                 "_c")

    def __init__(self, machine: "Machine", core: Core, over: Any, tolerance: float, time: Value, at: Mapping[str, Value]) -> None:
        super().__init__()
        self.machine, self._core = machine, core
        self._request = {"over": over, "tolerance": tolerance, "time": time, "at": dict(at)}
        options = ffi.new("YkRegionsOptions *", lib.yk_default_regions_options())
        options.tolerance = number(tolerance, "tolerance")
        if not 1e-4 <= options.tolerance <= 0.1:
            raise refusal(RequestError, "E0806", f"tolerance takes a number from 0.0001 to 0.1, not {tolerance!r}")
        plan, first, second, state = self._stand(core, over, time, at)
        problems = Problems()
        made = lib.yk_regions_new(state, first.number, second.number, options, problems.c)
        if made == ffi.NULL:
            raise problems.fail(PoseError)
        self._c = ffi.gc(made, lib.yk_regions_free)
        check()
        self.coordinates = (first.name, second.name)
        self.domain = tuple(_range(lib.yk_regions_domain(self._c, axis)) for axis in range(2))
        self.tolerance = tuple(lib.yk_regions_tolerance(self._c, axis) for axis in range(2))
        self.proved = lib.yk_regions_proved(self._c)
        self.complete, self.because = bool(lib.yk_regions_are_complete(self._c)), text_of(lib.yk_regions_message(self._c))
        self.regions = tuple(self._region(plan, k) for k in range(lib.yk_regions_count(self._c)))

    @staticmethod
    def _stand(core: Core, over: Any, time: Value, at: Mapping[str, Value]) -> "tuple[Plan, Coordinate, Coordinate, CData]":
        """Moves a state to the machine's pose, with the mapped coordinates as inputs."""
        names = names_of(over) if over is not None else []
        if over is not None and len(names) != 2:
            raise refusal(RequestError, "E0806", f"`over` takes the names of two coordinates, not {over!r}")
        held = [name for name in names if name in at]
        if held:
            raise refusal(RequestError, "E0806", f"`{held[0]}` is mapped, so `at` cannot hold it")
        hold = Holding(core, time, None, None, None)
        plan = core.plan([*at, *names])
        hold.fill(plan, at)
        free = sorted((c for c in plan.coordinates.values() if c.input >= 0 and c.name not in at), key=lambda c: c.input)
        if len(free) != 2:
            raise refusal(PoseError, "E0850", f"regions are mapped over two freedoms, and this machine has {len(free)}",
                          "hold all inputs but two by `at`" if len(free) > 2 else
                          "m.map() follows the whole motion of a machine with one freedom", "no-map")
        for k, name in enumerate(names, len(at)):
            if plan.entry is not None:
                plan.holds[k].value = lib.yk_state_coordinate(plan.entry, plan.coordinates[name].number).position
        first, second = (plan.coordinates[name] for name in names) if names else free
        state = new_state(plan.mech)
        plan.reach(state, hold.time)
        return plan, first, second, state

    def __reduce__(self) -> Any:
        return _again, (self.machine, self._request)

    def _region(self, plan: Plan, k: int) -> Region:
        r = lib.yk_regions_region(self._c, k)
        bounds = [lib.yk_regions_bound(self._c, k, b) for b in range(r.bounds)]
        return Region(r.configurations, bool(r.contains_start), r.area, (_range(r.range[0]), _range(r.range[1])),
                      tuple(self._outline(k, o) for o in range(r.outlines)),
                      tuple(Bound(None if b.block < 0 else text_of(lib.yk_block_info(plan.mech, b.block).label), b.part)
                            for b in bounds))

    def _outline(self, region: int, k: int) -> "NDArray[np.float64]":
        count = ffi.new("size_t *")
        points = lib.yk_regions_outline(self._c, region, k, count)
        if count[0] == 0:
            return np.empty((0, 2))
        return np.frombuffer(ffi.buffer(points, 16 * count[0])).reshape(count[0], 2).copy()

    # --- questions

    def at(self, first: float, second: float) -> "tuple[int, bool]":
        """Returns how many configurations there are at a pose, rad or m, and whether that is proved there."""
        with self._lock:
            if self._gone:
                self._refuse()
            proved = ffi.new("bool *")
            count = lib.yk_regions_at(self._c, number(first, self.coordinates[0]), number(second, self.coordinates[1]), proved)
            if count < 0:
                raise refusal(RequestError, "E0806", f"({first!r}, {second!r}) is outside of the map", "its `domain` tells where that is")
            return count, bool(proved[0])

    def svg(self) -> Svg:
        """Draws the regions in colours, darker where there are more configurations."""
        with self._lock:
            if self._gone:
                self._refuse()
            core, options, kept = self._core, ffi.new("YkRegionsPicture *"), []
            for axis, name in enumerate(self.coordinates):
                unit = unit_of(core.model, (LENGTH if core.coordinate(name).is_distance else ANGLE)[0])
                kept += [ffi.new("char[]", name.encode()), ffi.new("char[]", unit[0].encode())]
                options.names[axis], options.units[axis], options.scale[axis] = kept[-2], kept[-1], 1 / unit[1]
            drawn = lib.yk_regions_picture(self._c, options)
            if drawn == ffi.NULL:
                raise MemoryError("out of memory")
            return Svg(text_of(drawn))

    def _repr_svg_(self) -> str:
        return self.svg()

    def __len__(self) -> int:
        return len(self.regions)

    def __repr__(self) -> str:
        proof = "complete" if self.complete else "not complete"
        return f"<yoke.Regions of {self.machine.name!r} over {', '.join(self.coordinates)}: {len(self.regions)} regions, {proof}>"


def _range(c: CData) -> Range:
    return Range(getattr(c, "from"), c.to)


def _again(machine: "Machine", request: "dict[str, Any]") -> Regions:
    return machine.regions(**request)
