"""Rows as structured NumPy arrays that know their units, events and status."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional, Sequence

import numpy as np

from . import _grid

Floats = "np.ndarray[Any, np.dtype[np.float64]]"


class Event(NamedTuple):
    """Something that happened on the way: `at` is the value of the swept variable, or the time."""

    kind: str  # "limit", "change-point", "dead-point", "minimum", "maximum"; "stop", "release", "crossing", ...
    at: float
    name: str  # of the channel, joint, coordinate or crossing
    value: float  # NaN if there is none


class Column(NamedTuple):
    """A column's name, and the unit in which tables show it with its size in SI."""

    name: str
    unit: str
    size: float


class Table(np.ndarray):  # type: ignore[type-arg]
    """Rows of an answer as a structured array: `t["s.rate"]` is a column, in SI and radians.

    columns   names with the file's units, for `text` and notebooks
    events    what happened between the rows
    status    "ok", or why the rows end early; `message` says more
    """

    columns: tuple[Column, ...]
    events: tuple[Event, ...]
    status: str
    message: str
    caption: str
    summary: Any

    def __array_finalize__(self, other: Any) -> None:
        self.columns = getattr(other, "columns", ())
        self.events = getattr(other, "events", ())
        self.status = getattr(other, "status", "ok")
        self.message = getattr(other, "message", "")
        self.caption = getattr(other, "caption", "")
        self.summary = getattr(other, "summary", None)

    def __getitem__(self, key: Any) -> Any:
        result = super().__getitem__(key)
        if isinstance(result, Table) and result.dtype.names is None:
            return result.view(np.ndarray)
        return result

    def __reduce__(self) -> Any:
        remake, args, state = super().__reduce__()  # type: ignore[misc]
        own = (self.columns, self.events, self.status, self.message, self.caption, self.summary)
        return remake, args, (state, own)

    def __setstate__(self, state: Any) -> None:
        super().__setstate__(state[0])
        self.columns, self.events, self.status, self.message, self.caption, self.summary = state[1]

    def _shown(self) -> list[Column]:
        names = self.dtype.names or ()
        known = {c.name: c for c in self.columns}
        return [known.get(name, Column(name, "", 1.0)) for name in names]

    def _heads(self) -> list[str]:
        return [f"{c.name} [{c.unit}]" if c.unit else c.name for c in self._shown()]

    def _cells(self, most: int) -> list[Sequence[_grid.Cell]]:
        flat = np.atleast_1d(self)
        rows = len(flat)
        picked = range(rows) if rows <= most else [*range(most // 2), *range(rows - most // 2, rows)]
        sizes = [c.size for c in self._shown()]
        noise = [1e-14 * max((abs(x) for x in flat[c.name].tolist() if x == x), default=0.0) for c in self._shown()]
        return [[0.0 if abs(x) < n else float(x) / size for x, size, n in zip(flat[k].tolist(), sizes, noise)]
                for k in picked]

    def text(self, most: int = 1000) -> str:
        """Returns the rows as a table in the file's units; the first and last ones if there are more than `most`."""
        return _grid.text(self._heads(), self._cells(most))

    def _repr_html_(self) -> str:
        note = f"{self.caption}: {len(np.atleast_1d(self))} rows" + ("" if self.status == "ok" else f", {self.status}")
        return _grid.html(self._heads(), self._cells(20), note)

    def to_pandas(self, index: Optional[str] = None) -> Any:
        """Returns the rows as a pandas.DataFrame; requires pandas."""
        import pandas  # type: ignore[import]

        frame = pandas.DataFrame({name: self[name] for name in self.dtype.names or ()})
        return frame.set_index(index) if index else frame


def table(data: Any, columns: Sequence[Column], caption: str) -> Table:
    """Returns a structured array as a table, without a copy."""
    result: Table = data.view(Table)
    result.columns, result.caption = tuple(columns), caption
    return result


def row_type(names: Sequence[str]) -> Any:
    """Returns the type of a row: doubles with these names, as the library lays them out."""
    return np.dtype([(name, np.float64) for name in names])
