"""How a machine gets to a requested pose: from where `start:` says that it was assembled, as the command moves it."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

from ._native import ffi, lib
from ._problems import ModelError, PoseError, Problem, Problems, RequestError, refusal, status_name, text_of
from ._values import CData, shown
from ._watch import check, progress_of_host

if TYPE_CHECKING:
    from ._core import Coordinate, Core

_CODES = {
    lib.YK_REDUNDANT: "E0605", lib.YK_CHANGE_POINT: "E0604", lib.YK_SINGULAR: "E0603", lib.YK_LIMIT: "E0602",
    lib.YK_NO_ASSEMBLY: "E0601", lib.YK_NOT_CONVERGED: "E0606", lib.YK_STOPPED: "E0608",
}  # fmt: skip


def new_state(mech: CData) -> CData:
    """Returns a state of a mechanism, which its long calls can be stopped on."""
    state = lib.yk_state_new(mech)
    if state == ffi.NULL:
        raise MemoryError("out of memory")

    def free(c: CData, keep: CData = mech) -> None:
        lib.yk_state_free(c)

    state = ffi.gc(state, free)
    if lib.yk_state_set_progress(state, progress_of_host) < 0:
        raise MemoryError("out of memory")
    return state


def new_dynamics(mech: CData) -> CData:
    """Returns the dynamics of a mechanism, or None if it has neither masses nor loads."""
    problems = Problems()
    dynamics = lib.yk_dynamics_new(mech, problems.c)
    if dynamics == ffi.NULL:
        raise problems.fail(ModelError)

    def free(c: CData, keep: CData = mech) -> None:
        lib.yk_dynamics_free(c)

    dynamics = ffi.gc(dynamics, free)
    return dynamics if lib.yk_dynamics_has_loads(dynamics) else None


def message_of(state: CData) -> str:
    """Returns what a state's report says."""
    return text_of(lib.yk_state_report(state).message)


def label_of(state: CData) -> str:
    """Returns the label of a state's configuration, as "A+ C-"."""
    length = lib.yk_state_label(state, ffi.NULL, 0)
    text = ffi.new("char[]", length + 1)
    lib.yk_state_label(state, text, length + 1)
    return text_of(text)


def pose_error(status: int, message: str, hint: Optional[str] = None) -> Exception:
    """Returns the exception for a pose that is not reached; raises what ended the call from outside."""
    check()
    if status == lib.YK_NO_MEMORY:
        return MemoryError("out of memory")
    name = status_name(status)
    return refusal(PoseError, _CODES.get(status, "E0806"), f"{name}: {message or name}", hint, name)


class Start:
    """The machine where the file assembles it, with the file's own choice of inputs, at t = 0."""

    def __init__(self, core: "Core") -> None:
        self.core = core
        self.mech: CData = core.base
        self.state = new_state(self.mech)
        self.own_state: CData = None
        own = self._own()
        self.status = self._assemble(self.state) if own is None else self._take(own)
        check()

    @staticmethod
    def _assemble(state: CData) -> int:
        status = lib.yk_state_set_time(state, 0.0, ffi.NULL)
        return int(lib.yk_state_assemble(state) if status >= 0 else status)

    def _own(self) -> CData:
        """Assembles the file's own machine where parameters replace its values; None if it cannot be."""
        core = self.core
        mech = core.compile(core.own, (), Problems()) if core.own is not None else None
        state = new_state(mech) if mech is not None else None
        return state if state is not None and self._assemble(state) >= 0 else None

    def _take(self, own: CData) -> int:
        """Takes the configuration that the file has at its own parameters."""
        status = lib.yk_state_set_time(self.state, 0.0, ffi.NULL)
        if status < 0:
            return int(status)
        if lib.yk_state_take_labels(self.state, own) == lib.YK_OK:
            status = lib.yk_state_solve(self.state)
        else:
            carried = self._carry(own)
            if carried is None:
                status = lib.yk_state_guess(self.state, own)
                carried = lib.yk_state_assemble(self.state) if status >= 0 else status
            status = carried
        return int(lib.YK_NO_ASSEMBLY if status == lib.YK_LIMIT else status)

    def _carry(self, own: CData) -> Optional[int]:
        """Moves all parameters at once from the file's to the asked ones; None if they do not vary continuously."""
        core, names = self.core, list(self.core.parameters)
        mech = lib.yk_state_mechanism(own)
        inputs = lib.yk_input_count(self.mech)
        if lib.yk_input_count(mech) != inputs:
            return None
        kept = [ffi.new("char[]", name.encode()) for name in names]
        before = ffi.new("double[]", [lib.yk_model_parameter(core.own, name) for name in kept])
        after = ffi.new("double[]", [lib.yk_model_parameter(core.model, name) for name in kept])
        goal = ffi.new("YkMotion[]", [lib.yk_state_input(self.state, k) for k in range(inputs)])
        variant = lib.yk_variant_new(mech, ffi.new("char *[]", kept), len(kept), Problems().c)
        if variant == ffi.NULL:
            return None
        variant = ffi.gc(variant, lib.yk_variant_free)
        moving = new_state(lib.yk_variant_mechanism(variant))
        result = None
        if lib.yk_state_adopt(moving, own) >= 0:
            result = lib.yk_state_carry(moving, variant, before, after, len(kept), goal)
            if result >= 0:
                result = lib.yk_state_adopt(self.state, moving)
        del moving  # before its variant
        return result

    def is_told(self) -> bool:
        """Tells whether a drive or `start:` gives every input a value."""
        inputs = [c for c in self.core.coordinates.values() if c.input >= 0]
        return all(c.has_drive or c.has_start for c in inputs)


