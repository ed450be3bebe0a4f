"""Motion in time: whole simulations, and the host loop that steps one and acts on it."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Callable, Iterator, Mapping, MutableMapping, NamedTuple, Optional, Sequence

import numpy as np

from . import _sweep
from ._core import channels_of, names_of
from ._guard import Guarded
from ._native import ffi, lib
from ._problems import (
    Error, ModelError, PoseError, Problems, RequestError, UnknownName, refusal, status_name, text_of,
)  # fmt: skip
from ._reach import new_state
from ._table import Column, Event, Table, row_type, table
from ._values import TIME, CData, Value, encoded, shown, si, unit_of
from ._watch import check, keep

if TYPE_CHECKING:
    from ._core import Core
    from ._machine import Machine

METHODS = {"dop853": lib.YK_INTEGRATOR_DOP853, "sdirk4": lib.YK_INTEGRATOR_SDIRK4, "rk4": lib.YK_INTEGRATOR_RK4}
_KINDS = {
    lib.YK_HAPPENING_STOP: "stop", lib.YK_HAPPENING_RELEASE: "release", lib.YK_HAPPENING_STICK: "stick",
    lib.YK_HAPPENING_SLIP: "slip", lib.YK_HAPPENING_CHANGE_POINT: "change-point",
    lib.YK_HAPPENING_DEAD_POINT: "dead-point", lib.YK_HAPPENING_CROSSING: "crossing",
}  # fmt: skip


class Summary(NamedTuple):
    """How a simulation went: its steps, and how well energy and loops are kept."""

    steps: int
    rejected: int
    evaluations: int
    recoordinations: int
    energy_error: float
    worst_residual: float
    energy_start: float
    energy_end: float


class Request:
    """A simulation's options and start values, read once; `new` begins one."""

    def __init__(self, core: "Core", *, start: Value = 0.0, to: Optional[float] = None, at: Mapping[str, Value],
                 rate: Mapping[str, Value], effort: Mapping[str, Value], method: str = "dop853",
                 tolerance: Optional[float] = None, step: Optional[Value] = None, pulls: int = 0,
                 steps_max: int = 0) -> None:  # fmt: skip
        self.core = core
        if method not in METHODS:
            raise refusal(RequestError, "E0806", f"method takes dop853, sdirk4 or rk4 here, not `{method}`")
        if step is not None and method != "rk4":
            raise refusal(RequestError, "E0806", "step: only method=\"rk4\" has a fixed step")
        if tolerance is not None and method == "rk4":
            raise refusal(RequestError, "E0806", "tolerance: method=\"rk4\" has a fixed step and no tolerance")
        self.plan = core.plan(list(at))
        self.start = si(core.model, start, TIME, "start")
        self.options = options = ffi.new("YkSimulationOptions *")
        options[0] = lib.yk_default_simulation_options()
        options.integrator = METHODS[method]
        if tolerance is not None:
            options.tolerance = si(core.model, tolerance, lib.YK_QUANTITY_NUMBER, "tolerance")
        if not 1e-15 <= options.tolerance <= 0.1:
            raise refusal(RequestError, "E0806", f"tolerance takes a number from 1e-15 to 0.1, not {tolerance!r}")
        if step is not None:
            options.step = si(core.model, step, TIME, "step")
            if options.step <= 0:
                raise refusal(RequestError, "E0806", f"step must be greater than 0, not {step!r}")
        options.start, options.horizon = self.start, 0.0 if to is None else to
        options.pulls, options.steps_max = pulls, steps_max
        self.span = ffi.new("double[2]", [self.start, self.start if to is None else to])
        options.goes_on, options.context = ffi.addressof(lib, "yk_host_goes_on_in_time"), self.span
        self._names: list[Any] = []
        self._start_values(at, rate)
        self.effort = {self._free(name).name: _sweep.Holding(core, 0.0, None, None, {name: x}).efforts()
                       for name, x in effort.items()}  # fmt: skip

    def _free(self, name: str) -> Any:
        c = self.core.coordinate(name)
        if c.has_drive:
            raise refusal(RequestError, "E0822", f"`{name}` is driven: its drive says where it starts, and exerts the "
                          "effort that its motion takes")  # fmt: skip
        return c

    def _start_values(self, at: Mapping[str, Value], rate: Mapping[str, Value]) -> None:
        core, pairs = self.core, [(n, v, 0) for n, v in at.items()] + [(n, v, 1) for n, v in rate.items()]
        self.values = ffi.new("YkStartValue[]", len(pairs) + 1)
        for k, (name, value, order) in enumerate(pairs):
            c = self._free(name)
            self._names.append(ffi.new("char[]", encoded(name)))
            self.values[k].coordinate, self.values[k].is_rate = self._names[-1], bool(order)
            self.values[k].value = si(core.model, value, c.quantity(order), name)
            if order == 0:
                self.plan.holds[k].value = self.values[k].value
        self.options.values, self.options.value_count = self.values, len(pairs)
        self.inputs = ffi.new("char *[]", self._names[: len(at)] or [ffi.NULL])
        self.compile = ffi.new("YkCompileOptions *")
        self.compile.inputs, self.compile.input_count = self.inputs, len(at)
        self.options.compile = self.compile if at else ffi.NULL

    def new(self) -> CData:
        """Moves the machine to its start and begins a simulation there."""
        state = new_state(self.plan.mech)
        self.plan.reach(state, self.start)
        self.options.pose = state
        problems = Problems()
        simulation = lib.yk_simulation_new(self.core.model, self.options, problems.c)
        if simulation == ffi.NULL:
            is_pose = any(p.code in ("E0601", "E0602") for p in problems.list())
            raise problems.fail(PoseError if is_pose else ModelError)
        problems.warn(4)

        def free(c: CData, keep_alive: Any = (self, state, self.core.model)) -> None:
            lib.yk_simulation_free(c)

        simulation = ffi.gc(simulation, free)
        for name, value in self.effort.items():
            status = lib.yk_simulation_set_effort(simulation, encoded(name), next(iter(value.values())))
            if status < 0:
                raise refusal(RequestError, "E0806", f"the effort along `{name}` cannot be set")
        return simulation


