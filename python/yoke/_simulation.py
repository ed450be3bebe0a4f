"""A machine that moves in time; its host steps it and acts on it."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Iterator, MutableMapping, NamedTuple, Optional, Sequence
from weakref import ref

import numpy as np

from . import _motion
from ._core import channels_of
from ._guard import Guarded
from ._native import ffi, lib
from ._problems import Error, PoseError, RequestError, refusal, status_name, text_of
from ._request import Request
from ._table import Event, Table
from ._values import TIME, CData, Value, encoded, shown, si
from ._watch import check, keep

if TYPE_CHECKING:
    from ._machine import Machine

_KINDS = {
    lib.YK_HAPPENING_STOP: "stop", lib.YK_HAPPENING_RELEASE: "release", lib.YK_HAPPENING_STICK: "stick",
    lib.YK_HAPPENING_SLIP: "slip", lib.YK_HAPPENING_CHANGE_POINT: "change-point",
    lib.YK_HAPPENING_DEAD_POINT: "dead-point", lib.YK_HAPPENING_CROSSING: "crossing",
    lib.YK_HAPPENING_LIFT_OFF: "lift-off", lib.YK_HAPPENING_LAW_LEFT: "law-left",
    lib.YK_HAPPENING_LANDING: "landing", lib.YK_HAPPENING_PULL: "pull",
}


class Summary(NamedTuple):
    """Figures of a simulation: its steps, and how well energy and loops are kept."""

    steps: int
    rejected: int
    evaluations: int
    recoordinations: int
    energy_error: float
    worst_residual: float
    energy_start: float
    energy_end: float


class Efforts(MutableMapping[str, float]):
    """Efforts that act along coordinates, N m or N; each holds until it is set again."""

    __slots__ = ("_simulation", "_set")

    def __init__(self, simulation: "Simulation") -> None:
        self._simulation, self._set = simulation, simulation._efforts

    def __setitem__(self, name: str, value: Value) -> None:
        sim = self._simulation
        with sim._lock:
            c = sim._request.free(name)
            quantity = lib.YK_QUANTITY_FORCE if c.is_distance else lib.YK_QUANTITY_TORQUE
            effort = si(sim._core.model, value, quantity, name)
            status = lib.yk_simulation_act_effort(sim._use(), c.number, effort)
            if status == lib.YK_BAD_ARGUMENT:
                status = lib.yk_simulation_set_effort(sim._use(), encoded(name), effort)
            if status < 0:
                raise refusal(RequestError, "E0806", f"no effort along `{name}` was there when the simulation began",
                              f"machine.simulation(effort={{{name!r}: 0.0}}) begins with one")
            self._set[name] = effort

    def __getitem__(self, name: str) -> float:
        self._simulation._use()
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
    return function(simulation(), time) is not False


class Simulation(Guarded):
    """A machine that moves in time, stepped by its host.

    `sim["theta"]` reads any channel, `sim.effort["theta"] = 2.0` acts, `sim.step(1e-3)` goes on. After `save` and
    `restore` it continues with the same bits. A simulation is a context manager and belongs to one thread at a time.
    """

    __slots__ = ("machine", "_efforts", "_c", "_request", "_core", "_channels", "_control", "_kept")

    def __init__(self, machine: "Machine", request: Request, kept: Any, c: Optional[CData] = None) -> None:
        super().__init__()
        self.machine, self._request, self._core, self._kept = machine, request, request.core, kept
        self._c: CData = request.new() if c is None else c
        self._efforts: dict[str, float] = {n: next(iter(x.values())) for n, x in request.effort.items()}
        self._channels: dict[Any, Any] = {}
        self._control: Any = None

    @property
    def effort(self) -> Efforts:
        """The efforts that act: sim.effort["theta"] = 2.0."""
        return Efforts(self)

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
        """The present time, s."""
        with self._lock:
            return float(lib.yk_simulation_time(self._use()))

    def step(self, span: Value) -> float:
        """Advances by a span of time; a number is in seconds. Returns the time reached."""
        with self._lock:
            c = self._use()
            return self._end(c, lib.yk_simulation_step(c, si(self._core.model, span, TIME, "span")))

    def advance(self, to: Value) -> float:
        """Advances to a time. Returns the time reached, which is earlier only if a control ended the advance."""
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
        """Takes over a driven coordinate: from now on it moves with this acceleration, in place of its drive."""
        with self._lock:
            c, info = self._use(), self._core.coordinate(coordinate)
            value = si(self._core.model, acceleration, info.quantity(2), coordinate)
            if lib.yk_simulation_act_drive(c, info.number, value) < 0:
                raise refusal(RequestError, "E0806", f"`{coordinate}` is not driven")

    def watch(self, name: str, channel: str, value: Value = 0.0, direction: int = 0) -> None:
        """Reports each time that a channel crosses a value, as an event called `name`."""
        with self._lock:
            found = self._found(channel)
            limit = si(self._core.model, value, found[0].quantity, name)
            if lib.yk_simulation_watch(self._use(), encoded(name), found[0], limit, direction) < 0:
                raise MemoryError("out of memory")

    def control(self, period: Value, function: Optional[Callable[["Simulation", float], object]]) -> None:
        """Calls function(simulation, time) now and exactly after every period; False ends the advance."""
        with self._lock:
            c = self._use()
            handle = ffi.new_handle((ref(self), function)) if callable(function) else ffi.NULL
            call = lib.yk_host_control if callable(function) else ffi.NULL
            if lib.yk_simulation_set_control(c, si(self._core.model, period, TIME, "period"), call, handle) < 0:
                raise refusal(RequestError, "E0806", f"a control's period is greater than 0, not {period!r}")
            self._control = handle

    def reset(self) -> None:
        """Goes back to the start; what follows has the same bits as the first time."""
        with self._lock:
            if lib.yk_simulation_reset(self._use()) < 0:
                raise refusal(RequestError, "E0806", "a simulation cannot be reset now: memory ran out, or it is in a "
                              "control")

    def save(self) -> bytes:
        """Returns the simulation as bytes, which carry a version, the machine's fingerprint and a checksum."""
        with self._lock:
            c = self._use()
            size = lib.yk_simulation_save(c, ffi.NULL, 0)
            data = ffi.new("char[]", size)
            lib.yk_simulation_save(c, data, size)
            return bytes(ffi.buffer(data, size))

    def restore(self, saved: bytes) -> None:
        """Restores a saved simulation of the same machine; on failure nothing changes."""
        with self._lock:
            status = lib.yk_simulation_restore(self._use(), ffi.from_buffer(saved), len(saved))
            if status == lib.YK_BAD_MODEL:
                raise Error("the bytes were saved by another machine", status=status_name(status))
            if status < 0:
                raise Error("the bytes are damaged, incomplete, or of another version", status=status_name(status))

    def clone(self) -> "Simulation":
        """Returns a second simulation in the same condition, without the control; it goes on with the same bits."""
        with self.machine._lock:  # finding a start uses what the machine keeps
            other = Simulation(self.machine, self._request, self._kept)
        other.restore(self.save())
        other._efforts.update(self._efforts)
        return other

    def __reduce__(self) -> Any:
        return _again, (self.machine, self._kept, self.save(), dict(self._efforts))

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
                    for k in range(lib.yk_simulation_work_count(c))}

    @property
    def summary(self) -> Summary:
        """Steps taken, energy error, worst residual."""
        with self._lock:
            s = lib.yk_simulation_summary(self._use())
            return Summary(*(getattr(s, name) for name in Summary._fields))

    def rows(self, to: Value, *, every: Optional[Value] = None, steps: int = 100, of: Any = None) -> Table:
        """Advances to a time and returns rows of channels on the way, from the present time on."""
        with self._lock:
            return _motion.rows(self, self.time, si(self._core.model, to, TIME, "to"), every, steps, of)

    def __repr__(self) -> str:
        if self._gone:
            return f"<yoke.Simulation: {self._gone}>"
        return f"<yoke.Simulation of {self.machine.name!r} at t = {self.time:.6g} s>"


def _again(machine: "Machine", kept: Any, saved: bytes, efforts: dict[str, float]) -> Simulation:
    simulation: Simulation = machine.simulation(**kept)
    simulation.restore(saved)
    simulation._efforts.update(efforts)
    return simulation
