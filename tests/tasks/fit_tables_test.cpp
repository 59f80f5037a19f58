// All that a fit's lab tables hold for many small recordings, in tests/tasks/numbers (written anew as
// tests/support/number_sheet.h says): parameters with their units and intervals, plans, segments, stretches,
// budgets, holds and lines, the fitted motion. What the numbers should be is asked elsewhere.
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <random>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/fit_driven.h"
#include "cromer/tasks/fit/fit_forced.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/fit/used_samples.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"
#include "tests/support/number_sheet.h"

namespace cromer::core {
namespace CROMER_FILE {

const std::filesystem::path task_numbers = std::filesystem::path(CROMER_SOURCE_DIR) / "tests/tasks/numbers";

Motion swing_of_law(const char* law) {
  Motion motion{.equilibrium = 0.2, .position = 0.08, .velocity = 0.1};
  motion.law = law_of(law);
  motion.set_angular_frequency(9);
  if (motion.law.has<Viscous>()) motion.set_decay_rate(0.06);
  Oscillator<double>& o = motion.per_mass;
  if (motion.law.has<Drag>()) o.drag = 0.6;
  if (motion.law.has<Friction>()) o.friction = 0.15;
  if (motion.law.has<Cubic>()) o.cubic = 2000;
  if (motion.law.has<Quadratic>()) o.quadratic = 60;
  if (motion.law.has<OddQuadratic>()) o.odd_quadratic = 100;
  if (motion.law.has<Quintic>()) o.quintic = 1e5;
  if (motion.law.has<VanDerPol>()) o.van_der_pol = 60;
  if (motion.law.has<Pendulum>()) motion.position = 0.9;
  if (motion.law.has<VanDerPol>()) motion.set_decay_rate(-0.05);
  return motion;
}

Series recorded(const Motion& motion, const std::vector<double>& t, double noise, int derivative = 0,
                double resolution = 0) {
  Series series;
  const bool angle = motion.law.has<Pendulum>();
  const char* quantities[] = {angle ? "angle" : "position", angle ? "angular velocity" : "velocity",
                              angle ? "angular acceleration" : "acceleration"};
  const char* units[] = {angle ? "rad" : "m", angle ? "rad/s" : "m/s", angle ? "rad/s²" : "m/s²"};
  series.quantity = quantities[derivative];
  series.unit = units[derivative];
  series.column = series.quantity + " (" + series.unit + ")";
  series.time_column = "Time (s)";
  series.rate = 1 / (t[1] - t[0]);
  series.t = t;
  series.y = noisy(observed_motion(motion, {}, t, derivative, 0.004), noise);
  series.resolution = resolution;
  if (resolution > 0)
    for (double& y : series.y) y = resolution * std::round(y / resolution);
  return series;
}

void write_parameters(test::NumberSheet& sheet, const std::vector<Parameter>& all) {
  for (const Parameter& each : all)
    sheet.row("  " + each.name + " [" + each.unit + "]",
              {each.estimate.value, each.estimate.standard_error, each.estimate.low, each.estimate.high});
}

std::string codes_of_all(const std::vector<Notice>& notices) {
  std::string codes;
  for (const Notice& each : notices) codes += " " + each.code;
  return codes;
}

void write_all(test::NumberSheet& sheet, const std::string& name, const Result<FittedRecording>& result) {
  if (!result) return sheet.row(name + ": " + in_words(result.error()), {});
  const FittedRecording& fitted = *result;
  sheet.row(name + codes_of_all(fitted.notices) +
                (fitted.fit.message.empty() ? "" : " (" + fitted.fit.message.code + ")"),
            {static_cast<double>(fitted.used()), fitted.succeeded() ? 1.0 : 0.0});
  write_parameters(sheet, fitted.parameters);
  write_parameters(sheet, fitted.derived);
  sheet.row("  headline", {});
  write_parameters(sheet, fitted.headline);
  if (fitted.held_out)
    sheet.row("  held out", {fitted.held_out->from, fitted.held_out->to,
                             static_cast<double>(fitted.held_out->samples), fitted.held_out->rms});
  if (!fitted.fit.has_values()) return;
  write_parameters(sheet, decay_rate_ends(fitted.fit, 7.5));
  for (const DecaySegment& each : fitted.segments)
    sheet.row("  segment", {each.from, each.to, each.rate.value, each.rate.standard_error, each.rate.high});
  for (const AmplitudeRate& each : fitted.decay_by_amplitude)
    sheet.row("  stretch", {each.from, each.to, each.amplitude, each.rate.value, each.rate.standard_error,
                            each.rate.low, each.law_rate});
  for (const Contribution& each : fitted.stiffness_budget)
    sheet.row("  budget " + each.quantity + " [" + each.unit + "]",
              {each.value, each.standard_uncertainty, each.sensitivity, each.contribution, each.share});
  if (fitted.monte_carlo)
    sheet.row("  trials", {fitted.monte_carlo->mean, fitted.monte_carlo->standard_deviation,
                           fitted.monte_carlo->low, fitted.monte_carlo->high});
  for (const ReynoldsWindow& each : fitted.reynolds) sheet.row("  Reynolds", {each.t, each.value});
  if (fitted.plan) {
    const RecordingPlan& plan = *fitted.plan;
    sheet.row("  plan: " + in_words(plan.text),
              {plan.value, plan.goal, plan.now, plan.met ? 1.0 : 0.0, plan.possible ? 1.0 : 0.0,
               plan.duration, plan.best, plan.noise_ratio, plan.rate_ratio});
  }
  if (fitted.textbook && fitted.textbook->decrement)
    sheet.row("  decrement", {fitted.textbook->decrement->value, fitted.textbook->decrement->standard_error,
                              static_cast<double>(fitted.textbook->decrement->peaks)});
  const FittedMotion motion = fitted_motion(fitted);
  for (const auto& [of, values] : {std::pair{"  residual", &motion.residual}, std::pair{"  x", &motion.x},
                                   std::pair{"  v", &motion.v}, std::pair{"  energy", &motion.energy}})
    sheet.in_short(of, *values);
  std::vector<double> known;
  for (const double each : motion.local_velocity)
    if (!std::isnan(each)) known.push_back(each);
  sheet.in_short("  local velocity", known);
  const MotionUnits units = motion_units(fitted);
  std::string settings = "  in " + units.measured + ", " + units.displacement + ", " + units.velocity + ", " +
                         units.energy + ":";
  std::vector<double> values{motion.per_mass ? 1.0 : 0.0};
  for (const auto& [option, value] : simulate_and_lay_over(fitted)) {
    double number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error == std::errc()) values.insert(values.end(), {number, static_cast<double>(value.size())});
    settings +=
        " " + option + (error == std::errc() ? std::string(end, value.data() + value.size()) : " " + value);
  }
  sheet.row(settings, values);
}

void write_all(test::NumberSheet& sheet, const std::string& name, const Series& series,
               const FitOptions& options) {
  write_all(sheet, name, fit_series(series, "lab.csv", options));
}

FitOptions lab_options(const char* law) {
  FitOptions lab;
  lab.law = law;
  lab.mass = {{0.2176, 0.0003}};
  lab.spring_mass = Quantity{0.01, 0.001};
  lab.disc_diameter = Quantity{0.12, 0.001};
  lab.temperature = Quantity{295.15, 1};
  lab.segments = 3;
  lab.textbook = true;
  lab.monte_carlo = 1000;
  return lab;
}

TEST(FitTables, OfEachLaw) {
  test::NumberSheet sheet;
  const auto t = even_times(400, 0.05);
  for (const char* law :
       {"viscous", "viscous+drag", "friction", "viscous+friction", "viscous+cubic", "viscous+quadratic",
        "viscous+odd-quadratic", "viscous+quintic", "viscous+van-der-pol", "viscous+drag+friction"}) {
    write_all(sheet, law, recorded(swing_of_law(law), t, 5e-4), lab_options(law));
    FitOptions bare;
    bare.law = law;
    write_all(sheet, std::string(law) + ", bare", recorded(swing_of_law(law), t, 5e-4), bare);
  }
  FitOptions bare;
  for (const char* law : {"viscous+pendulum", "viscous+drag+pendulum"}) {
    bare.law = law;
    write_all(sheet, law, recorded(swing_of_law(law), t, 5e-3), bare);
    write_all(sheet, std::string(law) + ", with a mass", recorded(swing_of_law(law), t, 5e-3),
              lab_options(law));
  }
  for (const int derivative : {1, 2})
    for (const char* law : {"viscous", "viscous+drag", "viscous+cubic"})
      write_all(sheet, fmt::format("{}, derivative {}", law, derivative),
                recorded(swing_of_law(law), t, 2e-2, derivative), lab_options(law));
  sheet.expect_as_in(task_numbers / "laws.txt");
}

TEST(FitTables, OfManyKindsOfRecordings) {
  test::NumberSheet sheet;
  const auto t = even_times(400, 0.05);
  const Motion plain = swing_of_law("viscous");
  const auto changed = [&](const char* name, const std::function<void(Series&, FitOptions&)>& change) {
    Series series = recorded(plain, t, 5e-4);
    FitOptions options = lab_options("viscous");
    change(series, options);
    write_all(sheet, name, series, options);
  };
  changed("a length of segments", [](Series&, FitOptions& o) { o.segments.reset(), o.segment = 4.1; });
  changed("a length that fills it", [](Series&, FitOptions& o) { o.segments.reset(), o.segment = 4; });
  changed("a length and a number", [](Series&, FitOptions& o) { o.segments = 2, o.segment = 4; });
  changed("a length and too large a number", [](Series&, FitOptions& o) { o.segments = 9, o.segment = 4; });
  changed("segments that are too short", [](Series&, FitOptions& o) { o.segments = 30; });
  changed("segments just long enough", [](Series&, FitOptions& o) { o.segments = 19; });
  changed("a length that is too short", [](Series&, FitOptions& o) { o.segments.reset(), o.segment = 0.9; });
  changed("a length that is too long", [](Series&, FitOptions& o) { o.segments.reset(), o.segment = 25; });
  changed("from and to", [](Series&, FitOptions& o) { o.from = 3, o.to = 12.02; });
  changed("nothing left", [](Series&, FitOptions& o) { o.from = 30; });
  changed("one in between", [](Series&, FitOptions& o) { o.from = 3, o.to = 3; });
  changed("a mass without error", [](Series&, FitOptions& o) { o.mass = {{0.2, 0}}, o.spring_mass.reset(); });
  changed("no mass",
          [](Series&, FitOptions& o) { o.mass.clear(), o.spring_mass.reset(), o.monte_carlo.reset(); });
  changed("no mass nor disc", [](Series&, FitOptions& o) {
    o.mass.clear(), o.spring_mass.reset(), o.monte_carlo.reset(), o.disc_diameter.reset();
  });
  changed("another seed", [](Series&, FitOptions& o) { o.seed = 7, o.monte_carlo = 1023; });
  changed("far too large", [](Series& s, FitOptions&) {
    for (double& y : s.y) y *= 1e105;
  });
  changed("far too small", [](Series& s, FitOptions&) {
    for (double& y : s.y) y *= 1e-105;
  });
  changed("one far too large", [](Series& s, FitOptions&) { s.y[100] = 1e120; });
  changed("all alike", [](Series& s, FitOptions&) {
    for (double& y : s.y) y = 0.25;
  });
  changed("lost", [](Series& s, FitOptions&) {
    for (std::size_t i = 250; i < s.y.size(); ++i) s.y[i] = 0;
  });
  changed("dropped out", [](Series& s, FitOptions&) {
    for (std::size_t i = 100; i < 112; ++i) s.y[i] = -1;
  });
  changed("a listed outlier", [](Series& s, FitOptions&) {
    s.y[100] = 0.9;
    s.outliers.push_back({s.t[100], s.y[100], 0});
  });
  changed("outliers", [](Series& s, FitOptions&) { s.y[100] = 0.9, s.y[230] = -0.3; });
  changed("in steps", [](Series& s, FitOptions&) {
    for (double& y : s.y) y = 0.01 * std::round(y / 0.01);
    s.resolution = 0.01;
  });
  changed("its clock is rounded", [](Series& s, FitOptions&) { s.clock_error = 1e-3; });
  changed("no name for its quantity", [](Series& s, FitOptions&) { s.quantity.clear(), s.unit.clear(); });
  changed("times from a rate", [](Series& s, FitOptions&) { s.time_column.clear(); });
  changed("another run, in centimetres",
          [](Series& s, FitOptions&) { s.run = 3, s.unit = "cm", s.to_si = 0.01; });
  for (const double noise : {5e-3, 3e-2})
    write_all(sheet, fmt::format("noise {}", noise), recorded(plain, t, noise), lab_options("viscous"));
  for (const std::size_t n : {20, 24, 30, 60})
    write_all(sheet, fmt::format("{} samples", n), recorded(plain, even_times(n, 0.09), 5e-4),
              lab_options("viscous"));
  write_all(sheet, "many periods", recorded(plain, even_times(1500, 0.1), 5e-4), lab_options("viscous"));
  write_all(sheet, "a fine one", recorded(plain, even_times(2000, 0.004), 5e-4), lab_options("viscous"));
  Motion damped = plain;
  damped.set_decay_rate(0.7);
  write_all(sheet, "dies down", recorded(damped, t, 5e-4), lab_options("viscous"));
  damped.set_decay_rate(-0.02);
  write_all(sheet, "grows", recorded(damped, t, 5e-4), lab_options("viscous"));
  std::vector<double> gaps;
  for (int i = 0; i < 600; ++i)
    if (i % 90 < 60) gaps.push_back(0.05 * i);
  write_all(sheet, "gaps", recorded(plain, gaps, 5e-4), lab_options("viscous"));
  sheet.expect_as_in(task_numbers / "recordings.txt");
}

TEST(FitTables, UnderARecordedForce) {
  test::NumberSheet sheet;
  const ForcedSynthetic truth = forced_synthetic({}, multisine(14, 6, 24), 300, 0.05, 1e-3, 4);
  struct Both {
    Series motion, force;
    FitOptions options;
  };
  const auto write = [&](const std::string& name, const std::function<void(Both&)>& change = {}) {
    Both both;
    both.motion.column = "Position (m)";
    both.motion.quantity = "position";
    both.motion.unit = "m";
    both.motion.t = truth.t;
    both.motion.y = truth.y;
    both.force = both.motion;
    both.force.y = truth.force;
    both.force.column = "Force (N)";
    both.force.quantity = "force";
    both.force.unit = "N";
    both.motion.rate = both.force.rate = 20;
    both.motion.lines.assign(300, 7);
    both.force.lines.assign(300, 7);
    both.options.law = "viscous";
    both.options.force_column = "Force (N)";
    both.options.between_samples = "linear";
    if (change) change(both);
    write_all(sheet, name, fit_forced(both.motion, both.force, "lab.csv", both.options, {}));
  };
  const auto cut = [](Series& series, std::size_t from, std::size_t to) {
    const auto part = [&](auto& all) {
      all = {all.begin() + static_cast<std::ptrdiff_t>(from), all.begin() + static_cast<std::ptrdiff_t>(to)};
    };
    part(series.t);
    part(series.y);
    part(series.lines);
  };
  write("whole");
  write("with a mass", [](Both& b) { b.options.mass = {{0.4, 0.001}}, b.options.monte_carlo = 1000; });
  write("with a disc", [](Both& b) {
    b.options.mass = {{0.4, 0.001}}, b.options.disc_diameter = Quantity{0.1, 0};
  });
  write("drag with a disc", [](Both& b) {
    b.options.law = "viscous+drag", b.options.mass = {{0.4, 0.001}},
    b.options.disc_diameter = Quantity{0.1, 0};
  });
  for (const double share : {0.01, 0.1, 0.333, 0.9})
    write(fmt::format("{} held out", share), [=](Both& b) { b.options.hold_out = share; });
  write("without a spring", [](Both& b) { b.options.no_spring = true; });
  write("a part", [](Both& b) { b.options.from = 3.02, b.options.to = 11; });
  write("an outlier", [](Both& b) {
    b.motion.y[100] = 3, b.motion.outliers.push_back({b.motion.t[100], b.motion.y[100], 7});
  });
  write("outliers at both ends", [](Both& b) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{299}})
      b.motion.y[i] = 3, b.motion.outliers.push_back({b.motion.t[i], b.motion.y[i], 7});
  });
  write("the force ends one sample early", [&](Both& b) { cut(b.force, 0, 299); });
  write("the force begins one sample late", [&](Both& b) { cut(b.force, 1, 300); });
  write("the motion is shorter", [&](Both& b) { cut(b.motion, 100, 260); });
  write("the motion has every third sample", [](Both& b) {
    Series third = b.motion;
    third.t.clear(), third.y.clear(), third.lines.clear();
    for (std::size_t i = 0; i < 300; i += 3)
      third.t.push_back(b.motion.t[i]), third.y.push_back(b.motion.y[i]), third.lines.push_back(7);
    b.motion = third;
  });
  for (const double off : {0.0004, 0.004, 0.02})
    write(fmt::format("the motion {} s later", off), [=](Both& b) {
      for (double& t : b.motion.t) t += off;
      b.options.to = 14;
    });
  for (const double off : {0.0004, 0.01})
    write(fmt::format("one time of the force is {} s off", off), [=](Both& b) { b.force.t[150] += off; });
  write("the force never changes", [](Both& b) { b.force.y.assign(300, 2); });
  write("the same column", [](Both& b) { b.force.column = b.motion.column; });
  const auto with_gap = [&](Both& b, std::size_t from, std::size_t to) {
    cut(b.motion, from, to);
    Series some = b.force, rest = b.force;
    cut(some, 0, 100);
    cut(rest, 120, 300);
    for (std::size_t i = 0; i < rest.t.size(); ++i)
      some.t.push_back(rest.t[i]), some.y.push_back(rest.y[i]), some.lines.push_back(7);
    b.force = some;
    b.force.gaps.push_back({.t = 4.95, .length = 1.05});
  };
  write("a gap of the force before", [&](Both& b) { with_gap(b, 150, 300); });
  write("a gap of the force just before", [&](Both& b) { with_gap(b, 120, 300); });
  write("a gap of the force behind", [&](Both& b) { with_gap(b, 0, 80); });
  write("a gap of the force just behind", [&](Both& b) { with_gap(b, 0, 100); });
  write("a gap of the force amid", [&](Both& b) { with_gap(b, 90, 200); });
  sheet.expect_as_in(task_numbers / "forced.txt");
}

