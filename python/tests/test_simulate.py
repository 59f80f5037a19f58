import pickle
import re

import cromer
import numpy as np
import pytest
from conftest import ROOT, swing
from cromer import _plot
from hypothesis import given, settings
from hypothesis import strategies as st


def test_one_method_and_several():
    run = cromer.simulate(stiffness=9, damping=0.2, position=1, method="exact", step=0.01, until=5)
    w = np.sqrt(9 - 0.01)
    x = np.exp(-0.1 * run.t) * (np.cos(w * run.t) + 0.1 / w * np.sin(w * run.t))
    assert np.allclose(run.x, x, atol=1e-12) and run.status == "reached_end"
    runs = cromer.simulate(stiffness=9, damping=0.2, method=["euler-cromer", "exact"], step=0.01, until=5)
    assert len(runs) == 2 and np.array_equal(runs["exact"].x, run.x)
    assert runs[0].energy[0] == pytest.approx(4.5)
    with pytest.raises(KeyError, match="euler-cromer"):
        runs["rk5"]


def test_one_run_of_several_is_written_alone():
    runs = cromer.simulate(stiffness=9, method=["euler-cromer", "exact"], step=0.1, until=1)
    rows = runs["exact"].to_csv().splitlines()
    assert len(rows) == 12 and float(rows[2].split(",")[2]) == runs["exact"].x[1]
    assert len(runs.to_csv().splitlines()) == 23 and "exact" in str(runs["exact"])


def test_points_without_a_steady_motion_warn():
    with pytest.warns(cromer.FitWarning, match="3 of 3 points"):
        cromer.sweep(stiffness=9, method="exact", drive_amplitude=1, drive_frequency=[2, 3, 4])


@settings(max_examples=40, deadline=None)
@given(st.floats(0.1, 50), st.floats(0, 5), st.floats(-2, 2), st.floats(-2, 2))
def test_euler_cromer_is_its_two_lines(stiffness, damping, x, v):
    run = cromer.simulate(stiffness=stiffness, damping=damping, position=x, velocity=v, method="euler-cromer",
                          step=0.01, until=0.5)
    for i in range(50):
        v += 0.01 * (-stiffness * x - damping * v)
        x += 0.01 * v
        assert run.x[i + 1] == pytest.approx(x, rel=1e-9, abs=1e-12)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.5, 20), st.floats(0, 2), st.floats(0, 4), st.floats(0, 1))
def test_laws_of_scipy(stiffness, damping, cubic, drag):
    integrate = pytest.importorskip("scipy.integrate")
    run = cromer.simulate(stiffness=stiffness, damping=damping, cubic=cubic, drag=drag, position=1,
                          method="dormand-prince", tolerance=1e-11, step=0.1, until=3)
    truth = integrate.solve_ivp(
        lambda t, y: [y[1], -stiffness * y[0] - cubic * y[0]**3 - damping * y[1] - drag * y[1] * abs(y[1])],
        (0, 3), [1, 0], rtol=1e-11, atol=1e-12, dense_output=True)
    assert np.allclose(run.x, truth.sol(run.t)[0], atol=2e-8)


def test_a_recorded_force():
    signal = pytest.importorskip("scipy.signal")
    t = np.arange(0, 20, 0.01)
    force = np.sin(2.2 * t) * np.exp(-0.1 * t)
    run = cromer.simulate(stiffness=9, damping=0.3, position=0, force=force, spacing=0.01, method="exact", step=0.01,
                          until=float(t[-1]))
    _, x, _ = signal.lsim(signal.lti([1], [1, 0.3, 9]), force, t)
    assert np.allclose(run.x, x, atol=1e-9)


def test_methods_say_what_they_simulate():
    table = cromer.methods(natural_frequency=3, damping_ratio=0.01, step=0.01)
    assert table["forward-euler"]["effective"]["decay_rate"] == pytest.approx(-0.015, rel=1e-3)
    assert "euler-cromer" in table.names and len(table) == len(table.names)
    assert table["implicit-euler"]["stable"]


