"""Arguments as users have them, in the words of a request."""

from __future__ import annotations

import math
import os
import re
from typing import Any, Dict, Mapping

import numpy as np

from ._core import InputError
from ._estimate import Estimate
from ._options import ARGUMENTS

_COUNTED = {"hertz", "kilohertz", "megahertz", "revolutions_per_minute", "rpm"}  # cycles: the core multiplies by 2 pi


_STEPS = {"dt": ("step", "spacing"), "h": ("step", "spacing")}  # a symbol, and what a verb may call it


def request_of(options: Mapping[str, Any], verb: str) -> Dict[str, Any]:
    """The options that were given, in the form that a request has; `from_` is "from", a word of Python's own."""
    for symbol in _STEPS.keys() & options.keys():
        name = next((each for each in _STEPS[symbol] if each in ARGUMENTS[verb] or each in options), None)
        if name:
            raise InputError(f'{verb} has no argument "{symbol}"; did you mean {name}?', symbol, "unknown_argument_but",
                             {"argument": symbol, "verb": verb, "near": name})
    return {name.rstrip("_"): _plain(name, value, *ARGUMENTS[verb].get(name, ("", "")))
            for name, value in options.items() if value is not None}


def _plain(name: str, value: Any, kind: str, text: str) -> Any:
    """`kind` and `text` are the table's: the type, and what the argument is, with its unit in brackets first."""
    uncertain = kind == "Uncertain"
    if isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, float):
        if not math.isfinite(value):
            raise InputError(f"{name} must be finite, not {value}", name, "not_finite", {"value": str(value)})
        return float(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "to_base_units"):  # pint
        return _plain(name, _of_pint(name, value, text), kind, text)
    if isinstance(value, Estimate):  # with its unit, which the core checks
        number = f"{value.value!r} ± {value.standard_error!r}" if uncertain else repr(value.value)
        return number if value.unit in ("", "1") else f"{number} {value.unit}"
    if hasattr(value, "nominal_value"):  # uncertainties
        both = [float(value.nominal_value), float(value.std_dev)]
        return _plain(name, both if uncertain else both[0], kind, text)
    if isinstance(value, (np.ndarray, np.generic)) or hasattr(value, "__array__"):
        return _plain(name, np.asarray(value).tolist(), kind, text)
    if isinstance(value, (list, tuple, range)):
        return [_plain(name, each, kind, text) for each in value]
    raise InputError(f"{name} must be a number, a text or a list of them, not {type(value).__name__}", name, "must_be_value")


def _of_pint(name: str, value: Any, text: str) -> Any:
    """Its magnitude in the argument's unit; cycles as a text, since the core multiplies them by 2 pi."""
    if str(value.units) in _COUNTED:
        return f"{float(value.to('hertz').magnitude)!r} Hz"
    unit = re.match(r"\[([^]]+)\]", text)
    try:
        return value.to(unit[1] if unit else "dimensionless").magnitude
    except Exception as error:
        raise InputError(f"{name}: {error}", name, "wrong_unit", {"unit": unit[1] if unit else ""}) from None
