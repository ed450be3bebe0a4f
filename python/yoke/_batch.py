"""Batches: many independent poses in one call."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional

import numpy as np

from ._arrays import dimensions, doubles
from ._core import channels_of, names_of
from ._native import ffi, lib
from ._problems import RequestError, refusal
from ._reach import Plan
from ._start import new_state, pose_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._core import Core

SLICE = 1 << 16  # poses per call; Ctrl-C is noticed between two calls


class Columns(Mapping[str, Any]):
    """Answers as contiguous arrays by name. A pose is valid where `status` is 0 or above."""

    def __init__(self, names: list[str], values: "NDArray[np.float64]", status: "NDArray[np.int8]") -> None:
        self.values_, self.status = values, status
        self._rows = dict(zip(names, values))

    def __getitem__(self, name: str) -> "NDArray[np.float64]":
        result: NDArray[np.float64] = self._rows[name]
        return result

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def array(self) -> "NDArray[np.float64]":
        """All columns as one array, [column, pose]."""
        return self.values_

    def to_pandas(self) -> Any:
        """Returns the columns as a pandas.DataFrame; requires pandas."""
        import pandas  # type: ignore[import]

        return pandas.DataFrame({**self._rows, "status": self.status})

    def __repr__(self) -> str:
        bad = int((self.status < 0).sum())
        failed = f", {bad} not reached" if bad else ""
        return f"<yoke.Columns of {len(self.status)} poses: {', '.join(self._rows)}{failed}>"


def _batch_of(plan: Plan, names: list[str]) -> Any:
    """Returns the plan's batch for these columns, made once."""
    key = ("batch", *names)
    found = plan.channels.get(key)  # type: ignore[call-overload]
    if found is not None:
        return found
    if plan.entry is None or plan.entry_status < 0:
        raise pose_error(min(plan.core.start.status, plan.entry_status), "the machine has no pose to begin from")
    channels = channels_of(plan.mech, names)
    forces = any(channels[k].kind >= lib.YK_CHANNEL_FORCE_X for k in range(len(names)))
    if forces and plan.new_dynamics() is None:
        raise refusal(RequestError, "E0819", "the machine has neither masses nor loads, and therefore no forces")
    state = new_state(plan.mech)
    lib.yk_state_copy(state, plan.entry)
    batch = lib.yk_batch_new(state, channels, len(names))
    if batch == ffi.NULL:
        raise MemoryError("out of memory")

    def free(c: Any, keep: Any = state) -> None:
        lib.yk_batch_free(c)

    batch = plan.channels[key] = ffi.gc(batch, free)  # type: ignore[index]
    return batch


def run(core: "Core", coordinates: Mapping[str, Any], rate: Mapping[str, Any], accel: Mapping[str, Any], of: Any,
        out: Optional[Any]) -> Columns:
    """Solves all poses; arrays of input values are in SI."""
    names = names_of(of)
    plan = core.plan(list(coordinates), list(rate), list(accel), imposed=True)
    given = [(name, order, value) for order, values in enumerate((coordinates, rate, accel))
             for name, value in values.items()]
    lengths = {name: np.shape(value)[0] for name, _, value in given if dimensions(value, name) == 1}
    if len(set(lengths.values())) != 1:
        raise refusal(RequestError, "E0806", "a batch takes arrays of one length, as theta=numpy.linspace(0, 6, 100)"
                      + (f", not of {lengths}" if lengths else ""))
    poses = next(iter(lengths.values()))
    arrays = {(plan.coordinates[name].input, order): doubles(value, name, (poses,)) for name, order, value in given}
    values = _room(out, len(names), poses, list(arrays.values()))
    status = np.empty(poses, np.int8)
    if poses:
        _solve(plan, _batch_of(plan, names), arrays, values, status)
    return Columns(names, values, status)


def _room(out: Any, columns: int, poses: int, inputs: list[Any]) -> "NDArray[np.float64]":
    if out is None:
        return np.empty((columns, poses))
    good = isinstance(out, np.ndarray) and out.dtype == np.float64 and out.shape == (columns, poses)
    if not good or not out.flags.c_contiguous or not out.flags.writeable:
        raise refusal(RequestError, "E0806", f"out takes a contiguous array of doubles of shape {(columns, poses)}")
    if any(np.may_share_memory(out, array) for array in inputs):
        raise refusal(RequestError, "E0806", "out shares memory with an input")
    result: NDArray[np.float64] = out
    return result


def _solve(plan: Plan, batch: Any, arrays: Mapping[tuple[int, int], Any], values: Any, status: Any) -> None:
    inputs = ffi.new("double *[]", 3 * plan.inputs + 1)
    outputs = ffi.new("double *[]", len(values) + 1)
    data = {key: ffi.from_buffer("double[]", array) for key, array in arrays.items()}
    results = [ffi.from_buffer("double[]", row) for row in values]
    flags = ffi.from_buffer("signed char[]", status)
    for first in range(0, len(status), SLICE):
        for (k, order), array in data.items():
            inputs[3 * k + order] = array + first
        for c, row in enumerate(results):
            outputs[c] = row + first
        worst = lib.yk_batch_run(batch, inputs, outputs, flags + first, min(SLICE, len(status) - first))
        if worst in (lib.YK_NO_MEMORY, lib.YK_BAD_ARGUMENT):
            raise pose_error(worst, "the batch could not be solved")
