"""Sweeps: a coordinate, or time, through a range."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from ._core import channels_of, names_of
from ._native import ffi, lib
from ._problems import Problems, RequestError, refusal, status_name, text_of
from ._reach import Plan
from ._start import message_of, new_state
from ._table import Column, Event, Table, row_type, table
from ._values import TIME, CData, Value, named, shown, si, unit_of, words
from ._watch import check

if TYPE_CHECKING:
    from ._core import Core

Range = Union[Tuple[Value, Value], Tuple[float, float, str]]


def is_range(value: Any) -> bool:
    """Returns whether it is a range: (0, 360, "deg"), (0.0, 6.28) and ("0 deg", "1 rad") are, (30, "deg") is not."""
    if not isinstance(value, (tuple, list)):
        return False
    return len(value) == 3 or len(value) == 2 and (isinstance(value[0], str) or not isinstance(value[1], str))


def ends(model: CData, value: Any, quantity: int, name: str) -> tuple[float, float]:
    """Returns both ends of a range in SI; a unit after them applies to both."""
    if not is_range(value):
        raise refusal(RequestError, "E0812", f"`{name}` takes a range as (0, 360, \"deg\") or (\"0 mm\", \"60 mm\"), "
                      f"not {value!r}")
    if len(value) == 3:
        first, second = (f"{words(x, name)} {value[2]}" for x in value[:2])
        return si(model, first, quantity, name), si(model, second, quantity, name)
    return si(model, value[0], quantity, name), si(model, value[1], quantity, name)


def count(value: Any, name: str, most: int = 10_000_000) -> int:
    """Returns a whole number from 1 to `most`."""
    try:
        result = value.__index__()
    except (AttributeError, TypeError):
        result = 0
    if isinstance(value, bool) or not 1 <= result <= most:
        raise refusal(RequestError, "E0806", f"`{name}` takes a whole number from 1 to {most}, not {value!r}")
    return int(result)


def columns(model: CData, channels: CData, names: Sequence[str]) -> list[Column]:
    """Returns the columns of channels, with the file's units."""
    return [Column(name, *unit_of(model, channels[k].quantity)) for k, name in enumerate(names)]


def split(coordinates: Mapping[str, Any]) -> tuple[str, Any, dict[str, Any]]:
    """Returns the one name that has a range, its range, and the values of the others."""
    ranges = {name: value for name, value in coordinates.items() if is_range(value)}
    if len(ranges) != 1:
        raise refusal(RequestError, "E0804", "a sweep takes one range, as theta=(0, 360, \"deg\") or t=(0, 2, \"s\"), "
                      f"not {len(ranges)}", f"the machine has {', '.join(coordinates)}" if coordinates else None)
    name, value = next(iter(ranges.items()))
    return name, value, {n: v for n, v in coordinates.items() if n != name}


_EVENTS = {lib.YK_EVENT_LIMIT: "limit", lib.YK_EVENT_CHANGE_POINT: "change-point", lib.YK_EVENT_SINGULAR: "dead-point"}


def _event(e: CData, mech: CData, names: Sequence[str]) -> Event:
    if e.kind == lib.YK_EVENT_EXTREME:
        return Event("maximum" if e.is_maximum else "minimum", e.at, names[e.channel], e.value)
    where = text_of(lib.yk_block_info(mech, e.block).label) if e.block >= 0 else ""
    return Event(_EVENTS[e.kind], e.at, where, float("nan"))


def _words_of_limit(plan: Plan, sweep: CData, swept: str, quantity: int, state: CData) -> str:
    for k in reversed(range(lib.yk_sweep_event_count(sweep))):
        e = lib.yk_sweep_event(sweep, k)
        if e.kind != lib.YK_EVENT_LIMIT:
            continue
        text = f"{swept} goes no further than {shown(plan.core.model, e.at, quantity, 12)}"
        if e.block < 0:
            return text
        block = lib.yk_block_info(plan.mech, e.block)
        kind = text_of(lib.yk_block_kind_name(block.kind))
        return f"{text}: beyond, joint `{text_of(block.label)}` ({kind}) does not close"
    return message_of(state)


