"""The handles of one machine: its model, and its mechanisms with the pose from which every request begins."""
from __future__ import annotations

from typing import Any, Iterable, NamedTuple, Optional, Sequence

from . import _reach, _start
from ._native import ffi, lib
from ._problems import ModelError, Problems, RequestError, UnknownName, refusal, text_of
from ._values import ANGLE, LENGTH, CData, Value, encoded, number, words
from ._watch import progress_of_host


class Coordinate(NamedTuple):
    """A coordinate of the machine: second body relative to first."""

    name: str
    number: int
    is_distance: bool
    is_declared: bool
    has_drive: bool
    has_start: bool
    input: int  # its number among the inputs, or -1

    def quantity(self, order: int) -> int:
        """Returns the library's quantity of its value, rate or acceleration."""
        return int((LENGTH if self.is_distance else ANGLE)[order])


def nearest(name: str, names: Iterable[str]) -> Optional[str]:
    """Returns the name that was probably meant."""
    from difflib import get_close_matches

    found = get_close_matches(name, list(names), 1, 0.6)
    return found[0] if found else None


def parse(text: str, name: str, overrides: Sequence[tuple[str, str]], lock: Optional[str], problems: Problems) -> CData:
    """Reads a model file's text. Returns the model, or None with problems added."""
    options = ffi.new("YkLoadOptions *")
    options[0] = lib.yk_default_load_options()
    kept = [(ffi.new("char[]", encoded(n)), ffi.new("char[]", encoded(v))) for n, v in overrides]
    options.parameters = parameters = ffi.new("YkOverride[]", len(kept) + 1)
    for k, (n, v) in enumerate(kept):
        parameters[k].name, parameters[k].value = n, v
    options.parameter_count = len(kept)
    options.lock = locked = ffi.NULL if lock is None else ffi.new("char[]", encoded(lock))
    options.progress = progress_of_host
    data = encoded(text)
    model = lib.yk_model_parse(data, len(data), encoded(name), options, problems.c)
    del kept, parameters, locked
    return None if model == ffi.NULL else ffi.gc(model, lib.yk_model_free)


_SI_UNITS = ("m", "rad", "kg", "s", "N", "N*m", "kg*m^2", "m/s", "rad/s", "m/s^2", "rad/s^2", "N/m", "N*s/m", "N*m/rad",
             "N*m*s/rad", "J", "m^2", "1/s")


def exact_words(own: CData, name: str, value: Value) -> str:
    """Returns a parameter's value as a string; a number is in SI, and reads back as the same number."""
    if isinstance(value, (str, tuple)):
        return words(value, name)
    wanted = number(value, name)
    if own is None or lib.yk_model_parameter_unit(own, encoded(name)) == 1:
        return repr(wanted)
    read = ffi.new("double *")
    for unit in _SI_UNITS:  # one of them has the parameter's dimension
        text = f"{wanted!r} {unit}"
        status = lib.yk_model_parameter_read(own, encoded(name), text.encode(), read, Problems().c)
        if status >= 0 and read[0] == wanted:
            return text
    return repr(wanted / lib.yk_model_parameter_unit(own, encoded(name)))


