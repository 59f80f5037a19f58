// Drives other than the harmonic one. Those with a closed form are checked against Duhamel's integral, x(t) =
// integral of g(t - u) f(u) du, by quadrature.
#include "cromer/model/general_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/model/harmonic_force.h"
#include "cromer/model/sampled_drive.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(GeneralDrive, JoinsTheLawWithoutLosingATerm) {
  const Oscillator<double> everything{
      .mass = 2, .stiffness = 8, .damping = 0.6, .drag = 0.4, .friction = 0.2, .cubic = 3};
  const GeneralDrive<double> drive = PulseDrive<double>{PulseShape::half_sine, 1.4, 0.5, 2};
  for (int set = 0; set < 16; ++set) {
    Oscillator<double> o = everything;
    if (set & 1) o.damping = 0;
    if (set & 2) o.drag = 0;
    if (set & 4) o.friction = 0;
    if (set & 8) o.cubic = 0;
    const double t = 1.1, x = -0.4, v = -0.9;
    const double a = with_terms(o, drive, [&](const auto& system) { return system.acceleration(t, x, v); });
    const double force = 1.4 * std::sin(std::numbers::pi * 0.6 / 2) - o.stiffness * x - o.cubic * x * x * x -
                         o.damping * v - o.drag * v * std::abs(v) + o.friction;
    EXPECT_NEAR(a, force / o.mass, 2e-15) << set;
  }
}

const SampledDrive two_samples{std::make_shared<const std::vector<double>>(2, 1.0)};

TEST(GeneralDrive, HasAClosedFormWhereLawAndForceHaveOne) {
  const auto exact = [](const Oscillator<double>& o, const GeneralDrive<double>& drive) {
    return with_terms(o, drive, []<class S>(const S&) { return ExactSystem<S, double>; });
  };
  EXPECT_TRUE(exact({}, PulseDrive<double>{PulseShape::half_sine, 1, 0, 2}));
  EXPECT_TRUE(exact({.damping = 1}, two_samples));
  EXPECT_FALSE(exact({.cubic = 1}, PulseDrive<double>{PulseShape::step, 1}));
  EXPECT_FALSE(exact({}, ChirpDrive<double>{.amplitude = 1, .from = 1, .to = 2, .duration = 3}));
}

/// Gauss-Legendre with five points on many panels between neighbouring corners.
double integral(const std::function<double(double)>& f, std::vector<double> corners, int panels = 400) {
  constexpr double node[] = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double sum = 0;
  for (std::size_t c = 0; c + 1 < corners.size(); ++c)
    for (int i = 0; i < panels; ++i) {
      const double h = (corners[c + 1] - corners[c]) / panels, middle = corners[c] + (i + 0.5) * h;
      double panel = weight[0] * f(middle);
      for (int k : {1, 2}) panel += weight[k] * (f(middle - node[k] * h / 2) + f(middle + node[k] * h / 2));
      sum += panel * h / 2;
    }
  return sum;
}

/// The free motion plus what a force (per unit mass) with kinks at the corners adds.
State<double> duhamel(const LinearLaw<double>& law, const std::function<double(double)>& force,
                      const std::vector<double>& corners, const State<double>& start) {
  const double t = corners.back();
  State<double> y = propagate(law, corners.front(), t, start);
  y.x += integral([&](double u) { return impulse_response(law, t - u).g * force(u); }, corners);
  y.v += integral([&](double u) { return impulse_response(law, t - u).slope * force(u); }, corners);
  return y;
}

// underdamped, undamped, free, creeping, nearly critical, critical, overdamped, stiff overdamped, inverted
const LinearLaw<double> laws[] = {{0.15, 36}, {0, 9},      {0, 0}, {0.4, 0},   {3 - 1e-9, 9},
                                  {3, 9},     {3.0001, 9}, {7, 9}, {40, 1e-3}, {0.2, -4}};

TEST(RampResponse, IsTheIntegralOfTheImpulseResponse) {
  for (const auto& law : laws)
    for (const double tau : {1e-9, 1e-4, 0.02, 0.1, 0.25, 0.3, 0.34, 0.7, 2.0, 5.0}) {
      const auto free = impulse_response(law, tau);
      const auto response = ramp_response(law, free, tau);
      const double step = integral([&](double u) { return impulse_response(law, u).g; }, {0, tau});
      const double ramp =
          integral([&](double u) { return (tau - u) * impulse_response(law, u).g; }, {0, tau});
      EXPECT_NEAR(response.step / step, 1, 5e-14) << law.decay_rate << ' ' << law.stiffness << ' ' << tau;
      EXPECT_NEAR(response.ramp / ramp, 1, 2e-13) << law.decay_rate << ' ' << law.stiffness << ' ' << tau;
    }
}

