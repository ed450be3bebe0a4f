"""Many simulations of one machine, stepped together."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence

import numpy as np

from . import _sweep
from ._arrays import dimensions, doubles, is_pair, spread
from ._core import channels_of, names_of
from ._guard import Guarded
from ._lanes import Lanes
from ._motion import usual_columns
from ._native import ffi, lib
from ._problems import RequestError, refusal
from ._request import Request
from ._values import TIME, Value, named, si
from ._watch import check

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._machine import Machine


class Simulations(Guarded):
    """`count` simulations of one machine; `step` acts on all of them and advances them, on several threads.

    values   [simulation, column]: what `of` names, after the last step
    status   0, or below 0 for a simulation that could not go on; it stands still until it is restarted
    time     s, of each
    lanes    whether several are stepped at a time, in SIMD lanes: if method="rk4", if the columns are positions and
             rates of coordinates, and if the machine is an open tree whose loads are gravity, efforts that are set or
             constant, viscous friction, and linear springs and dampers along coordinates
    The results have the same bits for any number of threads; in lanes they agree with single simulations up to
    rounding.
    """

    __slots__ = ("machine", "count", "of", "efforts", "values", "status", "_core", "_options", "_at", "_rate", "_held",
                 "_array", "_many", "_channels", "_coordinates", "_threads", "_pool", "_process", "_lanes")

    def __init__(self, machine: "Machine", count: int, *, of: Any, effort: Sequence[str], at: Mapping[str, Any],
                 rate: Mapping[str, Any], method: str, tolerance: Optional[float], step: Optional[Value],
                 threads: Optional[int]) -> None:
        super().__init__()
        self.machine, self._core = machine, machine._ready()
        self.count = _sweep.count(count, "count")
        self.efforts = tuple(names_of(effort))
        self._options: dict[str, Any] = {"method": method, "tolerance": tolerance, "step": step,
                                         "effort": {name: 0.0 for name in self.efforts}}
        self._at, self._rate = dict(at), dict(rate)
        self.of = tuple(names_of(of) if of is not None else usual_columns(self._core))
        most = os.cpu_count() or 1 if threads is None else _sweep.count(threads, "threads", 1024)
        self._threads = min(most, self.count)
        self._pool: Any = None
        self._process = 0  # the process in which the pool has its threads
        self.values, self.status = np.zeros((self.count, len(self.of))), np.zeros(self.count, np.int8)
        plan, acted = self._core.plan(list(self._at)), [self._core.coordinate(n).number for n in self.efforts]
        self._channels = channels_of(plan.mech, self.of)
        self._held: list[Any] = []
        self._array: Any = ffi.NULL
        self._lanes: Optional[Lanes] = None
        if method == "rk4":
            read = [self._channels[k] for k in range(len(self.of))]
            with machine._lock:
                self._lanes = Lanes.make(self._core, self._options, self._at, self._rate, read, acted, self.status,
                                         self._threads)
        if not self._lanes:
            self._each_alone(acted)
        self._restart(range(self.count), self._at, self._rate)
        self._run(0.0, None)

    @property
    def lanes(self) -> bool:
        """Whether they are stepped in SIMD lanes."""
        return self._lanes is not None

    def _each_alone(self, acted: "list[int]") -> None:
        """Prepares simulations that are stepped one by one."""
        self._held = [None] * self.count
        self._array = ffi.new("YkSimulation *[]", self.count)
        self._coordinates = ffi.new("size_t[]", acted or 1)
        self._many = ffi.new("YkHostMany *")
        many = self._many
        many.simulations, many.coordinates, many.coordinate_count = self._array, self._coordinates, len(self.efforts)
        many.channels, many.channel_count = self._channels, len(self.of)
        many.values = ffi.from_buffer("double[]", self.values)
        many.status = ffi.from_buffer("signed char[]", self.status)

    def __enter__(self) -> "Simulations":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Frees all simulations; every later use raises ClosedError."""
        with self._lock:
            self._gone, self._held, self._lanes = "was closed", [], None
            self._array = ffi.new("YkSimulation *[]", 1)
            if self._pool is not None and self._process == os.getpid():
                self._pool.shutdown()

    def __len__(self) -> int:
        return self.count

    def _restart(self, which: Any, at: Mapping[str, Any], rate: Mapping[str, Any]) -> None:
        """Begins simulations anew; arrays hold a value for each of `which`."""
        which = list(which)
        with self.machine._lock:  # starts are found with what the machine keeps
            if self._lanes:
                self._lanes.restart(np.array(which, np.int64), at, rate)
            else:
                self._begin(which, at, rate)

    def _begin(self, which: "list[int]", at: Mapping[str, Any], rate: Mapping[str, Any]) -> None:
        same_at, each_at = spread(at, len(which))
        same_rate, each_rate = spread(rate, len(which))
        first: Optional[Request] = None
        saved: Any = None
        for k, index in enumerate(which):
            if first is None or each_at or each_rate:
                own_at = {**same_at, **{n: float(a[k]) for n, a in each_at.items()}}
                own_rate = {**same_rate, **{n: float(a[k]) for n, a in each_rate.items()}}
                first = Request(self._core, at={n: own_at[n] for n in at}, rate={n: own_rate[n] for n in rate},
                                **self._options)
                c = first.new()
                saved = c
            else:
                clone = lib.yk_simulation_clone(saved)
                if clone == ffi.NULL:
                    raise MemoryError("out of memory")

                def free(p: Any, keep: Any = saved) -> None:
                    lib.yk_simulation_free(p)

                c = ffi.gc(clone, free)
            self._held[index], self._array[index] = c, c
            check()

    def restart(self, which: Any = None, *, at: Optional[Mapping[str, Any]] = None,
                rate: Optional[Mapping[str, Any]] = None) -> None:
        """Begins some or all simulations anew, from arrays with a start value for each of them or from shared values.

        which  indices, or a mask [count]; None: all
        """
        with self._lock:
            self._use()
            try:
                indices = np.arange(self.count) if which is None else np.asarray(which)
            except ValueError:
                indices = np.array(None)
            if indices.size == 0 and indices.ndim == 1:
                indices = indices.astype(np.int64)
            if indices.dtype == bool:
                if indices.shape != (self.count,):
                    raise refusal(RequestError, "E0806", f"a mask has the shape {(self.count,)}, not {indices.shape}")
                indices = np.flatnonzero(indices)
            if indices.dtype.kind not in "iu" or indices.ndim != 1:
                raise refusal(RequestError, "E0806", "restart takes indices of simulations, or a mask")
            if indices.size and not (0 <= indices.min() and indices.max() < self.count):
                raise refusal(RequestError, "E0806", f"restart takes indices from 0 to {self.count - 1}")
            given_at = {**self._scalars(self._at), **named(at, "at")}
            given_rate = {**self._scalars(self._rate), **named(rate, "rate")}
            if list(given_at) != list(self._at):
                raise refusal(RequestError, "E0806", f"restart sets the coordinates that `simulations` set: "
                              f"{', '.join(self._at) or 'none'}")
            self._restart(indices.tolist(), given_at, given_rate)
            if self._lanes:
                self._lanes.read(self.values)
                return
            self.status[indices] = 0
            self._many.span = 0.0
            self._many.efforts = ffi.NULL
            for k in indices.tolist():
                lib.yk_host_step_many(self._many, k, k + 1)
            check()

    @staticmethod
    def _scalars(values: Mapping[str, Any]) -> dict[str, Any]:
        return {name: 0.0 if not is_pair(v) and dimensions(v, name) > 0 else v for name, v in values.items()}

    def _use(self) -> None:
        if self._gone:
            self._refuse()

    def step(self, span: Value, efforts: Any = None) -> "NDArray[np.float64]":
        """Sets efforts [simulation, effort] (or [simulation], with one effort), advances all, and returns `values`."""
        with self._lock:
            self._use()
            seconds = si(self._core.model, span, TIME, "span")
            if seconds < 0:
                raise refusal(RequestError, "E0806", "a simulation advances by a span of time that is not negative")
            array = None
            if efforts is not None:
                shape = (self.count, len(self.efforts))
                is_column = shape[1] == 1 and dimensions(efforts, "efforts") == 1
                array = doubles(np.asarray(efforts)[:, None] if is_column else efforts, "efforts", shape)
            self._run(seconds, array)
            return self.values

    def _submit(self, function: Any, *arguments: Any) -> Any:
        """Begins a call in another thread."""
        if self._pool is None or self._process != os.getpid():  # a fork leaves the threads behind
            from concurrent.futures import ThreadPoolExecutor

            self._pool, self._process = ThreadPoolExecutor(self._threads - 1, "yoke"), os.getpid()
        return self._pool.submit(function, *arguments)

    def _run(self, span: float, efforts: Any) -> None:
        if self._lanes:
            self._lanes.step(span, efforts, self._submit)
            self._lanes.read(self.values)
            check()
            return
        self._many.span = span
        kept = ffi.NULL if efforts is None else ffi.from_buffer("double[]", efforts)
        self._many.efforts = kept
        bounds = [self.count * k // self._threads for k in range(self._threads + 1)]
        if self._threads == 1 or span == 0.0:
            lib.yk_host_step_many(self._many, 0, self.count)
        else:
            parts = zip(bounds[1:], bounds[2:])
            waiting = [self._submit(lib.yk_host_step_many, self._many, a, b) for a, b in parts]
            lib.yk_host_step_many(self._many, 0, bounds[1])
            for one in waiting:
                one.result()
        check()

    @property
    def time(self) -> "NDArray[np.float64]":
        """The times at which they stand, s."""
        with self._lock:
            self._use()
            if self._lanes:
                return self._lanes.times.copy()
            return np.array([lib.yk_simulation_time(c) for c in self._held])

    def __repr__(self) -> str:
        if self._gone:
            return f"<yoke.Simulations: {self._gone}>"
        failed = int((self.status < 0).sum())
        return f"<yoke.Simulations: {self.count} of {self.machine.name!r}{f', {failed} stand still' if failed else ''}>"
