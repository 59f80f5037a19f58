// Two components walked together, and how far their motion reaches in every direction. Included by walk.h.
#pragma once

#include <cstddef>
#include <utility>

#include "cromer/analysis/interval_peak.h"
#include "cromer/ensemble/filter_walk.h"
#include "cromer/ensemble/pack.h"

namespace cromer::core {

/// One pack of lanes of both components.
template <class Pack>
struct LanesOfTwo {
  ResponseFilter<Pack> filter;
  FilterState<Pack> first, second;
  Pack reach[cromer_walk::sketched];

  LanesOfTwo(const cromer_walk::Filters& filters, const cromer_walk::Filters& across, std::size_t place) {
    const auto load = [&](const cromer_walk::Numbers& numbers) { return Pack::load(numbers.of + place); };
    filter = {load(filters.decay), load(filters.kappa), load(filters.e0), load(filters.e2), Pack(1.0)};
    first = {load(filters.u), load(filters.d)};
    second = {load(across.u), load(across.d)};
  }

  void pass(double f1, double f2) {
    filter.step(first, Pack(f1));
    filter.step(second, Pack(f2));
  }
  void look(double f1, double f2) {
    const Pack q1 = filter.step(first, Pack(f1)), q2 = filter.step(second, Pack(f2));
    const auto include = [&](std::size_t i, const Pack& q) { reach[i] = larger(reach[i], abs(q)); };
    constexpr double c1 = 0.92387953251128675613, s1 = 0.38268343236508977173;  // of 22.5 degrees
    constexpr double c2 = 0.70710678118654752440;                               // of 45 degrees
    static_assert(cromer_walk::sketched == 8);
    include(0, q1), include(4, q2);
    include(1, c1 * q1 + s1 * q2), include(7, c1 * q1 - s1 * q2);
    include(2, c2 * (q1 + q2)), include(6, c2 * (q1 - q2));
    include(3, s1 * q1 + c1 * q2), include(5, s1 * q1 - c1 * q2);
  }

  void interval(const cromer_walk::Walk& walk, const double* across, std::size_t i) {
    const double part = walk.hold ? 0 : 1 / static_cast<double>(walk.substeps);
    const double from1 = walk.force[i], to1 = walk.force[i + 1], rise1 = part * (to1 - from1);
    const double from2 = across[i], to2 = across[i + 1], rise2 = part * (to2 - from2);
    for (std::size_t j = 1; j < walk.substeps; ++j) {
      const auto done = static_cast<double>(j);
      const double f1 = from1 + done * rise1, f2 = from2 + done * rise2;
      walk.every ? look(f1, f2) : pass(f1, f2);
    }
    walk.every || (i + 1) % walk.look_every == 0 ? look(to1, to2) : pass(to1, to2);
  }

  void run(const cromer_walk::Walk& walk, const double* across, std::size_t place,
           cromer_walk::BlockOfTwo* blocks) {
    const std::size_t intervals = walk.samples - 1;
    const bool plain = walk.substeps == 1 && (walk.every || walk.look_every == 1);
    for (std::size_t begin = 0; begin < intervals; begin += walk.block, ++blocks) {
      first.u.store(blocks->u[0].of + place), first.d.store(blocks->d[0].of + place);
      second.u.store(blocks->u[1].of + place), second.d.store(blocks->d[1].of + place);
      for (Pack& each : reach) each = Pack(0.0);
      const std::size_t end = intervals - begin < walk.block ? intervals : begin + walk.block;
      if (plain)
        for (std::size_t i = begin; i < end; ++i) look(walk.force[i + 1], across[i + 1]);
      else
        for (std::size_t i = begin; i < end; ++i) interval(walk, across, i);
      double lanes_reach[cromer_walk::sketched][Pack::size];
      for (std::size_t k = 0; k < cromer_walk::sketched; ++k) reach[k].store(lanes_reach[k]);
      for (std::size_t lane = 0; lane < Pack::size; ++lane)
        for (std::size_t k = 0; k < cromer_walk::sketched; ++k)
          blocks->reach[place + lane][k] = lanes_reach[k][lane];
    }
  }
};

template <class Pack>
void walk_two(const cromer_walk::Filters& filters, const cromer_walk::Filters& across_filters,
              const cromer_walk::Walk& walk, const double* across, cromer_walk::BlockOfTwo* blocks) {
  for (std::size_t place = 0; place < cromer_walk::lanes; place += Pack::size)
    LanesOfTwo<Pack>(filters, across_filters, place).run(walk, across, place, blocks);
}

/// As many directions as a pack has lanes.
template <class Pack>
struct Directions {
  Pack cosine, sine;