def test_a_run_is_recognised(tmp_path):
    run = cromer.simulate(mass=0.2, stiffness=16, damping=0.02, method="heun", step=0.01, every=3, until=6)
    path = tmp_path / "run.csv"
    path.write_text(run.to_csv())
    found = cromer.methods(recognise=path, mass=0.2, stiffness=16, damping=0.02)
    assert found.verdict == "made" and found[0]["method"] == "heun" and found[0]["same_map"] == []
    assert found[0]["step"] == pytest.approx(0.01, rel=1e-12) and "heun" in str(found) and len(found) > 1
    assert found.to_pandas()["distance"].is_monotonic_increasing
    with pytest.warns(cromer.FitWarning, match="check the law"):
        assert cromer.methods(recognise=path, mass=0.2, stiffness=17).verdict == "other_law"
    with pytest.raises(cromer.NoSuccess):
        cromer.methods(recognise=path, mass=0.2, stiffness=17, strict=True)


def test_modes_of_a_network_are_those_of_its_matrices(tmp_path):
    path = tmp_path / "chain.toml"
    path.write_text("".join(f'[[mass]]\nname = "m{i}"\nmass = {i + 1}\n' for i in range(3)) +
                    "".join(f'[[link]]\nfrom = "{a}"\nto = "{b}"\nstiffness = 9\n'
                            for a, b in [("ground", "m0"), ("m0", "m1"), ("m1", "m2")]))
    modes = cromer.modes(path, method=["euler-cromer", "newmark"], step=0.1)
    mass, stiffness = np.array([1, 2, 3]), 9 * np.array([[2, -1, 0], [-1, 2, -1], [0, -1, 1]])
    squares, shapes = np.linalg.eigh(stiffness / np.sqrt(np.outer(mass, mass)))
    assert np.allclose(modes.frequency, np.sqrt(squares) / (2 * np.pi)) and np.allclose(modes.damping_ratio, 0)
    assert modes.names == ["m0", "m1", "m2"] and len(modes) == 3
    for j, mode in enumerate(modes):
        shape = shapes[:, j] / np.sqrt(mass)
        assert np.allclose(mode.shape, shape / shape[np.argmax(np.abs(shape))])
        swings = 2 / 0.1 * np.arctan(np.sqrt(squares[j]) * 0.1 / 2)  # average acceleration
        assert mode.methods[1]["frequency"] == pytest.approx(swings / (2 * np.pi), rel=1e-9)
    assert sum(mode.participation for mode in modes) == pytest.approx(1)
    assert "participation" in str(modes) and "mode" in modes.to_csv()
    with pytest.raises(cromer.InputError, match="no mass"):
        path.write_text(path.read_text().replace('to = "m2"', 'to = "m9"'))
        cromer.modes(path)


def test_a_sweep_is_the_closed_form():
    w = np.linspace(1, 5, 50)
    found = cromer.sweep(stiffness=9, damping=0.2, method="exact", drive_amplitude=1, drive_frequency=w)
    assert np.array_equal(found.drive_frequency, w)
    assert np.allclose(found.amplitude, 1 / np.hypot(9 - w**2, 0.2 * w), rtol=1e-12)
    assert found.units["amplitude"] == "m" and set(found.statuses) == {"settled"}
    given = {"stiffness": 9, "damping": 0.2, "method": "exact", "drive_amplitude": 1}
    assert list(cromer.sweep(**given, drive_frequency=w, measure=["peak", "rms"]).columns)[1:] == ["peak", "rms"]
    cycles = cromer.sweep(**given, drive_frequency=["0.2 Hz", "0.5 Hz"])
    assert np.allclose(cycles.drive_frequency, 2 * np.pi * np.array([0.2, 0.5]))
    fitted = cromer.fit(*swing(), law="viscous")["frequency"]
    assert cromer.sweep(**given, drive_frequency=[fitted]).drive_frequency == pytest.approx(2 * np.pi * fitted.value)


def test_a_sweep_that_was_ended_says_so():
    with pytest.warns(cromer.FitWarning, match="interrupted"):
        found = cromer.sweep(stiffness=9, cubic=1, damping=0.2, method="rk4", drive_amplitude=1,
                             drive_frequency=np.linspace(1, 5, 500), progress=lambda done: False)
    assert found.status == "interrupted" and "not_reached" in found.statuses


