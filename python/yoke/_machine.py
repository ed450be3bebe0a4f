"""The machine: what `yoke.load` returns, and what all questions are asked of."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Mapping, Optional, Sequence, Union

from . import _batch, _configurations, _equations, _many, _motion, _output, _study, _sweep
from ._builder import Builder
from ._core import Core
from ._native import ffi, lib
from ._pose import Pose
from ._problems import ModelError, Problems, RequestError, refusal, text_of
from ._reach import Plan, Slot
from ._table import Table
from ._values import TIME, Value, encoded, si
from ._watch import Progress, Watch, check

PathLike = Union[str, "os.PathLike[str]"]
Values = Optional[Mapping[str, Value]]
METHODS = {"reduced": lib.YK_METHOD_REDUCED, "newton-euler": lib.YK_METHOD_NEWTON_EULER}
_NONE: Mapping[str, Any] = {}


_given_up: "list[Optional[Core]]" = []


class Machine(Builder):
    """A planar machine: loaded by `yoke.load`, or made by calls.

    Values are numbers in SI and radians, texts with a unit as "60 mm", or pairs as (30, "deg"). Coordinates are
    keyword arguments, or in `at` where their names are no identifiers. All answers are in SI and radians.

    >>> m = Machine("pendulum").gravity(0, -9.81).body("ground", {"O": (0, 0)})
    >>> m = m.body("rod", {"O": (0, 0), "P": (0, -0.5)}, mass=2, rod=("O", "P"))
    >>> m = m.pin("O", "ground", "rod", angle="theta").start("theta", "30 deg")
    >>> round(m.solve().points["rod.P"].position[0], 6)
    0.25
    """

    __slots__ = ("_kept", "_source")

    def __init__(self, name: str = "") -> None:
        super().__init__(name)
        self._kept: Optional[Core] = None
        self._source: Optional[tuple[str, str, dict[str, Value], Optional[str]]] = None

    @classmethod
    def _loaded(cls, text: str, name: str, parameters: Mapping[str, Value], lock: Optional[str]) -> "Machine":
        machine = cls.__new__(cls)
        Builder.__init__(machine, None)
        machine._source, machine._kept = (text, name, dict(parameters), lock), None
        machine._ready()
        return machine

    # --- its life

    def _give_up(self, why: str) -> None:
        super()._give_up(why)
        _given_up.append(self._kept)  # half changed: never used, never freed
        self._kept = None

    def _changed(self) -> None:
        self._kept = None

    def _ready(self) -> Core:
        """Returns what was computed from the machine; loads it where that is not done. The lock is held."""
        if self._kept is not None:
            return self._kept
        if self._gone:
            self._refuse()
        problems = Problems()
        if self._source is None:
            said = self._check_builder()
            if lib.yk_problems_error_count(said.c) > 0:
                raise said.fail(ModelError)
            core = Core(self._said(), "machine", {}, None, problems)
        else:
            text, name, parameters, lock = self._source
            core = Core(text, name, parameters, lock, problems)
        check()
        problems.warn(4)
        self._kept = core
        return core

    def close(self) -> None:
        """Frees the machine; every later use raises ClosedError. Poses and simulations made before stay as they are."""
        with self._lock:
            self._gone, self._kept, self._source, self._builder = "was closed", None, None, ffi.NULL

    def __enter__(self) -> "Machine":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __reduce__(self) -> Any:
        with self._lock:
            if self._source is not None:
                return Machine._loaded, self._source
            if self._gone:
                self._refuse()
            return _built, (self._said(),)

    # --- what it is

    @property
    def name(self) -> str:
        """The machine's name."""
        with self._lock:
            return text_of(lib.yk_model_name(self._ready().model))

    @property
    def text(self) -> str:
        """The machine as a model file: read back, it is the same machine to the last bit."""
        with self._lock:
            return self._said() if self._source is None and not self._gone else text_of(
                lib.yk_model_text(self._ready().model))  # fmt: skip

    def write(self, path: PathLike) -> Path:
        """Writes the machine as a model file, which appears whole or not at all."""
        with self._lock:
            problems = Problems()
            status = lib.yk_model_write(self._ready().model, encoded(os.fspath(path)), problems.c)
            if status < 0:
                raise problems.fail(RequestError, status)
            return Path(path)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Names of the bodies, the ground first."""
        with self._lock:
            return tuple(self._ready().bodies)

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints."""
        with self._lock:
            return tuple(self._ready().joints)

    @property
    def points(self) -> tuple[str, ...]:
        """Names of the points, as "body.point"."""
        with self._lock:
            return tuple(self._ready().points)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        with self._lock:
            return tuple(self._ready().coordinates)

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of the coordinates that are inputs: driven, held or free."""
        with self._lock:
            return tuple(c.name for c in self._ready().coordinates.values() if c.input >= 0)

    @property
    def freedom(self) -> int:
        """Degrees of freedom, by rank where the machine could be assembled."""
        with self._lock:
            f = lib.yk_mechanism_freedom(self._ready().base)
            return int(f.by_rank if f.by_rank >= 0 else f.gruebler)

    def parameter_value(self, name: str) -> float:
        """Returns a parameter's value in SI."""
        with self._lock:
            return _study.parameter(self._ready().model, name, lib.yk_model_parameter(self._ready().model,
                                                                                     encoded(name)))  # fmt: skip

    def value(self, text: str, kind: str = "length") -> float:
        """Returns a value with a unit in SI, as value("30 deg", "angle"); kinds as "length", "angle", "time", "force"."""
        quantity = getattr(lib, f"YK_QUANTITY_{kind.upper().replace('-', '_')}", None)
        if quantity is None:
            raise refusal(RequestError, "E0806", f"there is no kind of value `{kind}`")
        with self._lock:
            return si(self._ready().model, text, quantity, "text")

    def replace(self, parameters: Values = None, **named: Value) -> "Machine":
        """Returns the machine with other values of its parameters, in the configuration that it was put together in."""
        more = {**(parameters or {}), **named}
        with self._lock:
            self._ready()
            if self._source is None:
                return Machine._loaded(self._said(), "machine", more, None)
            text, name, old, lock = self._source
            return Machine._loaded(text, name, {**old, **more}, lock)

    # --- a pose

    def solve(self, *, time: Value = 0.0, at: Values = None, rate: Values = None, accel: Values = None,
              effort: Values = None, assembly: Union[str, int, None] = None, method: str = "reduced",
              **coordinates: Value) -> Pose:  # fmt: skip
        """Moves the machine to a pose and returns it, with forces where there are masses or loads.

        Without arguments it is the pose of `start:` at t = 0. `time` follows the drives, coordinates are set in place
        of their drives, `rate`, `accel` and `effort` set those by name. `assembly` takes another configuration on
        purpose: "nearest", a label, or its number in `configurations`, from 1. Raises PoseError if a limit is in the way.
        """
        with self._lock:
            core = self._kept if self._kept is not None else self._ready()
            if at:
                coordinates = {**at, **coordinates}
            if rate or accel or effort or assembly is not None:
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
        """Finds the forces of a pose that was reached."""
        if method is None:
            raise refusal(RequestError, "E0806", "method takes reduced or newton-euler here")
        forces = 0
        if slot.dynamics is not None and lib.yk_state_has_rates(slot.state):
            forces = lib.yk_dynamics_solve(slot.dynamics, slot.state, method)
        pose = Pose(self, plan, slot, request, forces or status, is_start)
        if forces not in (lib.YK_OK, lib.YK_REDUNDANT):
            pose.message, pose._forces = text_of(lib.yk_dynamics_report(slot.dynamics).message), False
        elif not lib.yk_state_has_rates(slot.state):
            pose._forces = False
        return pose

    def _solve_more(self, core: Core, time: Value, coordinates: Mapping[str, Value], rate: Values, accel: Values,
                    effort: Values, assembly: Union[str, int, None], method: str) -> Pose:  # fmt: skip
        hold = _sweep.Holding(core, time, rate, accel, effort)
        plan = core.plan(list(coordinates), list(hold.rate), list(hold.accel))
        hold.fill(plan, coordinates)
        slot = plan.take() if not hold.effort else Slot(plan, False)
        for index, value in hold.efforts().items():
            if slot.dynamics is not None:
                lib.yk_dynamics_set_effort(slot.dynamics, index, value)
        request = {"time": hold.time, "at": dict(coordinates), "rate": hold.rate, "accel": hold.accel,
                   "effort": hold.effort, "assembly": assembly, "method": method}  # fmt: skip
        if assembly is None:
            status = plan.reach(slot.state, hold.time)
            pose = self._posed(plan, slot, request, status, METHODS.get(method), True)
            pose.notes = plan.notes
            return pose
        status = _configurations.choose(plan, slot.state, hold.time, assembly)
        is_start = _configurations.is_own(plan, slot.state, hold.time)
        return self._posed(plan, slot, request, status, METHODS.get(method), is_start)

    def configurations(self, *, time: Value = 0.0, at: Values = None, progress: Progress = None,
                       **coordinates: Value) -> "_configurations.Configurations":  # fmt: skip
        """Returns every configuration that closes at a pose, as a list of poses; `complete` tells whether these are all."""
        with self._lock, Watch(progress, "configurations"):
            core = self._ready()
            coordinates = {**(at or {}), **coordinates}
            hold = _sweep.Holding(core, time, None, None, None)
            plan = core.plan(list(coordinates))
            hold.fill(plan, coordinates)
            return _configurations.find(self, plan, hold.time, {"time": hold.time, "at": coordinates})

    # --- many poses

    def sweep(self, *, steps: int = 36, of: Any = None, time: Value = 0.0, at: Optional[Mapping[str, Any]] = None,
              rate: Values = None, accel: Values = None, effort: Values = None, method: str = "reduced",
              turn_max: Optional[Value] = None, progress: Progress = None, **coordinates: Any) -> Table:  # fmt: skip
        """Moves a coordinate, or the time `t`, through a range and returns a row for each step, and one more.

        The range is a pair or has a unit: theta=(0, 360, "deg"). Between the rows nothing is jumped: limits, dead
        points, change points and extremes are the table's `events`. At a limit the rows end, and `status` is "limit".
        The rows are the library's own memory, not a copy.
        """
        with self._lock, Watch(progress, "sweep"):
            core = self._ready()
            if method not in METHODS:
                raise refusal(RequestError, "E0806", f"method takes reduced or newton-euler here, not `{method}`")
            hold = _sweep.Holding(core, time, rate, accel, effort)
            return _sweep.run(core, {**(at or {}), **coordinates}, of, steps, hold, METHODS[method], turn_max)

    def batch(self, of: Any, *, at: Optional[Mapping[str, Any]] = None, rate: Optional[Mapping[str, Any]] = None,
              accel: Optional[Mapping[str, Any]] = None, out: Any = None, **coordinates: Any) -> _batch.Columns:  # fmt: skip
        """Solves many independent poses at once: arrays of input values in, an array for each column out.

        Every pose lies on the machine's branches, whether or not it could get there; `status` tells which poses stand,
        and others are 0. `out`, an array [column, pose], takes the answers in place of a new one.
        """
        with self._lock:
            return _batch.run(self._ready(), {**(at or {}), **coordinates}, rate or {}, accel or {}, of, out)

    def study(self, *, vary: Optional[Mapping[str, Any]] = None, sample: Any = None,
              designs: Union[Mapping[str, Any], int, None] = None, of: Any, over: _study.Over = None, steps: int = 36,
              seed: Optional[int] = None, every_pose: bool = False, threads: Optional[int] = None, time: Value = 0.0,
              at: Values = None, rate: Values = None, accel: Values = None, effort: Values = None,
              progress: Progress = None) -> Table:  # fmt: skip
        """Computes many designs of the machine, each with its own parameters, on all processors.

        vary     a grid, as {"r": ("40 mm", "60 mm", 100)}
        sample   distributions, as {"r": yoke.normal("50 mm", "0.1 mm")}, or the path of a file of them;
                 `designs` says how many, `seed` which
        designs  the designs themselves: arrays in SI by parameter
        over     poses of each design, as {"theta": (0, 360, "deg")} in `steps` steps: then the least, largest and mean
                 value and the range of each column are returned, or with every_pose all of them
        """
        with self._lock, Watch(progress, "study"):
            core = self._ready()
            given = designs if isinstance(designs, Mapping) else None
            if sum(x is not None for x in (vary, sample, given)) != 1:
                raise refusal(RequestError, "E0804", "a study takes one of vary, sample and designs")
            if vary is not None:
                values = _study.grid(core.model, vary)
            elif given is not None:
                values = dict(given)
            else:
                values = _study.sampled(core, sample, designs if isinstance(designs, int) else None, seed)
            hold = _sweep.Holding(core, time, rate, accel, effort)
            study = _study.Study(core, list(values), of, over, steps, at or {}, hold, threads)
            return _study.run(study, values, every_pose)

    def sensitivities(self, parameters: Sequence[str], of: Any, *, time: Value = 0.0, at: Values = None,
                      **coordinates: Value) -> _study.Sensitivities:  # fmt: skip
        """Returns derivatives of columns with respect to parameters at a pose."""
        with self._lock:
            core = self._ready()
            hold = _sweep.Holding(core, time, None, None, None)
            study = _study.Study(core, parameters, of, None, 1, {**(at or {}), **coordinates}, hold, 1)
            return _study.sensitivities(study)

    # --- motion in time

    def simulate(self, to: Value, *, of: Any = None, start: Value = 0.0, every: Optional[Value] = None,
                 steps: int = 100, at: Values = None, rate: Values = None, effort: Values = None,
                 events: Optional[Mapping[str, Value]] = None, method: str = "dop853",
                 tolerance: Optional[float] = None, step: Optional[Value] = None, progress: Progress = None,
                 **coordinates: Value) -> Table:  # fmt: skip
        """Returns the motion under loads from `start:` as rows in time, with events and a summary.

        events   crossings to report, as {"theta": "90 deg"}
        method   "dop853", "sdirk4" for stiff machines, or "rk4" with a fixed `step`
        """
        with self._lock, Watch(progress, "simulate"):
            core = self._ready()
            end = si(core.model, to, TIME, "to")
            request = _motion.Request(core, start=start, to=end, at={**(at or {}), **coordinates}, rate=rate or {},
                                      effort=effort or {}, method=method, tolerance=tolerance, step=step)  # fmt: skip
            with _motion.Simulation(self, request, None) as simulation:
                for name, value in (events or {}).items():
                    simulation.watch(f"{name}={value}", name, value)
                return simulation.rows(end, every=every, steps=steps, of=of)

    def simulation(self, *, start: Value = 0.0, at: Values = None, rate: Values = None, effort: Values = None,
                   method: str = "dop853", tolerance: Optional[float] = None, step: Optional[Value] = None,
                   **coordinates: Value) -> _motion.Simulation:  # fmt: skip
        """Begins a simulation that the caller steps and acts on."""
        with self._lock:
            core = self._ready()
            kept: dict[str, Any] = {"start": start, "at": {**(at or {}), **coordinates}, "rate": dict(rate or {}),
                    "effort": dict(effort or {}), "method": method, "tolerance": tolerance, "step": step}  # fmt: skip
            request = _motion.Request(core, start=start, at=kept["at"], rate=kept["rate"], effort=kept["effort"],
                                      method=method, tolerance=tolerance, step=step)  # fmt: skip
            return _motion.Simulation(self, request, kept)

    def simulations(self, count: int, *, of: Any = None, effort: Sequence[str] = (), at: Optional[Mapping[str, Any]] = None,
                    rate: Optional[Mapping[str, Any]] = None, method: str = "dop853",
                    tolerance: Optional[float] = None, step: Optional[Value] = None,
                    threads: Optional[int] = None) -> _many.Simulations:  # fmt: skip
        """Begins many simulations that are stepped together: arrays of efforts in, arrays of channels out."""
        with self._lock:
            return _many.Simulations(self, count, of=of, effort=effort, at=at or {}, rate=rate or {}, method=method,
                                     tolerance=tolerance, step=step, threads=threads)  # fmt: skip

    # --- equations and pages

    def derive(self, what: Union[str, Sequence[str], None] = None, *, pose: Optional[Pose] = None,
               progress: Progress = None) -> _equations.Equations:  # fmt: skip
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
             kinematics: bool = False) -> Union[str, Path]:  # fmt: skip
        """Returns C for this machine, or writes it to a file, which appears whole or not at all."""
        with self._lock:
            return _output.finish(_output.code(self._ready(), prefix, single, kinematics), path)

    def svg(self, width: float = 800, labels: bool = True) -> str:
        """Returns a drawing of the machine at its start."""
        return self.solve().svg(width, labels)

    def animation(self, seconds: Optional[float] = None, rate: float = 25.0) -> str:
        """Returns the machine moving, as an SVG document that is animated by CSS alone."""
        with self._lock:
            return _output.animation(self._ready(), seconds, rate)

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        if self._gone:
            return f"<yoke.Machine: {self._gone}>"
        try:
            return (f"<yoke.Machine {self.name!r}: {len(self.bodies) - 1} bodies, {len(self.joints)} joints, "
                    f"freedom {self.freedom}, inputs {', '.join(self.inputs) or 'none'}>")  # fmt: skip
        except Exception as error:
            return f"<yoke.Machine, not yet whole: {str(error).splitlines()[0]}>"


def _built(text: str) -> Machine:
    """Makes a machine from what a builder said, after pickling."""
    return Machine._loaded(text, "machine", {}, None)


def load(path: PathLike, parameters: Values = None, *, lock: Optional[str] = None, **named: Value) -> Machine:
    """Loads a machine from its file, with other values of its parameters: load("crank.yaml", r="60 mm").

    Raises ModelError with every problem of the file, each with line, column and hint. `lock` engages an entry of
    `locks:`; `parameters` takes names that are no identifiers.
    """
    with open(path, encoding="utf-8", errors="surrogateescape", newline="") as file:
        text = file.read()
    return Machine._loaded(text, os.fspath(path), {**(parameters or {}), **named}, lock)


def parse(text: str, name: str = "machine.yaml", parameters: Values = None, *, lock: Optional[str] = None,
          **named: Value) -> Machine:  # fmt: skip
    """Reads a machine from the text of a model file; `name` stands for the file's name in messages."""
    return Machine._loaded(text, name, {**(parameters or {}), **named}, lock)


