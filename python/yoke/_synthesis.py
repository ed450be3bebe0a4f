"""Synthesis: from a task to machines that fulfil it."""
from __future__ import annotations

import os
from math import isnan
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np

from . import _sweep
from ._native import ffi, lib
from ._pose import Svg
from ._problems import Error, Problems, text_of
from ._values import CData, encoded
from ._watch import Progress, Watch, check

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._machine import Machine


class TaskError(Error, ValueError):
    """The task's file is wrong, or asks for something that cannot be searched for."""


class Dyad(NamedTuple):
    """A link between the ground and the moving body: "RR" with two pins, "PR" with a slide on the ground, "RP" on the body."""

    kind: str
    fixed: tuple[float, float]
    moving: tuple[float, float]
    length: float  # length of the link, m; 0 with a slide
    direction: float  # angle of the line, rad; 0 with two pins


class Candidate(NamedTuple):
    """A machine that does what the task asks; all numbers in SI. `machine()` loads it."""

    model: str  # the model file's text
    mechanism: str
    type: str  # "crank-rocker", ...: as driven
    error: float  # sum of squares: of distances (m^2), angles (rad^2), or both by weight
    worst: float  # the largest single deviation
    transmission: tuple[float, float]  # least and largest transmission angle over the motion
    size: float  # length of the longest link
    circuits: int
    pivots: tuple[tuple[float, float], tuple[float, float]]
    lengths: tuple[float, float, float, float]  # ground, input, coupler, output
    # Signed distance of the slider's line from the input's pivot, positive to the line's left (slider-crank), or of
    # the output's pivot from the coupler's line (inverted slider-crank); None for others.
    offset: Optional[float]
    point: tuple[float, float]  # a point of the coupler, in its axes
    dyads: Optional[tuple[int, int]]
    parameters: dict[str, float]
    angles: "NDArray[np.float64]"  # angles of the input at the points of a path
    curve: "NDArray[np.float64]"  # [k, 2]: the coupler point's path; of functions the input angle and the error
    defect: Optional[str]  # why it was left out; None if it is a candidate

    def machine(self) -> "Machine":
        """Loads the machine."""
        from ._machine import parse

        return parse(self.model, f"{self.type or self.mechanism}.yaml")

    def _repr_svg_(self) -> str:
        return self.machine().svg()


class Synthesis(list):  # type: ignore[type-arg]
    """The candidates of a task, the best first.

    complete    whether all machines were searched for: not if the task leaves a choice, which is sampled, nor for paths
    stopped     whether the search was ended early; then the same seed need not give the same answer again
    solutions   how many solutions the equations have, complex and real, if finitely many; otherwise None
    left_out    how many machines were left out, by their defect: "branch", "circuit", "order", ...
    defects     those machines
    """

    task: str = ""
    kind: str = ""
    seed: int = 1
    complete: bool = False
    stopped: bool = False
    solutions: Optional[tuple[int, int]] = None
    dyads: tuple[Dyad, ...] = ()
    left_out: dict[str, int] = {}
    defects: tuple[Candidate, ...] = ()
    picture: Svg = Svg("")

    def __reduce__(self) -> Any:
        return _again, (list(self), dict(self.__dict__))

    def _repr_svg_(self) -> str:
        return str(self.picture)

    def __repr__(self) -> str:
        return f"<yoke.Synthesis {self.task!r}: {len(self)} machines, {sum(self.left_out.values())} left out>"


def _again(found: "list[Candidate]", facts: "dict[str, Any]") -> Synthesis:
    result = Synthesis(found)
    result.__dict__.update(facts)
    return result


def _pair(values: CData) -> tuple[float, float]:
    return values[0], values[1]


def _array(read: Any, size: int) -> "NDArray[np.float64]":
    data, count = read
    return np.frombuffer(ffi.buffer(data, 8 * size * count)).copy() if count else np.empty(0)


def _angles(synthesis: CData, k: int) -> "NDArray[np.float64]":
    count = ffi.new("size_t *")
    data = lib.yk_synthesis_angles(synthesis, k, count)
    return _array((data, count[0] if data != ffi.NULL else 0), 1)


def _curve(synthesis: CData, k: int) -> "NDArray[np.float64]":
    data = ffi.new("double **")
    count = lib.yk_synthesis_curve(synthesis, k, data)
    return _array((data[0], count), 2).reshape(-1, 2)


