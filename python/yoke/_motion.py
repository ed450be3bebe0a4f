"""Motion in time as rows."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _sweep
from ._core import channels_of, names_of
from ._native import ffi, lib
from ._problems import RequestError, UnknownName, refusal, status_name, text_of
from ._table import Column, Table, row_type, table
from ._values import TIME, Value, si, unit_of
from ._watch import check

if TYPE_CHECKING:
    from ._core import Core
    from ._simulation import Simulation


def usual_columns(core: "Core") -> list[str]:
    """Returns the coordinates that the file names, or all, and the energy."""
    named = [c.name for c in core.coordinates.values() if c.is_declared]
    return [*(named or core.coordinates), "energy"]


def rows(sim: "Simulation", start: float, to: float, every: Optional[Value], steps: int, of: Any) -> Table:
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
    """Returns the number of rows after the first; the last row is at the end, even if the last span is shorter."""
    count = span / every
    if not count <= 10_000_000:
        raise refusal(RequestError, "E0806", "every: more than 10 million rows")
    whole = round(count)
    return max(1, whole if abs(count - whole) < 1e-9 * count else math.ceil(count))
