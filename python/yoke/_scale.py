"""The size of rounding noise in a table, by the largest values of its pose; the units requested for a table."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Sequence

from ._native import ffi, lib
from ._problems import Problems, RequestError, refusal
from ._values import ANGLE, LENGTH, CData, encoded

if TYPE_CHECKING:
    from ._reach import Plan, Slot

_NOISE, _NOISE_OF_SUMS = 1e-13, 1e-15


class Scale:
    """The largest rate and acceleration of a pose, of angles or of lengths over the machine's size."""

    def __init__(self, plan: "Plan", slot: "Slot") -> None:
        state: CData = slot.state
        mech: CData = plan.mech
        model: CData = plan.core.model
        self.size = lib.yk_mechanism_size(mech)
        self.of_angles = _NOISE_OF_SUMS if lib.yk_loop_count(mech) == 0 else _NOISE
        self.rate = self.acceleration = 0.0
        if not lib.yk_state_has_rates(state):
            return
        for c in plan.coordinates.values():
            m, size = lib.yk_state_coordinate(state, c.number), self.size if c.is_distance else 1.0
            self._raise(m.velocity / size, m.acceleration / size)
        for k in range(1, lib.yk_model_body_count(model)):
            m = lib.yk_state_body(state, k)
            self._raise(m.velocity, m.acceleration)
            if slot.dynamics is not None:
                self._add_load(slot.dynamics, model, k)
        for k in range(lib.yk_model_point_count(model)):
            p = lib.yk_state_point(state, k)
            self._raise(math.hypot(*p.velocity) / self.size, math.hypot(*p.acceleration) / self.size)

    def _add_load(self, dynamics: CData, model: CData, body: int) -> None:
        mass = lib.yk_model_body_mass(model, body)
        if mass > 0:
            self._raise(0.0, math.hypot(*lib.yk_dynamics_balance(dynamics, body).loads.force) / mass / self.size)

    def _raise(self, rate: float, acceleration: float) -> None:
        if math.isfinite(rate):
            self.rate = max(self.rate, abs(rate))
        if math.isfinite(acceleration):
            self.acceleration = max(self.acceleration, abs(acceleration))

    def shown(self, value: float, quantity: int) -> float:
        """Returns a value with noise set to zero."""
        acceleration = max(self.acceleration, self.rate * self.rate)
        noise = dict(zip(ANGLE, (self.of_angles, self.of_angles * self.rate, self.of_angles * acceleration)))
        noise.update(zip(LENGTH, (_NOISE * self.size, _NOISE * self.rate * self.size,
                                  _NOISE * acceleration * self.size)))
        return 0.0 if abs(value) <= noise.get(quantity, 0.0) else value


def chosen_units(model: CData, units: Sequence[str]) -> dict[int, tuple[str, float]]:
    """Reads units such as "mm" and "deg". Returns the name and size in SI of their values, rates and accelerations."""
    result: dict[int, tuple[str, float]] = {}
    for unit in units:
        for family in (ANGLE, LENGTH):
            sizes = [_size(model, text, quantity) for text, quantity in zip((unit, f"{unit}/s", f"{unit}/s^2"), family)]
            if all(size is not None for size in sizes):
                names = (unit, f"{unit}/s", f"{unit}/s^2")
                result.update({q: (n, s) for q, n, s in zip(family, names, sizes) if s is not None})
                break
        else:
            raise refusal(RequestError, "E0806", f"`{unit}` is neither a length nor an angle")
    return result


def _size(model: CData, unit: str, quantity: int) -> "float | None":
    value = ffi.new("double *")
    good = lib.yk_model_value(model, encoded(f"1 {unit}"), quantity, value, Problems().c) >= 0
    return float(value[0]) if good else None