TEST(RampResponse, DerivativesAgreeWithDifferences) {
  using D = Dual<double, 2>;
  for (const auto& law : laws)
    for (const double tau : {0.05, 0.4, 3.0}) {
      const auto at = [&](double b, double s) {
        const LinearLaw<double> moved{b, s};
        return ramp_response(moved, impulse_response(moved, tau), tau);
      };
      const LinearLaw<D> dual{D::variable(law.decay_rate, 0), D::variable(law.stiffness, 1)};
      const auto response = ramp_response(dual, impulse_response(dual, D(tau)), D(tau));
      const double e = 1e-5, scale = 1e-8 * (1 + tau * tau * tau);
      EXPECT_NEAR(
          response.ramp.derivative[0],
          (at(law.decay_rate + e, law.stiffness).ramp - at(law.decay_rate - e, law.stiffness).ramp) / (2 * e),
          scale);
      EXPECT_NEAR(
          response.ramp.derivative[1],
          (at(law.decay_rate, law.stiffness + e).ramp - at(law.decay_rate, law.stiffness - e).ramp) / (2 * e),
          scale);
    }
}

const PulseDrive<double> pulses[] = {
    {PulseShape::step, 1.5, 0.4},
    {PulseShape::rectangular, -2, 0.4, 0.7},
    {PulseShape::half_sine, 1.5, 0.4, 0.7},
    {PulseShape::triangular, 1.5, 0.4, 0.7},
    {PulseShape::half_sine, 1.5, 0, std::numbers::pi / 3}};  // w = 3: resonant

