"""Arguments as users have them, in the words of a request."""

from __future__ import annotations

import os
from typing import Any, Dict, Mapping, Sequence, Tuple, Union

import numpy as np

#: A number in SI units, a text with a unit ("217.6 g"), or a quantity of pint.
Value = Union[float, str, Any]
#: A Value, or (value, standard uncertainty), a text with ± ("217.6 ± 0.3 g"), or a number of `uncertainties`.
Uncertain = Union[float, str, Tuple[float, float], Any]
#: A Value, a text that is a grid ("0.5..5 / 200"), or an array.
Grid = Union[float, str, Sequence[float], "np.ndarray[Any, Any]", Any]

_COUNTED = {"hertz", "kilohertz", "megahertz", "revolutions_per_minute", "rpm"}  # cycles: the core multiplies by 2 pi


def request_of(options: Mapping[str, Any]) -> Dict[str, Any]:
    """The options that were given, in the form that a request has; `from_` is "from", a word of Python's own."""
    return {name.rstrip("_"): _plain(value) for name, value in options.items() if value is not None}


def _plain(value: Any) -> Any:
    if isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "to_base_units"):  # pint
        unit = str(value.units)
        if unit in _COUNTED:
            return f"{float(value.to('hertz').magnitude)!r} Hz"
        return _plain(value.to_base_units().magnitude)
    if hasattr(value, "nominal_value"):  # uncertainties
        return [float(value.nominal_value), float(value.std_dev)]
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if hasattr(value, "__array__"):
        return np.asarray(value).tolist()
    if isinstance(value, (list, tuple, range)):
        return [_plain(each) for each in value]
    return value