def test_a_spectrum_beside_scipy():
    integrate = pytest.importorskip("scipy.signal")
    dt = 0.005
    t = np.arange(0, 12, dt)
    a = np.sin(9 * t) * np.exp(-((t - 4) / 2) ** 2)
    periods = np.array([0.2, 0.7, 2.0])
    found = cromer.spectrum(a, dt, periods=periods, damping_ratio=0.05)
    for period, sd in zip(periods, found.sd):
        w = 2 * np.pi / period
        _, x, _ = integrate.lsim(integrate.lti([-1], [1, 0.1 * w, w * w]), a, t)
        assert sd == pytest.approx(np.abs(x).max(), rel=2e-3) and sd >= np.abs(x).max() * (1 - 1e-9)
    assert np.allclose(found.psa, found.sd * (2 * np.pi / periods) ** 2)
    several = cromer.spectrum(a, dt, periods=periods, damping_ratio=[0.02, 0.05])
    assert several.sd.shape == (2, 3) and np.array_equal(several.sd[1], found.sd)


def test_the_ground_of_a_spectrum_is_its_own_integral():
    dt, fine = 0.02, 500
    a = np.random.default_rng(7).normal(size=120)
    a[-1] = 0
    found = cromer.spectrum(a, dt, periods=[0.3])
    t = np.arange(a.size) * dt
    dense = np.interp(np.arange((a.size - 1) * fine + 1) * (dt / fine), t, a)
    v = np.concatenate([[0], np.cumsum((dense[1:] + dense[:-1]) / 2) * (dt / fine)])
    x = np.concatenate([[0], np.cumsum((v[1:] + v[:-1]) / 2) * (dt / fine)])
    assert np.allclose(found.ground_velocity, v[::fine], atol=1e-12)
    assert np.allclose(found.ground_displacement, x[::fine], atol=1e-8)
    ground = found.components[0]
    assert ground["peak_velocity"] == pytest.approx(np.abs(v).max(), rel=1e-6)
    assert ground["peak_displacement"] == pytest.approx(np.abs(x).max(), rel=1e-6)
    assert ground["cumulative_absolute_velocity"] == pytest.approx(np.abs(dense).sum() * dt / fine, rel=1e-5)
    above = np.flatnonzero(np.abs(dense) >= 0.05 * 9.80665) * (dt / fine)
    assert ground["duration_bracketed"] == pytest.approx(above[-1] - above[0], abs=2 * dt / fine)
    energy = np.cumsum(dense ** 2) / np.sum(dense ** 2)
    share = [np.searchsorted(energy, each) * (dt / fine) for each in (0.05, 0.75, 0.95)]
    assert ground["duration_5_75"] == pytest.approx(share[1] - share[0], abs=2 * dt / fine)
    assert ground["duration_5_95"] == pytest.approx(share[2] - share[0], abs=2 * dt / fine)


def butterworth_response(order, low, high, frequency, dt):
    """The complex response of the definition: analogue poles of the prototype, s -> (s² + W0²)/(B s), bilinear."""
    warp = lambda f: np.tan(np.pi * f * dt)
    s = 1j * warp(frequency[1:])
    p = (s ** 2 + warp(low) * warp(high)) / ((warp(high) - warp(low)) * s)
    response = np.ones(frequency.size, complex)
    for k in range(order):
        response[1:] /= p - np.exp(1j * np.pi * (2 * k + order + 1) / (2 * order))
    response[0] = 0
    return response


@pytest.mark.parametrize("order, causal", [(2, False), (4, False), (4, True), (3, True)])
def test_a_corrected_ground_is_the_filter_of_its_definition(order, causal):
    dt, n, low, high = 0.01, 3000, 0.2, 20
    t = np.arange(n) * dt
    a = np.random.default_rng(3).normal(size=n) * np.exp(-((t - 12) / 5) ** 2) + 0.05 + 0.01 * t
    found = cromer.spectrum(a, dt, periods=[0.3], baseline="linear", band_pass=f"{low}:{high} Hz", band_pass_order=order,
                            causal=causal)
    left = a - np.polyval(np.polyfit(t, a, 1), t)
    size = 1 << 16  # so long that what rings has died down when the record comes round again
    frequency = np.fft.rfftfreq(size, dt)
    response = butterworth_response(order, low, high, frequency, dt)
    truth = np.fft.irfft(np.fft.rfft(left, size) * (response if causal else np.abs(response) ** 2), size)
    ground = found.components[0]
    before = round(-ground["begins"] / dt)
    assert (before == 0) == causal and ground["samples"] == n + (1 if causal else 2) * (ground["samples"] - n - before)
    truth = np.roll(truth, before)[:ground["samples"]]
    assert ground["peak_acceleration"] == pytest.approx(np.abs(truth).max(), rel=1e-6)
    v = np.concatenate([[0], np.cumsum((truth[1:] + truth[:-1]) / 2 * dt)])
    assert np.abs(found.ground_velocity - v).max() < 1e-5 * np.abs(v).max()
    assert abs(v[-1]) < 1e-4 * np.abs(v).max()
    assert found.to_dict()["correction"] == {"baseline": "linear", "band_pass": {"low": low, "high": high, "order": order,
                                                                               "causal": causal}}


