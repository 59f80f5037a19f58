"""Every cell of the notebooks runs."""

import json
import warnings

import cromer
import numpy as np
import pytest
from conftest import ROOT

pytest.importorskip("matplotlib").use("Agg")
NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))


def run(path, monkeypatch):
    import matplotlib.pyplot as plt
    monkeypatch.chdir(ROOT)
    room = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cromer.CromerWarning)
        for cell in json.loads(path.read_text())["cells"]:
            if cell["cell_type"] == "code":
                assert cell["outputs"] == [] and cell["execution_count"] is None, "clear the outputs before committing"
                exec("".join(cell["source"]), room)
    plt.close("all")
    return room


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_each_cell_runs(path, monkeypatch):
    assert run(path, monkeypatch)


def test_the_students_lab_finds_the_law_that_made_the_record(monkeypatch):
    fit = run(ROOT / "python" / "notebooks" / "students_lab.ipynb", monkeypatch)["fit"]
    low, high = fit["stiffness"].confidence_95
    assert low < 17.04 < high


def test_the_engineers_rig_is_found(monkeypatch):
    room = run(ROOT / "python" / "notebooks" / "shaker_engineer.ipynb", monkeypatch)
    for name, truth in (("angular_frequency", 20), ("decay_rate", 1)):
        low, high = room["fit"][name].confidence_95
        assert low < truth < high, name


def test_a_fit_finds_what_the_method_says_it_simulates(monkeypatch):
    room = run(ROOT / "python" / "notebooks" / "methods_that_lie.ipynb", monkeypatch)
    for name in ("euler-cromer", "implicit-euler"):
        found = cromer.fit(room["runs"][name].t, room["runs"][name].x, law="viscous")
        assert np.isclose(found["decay_rate"].value, room["table"][name]["effective"]["decay_rate"], rtol=1e-6)
