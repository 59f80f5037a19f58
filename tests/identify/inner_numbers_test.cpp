// What the inner functions of a fit give for many small records, in tests/identify/numbers (written anew as
// tests/support/number_sheet.h says). What the numbers should be is asked elsewhere: of fits, and of each
// function where a closed form is known.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "cromer/identify/fit_settings.h"
#include "cromer/identify/least_squares/noise.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/start/driven_start.h"
#include "cromer/identify/start/envelope_track.h"
#include "cromer/identify/start/start_values.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"
#include "tests/support/number_sheet.h"

namespace cromer::core {
namespace CROMER_FILE {

const std::filesystem::path numbers = std::filesystem::path(CROMER_SOURCE_DIR) / "tests/identify/numbers";

struct NamedRecord {
  std::string name;
  std::vector<double> t, y;
  double resolution = 0;
  int derivative = 0;

  Record record() const { return {t, y, resolution, derivative}; }
};

NamedRecord made_of(std::string name, const std::vector<double>& t, const std::function<double(double)>& y,
                    double noise = 0) {
  NamedRecord made{std::move(name), t, {}};
  for (const double s : t) made.y.push_back(y(s));
  made.y = noisy(made.y, noise);
  return made;
}

std::vector<double> kept_times(const std::vector<double>& t,
                               const std::function<bool(std::size_t)>& is_kept) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (is_kept(i)) kept.push_back(t[i]);
  return kept;
}

std::function<double(double)> decaying(double w, double g, double level = 0.3) {
  return [=](double s) { return level + std::exp(-g * s) * (0.5 * std::cos(w * s) + 0.2 * std::sin(w * s)); };
}

/// Times that jitter by a part of their step.
std::vector<double> jittering(std::size_t n, double h, double part) {
  std::vector<double> t = even_times(n, h);
  for (std::size_t i = 0; i < n; ++i) t[i] += part * h * std::sin(2.3 * static_cast<double>(i * i));
  return t;
}

std::vector<NamedRecord> swings() {
  const double turn = 2 * std::numbers::pi;
  std::vector<NamedRecord> all{
      made_of("eight samples", even_times(8, 0.1), decaying(6, 0.1), 1e-3),
      made_of("nine samples of half a period", even_times(9, 0.1), decaying(4, 0.3), 1e-3),
      made_of("twelve coarse samples", even_times(12, 0.7), decaying(4, 0.05), 1e-3),
      made_of("two periods", even_times(100, 0.02), decaying(turn, 0.2), 1e-3),
      made_of("five periods", even_times(250, 0.02), decaying(turn, 0.2), 0.01),
      made_of("just below six periods", even_times(298, 0.02), decaying(turn, 0.1), 1e-3),
      made_of("just above six periods", even_times(306, 0.02), decaying(turn, 0.1), 1e-3),
      made_of("seven periods and a half", even_times(376, 0.02), decaying(turn, 0.1), 0.1),
      made_of("thirty periods", even_times(600, 0.05), decaying(turn, 0.03), 0.01),
      made_of("thirty periods, loud", even_times(600, 0.05), decaying(turn, 0.03), 0.6),
      made_of("thirty periods, very loud", even_times(600, 0.05), decaying(turn, 0.03), 2),
      made_of("growing", even_times(600, 0.05), decaying(turn, -0.05), 0.01),
      made_of("growing from nothing", even_times(300, 0.05), decaying(turn, -0.6), 0.01),
      made_of("gone within three periods", even_times(600, 0.05), decaying(turn, 1.1), 0.002),
      made_of("gone within a period", even_times(400, 0.05), decaying(turn, 4), 0.002),
      made_of("no swing at all", even_times(400, 0.05), decaying(1, 3), 0.002),
      made_of("slow and long", even_times(3000, 0.01), decaying(0.9, 0.02), 0.01),
      made_of("many samples a period", even_times(2500, 0.002), decaying(9, 0.3), 0.01),
      made_of("nearly two samples a period", even_times(500, 0.1), decaying(29, 0.01), 0.01),
      made_of("more than is searched", even_times(12000, 0.02), decaying(7, 0.004), 0.02),
      made_of("more than is searched, few periods in it", even_times(20000, 0.002), decaying(1.3, 0.02),
              0.02),
      made_of("more than is searched, no period in it", even_times(20000, 0.002), decaying(0.5, 0.01), 0.02),
      made_of(
          "more than is searched, a line of noise", even_times(18000, 0.002),
          [](double s) { return std::cos(1.1 * s) + 0.2 * std::cos(40 * s); }, 0.02),
      made_of("jitter", jittering(500, 0.05, 0.3), decaying(turn, 0.03), 0.01),
      made_of("a little jitter", jittering(500, 0.05, 0.02), decaying(turn, 0.03), 0.01),
      made_of("few periods with jitter", jittering(60, 0.05, 0.4), decaying(turn, 0.03), 0.01),
      made_of("a gap", kept_times(even_times(800, 0.05), [](std::size_t i) { return i < 200 || i > 500; }),
              decaying(turn, 0.03), 0.01),
      made_of("bursts", kept_times(even_times(3000, 0.05), [](std::size_t i) { return i % 100 < 12; }),
              decaying(turn, 0.005), 0.01),
      made_of("each tenth moment two samples",
              kept_times(even_times(3000, 0.03), [](std::size_t i) { return i % 10 < 2; }),
              decaying(turn, 0.01), 0.01),
      made_of(
          "samples far apart behind a burst",
          [] {
            std::vector<double> t = even_times(300, 0.01);
            for (int i = 0; i < 40; ++i) t.push_back(20 + 60.0 * i * (1 + 0.01 * i));
            return t;
          }(),
          decaying(9, 0.2), 0.005),
      made_of(
          "two lines", even_times(600, 0.05),
          [](double s) {
            return std::exp(-0.02 * s) * std::cos(5 * s) + 0.7 * std::exp(-0.01 * s) * std::cos(8 * s);
          },
          0.01),
      made_of(
          "two lines, close", even_times(900, 0.05),
          [](double s) {
            return std::exp(-0.02 * s) * std::cos(5 * s) + 0.7 * std::exp(-0.01 * s) * std::cos(5.4 * s);
          },
          0.01),
      made_of(
          "a drift beside it", even_times(600, 0.05),
          [](double s) { return 0.08 * s + std::exp(-0.02 * s) * std::cos(7 * s); }, 0.01),
      made_of(
          "a large drift beside it", even_times(600, 0.05),
          [](double s) { return 0.9 * s + std::exp(-0.02 * s) * std::cos(7 * s); }, 0.01),
      made_of(
          "noise", even_times(300, 0.05), [](double) { return 0.0; }, 1),
      made_of(
          "a long noise", even_times(1100, 0.05), [](double) { return 2.0; }, 1),
      made_of(
          "a harmonic larger than it", even_times(600, 0.03),
          [](double s) { return 0.4 * std::cos(3 * s) + 0.9 * std::cos(6 * s); }, 0.01),
  };
  return all;
}

void write_start(test::NumberSheet& sheet, const std::string& name, const StartValues& start) {
  sheet.row(name, {start.phasor[0], start.phasor[1], start.phasor[2], start.phasor[3], start.phasor[4],
                   static_cast<double>(start.first), static_cast<double>(start.samples)});
  sheet.row("  errors", {start.frequency_error, start.rival});
  sheet.row("  rival leaves more", {start.rival_excess});
}

TEST(InnerNumbers, StartValues) {
  test::NumberSheet sheet;
  for (const NamedRecord& each : swings()) {
    const Record record = each.record();
    const auto start = find_start_values(record);
    if (!start) {
      sheet.row(each.name, {});
      continue;
    }
    write_start(sheet, each.name, *start);
    if (start->samples < record.t.size()) write_start(sheet, "  grown", grown(record, *start));
  }
  sheet.expect_as_in(numbers / "start_values.txt");
}

Motion swing_under(const char* law, double w, double g, const std::function<void(Motion&)>& more = {}) {
  Motion motion{.equilibrium = 0.1, .position = 0.4, .velocity = 0.3};
  motion.law = law_of(law);
  motion.set_angular_frequency(w);
  motion.set_decay_rate(g);
  if (more) more(motion);
  return motion;
}

NamedRecord observed(std::string name, const Motion& motion, const std::vector<double>& t, double noise,
                     int derivative = 0, double resolution = 0) {
  NamedRecord made{std::move(name), t, noisy(observed_motion(motion, {}, t, derivative, 0.004), noise)};
  made.derivative = derivative;
  made.resolution = resolution;
  return made;
}

void write_motion(test::NumberSheet& sheet, const std::string& name, const Motion& m) {
  const Oscillator<double>& o = m.per_mass;
  sheet.row(name, {m.equilibrium, m.position, m.velocity, o.stiffness, o.damping});
  sheet.row("  terms", {o.drag, o.friction, o.cubic, o.quadratic, o.odd_quadratic, o.quintic, o.pendulum,
                        o.van_der_pol});
  sheet.row("  drive", {m.cosine, m.sine, m.drive_frequency, m.force_gain, m.force_offset});
}

void write_tracks(test::NumberSheet& sheet, const NamedRecord& each, double w, double g,
                  const std::vector<const char*>& laws) {
  const auto track = track_envelope(each.record(), w, g);
  if (!track) return sheet.row(each.name, {});
  sheet.row(each.name, {track->frequency, track->equilibrium, static_cast<double>(track->samples),
                        static_cast<double>(track->swinging)});
  sheet.in_short("  times", track->t);
  sheet.in_short("  amplitudes", track->amplitude);
  sheet.in_short("  phases", track->phase);
  for (const char* law : laws)
    write_motion(sheet, std::string("  ") + law, motion_along(*track, law_of(law), each.t.front()));
}

TEST(InnerNumbers, EnvelopeTracks) {
  test::NumberSheet sheet;
  const auto t = even_times(600, 0.05);
  const std::vector<const char*> all{"viscous",
                                     "viscous+drag",
                                     "viscous+friction",
                                     "friction",
                                     "viscous+drag+friction",
                                     "viscous+cubic",
                                     "viscous+drag+cubic",
                                     "viscous+quadratic",
                                     "viscous+odd-quadratic",
                                     "viscous+quintic",
                                     "viscous+cubic+quintic",
                                     "viscous+odd-quadratic+quintic",
                                     "viscous+pendulum",
                                     "viscous+drag+pendulum",
                                     "viscous+van-der-pol"};
  const auto from = [](std::vector<double> times, double t0) {
    for (double& each : times) each += t0;
    return times;
  };
  write_tracks(sheet, observed("viscous", swing_under("viscous", 6, 0.04), t, 1e-3), 6, 0.04, all);
  write_tracks(sheet, observed("named five percent off", swing_under("viscous", 6, 0.04), t, 1e-3), 6.3, 0.04,
               {"viscous"});
  write_tracks(sheet, observed("named thirty percent off", swing_under("viscous", 6, 0.04), t, 1e-3), 7.8,
               0.04, {"viscous"});
  write_tracks(sheet, observed("noisy", swing_under("viscous", 6, 0.02), t, 0.05), 6, 0.02,
               {"viscous", "viscous+drag", "viscous+cubic"});
  write_tracks(sheet, observed("very noisy", swing_under("viscous", 6, 0.02), t, 0.2), 6, 0.02, {"viscous"});
  write_tracks(sheet, observed("dies away", swing_under("viscous", 6, 0.3), t, 1e-3), 6, 0.02,
               {"viscous", "viscous+friction"});
  write_tracks(sheet, observed("dies away in noise", swing_under("viscous", 6, 0.3), t, 0.03), 6, 0.1,
               {"viscous"});
  write_tracks(sheet, observed("dies away in steps", swing_under("viscous", 6, 0.2), t, 1e-3, 0, 0.1), 6, 0.1,
               {"viscous"});
  write_tracks(sheet, observed("few periods", swing_under("viscous", 6, 0.1), even_times(70, 0.05), 1e-3), 6,
               0.1, {"viscous"});
  write_tracks(sheet, observed("too few periods", swing_under("viscous", 6, 0.1), even_times(50, 0.05), 1e-3),
               6, 0.1, {"viscous"});
  write_tracks(sheet, observed("coarse", swing_under("viscous", 6, 0.02), even_times(200, 0.17), 1e-3), 6,
               0.02, {"viscous"});
  write_tracks(sheet, observed("too coarse", swing_under("viscous", 6, 0.02), even_times(200, 0.25), 1e-3), 6,
               0.02, {"viscous"});
  write_tracks(sheet, observed("fine", swing_under("viscous", 6, 0.02), even_times(4000, 0.004), 1e-3), 6,
               0.02, {"viscous", "viscous+drag"});
  write_tracks(sheet,
               observed("a gap", swing_under("viscous", 6, 0.03),
                        kept_times(t, [](std::size_t i) { return i < 200 || i > 290; }), 1e-3),
               6, 0.03, {"viscous"});
  write_tracks(sheet, observed("from a later time", swing_under("viscous", 6, 0.04), from(t, 12.5), 1e-3), 6,
               0.04, {"viscous", "viscous+cubic"});
  write_tracks(
      sheet,
      observed("drag", swing_under("viscous+drag", 6, 0.02, [](Motion& m) { m.per_mass.drag = 0.5; }), t,
               1e-3),
      6, 0.04, all);
  write_tracks(sheet,
               observed("friction",
                        swing_under("friction", 6, 0, [](Motion& m) { m.per_mass.friction = 0.2; }), t, 1e-3),
               6, 0.04, {"friction", "viscous+friction", "viscous", "viscous+drag+friction"});
  for (const double cubic : {-40.0, 15.0, 150.0, 600.0})
    write_tracks(
        sheet,
        observed("cubic", swing_under("viscous+cubic", 6, 0.05, [=](Motion& m) { m.per_mass.cubic = cubic; }),
                 t, 1e-3),
        6 + 0.004 * cubic, 0.05,
        {"viscous", "viscous+cubic", "viscous+drag+cubic", "viscous+cubic+quintic",
         "viscous+quadratic+cubic"});
  write_tracks(sheet,
               observed("odd quadratic",
                        swing_under("viscous+odd-quadratic", 6, 0.05,
                                    [](Motion& m) { m.per_mass.odd_quadratic = 40; }),
                        t, 1e-3),
               7, 0.05, {"viscous+odd-quadratic", "viscous+cubic", "viscous+odd-quadratic+quintic"});
  write_tracks(
      sheet,
      observed("quintic",
               swing_under("viscous+quintic", 6, 0.05, [](Motion& m) { m.per_mass.quintic = 500; }), t, 1e-3),
      6.5, 0.05, {"viscous+quintic", "viscous+cubic+quintic"});
  write_tracks(
      sheet,
      observed("quadratic",
               swing_under("viscous+quadratic", 6, 0.05, [](Motion& m) { m.per_mass.quadratic = 15; }), t,
               1e-3),
      6, 0.05, {"viscous+quadratic", "viscous+quadratic+cubic"});
  for (const double angle : {0.3, 1.2, 2.6, 3.0})
    write_tracks(
        sheet,
        observed("pendulum", swing_under("viscous+pendulum", 6, 0.05, [=](Motion& m) { m.position = angle; }),
                 t, 1e-3),
        6 * (1 - angle * angle / 17), 0.05,
        {"viscous+pendulum", "viscous+drag+pendulum", "viscous+cubic", "viscous+friction+pendulum"});
  write_tracks(sheet, observed("velocities", swing_under("viscous", 6, 0.04), t, 1e-2, 1), 6, 0.04,
               {"viscous", "viscous+drag", "viscous+cubic"});
  write_tracks(sheet, observed("accelerations", swing_under("viscous", 6, 0.04), t, 5e-2, 2), 6, 0.04,
               {"viscous", "viscous+drag", "viscous+cubic"});
  write_tracks(
      sheet,
      observed("van der Pol",
               swing_under("viscous+van-der-pol", 6, -0.1, [](Motion& m) { m.per_mass.van_der_pol = 3; }), t,
               1e-3),
      6, 0, {"viscous+van-der-pol", "viscous"});
  sheet.expect_as_in(numbers / "envelope_tracks.txt");
}

NamedRecord driven(std::string name, double w, double g, double drive, double force,
                   const std::vector<double>& t, double noise, int derivative = 0, double position = 0.4) {
  Motion motion = swing_under("viscous", w, g);
  motion.position = position;
  motion.cosine = force;
  motion.sine = -0.4 * force;
  motion.drive_frequency = drive;
  NamedRecord made{std::move(name), t,
                   noisy(observed_motion(motion, Drive::harmonic(), t, derivative, 0.004), noise)};
  made.derivative = derivative;
  return made;
}

TEST(InnerNumbers, DrivenStarts) {
  test::NumberSheet sheet;
  const auto t = even_times(700, 0.05);
  const auto write = [&](const NamedRecord& each, std::optional<double> drive) {
    const auto start = driven_start(each.record(), drive);
    if (start)
      write_motion(sheet, each.name, *start);
    else
      sheet.row(each.name, {});
  };
  for (const double drive : {2.0, 4.5, 5.7, 6.0, 6.3, 8.0, 14.0}) {
    const NamedRecord each = driven(fmt::format("driven at {}", drive), 6, 0.06, drive, 6, t, 5e-3);
    write(each, {});
    write(each, drive);
    write(each, 1.004 * drive);
  }
  write(driven("weakly", 6, 0.03, 8, 0.2, t, 5e-3), {});
  write(driven("weakly, known", 6, 0.03, 8, 0.2, t, 5e-3), 8.0);
  write(driven("hardly", 6, 0.03, 8, 0.01, t, 5e-3), 8.0);
  write(driven("strongly damped", 6, 1.5, 4, 20, t, 5e-3), {});
  write(driven("strongly damped, known", 6, 1.5, 4, 20, t, 5e-3), 4.0);
  write(driven("steady", 6, 0.5, 7, 20, t, 5e-3, 0, 0), {});
  write(driven("noisy", 6, 0.06, 8, 6, t, 0.2), {});
  write(driven("noisy, known", 6, 0.06, 8, 6, t, 0.2), 8.0);
  write(driven("shortly", 6, 0.06, 8, 6, even_times(60, 0.05), 5e-3), {});
  write(driven("shortly, known", 6, 0.06, 8, 6, even_times(60, 0.05), 5e-3), 8.0);
  write(driven("few samples", 6, 0.06, 8, 6, even_times(33, 0.15), 5e-3), 8.0);
  write(driven("a long record", 6, 0.004, 6.2, 1, even_times(6000, 0.05), 5e-3), {});
  write(driven("a long record, known nearly", 6, 0.004, 6.2, 1, even_times(6000, 0.05), 5e-3), 6.24);
  write(driven("a long record of a free swing, another drive named", 6, 0.002, 6.2, 0, even_times(6000, 0.05),
               5e-3),
        6.03);
  write(driven("many samples a period", 6, 0.06, 8, 6, even_times(5000, 0.005), 5e-3), {});
  write(driven("fast lines", 60, 0.06, 58, 60, even_times(5000, 0.02), 5e-3), {});
  write(driven("uneven times", 6, 0.06, 8, 6, jittering(700, 0.05, 0.4), 5e-3), {});
  write(driven("a gap", 6, 0.06, 8, 6, kept_times(t, [](std::size_t i) { return i < 300 || i > 380; }), 5e-3),
        {});
  write(driven("velocities", 6, 0.06, 8, 6, t, 5e-3, 1), {});
  write(driven("accelerations", 6, 0.06, 8, 6, t, 5e-3, 2), {});
  write(driven("velocities, known", 6, 0.06, 4, 6, t, 5e-3, 1), 4.0);
  write(made_of("a straight line", t, [](double s) { return s; }), {});
  write(made_of(
            "noise", t, [](double) { return 0; }, 1),
        {});
  write(made_of(
            "noise with a drive", t, [](double) { return 0; }, 1),
        6.0);
  sheet.expect_as_in(numbers / "driven_starts.txt");
}

TEST(InnerNumbers, ForcedStarts) {
  test::NumberSheet sheet;
  const auto write = [&](const std::string& name, const ForcedSynthetic& record,
                         const std::vector<const char*>& laws) {
    for (const char* law : laws) {
      const auto start = forced_start(record.record(), record.recorded(BetweenSamples::linear), law_of(law));
      if (start)
        write_motion(sheet, name + ", " + law, *start);
      else
        sheet.row(name + ", " + law, {});
    }
  };
  const std::vector<const char*> all{"viscous",
                                     "viscous+quadratic",
                                     "viscous+cubic",
                                     "viscous+quadratic+cubic",
                                     "viscous+odd-quadratic",
                                     "viscous+odd-quadratic+quintic",
                                     "viscous+drag"};
  const auto force = multisine(20, 3, 24);
  const ForcedSynthetic plain = forced_synthetic({}, force, 300, 0.025, 1e-3, 4);
  write("linear", plain, all);
  write("hardening", forced_synthetic({.cubic = 400}, force, 300, 0.025, 1e-3, 4), all);
  write("softening", forced_synthetic({.cubic = -150}, force, 300, 0.025, 1e-3, 4), all);
  write("quadratic", forced_synthetic({.quadratic = 60}, force, 300, 0.025, 1e-3, 4), all);
  write("drag", forced_synthetic({.drag = 2}, force, 300, 0.025, 1e-3, 4), {"viscous", "viscous+drag"});
  write("zero far off", forced_synthetic({.offset = 3, .equilibrium = 2.5}, force, 300, 0.025, 1e-3, 4), all);
  write("zero amid", forced_synthetic({.offset = 3, .equilibrium = 0.03}, force, 300, 0.025, 1e-3, 4), all);
  write("bent, zero amid",
        forced_synthetic({.quadratic = 50, .cubic = 200, .offset = 3, .equilibrium = 0.03}, force, 300, 0.025,
                         1e-3, 4),
        all);
  write("velocities", forced_synthetic({}, force, 300, 0.025, 1e-3, 4, 1), {"viscous", "viscous+cubic"});
  write("accelerations", forced_synthetic({}, force, 300, 0.025, 1e-3, 4, 2), {"viscous", "viscous+cubic"});
  write("noisy", forced_synthetic({}, force, 300, 0.025, 0.05, 4), {"viscous", "viscous+cubic"});
  write("strongly damped", forced_synthetic({.w0 = 6, .g = 9}, force, 300, 0.025, 1e-3, 4), {"viscous"});
  write("hardly damped", forced_synthetic({.g = 0.001}, force, 300, 0.025, 1e-3, 4), {"viscous"});
  write("sixteen samples", forced_synthetic({}, force, 16, 0.05, 1e-3, 4), {"viscous"});
  write("nineteen samples", forced_synthetic({}, force, 19, 0.05, 1e-3, 4), {"viscous", "viscous+cubic"});
  write("a prime number of samples", forced_synthetic({}, force, 211, 0.05, 1e-3, 4), {"viscous"});
  write("of the force nothing", forced_synthetic({.gain = 0}, force, 300, 0.025, 1e-3, 4), {"viscous"});
  for (const int derivative : {0, 1, 2})
    write(fmt::format("no spring, derivative {}", derivative),
          forced_synthetic({.w0 = 0.001, .g = 0.4, .offset = 0.2}, force, 300, 0.025, 1e-3, 4, derivative),
          {"damping", "viscous"});
  ForcedSynthetic holes = plain;
  std::vector<double> t, y;
  for (std::size_t i = 0; i < holes.t.size(); ++i)
    if (i % 50 < 44) t.push_back(holes.t[i]), y.push_back(holes.y[i]);
  holes.t = t;
  holes.y = y;
  write("samples missing", holes, {"viscous", "viscous+cubic"});
  ForcedSynthetic part = plain;
  part.t = std::vector<double>(plain.t.begin() + 100, plain.t.begin() + 283);
  part.y = std::vector<double>(plain.y.begin() + 100, plain.y.begin() + 283);
  write("a part", part, {"viscous"});
  sheet.expect_as_in(numbers / "forced_starts.txt");
}

void write_equations(test::NumberSheet& sheet, const std::string& name, const NormalEquations& equations) {
  sheet.row(name, {equations.sum_of_squares});
  sheet.row("  right", std::span(equations.right).first(static_cast<std::size_t>(equations.size)));
  for (int i = 0; i < equations.size; ++i)
    sheet.row("  row", std::span(equations.matrix[static_cast<std::size_t>(i)])
                           .first(static_cast<std::size_t>(equations.size)));
}

TEST(InnerNumbers, DampedPhasors) {
  test::NumberSheet sheet;
  const std::vector<std::pair<std::string, std::vector<double>>> times{
      {"one", {0.5}},
      {"even", even_times(200, 0.05)},
      {"several stretches", even_times(700, 0.05)},
      {"uneven", jittering(90, 0.05, 0.4)},
      {"gaps", kept_times(even_times(400, 0.05), [](std::size_t i) { return i % 60 > 20; })},
      {"gaps and single samples",
       kept_times(even_times(900, 0.05), [](std::size_t i) { return i < 500 || i % 7 == 0; })}};
  for (const auto& [name, t] : times) {
    const NamedRecord made = made_of(name, t, decaying(6, 0.1), 0.05);
    const DampedPhasor model(made.record());
    for (const double g : {0.1, 0.0, -0.05, 3.0}) {
      const Parameters at{6.1, g, 0.2, 0.4, 0.3};
      write_equations(sheet, fmt::format("{} at {}", name, g), model(at));
      std::vector<double> left;
      model.residuals(at, left);
      sheet.in_short("  residuals", left);
      sheet.in_short("  swing", model.swing(at));
      const auto best = model.best_linear(6.1, g);
      sheet.row("  best", {best.equilibrium, best.cosine, best.sine, best.sum_of_squares});
    }
  }
  sheet.expect_as_in(numbers / "damped_phasors.txt");
}

TEST(InnerNumbers, MotionsAndTheirDerivatives) {
  test::NumberSheet sheet;
  const auto t = kept_times(jittering(120, 0.05, 0.2), [](std::size_t i) { return i < 70 || i > 90; });
  const auto write = [&](const char* law, const Drive& drive, const std::function<void(Motion&)>& more) {
    const Motion motion = swing_under(law, 6, 0.2, more);
    const FittedParameters fitted = fitted_parameters(motion.law, drive.kind, {}, motion);
    const Parameters at = fitted.pack(motion);
    sheet.row(law, std::span(at).first(static_cast<std::size_t>(fitted.count)));
    for (const int derivative : {0, 1, 2}) {
      const std::vector<double> shown = observed_motion(motion, drive, t, derivative, 0.02);
      sheet.in_short("  shown", shown);
      const std::vector<double> noise = noisy(shown, 0.1);
      const Record record{t, noise, 0, derivative};
      const NormalEquations equations = motion_equations(fitted, at, drive, record, 0.02);
      sheet.row("  sum of squares", {equations.sum_of_squares});
      sheet.row("  right", std::span(equations.right).first(static_cast<std::size_t>(fitted.count)));
      for (int i = 0; i < fitted.count; ++i)
        sheet.row("  row", {equations.matrix[static_cast<std::size_t>(i)][0],
                            equations.matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)]});
      sheet.in_short("  Jacobian", jacobian_of(fitted, at, drive, record, 0.02));
      if (drive.kind == DriveKind::none && motion.law.has<Friction>()) {
        const Rest rest = rest_of(fitted, at, record, 0.02);
        sheet.row("  rest",
                  {static_cast<double>(rest.first), static_cast<double>(rest.half_swings), rest.position});
        sheet.row("  by", std::span(rest.derivative).first(static_cast<std::size_t>(fitted.count)));
      }
    }
    if (drive.kind != DriveKind::none) return;
    const VelocityGradient gradient = velocity_gradient(fitted, motion, 1.7, 0.02);
    sheet.row("  velocity", {gradient.velocity});
    sheet.row("  by", std::span(gradient.derivative).first(static_cast<std::size_t>(fitted.count)));
  };
  const std::vector<std::pair<const char*, std::function<void(Motion&)>>> laws{
      {"viscous", {}},
      {"viscous+drag", [](Motion& m) { m.per_mass.drag = 0.5; }},
      {"friction", [](Motion& m) { m.set_decay_rate(0), m.per_mass.friction = 2; }},
      {"viscous+friction", [](Motion& m) { m.per_mass.friction = 0.7; }},
      {"viscous+drag+friction", [](Motion& m) { m.per_mass.drag = 0.5, m.per_mass.friction = 0.7; }},
      {"viscous+cubic", [](Motion& m) { m.per_mass.cubic = 100; }},
      {"viscous+quadratic+cubic", [](Motion& m) { m.per_mass.cubic = 100, m.per_mass.quadratic = 10; }},
      {"viscous+odd-quadratic+friction",
       [](Motion& m) { m.per_mass.odd_quadratic = 30, m.per_mass.friction = 0.7; }},
      {"viscous+quintic", [](Motion& m) { m.per_mass.quintic = 300; }},
      {"viscous+pendulum", [](Motion& m) { m.position = 1.5; }},
      {"viscous+pendulum+friction", [](Motion& m) { m.position = 1.5, m.per_mass.friction = 2; }},
      {"viscous+van-der-pol", [](Motion& m) { m.per_mass.van_der_pol = 3; }},
      {"viscous+hysteresis", [](Motion& m) {
         m.per_mass.hysteresis_stiffness = 12;
         m.per_mass.hysteresis_beta = 30;
         m.per_mass.hysteresis_gamma = 10;
       }}};
  for (const auto& [law, more] : laws) write(law, {}, more);
  for (const auto& [law, more] : laws)
    if (law != std::string("viscous+hysteresis"))
      write(law, Drive::harmonic(), [&, more = more](Motion& m) {
        m.cosine = 3, m.sine = -2, m.drive_frequency = 5;
        if (more) more(m);
      });
  sheet.expect_as_in(numbers / "motions.txt");
}

