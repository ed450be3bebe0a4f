"""Designs of a study: values of parameters on a grid, or drawn from distributions."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional

import numpy as np

from . import _sweep
from ._native import ffi, lib
from ._problems import ModelError, Problems, RequestError, UnknownName, refusal, text_of
from ._values import CData, Value, encoded, si, words

if TYPE_CHECKING:
    from ._core import Core

INF = float("inf")


class Distribution(NamedTuple):
    """A distribution of a parameter; make it with `uniform`, `normal`, `triangular` or `tolerance`."""

    kind: str
    values: tuple[Value, ...]
    within: Optional[tuple[Value, Value]] = None


def uniform(low: Value, high: Value) -> Distribution:
    """Returns a uniform distribution between two values."""
    return Distribution("uniform", (low, high))


def normal(mean: Value, deviation: Value, within: Optional[tuple[Value, Value]] = None) -> Distribution:
    """Returns a normal distribution, cut off at the ends of `within` if they are given."""
    return Distribution("normal", (mean, deviation), within)


def triangular(low: Value, mode: Value, high: Value) -> Distribution:
    """Returns a triangular distribution."""
    return Distribution("triangular", (low, mode, high))


def tolerance(value: Value) -> Distribution:
    """Returns a uniform distribution within a tolerance of the machine's own value."""
    return Distribution("tolerance", (value,))


def parameter(model: CData, name: str, value: Value) -> float:
    """Returns a parameter's value in SI."""
    own = lib.yk_model_parameter(model, encoded(name))
    if own != own:
        raise refusal(UnknownName, "E0806", f"the machine has no parameter `{name}`")
    if not isinstance(value, (str, tuple)):
        return si(model, value, lib.YK_QUANTITY_NUMBER, name)
    problems, result = Problems(), ffi.new("double *")
    if lib.yk_model_parameter_read(model, encoded(name), encoded(words(value, name)), result, problems.c) < 0:
        raise problems.fail(RequestError)
    return float(result[0])


def _drawn(model: CData, name: str, asked: Distribution, seed: int, count: int, number: int) -> Any:
    own = parameter(model, name, lib.yk_model_parameter(model, encoded(name)))
    v = [parameter(model, name, x) for x in asked.values]
    d = ffi.new("YkDistribution *")
    d.low, d.high = -INF, INF
    if asked.kind == "uniform":
        d.kind, d.low, d.high = lib.YK_DISTRIBUTION_UNIFORM, v[0], v[1]
    elif asked.kind == "tolerance":
        d.kind, d.low, d.high = lib.YK_DISTRIBUTION_UNIFORM, own - v[0], own + v[0]
    elif asked.kind == "triangular":
        d.kind, d.low, d.center, d.high = lib.YK_DISTRIBUTION_TRIANGULAR, v[0], v[1], v[2]
    else:
        d.kind, d.center, d.spread = lib.YK_DISTRIBUTION_NORMAL, v[0], v[1]
        if asked.within is not None:
            d.low, d.high = (parameter(model, name, x) for x in asked.within)
    if not lib.yk_distribution_is_valid(d):
        raise refusal(RequestError, "E0806", f"`{name}`: {asked} is not a distribution")
    result = np.empty(count)
    lib.yk_host_draw(d, seed, number, ffi.from_buffer("double[]", result), count)
    return result


def grid(model: CData, vary: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the designs of a grid, (from, to, count) for each parameter; the last one varies fastest."""
    axes = []
    for name, given in vary.items():
        if not isinstance(given, (tuple, list)) or len(given) not in (3, 4):
            raise refusal(RequestError, "E0806", f"vary takes (from, to, count) for `{name}`, not {given!r}",
                          'as in vary={"r": ("40 mm", "60 mm", 100)}')
        low, high, count = given[0], given[1], _sweep.count(given[2], name)
        if len(given) == 4:
            low, high = (given[0], given[3]), (given[1], given[3])
        first, last = parameter(model, name, low), parameter(model, name, high)
        axis = [first + (last - first) * k / (count - 1) if count > 1 else first for k in range(count)]
        axis[-1] = last if count > 1 else first
        axes.append(np.array(axis))
    if int(np.prod([len(a) for a in axes])) > 10_000_000:
        raise refusal(RequestError, "E0806", "vary: the grid has more than 10 million designs")
    return {n: a.ravel() for n, a in zip(vary, np.meshgrid(*axes, indexing="ij"))} if axes else {}


def sampled(core: "Core", sample: Any, designs: Optional[int], seed: Optional[int]) -> dict[str, Any]:
    """Returns designs drawn from distributions, given here or in a file."""
    if isinstance(sample, Mapping):
        count = _sweep.count(1000 if designs is None else designs, "designs")
        for name, d in sample.items():
            if not isinstance(d, Distribution):
                raise refusal(RequestError, "E0806", f"sample takes a distribution for `{name}`, not {d!r}",
                              "as in yoke.normal(\"60 mm\", \"0.1 mm\")")
        return {n: _drawn(core.model, n, d, 1 if seed is None else seed, count, k)
                for k, (n, d) in enumerate(sample.items())}
    problems = Problems()
    c = lib.yk_tolerances_load(encoded(os.fspath(sample)), core.model, problems.c)
    if c == ffi.NULL:
        raise problems.fail(ModelError)
    c = ffi.gc(c, lib.yk_tolerances_free)
    count = _sweep.count(designs or int(lib.yk_tolerances_designs(c)) or 1000, "designs")
    result = {}
    for k in range(lib.yk_tolerances_count(c)):
        values = np.empty(count)
        d = ffi.new("YkDistribution *", lib.yk_tolerances_at(c, k))
        lib.yk_host_draw(d, lib.yk_tolerances_seed(c) if seed is None else seed, k,
                         ffi.from_buffer("double[]", values), count)
        result[text_of(lib.yk_tolerances_name(c, k))] = values
    return result
