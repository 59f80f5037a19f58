// What comes of a hundred and twenty recordings, and how much work it takes, in tests/tasks/ledger.txt: each
// number that is found, with its standard error, each notice's code, and how often the work looked whether to
// stop. What the numbers should be is asked elsewhere; here they stay what they are, so that nothing in
// between changes unseen. Run whole (--gtest_filter='*Ledger*') with CROMER_WRITE_TRANSCRIPTS=1, the test
// writes what comes out now: read the difference before you commit it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <tuple>

#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/modal_records.h"
#include "tests/identify/network_truth.h"
#include "tests/identify/synthetic.h"
#include "tests/support/bytes_of.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

const std::string ledger_file = std::string(CROMER_SOURCE_DIR) + "/tests/tasks/ledger.txt";

struct Case {
  std::string name, bytes;
  FitOptions options{};
};

/// A file of times and one or two columns, the values to five digits of the largest.
std::string file_of(const std::vector<double>& t, const std::vector<std::vector<double>>& columns,
                    const std::string& header) {
  std::string bytes = header + "\n";
  double largest = 0;
  for (const auto& column : columns)
    for (const double value : column) largest = std::max(largest, std::abs(value));
  const int decimals = std::max(0, 4 - static_cast<int>(std::floor(std::log10(largest))));
  for (std::size_t i = 0; i < t.size(); ++i) {
    bytes += fmt::format("{:.4f}", t[i]);
    for (const auto& column : columns) bytes += fmt::format(",{:.{}f}", column[i], decimals);
    bytes += "\n";
  }
  return bytes;
}

Motion swing(double frequency, double decay_rate, double position = 0.08) {
  Motion motion{.equilibrium = 0.02, .position = position, .velocity = 0.05};
  motion.law = law_of("viscous");
  motion.set_angular_frequency(2 * std::numbers::pi * frequency);
  motion.set_decay_rate(decay_rate);
  return motion;
}

Motion with(const char* law, double value, Motion motion = swing(1, 0.03)) {
  motion.law = law_of(law);
  if (motion.law.has<Drag>()) motion.per_mass.drag = value;
  if (motion.law.has<Friction>()) motion.per_mass.friction = value;
  if (motion.law.has<Cubic>()) motion.per_mass.cubic = value;
  if (motion.law.has<Quadratic>()) motion.per_mass.quadratic = value;
  if (motion.law.has<OddQuadratic>()) motion.per_mass.odd_quadratic = value;
  if (motion.law.has<Quintic>()) motion.per_mass.quintic = value;
  if (motion.law.has<VanDerPol>()) motion.per_mass.van_der_pol = value;
  return motion;
}

const std::vector<double> usual = even_times(1000, 0.02);

std::string free_swing(const Motion& motion, double noise = 2e-4, const std::vector<double>& t = usual,
                       const std::string& header = "Time (s),Position (m)", int derivative = 0) {
  return file_of(t, {noisy(observed_motion(motion, {}, t, derivative, 0.002), noise)}, header);
}

std::string driven_swing(Motion motion, double cosine, double at, const std::vector<double>& t = usual) {
  motion.cosine = cosine;
  motion.sine = 0.3 * cosine;
  motion.drive_frequency = 2 * std::numbers::pi * at;
  return file_of(t, {noisy(observed_motion(motion, Drive::harmonic(), t, 0, 0.002), 2e-4)},
                 "Time (s),Position (m)");
}

std::string changed_swing(const std::function<double(double t, double x)>& change,
                          const Motion& motion = swing(1, 0.03), const std::vector<double>& t = usual) {
  std::vector<double> y = noisy(observed_motion(motion, {}, t, 0, 0.002), 2e-4);
  for (std::size_t i = 0; i < t.size(); ++i) y[i] = change(t[i], y[i]);
  return file_of(t, {y}, "Time (s),Position (m)");
}

std::string forced_swing(const ForcedTruth& truth, bool hold = false) {
  const auto acting = multisine(20, 3);
  std::vector<double> samples;
  for (int i = 0; i < 1000; ++i) samples.push_back(acting(0.02 * i));
  const ForcedSynthetic record =
      forced_synthetic(truth, read_between(samples, 0.02, hold), 1000, 0.02, 1e-3, 4);
  return file_of(record.t, {record.y, record.force}, "Time (s),Position (m),Force (N)");
}

/// A short one: a derivative of the motion, changed rows.
std::string short_forced_swing(const ForcedTruth& truth, int derivative = 0,
                               const std::function<void(ForcedSynthetic&)>& change = {}) {
  ForcedSynthetic record = forced_synthetic(truth, multisine(14, 6), 400, 0.025, 1e-3, 4, derivative);
  if (change) change(record);
  const char* columns[] = {"Position (m)", "Velocity (m/s)", "Acceleration (m/s^2)"};
  return file_of(record.t, {record.y, record.force},
                 fmt::format("Time (s),{},Force (N)", columns[derivative]));
}

