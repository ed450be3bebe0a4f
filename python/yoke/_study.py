"""Studies: one machine in many designs."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _sweep
from ._arrays import doubles
from ._core import channels_of, names_of
from ._native import ffi, lib
from ._problems import Problems, RequestError, refusal, text_of
from ._start import new_state, pose_error
from ._table import Column, Table, table
from ._values import TIME, CData, encoded
from ._watch import check, progress_of_host

if TYPE_CHECKING:
    from ._core import Core

REDUCED = ("min", "max", "mean", "range")


class Study:
    """A study's request: its machine, poses and columns."""

    def __init__(self, core: "Core", names: Sequence[str], of: Any, over: Any, steps: Any, at: Mapping[str, Any],
                 hold: _sweep.Holding, threads: Optional[int]) -> None:
        self.core, self.names, self.hold, self.at = core, list(names), hold, at
        self.swept: Optional[str] = None
        self.range = (0.0, 0.0)
        value: Any = None
        if over is not None:
            self.swept, value = _one(over)
        self.is_time = self.swept == "t" and "t" not in core.coordinates
        self.steps = _sweep.count(steps, "steps", 1_000_000) if over is not None else 0
        self.plan = core.plan(list(at), list(hold.rate), list(hold.accel), None if self.is_time else self.swept,
                              imposed=True)
        hold.fill(self.plan, at)
        if self.swept is not None:
            quantity = TIME if self.is_time else self.plan.coordinates[self.swept].quantity(0)
            self.range = _sweep.ends(core.model, value, quantity, self.swept)
            if self.is_time:
                hold.time = self.range[0]
            else:
                self.plan.holds[self.plan.hold_count - 1].value = self.range[0]
        self.columns = names_of(of)
        self.channels = channels_of(self.plan.mech, self.columns)
        forces = any(self.channels[k].kind >= lib.YK_CHANNEL_FORCE_X for k in range(len(self.columns)))
        if forces and hold.dynamics(self.plan) is None:
            raise refusal(RequestError, "E0819", "the machine has neither masses nor loads, and therefore no forces")
        self._stand(threads)
        self._poses()

    def _stand(self, threads: Optional[int]) -> None:
        """Makes the study from where the machine was assembled."""
        plan, start = self.plan, self.core.start
        self.state = new_state(plan.mech)
        options = ffi.new("YkStudyOptions *")
        if start.status >= 0:
            if plan.entry_status < 0:
                raise pose_error(plan.entry_status, "the machine cannot stand at its start with these inputs")
            lib.yk_state_copy(self.state, plan.entry)
            options.start = start.state
        elif not plan.untold:
            plan.reach(self.state, 0.0)  # raises
        else:
            plan._reach_otherwise(self.state, self.hold.time)
        problems = Problems()
        timed = self.timed = new_state(plan.mech)
        lib.yk_state_copy(timed, self.state)
        if lib.yk_state_set_time(timed, self.hold.time, problems.c) < 0:
            raise problems.fail(RequestError, fallback="the drives have no value at this time")
        kept = [ffi.new("char[]", encoded(name)) for name in self.names]
        parameters = ffi.new("char *[]", kept or [ffi.NULL])
        options.parameters, options.parameter_count = parameters, len(kept)
        options.channels, options.channel_count = self.channels, len(self.columns)
        options.threads = os.cpu_count() or 1 if threads is None else _sweep.count(threads, "threads", 1024)
        options.progress = progress_of_host
        study = lib.yk_study_new(timed, options, problems.c)
        if study == ffi.NULL:
            raise problems.fail(RequestError)

        def free(c: CData, keep: Any = (timed, start.state)) -> None:
            lib.yk_study_free(c)

        self.c = ffi.gc(study, free)

    def _poses(self) -> None:
        """Evaluates the inputs at every pose: over time all drives move, over a coordinate only that one."""
        plan, count = self.plan, self.steps + 1 if self.swept is not None else 1
        self.pose_count = count
        self.inputs = np.empty((3 * plan.inputs, count))
        low, high = self.range
        at = [high if k == self.steps else low + (high - low) * k / self.steps for k in range(count)] \
            if self.swept is not None else [0.0]
        self.times = np.array(at) if self.is_time else None
        state, problems = new_state(plan.mech), Problems()
        lib.yk_state_copy(state, self.state)
        for k in range(plan.hold_count):
            lib.yk_state_hold_input(state, plan.holds[k].input, plan.holds[k].order, plan.holds[k].value)
        moved = -1 if self.swept is None or self.is_time else plan.coordinates[self.swept].input
        for p in range(count):
            if p == 0 or self.is_time:
                if lib.yk_state_set_time(state, at[p] if self.is_time else self.hold.time, problems.c) < 0:
                    raise problems.fail(RequestError, fallback="the drives have no value at this time")
                motions = [lib.yk_state_input(state, i) for i in range(plan.inputs)]
            for i, m in enumerate(motions):
                position = at[p] if i == moved else m.position
                self.inputs[3 * i : 3 * i + 3, p] = position, m.velocity, m.acceleration

    def case(self, designs: Sequence[Any]) -> Any:
        """Returns the request for these designs, with what it points to."""
        case = ffi.new("YkStudyCase *")
        rows = [ffi.from_buffer("double[]", a) for a in designs]
        inputs = [ffi.from_buffer("double[]", a) for a in self.inputs]
        first, second = ffi.new("double *[]", rows or [ffi.NULL]), ffi.new("double *[]", inputs or [ffi.NULL])
        case.parameters, case.inputs = first, second
        case.design_count, case.pose_count = len(designs[0]) if designs else 1, self.pose_count
        times = ffi.NULL if self.times is None else ffi.from_buffer("double[]", self.times)
        case.times = times
        return case, (rows, inputs, first, second, times)


