"""Exceptions that carry the problems with their place and hint, and the collector that makes them."""
from __future__ import annotations

import warnings
from typing import Any, NamedTuple, Optional

from . import _watch
from ._native import ffi, lib

_SEVERITIES = ("note", "warning", "error")


class Problem(NamedTuple):
    """One error, warning or note about a file or a request.

    `line` and `column` count from 1; `line` is 0 if there is no place in a text, and `where` may then name the item.
    """

    severity: str  # "note", "warning" or "error"
    code: str  # "E0123", "W0123" or "N0123", which `yoke.explain` explains
    message: str
    line: int = 0
    column: int = 0
    length: int = 0
    hint: Optional[str] = None
    where: Optional[str] = None

    def __str__(self) -> str:
        place = f"{self.line}:{self.column}: " if self.line else f"{self.where}: " if self.where else ""
        hint = f"\nhint: {self.hint}" if self.hint else ""
        return f"{place}{self.severity}: {self.message} [{self.code}]{hint}"


class Error(Exception):
    """The base of all exceptions of Yoke; `problems` gives the reasons, each with its place and hint."""

    def __init__(self, text: str, problems: tuple[Problem, ...] = (), status: str = "") -> None:
        super().__init__(text, problems, status)
        self.text, self.problems, self.status = text, problems, status

    def __str__(self) -> str:
        return self.text


class ModelError(Error, ValueError):
    """The machine's file, or the machine that was built, is wrong."""


class RequestError(Error, ValueError):
    """The request is wrong: an unknown name, a value that cannot be read, an option that does not fit."""


class UnknownName(RequestError, LookupError):
    """The machine has nothing of this name."""


class PoseError(Error):
    """The machine has no answer to this request: a limit is in the way, or nothing closes. `status` says which."""


class ClosedError(Error):
    """The object was closed and can no longer be used."""


class YokeWarning(UserWarning):
    """A warning of Yoke: the answer is valid, but should be looked at."""


def text_of(value: Any) -> str:
    """Returns a C string as a str; "" for NULL."""
    result: str = "" if value == ffi.NULL else ffi.string(value).decode("utf-8", "replace")
    return result


def status_name(status: int) -> str:
    """Returns the command's word for a status: "ok", "limit", ..."""
    return text_of(lib.yk_status_name(status))


def _problem(p: Any) -> Problem:
    return Problem(
        _SEVERITIES[p.severity], f"{'NWE'[p.severity]}{p.code:04d}", text_of(p.message), p.place.line, p.place.column,
        p.place.length, text_of(p.hint) or None, text_of(p.where) or None,
    )


class Problems:
    """Collects the library's problems during a call; then raises or warns of them."""

    __slots__ = ("c",)

    def __init__(self) -> None:
        self.c = lib.yk_problems_new()
        if self.c == ffi.NULL:
            raise MemoryError("out of memory")
        self.c = ffi.gc(self.c, lib.yk_problems_free)

    def list(self) -> tuple[Problem, ...]:
        """Returns all problems in order of their places."""
        return tuple(_problem(lib.yk_problems_get(self.c, k)[0]) for k in range(lib.yk_problems_count(self.c)))

    def text(self) -> str:
        """Returns them as the command prints them, with line, caret and hint."""
        return text_of(lib.yk_problems_text(self.c, 0)).rstrip("\n")

    def fail(self, kind: type[Error], status: int = 0, fallback: str = "out of memory") -> Error:
        """Returns the exception for a call that failed; if something outside ended it, such as Ctrl-C, raises that."""
        _watch.check()
        problems = self.list()
        if status == lib.YK_NO_MEMORY or not problems and fallback == "out of memory":
            raise MemoryError("out of memory")
        if any(p.code == "E0100" for p in problems):
            raise MemoryError(self.text())
        return kind(self.text() or fallback, problems, status_name(status) if status else "")

    def warn(self, level: int = 3) -> None:
        """Issues the problems that are warnings."""
        for problem in self.list():
            if problem.severity == "warning":
                warnings.warn(str(problem), YokeWarning, stacklevel=level + 1)


def refusal(kind: type[Error], code: str, message: str, hint: Optional[str] = None, status: str = "") -> Error:
    """Returns an exception for a request that this package itself refuses, in the command's words."""
    problem = Problem("error", code, message, hint=hint)
    return kind(str(problem), (problem,), status)


def explain(code: str) -> str:
    """Returns the paragraph that explains a code.

    >>> explain("E0814").splitlines()[0]
    'The machine has no coordinate of this name. `yoke check` lists the coordinates.'
    """
    digits = code.upper().lstrip("ENW")
    found = lib.yk_code_explain(int(digits)) if digits.isdigit() and len(digits) < 9 else ffi.NULL
    if found == ffi.NULL:
        raise refusal(UnknownName, "E0806", f"there is no code `{code}`")
    return text_of(found)