std::vector<double> some_of(const std::vector<double>& t, const std::function<bool(std::size_t)>& is_kept) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (is_kept(i)) kept.push_back(t[i]);
  return kept;
}

FitOptions of_law(const char* law) {
  FitOptions options;
  options.law = law;
  return options;
}

FitOptions under_force(const char* law = "auto") {
  FitOptions options = of_law(law);
  options.force_column = "Force (N)";
  return options;
}

auto free_cases() {
  Motion pendulum = swing(0.7, 0.02, 1.1);
  pendulum.law = law_of("viscous+pendulum");
  pendulum.set_angular_frequency(4.4);
  Motion high = swing(0.7, 0.05, 2.8);
  high.law = law_of("viscous+pendulum");
  high.set_angular_frequency(4.4);
  Motion hysteretic = swing(1, 0.02);
  hysteretic.law = law_of("viscous+hysteresis");
  hysteretic.per_mass.hysteresis_stiffness = 12;
  hysteretic.per_mass.hysteresis_beta = 30;
  hysteretic.per_mass.hysteresis_gamma = 10;
  FitOptions lab;
  lab.mass = {{0.2176, 0.0003}};
  lab.spring_mass = Quantity{0.01, 0.001};
  lab.disc_diameter = Quantity{0.12, 0.001};
  lab.temperature = Quantity{295.15, 1};
  lab.segments = 4;
  lab.textbook = true;
  lab.goal = "decay_rate 0.5 %";
  FitOptions held;
  held.hold_out = 0.3;
  FitOptions trials;
  trials.monte_carlo = 1000;
  trials.mass = {{0.5, 0.01}};
  FitOptions part;
  part.from = 4;
  part.to = 11.5;
  part.segment = 2.5;
  const Motion plain = swing(1, 0.03);
  const auto decayed = [](double decay, double at) { return std::exp(-decay * std::max(0.0, at)); };
  return std::to_array<Case>({
      {"viscous, with all of the lab", free_swing(plain), lab},
      {"viscous, the last 30 % held out", free_swing(plain), held},
      {"viscous, Monte Carlo", free_swing(plain), trials},
      {"viscous, a part of it in segments", free_swing(plain), part},
      {"viscous, noisy", free_swing(plain, 0.02)},
      {"viscous, two and a half cycles", free_swing(plain, 2e-4, even_times(125, 0.02))},
      {"viscous, twenty samples", free_swing(plain, 2e-4, even_times(20, 0.11))},
      {"viscous, two samples a cycle and a half", free_swing(swing(1, 0.01), 2e-4, even_times(300, 0.43))},
      {"viscous, fine and long", free_swing(swing(2.5, 0.004), 2e-4, even_times(12000, 0.01))},
      {"viscous, strongly damped", free_swing(swing(1, 3), 1e-4, even_times(400, 0.005))},
      {"viscous, more than critical", free_swing(swing(1, 9), 1e-4, even_times(800, 0.005))},
      {"viscous, growing", free_swing(swing(1, -0.05, 0.02))},
      {"viscous, velocities", free_swing(plain, 1e-3, usual, "Time (s),Velocity (m/s)", 1), lab},
      {"viscous, accelerations", free_swing(plain, 1e-2, usual, "Time (s),Acceleration (m/s^2)", 2)},
      {"viscous, uneven times",
       free_swing(plain, 2e-4, some_of(usual, [](std::size_t i) { return i % 7 < 4; }))},
      {"viscous, two gaps",
       free_swing(plain, 2e-4, some_of(usual, [](std::size_t i) { return i % 400 > 60; }))},
      {"drag", free_swing(with("viscous+drag", 1.5)), lab},
      {"friction, to its rest", free_swing(with("friction", 0.12, swing(1, 0))), of_law("auto")},
      {"friction", free_swing(with("friction", 0.02, swing(1, 0))), of_law("friction")},
      {"viscous and friction", free_swing(with("viscous+friction", 0.03))},
      {"viscous, drag and friction", free_swing(with("viscous+drag+friction", 0.05)), lab},
      {"cubic", free_swing(with("viscous+cubic", 300))},
      {"softening cubic", free_swing(with("viscous+cubic", -600))},
      {"quadratic", free_swing(with("viscous+quadratic", 60))},
      {"odd quadratic", free_swing(with("viscous+odd-quadratic", 40))},
      {"quintic", free_swing(with("viscous+quintic", 2e4))},
      {"pendulum", free_swing(pendulum, 2e-3, usual, "Time (s),Angle (rad)")},
      {"two modes",
       changed_swing([&](double t, double x) { return x + 0.05 * decayed(0.02, t) * std::cos(7.1 * t); })},
      {"with a quiet overtone",
       changed_swing([](double t, double x) { return x + 5e-4 * std::sin(31 * t); })},
      {"outliers",
       changed_swing([](double t, double x) { return std::fmod(t, 3.1) < 0.019 ? x + 0.07 : x; })},
      {"clipped", changed_swing([](double, double x) { return std::min(x, 0.07); })},
      {"coarse", changed_swing([](double, double x) { return 0.005 * std::round(x / 0.005); })},
      {"drifting", changed_swing([](double t, double x) { return x + 0.001 * t; })},
      {"caught", changed_swing([](double t, double x) { return t < 14.3 ? x : 0.02; })},
      {"let go late", changed_swing([](double t, double x) { return t < 3.27 ? 0.1 : x; })},
      {"pushed on the way",
       changed_swing([](double t, double x) { return t < 9 ? x : 0.02 + 1.7 * (x - 0.02); })},
      {"a wandering noise",
       [] {
         std::mt19937_64 engine(8);
         std::normal_distribution<double> normal(0, 1e-3);
         double at = 0;
         return changed_swing([&](double, double x) { return x + (at = 0.9 * at + normal(engine)); });
       }()},
      {"noise alone",
       changed_swing([](double, double x) { return x; }, swing(1, 0.03, 0), even_times(400, 0.02))},
      {"a straight line", changed_swing([](double t, double x) { return 0.3 * t + 1e-3 * x; })},
      {"friction, three half swings",
       free_swing(with("friction", 0.5, swing(1, 0)), 2e-4, even_times(200, 0.02)), of_law("auto")},
      {"viscous and friction, four half swings",
       free_swing(with("viscous+friction", 0.3, swing(1, 0.1)), 2e-4, even_times(200, 0.02)),
       of_law("viscous+friction")},
      {"friction, seen by its velocity",
       free_swing(with("friction", 0.2, swing(1, 0)), 1e-3, even_times(300, 0.02), "Time (s),Velocity (m/s)",
                  1),
       of_law("friction")},
      {"hysteresis", free_swing(hysteretic, 2e-4, even_times(400, 0.02)), of_law("viscous+hysteresis")},
      {"drag, and a cubic term that is not there",
       free_swing(with("viscous+drag", 1, with("viscous+drag+cubic", 500)), 2e-4, even_times(300, 0.03)),
       of_law("viscous+drag+cubic")},
      {"pendulum, nearly upside down", free_swing(high, 2e-3, even_times(500, 0.02), "Time (s),Angle (rad)")},
      {"in centimetres, to whole numbers",
       [] {
         std::string rows = "Time (s),Position (cm)\n";
         for (int i = 0; i < 400; ++i)
           rows += fmt::format("{:.3f},{:.0f}\n", 0.025 * i, 40 * std::exp(-0.001 * i) * std::cos(0.17 * i));
         return rows;
       }()},
      {"uneven times, drag",
       free_swing(with("viscous+drag", 1.5), 2e-4,
                  some_of(even_times(600, 0.02), [](std::size_t i) { return i * i % 11 < 5; }))},
      {"let go late, noisy",
       [] {
         std::mt19937_64 engine(3);
         std::normal_distribution<double> normal(0, 3e-3);
         return changed_swing([&](double t, double x) { return t < 4.1 ? 0.1 + normal(engine) : x; },
                              swing(1, 0.05), even_times(700, 0.02));
       }()},
      {"loud at one time",
       [] {
         std::mt19937_64 engine(3);
         std::normal_distribution<double> normal(0, 1);
         return changed_swing(
             [&](double t, double x) { return x + (t > 3 && t < 5 ? 0.01 : 2e-4) * normal(engine); },
             swing(1, 0.05), even_times(500, 0.02));
       }()},
      {"a part missing beside outliers",
       changed_swing([](double t, double x) { return std::fmod(t, 1.7) < 0.019 ? x - 0.3 : x; },
                     swing(1, 0.05),
                     some_of(even_times(600, 0.02), [](std::size_t i) { return i < 200 || i > 290; }))},
      {"two modes, near",
       changed_swing([&](double t, double x) { return x + 0.05 * decayed(0.03, t) * std::cos(6.6 * t); },
                     swing(1, 0.03), even_times(600, 0.04))},
      {"twelve samples", free_swing(plain, 2e-4, even_times(12, 0.13))},
      {"two runs", "Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2\n" +
                       [] {
                         std::string rows;
                         for (int i = 0; i < 500; ++i) {
                           const double t = 0.02 * i;
                           rows += fmt::format("{0:.2f},{1:.4f},{0:.2f},{2:.4f}\n", t,
                                               0.3 * std::exp(-0.05 * t) * std::cos(6 * t),
                                               0.2 * std::exp(-0.08 * t) * std::sin(4.5 * t));
                         }
                         return rows;
                       }()},
  });
}