def _one(over: Any) -> tuple[str, Any]:
    if isinstance(over, Mapping) and len(over) == 1:
        name, value = next(iter(over.items()))
        return str(name), value
    raise refusal(RequestError, "E0812", f"over takes one range by name, not {over!r}",
                  'as in over={"theta": (0, 360, "deg")} or over={"t": (0, 2, "s")}')


def run(study: Study, designs: Mapping[str, Any], every_pose: bool) -> Table:
    """Computes all designs. Returns a row for each: parameters, status, number of valid poses, then the answers."""
    arrays = [doubles(a, n) for n, a in designs.items()]
    count, reduced = len(arrays[0]) if arrays else 1, study.swept is not None and not every_pose
    if any(a.shape != (count,) for a in arrays):
        raise refusal(RequestError, "E0806", "designs takes one-dimensional arrays of one length")
    names, poses = study.columns, study.pose_count
    shape: tuple[int, ...] = (poses,) if every_pose else ()
    answers = [f"{n}.{kind}" for n in names for kind in REDUCED] if reduced else names
    kind = np.dtype([(n, np.float64) for n in designs] + [("status", np.int8, shape), ("poses", np.int64)]
                    + [(n, np.float64, shape) for n in answers])
    data = np.empty(count, kind)
    for name, array in zip(designs, arrays):
        data[name] = array
    case, keep = study.case(arrays)
    (_reduce if reduced else _run)(study, case, data)
    del keep
    model = study.core.model
    heads = [Column(n, "", lib.yk_model_parameter_unit(model, encoded(n))) for n in designs]
    for c in _sweep.columns(model, study.channels, names):
        heads += [Column(f"{c.name}.{k}", c.unit, c.size) for k in REDUCED] if reduced else [c]
    return table(data, heads, f"{text_of(lib.yk_model_name(model))}: study of {', '.join(designs)}")


def _end(worst: int) -> None:
    check()
    if worst == lib.YK_NO_MEMORY:
        raise MemoryError("out of memory")
    if worst in (lib.YK_STOPPED, lib.YK_BAD_ARGUMENT):
        raise pose_error(worst, "the study was not completed")


def _reduce(study: Study, case: Any, data: Any) -> None:
    count = len(data)
    extents = np.empty((len(study.columns), count, 3))
    status, valid = np.empty(count, np.int8), np.empty(count, np.uint64)
    _end(lib.yk_study_reduce(study.c, case, ffi.from_buffer("YkExtent[]", extents),
                             ffi.from_buffer("signed char[]", status), ffi.from_buffer("size_t[]", valid)))
    data["status"], data["poses"] = status, valid
    extents[:, valid == 0] = np.nan
    for k, name in enumerate(study.columns):
        least, largest, mean = extents[k].T
        for word, values in zip(REDUCED, (least, largest, mean, largest - least)):
            data[f"{name}.{word}"] = values


def _run(study: Study, case: Any, data: Any) -> None:
    count, poses = len(data), study.pose_count
    values = np.empty((len(study.columns), count, poses))
    status = np.empty((count, poses), np.int8)
    rows = [ffi.from_buffer("double[]", v) for v in values]
    _end(lib.yk_study_run(study.c, case, ffi.new("double *[]", rows or [ffi.NULL]),
                          ffi.from_buffer("signed char[]", status)))
    data["status"] = status.reshape(data["status"].shape)
    data["poses"] = (status >= 0).sum(axis=1)
    for k, name in enumerate(study.columns):
        channel = study.channels[k]
        is_rate = channel.order > 0 or channel.kind == lib.YK_CHANNEL_POINT_SPEED
        is_lost = is_rate or channel.kind >= lib.YK_CHANNEL_FORCE_X  # at a dead point
        values[k][(status < 0) | ((status == lib.YK_SINGULAR) & bool(is_lost))] = np.nan
        data[name] = values[k].reshape(data[name].shape)


class Sensitivities(NamedTuple):
    """Derivatives of columns with respect to parameters, [column, parameter], in two ways that share only the pose.

    `by_derivative` covers positions in machines without gears, belts and cams; elsewhere it is NaN.
    """

    of: tuple[str, ...]
    parameters: tuple[str, ...]
    by_derivative: Any
    by_difference: Any


def sensitivities(study: Study) -> Sensitivities:
    """Finds derivatives at the machine's own values and the study's pose."""
    shape = (len(study.columns), len(study.names))
    first, second = np.empty(shape), np.empty(shape)
    _, (_, _, _, inputs, _) = keep = study.case([])
    status = lib.yk_study_sensitivities(study.c, inputs, ffi.from_buffer("double[]", first),
                                        ffi.from_buffer("double[]", second))
    del keep
    check()
    if status < 0:
        raise pose_error(status, "no sensitivities: a design next to the file's own has no valid pose")
    return Sensitivities(tuple(study.columns), tuple(study.names), first, second)


Over = Union[Mapping[str, Any], None]