TEST(InnerNumbers, MotionsUnderARecordedForce) {
  test::NumberSheet sheet;
  const auto acting = multisine(14, 6);
  std::vector<double> samples;
  for (int i = 0; i < 160; ++i) samples.push_back(acting(0.05 * i));
  std::vector<double> t;
  for (int i = 10; i < 130; ++i)
    if (i < 60 || i > 80) t.push_back(0.05 * i);
  for (const auto between : {BetweenSamples::linear, BetweenSamples::hold, BetweenSamples::band_limited})
    for (const char* law : {"viscous", "viscous+drag", "viscous+friction", "viscous+quadratic+cubic",
                            "viscous+pendulum", "damping"}) {
      const Drive drive = Drive::recorded({samples, 0, 0.05, between});
      Motion motion = swing_under(law, 6, 0.2);
      motion.force_gain = 2;
      motion.force_offset = 0.1;
      if (motion.law.has<Drag>()) motion.per_mass.drag = 0.5;
      if (motion.law.has<Friction>()) motion.per_mass.friction = 0.3;
      if (motion.law.has<Quadratic>()) motion.per_mass.quadratic = 10, motion.per_mass.cubic = 50;
      motion = motion.under(motion.law);
      const FittedParameters fitted = fitted_parameters(motion.law, drive.kind, {}, motion);
      const Parameters at = fitted.pack(motion);
      for (const int derivative : {0, 1, 2}) {
        const std::vector<double> shown = observed_motion(motion, drive, t, derivative, 0.02);
        sheet.in_short(fmt::format("{} {} {}", law, static_cast<int>(between), derivative), shown);
        const std::vector<double> noise = noisy(shown, 0.1);
        const Record record{t, noise, 0, derivative};
        sheet.in_short("  Jacobian", jacobian_of(fitted, at, drive, record, 0.02));
        sheet.in_short("  left", motion_residuals(motion, drive, record, 0.02));
        const NormalEquations equations = motion_equations(fitted, at, drive, record, 0.02);
        sheet.row("  right", std::span(equations.right).first(static_cast<std::size_t>(fitted.count)));
      }
    }
  sheet.expect_as_in(numbers / "forced_motions.txt");
}

