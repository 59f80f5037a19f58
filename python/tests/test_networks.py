"""Networks of masses, and channels recorded together."""

import numpy as np
import pytest

import cromer
from conftest import ROOT

TOGETHER, AGAINST = 2.0, np.sqrt(7)  # [rad/s] of two carts of 2 kg, springs of 8 N/m at the walls and 3 N/m between


def carts(joint=3.0, damping=0):
    return {"mass": [{"name": "left", "mass": "2 kg", "position": np.float64(0.1)}, {"name": "right", "mass": 2}],
            "link": [{"to": "left", "stiffness": 8, "damping": damping}, {"to": "right", "stiffness": "8 N/m", "damping": damping},
                     {"from": "left", "to": "right", "stiffness": joint}]}


def run(**options):
    return cromer.simulate(network=carts(), **{"method": "exact", "step": 0.05, "until": 30, **options})


def test_a_run_is_the_sum_of_its_modes(tmp_path):
    found = run()
    together, against = 0.05 * np.cos(TOGETHER * found.t), 0.05 * np.cos(AGAINST * found.t)
    assert found.names == ["left", "right"] and found.x.shape == found.v.shape == (2, found.t.size)
    assert np.allclose(found.x, [together + against, together - against], atol=1e-13)
    assert np.allclose(found.energy, 0.055, atol=1e-14) and found.status == "reached_end" and found.step == 0.05
    assert np.array_equal(found["right"].v, found.v[1]) and not found.x.flags.writeable
    assert found.to_csv().startswith("t (s),left x (m)") and "exact" in repr(found)
    path = tmp_path / "carts.toml"
    path.write_text('[[mass]]\nname="left"\nmass=2\nposition=0.1\n[[mass]]\nname="right"\nmass=2\n'
                    '[[link]]\nto="left"\nstiffness=8\n[[link]]\nto="right"\nstiffness=8\n'
                    '[[link]]\nfrom="left"\nto="right"\nstiffness=3\n')
    assert np.array_equal(cromer.simulate(network=path, method="exact", step=0.05, until=30).x, found.x)
    assert np.array_equal(cromer.modes(path).frequency, cromer.modes(carts()).frequency)


def test_several_methods_are_several_runs():
    runs = run(method=["exact", "rk4"], until=5)
    assert runs.keys() == ["exact", "rk4"] and len(runs) == 2 and [each.method for each in runs] == runs.keys()
    for each in runs:
        alone = run(method=each.method, until=5)
        assert np.array_equal(each.x, alone.x) and np.array_equal(each["right"].v, alone["right"].v)
        assert np.array_equal(each.energy, alone.energy) and each.to_dict() == alone.to_dict()
    assert runs["rk4"] is runs[1] and np.abs(runs["rk4"].x - runs["exact"].x).max() < 1e-5
    assert runs.to_csv().splitlines()[0].startswith("run,t (s),left x (m)") and "rk4" in repr(runs)
    assert len(run(method=["exact"], until=5)) == 1
    with pytest.raises(KeyError, match="did you mean 'rk4'"):
        runs["rk5"]


def test_several_methods_warn_and_fail_by_name():
    with pytest.warns(cromer.FitWarning, match="forward-euler: not_finite"):
        runs = cromer.simulate(network=carts(), method=["exact", "forward-euler"], step=0.5, until=3000)
    assert runs["exact"].status == "reached_end"


def test_the_method_is_the_programs(program, tmp_path):
    path = tmp_path / "run.csv"
    program("simulate", "--network", str(ROOT / "data/networks/pendulums.toml"), "--method", "newmark", "--step", "0.02", "--until", "5",
            "-o", str(path))
    table = np.genfromtxt(path, delimiter=",", skip_header=1)
    found = cromer.simulate(network=str(ROOT / "data/networks/pendulums.toml"), method="newmark", step=0.02, until=5)
    assert np.array_equal(table[:, [1, 3]].T, found.x) and np.array_equal(table[:, [2, 4]].T, found.v)