TEST(FitTables, UnderAHarmonicForce) {
  test::NumberSheet sheet;
  const auto t = even_times(260, 0.05);
  const auto series_of = [&](double drive, double push, double g, int derivative = 0) {
    Motion motion = swing_of_law("viscous");
    motion.set_decay_rate(g);
    motion.cosine = push;
    motion.drive_frequency = drive;
    Series series = recorded(motion, t, 0, derivative);
    series.y = noisy(observed_motion(motion, Drive::harmonic(), t, derivative, 0.004), 5e-4);
    return series;
  };
  const auto write = [&](const std::string& name, const Series& series, const FitOptions& options) {
    write_all(sheet, name, fit_driven(series, "lab.csv", options, {}));
  };
  FitOptions plain;
  plain.law = "viscous";
  plain.drive_frequency = "auto";
  for (const double drive : {4.0, 6.2, 8.0, 8.7, 9.3, 12.0, 20.0})
    for (const double push : {0.3, 3.0})
      write(fmt::format("driven at {} by {}", drive, push), series_of(drive, push, 0.1), plain);
  for (const double g : {0.02, 0.5, 2.0})
    write(fmt::format("its swing decays by {}", g), series_of(8, 3, g), plain);
  for (const int derivative : {1, 2})
    write(fmt::format("derivative {}", derivative), series_of(8, 3, 0.1, derivative), plain);
  FitOptions asked = plain;
  for (const char* drive : {"1.27 Hz", "1.3 Hz", "1.6 Hz", "9.9 Hz", "10 Hz", "11 Hz", "8 rad/s"}) {
    asked.drive_frequency = drive;
    write(std::string("named ") + drive, series_of(8, 3, 0.1), asked);
  }
  FitOptions all = lab_options("viscous");
  all.drive_frequency = "auto";
  all.goal = "decay_rate 1 %";
  all.segment = 3;
  write("with all of the lab", series_of(8, 3, 0.1), all);
  all.law = "viscous+drag";
  write("with all of the lab, drag", series_of(8, 3, 0.1), all);
  Series aside = series_of(8, 3, 0.1);
  aside.y[0] = 2;
  aside.outliers.push_back({aside.t[0], aside.y[0], 0});
  write("its first sample aside", aside, plain);
  sheet.expect_as_in(task_numbers / "driven.txt");
}