def test_a_correction_beside_scipy():
    signal = pytest.importorskip("scipy.signal")
    dt = 0.005
    a = np.random.default_rng(4).normal(size=4000)
    found = cromer.spectrum(a, dt, periods=[0.3], band_pass="0.5:30 Hz", causal=True)
    sections = signal.butter(4, [0.5, 30], "bandpass", fs=1 / dt, output="sos")
    ours = np.diff(found.ground_velocity) / dt
    theirs = signal.sosfilt(sections, np.concatenate([a, np.zeros(found.ground_velocity.size - a.size)]))
    assert np.abs(ours - (theirs[1:] + theirs[:-1]) / 2).max() < 1e-9


def test_a_shock_spectrum_beside_scipy():
    signal = pytest.importorskip("scipy.signal")
    dt, length = 1e-4, 0.02
    t = np.arange(0, 0.4, dt)
    shock = np.where(t <= length, np.sin(np.pi * t / length), 0)
    during = round(length / dt) + 1
    periods, zeta = np.array([0.01, 0.03, 0.08]), 0.05
    found = cromer.spectrum(shock[:during], dt, periods=periods, damping_ratio=zeta, shock=True)
    for i, period in enumerate(periods):
        w = 2 * np.pi / period
        _, a, _ = signal.lsim(signal.lti([2 * zeta * w, w * w], [1, 2 * zeta * w, w * w]), shock, t)
        for name, truth in (("primary", np.abs(a[:during]).max()), ("residual", np.abs(a[during:]).max()),
                            ("maximax", np.abs(a).max()), ("positive", a.max()), ("negative", -a.min())):
            assert getattr(found, name)[i] == pytest.approx(truth, rel=2e-3), (name, period)
    assert not found.psa.size and list(found.to_pandas().columns)[0] == "maximax" and found.period.size == 3
    assert "3 periods, ζ = 0.05" in repr(found)
    in_g = cromer.spectrum(shock[:during], dt, periods=periods, damping_ratio=zeta, shock=True, in_g=True)
    assert np.allclose(in_g.maximax, found.maximax, rtol=1e-14) and "maximax (g)" in in_g.to_csv()
    several = cromer.spectrum(shock[:during], dt, periods=periods, damping_ratio=[0.02, zeta], shock=True)
    assert several.maximax.shape == (2, 3) and np.array_equal(several.maximax[1], found.maximax)


def test_hysteretic_damping_has_no_damping_ratio():
    found = cromer.spectrum(np.sin(9 * np.arange(0, 5, 0.01)), 0.01, periods=[0.5, 1.0], loss_factor=[0.04, 0.1])
    assert np.array_equal(found.loss_factor, [0.04, 0.1]) and np.isnan(found.damping_ratio).all()
    assert found.psa.shape == (2, 2) and "η = 0.04, η = 0.1" in repr(found)


def test_a_comparison_says_what_the_method_adds():
    t, x = swing(noise=1e-5)
    found = cromer.compare(t, x)
    assert found.status == "converged" and found.explanation
    assert found.curves[0].t.size and found.curves[0].rms > 0


def test_a_comparison_has_the_whole_fit():
    t, x = swing(noise=1e-4)
    x[300] = 2  # to be set aside
    found = cromer.compare(t, x, method="rk4", step=0.01)
    assert found.fit.to_dict() == found.to_dict()["fit"] and found.fit is found.fit
    assert np.array_equal(found.fit.measured, x) and np.array_equal(found.fit.at([2.0]).x, cromer.fit(t, x).at([2.0]).x)
    again = pickle.loads(pickle.dumps(found))
    assert again.fit["decay_rate"] == found.fit["decay_rate"] and "decay rate" in str(again.fit)