def test_states_go_into_a_table():
    pytest.importorskip("pandas")
    found = run(until=1)
    table = found.to_pandas()
    assert list(table) == ["left x", "left v", "right x", "right v", "energy"] and np.array_equal(table["right v"], found.v[1])
    open_joint = carts(joint="?")
    record = run().to_pandas()
    assert cromer.fit(record.index, record[["left x", "right x"]], network=open_joint).succeeded


@pytest.mark.parametrize("given", ["list", "rows", "columns", "mapping"])
def test_links_are_found_in_channels(given):
    record = run()
    channels = {"list": list(record.x), "rows": record.x, "columns": record.x.T, "mapping": {"a": record.x[0], "b": record.x[1]}}[given]
    fit = cromer.fit(record.t, channels, network=carts(joint="?"))
    assert fit.succeeded and fit.status == "converged"
    assert fit["left", "right"].parameters["stiffness"].value == pytest.approx(3, rel=1e-8)
    assert fit.links[2].start == "left" and fit.masses["left"]["position"].value == pytest.approx(0.1, rel=1e-8)
    assert fit.measured.shape == fit.residuals.shape == (2, record.t.size)
    assert "stiffness" in str(fit) and "stiffness" in repr(fit) and fit.to_svg().strip().endswith("</svg>")


def test_links_are_found_in_a_file(tmp_path):
    path = tmp_path / "carts.csv"
    path.write_text(run().to_csv())
    for source in (path, cromer.read(path)):
        fit = cromer.fit(source, network=carts(joint="?"), to=20)
        assert fit["right", "left"].parameters["stiffness"].value == pytest.approx(3, rel=1e-8) and fit.t[-1] <= 20


def test_modes_are_found_in_channels():
    record = cromer.simulate(network=carts(damping=0.05), method="exact", step=0.1, until=60)
    found = cromer.modes(record.t, record.x)
    assert np.allclose(found.frequency, np.array([TOGETHER, AGAINST]) / (2 * np.pi), rtol=1e-6)
    assert found.names == ["channel 1 (m)", "channel 2 (m)"] and found.to_svg()
    named = cromer.modes(record.t, {"a": record.v[0], "b": record.v[1]}, observed="velocity")
    assert named.names == ["a (m/s)", "b (m/s)"] and len(named) == 2


def test_modes_of_a_recording_are_set_beside_a_network(tmp_path):
    record = cromer.simulate(network=carts(damping=0.05), method="exact", step=0.1, until=60)
    path = tmp_path / "carts.csv"
    path.write_text(record.to_csv())
    for found in (cromer.modes(record.t, record.x, network=carts()), cromer.modes(path, network=carts())):
        assert [each.of_network["mode"] for each in found] == [1, 2]
        assert all(each.of_network["mac"] > 0.999 for each in found)
        assert found[1].of_network["frequency"] == pytest.approx(AGAINST / (2 * np.pi))
    assert cromer.modes(record.t, record.x)[0].of_network is None
    with pytest.raises(ValueError, match="beside a recording"):
        cromer.modes(carts(), network=carts())


def test_a_network_that_cannot_be_used_is_refused():
    wrong = carts()
    wrong["link"][2]["to"] = "rihgt"
    with pytest.raises(cromer.InputError, match=r"network.link\[2\]: there is no mass") as caught:
        cromer.simulate(network=wrong)
    assert caught.value.argument == "network"
    with pytest.raises(cromer.InputError, match="path of a file"):
        cromer.simulate(network=7)
    with pytest.raises(cromer.InputError, match="stiffness does not go with network"):
        cromer.simulate(network=carts(), stiffness=3)
    with pytest.raises(cromer.InputError, match="needs a value"):
        cromer.simulate(network=carts(joint="?"))
    t = np.arange(9.0)
    with pytest.raises(cromer.InputError, match="each mass needs its column"):
        cromer.fit(t, [t], network=carts(joint="?"))
    with pytest.raises(cromer.InputError, match="that is the time"):
        cromer.modes(t, {"t": t})
    with pytest.raises(cromer.InputError, match="its own columns"):
        cromer.modes("a.csv", [t])
    with pytest.raises(cromer.InputError, match="y is missing"):
        cromer.modes(t)
    with pytest.warns(cromer.FitWarning):
        assert not cromer.fit(t, [t, t], network=carts(joint="?")).succeeded
