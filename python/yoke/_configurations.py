"""Configurations: all that close at a pose, and the one that is meant."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Optional, Union

from ._native import ffi, lib
from ._pose import Pose
from ._problems import PoseError, refusal
from ._reach import Plan, Slot
from ._start import label_of, message_of, new_state, pose_error
from ._values import CData
from ._watch import check, keep

if TYPE_CHECKING:
    from ._machine import Machine


class Configurations(list):  # type: ignore[type-arg]
    """The poses of all configurations; `complete` is False where a larger group was searched, not enumerated."""

    complete: bool = True

    def __reduce__(self) -> Any:
        return _again, (list(self), self.complete)

    def _repr_html_(self) -> str:
        return "".join(pose._repr_html_() for pose in self)


def _again(poses: "list[Pose]", complete: bool) -> Configurations:
    result = Configurations(poses)
    result.complete = complete
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


def states(plan: Plan, time: float) -> tuple[list[CData], bool, int]:
    """Returns the states of all configurations at the asked pose, whether these are all, and the status."""
    state = new_state(plan.mech)
    plan.ask(state, time)
    found: list[CData] = []
    complete = ffi.new("bool *", True)
    handle = ffi.new_handle((found, plan.mech))
    status: int = lib.yk_state_each(state, lib.yk_host_visit, handle, complete)
    check()
    if status in (lib.YK_NO_MEMORY, lib.YK_STOPPED):
        raise pose_error(status, message_of(state))
    return found, bool(complete[0]), status


def same(plan: Plan, one: CData, other: CData) -> bool:
    """Tells whether two poses are the same configuration, up to whole turns."""
    size = lib.yk_mechanism_size(plan.mech)
    for c in plan.coordinates.values():
        off = lib.yk_state_coordinate(one, c.number).position - lib.yk_state_coordinate(other, c.number).position
        off = off / size if c.is_distance else math.remainder(off, 2 * math.pi)
        if not abs(off) < 1e-6:
            return False
    return True


def own(plan: Plan, time: float) -> Optional[CData]:
    """Returns the machine's own state at the asked pose, or None if it does not get there."""
    if plan.entry is None:
        return None
    state = new_state(plan.mech)
    try:
        plan.reach(state, time)
    except PoseError:
        return None
    return state


def is_own(plan: Plan, state: CData, time: float) -> bool:
    """Tells whether a configuration is the one that the machine gets to."""
    mine = own(plan, time)
    return mine is not None and same(plan, mine, state)


def find(machine: "Machine", plan: Plan, time: float, request: Any) -> Configurations:
    """Returns the poses of all configurations, with their forces."""
    mine = own(plan, time)
    found, complete, _ = states(plan, time)
    result = Configurations()
    result.complete = complete
    for k, state in enumerate(found):
        slot = Slot(plan, False)
        if lib.yk_state_copy(slot.state, state) < 0:
            raise MemoryError("out of memory")
        is_start = mine is not None and same(plan, mine, state)
        pose = machine._posed(plan, slot, request, 0, lib.YK_METHOD_REDUCED, is_start)
        pose.index = k
        result.append(pose)
    return result


def choose(plan: Plan, state: CData, time: float, word: Union[str, int]) -> int:
    """Puts a state in the configuration that is named: "nearest", a label, or a number from 1. Returns the status."""
    plan.ask(state, time)
    if word == "nearest":
        status: int = lib.yk_state_assemble(state)
        if status < 0:
            raise pose_error(status, message_of(state))
        return status
    found, _, _ = states(plan, time)
    labels = [label_of(one) for one in found]
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