std::vector<double> coloured(std::size_t n, const std::vector<double>& coefficients, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<double> r;
  for (std::size_t i = 0; i < n + 100; ++i) {
    double value = normal(engine);
    for (std::size_t k = 0; k < coefficients.size() && k < i; ++k) value += coefficients[k] * r[i - 1 - k];
    r.push_back(value);
  }
  return {r.begin() + 100, r.end()};
}

struct Left {
  std::string name;
  std::vector<double> t, r, motion;
};

/// Residuals of many kinds, at times with and without gaps, beside a decaying motion.
std::vector<Left> residuals() {
  std::vector<Left> all;
  const auto add = [&](const std::string& name, const std::vector<double>& t, std::vector<double> r,
                       const std::function<double(double s, double x)>& size = {}) {
    Left left{name, t, std::move(r), {}};
    left.r.resize(t.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
      left.motion.push_back(0.2 + std::exp(-0.02 * t[i]) * std::cos(2.3 * t[i]));
      if (size) left.r[i] *= size(t[i], left.motion[i] - 0.2);
    }
    all.push_back(std::move(left));
  };
  const auto gaps = [](std::size_t n) {
    return kept_times(even_times(n, 0.1), [](std::size_t i) { return i % 40 < 33 && i % 17 != 3; });
  };
  add("white", even_times(400, 0.1), coloured(400, {}, 1));
  add("white, few", even_times(29, 0.1), coloured(29, {}, 2));
  add("white, thirty", even_times(30, 0.1), coloured(30, {}, 2));
  add("white, six", even_times(6, 0.1), coloured(6, {}, 2));
  add("all alike", even_times(40, 0.1), std::vector<double>(40, 0.5));
  add("none", even_times(40, 0.1), std::vector<double>(40, 0.0));
  add("white, with gaps", gaps(600), coloured(600, {}, 3));
  add("red", even_times(500, 0.1), coloured(500, {0.6}, 4));
  add("very red", even_times(500, 0.1), coloured(500, {0.97}, 4));
  add("a little red", even_times(500, 0.1), coloured(500, {0.15}, 4));
  add("hardly red", even_times(3000, 0.1), coloured(3000, {0.04}, 4));
  add("blue", even_times(500, 0.1), coloured(500, {-0.5}, 5));
  add("ringing", even_times(500, 0.1), coloured(500, {1.2, -0.8}, 6));
  add("red, with gaps", gaps(700), coloured(700, {0.6}, 7));
  add("ringing, with gaps", gaps(700), coloured(700, {1.2, -0.8}, 7));
  add("a long memory", even_times(1500, 0.1), [] {
    std::vector<double> memory(40, 0.0);
    memory[39] = 0.8;
    return coloured(1500, memory, 8);
  }());
  add("each second", kept_times(even_times(600, 0.1), [](std::size_t i) { return i % 3 != 1; }),
      coloured(600, {0.5}, 8));
  add("growing with the displacement", even_times(600, 0.1), coloured(600, {}, 9),
      [](double, double x) { return 0.2 + std::abs(x); });
  add("growing with the velocity", even_times(600, 0.1), coloured(600, {}, 10),
      [](double s, double) { return 0.2 + std::exp(-0.02 * s) * std::abs(std::sin(2.3 * s)); });
  add("growing with the motion, red", even_times(900, 0.1), coloured(900, {0.5}, 10),
      [](double s, double) { return 0.1 + std::exp(-0.02 * s); });
  add("growing with the displacement, with gaps", gaps(900), coloured(900, {}, 9),
      [](double, double x) { return 0.2 + std::abs(x); });
  add("growing with the velocity, with gaps", gaps(900), coloured(900, {}, 9),
      [](double s, double) { return 0.1 + std::exp(-0.02 * s) * std::abs(std::sin(2.3 * s)); });
  add("loud at one time", even_times(600, 0.1), coloured(600, {}, 11),
      [](double s, double) { return s > 20 && s < 30 ? 4 : 1; });
  add("loud at one time, red", even_times(600, 0.1), coloured(600, {0.6}, 11),
      [](double s, double) { return s > 20 && s < 30 ? 4 : 1; });
  add("loud at the end", even_times(1100, 0.1), coloured(1100, {}, 12),
      [](double s, double) { return s > 90 ? 3 : 1; });
  add("loud and growing", even_times(800, 0.1), coloured(800, {}, 13),
      [](double s, double x) { return (s > 60 ? 4 : 1) * (0.2 + std::abs(x)); });
  add("loud at one time, with gaps", gaps(900), coloured(900, {}, 14),
      [](double s, double) { return s > 20 && s < 30 ? 4 : 1; });
  add("a few large ones", even_times(300, 0.1), coloured(300, {}, 15),
      [](double s, double) { return std::fmod(s, 7) < 0.15 ? 6 : 1; });
  add("seventy", even_times(70, 0.1), coloured(70, {0.4}, 16),
      [](double s, double) { return s > 5 ? 3 : 1; });
  add("sixty", even_times(60, 0.1), coloured(60, {0.4}, 16), [](double s, double) { return s > 5 ? 3 : 1; });
  return all;
}