auto driven_cases() {
  FitOptions at_known;
  at_known.drive_frequency = "1.3 Hz";
  FitOptions sought = of_law("auto");
  sought.drive_frequency = "auto";
  FitOptions no_spring = under_force();
  no_spring.no_spring = true;
  FitOptions held = under_force("viscous");
  held.between_samples = "hold";
  FitOptions held_out = under_force("viscous+drag");
  held_out.hold_out = 0.4;
  held_out.mass = {{0.4, 0.001}};
  FitOptions part = under_force("viscous");
  part.from = 2.51;
  part.to = 8.2;
  part.between_samples = "band-limited";
  FitOptions weighed = at_known;
  weighed.mass = {{0.5, 0.002}};
  weighed.disc_diameter = Quantity{0.1, 0.001};
  weighed.law = "viscous";
  Motion pushed = swing(1, 0.1);
  pushed.cosine = 3;
  pushed.drive_frequency = 2 * std::numbers::pi * 1.3;
  const std::vector<double> shortly = even_times(400, 0.02);
  const std::string driven_velocities =
      file_of(shortly, {noisy(observed_motion(pushed, Drive::harmonic(), shortly, 1, 0.002), 2e-3)},
              "Time (s),Velocity (m/s)");
  return std::to_array<Case>({
      {"driven near resonance", driven_swing(swing(1, 0.2), 0.6, 1.08)},
      {"driven, its frequency known", driven_swing(swing(1, 0.1), 3, 1.3), at_known},
      {"driven, its frequency sought", driven_swing(swing(1, 0.1), 3, 0.7), sought},
      {"driven at resonance", driven_swing(swing(1, 0.15), 0.3, 1)},
      {"driven, with drag", driven_swing(with("viscous+drag", 2), 3, 1.4), sought},
      {"driven, with friction", driven_swing(with("viscous+friction", 0.15), 4, 1.3), at_known},
      {"driven, hardening", driven_swing(with("viscous+cubic", 800), 3, 1.3), sought},
      {"beats of a driven swing", driven_swing(swing(1, 0.004), 0.4, 1.06, even_times(2500, 0.02))},
      {"under a recorded force", forced_swing({.quadratic = 0}), under_force()},
      {"under a recorded force, hardening", forced_swing({.cubic = 400}), under_force()},
      {"under a recorded force, drag", forced_swing({.drag = 2}), under_force()},
      {"under a held force", forced_swing({}, true), held},
      {"under a force without a spring", forced_swing({.w0 = 0.001, .g = 0.4}), no_spring},
      {"under a force, velocities", short_forced_swing({}, 1), under_force("viscous")},
      {"under a force, accelerations", short_forced_swing({}, 2), under_force("viscous")},
      {"under a force, the last part held out", short_forced_swing({.drag = 2}), held_out},
      {"under a force, a part of it", short_forced_swing({}), part},
      {"under a force, rows missing",
       short_forced_swing({}, 0,
                          [](ForcedSynthetic& record) {
                            for (std::size_t i = 0; i < 400; ++i)
                              if (i % 90 > 84) record.y[i] = std::nan("");
                          }),
       under_force("viscous")},
      {"under a force, strongly damped", short_forced_swing({.w0 = 6, .g = 7}), under_force("viscous")},
      {"under a force that says little",
       short_forced_swing({}, 0,
                          [](ForcedSynthetic& record) {
                            std::mt19937_64 engine(7);
                            std::normal_distribution<double> normal;
                            for (double& y : record.y) y += 0.05 * normal(engine);
                          }),
       under_force()},
      {"under a force, its zero far off", short_forced_swing({.offset = 3, .equilibrium = 0.5}),
       under_force("viscous")},
      {"under a force, quadratic", short_forced_swing({.quadratic = 90}), under_force()},
      {"driven, velocities", driven_velocities, at_known},
      {"driven, shortly", driven_swing(swing(1, 0.1), 3, 1.3, even_times(150, 0.02)), at_known},
      {"driven, with the body's mass", driven_swing(swing(1, 0.1), 3, 1.3, even_times(400, 0.02)), weighed},
  });
}

