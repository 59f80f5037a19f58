"""The Python snippets of the documentation run: those of a page in their order, in one room."""

import inspect
import re
import shlex
import warnings

import cromer
import numpy as np
import pytest
from conftest import ROOT

pytest.importorskip("matplotlib").use("Agg")


def blocks(page):
    return re.findall(r"```(\w+)\n(.*?)```", page.read_text(), re.S)


def writes_hdf5(block):
    """The commands of a shell block whose files the page goes on to open."""
    lines = re.sub(r"\s+#.*", "", block.replace("\\\n", " ")).splitlines()
    return [shlex.split(line)[1:] for line in lines if line.startswith("cromer ") and ".h5" in line]


PAGES = [page for page in sorted((ROOT / "docs").rglob("*.md")) if any(kind == "python" for kind, _ in blocks(page))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_each_snippet_runs(page, monkeypatch, tmp_path, program):
    (tmp_path / "data").symlink_to(ROOT / "data")
    monkeypatch.chdir(tmp_path)
    room = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cromer.CromerWarning)
        for kind, block in blocks(page):
            if kind == "sh":
                for command in writes_hdf5(block):
                    program(*command)
            elif kind == "python":
                exec(block, room)
    if page.stem == "python":
        assert room["fit"].succeeded


def test_every_verb_has_its_section_of_arguments():
    for verb in ("read", "fit", "fit_all", "simulate", "compare", "methods", "modes", "spectrum", "sweep"):
        said = getattr(cromer, verb).__doc__
        assert "Parameters\n----------" in said and "{options}" not in said, verb
        section = said.split("----------\n")[1].split("\n\n")[0].splitlines()
        margins = {len(line) - len(line.lstrip()) for line in section}
        assert margins == {0, 4}, verb
        assert set(inspect.signature(getattr(cromer, verb)).parameters) == set(re.findall(r"\w+", " ".join(
            line.split(" : ")[0] for line in section if not line.startswith(" ")))), verb


def test_what_a_class_promises_it_has(tmp_path):
    t = np.arange(0, 10, 0.01)
    x = np.cos(3 * t) * np.exp(-0.05 * t)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cromer.CromerWarning)
        fit = cromer.fit(t, x, law="viscous")
        runs = cromer.simulate(stiffness=9, method=["rk4"], step=0.01, until=1)
        compared = cromer.compare(t, x, law="viscous", method=["rk4"])
        (tmp_path / "run.csv").write_text(cromer.simulate(stiffness=9, method="rk4", step=0.01, until=9).to_csv())
        modes = cromer.modes(ROOT / "data" / "networks" / "frame.toml")
        network = cromer.simulate(network=ROOT / "data" / "networks" / "pendulums.toml", step=0.02, until=60, method="rk4")
        networks = cromer.simulate(network=ROOT / "data" / "networks" / "pendulums.toml", step=0.02, until=1, method=["rk4", "verlet"])
        links = cromer.fit(network.t, network.x, network=ROOT / "data" / "networks" / "pendulums_open.toml")
        made = [network, networks, links, links.links[0], cromer.methods(recognise=tmp_path / "run.csv", stiffness=9),
                fit, fit["frequency"], fit.residual, fit.at(t), runs, runs[0], compared, compared.curves[0],
                cromer.methods(), modes, modes[0], cromer.spectrum(x, 0.01, periods=[1, 2], damping_ratio=0.05),
                cromer.sweep(stiffness=9, damping=0.2, drive_amplitude=1, drive_frequency=[1.0, 2.0], method="exact"),
                cromer.read(ROOT / "data" / "recording1.csv"), cromer.fit_all(ROOT / "data" / "recording1.csv"),
                cromer.InputError(""), cromer.CromerWarning(""), cromer.NoSuccess(""), cromer.Notice("", "", "", {})]
    classes = {getattr(cromer, name) for name in cromer.__all__ if isinstance(getattr(cromer, name), type)}
    assert classes - {cromer.FitWarning} == {type(each) for each in made}
    for each in made:
        for name in re.findall(r"`(\w+)`", type(each).__doc__):
            assert hasattr(each, name) or hasattr(cromer, name) or name == "uncertainties", (type(each), name)
        for name, member in inspect.getmembers(type(each), lambda member: isinstance(member, property)):
            if not name.startswith("_"):
                assert member.__doc__, (type(each), name)
                if "Numbers" in str(member.fget.__annotations__["return"]):
                    assert re.search(r"\[.+\]", member.__doc__), (type(each), name)
