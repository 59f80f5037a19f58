import html
import multiprocessing
import os
import pickle
import re
import signal
import threading
import warnings
from decimal import Decimal
from fractions import Fraction

import cromer
import numpy as np
import pytest
from conftest import ROOT, swing

RECORDING = str(ROOT / "data" / "recording1.csv")
RECORDING_2 = str(ROOT / "data" / "recording2.csv")


def test_the_law_of_arrays():
    t, x = swing()
    fit = cromer.fit(t, x, mass="217.6 ± 0.3 g")
    assert fit.succeeded and fit.law == "viscous"
    rate = fit["decay_rate"]
    assert rate.confidence_95[0] < 0.03 < rate.confidence_95[1]
    assert rate.unit == "1/s" and float(rate) == rate.value
    assert fit["stiffness"].value == pytest.approx(0.2176 * (8.9**2 + 0.03**2), rel=1e-3)
    assert fit.covariance.shape == (len(fit.fitted),) * 2
    i = fit.fitted.index("decay_rate")
    assert np.sqrt(fit.covariance[i, i]) == pytest.approx(rate.standard_error, rel=1e-12)
    assert np.array_equal(fit.t, t) and np.array_equal(fit.measured, x)
    assert np.allclose(fit.measured - fit.residuals, fit.x + fit["equilibrium"].value, atol=1e-15)
    with pytest.raises(KeyError, match="quality_factor"):
        fit["no_such_thing"]


def test_the_command_lays_a_file_under_the_run_and_no_arrays():
    assert " --over " not in cromer.fit(*swing())._document["simulate"]
    fit = cromer.fit(RECORDING)
    assert f" --over {RECORDING} --over-column 'Position (m)' " in fit._document["simulate"]
    assert "over" not in fit.simulation()


def test_intervals_hold_the_truth():
    held = 0
    for seed in range(60):
        t, x = swing(seed=100 + seed, seconds=8, noise=1e-3)
        low, high = cromer.fit(t, x, law="viscous")["decay_rate"].confidence_95
        held += low < 0.03 < high
    assert held >= 52  # of 60 at 95 %: fewer once in 3000 runs


def test_the_law_between_and_after_the_samples():
    t, x = swing(noise=1e-6)
    fit = cromer.fit(t, x, law="viscous")
    at = np.array([0.005, 3.333, 25.0])
    motion = fit.at(at)
    assert np.allclose(motion.x, 0.05 * np.exp(-0.03 * at) * np.cos(8.9 * at), atol=1e-6)
    with pytest.raises(cromer.InputError) as refused:
        fit.at([-1.0])
    assert refused.value.argument == "t" and refused.value.code == "times_before_the_first"


@pytest.mark.parametrize("given", ["217.6 ± 0.3 g", (0.2176, 0.0003), [0.2176, 0.0003], np.array([0.2176, 0.0003]),
                                   (Decimal("0.2176"), Fraction(3, 10000))])
def test_masses_as_people_have_them(given):
    t, x = swing()
    fit = cromer.fit(t, x, mass=given, law="viscous")
    assert fit["stiffness"].standard_error == pytest.approx(0.0003 * 8.9**2, rel=0.01)


def test_uncertainties_and_pint():
    ufloat = pytest.importorskip("uncertainties").ufloat
    t, x = swing()
    fit = cromer.fit(t, x, mass=ufloat(0.2176, 0.0003), law="viscous")
    assert fit["stiffness"].to_uncertainties().std_dev == fit["stiffness"].standard_error
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    with pytest.raises(cromer.InputError, match="mass"):
        cromer.fit(t, x, mass=5 * unit.newton)
    cycles = cromer.methods(natural_frequency=2 * unit.hertz, step=0.01)["rk4"]["effective"]["angular_frequency"]
    assert cycles == pytest.approx(4 * np.pi, rel=1e-4)
    for turns, each in ((60, unit.rpm), (1000, unit.millihertz), (2 * np.pi, unit.radian / unit.second)):
        driven = cromer.simulate(drive_amplitude=1, drive_frequency=turns * each, step=0.01, until=1)
        assert driven.to_dict()["parameters"]["drive_frequency"] == pytest.approx(2 * np.pi, rel=1e-12), each
    grams = cromer.fit(t, x, mass=217.6 * unit.gram, law="viscous")
    assert grams["stiffness"].value == pytest.approx(fit["stiffness"].value, rel=1e-12)