/// Two lines, each with its decay, and what may be asked of them.
auto cases_of_two_lines() {
  const std::vector<double> t = even_times(450, 0.05);
  const auto lines = [&](double a, double f, double at, double g = 0.05, double noise = 3e-4) {
    std::vector<double> y;
    for (const double s : t)
      y.push_back(0.02 + 0.08 * std::exp(-g * s) * std::cos(6 * s) +
                  0.08 * a * std::exp(-f * s) * std::cos(at * s + 1));
    return file_of(t, {noisy(y, noise)}, "Time (s),Position (m)");
  };
  const auto asking = [](const char* drive, const char* law = "auto") {
    FitOptions options = of_law(law);
    options.drive_frequency = drive;
    return options;
  };
  Motion begun = swing(1, 0.05, 0);
  begun.velocity = 0;
  FitOptions alone = of_law("auto");
  alone.recognise_drive = false;
  const auto second_mode = [&](double a) {
    return Case{fmt::format("a second mode of {}", a), lines(a, 0.05, 9)};
  };
  const auto steady = [&](double a) { return Case{fmt::format("a steady line of {}", a), lines(a, 0, 9)}; };
  const auto falling = [&](double f) {
    return Case{fmt::format("a line that falls by {} a second", f), lines(0.5, f, 9)};
  };
  return std::to_array<Case>({
      second_mode(0.006),
      second_mode(0.02),
      second_mode(0.08),
      second_mode(0.4),
      second_mode(1.0),
      steady(0.01),
      steady(0.1),
      steady(0.5),
      falling(0.002),
      falling(0.006),
      {"a steady line, and a swing that lasts", lines(0.7, 0, 9, 0)},
      {"a steady line, whatever drives it", lines(0.5, 0, 9), alone},
      {"two modes, named a drive", lines(0.5, 0.05, 9), asking("1.4324 Hz")},
      {"two modes, sought a drive", lines(0.5, 0.05, 9), asking("auto")},
      {"two steady lines, named a drive", lines(0.7, 0, 9, 0), asking("1.4324 Hz")},
      {"two steady lines, sought a drive", lines(0.7, 0, 9, 0), asking("auto")},
      {"a free swing, named a drive", lines(0, 0, 9), asking("1.4324 Hz")},
      {"a free swing, sought a drive", lines(0, 0, 9), asking("auto")},
      {"a free swing, its own frequency named", lines(0, 0, 9), asking("0.955 Hz")},
      {"a weak drive, named", lines(0.02, 0, 9), asking("1.4324 Hz", "viscous")},
      {"driven from rest", driven_swing(begun, 1, 1.2, t)},
      {"driven from rest, its frequency named", driven_swing(begun, 1, 1.2, t), asking("1.2 Hz")},
      {"two lines of noise", lines(0.5, 0.05, 9, 0.05, 0.05)},
  });
}

