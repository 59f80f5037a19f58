"""A number with its uncertainty."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Tuple

import numpy as np


@dataclass(frozen=True)
class Estimate:
    """A number with its standard error and its 95 % interval, in SI units.

    `float(estimate)` and a format as in f"{estimate:.3f}" are of its `value`; f"{estimate}" has the uncertainty too.
    Arithmetic is refused, since it would lose the uncertainty: take `value`, or LawFit.to_uncertainties().
    """

    name: str
    value: float
    standard_error: float
    confidence_95: Tuple[float, float]
    unit: str

    def __float__(self) -> float:
        return self.value

    def __format__(self, spec: str) -> str:
        return format(self.value, spec) if spec else str(self)

    def _no_arithmetic(self, *_: Any) -> Any:
        raise TypeError(f"arithmetic would lose the uncertainty of {self.name}: take .value for the number, or "
                        "to_uncertainties() of the fit for numbers that keep their uncertainties and correlations")

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _no_arithmetic
    __pow__ = __rpow__ = __neg__ = _no_arithmetic
    __array_ufunc__ = None  # arrays leave arithmetic to this class

    def __str__(self) -> str:
        low, high = self.confidence_95
        unit = "" if self.unit in ("", "1") else f" {self.unit}"
        return f"{with_error(self.value, self.standard_error)}{unit} (95 %: {low:.7g} to {high:.7g})"

    def to_uncertainties(self) -> Any:
        """The same as a number of the package `uncertainties`, without its correlations with other estimates:
        LawFit.to_uncertainties() keeps those."""
        from uncertainties import ufloat
        return ufloat(self.value, self.standard_error, tag=self.name)

    def to_pint(self, registry: Any = None) -> Any:
        """The value as a quantity of the package `pint`, of `registry` or of pint's own."""
        import pint
        registry = registry or pint.get_application_registry()  # type: ignore[no-untyped-call]
        return self.value * registry.parse_units(self.unit if self.unit not in ("", "1") else "dimensionless")


def with_error(value: float, error: float) -> str:
    """17.04 ± 0.03: the error at two digits if it begins with 1 or 2, else at one, the value to the same place."""
    if not (np.isfinite(error) and error > 0 and np.isfinite(value)):
        return f"{value:.7g}"
    first = f"{error:.1e}" if f"{error:.1e}"[0] in "12" else f"{error:.0e}"
    digits = (1 if first[0] in "12" else 0) - int(first.partition("e")[2])
    if -4 <= np.floor(np.log10(max(abs(value), error))) < 7:
        return f"{value:.{max(digits, 0)}f} ± {error:.{max(digits, 0)}f}"
    power = int(np.floor(np.log10(max(abs(value), error))))
    places = max(digits + power, 0)
    return f"({value / 10.0**power:.{places}f} ± {error / 10.0**power:.{places}f})e{power:+03d}"
