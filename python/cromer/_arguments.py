"""Arguments as users have them, in the words of a request."""

from __future__ import annotations

import math
import os
from typing import Any, Dict, Mapping

import numpy as np

from ._core import InputError
from ._options import ARGUMENTS

_COUNTED = {"hertz", "kilohertz", "megahertz", "revolutions_per_minute", "rpm"}  # cycles: the core multiplies by 2 pi


def request_of(options: Mapping[str, Any], verb: str) -> Dict[str, Any]:
    """The options that were given, in the form that a request has; `from_` is "from", a word of Python's own."""
    table = ARGUMENTS[verb]
    return {name.rstrip("_"): _plain(name, value, table.get(name, ("", ""))[0] == "Uncertain")
            for name, value in options.items() if value is not None}


def _plain(name: str, value: Any, uncertain: bool) -> Any:
    if isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, float):
        if not math.isfinite(value):
            raise InputError(f"{name} must be finite, not {value}", name, "not_finite", {"value": str(value)})
        return float(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "to_base_units"):  # pint
        if str(value.units) in _COUNTED:
            return f"{float(value.to('hertz').magnitude)!r} Hz"
        return _plain(name, value.to_base_units().magnitude, uncertain)
    for number, error in (("nominal_value", "std_dev"), ("value", "standard_error")):  # uncertainties, Estimate
        if hasattr(value, number) and hasattr(value, error):
            both = [getattr(value, number), getattr(value, error)]
            return _plain(name, both if uncertain else both[0], uncertain)
    if isinstance(value, (np.ndarray, np.generic)) or hasattr(value, "__array__"):
        return _plain(name, np.asarray(value).tolist(), uncertain)
    if isinstance(value, (list, tuple, range)):
        return [_plain(name, each, uncertain) for each in value]
    raise InputError(f"{name} must be a number, a text or a list of them, not {type(value).__name__}", name, "must_be_value")