  Directions(const cromer_walk::Reach& reach, std::size_t place)
      : cosine(Pack::load(reach.cosine + place)), sine(Pack::load(reach.sine + place)) {}

  Pack along(double first, double second) const { return cosine * Pack(first) + sine * Pack(second); }
};

template <class Pack>
void reach_of_points(const cromer_walk::Points& points, cromer_walk::Reach& reach) {
  static_assert(cromer_walk::Reach::size % Pack::size == 0);
  for (std::size_t place = 0; place < cromer_walk::Reach::size; place += Pack::size) {
    const Directions<Pack> directions(reach, place);
    Pack most = Pack::load(reach.magnitude + place);
    for (std::size_t i = 0; i < points.count; ++i)
      most = larger(most, abs(directions.along(points.x[i], points.y[i])));
    most.store(reach.magnitude + place);
  }
}

inline constexpr std::size_t most_powers = 17;

/// Powers of a motion's series over an interval until the next is below 1e-17; at most 17 at 0.63.
inline std::size_t powers_of(double rate_times_h) {
  std::size_t n = 4;
  double next = rate_times_h * rate_times_h * rate_times_h * rate_times_h / 24;
  for (; n < most_powers && next > 1e-17; ++n) next *= rate_times_h / static_cast<double>(n + 1);
  return n;
}

/// A motion as a power series of the part of an interval that has passed, and its first two derivatives.
template <class Real>
struct PowerSeries {
  Real value[most_powers], slope[most_powers], bend[most_powers];

  /// The first n powers and their derivative.
  static std::pair<Real, Real> at(const Real* series, std::size_t n, const Real& t) {
    Real value = series[n - 1], derivative = 0.0;
    for (std::size_t i = n - 1; i-- > 0;) {
      derivative = derivative * t + value;
      value = value * t + series[i];
    }
    return {value, derivative};
  }
};

/// From x'' + 2 b x' + s x = f0 + (f1 - f0) t/h, power by power.
inline void power_series(const cromer_walk::Path& path, std::size_t component, std::size_t i,
                         std::size_t powers, double* of) {
  const double h = path.h, damping = 2 * path.decay_rate * h, spring = path.stiffness * h * h;
  const double f0 = path.f[component][i], rise = path.hold ? 0 : path.f[component][i + 1] - f0;
  const double force[2] = {h * h * f0, h * h * rise};
  of[0] = path.x[component][i];
  of[1] = h * path.v[component][i];
  for (std::size_t k = 0; k + 2 < powers; ++k) {
    const auto n = static_cast<double>(k + 1);
    of[k + 2] = ((k < 2 ? force[k] : 0) - damping * n * of[k + 1] - spring * of[k]) / (n * (n + 1));
  }
}

/// Where the series vanishes between a and b, in the lanes where its values there, fa and fb, differ in sign:
/// by Newton's steps, or bisection where they leave the bracket. Elsewhere any number between a and b.
template <class Pack>
Pack root_between(const Pack* series, std::size_t powers, Pack a, const Pack& fa, Pack b, const Pack& fb) {
  using Truth = decltype(a < b);
  const double to_within = 1e-7;    // the motion is flat where it turns: good to 1e-14
  const double last_newton = 1e-4;  // a step as short is the last: what is left is as its square
  const Truth falls = fa > 0.0 && fb < 0.0, sought = falls || (fa < 0.0 && fb > 0.0);
  const Truth idle = choose(sought, Pack(1.0), Pack(0.0)) <= 0.0;
  if (all(idle)) return a;
  Pack t = choose(sought, a + (b - a) * (fa / (fa - fb)), a);
  for (int i = 0; i < 60; ++i) {
    const auto [value, derivative] = PowerSeries<Pack>::at(series, powers, t);
    const Pack as_begun = choose(falls, value, -value);  // > 0 before the root
    a = choose(as_begun > 0.0, t, a);
    b = choose(as_begun < 0.0, t, b);
    const Pack next = t - value / derivative;
    const Truth inside = next > a && next < b;
    const Pack to = choose(value <= 0.0 && value >= 0.0, t, choose(inside, next, a + 0.5 * (b - a)));
    const Pack moved = abs(to - t);
    const Truth settled = moved <= to_within || (inside && moved <= last_newton);
    t = choose(sought, to, t);
    if (all(settled || idle)) break;
  }
  return t;
}

/// One interval of a path in as many directions as a pack has lanes.
template <class Pack>
Pack reach_inside(const Directions<Pack>& directions, const double* first, const double* second,
                  std::size_t powers) {
  PowerSeries<Pack> series;
  for (std::size_t i = 0; i < powers; ++i) series.value[i] = directions.along(first[i], second[i]);
  for (std::size_t i = 0; i + 1 < powers; ++i)
    series.slope[i] = static_cast<double>(i + 1) * series.value[i + 1];
  for (std::size_t i = 0; i + 2 < powers; ++i)
    series.bend[i] = static_cast<double>(i + 1) * series.slope[i + 1];
  const auto slope = [&](const Pack& t) { return PowerSeries<Pack>::at(series.slope, powers - 1, t).first; };
  const auto turn_between = [&](const Pack& a, const Pack& at_a, const Pack& b, const Pack& at_b) {
    return abs(
        PowerSeries<Pack>::at(series.value, powers, root_between(series.slope, powers - 1, a, at_a, b, at_b))
            .first);
  };
  // q'' swings freely and vanishes at most once in half a period: on both sides of that q' is monotone.
  const Pack begin = 0.0, end = 1.0, bend_at_end = PowerSeries<Pack>::at(series.bend, powers - 2, end).first;
  const Pack middle = root_between(series.bend, powers - 2, begin, series.bend[0], end, bend_at_end);
  const Pack at_middle = slope(middle);
  return larger(turn_between(begin, series.slope[0], middle, at_middle),
                turn_between(middle, at_middle, end, slope(end)));
}

/// The motion of both components at a step, and its derivatives until the next.
struct MotionOfTwo {
  IntervalMotion first, second;