def _parameters(synthesis: CData, k: int) -> dict[str, float]:
    found: dict[str, float] = {}
    value = ffi.new("double *")
    while True:
        name = lib.yk_synthesis_parameter(synthesis, k, len(found), value)
        if name == ffi.NULL:
            return found
        found[text_of(name)] = value[0]


def _candidate(synthesis: CData, k: int, c: CData, is_kept: bool) -> Candidate:
    return Candidate(
        text_of(c.model), text_of(c.mechanism), text_of(c.type), c.error, c.worst, _pair(c.transmission), c.size, c.circuits,
        (_pair(c.pivots[0]), _pair(c.pivots[1])), (c.lengths[0], c.lengths[1], c.lengths[2], c.lengths[3]), None if isnan(c.offset) else c.offset, _pair(c.point),
        (c.dyads[0], c.dyads[1]) if c.dyads[0] >= 0 else None, _parameters(synthesis, k) if is_kept else {},
        _angles(synthesis, k) if is_kept else np.empty(0), _curve(synthesis, k) if is_kept else np.empty((0, 2)),
        None if is_kept else text_of(lib.yk_defect_name(c.defect)))


def _dyad(c: CData) -> Dyad:
    kind = {lib.YK_DYAD_RR: "RR", lib.YK_DYAD_PR: "PR", lib.YK_DYAD_RP: "RP"}[c.kind]
    return Dyad(kind, _pair(c.fixed), _pair(c.moving), c.length, c.direction)


def _run(task: CData, seed: int, best: int) -> CData:
    options = ffi.new("YkSynthesisOptions *", lib.yk_default_synthesis_options())
    options.seed, options.best, options.progress = seed, best, lib.yk_host_progress()
    problems = Problems()
    made = lib.yk_synthesis_run(task, options, problems.c)
    if made == ffi.NULL:
        raise problems.fail(TaskError)
    made = ffi.gc(made, lib.yk_synthesis_free)
    check()
    problems.warn(4)
    return made


def _load(task: Union[str, "os.PathLike[str]"]) -> CData:
    problems = Problems()
    if isinstance(task, str) and "\n" in task:
        data = encoded(task)
        made = lib.yk_task_parse(data, len(data), b"task.yaml", problems.c)
    else:
        made = lib.yk_task_load(encoded(os.fspath(task)), problems.c)
    if made == ffi.NULL:
        raise problems.fail(TaskError)
    made = ffi.gc(made, lib.yk_task_free)
    problems.warn(4)
    return made


def synthesize(task: Union[str, "os.PathLike[str]"], *, seed: int = 1, best: int = 0,
               progress: Progress = None) -> Synthesis:
    """Finds machines for a task: the path of its file, or its text if that has several lines.

    seed   of the samples, if the task leaves a choice
    best   how many candidates are kept; 0: as many as the task says, or 10
    """
    with Watch(progress, "synthesize"):
        own = _load(task)
        run = _run(own, _sweep.count(seed, "seed"), _sweep.count(best, "best") if best else 0)
        result = Synthesis(_candidate(run, k, lib.yk_synthesis_candidate(run, k), True)
                           for k in range(lib.yk_synthesis_count(run)))
        result.task, result.kind = text_of(lib.yk_task_name(own)), text_of(lib.yk_task_kind(own))
        result.seed, result.complete = seed, bool(lib.yk_synthesis_is_complete(run))
        result.stopped = bool(lib.yk_synthesis_was_stopped(run))
        total, real = ffi.new("size_t *"), ffi.new("size_t *")
        if lib.yk_synthesis_solutions(run, total, real):
            result.solutions = total[0], real[0]
        result.dyads = tuple(_dyad(lib.yk_synthesis_dyad(run, k)) for k in range(lib.yk_synthesis_dyad_count(run)))
        counts = {text_of(lib.yk_defect_name(k)): lib.yk_synthesis_left_out(run, k) for k in range(1, lib.YK_DEFECT_COUNT)}
        result.left_out = {name: count for name, count in counts.items() if count}
        result.defects = tuple(_candidate(run, k, lib.yk_synthesis_defect(run, k), False)
                               for k in range(lib.yk_synthesis_defect_count(run)))
        drawn = lib.yk_synthesis_picture(run)
        if drawn == ffi.NULL:
            raise MemoryError("out of memory")
        result.picture = Svg(text_of(drawn))
        return result