def test_a_curve_against_time():
    t, x = swing(noise=1e-6)
    x[300] = 2
    found = cromer.compare(t, x, method="euler-cromer", step=0.01)
    curve = found["euler-cromer"]
    used = np.arange(t.size) != 300
    assert np.sqrt(np.mean(curve.residual[used] ** 2)) == pytest.approx(curve.rms, rel=1e-9)
    known = np.isfinite(curve.phase_error)
    assert known.mean() > 0.95
    late = t[known] > 15
    drift = np.polyfit(t[known][late], curve.phase_error[known][late], 1)
    assert abs(curve.method_phase) > 0.03
    assert np.polyval(drift, t[-1]) == pytest.approx(curve.method_phase, rel=0.05)
    assert list(curve.to_pandas().columns) == ["x", "v", "residual", "phase_error"]


def test_a_comparison_of_several_methods():
    t, x = swing(noise=1e-5)
    found = cromer.compare(t, x, method=["forward-euler", "rk4"], step=0.01)
    assert [each.method for each in found.curves] == ["exact", "exact", "forward-euler", "rk4"]
    assert found["exact"] is found.curves[1] and found["rk4"] is found.curves[3]
    assert found["rk4"].rms == cromer.compare(t, x, method="rk4", step=0.01).curves[-1].rms < found["forward-euler"].rms
    assert found["exact"].rms == pytest.approx(found.fit.residual.rms, rel=1e-6) and found["exact"].residual.size == t.size
    assert found.to_pandas().loc[found["rk4"].label].rms == found["rk4"].rms and "rk4" in found._repr_html_()
    assert "forward-euler" in found.explanation
    told = []
    cromer.compare(t, x, law="viscous", method=["euler-cromer", "rk4"], progress=told.append)
    assert told and told == sorted(told)
    with pytest.raises(KeyError, match="did you mean 'rk4'"):
        found["rk5"]


@pytest.mark.parametrize("wrong, argument", [({"step": -1}, "step"), ({"method": "rk5"}, "method"),
                                             ({"spacing": 0.1}, "spacing"), ({"stifness": 3}, "stifness"), ({"dt": 1}, "dt")])
def test_wrong_input_is_said(wrong, argument):
    with pytest.raises(cromer.InputError) as refused:
        cromer.simulate(**{"step": 0.01, "until": 1, **wrong})
    assert refused.value.argument == argument


@pytest.mark.parametrize("wrong, argument", [({"spacing": 0.01}, "spacing"), ({"second": np.ones(9)}, "second")])
def test_what_goes_with_arrays_is_refused_of_a_file(wrong, argument):
    ground = str(ROOT / "data" / "ground" / "shaking.csv")
    for source in (ground, cromer.read(ground)):
        with pytest.raises(cromer.InputError) as refused:
            cromer.spectrum(source, column="east", **wrong)
        assert refused.value.argument == argument


def test_a_table_of_pandas_has_too_many_dimensions():
    pandas = pytest.importorskip("pandas")
    with pytest.raises(cromer.InputError) as refused:
        cromer.spectrum(pandas.DataFrame({"east": np.ones(100)}), 0.01)
    assert (refused.value.argument, refused.value.code) == ("acceleration", "not_one_dimension")


@pytest.mark.parametrize("verb", [lambda **given: list(cromer.simulate(**given)),
                                  lambda **given: cromer.compare(*swing(), law="viscous", **given).curves[2:]])
def test_methods_are_a_list_of_any_kind(verb):
    names = ["euler-cromer", "rk4"]
    for several in (np.array(names), tuple(names)):
        assert [each.method for each in verb(method=several)] == names
    with pytest.raises(cromer.InputError) as refused:
        verb(method=[])
    assert refused.value.argument == "method"


@pytest.mark.parametrize("given", ["data/recording1.csv", {"stiffness": 9}])
def test_only_a_fit_is_a_law(given):
    with pytest.raises(cromer.InputError, match="fit") as refused:
        cromer.simulate(given)
    assert refused.value.argument == "law"


@pytest.mark.parametrize("given, replaced", [
    ({"natural_frequency": 3}, {"stiffness": 9}), ({"damping_ratio": 0.02}, {"damping": 0.04 * 8.9}),
    ({"quality_factor": 25}, {"damping": 0.04 * 8.9}), ({"accuracy": 0.01}, None)])