def test_arrays_with_units_are_taken_in_them():
    unit = pytest.importorskip("pint").UnitRegistry()
    t, x = swing()
    fit = cromer.fit(t, x, law="viscous")
    scaled = cromer.fit(1000 * t * unit.millisecond, 1000 * x * unit.millimetre, law="viscous")
    for name in ("angular_frequency", "position"):
        assert scaled[name].value == pytest.approx(fit[name].value, rel=1e-9)
    assert scaled.at([2000] * unit.millisecond).x == pytest.approx(fit.at([2]).x)
    angles = cromer.fit(t, np.degrees(x) * unit.degree, observed="angle", law="viscous")
    assert angles["position"].value == pytest.approx(fit["position"].value, rel=1e-9)
    with pytest.raises(cromer.InputError, match="radian") as refused:
        cromer.fit(t, x * unit.radian / unit.second)
    assert refused.value.argument == "y"
    plain = cromer.spectrum(9.80665 * x, 0.01, periods=[0.5])
    assert cromer.spectrum(x * unit.standard_gravity, 10 * unit.millisecond, periods=[500] * unit.millisecond).psa == \
        pytest.approx(plain.psa, rel=1e-12)
    swept = cromer.sweep(stiffness=9, damping=0.2, method="exact", drive_amplitude=1, mass=[900, 1000] * unit.gram,
                         drive_frequency=[0.2 * unit.hertz, 0.5 * unit.hertz])
    assert np.allclose(swept.mass, [0.9, 0.9, 1, 1]) and np.allclose(swept.drive_frequency, np.pi * np.array([0.4, 1, 0.4, 1]))


def test_series_of_pandas():
    pandas = pytest.importorskip("pandas")
    t, x = swing()
    fit = cromer.fit(pandas.Series(x, index=t))
    assert fit["decay_rate"] == cromer.fit(t, x)["decay_rate"]
    assert cromer.fit(pandas.Series(t), pandas.Series(x))["decay_rate"] == fit["decay_rate"]
    assert list(fit.to_pandas().columns) == ["measured", "x", "v", "residual"]


def test_times_of_the_calendar_are_seconds():
    pandas = pytest.importorskip("pandas")
    t, x = swing(step=0.02)
    truth = cromer.fit(t, x, law="viscous")["angular_frequency"].value
    stamps = pandas.date_range("2024-05-01", periods=t.size, freq="20ms")
    for index in (stamps, stamps.tz_localize("Europe/Berlin"), stamps - stamps[0]):
        found = cromer.fit(pandas.Series(x, index=index), law="viscous")["angular_frequency"].value
        assert found == pytest.approx(truth, rel=1e-9)
    column = pandas.Series(stamps.tz_localize("Europe/Berlin"))
    assert cromer.fit(column, x, law="viscous")["angular_frequency"].value == pytest.approx(truth, rel=1e-9)
    with pytest.raises(cromer.InputError, match="not times"):
        cromer.fit(t, stamps)
    with pytest.raises(cromer.InputError, match="seconds"):  # it does not know when the record began
        cromer.fit(pandas.Series(x, index=stamps), law="viscous").at(stamps[100:])


def test_masked_and_missing_values_are_missing():
    t, x = swing()
    holes = np.zeros(t.size, bool)
    holes[::7] = True
    nan = cromer.fit(t, np.where(holes, np.nan, x), law="viscous")["angular_frequency"]
    assert cromer.fit(t, np.ma.array(np.where(holes, -999, x), mask=holes), law="viscous")["angular_frequency"] == nan
    pandas = pytest.importorskip("pandas")
    series = pandas.Series(np.where(holes, np.nan, x)).astype("Float64")
    assert cromer.fit(t, series, law="viscous")["angular_frequency"] == nan


