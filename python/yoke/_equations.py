"""The machine's equations in symbols, and verdicts on equations of the user's own."""
from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Sequence, Union

from ._core import names_of
from ._native import ffi, lib
from ._problems import ModelError, Problems, RequestError, UnknownName, refusal, text_of
from ._values import CData, encoded
from ._watch import check as check_watch
from ._watch import progress_of_host

if TYPE_CHECKING:
    from ._machine import Machine


def sections() -> list[str]:
    """Returns the names of all sections: "loops", "jacobian", ..."""
    return [text_of(lib.yk_derivation_section_name(k)) for k in range(lib.yk_derivation_section_count())]


def new_derivation(model: CData, mech: CData) -> CData:
    """Starts a derivation, which can be stopped."""
    problems = Problems()
    derivation = lib.yk_derivation_new(model, mech, problems.c)
    if derivation == ffi.NULL:
        raise problems.fail(ModelError)

    def free(c: CData, keep: CData = mech) -> None:
        lib.yk_derivation_free(c)

    derivation = ffi.gc(derivation, free)
    lib.yk_derivation_set_progress(derivation, progress_of_host)
    return derivation


class Equations:
    """A page of equations. `text`, `latex`, `mathml`, `json` and `c` print it; a notebook shows it set."""

    def __init__(self, machine: "Machine", what: Union[str, Sequence[str], None], pose: Any = None) -> None:
        known = sections()
        names = [] if what is None or isinstance(what, str) and what == "all" else names_of(what)
        for name in names:
            if name not in known:
                raise refusal(UnknownName, "E0806", f"there is no section `{name}`", f"there are {', '.join(known)}")
        if pose is not None and getattr(pose, "machine", None) is not machine:
            raise refusal(RequestError, "E0806", "the pose is one of another machine")
        self.machine, self.names, self._pose = machine, names, pose
        self._core = machine._ready() if pose is None else pose._plan.core
        self._pages: dict[str, str] = {}
        self._page("text")  # derives now, so that it raises now if something cannot be derived

    def _page(self, format_: str) -> str:
        if format_ not in self._pages:
            with self.machine._lock:
                self._pages[format_] = self._print(format_)
        return self._pages[format_]

    def _print(self, format_: str) -> str:
        core = self._core
        mech = core.base if self._pose is None else self._pose._plan.mech
        derivation = new_derivation(core.model, mech)
        options = ffi.new("YkPageOptions *")
        options[0] = lib.yk_default_page_options()
        options.format = lib.yk_page_format_find(format_.encode())
        if self.names:
            wanted = ffi.new("bool[]", [name in self.names for name in sections()])
            options.sections = wanted
        if self._pose is not None:
            options.state = self._pose._slot.state
            if self._pose._forces:
                options.dynamics = self._pose._slot.dynamics
        problems = Problems()
        status = lib.yk_derivation_page(derivation, options, problems.c)
        if status < 0:
            raise problems.fail(ModelError, status, "the equations cannot be derived exactly")
        return text_of(lib.yk_derivation_text(derivation))

    def text(self) -> str:
        """Returns the equations for people, one formula on each line."""
        return self._page("text")

    def latex(self) -> str:
        """Returns a whole LaTeX document."""
        return self._page("latex")

    def mathml(self) -> str:
        """Returns a whole HTML document with MathML."""
        return self._page("mathml")

    def c(self) -> str:
        """Returns the equations as C, with one function for each section."""
        return self._page("c")

    def json(self) -> Any:
        """Returns the equations as Python data, as `yoke derive --format json` writes them."""
        return json.loads(self._page("json"))

    def formulas(self) -> list[str]:
        """Returns every formula as LaTeX, without the document around it."""
        return [item["latex"] for section in self.json()["sections"] for item in section["items"] if "latex" in item]

    def _repr_latex_(self) -> str:
        return "\n".join(f"$$\\displaystyle {formula}$$" for formula in self.formulas())

    def __str__(self) -> str:
        return self.text()

    def __repr__(self) -> str:
        what = ", ".join(self.names) or "all"
        return f"<yoke.Equations of {self.machine.name!r}: {what}>"


class Verdict(NamedTuple):
    """Whether an equation is true for a machine.

    verdict  "true" for all dimensions, "true-here" with this file's numbers, "true-driven" as the drives move it,
             "false", or "undecided"
    """

    equation: str
    verdict: str
    is_identity: bool  # true even if the loops are open
    poses: int  # at which both sides were compared
    machines: int  # with other dimensions, compared too
    left: Optional[float]  # both sides at a pose where they differ
    right: Optional[float]
    pose: dict[str, tuple[float, float, float]]  # position, rate and acceleration of the coordinates there
    parameters: Optional[str]  # "a = 0.053", of a machine for which it is false
    hint: Optional[str]  # the slip that would explain it

    def __bool__(self) -> bool:
        return self.verdict.startswith("true")

    def __repr__(self) -> str:
        more = f": {self.left:.6g} is not {self.right:.6g}" if self.left is not None and self.right is not None else ""
        return f"<yoke.Verdict {self.verdict}{more}{'; ' + self.hint if self.hint else ''}>"


def verdict_on(machine: "Machine", equation: str, pose: Any) -> Verdict:
    """Decides about an equation, from a pose whose state changes."""
    core, slot, mech = pose._plan.core, pose._slot, pose._plan.mech
    derivation = new_derivation(core.model, mech)
    problems = Problems()
    dynamics = slot.dynamics if slot.dynamics is not None else ffi.NULL
    v = lib.yk_derivation_check(derivation, slot.state, dynamics, encoded(equation, "equation"), problems.c)
    check_watch()
    if v.kind == lib.YK_CHECK_UNREADABLE:
        raise problems.fail(RequestError, fallback="the equation could not be read")
    shown = v.shown
    differs = v.kind == lib.YK_CHECK_FALSE or v.is_false_there
    there = {} if shown.positions == ffi.NULL or not differs else {
        c.name: (shown.positions[c.number].position, shown.positions[c.number].velocity,
                 shown.positions[c.number].acceleration) for c in pose._plan.coordinates.values()}
    return Verdict(
        equation, text_of(lib.yk_check_kind_name(v.kind)), v.is_identity, v.poses, v.machines,
        shown.left if differs else None, shown.right if differs else None, there,
        text_of(shown.machine) or None if differs else None, text_of(v.slip) or None,
    )