  MotionOfTwo(const LinearLaw<double>& law, const cromer_walk::Path& path, std::size_t i)
      : first(of(law, path, 0, i)), second(of(law, path, 1, i)) {}

 private:
  static IntervalMotion of(const LinearLaw<double>& law, const cromer_walk::Path& path, std::size_t c,
                           std::size_t i) {
    const double slope = path.hold ? 0 : (path.f[c][i + 1] - path.f[c][i]) / path.h;
    return {law, {path.x[c][i], path.v[c][i]}, path.f[c][i], slope};
  }
};

template <class Pack>
void reach_of_path(const cromer_walk::Path& path, cromer_walk::Reach& reach) {
  const LinearLaw<double> law{.decay_rate = path.decay_rate, .stiffness = path.stiffness};
  const double b = path.decay_rate, discriminant = b * b - path.stiffness;
  const double rate = discriminant > 0 ? b + std::sqrt(discriminant) : std::sqrt(path.stiffness);
  const std::size_t powers = powers_of(rate * path.h);
  double least = reach.magnitude[0];
  for (const double each : reach.magnitude) least = each < least ? each : least;
  for (std::size_t i = 0; i + 1 < path.count; ++i) {
    const auto square = [&](std::size_t at) {
      return path.x[0][at] * path.x[0][at] + path.x[1][at] * path.x[1][at];
    };
    const MotionOfTwo motion(law, path, i);
    const double over1 = overshoot_bound(law, {1, 0}, motion.first, path.h);
    const double over2 = overshoot_bound(law, {1, 0}, motion.second, path.h);
    const double over = std::sqrt(over1 * over1 + over2 * over2), inner = least - over;
    if (inner > 0 && square(i) <= inner * inner && square(i + 1) <= inner * inner) continue;
    double first[most_powers], second[most_powers];
    bool expanded = false;
    for (std::size_t place = 0; place < cromer_walk::Reach::size; place += Pack::size) {
      const Directions<Pack> directions(reach, place);
      const Pack begin = abs(directions.along(path.x[0][i], path.x[1][i]));
      const Pack end = abs(directions.along(path.x[0][i + 1], path.x[1][i + 1]));
      const Pack most = larger(begin, end), reached = Pack::load(reach.magnitude + place);
      if (all(most + Pack(over) <= reached)) continue;
      const Pack bend = directions.along(motion.first.acceleration, motion.second.acceleration);
      const Pack twist = directions.along(motion.first.jerk, motion.second.jerk);
      const Pack room = larger(reached - most, 0.0), beyond = Pack(8 / (path.h * path.h)) * room;
      if (all(bend * bend + twist * twist / Pack(law.stiffness) <= beyond * beyond)) {
        larger(reached, most).store(reach.magnitude + place);
        continue;
      }
      if (!expanded) {
        power_series(path, 0, i, powers, first);
        power_series(path, 1, i, powers, second);
        expanded = true;
      }
      larger(larger(reached, most), reach_inside(directions, first, second, powers))
          .store(reach.magnitude + place);
    }
  }
}

}  // namespace cromer::core