@pytest.mark.parametrize("value", [float("nan"), float("inf"), (float("nan"), 0.1), 1j, b"1 kg", object()])
def test_a_mass_that_is_none_is_said_of_the_mass(value):
    t, x = swing()
    with pytest.raises(cromer.InputError, match="mass") as refused:
        cromer.fit(t, x, mass=value)
    assert refused.value.argument == "mass"


def test_what_one_result_has_another_takes():
    t, x = swing(noise=1e-6)
    fit = cromer.fit(t, x, mass=0.2, law="viscous")
    rows = cromer.methods(natural_frequency=fit["angular_frequency"], step=0.01)
    assert rows["exact" if "exact" in rows.names else "rk4"]["name"]
    with pytest.raises(cromer.InputError) as refused:
        cromer.fit(t, x, mass=fit["stiffness"])
    assert refused.value.argument == "mass"
    runs = cromer.simulate(fit, method=["rk4", "euler-cromer"], step=0.001, until=2)
    assert runs.keys() == ["rk4", "euler-cromer"]
    assert np.interp(1.5, runs["rk4"].t, runs["rk4"].x) == pytest.approx(fit.at([1.5]).x[0], abs=1e-6)


def test_segments_and_reynolds_number():
    fit = cromer.fit(str(ROOT / "data" / "recording2.csv"), disc_diameter="12 cm", segment="30 s", law="viscous+drag")
    assert len(fit.decay_segments) == 4 and fit.decay_segments[0]["rate"] > fit.decay_segments[-1]["rate"]
    assert fit.reynolds["max"] == pytest.approx(2532, rel=0.01)
    assert not fit.covariance.flags.writeable
    with pytest.raises(KeyError, match="did you mean 'decay_rate'"):
        fit["decay_rat"]


def test_what_the_document_has_is_an_attribute():
    described = (ROOT / "docs" / "results.md").read_text().split("\n## fit\n")[1].split("\n## ")[0]
    names = set(re.findall(r"^\| `(\w+)", described, re.M))
    assert "monte_carlo" in names
    bare = cromer.fit(*swing(), law="viscous")
    full = cromer.fit(RECORDING_2, mass="217.6 ± 0.3 g", disc_diameter="12 cm", segment="30 s", law="viscous+drag",
                      monte_carlo=1000, goal="decay_rate 0.5 %", textbook=True)
    for fit in (bare, full):
        assert names <= set(dir(fit))
    document = full.to_dict()
    same = names - {"headline", "parameters", "derived", "covariance", "residual", "notices", "message", "held_out"}
    for name in same - {"warnings", "between_samples", "modes"}:
        assert getattr(full, name) == document[name] and document[name], name
    assert bare.monte_carlo is None and not bare.decay_segments and bare.reynolds is None


@pytest.mark.parametrize("name, options, cure", [
    ("stiffness", {}, "give mass= to fit"), ("spring_constant", {}, "'stiffness'; give mass= to fit"),
    ("spring_constant", {"mass": 0.2}, "its name is 'stiffness'"), ("viscous_decay_rate", {}, "its name is 'decay_rate'"),
    ("drag_constant", {"mass": 0.2}, "this fit has"),  # a viscous law has none
    ("reynolds", {}, r"the attribute \.reynolds; give disc_diameter= to fit"),
    ("decay_by_amplitude", {}, r"the attribute \.decay_by_amplitude$")])
def test_a_name_that_is_no_quantity_is_told_the_cure(name, options, cure):
    with pytest.raises(KeyError) as refused:
        cromer.fit(*swing(), law="viscous", **options)[name]
    assert re.search(cure, refused.value.args[0])