std::string line_of(const char* kind, const std::string& name, const Estimate& e) {
  return fmt::format("  {} {} = {:.9g} ~ {:.6g}\n", kind, name, e.value, e.standard_error);
}

std::string codes_of(const std::vector<Notice>& notices) {
  std::string codes;
  for (const Notice& each : notices) {
    codes += "  notice " + each.code;
    for (const NoticeValue& value : each.values) {
      if (const auto* number = std::get_if<double>(&value.value))
        codes += fmt::format(" {}={:.5g}", value.name, *number);
      if (const auto* count = std::get_if<long long>(&value.value))
        codes += fmt::format(" {}={}", value.name, *count);
    }
    codes += "\n";
  }
  return codes;
}

std::string entry_of(const FittedRecording& fitted) {
  std::string text =
      fmt::format("  {}, {} of {} samples, law {}, {} iterations, rms {:.7g}, lag {:.5g}\n", fitted.status(),
                  fitted.used(), fitted.samples, to_text(fitted.fit.law), fitted.fit.iterations,
                  fitted.fit.residual.rms, fitted.fit.residual.autocorrelation);
  if (!fitted.fit.message.empty()) text += codes_of(std::vector<Notice>{fitted.fit.message});
  for (const Parameter& each : fitted.parameters) text += line_of("found", each.name, each.estimate);
  for (const Parameter& each : fitted.derived) text += line_of("derived", each.name, each.estimate);
  for (const Candidate& each : fitted.candidates)
    text += fmt::format("  candidate {} {:.4g} {:.6g} {}\n", to_text(each.law), each.rms, each.bic,
                        each.between_samples);
  for (const DecaySegment& each : fitted.segments)
    text += line_of("segment", fmt::format("{:.6g} to {:.6g}", each.from, each.to), each.rate);
  if (fitted.decay_rate_mean) text += line_of("segments", "mean", *fitted.decay_rate_mean);
  for (const AmplitudeRate& each : fitted.decay_by_amplitude)
    text += line_of("at", fmt::format("{:.5g} law {:.5g}", each.amplitude, each.law_rate), each.rate);
  if (fitted.reynolds_max)
    text += line_of("Reynolds", fmt::format("at {:.5g}", fitted.reynolds_max_t), *fitted.reynolds_max);
  if (fitted.keulegan_carpenter) text += line_of("Keulegan", "Carpenter", *fitted.keulegan_carpenter);
  for (const Contribution& each : fitted.stiffness_budget)
    text += fmt::format("  budget {} {:.6g}\n", each.quantity, each.share);
  for (const Mode& each : fitted.modes)
    text += line_of("mode", "frequency", each.angular_frequency) + line_of("mode", "decay", each.decay_rate) +
            fmt::format("  mode amplitude {:.6g} ~ {:.5g}\n", each.amplitude, each.amplitude_error);
  if (fitted.held_out)
    text += fmt::format("  held out {} from {:.5g} to {:.5g}: {:.6g}\n", fitted.held_out->samples,
                        fitted.held_out->from, fitted.held_out->to, fitted.held_out->rms);
  return text + codes_of(fitted.notices);
}