class Efforts(MutableMapping[str, float]):
    """Efforts that act along coordinates, N m or N: set one, and it holds until it is set again."""

    def __init__(self, simulation: "Simulation") -> None:
        self._simulation, self._set = simulation, dict[str, float]()

    def __setitem__(self, name: str, value: Value) -> None:
        sim = self._simulation
        with sim._lock:
            c = sim._request._free(name)
            quantity = lib.YK_QUANTITY_FORCE if c.is_distance else lib.YK_QUANTITY_TORQUE
            effort = si(sim._core.model, value, quantity, name)
            status = lib.yk_simulation_act_effort(sim._use(), c.number, effort)
            if status == lib.YK_BAD_ARGUMENT:
                status = lib.yk_simulation_set_effort(sim._use(), encoded(name), effort)
            if status < 0:
                raise refusal(RequestError, "E0806", f"no effort along `{name}` was there when the simulation began",
                              f"machine.simulation(effort={{{name!r}: 0.0}}) begins with one")  # fmt: skip
            self._set[name] = effort

    def __getitem__(self, name: str) -> float:
        return self._set[name]

    def __delitem__(self, name: str) -> None:
        raise refusal(RequestError, "E0806", "an effort is set to 0, not deleted")

    def __iter__(self) -> Iterator[str]:
        return iter(self._set)

    def __len__(self) -> int:
        return len(self._set)


@ffi.def_extern(error=False, onerror=keep)  # type: ignore[misc]
def yk_host_control(context: CData, _simulation: CData, time: float) -> bool:
    """Calls a simulation's control."""
    simulation, function = ffi.from_handle(context)
    return function(simulation, time) is not False