TEST(Pulse, HasItsShape) {
  const double m = 2;
  const auto at = [&](PulseShape shape, double t) {
    return PulseForce<double>(PulseDrive<double>{shape, 3, 1, 4}, m)(t) * m;
  };
  for (const auto shape :
       {PulseShape::step, PulseShape::rectangular, PulseShape::half_sine, PulseShape::triangular}) {
    EXPECT_EQ(at(shape, 0.999), 0);
    EXPECT_EQ(at(shape, 5.001), shape == PulseShape::step ? 3 : 0);
    EXPECT_DOUBLE_EQ(at(shape, 3), 3);
  }
  EXPECT_EQ(at(PulseShape::rectangular, 1), 3);
  EXPECT_EQ(at(PulseShape::rectangular, 5), 0);
  EXPECT_DOUBLE_EQ(at(PulseShape::half_sine, 2), 3 * std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(at(PulseShape::triangular, 2), 1.5);
  EXPECT_DOUBLE_EQ(at(PulseShape::triangular, 4.5), 0.75);
}

TEST(Pulse, MotionIsDuhamelsIntegral) {
  const State<double> start{0.3, -0.8};
  for (const auto& law : laws)
    for (const auto& pulse : pulses) {
      const PulseForce<double> force(pulse, 1.0);
      const double half = pulse.start + pulse.duration / 2, end = pulse.start + pulse.duration;
      for (const double t : {0.2, 0.5, 0.9, 1.3, 3.0}) {
        std::vector<double> corners{0};
        for (const double corner : {pulse.start, half, end})
          if (corner > corners.back() && corner < t) corners.push_back(corner);
        corners.push_back(t);
        const State<double> truth = duhamel(law, force, corners, start);
        const State<double> y = force.propagate(law, 0.0, t, start);
        const double scale = 1 + std::abs(truth.x) + std::abs(truth.v);
        EXPECT_NEAR(y.x, truth.x, 2e-13 * scale) << law.decay_rate << ' ' << law.stiffness << ' ' << t;
        EXPECT_NEAR(y.v, truth.v, 4e-13 * scale) << law.decay_rate << ' ' << law.stiffness << ' ' << t;
      }
    }
}

TEST(Pulse, ItsStartIsMetToRounding) {
  const PulseForce<double> force(PulseDrive<double>{PulseShape::rectangular, 1, 0.3, 0.4}, 1.0);
  for (int n = 0; n <= 10; ++n) EXPECT_EQ(force(n * 0.1), n >= 3 && n < 7 ? 1 : 0) << n;
}

SampledDrive samples(BetweenSamples between, double spacing = 0.1) {
  return {std::make_shared<const std::vector<double>>(std::vector<double>{0, 2, -1, 0.5, 3, 3, -2}), spacing,
          between};
}

TEST(Sampled, IsStraightOrHeldBetweenSamples) {
  const double m = 2;
  const SampledForce<double> linear(samples(BetweenSamples::linear), m);
  const SampledForce<double> held(samples(BetweenSamples::hold), m);
  EXPECT_DOUBLE_EQ(linear(0.05) * m, 1);
  EXPECT_DOUBLE_EQ(linear(0.175) * m, 2 - 3 * 0.75);
  EXPECT_DOUBLE_EQ(linear(0.6) * m, -2);
  EXPECT_DOUBLE_EQ(held(0.05) * m, 0);
  EXPECT_DOUBLE_EQ(held(0.65) * m, -2);
  // 3 * 0.1 is not 0.3, nor 0.7 - 0.1 quite 0.6: a sample's time is its time.
  const std::vector<double> values{0, 2, -1, 0.5, 3, 3, -2};
  for (int i = 0; i < 7; ++i) {
    EXPECT_DOUBLE_EQ(held(i * 0.1) * m, values[static_cast<std::size_t>(i)]);
    EXPECT_DOUBLE_EQ(held(std::nextafter(i * 0.1, -1.0)) * m, values[static_cast<std::size_t>(i)]);
    EXPECT_NEAR(linear(i * 0.1) * m, values[static_cast<std::size_t>(i)], 1e-15 * 100);
  }
  EXPECT_DOUBLE_EQ(samples(BetweenSamples::linear).duration(), 6 * 0.1);
  EXPECT_DOUBLE_EQ(samples(BetweenSamples::hold).duration(), 7 * 0.1);
}

TEST(Sampled, MotionIsDuhamelsIntegral) {
  const State<double> start{0.3, -0.8};
  for (const auto& law : laws)
    for (const auto between : {BetweenSamples::linear, BetweenSamples::hold}) {
      const SampledDrive drive = samples(between);
      const SampledForce<double> force(drive, 1.0);
      for (const double t : {0.04, 0.1, 0.37, 0.5, 0.6}) {
        std::vector<double> corners{0};
        for (int i = 1; i * 0.1 < t - 1e-9; ++i) corners.push_back(i * 0.1);
        corners.push_back(t);
        const State<double> truth = duhamel(law, force, corners, start);
        const State<double> once = force.propagate(law, 0.0, t, start);
        EXPECT_NEAR(once.x, truth.x, 1e-13) << law.decay_rate << ' ' << law.stiffness << ' ' << t;
        EXPECT_NEAR(once.v, truth.v, 3e-13) << law.decay_rate << ' ' << law.stiffness << ' ' << t;
        // In many short flights it is the same motion.
        State<double> y = start;
        for (int n = 0; n < 7; ++n) y = force.propagate(law, n * t / 7, (n + 1) * t / 7, y);
        EXPECT_NEAR(y.x, truth.x, 2e-13);
        EXPECT_NEAR(y.v, truth.v, 4e-13);
      }
    }
}

TEST(Chirp, SweepsItsFrequency) {
  for (const bool logarithmic : {false, true}) {
    const ChirpDrive<double> drive{.amplitude = 3,
                                   .from = 2,
                                   .to = 50,
                                   .phase = 0.4,
                                   .start = 1,
                                   .duration = 10,
                                   .logarithmic = logarithmic};
    const ChirpForce<double> force(drive, 1.5);
    EXPECT_EQ(force(0.999), 0);
    EXPECT_EQ(force(11.0), 0);
    EXPECT_DOUBLE_EQ(force(1.0), 2 * std::cos(0.4));
    // The phase is the integral of the frequency.
    for (const double t : {1.5, 4.0, 10.9}) {
      const double angle = integral(
          [&](double u) { return logarithmic ? 2 * std::pow(25, (u - 1) / 10) : 2 + 4.8 * (u - 1); }, {1, t});
      EXPECT_NEAR(force(t), 2 * std::cos(0.4 + angle), 1e-12) << t;
    }
  }
}

TEST(Chirp, WithoutASweepIsHarmonic) {
  for (const bool logarithmic : {false, true}) {
    const ChirpForce<double> force(
        ChirpDrive<double>{.amplitude = 1, .from = 3, .to = 3, .duration = 10, .logarithmic = logarithmic},
        1.0);
    for (const double t : {0.0, 0.7, 9.3}) EXPECT_NEAR(force(t), std::cos(3 * t), 1e-14);
  }
}

/// The turns of a force up to `until`; in between it must be monotonic.
template <class Force>
std::vector<double> turns(const Force& force, double until) {
  std::vector<double> found;
  double last = 0;
  while (true) {
    const double next = force.next_turn(last);
    if (!(next > last)) {
      ADD_FAILURE() << "stands still at " << last;
      return found;
    }
    const double end = std::min(next, until);
    bool rises = false, falls = false;
    double before = force(last + 1e-9 * (end - last));
    for (int i = 1; i < 1000; ++i) {
      const double now = force(last + i / 1000.0 * (end - last));
      rises = rises || now > before + 1e-12;
      falls = falls || now < before - 1e-12;
      before = now;
    }
    EXPECT_FALSE(rises && falls) << "between " << last << " and " << next;
    if (next >= until) return found;
    found.push_back(next);
    last = next;
  }
}

TEST(NextTurn, OfAHarmonicForceIsItsExtrema) {
  const auto found = turns(HarmonicForce<double>{2, 5, 0.4}, 100);
  ASSERT_EQ(found.size(), 159u);  // 500.4/pi
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_DOUBLE_EQ(found[i], ((static_cast<double>(i) + 1) * pi - 0.4) / 5);
  EXPECT_EQ(HarmonicForce<double>({2, 0, 0.4}).next_turn(3), std::numeric_limits<double>::infinity());
}

TEST(NextTurn, OfAPulseIsWhereItsPiecesBegin) {
  const auto of = [](PulseShape shape) { return turns(PulseForce<double>({shape, -3, 0.5, 0.25}, 1.0), 10); };
  EXPECT_EQ(of(PulseShape::step), (std::vector<double>{0.5}));
  EXPECT_EQ(of(PulseShape::rectangular), (std::vector<double>{0.5, 0.75}));
  EXPECT_EQ(of(PulseShape::triangular), (std::vector<double>{0.5, 0.625, 0.75}));
  const auto half_sine = of(PulseShape::half_sine);
  ASSERT_EQ(half_sine.size(), 3u);
  EXPECT_DOUBLE_EQ(half_sine[1], 0.625);
}

TEST(NextTurn, OfARecordingIsEverySample) {
  const auto samples = std::make_shared<const std::vector<double>>(std::vector<double>{0, 1, -2, 2, 2, 0});
  for (const auto between : {BetweenSamples::linear, BetweenSamples::hold}) {
    const auto found = turns(SampledForce<double>({samples, 0.1, between}, 1.0), 10);
    ASSERT_EQ(found.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(found[i], 0.1 * (static_cast<double>(i) + 1));
  }
}

TEST(NextTurn, OfAChirpIsItsExtrema) {
  struct Case {
    double from, to, phase;
    bool logarithmic;
  };
  for (const Case& c :
       {Case{0, 40, 0, false}, Case{40, 0, 1, false}, Case{10, 10, -2, false}, Case{3, 30, 0.3, false},
        Case{1, 100, -pi, true}, Case{100, 1, 0.5, true}, Case{7, 7, 0.5, true}, Case{0, 0, 0.2, false}}) {
    const ChirpDrive<double> drive{2, c.from, c.to, c.phase, 0.5, 4, c.logarithmic};
    const auto found = turns(ChirpForce<double>(drive, 1.0), 10);
    // The angle runs over this much; beside the turns there are start and end.
    const double mean =
        c.logarithmic && c.from != c.to ? (c.to - c.from) / std::log(c.to / c.from) : (c.from + c.to) / 2;
    const double half_turns = std::floor((c.phase + 4 * mean) / pi) - std::floor(c.phase / pi);
    EXPECT_NEAR(static_cast<double>(found.size()), 2 + half_turns, 1) << c.from << ' ' << c.to;
    EXPECT_EQ(found.front(), 0.5);
    EXPECT_EQ(found.back(), 4.5);
    for (std::size_t i = 1; i + 1 < found.size(); ++i)
      EXPECT_NEAR(std::abs(ChirpForce<double>(drive, 1.0)(found[i])), 2, 1e-12) << found[i];
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
