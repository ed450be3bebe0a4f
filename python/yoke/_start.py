"""The pose in which the file assembles the machine, from which every request begins."""
from __future__ import annotations

from typing import TYPE_CHECKING, Callable, Optional

from ._native import ffi, lib
from ._problems import ModelError, PoseError, Problems, refusal, status_name, text_of
from ._values import CData
from ._watch import check, progress_of_host

if TYPE_CHECKING:
    from ._core import Facts

_CODES = {  # the error for each failing status
    lib.YK_LIMIT: "E0602", lib.YK_NO_ASSEMBLY: "E0601", lib.YK_NOT_CONVERGED: "E0606", lib.YK_STOPPED: "E0608",
}


def _owned(made: CData, free: Callable[[CData], None], mech: CData) -> CData:
    """Frees what the library made from a mechanism when its last user goes, before the mechanism."""

    def end(c: CData, keep: CData = mech) -> None:
        free(c)

    return ffi.gc(made, end)


def new_state(mech: CData) -> CData:
    """Returns a state of a mechanism whose long calls can be stopped."""
    state = lib.yk_state_new(mech)
    if state == ffi.NULL:
        raise MemoryError("out of memory")
    state = _owned(state, lib.yk_state_free, mech)
    if lib.yk_state_set_progress(state, progress_of_host) < 0:
        raise MemoryError("out of memory")
    return state


def new_dynamics(mech: CData) -> CData:
    """Returns the dynamics of a mechanism, or None if it has neither masses nor loads."""
    problems = Problems()
    dynamics = lib.yk_dynamics_new(mech, problems.c)
    if dynamics == ffi.NULL:
        raise problems.fail(ModelError)
    dynamics = _owned(dynamics, lib.yk_dynamics_free, mech)
    return dynamics if lib.yk_dynamics_has_loads(dynamics) else None


def new_configurations(mech: CData) -> CData:
    """Returns an object that keeps what enumerating learns about a mechanism, for any number of poses."""
    all_of = lib.yk_configurations_new(mech)
    if all_of == ffi.NULL:
        raise MemoryError("out of memory")
    return _owned(all_of, lib.yk_configurations_free, mech)


def message_of(state: CData) -> str:
    """Returns a state's report in words."""
    return text_of(lib.yk_state_report(state).message)


def label_of(state: CData) -> str:
    """Returns the label of a state's configuration, such as "A+ C-"."""
    length = lib.yk_state_label(state, ffi.NULL, 0)
    text = ffi.new("char[]", length + 1)
    lib.yk_state_label(state, text, length + 1)
    return text_of(text)


def pose_error(status: int, message: str, hint: Optional[str] = None) -> Exception:
    """Returns the exception for a pose that is not reached; if something outside ended the call, raises that."""
    check()
    if status == lib.YK_NO_MEMORY:
        return MemoryError("out of memory")
    name = status_name(status)
    return refusal(PoseError, _CODES.get(status, "E0806"), f"{name}: {message or name}", hint, name)


class Start:
    """The machine as the file assembles it, with the file's own choice of inputs, at t = 0."""

    def __init__(self, core: "Facts") -> None:
        self.mech: CData = core.base
        self.state = new_state(self.mech)
        own = self._own(core)
        self.status = self._assemble(self.state) if own is None else self._take(core, own)
        # does a drive or `start:` give every input a value?
        self.is_told = all(c.has_drive or c.has_start for c in core.coordinates.values() if c.input >= 0)
        check()

    @staticmethod
    def _assemble(state: CData) -> int:
        status = lib.yk_state_set_time(state, 0.0, ffi.NULL)
        return int(lib.yk_state_assemble(state) if status >= 0 else status)

    def _own(self, core: "Facts") -> CData:
        """Assembles the file's own machine if parameters replace its values; None if it cannot be assembled."""
        mech = core.compile(core.own, (), Problems()) if core.own is not None else None
        state = new_state(mech) if mech is not None else None
        return state if state is not None and self._assemble(state) >= 0 else None

    def _take(self, core: "Facts", own: CData) -> int:
        """Takes the configuration that the file's own machine has."""
        status = lib.yk_state_set_time(self.state, 0.0, ffi.NULL)
        if status < 0:
            return int(status)
        if lib.yk_state_take_labels(self.state, own) == lib.YK_OK:
            status = lib.yk_state_solve(self.state)
        else:
            carried = self._carry(core, own)
            if carried is None:
                status = lib.yk_state_guess(self.state, own)
                carried = lib.yk_state_assemble(self.state) if status >= 0 else status
            status = carried
        return int(lib.YK_NO_ASSEMBLY if status == lib.YK_LIMIT else status)

    def _carry(self, core: "Facts", own: CData) -> Optional[int]:
        """Moves all parameters at once from the file's to the requested ones; None if they do not vary continuously."""
        names = list(core.parameters)
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
