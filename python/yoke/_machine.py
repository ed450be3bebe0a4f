"""The machine, which `yoke.load` returns and whose methods give all answers."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Mapping, Optional, Sequence, Union

from . import _batch, _configurations, _designs, _equations, _many, _map, _output, _regions, _study, _sweep
from ._core import Core
from ._identity import Identity, PathLike, Values
from ._native import lib
from ._pose import Pose, Svg
from ._problems import RequestError, refusal, text_of
from ._reach import Plan, Slot
from ._request import Request
from ._simulation import Simulation
from ._table import Table
from ._values import TIME, Value, named, si
from ._watch import Progress, Watch

METHODS = {"reduced": lib.YK_METHOD_REDUCED, "newton-euler": lib.YK_METHOD_NEWTON_EULER}
_NONE: Mapping[str, Any] = {}


class Machine(Identity):
    """A planar machine: loaded by `yoke.load`, or made by calls.

    Values are numbers in SI and radians, strings with a unit such as "60 mm", or pairs such as (30, "deg").
    Coordinates are keyword arguments, or entries of `at` if their names are not identifiers. All answers are in SI
    and radians.

    >>> m = Machine("pendulum").gravity(0, -9.81).body("ground", {"O": (0, 0)})
    >>> m = m.body("rod", {"O": (0, 0), "P": (0, -0.5)}, mass=2, rod=("O", "P"))
    >>> m = m.pin("O", "ground", "rod", angle="theta").start("theta", "30 deg")
    >>> round(m.solve().points["rod.P"].position[0], 6)
    0.25
    """

    __slots__ = ()

    # --- a pose

    def solve(self, *, time: Value = 0.0, at: Values = None, rate: Values = None, accel: Values = None,
              effort: Values = None, assembly: Union[str, int, None] = None, method: str = "reduced",
              **coordinates: Value) -> Pose:
        """Moves the machine to a pose and returns it, with forces if there are masses or loads.

        Without arguments it is the pose of `start:` at t = 0. `time` follows the drives, coordinates are set in place
        of their drives, and `rate`, `accel` and `effort` set rates, accelerations and efforts by name. `assembly`
        chooses another configuration: "nearest", a label, or its number in `configurations`, from 1. Raises PoseError
        if a limit is in the way.
        """
        with self._lock:
            core = self._kept if self._kept is not None else self._ready()
            if at is not None:
                coordinates = named(at, "at", coordinates)
            if rate is not None or accel is not None or effort is not None or assembly is not None:
                return self._solve_more(core, time, coordinates, rate, accel, effort, assembly, method)
            plan = core.plans.get((tuple(coordinates), (), (), None, False)) or core.plan(list(coordinates))
            k, model, holds, quantities = 0, core.model, plan.holds, plan.quantities
            for name, value in coordinates.items():
                holds[k].value = si(model, value, quantities[k], name)
                k += 1
            seconds = si(model, time, TIME, "time")
            slot = plan.take()
            status = plan.reach(slot.state, seconds)
            request = {"time": seconds, "at": coordinates} if coordinates or seconds else _NONE
            pose = self._posed(plan, slot, request, status, METHODS.get(method), True)
            pose.notes = plan.notes
            return pose

    def _posed(self, plan: Plan, slot: Slot, request: Any, status: int, method: Any, is_start: bool) -> Pose:
        """Finds the forces at a pose that was reached."""
        if method is None:
            raise refusal(RequestError, "E0806", "method takes reduced or newton-euler here")
        forces = 0
        if slot.dynamics is not None and lib.yk_state_has_rates(slot.state):
            forces = lib.yk_dynamics_solve(slot.dynamics, slot.state, method)
        pose = Pose(self, plan, slot, request, forces or status, is_start)
        if forces not in (lib.YK_OK, lib.YK_REDUNDANT):
            pose.message, pose._forces = text_of(lib.yk_dynamics_report(slot.dynamics).message), False
        elif pose._forces and not lib.yk_state_has_rates(slot.state):
            pose._forces = False
        return pose

    def _solve_more(self, core: Core, time: Value, coordinates: Mapping[str, Value], rate: Values, accel: Values,
                    effort: Values, assembly: Union[str, int, None], method: str) -> Pose:
        hold = _sweep.Holding(core, time, rate, accel, effort)
        plan = core.plan(list(coordinates), list(hold.rate), list(hold.accel))
        hold.fill(plan, coordinates)
        slot = plan.take() if not hold.effort else Slot(plan, False)
        for index, value in hold.efforts().items():
            if slot.dynamics is not None:
                lib.yk_dynamics_set_effort(slot.dynamics, index, value)
        request = {"time": hold.time, "at": dict(coordinates), "rate": hold.rate, "accel": hold.accel,
                   "effort": hold.effort, "assembly": assembly, "method": method}
        if assembly is None:
            status = plan.reach(slot.state, hold.time)
            pose = self._posed(plan, slot, request, status, METHODS.get(method), True)
            pose.notes = plan.notes
            return pose
        status = _configurations.choose(plan, slot.state, hold.time, assembly)
        is_start = _configurations.is_own(plan, slot.state, hold.time)
        return self._posed(plan, slot, request, status, METHODS.get(method), is_start)

    def configurations(self, *, time: Value = 0.0, at: Values = None, progress: Progress = None,
                       **coordinates: Value) -> "_configurations.Configurations":
        """Returns every configuration that closes at a pose; the list's `complete` says whether these are all."""
        with self._lock, Watch(progress, "configurations"):
            core = self._ready()
            coordinates = named(at, "at", coordinates)
            hold = _sweep.Holding(core, time, None, None, None)
            plan = core.plan(list(coordinates))
            hold.fill(plan, coordinates)
            return _configurations.find(self, plan, hold.time, {"time": hold.time, "at": coordinates})

    def map(self, over: Optional[str] = None, *, time: Value = 0.0, at: Values = None, progress: Progress = None,
            **coordinates: Value) -> _map.Map:
        """Maps the whole motion of a machine with one freedom: all circuits, limits, change points and dead points.

        over   the coordinate that is mapped, by default the first input; `at` holds other inputs
        """
        with self._lock, Watch(progress, "map"):
            return _map.Map(self, self._ready(), over, time, named(at, "at", coordinates))

    def regions(self, over: Any = None, *, tolerance: float = 1e-3, time: Value = 0.0, at: Values = None, progress: Progress = None,
                **coordinates: Value) -> _regions.Regions:
        """Maps two freedoms: the regions of their plane in which the machine has equally many configurations.

        over   two coordinates, "theta1,theta2" or a list; by default the inputs that `at` does not hold
        """
        with self._lock, Watch(progress, "regions"):
            return _regions.Regions(self, self._ready(), over, tolerance, time, named(at, "at", coordinates))

    # --- many poses

    def sweep(self, *, steps: int = 36, of: Any = None, time: Value = 0.0, at: Optional[Mapping[str, Any]] = None,
              rate: Values = None, accel: Values = None, effort: Values = None, method: str = "reduced",
              turn_max: Optional[Value] = None, progress: Progress = None, **coordinates: Any) -> Table:
        """Moves a coordinate, or the time `t`, through a range and returns a row for each step, and one more.

        The range is a pair, with or without a unit: theta=(0, 360, "deg"). No limit, dead point, change point or
        extreme between the rows is missed; they are the table's `events`. At a limit the rows end, and `status` is
        "limit". The rows are the library's own memory, not a copy.
        """
        with self._lock, Watch(progress, "sweep"):
            core = self._ready()
            if method not in METHODS:
                raise refusal(RequestError, "E0806", f"method takes reduced or newton-euler here, not `{method}`")
            hold = _sweep.Holding(core, time, rate, accel, effort)
            return _sweep.run(core, named(at, "at", coordinates), of, steps, hold, METHODS[method], turn_max)

    def batch(self, of: Any, *, at: Optional[Mapping[str, Any]] = None, rate: Optional[Mapping[str, Any]] = None,
              accel: Optional[Mapping[str, Any]] = None, out: Any = None, **coordinates: Any) -> _batch.Columns:
        """Solves many independent poses at once: arrays of input values in, an array for each column out.

        Every pose lies on the machine's branches, whether or not it could get there. If `status` is below 0, the
        pose does not exist and its answers are 0. `out`, an array [column, pose], receives the answers in place of a new
        array.
        """
        with self._lock:
            positions, rates, accelerations = named(at, "at", coordinates), named(rate, "rate"), named(accel, "accel")
            return _batch.run(self._ready(), positions, rates, accelerations, of, out)

    def study(self, *, vary: Optional[Mapping[str, Any]] = None, sample: Any = None,
              designs: Union[Mapping[str, Any], int, None] = None, of: Any, over: _study.Over = None, steps: int = 36,
              seed: Optional[int] = None, every_pose: bool = False, threads: Optional[int] = None, time: Value = 0.0,
              at: Values = None, rate: Values = None, accel: Values = None, effort: Values = None,
              progress: Progress = None) -> Table:
        """Computes many designs of the machine, each with its own parameters, on all processors.

        vary     a grid, such as {"r": ("40 mm", "60 mm", 100)}
        sample   distributions, such as {"r": yoke.normal("50 mm", "0.1 mm")}, or the path of a file of them;
                 `designs` is the number of samples, `seed` that of their random numbers
        designs  the designs themselves: arrays in SI by parameter
        over     poses of each design, such as {"theta": (0, 360, "deg")} in `steps` steps; returns the least, largest
                 and mean value and the range of each column, or with every_pose the values at all poses
        """
        with self._lock, Watch(progress, "study"):
            core = self._ready()
            given = designs if isinstance(designs, Mapping) else None
            if sum(x is not None for x in (vary, sample, given)) != 1:
                raise refusal(RequestError, "E0804", "a study takes one of vary, sample and designs")
            if vary is not None:
                values = _designs.grid(core.model, named(vary, "vary"))
            elif given is not None:
                values = dict(given)
            else:
                values = _designs.sampled(core, sample, designs if isinstance(designs, int) else None, seed)
            hold = _sweep.Holding(core, time, rate, accel, effort)
            study = _study.Study(core, list(values), of, over, steps, named(at, "at"), hold, threads)
            return _study.run(study, values, every_pose)

    def sensitivities(self, parameters: Sequence[str], of: Any, *, time: Value = 0.0, at: Values = None,
                      **coordinates: Value) -> _study.Sensitivities:
        """Returns derivatives of columns with respect to parameters at a pose."""
        with self._lock:
            core = self._ready()
            hold = _sweep.Holding(core, time, None, None, None)
            study = _study.Study(core, parameters, of, None, 1, named(at, "at", coordinates), hold, 1)
            return _study.sensitivities(study)

    # --- motion in time

    def simulate(self, to: Value, *, of: Any = None, start: Value = 0.0, every: Optional[Value] = None,
                 steps: int = 100, at: Values = None, rate: Values = None, effort: Values = None,
                 events: Optional[Mapping[str, Value]] = None, method: str = "dop853",
                 tolerance: Optional[float] = None, step: Optional[Value] = None, progress: Progress = None,
                 **coordinates: Value) -> Table:
        """Returns the motion under loads from `start:` as rows in time, with events and a summary.

        events   crossings to report, such as {"theta": "90 deg"}
        method   "dop853", "sdirk4" for stiff machines, or "rk4" with a fixed `step`
        """
        with self._lock, Watch(progress, "simulate"):
            core = self._ready()
            end = si(core.model, to, TIME, "to")
            request = Request(core, start=start, to=end, at=named(at, "at", coordinates), rate=named(rate, "rate"),
                                      effort=named(effort, "effort"), method=method, tolerance=tolerance, step=step)
            with Simulation(self, request, None) as simulation:
                for name, value in named(events, "events").items():
                    simulation.watch(f"{name}={value}", name, value)
                return simulation.rows(end, every=every, steps=steps, of=of)

    def simulation(self, *, start: Value = 0.0, at: Values = None, rate: Values = None, effort: Values = None,
                   method: str = "dop853", tolerance: Optional[float] = None, step: Optional[Value] = None,
                   **coordinates: Value) -> Simulation:
        """Begins a simulation that the caller steps and acts on."""
        with self._lock:
            core = self._ready()
            kept: dict[str, Any] = {"start": start, "at": named(at, "at", coordinates), "rate": named(rate, "rate"),
                    "effort": named(effort, "effort"), "method": method, "tolerance": tolerance, "step": step}
            request = Request(core, start=start, at=kept["at"], rate=kept["rate"], effort=kept["effort"],
                                      method=method, tolerance=tolerance, step=step)
            return Simulation(self, request, kept)

    def simulations(self, count: int, *, of: Any = None, effort: Sequence[str] = (),
                    at: Optional[Mapping[str, Any]] = None, rate: Optional[Mapping[str, Any]] = None,
                    method: str = "dop853",
                    tolerance: Optional[float] = None, step: Optional[Value] = None,
                    threads: Optional[int] = None) -> _many.Simulations:
        """Begins many simulations that are stepped together: arrays of efforts in, arrays of channels out."""
        with self._lock:
            return _many.Simulations(self, count, of=of, effort=effort, at=named(at, "at"), rate=named(rate, "rate"),
                                     method=method, tolerance=tolerance, step=step, threads=threads)

    # --- equations and pages

    def derive(self, what: Union[str, Sequence[str], None] = None, *, pose: Optional[Pose] = None,
               progress: Progress = None) -> _equations.Equations:
        """Derives the machine's equations: "loops", "lagrange", ... or all; with `pose`, values beside the symbols."""
        with self._lock, Watch(progress, "derive"):
            self._ready()
            return _equations.Equations(self, what, pose)

    def check(self, equation: str, *, progress: Progress = None) -> _equations.Verdict:
        """Decides whether an equation in the machine's names is true for it; the verdict is true or false as a bool."""
        with self._lock, Watch(progress, "check"):
            core = self._ready()
            plan = core.plan([])
            slot = Slot(plan, False)  # its state changes
            status = plan.reach(slot.state, 0.0)
            pose = self._posed(plan, slot, _NONE, status, METHODS["reduced"], True)
            return _equations.verdict_on(self, equation, pose)

    def report(self, path: Optional[PathLike] = None, *, progress: Progress = None, **options: Any) -> Union[str, Path]:
        """Returns the report as HTML, or writes it to a file, which appears whole or not at all."""
        with self._lock, Watch(progress, "report"):
            return _output.finish(_output.report(self._ready(), **options), path)

    def code(self, path: Optional[PathLike] = None, *, prefix: Optional[str] = None, single: bool = False,
             kinematics: bool = False) -> Union[str, Path]:
        """Returns C for this machine, or writes it to a file, which appears whole or not at all."""
        with self._lock:
            return _output.finish(_output.code(self._ready(), prefix, single, kinematics), path)

    def svg(self, width: float = 800, labels: bool = True) -> Svg:
        """Returns a drawing of the machine at its start."""
        return self.solve().svg(width, labels)

    def animation(self, seconds: Optional[float] = None, rate: float = 25.0) -> Svg:
        """Returns a moving picture of the machine, an SVG document animated by CSS alone."""
        with self._lock:
            return Svg(_output.animation(self._ready(), seconds, rate))

    def _repr_svg_(self) -> str:
        return self.svg()


def load(path: PathLike, parameters: Values = None, *, lock: Optional[str] = None, **values: Value) -> Machine:
    """Loads a machine from its file, with other values of its parameters: load("crank.yaml", r="60 mm").

    Raises ModelError with every problem of the file, each with line, column and hint. `lock` engages an entry of
    `locks:`; `parameters` takes names that are not identifiers.
    """
    with open(path, encoding="utf-8", errors="surrogateescape", newline="") as file:
        text = file.read()
    return Machine._loaded(text, os.fspath(path), named(parameters, "parameters", values), lock)


def parse(text: str, name: str = "machine.yaml", parameters: Values = None, *, lock: Optional[str] = None,
          **values: Value) -> Machine:
    """Reads a machine from the text of a model file; `name` stands for the file's name in messages."""
    return Machine._loaded(text, name, named(parameters, "parameters", values), lock)


