"""Cromer: the oscillator on a spring, from a recording to its law of motion and back.

    fit = cromer.fit(t, x, mass="217.6 ± 0.3 g")     # or cromer.fit("swing.csv", mass=...)
    fit["decay_rate"].value, fit.law, fit.at(t)

Arguments are SI numbers or texts with a unit; arrays are one-dimensional. The verbs are read, fit, simulate,
compare, methods, modes, spectrum and sweep.
"""

from ._core import InputError
from ._core import version as __version__
from ._estimate import Estimate
from ._networks import FittedLink, NetworkFit, NetworkRun, NetworkRuns
from ._results import (Comparison, CromerWarning, Curve, Fits, FitWarning, LawFit, Methods, Mode, Modes, NoSuccess, Notice,
                       Recognition, Recording, Residual, Run, Runs, Spectrum, Sweep, Trajectory)
from ._verbs import compare, fit, fit_all, methods, modes, read, simulate, spectrum, sweep

__all__ = ["Comparison", "CromerWarning", "Curve", "Estimate", "FitWarning", "Fits", "FittedLink", "InputError", "LawFit", "Methods",
           "Mode", "Modes", "NetworkFit", "NetworkRun", "NetworkRuns", "NoSuccess", "Notice", "Recognition", "Recording", "Residual", "Run", "Runs", "Spectrum", "Sweep", "Trajectory",
           "__version__", "compare", "fit", "fit_all", "methods", "modes", "read", "simulate", "spectrum", "sweep"]
