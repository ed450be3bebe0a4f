"""Values with units: "60 mm", (30, "deg"), or a plain number in SI."""
from __future__ import annotations

import math
from types import MappingProxyType
from typing import Any, Mapping, Tuple, Union

from ._native import ffi, lib
from ._problems import Problems, RequestError, refusal, text_of

Number = Union[float, int]
Value = Union[float, int, str, Tuple[float, str]]
CData = Any

ANGLE = (lib.YK_QUANTITY_ANGLE, lib.YK_QUANTITY_ANGLE_RATE, lib.YK_QUANTITY_ANGLE_ACCELERATION)
LENGTH = (lib.YK_QUANTITY_LENGTH, lib.YK_QUANTITY_SPEED, lib.YK_QUANTITY_ACCELERATION)
TIME = lib.YK_QUANTITY_TIME


def number(value: Any, name: str) -> float:
    """Returns a finite number; refuses everything else."""
    if isinstance(value, bool) or not hasattr(value, "__float__") or getattr(value, "ndim", 0) > 0:
        raise refusal(RequestError, "E0806", f"`{name}` takes a number, a text with a unit or (number, unit), "
                      f"not {value!r}")
    result = float(value)
    if not math.isfinite(result):
        raise refusal(RequestError, "E0806", f"`{name}` takes a finite number, not {result}")
    return result


def named(values: Any, name: str, more: Mapping[str, Any] = MappingProxyType({})) -> dict[str, Any]:
    """Returns values by name; refuses anything but a mapping from names."""
    if values is None:
        return dict(more)
    if not isinstance(values, Mapping) or not all(isinstance(key, str) for key in values):
        raise refusal(RequestError, "E0806", f"`{name}` takes values by name, as {{'theta': 1.0}}, not {values!r}")
    twice = [key for key in values if key in more]
    if twice:
        raise refusal(RequestError, "E0806", f"`{twice[0]}` stands in `{name}` and beside it")
    return {**values, **more}


def words(value: Value, name: str) -> str:
    """Returns a value as a string for the library: the pair (30, "deg") as "30.0 deg"."""
    if isinstance(value, str):
        return value
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str):
        return f"{number(value[0], name)!r} {value[1]}"
    return repr(number(value, name))


def si(model: CData, value: Value, quantity: int, name: str) -> float:
    """Returns a value in SI: numbers are in SI already, strings are read as the command reads them."""
    if type(value) is float and value - value == 0:
        return value
    if not isinstance(value, (str, tuple)):
        return number(value, name)
    problems = Problems()
    result = ffi.new("double *")
    text = words(value, name)
    if lib.yk_model_value(model, encoded(text, name), quantity, result, problems.c) < 0:
        raise problems.fail(RequestError, fallback=f"`{name}`: {text!r} is not a value")
    return number(result[0], name)


def encoded(text: str, name: str = "text") -> bytes:
    """Returns a string for C; refuses one that C would cut off."""
    if not isinstance(text, str):
        raise refusal(RequestError, "E0806", f"`{name}` takes a text, not {text!r}")
    if "\0" in text:
        raise refusal(RequestError, "E0806", f"`{name}`: a text cannot contain a NUL character")
    return text.encode("utf-8", "surrogateescape")


def unit_of(model: CData, quantity: int) -> tuple[str, float]:
    """Returns the file's unit of a quantity, and its size in SI; N for forces if the file has none."""
    size = ffi.new("double *", 1.0)
    unit = text_of(lib.yk_model_unit(model, quantity, size))
    si_units = {lib.YK_QUANTITY_FORCE: "N", lib.YK_QUANTITY_TORQUE: "N*m", lib.YK_QUANTITY_ENERGY: "J"}
    if quantity in si_units and ("/" in unit or quantity == lib.YK_QUANTITY_ENERGY and size[0] == 1):
        return si_units[quantity], 1.0
    return unit, size[0]


def digits(value: float, count: int = 6) -> str:
    """Returns a number with at most `count` significant digits, as the command writes it; "-" for NaN.

    >>> digits(0.1 + 0.2), digits(-0.0), digits(float("nan")), digits(123456789.0), digits(1.5e-7)
    ('0.3', '0', '-', '123457000', '1.5e-7')
    """
    if not math.isfinite(value):
        return "-"
    if value == 0:
        return "0"
    sign = "-" if value < 0 else ""
    mantissa, exponent = f"{abs(value):.{count - 1}e}".split("e")
    figures, point = mantissa.replace(".", "").rstrip("0"), int(exponent) + 1
    if not -5 < point <= 15:
        return f"{sign}{figures[0]}{'.' if len(figures) > 1 else ''}{figures[1:]}e{point - 1}"
    if point <= 0:
        return f"{sign}0.{'0' * -point}{figures}"
    whole, rest = figures[:point].ljust(point, "0"), figures[point:]
    return f"{sign}{whole}.{rest}" if rest else sign + whole


def shown(model: CData, value: float, quantity: int, count: int = 6) -> str:
    """Returns a value in the file's unit, such as "190.09 deg"; angles in radians also in degrees."""
    unit, size = unit_of(model, quantity)
    text = f"{digits(value / size, count)} {unit}".rstrip()
    if quantity == lib.YK_QUANTITY_ANGLE and unit == "rad":
        text += f" ({digits(value * (180 / math.pi), count)} deg)"
    return text
