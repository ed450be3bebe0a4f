"""Arrays from outside: checked once, copied only if they are not contiguous doubles."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional

import numpy as np

from ._problems import RequestError, refusal

if TYPE_CHECKING:
    from numpy.typing import NDArray


def dimensions(value: Any, name: str) -> int:
    """Returns the number of dimensions of a value that may be an array."""
    try:
        return int(np.ndim(value))
    except ValueError:
        raise refusal(RequestError, "E0806", f"`{name}` takes numbers or an array, not {value!r}") from None


def doubles(value: Any, name: str, shape: Optional[tuple[int, ...]] = None) -> "NDArray[np.float64]":
    """Returns a contiguous array of finite doubles; refuses other types, other shapes and NaN, and names the first.

    Arrays of other real numbers, and those that are not contiguous, are copied.
    """
    dimensions(value, name)
    if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
        raise refusal(RequestError, "E0806", f"`{name}` takes an array without masked entries", "fill them, or leave them out")
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise refusal(RequestError, "E0806", f"`{name}` takes an array of real numbers, not of {array.dtype}")
    if shape is not None and array.shape != shape:
        if array.ndim == 0 and shape:
            array = np.full(shape, array)
        else:
            raise refusal(RequestError, "E0806", f"`{name}` takes an array of shape {shape}, not {array.shape}")
    result = np.ascontiguousarray(array, dtype=np.float64)
    if not np.isfinite(result).all():
        first = int(np.flatnonzero(~np.isfinite(result.ravel()))[0])
        where = tuple(int(k) for k in np.unravel_index(first, result.shape))
        raise refusal(RequestError, "E0806", f"`{name}` takes finite numbers; {list(where)} is {result[where]}")
    return result


def spread(values: Mapping[str, Any], count: int) -> tuple[dict[str, float], dict[str, "NDArray[np.float64]"]]:
    """Separates start values that all simulations share from arrays with one value for each."""
    several = {name: v for name, v in values.items() if not is_pair(v) and dimensions(v, name) > 0}
    arrays = {name: doubles(v, name, (count,)) for name, v in several.items()}
    return {name: v for name, v in values.items() if name not in arrays}, arrays


def is_pair(value: Any) -> bool:
    """Returns whether it is a value with its unit, such as (60, "deg")."""
    return isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str)
