"""Many copies of an open tree, stepped together in SIMD lanes."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional

import numpy as np

from ._arrays import spread
from ._native import ffi, lib
from ._problems import RequestError, refusal
from ._request import Request
from ._values import CData
from ._watch import check

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._core import Core

_BLOCK = 32  # copies that the library steps together


class Lanes:
    """The states of `count` copies as rows: positions and rates of the inputs, a column for each copy.

    status  [copy]: below 0, a copy stands still
    times   [copy], s
    """

    def __init__(self, core: "Core", options: Mapping[str, Any], simulation: CData, lanes: list[CData],
                 channels: list[tuple[int, int]], acted: list[int], status: "NDArray[np.int8]") -> None:
        self._core, self._options, self._lanes, self.status = core, options, lanes, status
        mech, count = lib.yk_state_mechanism(lib.yk_simulation_state(simulation)), len(status)
        self._inputs = [lib.yk_coordinate_info(mech, k).input for k in range(lib.yk_coordinate_count(mech))]
        self._rows = [2 * self._inputs[coordinate] + order for coordinate, order in channels]
        size = lib.yk_lanes_input_count(lanes[0])
        self.states, self.times = np.zeros((2 * size, count)), np.zeros(count)
        self._efforts = np.zeros((len(acted), count))
        self._starts: dict[Any, "NDArray[np.float64]"] = {}
        self._kept = [ffi.new("double *[]", [ffi.from_buffer("double[]", row) for row in self.states]),
                      ffi.new("double *[]", size), simulation]
        for row, coordinate in zip(self._efforts, acted):
            self._kept[1][self._inputs[coordinate]] = ffi.from_buffer("double[]", row)
        self._case = ffi.new("YkLanesCase *")
        self._case.states, self._case.efforts = self._kept[0], self._kept[1]
        self._case.times, self._case.status = ffi.from_buffer("double[]", self.times), ffi.from_buffer("signed char[]", status)

    @classmethod
    def make(cls, core: "Core", options: Mapping[str, Any], at: Mapping[str, Any], rate: Mapping[str, Any],
             channels: list[Any], acted: list[int], status: "NDArray[np.int8]", threads: int) -> Optional["Lanes"]:
        """Returns None if the machine cannot run in lanes, or if a channel is not the position or rate of a coordinate."""
        if any(c.kind != lib.YK_CHANNEL_COORDINATE or c.order > 1 for c in channels):
            return None
        first = _first(core, options, at, rate, len(status)).new()
        lanes, fits = [], ffi.new("bool *")
        for _ in range(threads):
            one = lib.yk_lanes_new(first, fits)
            if one == ffi.NULL and not fits[0]:
                return None
            if one == ffi.NULL:
                raise MemoryError("out of memory")
            lanes.append(ffi.gc(one, lib.yk_lanes_free))
        return cls(core, options, first, lanes, [(c.index, c.order) for c in channels], acted, status)

    def restart(self, which: "NDArray[np.int64]", at: Mapping[str, Any], rate: Mapping[str, Any]) -> None:
        """Begins copies anew, with efforts of 0; arrays hold a value for each of `which`."""
        if not len(which):
            return
        same_at, each_at = spread(at, len(which))
        same_rate, each_rate = spread(rate, len(which))
        key = repr((same_at, same_rate))
        if key not in self._starts:
            self._starts = {key: self._start(_first(self._core, self._options, at, rate, len(which)).new())}
        self.states[:, which] = self._starts[key][:, None]
        for order, each in enumerate((each_at, each_rate)):
            for name, values in each.items():
                self.states[2 * self._inputs[self._core.coordinate(name).number] + order, which] = values
        self._efforts[:, which], self.times[which], self.status[which] = 0.0, 0.0, 0
        check()

    def _start(self, simulation: CData) -> "NDArray[np.float64]":
        state = lib.yk_simulation_state(simulation)
        motions = [lib.yk_state_input(state, i) for i in range(len(self.states) // 2)]
        return np.array([x for m in motions for x in (m.position, m.velocity)])

    def step(self, span: float, efforts: Optional["NDArray[np.float64]"], submit: Any) -> None:
        """Sets efforts [copy, effort] and advances all copies; `submit` begins a call in another thread."""
        if efforts is not None:
            self._efforts[:] = efforts.T
        count, threads = len(self.status), len(self._lanes)
        bounds = [min(count, -(-count * k // threads // _BLOCK) * _BLOCK) for k in range(threads)] + [count]
        parts = list(zip(self._lanes, bounds, bounds[1:]))
        waiting = [submit(lib.yk_lanes_step, one, self._case, a, b, span) for one, a, b in parts[1:]]
        done = [lib.yk_lanes_step(parts[0][0], self._case, 0, parts[0][2], span)] + [w.result() for w in waiting]
        if lib.YK_BAD_ARGUMENT in done and np.all(self.status != lib.YK_BAD_ARGUMENT):
            raise refusal(RequestError, "E0806", "a simulation advances by a finite span of time, of at most 1e14 steps")

    def read(self, values: "NDArray[np.float64]") -> None:
        """Writes the channels into values [copy, channel]."""
        for column, row in enumerate(self._rows):
            values[:, column] = self.states[row]


def _first(core: "Core", options: Mapping[str, Any], at: Mapping[str, Any], rate: Mapping[str, Any],
           count: int) -> Request:
    """Returns the library's request for the first of some copies."""
    (same_at, each_at), (same_rate, each_rate) = spread(at, count), spread(rate, count)
    own_at = {n: same_at[n] if n in same_at else float(each_at[n][0]) for n in at}
    own_rate = {n: same_rate[n] if n in same_rate else float(each_rate[n][0]) for n in rate}
    return Request(core, at=own_at, rate=own_rate, **options)