TEST(FitTables, Plans) {
  test::NumberSheet sheet;
  const auto t = even_times(200, 0.05);
  const auto write = [&](const char* law, const char* goal, bool with_mass = false) {
    FitOptions options;
    options.law = law;
    options.goal = goal;
    if (with_mass) options.mass = {{0.2176, 0.0003}}, options.disc_diameter = Quantity{0.12, 0.001};
    Series series = recorded(swing_of_law(law), t, 1e-3);
    const auto fitted = fit_series(series, "lab.csv", options);
    const std::string name = std::string(law) + " " + goal + (with_mass ? ", with a mass: " : ": ");
    if (!fitted) return sheet.row(name + in_words(fitted.error()), {});
    if (!fitted->plan) return sheet.row(name + "none", {});
    const RecordingPlan& plan = *fitted->plan;
    sheet.row(name + in_words(plan.text) + " [" + plan.unit + "]",
              {plan.value, plan.goal, plan.now, plan.met ? 1.0 : 0.0, plan.possible ? 1.0 : 0.0,
               plan.duration, plan.best, plan.noise_ratio, plan.rate_ratio});
  };
  for (const char* goal : {"decay_rate 5 %",
                           "decay_rate 2 %",
                           "decay_rate 1 %",
                           "decay_rate 0.3 %",
                           "decay_rate 0.1 %",
                           "decay_rate 0.0001 1/s",
                           "frequency 0.01 %",
                           "frequency 0.0001 Hz",
                           "frequency 1e-7 Hz",
                           "period 1 ms",
                           "period 1 us",
                           "quality_factor 1 %",
                           "damping_ratio 0.0001",
                           "equilibrium 1 mm",
                           "equilibrium 1e-5 m",
                           "position 1 %",
                           "position 1e-5 m",
                           "velocity 1 mm/s",
                           "logarithmic_decrement 0.5 %",
                           "limit_cycle_amplitude 1 %",
                           "angular_frequency 300 %",
                           "decay_rate 200 %",
                           "stiffness 1 %",
                           "drag 1 %",
                           "decay_rate 1 m",
                           "decay_rate 0 %",
                           "period -1 ms",
                           "period",
                           "velocty 1 %",
                           "angular frequency 1 %",
                           "brightness 3 %",
                           "decay_rate x %"})
    write("viscous", goal);
  for (const char* goal : {"stiffness 1 %", "stiffness 0.2 %", "stiffness 0.1 %", "damping 1 %",
                           "damping 0.0001 kg/s", "drag_coefficient 1 %"})
    write("viscous", goal, true);
  for (const char* goal :
       {"drag 3 %", "drag 0.5 %", "decay_rate 10 %", "frequency 0.01 %", "damping_ratio 1 %"})
    write("viscous+drag", goal);
  write("viscous+drag", "drag_coefficient 3 %", true);
  for (const char* goal : {"friction 1 %", "friction 0.1 %", "frequency 0.001 %", "equilibrium 1e-6 m"})
    write("friction", goal);
  for (const char* goal : {"cubic 1 %", "frequency 0.01 %"}) write("viscous+cubic", goal);
  sheet.expect_as_in(task_numbers / "plans.txt");
}