def test_what_is_given_replaces_what_the_fitted_law_has(given, replaced):
    fit = cromer.fit(*swing(noise=1e-9), law="viscous")
    run = cromer.simulate(fit, until=5, **given)
    if replaced is None:
        assert run.step > cromer.simulate(fit, until=5).step
    else:
        assert np.allclose(run.x, cromer.simulate(fit, until=5, **replaced).x, atol=1e-7)


def test_a_symbol_is_told_its_name():
    with pytest.raises(cromer.InputError, match="did you mean step"):
        cromer.simulate(stiffness=9, until=1, h=0.01)
    with pytest.raises(cromer.InputError, match="did you mean spacing"):
        cromer.spectrum(np.ones(100), dt=0.01)


def test_the_lines_are_those_of_the_programs_figures():
    palette = (ROOT / "src" / "cromer" / "report" / "palette.cpp").read_text()
    dashes = {"solid": "-"}
    for name, numbers in re.findall(r"(\w+){([\d, ]+)}", palette[:palette.index("roles")]):
        dashes[name] = (0, tuple(int(each) for each in numbers.split(",") if int(each)))
    roles = {name: (colour, dashes[dash]) for name, colour, dash in
             re.findall(r'\{"([\w:-]+)", "(#\w+)",.*, (\w+)\}', palette) if dash in dashes}
    assert set(_plot.LINES) <= set(roles)
    for method in cromer.methods().names:
        assert _plot.LINES[method][:2] == roles[method], method
    assert (_plot.INK, _plot.LAW) == (roles["measured"][0], roles["fitted"][0])


def test_many_swings_are_an_envelope_and_a_few_of_them():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    t, x = swing(seconds=60)
    fit = cromer.fit(t, x, law="viscous")
    whole, few, left = fit.plot()
    low, high = sorted((line.get_ydata() for line in whole.lines), key=np.mean)
    at = whole.lines[0].get_xdata()[5:-5]
    for line, sign in ((low, -1), (high, 1)):
        assert np.allclose(line[5:-5], sign * 0.05 * np.exp(-0.03 * at), rtol=0.04)
    seen = few.lines[-1].get_xdata()
    assert seen[-1] == pytest.approx(5 / fit["frequency"].value, abs=0.02) and left.lines[0].get_xdata().size == t.size
    _, ax = plt.subplots()  # one that may be zoomed into has each sample
    assert fit.plot(ax).lines[-1].get_xdata().size == t.size
    plt.close("all")


def test_a_gap_is_left_empty():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    t, x = swing(seconds=60)
    seen = (t < 10) | (t > 20)
    whole = cromer.fit(t[seen], x[seen], law="viscous").plot()[0]
    band, = whole.collections
    assert len(band.get_paths()) == 2
    for path in band.get_paths():
        assert not np.any((path.vertices[:, 0] > 10.1) & (path.vertices[:, 0] < 19.9))
    plt.close("all")


@pytest.mark.parametrize("observed, each", [("position", "x"), ("velocity", "v")])
def test_a_law_is_drawn_between_samples_too(observed, each):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    t, x = swing(step=0.27, seconds=12)
    fit = cromer.fit(t, x, observed=observed, law="viscous")
    line = fit.plot()[0].lines[0]
    assert line.get_xdata().size > 20 * fit["frequency"].value * 12 and line.get_xdata()[-1] == fit.t[-1]
    assert np.allclose(line.get_ydata(), getattr(fit.at(line.get_xdata()), each) + fit["equilibrium"].value)
    plt.close("all")