TEST(InnerNumbers, Residuals) {
  test::NumberSheet sheet;
  for (const Left& each : residuals()) {
    const SampleGrid grid = find_grid(each.t);
    const auto rho = autocorrelations(each.r, grid, first_lags(each.r.size()));
    const Residual of = describe_residual(each.r, rho, grid);
    sheet.row(each.name, {of.rms, of.autocorrelation, of.autocorrelation_error,
                          static_cast<double>(of.strongest_lag), of.strongest, of.white ? 1.0 : 0.0});
    sheet.row("  normality", {of.normality});
    sheet.in_short("  rho", rho);
    const Autoregression model = autoregression_of(each.r, rho, grid);
    sheet.in_short("  model", model.coefficients);
    sheet.row("  of it", {model.innovation, model.density(0), model.density(0.7), model.density(3.1)});
    sheet.row("  of the logarithm", {model.log_variance(std::vector<double>(model.coefficients.size(), 0.3),
                                                        static_cast<double>(each.r.size()))});
    sheet.row("  factors", {correlation_factor(each.r, 0), correlation_factor(each.r, 0.5),
                            correlation_factor(each.r, 2.5)});
  }
  sheet.expect_as_in(numbers / "residuals.txt");
}

// Of tables of chi-squared: 1 %, a thousandth and 5 % of records lie above.
TEST(ChiSquared, IsThatOfTheTables) {
  EXPECT_NEAR(chi_squared(20, 2.326348), 37.566, 0.1);
  EXPECT_NEAR(chi_squared(10, 2.326348), 23.209, 0.1);
  EXPECT_NEAR(chi_squared(49, 3.090232), 85.351, 0.1);
  EXPECT_NEAR(chi_squared(100, 1.644854), 124.342, 0.1);
  EXPECT_NEAR(chi_squared(100, 0), 99.334, 0.1);
}

