"""What bench/ measures of Cromer itself: the programs of a build, and its whole commands."""
import os
import pathlib
import subprocess
import sys

PROGRAMS = ["w1", "work_precision", "w2", "w3", "w4", "w5", "w6", "invariants"]


def rows_of(command):
    """What a program prints: lines of row, who, seconds."""
    answer = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    if answer.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, command))} failed:\n{answer.stderr}")
    return [line.split("\t") for line in answer.stdout.splitlines() if line.count("\t") == 2]


def spectrum_commands(cromer, recording, folder):
    """Of a recording that bench_w3 writes."""
    return {f"whole command, 1000 periods to CSV, {name}":
            [cromer, "spectrum", recording, "--periods", "0.1:10:1000:log", "--peaks", name, "-o", os.path.join(folder, "spectrum.csv")]
            for name in ("samples", "continuous")}


def fit_commands(cromer, recording):
    """Of a recording of five million samples that bench_w4 writes."""
    return {"5 million samples, file to law": [cromer, "fit", recording, "--law", "viscous", "--json"]}


def sweep_commands(cromer):
    """A resonance curve of a million points on one core, not written, and a map of basins on all."""
    return {"resonance curve of 10^6 points, one core, not written":
            [cromer, "sweep", "--damping-ratio", "0.05", "--drive-amplitude", "1", "--drive-frequency", "0.1:3:1000000",
             "--threads", "1", "--quiet"],
            "basins, 1000 x 1000 points, 500 cycles of the drive each, all cores":
            [cromer, "sweep", "--stiffness=-1", "--cubic", "1", "--damping", "0.1", "--drive-amplitude", "0.1",
             "--drive-frequency", "1", "--position=-2:2:1000", "--velocity=-2:2:1000", "--until", "3141.6", "--measure",
             "final", "--quiet"]}


def write_shaking(build, folder):
    recording = os.path.join(folder, "shaking.csv")
    subprocess.run([pathlib.Path(build) / "bench" / "bench_w3", "--recording", recording], check=True)
    return recording


def write_decay(build, folder, samples):
    recording = os.path.join(folder, f"decay-{samples}.csv")
    subprocess.run([pathlib.Path(build) / "bench" / "bench_w4", "--samples", str(samples), recording], check=True)
    return recording


def figure(seconds):
    if seconds < 1e-6:
        return f"{seconds * 1e9:.2f} ns"
    if seconds >= 1:
        return f"{seconds:.2f} s"
    return f"{seconds * 1e6:.1f} us" if seconds < 1e-3 else f"{seconds * 1e3:.2f} ms"
