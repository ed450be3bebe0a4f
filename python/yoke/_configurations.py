"""Configurations: all that close at a pose, and the one that is meant."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

from ._native import ffi, lib
from ._pose import Pose
from ._problems import PoseError, refusal, text_of
from ._reach import Plan, Slot
from ._start import message_of, new_state, pose_error
from ._values import CData
from ._watch import check, keep

if TYPE_CHECKING:
    from ._machine import Machine


class Configurations(list):  # type: ignore[type-arg]
    """The poses of all configurations.

    `complete` is True if there is a proof that no others exist. `reason` and `because` give the proof, or what is
    missing from it.
    """

    complete: bool = True
    reason: Optional[str] = None
    because: str = ""

    def __reduce__(self) -> Any:
        return _again, (list(self), self.complete, self.reason, self.because)

    def _repr_html_(self) -> str:
        return "".join(pose._repr_html_() for pose in self)


def _again(poses: "list[Pose]", complete: bool, reason: Optional[str], because: str) -> Configurations:
    result = Configurations(poses)
    result.complete, result.reason, result.because = complete, reason, because
    return result


@ffi.def_extern(error=False, onerror=keep)  # type: ignore[misc]
def yk_host_visit(context: CData, state: CData) -> bool:
    """Takes one configuration."""
    found, mech = ffi.from_handle(context)
    copy = new_state(mech)
    if lib.yk_state_copy(copy, state) < 0:
        raise MemoryError("out of memory")
    found.append(copy)
    return True


def states(plan: Plan, time: float) -> tuple[list[CData], CData]:
    """Returns the states of all configurations at the requested pose, in the command's order, and the report."""
    state = new_state(plan.mech)
    plan.ask(state, time)
    found: list[CData] = []
    report = ffi.new("YkConfigurationsReport *")
    options = ffi.new("YkConfigurationsOptions *", lib.yk_default_configurations_options())
    options.in_search_order = True
    handle = ffi.new_handle((found, plan.mech))
    status: int = lib.yk_configurations_each(plan.configurations, state, options, lib.yk_host_visit, handle, report)
    check()
    if status in (lib.YK_NO_MEMORY, lib.YK_STOPPED):
        raise pose_error(status, message_of(state))
    return found, report


def own(plan: Plan, time: float) -> Optional[CData]:
    """Returns the machine's own state at the requested pose, or None if it does not get there."""
    if plan.entry is None:
        return None
    state = new_state(plan.mech)
    try:
        plan.reach(state, time)
    except PoseError:
        return None
    return state


def is_own(plan: Plan, state: CData, time: float) -> bool:
    """Returns whether a configuration is the one that the machine gets to."""
    mine = own(plan, time)
    return mine is not None and bool(lib.yk_state_is_at(mine, state))


def find(machine: "Machine", plan: Plan, time: float, request: Any) -> Configurations:
    """Returns the poses of all configurations, with their forces."""
    mine = own(plan, time)
    found, report = states(plan, time)
    result = Configurations()
    result.complete, result.because = bool(report.complete), text_of(report.message)
    result.reason = text_of(lib.yk_complete_reason_name(report.reason)) if result.complete else None
    for k, state in enumerate(found):
        slot = Slot(plan, False)
        if lib.yk_state_copy(slot.state, state) < 0:
            raise MemoryError("out of memory")
        is_start = mine is not None and bool(lib.yk_state_is_at(mine, state))
        pose = machine._posed(plan, slot, request, 0, lib.YK_METHOD_REDUCED, is_start)
        pose.index = k
        result.append(pose)
    return result


def choose(plan: Plan, state: CData, time: float, word: Union[str, int]) -> int:
    """Puts a state in a named configuration: "nearest", a label, or a number from 1. Returns the status."""
    plan.ask(state, time)
    if word == "nearest":
        status: int = lib.yk_state_assemble(state)
        if status < 0:
            raise pose_error(status, message_of(state))
        return status
    found, _ = states(plan, time)
    labels = [plan.name_of(one) for one in found]
    chosen = [k for k, label in enumerate(labels) if k + 1 == word or label == word or str(k + 1) == word]
    there = "; ".join(f"{k + 1}: {label}" for k, label in enumerate(labels))
    if len(chosen) != 1:
        many = "several configurations are" if chosen else "no configuration is"
        raise refusal(PoseError, "E0609", f"{many} called `{word}` at the requested pose",
                      f"there are {there}" if found else "nothing closes there", "no-assembly")
    if lib.yk_state_copy(state, found[chosen[0]]) < 0:
        raise MemoryError("out of memory")
    plan.ask(state, time)
    status = lib.yk_state_solve(state)
    if status < 0:
        raise pose_error(status, message_of(state))
    return status