@pytest.mark.parametrize("name, cure", [("frequency", r"fit\['frequency'\]"), ("stiffness", "give mass= to fit"),
                                        ("segments", "did you mean decay_segments"), ("nonsense", "has no nonsense")])
def test_an_attribute_that_is_none_is_told_the_cure(name, cure):
    fit = cromer.fit(*swing(), law="viscous")
    with pytest.raises(AttributeError, match=cure):
        getattr(fit, name)
    assert not hasattr(fit, "_repr_png_") and getattr(fit, name, None) is None


def test_estimates_are_written_and_keep_their_uncertainty():
    fit = cromer.fit(*swing(), mass=(0.2, 0.001), law="viscous")
    stiffness = fit["stiffness"]
    assert f"{stiffness:.3f}" == f"{stiffness.value:.3f}" and f"{stiffness}" == str(stiffness)
    for lossy in (lambda: stiffness * 2, lambda: 2 * np.pi * stiffness, lambda: np.ones(3) * stiffness,
                  lambda: stiffness - stiffness, lambda: np.float64(2) / stiffness, lambda: -stiffness):
        with pytest.raises(TypeError, match=r"\.value.*to_uncertainties\(\)"):
            lossy()
    pytest.importorskip("uncertainties")
    found = fit.to_uncertainties()
    assert list(found) == fit.fitted
    i, j = fit.fitted.index("angular_frequency"), fit.fitted.index("velocity")
    total = found["angular_frequency"] + found["velocity"]
    variance = fit.covariance[i, i] + fit.covariance[j, j] + 2 * fit.covariance[i, j]
    assert abs(fit.covariance[i, j]) > 0.01 * np.sqrt(fit.covariance[i, i] * fit.covariance[j, j])
    assert total.std_dev == pytest.approx(np.sqrt(variance), rel=1e-6)


def test_a_table_of_pandas_is_refused_with_the_cure():
    pandas = pytest.importorskip("pandas")
    t, x = swing()
    with pytest.raises(cromer.InputError, match=r"fit\(table\[TIME\].*time, height") as refused:
        cromer.fit(pandas.DataFrame({"time": t, "height": x}))
    assert refused.value.argument == "t"


def test_files_and_what_read_gave():
    recording = cromer.read(RECORDING)
    assert recording["position"].size == recording["Time (s)"].size
    assert recording.units["Position (m)"] == "m"
    of_file = cromer.fit(RECORDING)
    assert of_file["angular_frequency"] == cromer.fit(recording)["angular_frequency"]
    of_arrays = cromer.fit(recording["time"], recording["position"])
    assert of_arrays["angular_frequency"].value == pytest.approx(of_file["angular_frequency"].value, rel=1e-12)
    assert cromer.read(os.fsencode(RECORDING)).columns == recording.columns
    with pytest.raises(KeyError, match="Position"):
        recording[1]
    every = cromer.fit_all(recording)
    assert len(every) == 1 and repr(every) == repr(every[0])


@pytest.mark.parametrize("arguments, options, argument, code", [
    (([0, 1, 2], [0, 1]), {}, None, None),
    (([0, 1, 2], None), {}, "y", "array_is_missing"),
    ((RECORDING, "position"), {}, "y", "file_and_arrays"),
    ((RECORDING,), {"force": np.ones(9)}, "force", "file_and_arrays"),
    (([[0, 1]], [0, 1]), {}, "t", "not_one_dimension"),
    ((["a", "b"], [0, 1]), {}, "t", "no_numbers"),
    (("no_such_file.csv", None), {}, None, None),
    ((np.arange(100.0), np.sin(np.arange(100.0))), {"mas": 1}, "mas", "unknown_argument_but"),
    ((np.arange(100.0), np.sin(np.arange(100.0))), {"mass": "5 N"}, "mass", None),
    ((np.arange(100.0), np.sin(np.arange(100.0))), {"law": "stiff"}, "law", "law_term_unknown")])
