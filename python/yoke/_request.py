"""A simulation's options and start values, read once."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional

from . import _sweep
from ._native import ffi, lib
from ._problems import ModelError, PoseError, Problems, RequestError, refusal
from ._start import new_state
from ._values import TIME, CData, Value, encoded, si

if TYPE_CHECKING:
    from ._core import Core

METHODS = {"dop853": lib.YK_INTEGRATOR_DOP853, "sdirk4": lib.YK_INTEGRATOR_SDIRK4, "rk4": lib.YK_INTEGRATOR_RK4}


class Request:
    """A simulation's options and start values, read once; `new` begins one."""

    def __init__(self, core: "Core", *, start: Value = 0.0, to: Optional[float] = None, at: Mapping[str, Value],
                 rate: Mapping[str, Value], effort: Mapping[str, Value], method: str = "dop853",
                 tolerance: Optional[float] = None, step: Optional[Value] = None, pulls: int = 0,
                 steps_max: int = 0) -> None:
        self.core = core
        if method not in METHODS:
            raise refusal(RequestError, "E0806", f"method takes dop853, sdirk4 or rk4 here, not `{method}`")
        if step is not None and method != "rk4":
            raise refusal(RequestError, "E0806", "step: only method=\"rk4\" has a fixed step")
        if tolerance is not None and method == "rk4":
            raise refusal(RequestError, "E0806", "tolerance: method=\"rk4\" has a fixed step and no tolerance")
        self.plan = core.plan(list(at))
        self.start = si(core.model, start, TIME, "start")
        self.options = options = ffi.new("YkSimulationOptions *")
        options[0] = lib.yk_default_simulation_options()
        options.integrator = METHODS[method]
        if tolerance is not None:
            options.tolerance = si(core.model, tolerance, lib.YK_QUANTITY_NUMBER, "tolerance")
        if not 1e-15 <= options.tolerance <= 0.1:
            raise refusal(RequestError, "E0806", f"tolerance takes a number from 1e-15 to 0.1, not {tolerance!r}")
        if step is not None:
            options.step = si(core.model, step, TIME, "step")
            if options.step <= 0:
                raise refusal(RequestError, "E0806", f"step must be greater than 0, not {step!r}")
        options.start, options.horizon = self.start, 0.0 if to is None else to
        options.pulls, options.steps_max = pulls, steps_max
        self.span = ffi.new("double[2]", [self.start, self.start if to is None else to])
        options.goes_on, options.context = ffi.addressof(lib, "yk_host_goes_on_in_time"), self.span
        self._names: list[Any] = []
        self._start_values(at, rate)
        self.effort = {self.free(name).name: _sweep.Holding(core, 0.0, None, None, {name: x}).efforts()
                       for name, x in effort.items()}

    def free(self, name: str) -> Any:
        c = self.core.coordinate(name)
        if c.has_drive:
            raise refusal(RequestError, "E0822", f"`{name}` is driven: its drive says where it starts, and exerts the "
                          "effort that its motion takes")
        return c

    def _start_values(self, at: Mapping[str, Value], rate: Mapping[str, Value]) -> None:
        core, pairs = self.core, [(n, v, 0) for n, v in at.items()] + [(n, v, 1) for n, v in rate.items()]
        self.values = ffi.new("YkStartValue[]", len(pairs) + 1)
        for k, (name, value, order) in enumerate(pairs):
            c = self.free(name)
            self._names.append(ffi.new("char[]", encoded(name)))
            self.values[k].coordinate, self.values[k].is_rate = self._names[-1], bool(order)
            self.values[k].value = si(core.model, value, c.quantity(order), name)
            if order == 0:
                self.plan.holds[k].value = self.values[k].value
        self.options.values, self.options.value_count = self.values, len(pairs)
        self.inputs = ffi.new("char *[]", self._names[: len(at)] or [ffi.NULL])
        self.compile = ffi.new("YkCompileOptions *")
        self.compile.inputs, self.compile.input_count = self.inputs, len(at)
        self.options.compile = self.compile if at else ffi.NULL

    def new(self) -> CData:
        """Moves the machine to its start and begins a simulation there."""
        state = new_state(self.plan.mech)
        self.plan.reach(state, self.start)
        self.options.pose = state
        problems = Problems()
        simulation = lib.yk_simulation_new(self.core.model, self.options, problems.c)
        if simulation == ffi.NULL:
            is_pose = any(p.code in ("E0601", "E0602") for p in problems.list())
            raise problems.fail(PoseError if is_pose else ModelError)
        problems.warn(4)

        def free(c: CData, keep_alive: Any = (self, state, self.core.model)) -> None:
            lib.yk_simulation_free(c)

        simulation = ffi.gc(simulation, free)
        for name, value in self.effort.items():
            status = lib.yk_simulation_set_effort(simulation, encoded(name), next(iter(value.values())))
            if status < 0:
                raise refusal(RequestError, "E0806", f"the effort along `{name}` cannot be set")
        return simulation