class Slot:
    """A state with its dynamics, lent to one pose at a time."""

    __slots__ = ("state", "dynamics", "is_shared")

    def __init__(self, plan: "Plan", is_shared: bool = True) -> None:
        self.state: CData = new_state(plan.mech)
        self.dynamics: CData = plan.new_dynamics()
        self.is_shared = is_shared  # goes back to the pool; not with efforts of its own


class Plan:
    """Requests that set the same coordinates: their mechanism, and the pose from which they all begin."""

    def __init__(self, core: "Core", at: Sequence[str], rate: Sequence[str], accel: Sequence[str],
                 swept: Optional[str], imposed: bool) -> None:  # fmt: skip
        self.core, self.imposed = core, imposed
        self.start: Optional[Start] = core.start
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
        self.holds = ffi.new("YkHostHold[]", len(order) + 1)
        self.hold_count = len(order)
        for k, (name, derivative) in enumerate(order):
            self.holds[k].input, self.holds[k].order = self._input(name), derivative
        self.quantities = [self.coordinates[name].quantity(derivative) for name, derivative in order]
        self.prescribed = [self._input(name) for name in accel]
        self.inputs = lib.yk_input_count(self.mech)
        self.goal = ffi.new("YkMotion[]", self.inputs + 1)
        self.move = ffi.new("YkMove *")
        self.has_free = False
        self.pool: list[Slot] = []
        self.notes: tuple[Problem, ...] = ()
        self.entry: CData = None
        self.entry_status = 0
        self.channels: dict[str, Any] = {}
        self._enter()

    def _input(self, name: str) -> int:
        found = self.coordinates[name].input
        if found < 0:
            raise refusal(RequestError, "E0813", f"no freedom is left to set `{name}`: the others fix it")
        return found

    def new_dynamics(self, all_prescribed: bool = False) -> CData:
        """Returns dynamics in which accelerations that are set, or all, are prescribed; None without loads."""
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
            start.status in (lib.YK_NO_ASSEMBLY, lib.YK_LIMIT) and self.hold_count > 0 and not start.is_told()
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
        """Brings a state to the pose that `holds` and `time` ask for. Returns the status; raises if it is not reached."""
        if self.entry is None or self.entry_status == lib.YK_SINGULAR and self.mech is not self.core.base:
            return self._reach_otherwise(state, time)
        problems = Problems().c if time else ffi.NULL
        status: int = lib.yk_host_reach(state, self.entry, self.holds, self.hold_count, time, self.goal, self.move,
                                        problems)  # fmt: skip
        if status < 0:
            raise pose_error(status, self._word_stop(state), self._hint(state, status, time))
        move = self.move
        self.notes = ()
        if move.pass_count or move.is_detour or self.entry_status == lib.YK_SINGULAR:
            self.notes = self._note_way()
        return status

    def _note_way(self) -> tuple[Problem, ...]:
        """Tells change points and detours on the way, and a start at which two configurations meet."""
        move, notes = self.move, []
        if self.entry_status == lib.YK_SINGULAR and self.hold_count > 0:
            notes.append(Problem("warning", "W0615", "the pose of `start:` is one where two configurations meet; the "
                                 f"machine is taken to leave it as {label_of(self.entry)}"))  # fmt: skip
        if move.is_detour:
            notes.append(Problem("note", "N0611", "a limit blocks the straight way from `start:`; the machine got here "
                                 "by a detour, through its several inputs"))  # fmt: skip
        if move.pass_count:
            label = text_of(lib.yk_block_info(self.mech, move.passes[0].block).label)
            notes.append(Problem("note", "N0610", f"the machine passed {move.pass_count} change point"
                                 f"{'' if move.pass_count == 1 else 's'} on its way from `start:`, the first of them at "
                                 f"joint `{label}`"))  # fmt: skip
        return tuple(notes)

    def ask(self, state: CData, time: float) -> None:
        """Sets a fresh state's inputs to those that are asked, without a pose."""
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
        if start.status >= 0:
            raise pose_error(lib.YK_LIMIT if self.entry_status >= 0 else self.entry_status,
                             "with these inputs the pose of `start:` is a dead point, from which two branches part, "
                             "and the file does not say which is meant")  # fmt: skip
        self.ask(state, time)
        status: int = lib.yk_state_assemble(state)
        if status < 0:
            raise pose_error(status, message_of(state))
        import warnings

        from ._problems import YokeWarning

        warnings.warn("the file does not say where the machine was assembled; the configuration nearest to its "
                      "guesses at this pose was taken [W0612]", YokeWarning, stacklevel=4)  # fmt: skip
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
                for k in range(min(self.inputs, 3))]  # fmt: skip
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
                             for x in (getattr(ranges[k], "from"), ranges[k].to))  # fmt: skip
                return f"this configuration ({label_of(state)}) closes for {info.name} from {low} to {high}"
        return None