def test_wrong_input_is_said(arguments, options, argument, code):
    with pytest.raises(cromer.InputError) as refused:
        cromer.fit(*arguments, **options)
    assert isinstance(refused.value, ValueError) and str(refused.value)
    if argument is not None:
        assert refused.value.argument == argument
    if code is not None:
        assert refused.value.code == code
    again = pickle.loads(pickle.dumps(refused.value))
    assert (str(again), again.code) == (str(refused.value), refused.value.code)


def test_what_does_not_succeed_warns_or_raises():
    t = np.arange(0, 10, 0.01)
    noise = np.random.default_rng(3).normal(0, 1, t.size)
    with pytest.warns(cromer.FitWarning):
        fit = cromer.fit(t, noise)
    assert not fit.succeeded and fit.message and fit.message in repr(fit)
    assert fit.to_uncertainties() == {}
    with pytest.raises(cromer.NoSuccess) as none, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        cromer.fit(t, noise, strict=True)
    assert none.value.result.status == fit.status
    with pytest.warns(cromer.FitWarning):
        compared = cromer.compare(t, noise)
    assert compared.message in repr(compared) and html.escape(compared.message) in compared._repr_html_()


def test_notices_are_warnings_with_codes():
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        fit = cromer.fit(RECORDING)  # too weakly damped to tell its law
    told = {each.message.code for each in caught if isinstance(each.message, cromer.CromerWarning)}
    assert told and told == {each.code for each in fit.notices if each.severity != "detail"}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cromer.simulate(stiffness=9, method="euler-cromer", step=0.01, until=1)  # its notices, if any, are details


def test_errors_have_as_many_digits_as_the_program_gives_them():
    t, x = swing()
    for error in np.geomspace(1e-3, 1e-2, 30):
        fit = cromer.fit(t, x, mass=(1, error), law="viscous")
        shown = re.search(r"spring constant +(.*?) N/m", str(fit).replace("\xa0", " "))[1]
        assert str(fit["stiffness"]).startswith(shown + " N/m")


def test_the_same_as_the_program(program):
    import json
    document = json.loads(program("fit", RECORDING, "--mass", "217.6 ± 0.3 g", "--json"))
    fit = cromer.fit(RECORDING, mass="217.6 ± 0.3 g")
    for name, each in document["parameters"].items():
        assert fit[name].value == each["value"] and fit[name].standard_error == each["standard_error"]
    assert str(fit).splitlines()[0] in program("fit", RECORDING, "--mass", "217.6 ± 0.3 g")


def test_pickled_fits_are_whole():
    t, x = swing()
    fit = cromer.fit(t, x)
    again = pickle.loads(pickle.dumps(fit))
    assert again["decay_rate"] == fit["decay_rate"] and np.array_equal(again.residuals, fit.residuals)
    assert np.array_equal(again.at([1.0, 2.0]).x, fit.at([1.0, 2.0]).x)
    assert str(again) == str(fit)


def test_arrays_live_as_long_as_they_are_used():
    t, x = swing()
    residuals = cromer.fit(t, x).residuals
    kept = residuals.copy()
    for _ in range(5):
        cromer.fit(t, x + 1)
    assert np.array_equal(residuals, kept)
    with pytest.raises(ValueError):
        residuals[0] = 1


