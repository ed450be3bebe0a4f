"""Tables for people: text as the command aligns it, and HTML."""
from __future__ import annotations

from html import escape
from typing import Optional, Sequence, Union

from ._values import digits

Cell = Union[str, float, None]


def _left(text: str) -> int:
    """Returns the place at which a number is aligned: its point, its exponent, or its end."""
    return min((text.find(c) for c in ".e" if c in text), default=len(text))


def text(heads: Sequence[str], rows: Sequence[Sequence[Cell]], indent: int = 2) -> str:
    """Returns a table whose numbers are aligned at their points.

    >>> print(text(["angle", "[deg]"], [["theta", 30.0], ["phi", -7.25]]))
      angle  [deg]
      theta  30
      phi    -7.25
    """
    numeric = [any(isinstance(row[c], float) for row in rows) for c in range(len(heads))]
    cells = [[digits(x) if isinstance(x, float) else x or "" for x in row] for row in rows]
    lines, columns = [[""] * len(heads) for _ in range(len(rows) + 1)], []
    for c, head in enumerate(heads):
        numbers = [row[c] for row, raw in zip(cells, rows) if isinstance(raw[c], float)]
        left = max((_left(n) for n in numbers), default=0)
        right = max((len(n) - _left(n) for n in numbers), default=0)
        plain = [row[c] for row, raw in zip(cells, rows) if not isinstance(raw[c], float)]
        total = max([left + right, len(head), *map(len, plain)])
        columns.append(total)
        lines[0][c] = head.rjust(total) if numeric[c] else head
        for r, row in enumerate(cells):
            is_number = isinstance(rows[r][c], float)
            lines[r + 1][c] = " " * (total - right - _left(row[c])) + row[c] if is_number else row[c]
    return "\n".join(
        (" " * indent + "  ".join(cell.ljust(w) for cell, w in zip(line, columns))).rstrip() for line in lines
    )


def html(heads: Sequence[str], rows: Sequence[Sequence[Cell]], caption: Optional[str] = None) -> str:
    """Returns a table as HTML."""
    out = ["<table>"]
    if caption:
        out.append(f"<caption>{escape(caption)}</caption>")
    out.append("<thead><tr>" + "".join(f"<th>{escape(h)}</th>" for h in heads) + "</tr></thead><tbody>")
    for row in rows:
        words = [digits(x) if isinstance(x, float) else x or "" for x in row]
        out.append("<tr>" + "".join(f"<td>{escape(w)}</td>" for w in words) + "</tr>")
    return "\n".join([*out, "</tbody></table>"])