TEST(Stretches, AreAFiftiethOrSixteenSamples) {
  EXPECT_EQ(stretch_of(3), 16u);
  EXPECT_EQ(stretch_of(849), 16u);
  EXPECT_EQ(stretch_of(850), 17u);
  EXPECT_EQ(stretch_of(5000), 100u);
  EXPECT_EQ(first_lags(63), 31u);
  EXPECT_EQ(first_lags(64), 32u);
  EXPECT_EQ(first_lags(1000), 32u);
}

TEST(InnerNumbers, Noise) {
  test::NumberSheet sheet;
  for (const Left& each : residuals()) {
    const SampleGrid grid = find_grid(each.t);
    const auto rho = autocorrelations(each.r, grid, first_lags(each.r.size()));
    sheet.in_short(each.name, noise_scale(grid, each.r, each.motion));
    sheet.in_short("  along", scale_along(grid, each.r, rho));
    const core::Noise noise = find_noise(grid, each.r, each.motion, rho);
    sheet.in_short("  scale", noise.scale);
    sheet.in_short("  correlation", noise.correlation.coefficients);
    sheet.row("  stretch",
              {static_cast<double>(noise.stretch), noise.correlation.innovation, noise.sum_of_squares});
    for (const int size : {1, 2, 4, 5, 8, 9, 12, 13, 16}) {
      if (2 * static_cast<std::size_t>(size) > each.t.size()) continue;
      std::vector<double> jacobian;
      for (const double s : each.t)
        for (int k = 0; k < size; ++k)
          jacobian.push_back(k == 0 ? 1 : (k % 3 == 0 ? 0.1 * s : 1) * std::cos(0.9 * k * s + k));
      const EstimateNoise of = estimate_noise(jacobian, size, noise, size == 5 ? 3.0 : 0);
      std::vector<double> numbers_of;
      for (int k = 0; k < size; ++k) {
        numbers_of.push_back(of.covariance[static_cast<std::size_t>(k)][static_cast<std::size_t>(k)]);
        numbers_of.push_back(of.degrees[static_cast<std::size_t>(k)]);
      }
      sheet.row(fmt::format("  {} parameters", size), numbers_of);
      if (size > 1) sheet.row("  between two", {of.covariance[0][1], of.covariance[1][0]});
    }
  }
  sheet.expect_as_in(numbers / "noise.txt");
}