def test_other_threads_go_on_and_give_the_same():
    t, x = swing(seconds=100)
    found = []
    threads = [threading.Thread(target=lambda: found.append(cromer.fit(t, x)["decay_rate"])) for _ in range(4)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert len(found) == 4 and len(set(found)) == 1


@pytest.mark.parametrize("false", [False, np.False_])
def test_progress_ends_the_work(false):
    t, x = swing(seconds=600)
    told = []

    def first_word(done):
        told.append(done)
        return false

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        fit = cromer.fit(t, x, progress=first_word)
    assert told and all(0 <= each <= 1 for each in told)
    assert not fit.succeeded and "interrupted" in fit.message

    def failing(done):
        raise RuntimeError("mine")

    with pytest.raises(RuntimeError, match="mine"):
        cromer.fit(t, x, progress=failing)


def test_progress_is_told_within_the_fit_of_one_law():
    t, x = swing(seconds=300)
    told = []

    def third_word(done):
        told.append(done)
        return len(told) < 3

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        fit = cromer.fit(t, x, law="viscous+drag+cubic+hysteresis", progress=third_word)
    assert len(told) == 3 and told == sorted(told) and told[-1] > 0
    assert not fit.succeeded and "interrupted" in fit.message


def interrupted_by_ctrl_c(work):
    """The shares that were told meanwhile."""
    told = []

    def interrupt(done):
        if not told:
            signal.raise_signal(signal.SIGINT)
        told.append(done)

    with pytest.raises(KeyboardInterrupt):
        work(interrupt)
    return told


def test_ctrl_c_ends_the_fit_of_one_law():
    t, x = swing(seconds=300)
    told = interrupted_by_ctrl_c(lambda progress: cromer.fit(t, x, law="viscous+drag+cubic+hysteresis", progress=progress))
    assert len(told) < 5


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
def test_a_forked_process_works_on():
    t, x = swing()
    here = cromer.fit(t, x, law="viscous")["decay_rate"].value
    with multiprocessing.get_context("fork").Pool(1) as pool:
        there = pool.apply_async(_decay_rate, (t, x)).get(timeout=60)
    assert there == here


def _decay_rate(t, x):
    return cromer.fit(t, x, law="viscous")["decay_rate"].value


def test_refusals_follow_the_language():
    t, x = swing()
    with pytest.raises(cromer.InputError, match="Gesetz"):
        cromer.fit(t, x, law="nonsense", language="de")
    fit = cromer.fit(t, x, law="viscous", language="de")
    with pytest.raises(cromer.InputError, match="vor dem ersten benutzten Messwert"):
        fit.at([-1.0])


def test_ctrl_c_ends_the_work():
    told = interrupted_by_ctrl_c(lambda progress: cromer.sweep(
        stiffness=9, damping=0.01, cubic=5, method="rk4", step=0.001, drive_amplitude=1,
        drive_frequency=np.linspace(1, 5, 5000), progress=progress))
    assert max(told) < 0.9


def test_as_it_is_shown():
    t, x = swing()
    fit = cromer.fit(t, x, mass=0.2)
    assert "LawFit: viscous, converged" in repr(fit)
    assert "<table>" in fit._repr_html_()
    for shown in (repr(fit), fit._repr_html_()):
        places = [shown.index(each) for each in ("frequency", "stiffness", "decay rate start", "decay rate end",
                                                 "viscous decay rate", "quality factor")]
        assert places == sorted(places) and f"residual (rms) {fit.residual.rms:.3g} m" in shown
    assert "</svg>" in fit.to_svg() and "stiffness" in fit.to_csv()
    assert "mass" in cromer.fit.__doc__ and "[kg]" in cromer.fit.__doc__


def test_the_headline_has_the_decay_rate_at_both_ends():
    t, x = swing()
    fit = cromer.fit(t, x)
    assert list(fit.headline) == ["frequency", "decay_rate_start", "decay_rate_end"]
    # of the viscous law both are its own
    for end in ("decay_rate_start", "decay_rate_end"):
        assert fit[end].value == pytest.approx(fit["decay_rate"].value, rel=1e-12) and end in fit
        assert fit[end].standard_error == pytest.approx(fit["decay_rate"].standard_error, rel=1e-9)
    assert len(fit.keys()) == len(set(fit.keys())) and "decay_rate_end" in fit.keys()


def test_the_fitted_law_simulated_is_the_record():
    t, x = swing(noise=1e-7)
    fit = cromer.fit(t, x, mass=0.2, law="viscous")
    run = cromer.simulate(**fit.simulation())
    assert np.interp(5.0, run.t, run.x) == pytest.approx(0.05 * np.exp(-0.15) * np.cos(44.5), abs=2e-5)