def run(core: "Core", coordinates: Mapping[str, Any], of: Any, steps: Any, hold: "Holding", method: int,
        turn_max: Optional[Value]) -> Table:
    """Sweeps and returns the rows, which end at a limit."""
    swept, value, at = split(coordinates)
    step_count = count(steps, "steps")
    is_time = swept == "t" and "t" not in core.coordinates
    plan = core.plan(list(at), list(hold.rate), list(hold.accel), None if is_time else swept, imposed=True)
    quantity = TIME if is_time else plan.coordinates[swept].quantity(0)
    low, high = ends(core.model, value, quantity, swept)
    hold.fill(plan, at)
    time = hold.time
    if is_time:
        time = low
    else:
        plan.holds[plan.hold_count - 1].value = low
    names = names_of(of) if of is not None else [name for name in plan.coordinates if name != swept]
    channels = channels_of(plan.mech, names)
    if swept in names:
        raise refusal(RequestError, "E0806", f"`of` names the swept `{swept}`, which is the first column already")
    options = ffi.new("YkSweepOptions *")
    options[0] = lib.yk_default_sweep_options()
    setattr(options, "from", low)
    options.coordinate, options.to, options.steps = -1 if is_time else plan.coordinates[swept].number, high, step_count
    options.method = method
    if turn_max is not None:
        options.turn_max = si(core.model, turn_max, lib.YK_QUANTITY_ANGLE, "turn_max")
    if any(channels[k].kind >= lib.YK_CHANNEL_FORCE_X for k in range(len(names))):
        dynamics = hold.dynamics(plan)
        if dynamics is None:
            raise refusal(RequestError, "E0819", "the machine has neither masses nor loads, and therefore no forces")
        options.dynamics = dynamics
    state = new_state(plan.mech)
    plan.reach(state, time)
    problems = Problems()
    sweep = lib.yk_sweep_run(state, options, channels, len(names), problems.c)
    if sweep == ffi.NULL:
        raise problems.fail(RequestError)
    sweep = ffi.gc(sweep, lib.yk_sweep_free)
    check()
    lib.yk_host_blank_rates(sweep, channels, len(names))
    head = Column(swept, *unit_of(core.model, quantity))
    result = _view(sweep, [swept, *names], [head, *columns(core.model, channels, names)],
                   f"{text_of(lib.yk_model_name(core.model))}: sweep over {swept}")
    status = lib.yk_sweep_status(sweep)
    result.events = tuple(_event(lib.yk_sweep_event(sweep, k), plan.mech, names)
                          for k in range(lib.yk_sweep_event_count(sweep)))
    result.status = "ok" if status == lib.YK_OK else status_name(status)
    if status == lib.YK_LIMIT:
        result.message = _words_of_limit(plan, sweep, swept, quantity, state)
    elif status != lib.YK_OK:
        result.message = message_of(state)
    return result


def _view(sweep: CData, names: Sequence[str], heads: Sequence[Column], caption: str) -> Table:
    """Returns the library's own rows as an array; they live as long as it does."""
    kind = row_type(names)
    rows = lib.yk_sweep_row_count(sweep)
    if rows == 0:
        return table(np.empty(0, kind), heads, caption)

    def free(c: CData, keep: CData = sweep) -> None:
        pass

    memory = ffi.gc(ffi.cast("double *", lib.yk_sweep_rows(sweep)), free)
    return table(np.frombuffer(ffi.buffer(memory, rows * kind.itemsize), kind), heads, caption)


class Holding:
    """The settings of a request other than its coordinates: rates, accelerations, efforts, and the time."""

    def __init__(self, core: "Core", time: Value, rate: Optional[Mapping[str, Value]],
                 accel: Optional[Mapping[str, Value]], effort: Optional[Mapping[str, Value]]) -> None:
        self.core = core
        self.rate, self.accel, self.effort = named(rate, "rate"), named(accel, "accel"), named(effort, "effort")
        self.time = si(core.model, time, TIME, "time")

    def fill(self, plan: Plan, at: Mapping[str, Value]) -> None:
        """Writes the values into the plan's holds, in its order."""
        k = 0
        for values in (at, self.rate, self.accel):
            for name, value in values.items():
                plan.holds[k].value = si(self.core.model, value, plan.quantities[k], name)
                k += 1

    def efforts(self) -> dict[int, float]:
        """Returns efforts by coordinate."""
        result = {}
        for name, value in self.effort.items():
            c = self.core.coordinate(name)
            quantity = lib.YK_QUANTITY_FORCE if c.is_distance else lib.YK_QUANTITY_TORQUE
            result[c.number] = si(self.core.model, value, quantity, name)
        return result

    def dynamics(self, plan: Plan) -> Any:
        """Returns dynamics with these efforts, or None without loads."""
        dynamics = plan.new_dynamics()
        for index, value in self.efforts().items():
            if dynamics is not None:
                lib.yk_dynamics_set_effort(dynamics, index, value)
        return dynamics