TEST(InnerNumbers, Rounding) {
  test::NumberSheet sheet;
  for (const double noise : {0.0, 0.03, 0.049, 0.05, 0.1, 0.2, 0.4, 0.7})
    for (const double value : {0.1, 0.25, 0.4, 0.6, 3.9})
      sheet.row(fmt::format("{} in noise of {}", value, noise), {expected_rounding_error(value, noise)});
  const auto t = even_times(120, 0.05);
  for (const double step : {0.0, 0.01, 0.05, 0.3})
    for (const double noise : {0.001, 0.02, 0.1}) {
      NamedRecord made = made_of("", t, decaying(6, 0.1), noise);
      for (double& y : made.y)
        if (step > 0) y = 0.004 + step * std::round((y - 0.004) / step);
      made.resolution = step;
      std::vector<double> left;
      for (std::size_t i = 0; i < t.size(); ++i) left.push_back(made.y[i] - decaying(6, 0.1)(t[i]));
      sheet.in_short(fmt::format("steps of {}, noise of {}", step, noise),
                     rounded_motion(made.record(), left));
    }
  sheet.expect_as_in(numbers / "rounding.txt");
}

TEST(InnerNumbers, Amplitudes) {
  test::NumberSheet sheet;
  for (const NamedRecord& each : swings()) {
    if (each.t.size() > 1200) continue;
    sheet.row(each.name, {centred_norm(each.y), sinusoid_amplitude(each.y), noise_of(each.y)});
    std::vector<double> windows;
    for (const double length : {0.7, 2.1, 9.0})
      for (const std::size_t at_least : {1, 8, 14, 15})
        for (const AmplitudeWindow& window : amplitude_windows(each.record(), length, at_least)) {
          windows.push_back(window.from);
          windows.push_back(window.to);
          windows.push_back(window.amplitude);
        }
    sheet.in_short("  windows", windows);
  }
  sheet.expect_as_in(numbers / "amplitudes.txt");
}