std::string entry_of(const Case& each) {
  std::atomic<int> looks = 0;
  Watch watch;
  watch.pulse = [&looks] { ++looks; };
  const auto fitted = fit(each.bytes, "file.csv", each.options, watch);
  std::string text = each.name + "\n";
  if (!fitted) return text + codes_of(std::vector<Notice>{fitted.error().notice});
  for (const FittedRecording& run : *fitted) text += entry_of(run);
  return text + fmt::format("  looks {}\n", looks.load());
}

struct ModesCase {
  std::string name;
  MadeChannels channels;
  std::string unit = "Acceleration {} (m/s^2)";
  ModesOptions options{};
};

auto modes_cases() {
  const std::vector<TrueMode> three{
      {1.1, 0.01, {0.5, 0.8, 1.0}}, {3.2, 0.015, {1.0, 0.5, -0.8}}, {4.6, 0.02, {0.8, -1.0, 0.4}}};
  const std::vector<TrueMode> near{{0.70, 0.003, {1.0, 1.0}}, {0.73, 0.003, {1.0, -1.0}}};
  ModesOptions some;
  some.modes = 1;
  ModesOptions between;
  between.from_frequency = 2 * std::numbers::pi * 2;
  between.to_frequency = 2 * std::numbers::pi * 4;
  ModesOptions simulated;
  simulated.of_method = "newmark";
  simulated.step = 0.05;
  MadeChannels late = let_go(near, {0.05, 0.04}, 1500, 0.05, 0.01, 6);
  for (auto& channel : late.values) channel.insert(channel.begin(), 60, 0);
  const std::string angle = "Angle {} (rad)";
  return std::to_array<ModesCase>({
      {"two masses under random forces", under_white_forces(two_masses(), 6000, 0.05, 1)},
      {"three masses under random forces", under_white_forces(three, 9000, 0.04, 2)},
      {"three masses, between two frequencies", under_white_forces(three, 6000, 0.04, 3),
       "Acceleration {} (m/s^2)", between},
      {"a short record of random forces", under_white_forces(two_masses(), 800, 0.05, 4)},
      {"two masses let go", let_go(two_masses(), {0.3, 0.1}, 800, 0.05, 0.01, 3)},
      {"two masses let go, noisy", let_go(two_masses(), {0.3, 0.1}, 800, 0.05, 0.2, 3)},
      {"three masses let go, one mode", let_go(three, {0.3, 0.1, 0.05}, 900, 0.04, 0.02, 5),
       "Position {} (m)", some},
      {"pendulums let go", let_go(near, {0.05, 0.04}, 1500, 0.05, 0.01, 6), angle},
      {"pendulums let go late", late, angle},
      {"simulated by average acceleration", let_go(near, {0.05, 0.04}, 1500, 0.05, 0.001, 7), angle,
       simulated},
  });
}

std::string entry_of(const ModesCase& each) {
  std::string header = "Time (s)", text = each.name + "\n";
  for (std::size_t i = 0; i < each.channels.values.size(); ++i)
    header += "," + fmt::format(fmt::runtime(each.unit), i + 1);
  std::vector<double> t;
  for (std::size_t i = 0; i < each.channels.values[0].size(); ++i)
    t.push_back(static_cast<double>(i) * each.channels.step);
  const auto recording = read_recording(file_of(t, each.channels.values, header), "file.csv", {});
  const auto found = recording ? recording_modes(*recording, each.options) : recording.error();
  if (!found) return text + codes_of(std::vector<Notice>{found.error().notice});
  if (!found->ok()) text += codes_of(std::vector<Notice>{found->message});
  for (const NaturalMode& mode : found->modes) {
    text +=
        line_of("mode", "frequency", mode.frequency) + line_of("mode", "damping ratio", mode.damping_ratio);
    for (std::size_t i = 0; i < mode.shape.size(); ++i)
      text += line_of("shape", "real", {mode.shape[i].real(), mode.shape_error[i].real()}) +
              line_of("shape", "imaginary", {mode.shape[i].imag(), mode.shape_error[i].imag()});
    for (const ModeByMethod& by : mode.methods)
      text += fmt::format("  by {}: {:.7g} {:.7g}\n", by.method, by.frequency().value_or(0),
                          by.damping_ratio().value_or(0));
  }
  if (found->recording) text += codes_of(std::vector<Notice>{found->recording->words});
  return text + codes_of(found->notices);
}