TEST(FitTables, StaticFits) {
  test::NumberSheet sheet;
  const auto rows_of = [](const std::vector<double>& levels, std::size_t each, bool timed) {
    std::string rows = timed ? "Time (s),Position (m)\n" : "Position (m)\n";
    std::size_t n = 0;
    for (const double level : levels)
      for (std::size_t i = 0; i < each; ++i, ++n) {
        const double y = level + 1e-4 * std::sin(static_cast<double>(n * n));
        rows += timed ? fmt::format("{:.2f},{:.5f}\n", 0.05 * static_cast<double>(n), y)
                      : fmt::format("{:.5f}\n", y);
      }
    return rows;
  };
  const std::string two_runs = [] {
    std::string rows = "Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2\n";
    for (int i = 0; i < 60; ++i)
      rows += fmt::format("{0:.2f},{1:.5f},{0:.2f},{2:.5f}\n", 0.05 * i, 0.1 + 1e-4 * std::sin(1.0 * i * i),
                          0.2 + 1e-4 * std::cos(1.0 * i * i));
    return rows;
  }();
  const auto write = [&](const std::string& name, const std::vector<std::string>& files,
                         StaticOptions options) {
    std::vector<Recording> recordings;
    for (const std::string& each : files) {
      const auto read = read_recording(each, fmt::format("{}.csv", recordings.size()), {});
      ASSERT_TRUE(read.ok()) << name;
      recordings.push_back(*read);
    }
    const auto found = fit_static(recordings, options);
    if (!found) return sheet.row(name + ": " + in_words(found.error()), {});
    sheet.row(name + codes_of_all(found->notices),
              {found->stiffness.value, found->stiffness.standard_error, found->stiffness.low});
    for (const Hold& each : found->holds)
      sheet.row("  hold " + each.file, {static_cast<double>(each.run), each.from, each.to, each.position,
                                        each.standard_error, each.mass.value});
  };
  const std::vector<Quantity> one{{0.1, 0}}, two{{0.1, 1e-4}, {0.3, 1e-4}},
      three{{0.1, 0}, {0.2, 0}, {0.3, 0}};
  const std::string low = rows_of({0.1}, 60, true), high = rows_of({0.2}, 60, true),
                    stairs = rows_of({0.1, 0.15, 0.2}, 80, true);
  const auto with = [](const std::vector<Quantity>& masses) { return StaticOptions{.masses = masses}; };
  write("two files", {low, high}, with(two));
  write("three files, two masses", {low, high, low}, with(two));
  write("two files, three masses", {low, high}, with(three));
  write("one file of stairs", {stairs}, with(three));
  write("one file of one hold", {low}, with(one));
  write("stairs and a hold", {stairs, high}, with(two));
  write("two runs", {two_runs}, with(two));
  write("two runs and a file", {two_runs, high}, with({{0.1, 0}, {0.2, 0}, {0.2, 0}}));
  write("two runs, one mass", {two_runs}, with(one));
  write("without times", {rows_of({0.1, 0.15, 0.2}, 80, false)}, with(three));
  StaticOptions run = with(one);
  run.fit.run = 2;
  write("one of two runs", {two_runs}, run);
  StaticOptions part = with(two);
  part.fit.to = 7.9;
  write("the first stairs", {stairs}, part);
  StaticOptions law = with(two);
  law.fit.law = "viscous";
  write("with a law", {low, high}, law);
  StaticOptions moon = with(two);
  moon.gravity = {1.62, 0.01};
  write("on the moon", {low, high}, moon);
  sheet.expect_as_in(task_numbers / "static_fits.txt");
}