TEST(InnerNumbers, Samplings) {
  test::NumberSheet sheet;
  const auto with_gaps = [](std::size_t n, std::size_t each, std::size_t kept) {
    return kept_times(even_times(n, 0.1), [=](std::size_t i) { return i % each < kept; });
  };
  std::vector<std::pair<std::string, std::vector<double>>> all{
      {"none", {}},
      {"one", {3}},
      {"two", {3, 3.5}},
      {"three", {3, 3.5, 7}},
      {"fifteen", even_times(15, 0.1)},
      {"sixteen", even_times(16, 0.1)},
      {"256", even_times(256, 0.1)},
      {"257", even_times(257, 0.1)},
      {"272", even_times(272, 0.1)},
      {"jitter", jittering(600, 0.1, 0.3)},
      {"gaps", with_gaps(400, 50, 31)},
      {"many gaps", with_gaps(900, 12, 9)},
      {"gaps after sixteen", with_gaps(400, 20, 16)},
      {"gaps after seventeen", with_gaps(400, 20, 17)},
      {"single samples", with_gaps(900, 9, 1)},
      {"slower at the end",
       [] {
         std::vector<double> t = even_times(80, 0.1);
         for (int i = 1; i < 60; ++i) t.push_back(t[79] + 0.17 * i);
         return t;
       }()},
      {"a gap of years",
       [] {
         std::vector<double> t = even_times(50, 0.1);
         for (int i = 0; i < 50; ++i) t.push_back(1e8 + 0.1 * i);
         return t;
       }()},
      {"far from zero",
       [] {
         std::vector<double> t = even_times(100, 0.1);
         for (double& each : t) each += 1.7e9;
         return t;
       }()},
  };
  for (const auto& [name, t] : all) {
    const Sampling sampling = find_sampling(t);
    const SampleGrid grid = find_grid(t);
    sheet.row(name, {sampling.step, grid.step});
    std::vector<double> stretches;
    for (const Stretch& each : sampling.stretches) {
      stretches.push_back(static_cast<double>(each.first));
      stretches.push_back(static_cast<double>(each.count));
      stretches.push_back(each.uniform ? 1 : 0);
    }
    sheet.in_short("  stretches", stretches);
    sheet.in_short("  places", std::vector<double>(grid.place.begin(), grid.place.end()));
  }
  sheet.expect_as_in(numbers / "samplings.txt");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