def test_pictures(tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    t, x = swing()
    cromer.fit(t, x).plot()
    unknown = tmp_path / "unknown.csv"
    unknown.write_text("Time (s),Tension\n" + "".join(f"{a},{b}\n" for a, b in zip(t, x)))
    assert cromer.fit(unknown, column="Tension").plot()[0].get_ylabel() == "Tension"
    runs = cromer.simulate(stiffness=9, method=["euler-cromer", "exact"], step=0.05, until=5)
    for of in ("position", "velocity", "energy", "phase"):
        axes = runs.plot(of)
        assert [each.get_text() for each in axes.get_legend().get_texts()] == ["exact", "euler-cromer"]
    _, ax = plt.subplots()
    for each in runs:
        each.plot("position", ax=ax)
    legend = ax.get_legend()
    assert len({each.get_color() for each in legend.get_texts()}) == 2
    ax.figure.canvas.draw()
    assert legend.get_window_extent().y0 >= ax.get_window_extent().y1 - 1  # not across the data
    with pytest.raises(cromer.InputError, match="phase") as refused:
        runs.plot("poition")
    assert refused.value.argument == "of"
    widths = [each.get_linewidth() for each in cromer.simulate(stiffness=9, method=["euler-cromer", "rk4"], step=0.01,
                                                               until=5).plot().lines]
    assert widths[0] >= widths[1] + 1  # curves that coincide are both seen
    compared = cromer.compare(t, x, method=["euler-cromer", "rk4"], step=0.01)
    for of in ("position", "residual", "phase_error"):
        assert len(compared.plot(of).get_legend().get_texts()) == len(compared.curves) + (of == "position")
    with pytest.raises(cromer.InputError, match="residual"):
        compared.plot("energy")
    swept = cromer.sweep(stiffness=9, damping=1, drive_amplitude=1, method="exact", drive_frequency=np.linspace(1, 5))
    swept.plot()
    moved = cromer.sweep(stiffness=9, damping=1, drive="base", base_displacement=1, method="exact", drive_frequency=[2, 4],
                         measure="transmissibility")
    assert list(moved.plot().lines[0].get_ydata()) == list(moved.transmissibility)
    lines = cromer.sweep(stiffness=[9, 10], damping=[0.1, 0.2, 0.3], drive_amplitude=1, method="exact",
                         drive_frequency=2).plot().lines
    assert [list(line.get_xdata()) for line in lines] == [[0.1, 0.2, 0.3]] * 2
    line, = cromer.sweep(stiffness=9, damping=0.1, drive_amplitude=1, method="exact", drive_frequency=[3, 1, 2]).plot().lines
    assert list(line.get_xdata()) == [1, 2, 3]
    both = cromer.sweep(stiffness=1, cubic=1, damping=0.1, drive_amplitude=0.5, method="rk4", direction="both",
                        drive_frequency=np.linspace(0.8, 2, 7))
    axes = both.plot()
    assert axes.get_xlabel().startswith("drive frequency")
    assert [list(line.get_ydata()) for line in axes.lines] == [list(both.amplitude[:7]), list(both.amplitude[7:])]
    assert [each.get_text() for each in axes.get_legend().get_texts()] == ["up", "down"]
    with pytest.raises(KeyError, match="did you mean 'amplitude'"):
        swept.plot("amplitud")
    cromer.spectrum(np.sin(t), 0.01, periods=np.geomspace(0.1, 5, 20), damping_ratio=[0.02, 0.05]).plot("psv")
    shock = cromer.spectrum(np.sin(t[:100] * np.pi), 0.01, periods=[0.5, 1.0], shock=True)
    assert np.array_equal(shock.plot().lines[0].get_ydata(), shock.maximax)
    with pytest.raises(cromer.InputError, match="maximax, primary"):
        shock.plot("psa")
    plt.close("all")


def test_files_of_the_program_are_read_unaided(program, tmp_path):
    """NumPy and pandas take the first line for the names of the columns."""
    law = ["--stiffness", "9", "--damping", "0.2", "--quiet"]
    for words in (["simulate", *law, "--until", "1", "--step", "0.1"],
                  ["sweep", *law, "--drive-amplitude", "1", "--drive-frequency", "2:4:11", "--method", "exact"],
                  ["spectrum", str(ROOT / "data/ground/shaking.csv"), "--column", "east", "--quiet"]):
        path = tmp_path / f"{words[0]}.csv"
        program(*words, "-o", str(path))
        table = np.genfromtxt(path, delimiter=",", names=True, deletechars="")
        assert table.size > 9 and all(np.isfinite(table[name]).all() for name in table.dtype.names)
        pandas = pytest.importorskip("pandas")
        frame = pandas.read_csv(path)
        assert list(frame.columns) == path.read_text(encoding="utf-8").split("\n")[0].split(",")
        assert np.allclose(frame.to_numpy(), table.view(float).reshape(table.size, -1), rtol=1e-12, atol=0)
        program(*words, "-o", str(path), "--provenance")
        assert path.read_text(encoding="utf-8").startswith(f"# cromer {words[0]} ")