TEST(FitTables, HoldsAndLines) {
  test::NumberSheet sheet;
  const auto write_static = [&](const std::string& name, const Result<std::vector<Hold>>& holds,
                                const Quantity& gravity = {9.81, 0.01}) {
    if (!holds) return sheet.row(name + ": " + in_words(holds.error()), {});
    for (const Hold& each : *holds)
      sheet.row(name, {each.from, each.to, static_cast<double>(each.samples), each.position, each.scatter,
                       each.standard_error, each.moves ? 1.0 : 0.0, each.mass.value});
    const auto found = static_stiffness(*holds, gravity);
    if (!found) return sheet.row("  " + in_words(found.error()), {});
    sheet.row(
        "  stiffness" + codes_of_all(found->notices),
        {found->stiffness.value, found->stiffness.standard_error, found->stiffness.low, found->stiffness.high,
         found->line.slope, found->line.intercept, found->line.chi_squared, found->line.extra_scatter});
  };
  const auto held = [&](const std::vector<double>& levels, std::size_t each, double noise,
                        double resolution = 0, double drift = 0, std::size_t between = 10) {
    Series series;
    series.column = "Position (m)";
    series.quantity = "position";
    series.unit = "m";
    series.resolution = resolution;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      if (k > 0)
        for (std::size_t i = 1; i <= between; ++i)
          series.y.push_back(levels[k - 1] + (levels[k] - levels[k - 1]) * static_cast<double>(i) /
                                                 static_cast<double>(between + 1));
      for (std::size_t i = 0; i < each; ++i) series.y.push_back(levels[k] + drift * static_cast<double>(i));
    }
    series.y = noisy(series.y, noise);
    for (std::size_t i = 0; i < series.y.size(); ++i) series.t.push_back(0.1 * static_cast<double>(i));
    series.lines.resize(series.y.size());
    return series;
  };
  const std::vector<Quantity> three{{0.1, 1e-4}, {0.2, 1e-4}, {0.3, 1e-4}}, two{{0.1, 0}, {0.3, 0}};
  write_static("three", find_holds({held({0.1, 0.15, 0.2}, 200, 1e-4)}, "h.csv", three));
  write_static("three, out of line", find_holds({held({0.1, 0.158, 0.2}, 200, 1e-4)}, "h.csv", three));
  write_static("three, out of order", find_holds({held({0.1, 0.05, 0.2}, 200, 1e-4)}, "h.csv", three));
  write_static("from below", find_holds({held({0.2, 0.15, 0.1}, 200, 1e-4)}, "h.csv", three));
  write_static("coarse", find_holds({held({0.1, 0.15, 0.2}, 200, 1e-5, 1e-3)}, "h.csv", three));
  write_static("drifting", find_holds({held({0.1, 0.15, 0.2}, 200, 1e-5, 0, 1e-5)}, "h.csv", three));
  write_static("quickly", find_holds({held({0.1, 0.15, 0.2}, 25, 1e-4, 0, 0, 2)}, "h.csv", three));
  write_static("too quickly", find_holds({held({0.1, 0.15, 0.2}, 8, 1e-4, 0, 0, 2)}, "h.csv", three));
  write_static("two of three", find_holds({held({0.1, 0.2}, 200, 1e-4)}, "h.csv", three));
  write_static("two", find_holds({held({0.1, 0.2}, 200, 1e-4)}, "h.csv", two), {9.81, 0});
  Series disturbed = held({0.1, 0.15, 0.2}, 200, 1e-4);
  for (std::size_t i = 300; i < 312; ++i) disturbed.y[i] += 0.03 * std::sin(static_cast<double>(i));
  write_static("disturbed", find_holds({disturbed}, "h.csv", three));
  write_static("in runs", find_holds({held({0.1}, 50, 1e-4), held({0.15}, 60, 1e-4), held({0.2}, 3, 1e-4)},
                                     "h.csv", three));
  write_static(
      "runs of one sample",
      find_holds({held({0.1}, 1, 1e-4), held({0.15}, 2, 1e-4), held({0.2}, 4, 1e-4)}, "h.csv", three));
  const auto write_line = [&](const std::string& name, const std::vector<double>& w,
                              const std::vector<Quantity>& masses, double error = 1e-3) {
    std::vector<FittedRecording> fits;
    for (const double each : w) {
      FittedRecording one;
      one.fit.names = {"angular_frequency"};
      one.fit.estimates = {make_estimate(each, error, 2)};
      one.fit.student = 2;
      if (each < 1) one.fit.status = FitStatus::too_short;
      fits.push_back(one);
    }
    const auto line = mass_line(fits, masses);
    if (!line) return sheet.row(name + ": " + in_words(line.error()), {});
    sheet.row(name + codes_of_all(line->notices),
              {line->stiffness.value, line->stiffness.standard_error, line->stiffness.high,
               line->effective_mass.value, line->effective_mass.standard_error, line->spring_mass.value,
               line->spring_mass.low, line->spring_mass.high, line->line.extra_scatter});
    for (const MassLinePoint& each : line->points)
      sheet.row("  point", {each.mass.value, each.period_square.value, each.period_square.standard_error});
  };
  write_line("a line", {12, 8.9, 7.35}, three);
  write_line("a line that scatters", {12, 8.7, 7.35}, three);
  write_line("exact frequencies", {12, 8.9, 7.35}, three, 1e-6);
  write_line("of two", {12, 7.35}, two);
  write_line("one left out", {12, 0, 7.35}, three);
  write_line("two left out", {12, 0, 0}, three);
  write_line("falling", {7, 9, 12}, three);
  write_line("another number", {7, 9}, three);
  sheet.expect_as_in(task_numbers / "holds.txt");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
