"""What an argument may be."""

from __future__ import annotations

from typing import Any, Sequence, Tuple, Union

import numpy as np

#: A number in SI units, a text with a unit ("217.6 g"), or a quantity of pint.
Value = Union[float, str, Any]
#: A Value, or (value, standard uncertainty), a text with ± ("217.6 ± 0.3 g"), or a number of `uncertainties`.
Uncertain = Union[float, str, Tuple[float, float], Any]
#: A Value, a text that is a grid ("0.5:5:200", "0.1:10:50:log", "2,5,10 Hz"), or an array.
Grid = Union[float, str, Sequence[float], "np.ndarray[Any, Any]", Any]
