// All that fits of many small records give, in tests/identify/numbers (written anew as
// tests/support/number_sheet.h says): values, errors, intervals, correlations, statistics, notices, and how
// often the work looked whether to stop. What the numbers should be is asked elsewhere.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "cromer/identify/choose/kind_of_motion.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/fit_viscous.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/network_truth.h"
#include "tests/identify/synthetic.h"
#include "tests/support/number_sheet.h"

namespace cromer::core {
namespace CROMER_FILE {

const std::filesystem::path fit_numbers = std::filesystem::path(CROMER_SOURCE_DIR) / "tests/identify/numbers";

constexpr double enough_steps = 1e10;

struct Fitted {
  std::string name;
  std::vector<double> t, y, force{};
  LawFitOptions options{};
  int derivative = 0;
  double resolution = 0, clock_error = 0;
  std::optional<BetweenSamples> between{};

  Record record() const { return {t, y, resolution, derivative, clock_error}; }
};

void write_fit(test::NumberSheet& sheet, const std::string& name, const LawFit& fit, int looks) {
  std::string codes;
  if (!fit.message.empty()) codes += " (" + fit.message.code + ")";
  for (const Notice& each : fit.notices) codes += " " + each.code;
  sheet.row(name + codes, {static_cast<double>(fit.status), static_cast<double>(fit.iterations),
                           static_cast<double>(fit.fitted), static_cast<double>(looks)});
  std::vector<double> values, errors, lows, highs, correlations;
  const std::size_t n = fit.estimates.size();
  for (const Estimate& each : fit.estimates) {
    values.push_back(each.value);
    errors.push_back(each.standard_error);
    lows.push_back(each.low);
    highs.push_back(each.high);
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      correlations.push_back(fit.covariance[i * n + j] /
                             (fit.estimates[i].standard_error * fit.estimates[j].standard_error));
  sheet.row("  values", values);
  sheet.row("  errors", errors);
  sheet.row("  low", lows);
  sheet.row("  high", highs);
  sheet.row("  correlations", correlations);
  sheet.row("  rms, independent, t", {fit.residual.rms, fit.independent_samples, fit.student});
  sheet.row("  explained", {fit.explained});
  sheet.row("  criterion", {fit.bic});
  sheet.row("  step, outliers", {fit.step, static_cast<double>(fit.outliers.size())});
}

void write_fitted(test::NumberSheet& sheet, const Fitted& each) {
  LawFitOptions options = each.options;
  if (each.between) options.drive = Drive::recorded({each.force, 0, each.t[1] - each.t[0], *each.between});
  std::atomic<int> looks = 0;
  Watch watch;
  watch.pulse = [&looks] { ++looks; };
  watch.steps_left = std::make_shared<std::atomic<double>>(enough_steps);
  const LawFit fit = fit_law(each.record(), options, watch);
  write_fit(sheet, each.name, fit, looks.load());
  sheet.row("  steps", {enough_steps - *watch.steps_left});
}

Motion law_motion(const char* law) {
  Motion motion{.equilibrium = 0.1, .position = 0.4, .velocity = 0.3};
  motion.law = law_of(law);
  motion.set_angular_frequency(6);
  if (motion.law.has<Viscous>()) motion.set_decay_rate(0.12);
  Oscillator<double>& o = motion.per_mass;
  if (motion.law.has<Drag>()) o.drag = 0.4;
  if (motion.law.has<Friction>()) o.friction = motion.law.has<Viscous>() ? 0.2 : 0.7;
  if (motion.law.has<Cubic>()) o.cubic = 60;
  if (motion.law.has<Quadratic>()) o.quadratic = 12;
  if (motion.law.has<OddQuadratic>()) o.odd_quadratic = 25;
  if (motion.law.has<Quintic>()) o.quintic = 150;
  if (motion.law.has<VanDerPol>()) o.van_der_pol = 2;
  if (motion.law.has<Pendulum>()) motion.position = 1.3;
  if (motion.law.has<Hysteresis>())
    o.hysteresis_stiffness = 12, o.hysteresis_beta = 30, o.hysteresis_gamma = 10;
  return motion;
}

Fitted free_one(std::string name, const Motion& motion, const char* law, double noise = 2e-3,
                const std::vector<double>& t = even_times(240, 0.06), int derivative = 0) {
  Fitted one{std::move(name), t, noisy(observed_motion(motion, {}, t, derivative, 0.005), noise)};
  one.options.law = law_of(law);
  one.derivative = derivative;
  return one;
}

Fitted with_options(Fitted one, const std::function<void(Fitted&)>& change) {
  change(one);
  return one;
}

TEST(WithinSteps, SoManyForEachSample) {
  const std::vector<double> t = even_times(100, 0.1), y(100);
  EXPECT_EQ(*within_steps({}, {t, y}, DriveKind::none).steps_left, 8e5 + 3000.0 * 100);
  EXPECT_EQ(*within_steps({}, {t, y}, DriveKind::harmonic).steps_left, 8e5 + 3000.0 * 100);
  EXPECT_EQ(*within_steps({}, {t, y}, DriveKind::recorded).steps_left, 8e5 + 20'000.0 * 100);
  Watch few;
  few.steps_left = std::make_shared<std::atomic<double>>(7);
  EXPECT_EQ(within_steps(few, {t, y}, DriveKind::none).steps_left, few.steps_left);
}

TEST(CountingPasses, RisesByEverLess) {
  std::vector<double> told;
  Watch whole;
  EXPECT_FALSE(counting_passes(whole).pulse);
  whole.progress = [&](double share) { told.push_back(share); };
  const Watch counting = counting_passes(whole);
  for (int i = 0; i < 60; ++i) EXPECT_FALSE(counting.interrupted());
  ASSERT_EQ(told.size(), 60u);
  EXPECT_DOUBLE_EQ(told[0], 1 / 21.0);
  EXPECT_DOUBLE_EQ(told[19], 0.5);
  EXPECT_DOUBLE_EQ(told[59], 0.75);
}

TEST(FirstPeriods, AreAtLeast32SamplesOrAll) {
  const std::vector<double> t = even_times(100, 0.1), y(100);
  const auto samples = [&](std::size_t n, double periods) {
    return first_periods({std::span(t).first(n), std::span(y).first(n)}, 2 * std::numbers::pi, periods)
        .t.size();
  };
  EXPECT_EQ(samples(100, 4.95), 50u);
  EXPECT_EQ(samples(100, 8.05), 81u);
  EXPECT_EQ(samples(100, 2), 32u);
  EXPECT_EQ(samples(100, 20), 100u);
  EXPECT_EQ(samples(20, 1), 20u);
}

TEST(FitsWrittenDown, OfFreeMotions) {
  test::NumberSheet sheet;
  const auto write = [&](const Fitted& one) { write_fitted(sheet, one); };
  for (const char* law :
       {"viscous", "viscous+drag", "friction", "viscous+friction", "viscous+drag+friction", "viscous+cubic",
        "viscous+quadratic", "viscous+quadratic+cubic", "viscous+odd-quadratic", "viscous+quintic",
        "viscous+pendulum", "viscous+van-der-pol", "viscous+drag+cubic"})
    for (const int derivative : {0, 1, 2})
      write(free_one(fmt::format("{}, derivative {}", law, derivative), law_motion(law), law,
                     derivative == 0 ? 2e-3 : 2e-2, even_times(240, 0.06), derivative));
  write(free_one("hysteresis", law_motion("viscous+hysteresis"), "viscous+hysteresis"));
  // Another law.
  for (const char* law :
       {"viscous+drag", "friction", "viscous+friction", "viscous+cubic", "viscous+quadratic",
        "viscous+pendulum", "drag", "viscous+quadratic+cubic", "viscous+drag+friction"})
    write(free_one(std::string("viscous, by ") + law, law_motion("viscous"), law));
  write(free_one("drag, by friction", law_motion("viscous+drag"), "viscous+friction"));
  write(free_one("friction, by drag", law_motion("friction"), "viscous+drag"));
  write(free_one("cubic, by viscous", law_motion("viscous+cubic"), "viscous"));
  write(free_one("pendulum, by viscous", law_motion("viscous+pendulum"), "viscous"));
  write(free_one("pendulum, by cubic", law_motion("viscous+pendulum"), "viscous+cubic"));
  // Damping.
  for (const double g : {0.0, 0.6, 2.0, 4.5, 5.9, 7.0}) {
    Motion motion = law_motion("viscous");
    motion.set_decay_rate(g);
    for (const char* law : {"viscous", "viscous+drag", "viscous+friction"})
      write(free_one(fmt::format("decay rate {}, {}", g, law), motion, law));
  }
  // To rest within few half swings, and at the end of the band.
  for (const double friction : {1.0, 2.0, 3.1, 4.0, 6.0}) {
    Motion motion = law_motion("friction");
    motion.per_mass.friction = friction;
    write(free_one(fmt::format("friction {}", friction), motion, "friction", 4e-3, even_times(140, 0.03)));
  }
  Motion stopped = law_motion("viscous+friction");
  stopped.per_mass.friction = 1.6;
  write(free_one("viscous and friction, to rest", stopped, "viscous+friction", 1e-2, even_times(160, 0.03)));
  sheet.expect_as_in(fit_numbers / "free_fits.txt");
}

TEST(FitsWrittenDown, AsTheyAreAskedFor) {
  test::NumberSheet sheet;
  const auto write = [&](const Fitted& one) { write_fitted(sheet, one); };
  const Motion plain = law_motion("viscous"), drag = law_motion("viscous+drag");
  const auto changed = [&](const char* name, const Motion& motion, const char* law,
                           const std::function<void(Fitted&)>& change) {
    write(with_options(free_one(name, motion, law), change));
  };
  for (const double step : {0.001, 0.02, 0.1, 0.3})
    for (const char* law : {"viscous", "viscous+drag"}) {
      changed("rounded", plain, law, [=](Fitted& one) {
        for (double& y : one.y) y = step * std::round(y / step);
        one.resolution = step;
      });
    }
  changed("rounded about another zero", plain, "viscous+drag", [](Fitted& one) {
    for (double& y : one.y) y = 0.013 + 0.05 * std::round((y - 0.013) / 0.05);
    one.resolution = 0.05;
  });
  changed("its clock is off", plain, "viscous", [](Fitted& one) { one.clock_error = 1e-3; });
  changed("its clock is off, drag", drag, "viscous+drag", [](Fitted& one) { one.clock_error = 1e-3; });
  changed("at most two iterations", drag, "viscous+drag",
          [](Fitted& one) { one.options.iteration_limit = 2; });
  changed("at most one iteration", plain, "viscous", [](Fitted& one) { one.options.iteration_limit = 1; });
  for (const double tolerance : {1e-4, 1e-2})
    changed("to a tolerance", drag, "viscous+drag", [=](Fitted& one) { one.options.tolerance = tolerance; });
  for (const double beat : {4e-4, 9e-4, 1.5e-3, 1.9e-3, 2.2e-3})
    changed("to beat", drag, "viscous+drag", [=](Fitted& one) { one.options.rms_to_beat = beat; });
  for (const double beat : {1e-3, 5e-3})
    changed("to beat by a wrong law", law_motion("viscous+pendulum"), "viscous+friction",
            [=](Fitted& one) { one.options.rms_to_beat = beat; });
  for (const std::size_t samples : {40, 100, 240})
    changed("from a known motion", drag, "viscous+drag", [&, samples](Fitted& one) {
      Motion start = plain;
      start.set_angular_frequency(6.05);
      one.options.start = KnownMotion{start.under(law_of("viscous+drag")), samples, 0.1};
    });
  Motion growing = plain;
  growing.set_decay_rate(-0.1);
  for (const bool may : {false, true})
    for (const char* law : {"viscous", "viscous+drag", "viscous+cubic"})
      changed("growing", growing, law, [=](Fitted& one) { one.options.may_grow = may; });
  for (const bool every : {false, true})
    for (const char* law : {"viscous", "viscous+drag"})
      changed("outliers", plain, law, [=](Fitted& one) {
        for (std::size_t i = 11; i < one.y.size(); i += 47) one.y[i] += 0.15;
        one.options.every_sample = every;
      });
  changed("hysteresis of another exponent", law_motion("viscous+hysteresis"), "viscous+hysteresis",
          [](Fitted& one) { one.options.hysteresis_exponent = 2; });
  // Noise that is no white one.
  const auto wandering = [](Fitted& one) {
    std::mt19937_64 engine(9);
    std::normal_distribution<double> normal(0, 4e-3);
    double at = 0;
    for (double& y : one.y) y += at = 0.8 * at + normal(engine);
  };
  changed("wandering noise", plain, "viscous", wandering);
  changed("wandering noise", drag, "viscous+drag", wandering);
  const auto loud_once = [](Fitted& one) {
    std::mt19937_64 engine(9);
    std::normal_distribution<double> normal(0, 3e-2);
    for (std::size_t i = 60; i < 100; ++i) one.y[i] += normal(engine);
  };
  changed("loud at one time", plain, "viscous", loud_once);
  changed("loud at one time", drag, "viscous+drag", loud_once);
  for (const double noise : {0.05, 0.3, 1.0})
    for (const char* law : {"viscous", "viscous+drag", "viscous+cubic"})
      write(free_one(fmt::format("noise {}, {}", noise, law), plain, law, noise));
  for (const std::size_t n : {8, 11, 20, 33, 63, 66, 120})
    for (const char* law : {"viscous", "viscous+drag"})
      write(free_one(fmt::format("{} samples, {}", n, law), drag, law, 2e-3, even_times(n, 0.11)));
  for (const double h : {0.002, 0.01, 0.3, 0.49})
    write(free_one(fmt::format("steps of {}", h), drag, "viscous+drag", 2e-3, even_times(300, h)));
  std::vector<double> some;
  for (int i = 0; i < 500; ++i)
    if (i % 40 < 13) some.push_back(0.06 * i);
  for (const char* law : {"viscous", "viscous+drag", "viscous+cubic"})
    write(free_one(std::string("bursts, ") + law, drag, law, 2e-3, some));
  sheet.expect_as_in(fit_numbers / "fits_as_asked.txt");
}

TEST(FitsWrittenDown, OfDrivenMotions) {
  test::NumberSheet sheet;
  const auto t = even_times(260, 0.06);
  const auto one_of = [&](const char* truth, const char* law, double drive, double amplitude, int derivative,
                          double noise = 4e-3) {
    Motion motion = law_motion(truth);
    motion.cosine = amplitude;
    motion.sine = 0.5 * amplitude;
    motion.drive_frequency = drive;
    Fitted one{fmt::format("{} at {}, by {}, derivative {}", truth, drive, law, derivative), t,
               noisy(observed_motion(motion, Drive::harmonic(), t, derivative, 0.005), noise)};
    one.options.law = law_of(law);
    one.options.drive = Drive::harmonic();
    one.derivative = derivative;
    return one;
  };
  for (const double drive : {3.5, 5.6, 6.1, 9.0})
    for (const bool known : {false, true})
      for (const char* law : {"viscous", "viscous+drag"}) {
        Fitted one = one_of(law, law, drive, 4, 0);
        if (known) one.options.drive_frequency = 1.003 * drive;
        write_fitted(sheet, one);
      }
  for (const char* law : {"viscous+friction", "viscous+cubic", "viscous+quadratic", "viscous+pendulum"})
    write_fitted(sheet, with_options(one_of(law, law, 8, 5, 0),
                                     [](Fitted& one) { one.options.drive_frequency = 8.02; }));
  for (const int derivative : {1, 2})
    for (const char* law : {"viscous", "viscous+drag"})
      write_fitted(sheet, one_of(law, law, 8, 5, derivative));
  write_fitted(sheet, one_of("viscous", "viscous+drag", 8, 5, 0));
  write_fitted(sheet, one_of("viscous", "viscous", 8, 0.02, 0));
  write_fitted(sheet, one_of("viscous", "viscous", 8, 5, 0, 0.4));
  write_fitted(sheet, one_of("viscous+cubic", "viscous", 8, 9, 0));
  sheet.expect_as_in(fit_numbers / "driven_fits.txt");
}

TEST(FitsWrittenDown, OfForcedMotions) {
  test::NumberSheet sheet;
  const auto write = [&](const std::string& name, const ForcedTruth& truth, const char* law,
                         BetweenSamples between, int derivative = 0, double noise = 1e-3) {
    const auto acting = multisine(14, 6);
    std::vector<double> samples;
    for (int i = 0; i < 240; ++i) samples.push_back(acting(0.05 * i));
    const auto force = between == BetweenSamples::band_limited
                           ? acting
                           : read_between(samples, 0.05, between == BetweenSamples::hold);
    const ForcedSynthetic record = forced_synthetic(truth, force, 240, 0.05, noise, 4, derivative);
    Fitted one{name + ", by " + law, record.t, record.y, record.force};
    one.options.law = law_of(law);
    one.derivative = derivative;
    one.between = between;
    write_fitted(sheet, one);
  };
  for (const auto between : {BetweenSamples::linear, BetweenSamples::hold, BetweenSamples::band_limited})
    write(fmt::format("reading {}", static_cast<int>(between)), {}, "viscous", between);
  const auto linear = BetweenSamples::linear;
  for (const char* law : {"viscous+drag", "viscous+quadratic", "viscous+cubic", "viscous+quadratic+cubic",
                          "viscous+odd-quadratic", "viscous+friction"})
    write("drag", {.drag = 2}, law, linear);
  write("cubic", {.cubic = 300}, "viscous+cubic", linear);
  write("cubic, its zero near", {.cubic = 300, .offset = 0.5, .equilibrium = 0.01}, "viscous+cubic", linear);
  write("quadratic", {.quadratic = 60}, "viscous+quadratic", linear);
  write("zero far off", {.offset = 1, .equilibrium = 2}, "viscous", linear);
  write("zero far off", {.offset = 1, .equilibrium = 2}, "viscous+quadratic", linear);
  write("cubic, zero far off", {.cubic = 300, .offset = 1, .equilibrium = 2}, "viscous+quadratic+cubic",
        linear);
  write("velocities", {}, "viscous", linear, 1);
  write("accelerations", {}, "viscous", linear, 2, 0.05);
  write("no spring", {.w0 = 0.001, .g = 0.4}, "damping", linear);
  write("no spring, velocities", {.w0 = 0.001, .g = 0.4}, "damping", linear, 1);
  write("noise", {}, "viscous", linear, 0, 0.1);
  write("a wrong law", {.cubic = 2000}, "viscous", linear);
  sheet.expect_as_in(fit_numbers / "forced_fits.txt");
}

/// A choice: the chosen law, what was tried, and how it told of its progress.
void write_choice(test::NumberSheet& sheet, const Fitted& each, const GivenLaw& given = {}) {
  LawFitOptions options = each.options;
  if (each.between) options.drive = Drive::recorded({each.force, 0, each.t[1] - each.t[0], *each.between});
  std::atomic<int> looks = 0;
  std::vector<double> shares;
  Watch watch;
  watch.pulse = [&looks] { ++looks; };
  watch.progress = [&shares](double share) { shares.push_back(share); };
  watch.steps_left = std::make_shared<std::atomic<double>>(enough_steps);
  const LawChoice choice = choose_law(each.record(), options, watch, given);
  write_fit(sheet, each.name + ": " + to_text(choice.chosen.law) + " " + choice.rivals.code, choice.chosen,
            looks.load());
  for (const LawFit& one : choice.candidates)
    sheet.row("  " + to_text(one.law), {static_cast<double>(one.status), one.residual.rms, one.bic,
                                        static_cast<double>(one.iterations)});
  sheet.in_short("  progress", shares);
  sheet.row("  steps", {enough_steps - *watch.steps_left});
}

TEST(FitsWrittenDown, ChosenLaws) {
  test::NumberSheet sheet;
  const auto write = [&](const char* law, const std::function<void(Fitted&)>& change = {}) {
    Fitted one = free_one(law, law_motion(law), "viscous", 2e-3, even_times(200, 0.06));
    if (change) change(one);
    write_choice(sheet, one);
  };
  for (const char* law : {"viscous", "viscous+drag", "friction", "viscous+cubic", "viscous+quadratic",
                          "viscous+quintic", "viscous+van-der-pol", "viscous+drag+cubic"})
    write(law);
  write("viscous+pendulum", [](Fitted& one) { one.options.angle = true; });
  write("viscous", [](Fitted& one) {
    for (std::size_t i = 0; i < one.y.size(); ++i) one.y[i] += 0.05 * std::cos(0.55 * static_cast<double>(i));
  });
  write("viscous", [](Fitted& one) {
    for (double& y : one.y) y = 0.1 * std::round(y / 0.1);
    one.resolution = 0.1;
  });
  write("viscous", [](Fitted& one) { one.y = noisy(std::vector<double>(one.t.size(), 0.0), 1); });
  write("viscous+drag", [](Fitted& one) { one.y[40] += 0.2, one.y[111] -= 0.3; });
  for (const std::size_t n : {8, 12, 16})
    write_choice(sheet, free_one(fmt::format("{} samples", n), law_motion("viscous+drag"), "viscous", 2e-3,
                                 even_times(n, 0.2)));
  sheet.expect_as_in(fit_numbers / "chosen_laws.txt");
}

TEST(FitsWrittenDown, ChosenLawsUnderADrive) {
  test::NumberSheet sheet;
  const auto t = even_times(160, 0.07);
  for (const char* law : {"viscous", "viscous+drag", "viscous+cubic"}) {
    Motion motion = law_motion(law);
    motion.cosine = 5;
    motion.drive_frequency = 8;
    Fitted one{std::string(law) + ", driven", t,
               noisy(observed_motion(motion, Drive::harmonic(), t, 0, 0.005), 4e-3)};
    one.options.drive = Drive::harmonic();
    write_choice(sheet, one);
  }
  const auto acting = multisine(14, 6, 24);
  const auto forced = [&](const char* name, const ForcedTruth& truth, const GivenLaw& given) {
    const ForcedSynthetic record = forced_synthetic(truth, acting, 160, 0.06, 1e-3, 4);
    Fitted one{name, record.t, record.y, record.force};
    one.between = BetweenSamples::linear;
    write_choice(sheet, one, given);
  };
  forced("forced", {}, {});
  forced("forced, linear between samples", {.drag = 2}, {{}, BetweenSamples::linear});
  forced("forced, cubic", {.cubic = 400}, {{}, BetweenSamples::band_limited});
  forced("forced, its law given", {.quadratic = 60}, {law_of("viscous+quadratic"), {}});
  sheet.expect_as_in(fit_numbers / "chosen_laws_under_a_drive.txt");
}

TEST(FitsWrittenDown, KindsOfMotion) {
  test::NumberSheet sheet;
  const auto write = [&](const std::string& name, const std::vector<double>& t,
                         const std::function<double(double)>& y, double noise, double resolution = 0) {
    std::vector<double> values;
    for (const double s : t) values.push_back(y(s));
    values = noisy(values, noise);
    const Record record{t, values, resolution};
    const LawFit free = fit_law(record, {});
    for (const bool known : {false, true}) {
      const LawFit driven = fit_driven(record, law_of("viscous"), known ? std::optional(8.0) : std::nullopt);
      const MotionJudgement judged = judge_motion(record, free, driven, known);
      sheet.row(name, {static_cast<double>(judged.kind), known ? 1.0 : 0.0});
      if (!judged.modes) continue;
      for (const Mode& mode : judged.modes->modes)
        sheet.row("  mode", {mode.angular_frequency.value, mode.angular_frequency.low,
                             mode.angular_frequency.standard_error, mode.decay_rate.value,
                             mode.decay_rate.standard_error, mode.decay_rate.high, mode.amplitude,
                             mode.amplitude_error, mode.decays() ? 1.0 : 0.0});
      sheet.row("  of both", {judged.modes->residual.rms, judged.modes->independent_samples});
    }
  };
  const auto two = [](double w, double g, double a, double f) {
    return [=](double s) {
      return std::exp(-g * s) * std::cos(w * s) + a * std::exp(-f * s) * std::cos(8 * s + 1);
    };
  };
  const auto t = even_times(300, 0.09);
  for (const double w : {5.0, 7.5, 7.9, 4.0})
    for (const double f : {0.0, 0.01, 0.05})
      write(fmt::format("{} beside 8, which decays by {}", w, f), t, two(w, 0.05, 0.6, f), 0.01);
  for (const double a : {0.3, 0.1, 0.05, 0.02, 0.01, 0.003})
    write(fmt::format("a second line of {}", a), t, two(5, 0.05, a, 0.05), 0.01);
  for (const double a : {0.1, 0.02, 0.01})
    write(fmt::format("a steady second line of {}", a), t, two(5, 0.05, a, 0), 0.01);
  for (const double f : {0.002, 0.0035, 0.005})
    write(fmt::format("a generator's line that falls by {}", f), t, two(5, 0.09, 0.6, f), 0.003);
  write("alone", t, two(5, 0.05, 0, 0), 0.01);
  write("alone and steady", t, two(5, 0, 0, 0), 0.01);
  write(
      "a cubic harmonic", t, [](double s) { return std::cos(2.6667 * s) + 0.05 * std::cos(8 * s); }, 0.01);
  write("shortly", even_times(31, 0.2), two(5, 0.05, 0.6, 0.02), 0.01);
  write("a little longer", even_times(33, 0.2), two(5, 0.05, 0.6, 0.02), 0.01);
  write("in steps", t, two(5, 0.05, 0.6, 0.02), 0.01, 0.1);
  write(
      "noise", t, [](double) { return 0.0; }, 1);
  sheet.expect_as_in(fit_numbers / "kinds_of_motion.txt");
}

TEST(FitsWrittenDown, FirstPeriods) {
  test::NumberSheet sheet;
  for (const double position : {0.3, 1.0, 2.0, 2.6})
    for (const double noise : {1e-3, 0.3}) {
      Motion motion = law_motion("viscous+pendulum");
      motion.position = position;
      const Fitted one = free_one(fmt::format("{} rad, {}", position, noise), motion, "viscous", noise);
      const LawFit fit = fit_viscous(one.record(), {}, {});
      write_fit(sheet, one.name, fit, 0);
      const auto first = fit_first_periods(one.record(), 5.5, {}, {});
      sheet.row("  first", {first ? static_cast<double>(first->samples) : 0});
      if (first) write_fit(sheet, "  by these", first->fit, 0);
    }
  sheet.expect_as_in(fit_numbers / "first_periods.txt");
}

NetworkMass mass_of(const char* name, double m, State<double> start) {
  NetworkMass one;
  one.name = name;
  one.mass = m;
  one.start = start;
  return one;
}

NetworkLink link_of(std::size_t from, std::size_t to, Oscillator<double> law) {
  NetworkLink one;
  one.from = from;
  one.to = to;
  one.law = law;
  return one;
}

Network two_masses_between_springs() {
  Network two;
  two.masses = {mass_of("left", 0.5, {0.1, 0}), mass_of("right", 0.8, {0, 0.2})};
  two.links = {link_of(ground, 0, {.stiffness = 20, .damping = 0.05}),
               link_of(0, 1, {.stiffness = 6, .damping = 0.02}), link_of(ground, 1, {.stiffness = 25})};
  return two;
}

const SoughtValue k0{0, &Oscillator<double>::stiffness}, k1{1, &Oscillator<double>::stiffness},
    k2{2, &Oscillator<double>::stiffness}, k3{3, &Oscillator<double>::stiffness},
    c0{0, &Oscillator<double>::damping, true}, c1{1, &Oscillator<double>::damping, true},
    c2{2, &Oscillator<double>::damping, true};

void write_network(test::NumberSheet& sheet, const std::string& name, const Network& truth,
                   const std::vector<SoughtValue>& sought, const NetworkSwings& swings) {
  Network asked = truth;
  for (const SoughtValue& each : sought) asked.links[each.link].law.*each.member = 0.5;
  for (NetworkMass& each : asked.masses) each.start = {};
  std::atomic<int> looks = 0;
  Watch watch;
  watch.pulse = [&looks] { ++looks; };
  const NetworkFit fit = fit_network(asked, sought, swings.record(), watch);
  sheet.row(name,
            {static_cast<double>(fit.status), static_cast<double>(fit.iterations), fit.independent_samples,
             static_cast<double>(fit.undetermined.size()), static_cast<double>(looks.load())});
  for (const Estimate& each : fit.values)
    sheet.row("  value", {each.value, each.standard_error, each.low, each.high});
  for (const FittedColumn& each : fit.columns) {
    sheet.row("  column", {each.position.value, each.position.standard_error, each.velocity.value,
                           each.velocity.standard_error, each.offset.value, each.offset.high});
    sheet.row("  left", {each.rms, each.explained});
  }
}

TEST(FitsWrittenDown, OfNetworks) {
  test::NumberSheet sheet;
  const Network two = two_masses_between_springs();
  const auto swings = swings_of(two, 260, 0.06, 1e-3, 4);
  write_network(sheet, "all", two, {k0, c0, k1, c1, k2, c2}, swings);
  write_network(sheet, "springs", two, {k0, k1, k2}, swings);
  write_network(sheet, "one spring", two, {k1}, swings);
  write_network(sheet, "noisy", two, {k0, c0, k1, k2}, swings_of(two, 260, 0.06, 0.02, 4));
  write_network(sheet, "coarse", two, {k0, c0, k1, k2}, swings_of(two, 120, 0.21, 1e-3, 4));
  write_network(sheet, "fine", two, {k0, k1}, swings_of(two, 700, 0.01, 1e-3, 4));
  write_network(sheet, "few samples", two, {k0, k1}, swings_of(two, 12, 0.2, 1e-3, 4));
  write_network(sheet, "fewer samples", two, {k0, k1}, swings_of(two, 11, 0.2, 1e-3, 4));
  NetworkSwings holes = swings;
  for (std::size_t n = 0; n < holes.t.size(); ++n) {
    if (n % 23 > 21) holes.y[0][n] = std::nan("");
    if (n > 100 && n < 120) holes.y[1][n] = std::nan("");
  }
  write_network(sheet, "holes", two, {k0, c0, k1, k2}, holes);
  NetworkSwings first = swings;
  first.y[0][0] = first.y[1][1] = std::nan("");
  write_network(sheet, "without the first", two, {k0, c0, k1, k2}, first);
  NetworkSwings still = swings;
  for (double& each : still.y[1]) each = 0.3;
  write_network(sheet, "one stands still", two, {k0, k1}, still);
  sheet.expect_as_in(fit_numbers / "network_fits.txt");
}

TEST(FitsWrittenDown, OfOtherNetworks) {
  test::NumberSheet sheet;
  const Network two = two_masses_between_springs();
  Network apart = two;
  apart.links.push_back(link_of(0, 1, {.stiffness = 2}));
  write_network(sheet, "two springs side by side", apart, {k0, k1, k3}, swings_of(apart, 260, 0.06, 1e-3, 4));
  Network bent = two;
  bent.links[0].law.cubic = 300;
  const SoughtValue cubic{0, &Oscillator<double>::cubic};
  write_network(sheet, "a bent spring", bent, {k0, cubic, k1}, swings_of(bent, 80, 0.08, 1e-3, 4));
  write_network(sheet, "a bent spring that the law lacks", two, {k0, k1}, swings_of(bent, 80, 0.08, 1e-3, 4));
  Network driven = two;
  driven.masses[0].drive = {.amplitude = 1.5, .frequency = 5, .phase = 0.4};
  write_network(sheet, "driven", driven, {k0, c0, k1, k2}, swings_of(driven, 260, 0.06, 1e-3, 4));
  Network dragged = two;
  dragged.links[1].law.drag = 0.3;
  const SoughtValue drag{1, &Oscillator<double>::drag, true};
  write_network(sheet, "drag", dragged, {k1, drag}, swings_of(dragged, 80, 0.08, 1e-3, 4));
  write_network(sheet, "no drag", two, {k1, drag}, swings_of(two, 80, 0.08, 1e-3, 4));
  Network three = two;
  three.masses.push_back(mass_of("last", 0.3, {-0.05, 0}));
  three.links.push_back(link_of(1, 2, {.stiffness = 9, .damping = 0.03}));
  write_network(sheet, "three masses", three, {k0, k1, k2, k3}, swings_of(three, 120, 0.08, 1e-3, 4));
  sheet.row("most sought", {static_cast<double>(most_sought(1)), static_cast<double>(most_sought(2)),
                            static_cast<double>(most_sought(6)), static_cast<double>(most_sought(7))});
  sheet.expect_as_in(fit_numbers / "other_network_fits.txt");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
