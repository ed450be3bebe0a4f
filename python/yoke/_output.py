"""Pages and files: the report, C code, moving pictures."""
from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Union

from . import _sweep
from ._native import ffi, lib
from ._problems import ModelError, PoseError, Problems, RequestError, UnknownName, refusal, text_of
from ._start import message_of, new_state, pose_error
from ._values import TIME, CData, Value, encoded, si
from ._watch import progress_of_host

if TYPE_CHECKING:
    from ._core import Core


def finish(text: str, path: Union[str, "os.PathLike[str]", None]) -> Union[str, Path]:
    """Returns a string, or writes it to a file, which appears whole or not at all, and returns the file's path."""
    if path is None:
        return text
    target = Path(path)
    import tempfile

    handle, name = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(name, 0o666 & ~mask)
        os.replace(name, target)
    except BaseException:
        os.unlink(name)
        raise
    return target


def _state(core: "Core", swept: Optional[str]) -> tuple[Any, CData]:
    """Returns a plan and its state at the start; without a pose if the machine cannot be assembled."""
    plan = core.plan([], swept=swept)
    state = new_state(plan.mech)
    if swept is not None and plan.entry is not None:
        coordinate = plan.coordinates[swept]
        plan.holds[0].value = lib.yk_state_coordinate(plan.entry, coordinate.number).position
    try:
        plan.reach(state, 0.0)
    except PoseError as error:
        if error.status != "no-assembly":
            raise
        plan.ask(state, 0.0)
    return plan, state


def _page(core: "Core", over: Optional[Mapping[str, Any]], steps: Optional[int], to: Optional[Value],
          trace: Sequence[str], plain: bool, pose_rate: float) -> CData:
    swept, value = next(iter(over.items())) if over else (None, None)
    is_time = swept == "t" and "t" not in core.coordinates
    plan, state = _state(core, None if is_time else swept)
    options = ffi.new("YkReportOptions *")
    options[0] = lib.yk_default_report_options()
    if swept is not None:
        quantity = TIME if is_time else plan.coordinates[swept].quantity(0)
        low, high = _sweep.ends(core.model, value, quantity, swept)
        options.has_range, options.coordinate = True, -1 if is_time else plan.coordinates[swept].number
        setattr(options, "from", low)
        options.to = high
    name = ffi.new("char[]", encoded(swept or ""))
    inputs, compile_ = ffi.new("char *[]", [name]), ffi.new("YkCompileOptions *")
    compile_.inputs, compile_.input_count = inputs, 1
    if swept is not None and not is_time and plan.mech is not core.base:
        options.compile = compile_
    options.steps = 0 if steps is None else _sweep.count(steps, "steps")
    options.duration = 0.0 if to is None else si(core.model, to, TIME, "to")
    unknown = [point for point in trace if point not in core.points]
    if unknown:
        raise refusal(UnknownName, "E0815", f"the machine has no point `{unknown[0]}`",
                      "a point is written body.point, as in `coupler.P`")
    points = ffi.new("size_t[]", [core.points[point] for point in trace] or 1)
    options.traced_points, options.traced_count = points, len(trace)
    options.is_plain, options.pose_rate = plain, pose_rate
    problems = Problems()
    report = lib.yk_report_new(state, options, problems.c)
    if report == ffi.NULL:
        raise problems.fail(RequestError)

    def free(c: CData, keep: Any = (state, points, name, inputs, compile_, options)) -> None:
        lib.yk_report_free(c)

    return ffi.gc(report, free)


def report(core: "Core", *, over: Optional[Mapping[str, Any]] = None, steps: Optional[int] = None,
           to: Optional[Value] = None, trace: Sequence[str] = (), plain: bool = False) -> str:
    """Returns the report as an HTML document."""
    page = _page(core, over, steps, to, trace, plain, 0.0)
    problems = Problems()
    html = lib.yk_report_html(page, problems.c)
    if html == ffi.NULL:
        raise problems.fail(ModelError)
    return text_of(html)


def animation(core: "Core", seconds: Optional[float], rate: float) -> str:
    """Returns a moving picture of the machine as an SVG document."""
    page = _page(core, None, None, None, (), False, rate)
    drawing = lib.yk_report_drawing(page)
    if drawing == ffi.NULL:
        raise pose_error(lib.YK_NO_ASSEMBLY, "the motion cannot be drawn")
    svg = lib.yk_drawing_animation(drawing, lib.yk_report_seconds(page) if seconds is None else seconds,
                                   lib.yk_report_goes_back(page))
    if svg == ffi.NULL:
        raise MemoryError("out of memory")
    return text_of(svg)


def code(core: "Core", prefix: Optional[str], single: bool, kinematics: bool) -> str:
    """Returns C11 for the machine."""
    if prefix is not None and not re.fullmatch("[A-Za-z][A-Za-z0-9_]{0,59}", str(prefix)):
        raise refusal(RequestError, "E0806", f"prefix takes a C name that begins with a letter, not `{prefix}`")
    options, problems = ffi.new("YkCSourceOptions *"), Problems()
    options[0] = lib.yk_default_c_source_options()
    name = ffi.NULL if prefix is None else ffi.new("char[]", str(prefix).encode())
    options.prefix, options.single, options.kinematics = name, single is True, kinematics is True
    options.progress = progress_of_host
    if core.parameters:
        if core.start.status < 0:
            raise pose_error(core.start.status, message_of(core.start.state))
        options.pose = core.start.state
    source = lib.yk_c_source_new(core.model, options, problems.c)
    if source == ffi.NULL:
        raise problems.fail(ModelError)
    source = ffi.gc(source, lib.yk_c_source_free)
    return text_of(lib.yk_c_source_text(source))