struct NetworkCase {
  std::string name, network, missing{};  ///< of the network's values those behind "?" are sought
  std::size_t samples = 600;
  double step = 0.05, noise = 5e-4;
  std::size_t still = 0;
  double from = 0;
};

const std::string two_pendulums = R"([[mass]]
name = "left"
inertia = "0.05 kg m²"
position = "0.12 rad"
[[mass]]
name = "right"
inertia = "0.05 kg m²"
[[link]]
to = "left"
stiffness = "?0.981 N m"
damping = "?0.0006 N m s"
[[link]]
to = "right"
stiffness = "?0.992 N m"
damping = "?0.0008 N m s"
[[link]]
from = "left"
to = "right"
stiffness = "?0.031 N m"
)";

auto network_cases() {
  std::string beside = two_pendulums;
  beside += "[[link]]\nfrom = \"left\"\nto = \"right\"\nstiffness = \"?0.01 N m\"\n";
  return std::to_array<NetworkCase>({
      {"two pendulums", two_pendulums},
      {"two pendulums, noisy", two_pendulums, "", 400, 0.05, 0.01},
      {"two pendulums, coarse", two_pendulums, "", 150, 0.19, 1e-3},
      {"two pendulums, samples missing", two_pendulums, "some"},
      {"two pendulums, a part missing", two_pendulums, "part"},
      {"two pendulums let go late", two_pendulums, "", 500, 0.05, 0, 80},
      {"two pendulums, the end", two_pendulums, "", 600, 0.05, 5e-4, 0, 14},
      {"two pendulums, shortly", two_pendulums, "", 45, 0.04, 1e-4},
      {"two pendulums, two springs side by side", beside},
  });
}

std::string entry_of(const NetworkCase& each) {
  std::string known = each.network, open;
  for (std::size_t at; (at = known.find('?')) != std::string::npos;) known.erase(at, 1);
  for (std::size_t i = 0; i < each.network.size(); ++i) {
    open += each.network[i];
    if (each.network[i] == '?') i = each.network.find('"', i) - 1;
  }
  const auto truth = read_network(known, "n.toml");
  const auto asked = read_network_file(open, "n.toml");
  if (!truth.ok() || !asked.ok()) return "no network\n";
  NetworkSwings swings = swings_of(*truth, each.samples, each.step, each.noise, 4);
  for (std::size_t n = 0; n < each.samples; ++n) {
    if (each.missing == "some" && n % 37 > 32) swings.y[n % 2][n] = std::nan("");
    if (each.missing == "part" && n % 300 > 200) swings.y[1][n] = std::nan("");
  }
  for (std::size_t n = 0; n < each.still; ++n) {
    for (auto& column : swings.y) column.insert(column.begin(), column.front());
    swings.t.push_back(swings.t.back() + each.step);
  }
  std::string header = "Time (s)";
  const char* column = asked->network.angles ? "Angle {} (rad)" : "Position {} (m)";
  for (std::size_t i = 1; i <= swings.y.size(); ++i) header += "," + fmt::format(fmt::runtime(column), i);
  FitOptions options;
  if (each.from > 0) options.from = each.from;
  std::atomic<int> looks = 0;
  Watch watch;
  watch.pulse = [&looks] { ++looks; };
  const auto recording = read_recording(file_of(swings.t, swings.y, header), "file.csv", {});
  const auto found =
      recording ? fit_network(*recording, *asked, "n.toml", options, watch) : recording.error();
  std::string text = each.name + "\n";
  if (!found) return text + codes_of(std::vector<Notice>{found.error().notice});
  if (!found->succeeded()) text += codes_of(std::vector<Notice>{found->message});
  text += fmt::format("  {} iterations, {:.5g} independent samples\n", found->fit.iterations,
                      found->fit.independent_samples);
  for (std::size_t link = 0; link < asked->network.links.size(); ++link)
    for (const Parameter& value : found->found_of(link))
      text += line_of("found", fmt::format("{} {}", link, value.name), value.estimate);
  for (const FittedColumn& of : found->fit.columns)
    text += line_of("column", "position", of.position) + line_of("column", "velocity", of.velocity) +
            line_of("column", "offset", of.offset) +
            fmt::format("  column rms {:.6g} explained {:.7g}\n", of.rms, of.explained);
  return text + codes_of(found->notices) + fmt::format("  looks {}\n", looks.load());
}

