"""Moves a machine from its start to a requested pose, as the command does."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

from ._native import ffi, lib
from ._problems import Problem, Problems, RequestError, refusal, text_of
from ._start import label_of, message_of, new_configurations, new_dynamics, new_state, pose_error
from ._values import CData, shown
from ._watch import check

if TYPE_CHECKING:
    from ._core import Coordinate, Facts

class Slot:
    """A state with its dynamics, lent to one pose at a time."""

    __slots__ = ("state", "dynamics", "is_shared")

    def __init__(self, plan: "Plan", is_shared: bool = True) -> None:
        self.state: CData = new_state(plan.mech)
        self.dynamics: CData = plan.new_dynamics()
        self.is_shared = is_shared  # goes back to the pool, unless it has efforts of its own


class Plan:
    """Requests that set the same coordinates: their mechanism, and the pose from which they all begin."""

    def __init__(self, core: "Facts", at: Sequence[str], rate: Sequence[str], accel: Sequence[str],
                 swept: Optional[str], imposed: bool) -> None:
        self.core, self.imposed = core, imposed
        names = list(dict.fromkeys(([swept] if swept else []) + [*at, *rate, *accel]))
        for name in names:
            core.coordinate(name)
        self.mech: CData = core.base
        if any(core.coordinates[name].input < 0 for name in names):
            problems = Problems()
            self.mech = core.compile(core.model, names, problems)
            if self.mech is None:
                raise problems.fail(RequestError)
        self.coordinates: dict[str, Coordinate] = core.coordinates_of(self.mech)
        order = [(name, 0) for name in at] + [(name, 1) for name in rate] + [(name, 2) for name in accel]
        order += [(swept, 0)] if swept else []
        self.holds = ffi.new("YkInputHold[]", len(order) + 1)
        self.hold_count = len(order)
        for k, (name, derivative) in enumerate(order):
            self.holds[k].input, self.holds[k].order = self._input(name), derivative
        self.quantities = [self.coordinates[name].quantity(derivative) for name, derivative in order]
        self.prescribed = [self._input(name) for name in accel]
        self.inputs = lib.yk_input_count(self.mech)
        self.move = ffi.new("YkMove *")
        self.has_free = False
        self.pool: list[Slot] = []
        self.notes: tuple[Problem, ...] = ()
        self.entry: CData = None
        self.entry_status = 0
        self.channels: dict[str, Any] = {}
        self._configurations: CData = None
        self._enter()

    def _input(self, name: str) -> int:
        found = self.coordinates[name].input
        if found < 0:
            raise refusal(RequestError, "E0813", f"no freedom is left to set `{name}`: the others fix it")
        return found

    @property
    def configurations(self) -> CData:
        """What enumerating configurations has learnt about this mechanism."""
        if self._configurations is None:
            self._configurations = new_configurations(self.mech)
        return self._configurations

    def name_of(self, state: CData) -> str:
        """Returns a configuration's name: its label, with a number if several at its inputs share it ("J+.2")."""
        name = ffi.new("char **")
        status = lib.yk_configurations_name(self.configurations, state, ffi.NULL, name)
        if status < 0:
            raise pose_error(status, message_of(state))
        return text_of(name[0])

    def new_dynamics(self, all_prescribed: bool = False) -> CData:
        """Returns dynamics in which some or all accelerations are prescribed; None without loads."""
        dynamics = new_dynamics(self.mech)
        if dynamics is None:
            return None
        for k in range(self.inputs) if self.imposed or all_prescribed else self.prescribed:
            lib.yk_dynamics_prescribe(dynamics, k, True)
        self.has_free = not all(lib.yk_dynamics_is_prescribed(dynamics, k) for k in range(self.inputs))
        return dynamics

    def _enter(self) -> None:
        """Puts `entry` where the machine was assembled, with this plan's inputs."""
        start = self.core.start
        self.untold = (
            start.status in (lib.YK_NO_ASSEMBLY, lib.YK_LIMIT) and self.hold_count > 0 and not start.is_told
        )
        if start.status < 0:
            return
        if self.mech is self.core.base:
            self.entry = start.state
            self.entry_status = lib.yk_state_report(start.state).status
        else:
            self.entry = new_state(self.mech)
            self.entry_status = lib.yk_state_adopt(self.entry, start.state)
            check()

    def take(self) -> Slot:
        """Returns a slot for a pose; `pool` takes it back."""
        try:
            return self.pool.pop()
        except IndexError:
            return Slot(self)

    def reach(self, state: CData, time: float) -> int:
        """Moves a state to the pose that `holds` and `time` ask for. Returns the status, or raises."""
        if self.entry is None or self.entry_status != 0:
            is_dead = self.entry_status == lib.YK_SINGULAR and self.mech is not self.core.base
            if self.entry is None or self.entry_status < 0 or is_dead:
                return self._reach_otherwise(state, time)
        problems = Problems().c if time else ffi.NULL
        status: int = lib.yk_host_reach(state, self.entry, self.holds, self.hold_count, time, self.move, problems)
        if status < 0:
            raise pose_error(status, self._word_stop(state), self._hint(state, status, time))
        move = self.move
        self.notes = ()
        if move.pass_count or move.is_detour or self.entry_status == lib.YK_SINGULAR:
            self.notes = self._note_way()
        return status

    def _note_way(self) -> tuple[Problem, ...]:
        """Notes change points and detours on the way, and a start at which two configurations meet."""
        move, notes = self.move, []
        if self.entry_status == lib.YK_SINGULAR and self.hold_count > 0:
            notes.append(Problem("warning", "W0615", "the pose of `start:` is one where two configurations meet; the "
                                 f"machine is taken to leave it as {label_of(self.entry)}"))
        if move.is_detour:
            notes.append(Problem("note", "N0611", "a limit blocks the straight way from `start:`; the machine got here "
                                 "by a detour, through its several inputs"))
        if move.pass_count:
            label = text_of(lib.yk_block_info(self.mech, move.passes[0].block).label)
            notes.append(Problem("note", "N0610", f"the machine passed {move.pass_count} change point"
                                 f"{'' if move.pass_count == 1 else 's'} on its way from `start:`, the first of them "
                                 f"at joint `{label}`"))
        return tuple(notes)

    def ask(self, state: CData, time: float) -> None:
        """Sets a fresh state's inputs to the requested ones, without solving its pose."""
        for k in range(self.hold_count):
            hold = self.holds[k]
            lib.yk_state_hold_input(state, hold.input, hold.order, hold.value)
        problems = Problems()
        status = lib.yk_state_set_time(state, time, problems.c)
        if status < 0:
            raise problems.fail(RequestError, status, "the drives have no value at this time")

    def _reach_otherwise(self, state: CData, time: float) -> int:
        start = self.core.start
        if start.status < 0 and not self.untold:
            raise pose_error(start.status, f"at the pose of `start:`, {message_of(start.state)}")
        if self.entry_status < 0:
            raise pose_error(self.entry_status, message_of(self.entry))
        if start.status >= 0:
            raise pose_error(lib.YK_LIMIT, "with these inputs the pose of `start:` is a dead point, from which two "
                             "branches part, and the file does not say which is meant")
        self.ask(state, time)
        status: int = lib.yk_state_assemble(state)
        if status < 0:
            raise pose_error(status, message_of(state))
        import warnings

        from ._problems import YokeWarning

        warnings.warn("the file does not say where the machine was assembled; the configuration nearest to its "
                      "guesses at this pose was taken [W0612]", YokeWarning, stacklevel=4)
        return status

    def _value(self, k: int, value: float, count: int) -> str:
        coordinate = lib.yk_input_coordinate(self.mech, k)
        info = next(c for c in self.coordinates.values() if c.number == coordinate)
        return f"{info.name} = {shown(self.core.model, value, info.quantity(0), count)}"

    def _word_stop(self, state: CData) -> str:
        move = self.move
        if move.status != lib.YK_LIMIT or move.block < 0:
            return message_of(state)
        here = [lib.yk_state_coordinate(state, lib.yk_input_coordinate(self.mech, k)).position
                for k in range(min(self.inputs, 3))]
        at = ", ".join(self._value(k, value, 10) for k, value in enumerate(here)) + (", ..." if self.inputs > 3 else "")
        block = lib.yk_block_info(self.mech, move.block)
        kind = text_of(lib.yk_block_kind_name(block.kind))
        return (f"the way from `start:` ends at {at}: beyond, joint `{text_of(block.label)}` ({kind}) does not close")

    def _hint(self, state: CData, status: int, time: float) -> Optional[str]:
        """Says in which range the machine's only input closes."""
        if status != lib.YK_LIMIT or self.inputs != 1 or self.move.status != lib.YK_LIMIT:
            return None
        coordinate = lib.yk_input_coordinate(self.mech, 0)
        here = lib.yk_state_coordinate(state, coordinate).position
        ranges = ffi.new("YkRange[]", 32)
        count = lib.yk_closing_ranges(state, coordinate, ranges, 32)
        check()
        info = next(c for c in self.coordinates.values() if c.number == coordinate)
        for k in range(min(count, 32) if count != lib.YK_NOT_FOUND else 0):
            if getattr(ranges[k], "from") - 1e-6 <= here <= ranges[k].to + 1e-6:
                low, high = (shown(self.core.model, x, info.quantity(0))
                             for x in (getattr(ranges[k], "from"), ranges[k].to))
                return f"this configuration ({label_of(state)}) closes for {info.name} from {low} to {high}"
        return None