class Simulation(Guarded):
    """One machine moving in time, stepped by its host.

    `sim["theta"]` reads any channel, `sim.effort["theta"] = 2.0` acts, `sim.step(1e-3)` goes on; `save` and `restore`
    continue with the same bits. A simulation is a context manager and belongs to one thread at a time.
    """

    __slots__ = ("machine", "effort", "_c", "_request", "_core", "_channels", "_control", "_kept")

    def __init__(self, machine: "Machine", request: Request, kept: Any, c: Optional[CData] = None) -> None:
        super().__init__()
        self.machine, self._request, self._core, self._kept = machine, request, request.core, kept
        self._c: CData = request.new() if c is None else c
        self.effort: Efforts = Efforts(self)
        self.effort._set.update({n: next(iter(x.values())) for n, x in request.effort.items()})
        self._channels: dict[Any, Any] = {}
        self._control: Any = None

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Frees the simulation; every later use raises ClosedError."""
        with self._lock:
            self._gone, self._c, self._control = "was closed", ffi.NULL, None

    def _use(self) -> CData:
        if self._gone:
            self._refuse()
        return self._c

    @property
    def time(self) -> float:
        """The time at which it stands, s."""
        with self._lock:
            return float(lib.yk_simulation_time(self._use()))

    def step(self, span: Value) -> float:
        """Advances by a span of time; a number is in seconds. Returns the time reached."""
        with self._lock:
            c = self._use()
            return self._end(c, lib.yk_simulation_step(c, si(self._core.model, span, TIME, "span")))

    def advance(self, to: Value) -> float:
        """Advances to a time. Returns the time reached, which is earlier only where a control ended it."""
        with self._lock:
            c = self._use()
            return self._end(c, lib.yk_simulation_advance(c, si(self._core.model, to, TIME, "to")))

    def _end(self, c: CData, status: int) -> float:
        check()
        time: float = lib.yk_simulation_time(c)
        if status < 0:
            raise self._failure(c, status)
        return time

    def _failure(self, c: CData, status: int) -> Exception:
        if status == lib.YK_BAD_ARGUMENT:
            return refusal(RequestError, "E0806", "a simulation advances to a finite time that is not past")
        if status == lib.YK_NO_MEMORY:
            return MemoryError("out of memory")
        why = text_of(lib.yk_simulation_report(c).message)
        at = shown(self._core.model, lib.yk_simulation_time(c), TIME, 10)
        return refusal(PoseError, "E0820", f"the motion ends at t = {at}: {why}", status=status_name(status))

    def _found(self, names: Any) -> CData:
        channels = self._channels.get(names)
        if channels is None:
            channels = channels_of(self._request.plan.mech, [names] if isinstance(names, str) else names)
            self._channels[names] = channels
        return channels

    def __getitem__(self, channel: str) -> float:
        with self._lock:
            c = self._use()
            found = self._channels.get(channel) or self._found(channel)
            return float(lib.yk_simulation_channel(c, found[0]))

    def read(self, names: Sequence[str]) -> Any:
        """Returns several channels as an array."""
        with self._lock:
            c, found = self._use(), self._found(tuple(names))
            return np.array([lib.yk_simulation_channel(c, found[k]) for k in range(len(names))])

    def accelerate(self, coordinate: str, acceleration: Value) -> None:
        """Takes over a driven coordinate: it goes on from where it stands with this acceleration, in place of its drive."""
        with self._lock:
            c, info = self._use(), self._core.coordinate(coordinate)
            value = si(self._core.model, acceleration, info.quantity(2), coordinate)
            if lib.yk_simulation_act_drive(c, info.number, value) < 0:
                raise refusal(RequestError, "E0806", f"`{coordinate}` is not driven")

    def watch(self, name: str, channel: str, value: Value = 0.0, direction: int = 0) -> None:
        """Reports crossings of a channel and a value as events called `name`."""
        with self._lock:
            found = self._found(channel)
            limit = si(self._core.model, value, found[0].quantity, name)
            if lib.yk_simulation_watch(self._use(), encoded(name), found[0], limit, direction) < 0:
                raise MemoryError("out of memory")

    def control(self, period: Value, function: Optional[Callable[["Simulation", float], object]]) -> None:
        """Calls function(simulation, time) now and after every period, exactly then; False ends the advance there."""
        with self._lock:
            c = self._use()
            handle = ffi.new_handle((self, function)) if function else ffi.NULL
            call = lib.yk_host_control if function else ffi.NULL
            if lib.yk_simulation_set_control(c, si(self._core.model, period, TIME, "period"), call, handle) < 0:
                raise refusal(RequestError, "E0806", f"a control's period is greater than 0, not {period!r}")
            self._control = handle

    def reset(self) -> None:
        """Goes back to the start; what follows has the same bits as the first time."""
        with self._lock:
            if lib.yk_simulation_reset(self._use()) < 0:
                raise refusal(RequestError, "E0806", "a simulation cannot be reset now: memory ran out, or it is in a "
                              "control")  # fmt: skip

    def save(self) -> bytes:
        """Returns the simulation as bytes, which carry a version, the machine's fingerprint and a checksum."""
        with self._lock:
            c = self._use()
            size = lib.yk_simulation_save(c, ffi.NULL, 0)
            data = ffi.new("char[]", size)
            lib.yk_simulation_save(c, data, size)
            return bytes(ffi.buffer(data, size))

    def restore(self, saved: bytes) -> None:
        """Puts it where another simulation of the same machine was saved; on failure nothing changes."""
        with self._lock:
            status = lib.yk_simulation_restore(self._use(), ffi.from_buffer(saved), len(saved))
            if status == lib.YK_BAD_MODEL:
                raise Error("the bytes were saved by another machine", status=status_name(status))
            if status < 0:
                raise Error("the bytes are damaged, incomplete, or of another version", status=status_name(status))

    def clone(self) -> "Simulation":
        """Returns a second simulation in the same condition, without the control; it goes on with the same bits."""
        with self.machine._lock:  # a start is found with what the machine keeps
            other = Simulation(self.machine, self._request, self._kept)
        other.restore(self.save())
        other.effort._set.update(self.effort._set)
        return other

    def __reduce__(self) -> Any:
        return _again, (self.machine, self._kept, self.save(), dict(self.effort._set))

    @property
    def events(self) -> tuple[Event, ...]:
        """What has happened: stops, releases, sticking, slipping, dead and change points, crossings."""
        with self._lock:
            c = self._use()
            found = [lib.yk_simulation_happening(c, k) for k in range(lib.yk_simulation_happening_count(c))]
            return tuple(Event(_KINDS[h.kind], h.time, text_of(h.name), h.value) for h in found)

    @property
    def work(self) -> dict[str, float]:
        """Work done so far by every load without a potential, J."""
        with self._lock:
            c = self._use()
            return {text_of(lib.yk_simulation_work_name(c, k)): lib.yk_simulation_work(c, k)
                    for k in range(lib.yk_simulation_work_count(c))}  # fmt: skip

    @property
    def summary(self) -> Summary:
        """Steps taken, energy error, worst residual."""
        with self._lock:
            s = lib.yk_simulation_summary(self._use())
            return Summary(*(getattr(s, name) for name in Summary._fields))

    def rows(self, to: Value, *, every: Optional[Value] = None, steps: int = 100, of: Any = None) -> Table:
        """Advances to a time and returns rows of channels on the way, from where it stands."""
        with self._lock:
            return _rows(self, self.time, si(self._core.model, to, TIME, "to"), every, steps, of)

    def __repr__(self) -> str:
        if self._gone:
            return f"<yoke.Simulation: {self._gone}>"
        return f"<yoke.Simulation of {self.machine.name!r} at t = {self.time:.6g} s>"


