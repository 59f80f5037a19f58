"""Modes of an hour of five channels, 15 a second, in the Python package and in pyOMA2, with standard errors and orders up
to 40 in both. A shear frame of five floors is shaken by white forces. Prints row, who, seconds, and on standard error how
far off the frequencies are, in per mille.

usage: modes.py LIBRARY"""
import logging
import os
import pathlib
import sys

import numpy

from stopwatch import median

os.environ["CROMER_LIBRARY"] = os.path.abspath(sys.argv[1])
os.environ["TQDM_DISABLE"] = "1"
logging.disable()
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import cromer

ROW = "an hour of five channels to modes with errors"
STEP, SAMPLES, FLOORS = 1 / 15, 54000, 5


def frame():
    """Stiffness and damping over mass, and the natural frequencies [Hz]."""
    stiffness = 400 * (2 * numpy.eye(FLOORS) - numpy.eye(FLOORS, k=1) - numpy.eye(FLOORS, k=-1))
    stiffness[-1, -1] = 400
    return stiffness, 0.08 * numpy.eye(FLOORS) + 5e-4 * stiffness, numpy.sqrt(numpy.linalg.eigvalsh(stiffness)) / (2 * numpy.pi)


def record():
    """Accelerations of the floors: the state from sample to sample by the exponential of its matrix, forces held between."""
    stiffness, damping, _ = frame()
    motion = numpy.block([[numpy.zeros((FLOORS, FLOORS)), numpy.eye(FLOORS)], [-stiffness, -damping]])
    values, vectors = numpy.linalg.eig(motion)
    back = numpy.linalg.inv(vectors)
    forces = numpy.random.default_rng(1).standard_normal((SAMPLES, FLOORS))
    pushed = back[:, FLOORS:] @ forces.T  # of each eigenvalue
    amplitudes = numpy.zeros(2 * FLOORS, complex)
    seen = numpy.empty((SAMPLES, FLOORS))
    factor, gain = numpy.exp(values * STEP), numpy.expm1(values * STEP) / values
    for n in range(SAMPLES):
        seen[n] = (vectors[FLOORS:] @ (values * amplitudes)).real + forces[n]
        amplitudes = factor * amplitudes + gain * pushed[:, n]
    return seen + 0.05 * seen.std(axis=0) * numpy.random.default_rng(2).standard_normal(seen.shape)


def off(frequencies):
    """Per mille of each natural frequency, by the nearest one found."""
    return ", ".join(f"{1000 * min((each / true - 1 for each in frequencies), key=abs):+.2f}" for true in frame()[2])


def report(who, seconds, frequencies):
    print(ROW, who, seconds, sep="\t", flush=True)
    print(f"{who}: {off(frequencies)}", file=sys.stderr)


def main():
    seen = record()
    times = numpy.arange(SAMPLES) * STEP
    ours = lambda: cromer.modes(times, seen.T, observed="acceleration")
    report("cromer", median(ours, 3), ours().frequency)
    try:
        from pyoma2.algorithms import SSI
        from pyoma2.setup.single import SingleSetup
    except ImportError:
        return

    def theirs():
        setup = SingleSetup(seen, fs=1 / STEP)
        setup.add_algorithms(SSI(name="ssi", method="cov", br=30, ordmax=40, step=2, calc_unc=True))
        setup.run_all()
        setup.mpe("ssi", sel_freq=list(frame()[2]), order_in="find_min")
        return setup["ssi"].result.Fn

    report("pyOMA2", median(theirs, 1), theirs())


main()
