"""PYTHONPATH, CROMER_LIBRARY and CROMER_PROGRAM are set by ./dev test."""

import os
import pathlib
import signal
import subprocess

import numpy as np
import pytest
from hypothesis import settings

settings.register_profile("cromer", database=None, derandomize=True)
settings.load_profile("cromer")
ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def ctrl_c_is_heard():
    """Python does not hear it where the shell began the tests in the background."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def program():
    """Runs the program with these words; gives what it printed."""
    path = os.environ["CROMER_PROGRAM"]

    def run(*words):
        done = subprocess.run([path, *words], capture_output=True, text=True, check=True)
        return done.stdout

    return run


def swing(decay_rate=0.03, angular_frequency=8.9, amplitude=0.05, noise=2e-4, seconds=20.0, step=0.01, seed=1):
    t = np.arange(0, seconds, step)
    x = amplitude * np.exp(-decay_rate * t) * np.cos(angular_frequency * t)
    return t, x + np.random.default_rng(seed).normal(0, noise, t.size)