def _again(machine: "Machine", kept: Any, saved: bytes, efforts: dict[str, float]) -> Simulation:
    simulation = machine.simulation(**kept)
    simulation.restore(saved)
    simulation.effort._set.update(efforts)
    return simulation


def usual_columns(core: "Core") -> list[str]:
    """Returns the coordinates that the file names, or all, and the energy."""
    named = [c.name for c in core.coordinates.values() if c.is_declared]
    return [*(named or core.coordinates), "energy"]


def _rows(sim: Simulation, start: float, to: float, every: Optional[Value], steps: int, of: Any) -> Table:
    core = sim._core
    names = names_of(of) if of is not None else usual_columns(core)
    channels = channels_of(sim._request.plan.mech, names)
    if "t" in names:
        raise refusal(UnknownName, "E0806", "`of` names `t`, which is the first column already")
    request = ffi.new("YkHostRows *")
    setattr(request, "from", start)
    request.to = to
    request.steps = _sweep.count(steps, "steps")
    if to <= start:
        raise refusal(RequestError, "E0806", f"to must be later than the start, {start} s")
    if every is not None:
        request.every = si(core.model, every, TIME, "every")
        if request.every <= 0:
            raise refusal(RequestError, "E0806", f"every must be greater than 0, not {every!r}")
        request.steps = _rows_of(to - start, request.every)
    kind = row_type(["t", *names])
    data = np.empty(request.steps + 1, kind)
    request.rows = ffi.from_buffer("double[]", data)
    request.channels, request.channel_count = channels, len(names)
    sim._request.span[0], sim._request.span[1] = start, to
    c = sim._use()
    status = lib.yk_host_simulate(c, request)
    check()
    heads = [Column("t", *unit_of(core.model, TIME)), *_sweep.columns(core.model, channels, names)]
    result = table(data[: request.done], heads, f"{text_of(lib.yk_model_name(core.model))}: motion in time")
    result.events, result.summary = sim.events, sim.summary
    if status < 0:
        result.status = status_name(status)
        result.message = "" if status == lib.YK_STOPPED else str(sim._failure(c, status))
    return result


def _rows_of(span: float, every: float) -> int:
    """Returns the number of rows after the first: the last one at the end, whatever is left of a span before it."""
    count = span / every
    if not count <= 10_000_000:
        raise refusal(RequestError, "E0806", "every: more than 10 million rows")
    whole = round(count)
    return max(1, whole if abs(count - whole) < 1e-9 * count else math.ceil(count))
