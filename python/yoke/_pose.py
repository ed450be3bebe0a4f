"""A pose: positions, velocities, accelerations and forces of a machine."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

from . import _grid, _scale
from ._answers import Effort, Energy, Motion, Named, PointMotion, Reaction
from ._core import channels_of
from ._native import ffi, lib
from ._problems import Problem, status_name, text_of
from ._reach import Plan, Slot
from ._values import CData, number, unit_of

if TYPE_CHECKING:
    from ._machine import Machine

NAN = float("nan")


class Svg(str):
    """A drawing as an SVG document, which a notebook shows."""

    def _repr_svg_(self) -> str:
        return str(self)


class Pose:
    """One pose of a machine. All numbers are in SI and radians; `pose["s.rate"]` reads any channel by its name.

    Like the machine, it belongs to one thread at a time.
    """

    __slots__ = ("machine", "_plan", "_slot", "_request", "status", "is_start", "index", "message", "notes",
                 "_forces", "__weakref__")

    def __init__(self, machine: "Machine", plan: Plan, slot: Slot, request: Any, status: int, is_start: bool) -> None:
        self.machine, self._plan, self._slot, self._request = machine, plan, slot, request
        self.is_start = is_start  # the configuration that the machine itself gets to
        self.index: Optional[int] = None  # among `configurations`
        self.message = ""  # why there are no forces, if there are none
        self.notes: tuple[Problem, ...] = ()  # what the machine passed on its way here
        self._forces = slot.dynamics is not None
        self.status = "ok" if status == 0 else status_name(status)

    def __del__(self) -> None:
        try:
            if self._slot.is_shared and len(self._plan.pool) < 16:
                self._plan.pool.append(self._slot)
        except AttributeError:
            pass  # it was never made

    def __reduce__(self) -> Any:
        return _again, (self.machine, self._request, self.index)

    # --- motion

    def _rates(self, velocity: Any, acceleration: Any, lost: Any) -> Any:
        if not lib.yk_state_has_rates(self._slot.state):
            return lost, lost
        return velocity, lost if self._lacks_accelerations else acceleration

    @property
    def _lacks_accelerations(self) -> bool:
        return bool(self.message) and self._plan.has_free

    def _motion(self, m: CData) -> Motion:
        return Motion(m.position, *self._rates(m.velocity, m.acceleration, NAN))

    @property
    def coordinates(self) -> Named[Motion]:
        """Motions of all coordinates, m or rad."""
        state = self._slot.state
        return Named(self._plan.coordinates,
                     lambda c: self._motion(lib.yk_state_coordinate(state, c.number)), "coordinate", self)

    @property
    def bodies(self) -> Named[Motion]:
        """Angles of the bodies to the ground, rad."""
        state, names = self._slot.state, {name: k for k, name in enumerate(self._plan.core.bodies) if k > 0}
        return Named(names, lambda k: self._motion(lib.yk_state_body(state, k)), "body", self)

    def _point(self, k: int) -> PointMotion:
        m = lib.yk_state_point(self._slot.state, k)
        first, second = self._rates(tuple(m.velocity), tuple(m.acceleration), (NAN, NAN))
        return PointMotion((m.position[0], m.position[1]), first, second)

    @property
    def points(self) -> Named[PointMotion]:
        """Motions of all points by the name "body.point", m."""
        return Named(self._plan.core.points, self._point, "point", self)

    @property
    def transmission(self) -> dict[str, float]:
        """Transmission angles of the dyads by the label of their block, rad."""
        mech, state = self._plan.mech, self._slot.state
        blocks = [(k, lib.yk_block_info(mech, k)) for k in range(lib.yk_block_count(mech))]
        return {text_of(b.label): lib.yk_state_transmission(state, k) for k, b in blocks if b.assur_class == 2}

    @property
    def label(self) -> str:
        """The configuration, such as "A+ C-", or "J+.2" if several at these inputs share a label."""
        with self.machine._lock:
            return self._plan.name_of(self._slot.state)

    @property
    def time(self) -> float:
        """The time at which drives and loads are evaluated, s."""
        return float(lib.yk_state_time(self._slot.state))

    def __getitem__(self, channel: str) -> float:
        """Returns a channel by its name in `--of`: "s.rate", "A.force.x", "energy"; NaN if it is undefined."""
        plan = self._plan
        found = plan.channels.get(channel)
        if found is None:
            found = plan.channels[channel] = channels_of(plan.mech, [channel])
        value = ffi.new("double *")
        dynamics = self._slot.dynamics if self._forces else None
        lib.yk_host_read(self._slot.state, ffi.NULL if dynamics is None else dynamics, found, 1,
                         not self._lacks_accelerations, value)
        return float(value[0])

    # --- forces

    @property
    def has_forces(self) -> bool:
        """Whether forces were found at this pose."""
        return self._forces

    @property
    def reactions(self) -> Named[Reaction]:
        """Reactions of the joints, and of gears, racks, belts and cams; empty without forces."""
        dynamics, core = self._slot.dynamics, self._plan.core
        names = {name: (False, k) for k, name in enumerate(core.joints)} if self._forces else {}
        for k in range(lib.yk_dynamics_contact_count(dynamics) if self._forces else 0):
            names[text_of(lib.yk_dynamics_contact_name(dynamics, k))] = (True, k)

        def read(key: tuple[bool, int]) -> Reaction:
            r = (lib.yk_dynamics_contact if key[0] else lib.yk_dynamics_reaction)(dynamics, key[1])
            force = (r.force[0], r.force[1])
            return Reaction(core.bodies[r.by], core.bodies[r.on], force, r.moment, r.is_determinate)

        return Named(names, read, "reaction", self)

    @property
    def efforts(self) -> Named[Effort]:
        """Efforts of the drives, and of `efforts:`; empty without forces."""
        dynamics = self._slot.dynamics
        names = {
            name: c.number for name, c in self._plan.coordinates.items()
            if self._forces and lib.yk_dynamics_has_effort(dynamics, c.number)
        }

        def read(k: int) -> Effort:
            r = lib.yk_dynamics_effort_range(dynamics, k)
            return Effort(lib.yk_dynamics_effort(dynamics, k), r.low, r.high)

        return Named(names, read, "effort", self)

    @property
    def energy(self) -> Optional[Energy]:
        """Kinetic and potential energy, J; None without forces."""
        if not self._forces:
            return None
        e = lib.yk_dynamics_energy(self._slot.dynamics)
        return Energy(e.kinetic, e.potential)

    # --- display

    def table(self, *units: str) -> str:
        """Returns the coordinates as the command prints them, in the file's units or in those given ("mm", "deg")."""
        return "\n\n".join(_grid.text(heads, rows) for heads, rows in self._tables(units))

    def _tables(self, units: Sequence[str]) -> list[tuple[list[str], list[list[_grid.Cell]]]]:
        model, scale = self._plan.core.model, _scale.Scale(self._plan, self._slot)
        chosen = _scale.chosen_units(model, units)
        result = []
        for is_distance, subject in ((False, "angle"), (True, "distance")):
            mine = [c for c in self._plan.coordinates.values() if c.is_distance == is_distance]
            if not mine:
                continue
            own = [chosen.get(mine[0].quantity(k)) or unit_of(model, mine[0].quantity(k)) for k in range(3)]
            heads = [subject] + [f"{word} [{unit}]" if unit else word
                                 for word, (unit, _) in zip(("position", "velocity", "acceleration"), own)]
            rows: list[list[_grid.Cell]] = []
            for c in mine:
                motion = self.coordinates[c.name]
                values = [scale.shown(x, c.quantity(k)) / own[k][1] for k, x in enumerate(motion)]
                rows.append([c.name + (" (input)" if c.input >= 0 else ""), *values])
            result.append((heads, rows))
        return result

    def svg(self, width: float = 800, labels: bool = True) -> Svg:
        """Returns a drawing of the machine at this pose, as an SVG document."""
        options = ffi.new("YkDrawOptions *")
        options[0] = lib.yk_default_draw_options()
        options.width, options.labels = number(width, "width"), labels is not False
        drawing = ffi.gc(lib.yk_drawing_new(self._plan.mech, options), lib.yk_drawing_free)
        if drawing == ffi.NULL or lib.yk_drawing_pose(drawing, self._slot.state) < 0:
            raise MemoryError("out of memory")
        svg = lib.yk_drawing_svg(drawing)
        if svg == ffi.NULL:
            raise MemoryError("out of memory")
        return Svg(text_of(svg))

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_html_(self) -> str:
        caption = f"{self.machine.name}, configuration {self.label}" if self.label else self.machine.name
        tables = self._tables(())
        return "\n".join(_grid.html(h, r, caption if k == 0 else None) for k, (h, r) in enumerate(tables)) + self.svg()

    def __repr__(self) -> str:
        inputs = ", ".join(
            f"{c.name}={self.coordinates[c.name].position:.6g}" for c in self._plan.coordinates.values() if c.input >= 0
        )
        label = f" {self.label!r}" if self.label else ""
        return f"<yoke.Pose of {self.machine.name!r}{label}: {self.status}, {inputs}>"


def _again(machine: "Machine", request: Any, index: Optional[int]) -> Pose:
    """Makes a pose again from its machine and the request, after pickling."""
    if index is not None:
        found: Pose = machine.configurations(**request)[index]
        return found
    return machine.solve(**request)