class Facts:
    """A model with everything that is computed from it once.

    Nothing that it points to points back to it, here and wherever handles of the library are kept: reference counts
    then free them in order. The collector of cycles would free them in any order.
    """

    def __init__(
        self, text: str, name: str, parameters: dict[str, Value], lock: Optional[str], problems: Problems
    ) -> None:
        self.text, self.name, self.parameters, self.lock = text, name, parameters, lock
        self.own: CData = None  # the file's own machine, if parameters replace its values
        overrides: list[tuple[str, str]] = []
        if parameters:
            quiet = Problems()
            self.own = parse(text, name, [], lock, quiet)
            if self.own is None and any(not isinstance(v, (str, tuple)) for v in parameters.values()):
                raise quiet.fail(ModelError)
            overrides = [(n, exact_words(self.own, n, v)) for n, v in parameters.items()]
        self.model = parse(text, name, overrides, lock, problems)
        if self.model is None:
            raise problems.fail(ModelError)
        self.base = self.compile(self.model, (), problems)
        if self.base is None:
            raise problems.fail(ModelError)
        self.coordinates = self.coordinates_of(self.base)
        self.bodies = [text_of(lib.yk_model_body_name(self.model, k)) for k in
                       range(lib.yk_model_body_count(self.model))]
        self.joints = [text_of(lib.yk_model_joint_name(self.model, k)) for k in
                       range(lib.yk_model_joint_count(self.model))]
        model = self.model
        self.points = {
            f"{self.bodies[lib.yk_model_point_body(model, k)]}.{text_of(lib.yk_model_point_name(model, k))}": k
            for k in range(lib.yk_model_point_count(model))
        }
        self.start = _start.Start(self)

    def compile(self, model: CData, inputs: Sequence[str], problems: Problems) -> CData:
        """Compiles a model with these coordinates as its first inputs. Returns None with problems added."""
        names = [ffi.new("char[]", encoded(name)) for name in inputs]
        options = ffi.new("YkCompileOptions *")
        options.inputs = array = ffi.new("char *[]", names or [ffi.NULL])
        options.input_count = len(names)
        options.progress = progress_of_host
        mech = lib.yk_mechanism_compile(model, options, problems.c)
        del array
        if mech == ffi.NULL:
            return None

        def free(c: CData, keep: CData = model) -> None:
            lib.yk_mechanism_free(c)

        return ffi.gc(mech, free)

    @staticmethod
    def coordinates_of(mech: CData) -> dict[str, Coordinate]:
        """Returns the coordinates of a mechanism by name, in their order."""
        result = {}
        for k in range(lib.yk_coordinate_count(mech)):
            c = lib.yk_coordinate_info(mech, k)
            name = text_of(c.name)
            result[name] = Coordinate(name, k, c.is_distance, c.is_declared, c.has_drive, c.has_start, c.input)
        return result

    def coordinate(self, name: str) -> Coordinate:
        """Finds a coordinate; refuses an unknown name and suggests the nearest."""
        found = self.coordinates.get(name)
        if found is None:
            near = nearest(str(name), self.coordinates)
            raise refusal(UnknownName, "E0814", f"the machine has no coordinate `{name}`",
                          f"did you mean `{near}`?" if near else f"there are {', '.join(self.coordinates)}")
        return found


class Core(Facts):
    """The facts, and the plans of earlier requests. The machine's lock guards it."""

    def __init__(
        self, text: str, name: str, parameters: dict[str, Value], lock: Optional[str], problems: Problems
    ) -> None:
        super().__init__(text, name, parameters, lock, problems)
        facts = Facts.__new__(Facts)
        facts.__dict__.update(self.__dict__)
        self.facts = facts
        self.plans: dict[Any, _reach.Plan] = {}

    def plan(self, at: Sequence[str], rate: Sequence[str] = (), accel: Sequence[str] = (), swept: Optional[str] = None,
             imposed: bool = False) -> "_reach.Plan":
        """Returns the plan of requests that set these coordinates. imposed: all inputs move as prescribed."""
        key = (tuple(at), tuple(rate), tuple(accel), swept, imposed)
        found = self.plans.get(key)
        if found is None:
            if len(self.plans) >= 64:  # a program that always asks for new combinations keeps the latest
                self.plans.pop(next(iter(self.plans)))
            found = self.plans[key] = _reach.Plan(self.facts, *key)
        return found


def channels_of(mech: CData, names: Sequence[str]) -> CData:
    """Reads channels' names; refuses all unknown ones at once."""
    problems = Problems()
    channels = ffi.new("YkChannel[]", len(names) + 1)
    good = True
    for k, name in enumerate(names):
        good &= lib.yk_channel_parse(mech, encoded(name, "of"), channels + k, problems.c) == lib.YK_OK
    if not good:
        raise problems.fail(UnknownName)
    return channels


def names_of(of: Any) -> list[str]:
    """Returns `of` as a list of names; it is a list, or a string such as "s,s.rate", as the command takes it."""
    if isinstance(of, str):
        return [name for name in of.split(",") if name]
    names = list(of)
    for name in names:
        if not isinstance(name, str):
            raise refusal(RequestError, "E0806", f"a list of names takes texts, not {name!r}")
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise refusal(RequestError, "E0806", f"{', '.join(twice)} is named twice")
    return names