/// A value to a five hundredth of its standard error, which stands behind it after "~"; other numbers, and
/// these errors, to one in five thousand.
bool same_entry(const std::string& one, const std::string& other) {
  std::istringstream words(one), now(other);
  double value = 0, value_now = 0;
  bool is_error = false, open = false;
  for (std::string a, b;;) {
    const bool more = static_cast<bool>(words >> a);
    if (static_cast<bool>(now >> b) != more) return false;
    if (!more) return !open;
    const auto number = [](const std::string& word) -> std::optional<double> {
      const std::size_t from = word.find_last_of("=") + 1;
      double read = 0;
      const char* const end = word.data() + word.size();
      const auto [stopped, error] = std::from_chars(word.data() + from, end, read);
      return error == std::errc() && stopped == end ? std::optional(read) : std::nullopt;
    };
    const auto x = number(a), y = number(b);
    if (a == "~" && b == "~") {
      is_error = true;
      continue;
    }
    if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) {
      if (open || a != b) return false;
      is_error = false;
      continue;
    }
    const bool near = std::abs(*x - *y) <= 2e-4 * std::max(std::abs(*x), std::abs(*y)) + 1e-12;
    if (is_error && !near) return false;
    if (is_error && !(std::abs(value - value_now) <= 2e-3 * *x + 1e-9 * std::abs(value) + 1e-12))
      return false;
    if (!is_error && open) return false;
    open = !is_error && !near;  // unless its error follows
    is_error = false;
    value = *x;
    value_now = *y;
  }
}

const std::string title =
    "What comes of recordings, and the work that it takes: tests/tasks/ledger_test.cpp makes this file.\n";

/// What the file says of one case, up to the next empty line.
std::string said_before(const std::string& name) {
  static const std::string all = bytes_of(ledger_file);
  const std::size_t at = all.find("\n\n" + name + "\n");
  if (at == std::string::npos) return "";
  return all.substr(at + 2, all.find("\n\n", at + 2) - at - 1);
}

void expect_as_before(const std::string& name, const std::string& entry) {
  if (std::getenv("CROMER_WRITE_TRANSCRIPTS")) {
    const bool is_first = name == free_cases().front().name;
    std::ofstream(ledger_file, is_first ? std::ios::trunc : std::ios::app) << (is_first ? title : "") << "\n"
                                                                           << entry;
    return;
  }
  std::istringstream then(said_before(name)), now(entry);
  for (std::string one, other;;) {
    const bool more = static_cast<bool>(std::getline(then, one)),
               more_now = static_cast<bool>(std::getline(now, other));
    if (!more && !more_now) break;
    ASSERT_TRUE(more && more_now && same_entry(one, other)) << name << "\nthen " << one << "\nnow  " << other;
  }
}

class LedgerOf : public testing::TestWithParam<std::size_t> {};
class LedgerOfDriven : public LedgerOf {};
class LedgerOfTwoLines : public LedgerOf {};
class LedgerOfModes : public LedgerOf {};
class LedgerOfNetworks : public LedgerOf {};

TEST_P(LedgerOf, FreeSwings) {
  const Case each = free_cases()[GetParam()];
  expect_as_before(each.name, entry_of(each));
}

TEST_P(LedgerOfDriven, Swings) {
  const Case each = driven_cases()[GetParam()];
  expect_as_before(each.name, entry_of(each));
}

TEST_P(LedgerOfTwoLines, Recordings) {
  const Case each = cases_of_two_lines()[GetParam()];
  expect_as_before(each.name, entry_of(each));
}

TEST_P(LedgerOfModes, Recordings) {
  const ModesCase each = modes_cases()[GetParam()];
  expect_as_before(each.name, entry_of(each));
}

TEST_P(LedgerOfNetworks, Swings) {
  const NetworkCase each = network_cases()[GetParam()];
  expect_as_before(each.name, entry_of(each));
}

/// How many there are, without making one.
template <auto make>
auto each_of() {
  return testing::Range<std::size_t>(0, std::tuple_size_v<decltype(make())>);
}

INSTANTIATE_TEST_SUITE_P(Each, LedgerOf, each_of<free_cases>());
INSTANTIATE_TEST_SUITE_P(Each, LedgerOfDriven, each_of<driven_cases>());
INSTANTIATE_TEST_SUITE_P(Each, LedgerOfTwoLines, each_of<cases_of_two_lines>());
INSTANTIATE_TEST_SUITE_P(Each, LedgerOfModes, each_of<modes_cases>());
INSTANTIATE_TEST_SUITE_P(Each, LedgerOfNetworks, each_of<network_cases>());

}  // namespace CROMER_FILE
}  // namespace cromer::core
