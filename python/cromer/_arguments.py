"""Arguments as users have them, in the words of a request."""

from __future__ import annotations

import decimal
import math
import numbers
import os
import re
from typing import Any, Dict, Mapping, Optional

import numpy as np

from ._core import InputError
from ._estimate import Estimate
from ._options import ARGUMENTS

#: arrays of SI units, and of what was observed
_ARRAYS = {"t": "s", "periods": "s", "force": "N", "acceleration": "m/s^2", "second": "m/s^2"}
_OBSERVED = {"position": "m", "angle": "rad", "velocity": "m/s", "angular_velocity": "rad/s", "acceleration": "m/s^2"}
_SPACING = ("Value", "[s]")  # no option of the program

_STEPS = {"dt": ("step", "spacing"), "h": ("step", "spacing")}  # a symbol, and what a verb may call it


def request_of(options: Mapping[str, Any], verb: str) -> Dict[str, Any]:
    """The options that were given, in the form that a request has; `from_` is "from", a word of Python's own."""
    for symbol in _STEPS.keys() & options.keys():
        name = next((each for each in _STEPS[symbol] if each in ARGUMENTS[verb] or each in options), None)
        if name:
            raise InputError(f'{verb} has no argument "{symbol}"; did you mean {name}?', symbol, "unknown_argument_but",
                             {"argument": symbol, "verb": verb, "near": name})
    return {name.rstrip("_"): _plain(name, value, *ARGUMENTS[verb].get(name, _SPACING if name == "spacing" else ("", "")))
            for name, value in options.items() if value is not None}


def arrays_of(arrays: Mapping[str, Any], observed: Optional[str] = None) -> Dict[str, Any]:
    """The arrays, quantities of pint in SI units."""
    units = {**_ARRAYS, "y": unit_of_observed(observed)}
    return {name: in_unit(name, values, units[name]) for name, values in arrays.items()}


def plain(name: str, value: Any) -> Any:
    """A value of a network, in the form that a request has; quantities of pint in the units of SI."""
    if hasattr(value, "to_base_units"):
        value = value.to_base_units().magnitude
    return _plain(name, value, "Value", "")


def in_unit(name: str, values: Any, unit: str) -> Any:
    """An array; of pint its magnitude in this unit."""
    return _of_pint(name, values, unit) if hasattr(values, "to_base_units") else values


def unit_of_observed(observed: Optional[str]) -> str:
    """The SI unit of what was observed, "" where it is not known."""
    return _OBSERVED.get(observed or "position", "")


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
        unit = re.match(r"\[([^]]+)\]", text)
        return _plain(name, _of_pint(name, value, unit[1] if unit else "dimensionless"), kind, text)
    if isinstance(value, Estimate):  # with its unit, which the core checks
        number = f"{value.value!r} ± {value.standard_error!r}" if uncertain else repr(value.value)
        return number if value.unit in ("", "1") else f"{number} {value.unit}"
    if hasattr(value, "nominal_value"):  # uncertainties
        both = [float(value.nominal_value), float(value.std_dev)]
        return _plain(name, both if uncertain else both[0], kind, text)
    if isinstance(value, (np.ndarray, np.generic)) or hasattr(value, "__array__"):
        return _plain(name, np.asarray(value).tolist(), kind, text)
    if isinstance(value, (numbers.Real, decimal.Decimal)):
        return _plain(name, float(value), kind, text)
    if isinstance(value, (list, tuple, range)):
        return [_plain(name, each, kind, text) for each in value]
    raise InputError(f"{name} must be a number, a text or a list of them, not {type(value).__name__}", name, "must_be_value")


def _of_pint(name: str, value: Any, unit: str) -> Any:
    """Its magnitude in this unit; cycles as texts, since the core multiplies them by 2 pi, and pint does not."""
    try:
        if "hertz" in str(value.units):
            cycles = np.asarray(value.to("hertz").magnitude)
            return [f"{each!r} Hz" for each in cycles.tolist()] if cycles.ndim else f"{cycles.item()!r} Hz"
        return value.to(unit).magnitude
    except Exception as error:
        raise InputError(f"{name}: {error}", name, "wrong_unit", {"unit": unit}) from None
