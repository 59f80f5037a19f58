#include "cromer/tasks/curves/resonance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/base/pi.h"
#include "cromer/model/law_force.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr double transient_left = 1e-6;
constexpr int measured_cycles = 4;

Result<void> check(const ResonanceOptions& options, const Oscillator<double>& law) {
  if (!(options.frequency_from > 0)) return Error{"frequency_from_not_positive"};
  if (!(options.frequency_to > options.frequency_from)) return Error{"frequency_to_not_above_from"};
  if (options.points < 2) return Error{"too_few_points"};
  const std::string_view drive = drive_name(options.simulate);
  if (drive == "none") return Error{"resonance_without_force"};
  if (drive != "harmonic" && drive != "unbalance" && drive != "base")
    return Error{"resonance_of_other_drive",
                 {{"option", options.simulate.drive.empty() ? drive : std::string_view("drive")}}};
  if (const std::string_view term = why_not_exact(law); !term.empty())
    return Error{"resonance_not_linear", {{"option", term}}};
  if (!(law.damping > 0)) return Error{"resonance_without_damping"};
  if (!(law.stiffness > 0)) return Error{"resonance_without_spring"};
  return {};
}

/// The damping ratios to draw, each as options of `simulate`.
Result<std::vector<SimulateOptions>> each_damping(const ResonanceOptions& options) {
  const SimulateOptions& given = options.simulate;
  if (options.damping_ratio.empty()) return std::vector{given};
  if (given.damping || given.damping_ratio || given.quality_factor)
    return Error{"damping_ratios_and_damping"};
  std::vector<SimulateOptions> all;
  for (const double ratio : options.damping_ratio) {
    all.push_back(given);
    all.back().damping_ratio = ratio;
  }
  return all;
}

/// The slowest decay rate of the free motion [1/s].
double slowest_decay(const Oscillator<double>& law) {
  const double b = decay_rate(law), w2 = law.stiffness / law.mass;
  return b * b <= w2 ? b : w2 / (b + std::sqrt(b * b - w2));
}

/// A steady motion and what it transmits.
struct Point {
  SteadyState motion;
  Transmission transmission;
};

constexpr double not_settled = std::numeric_limits<double>::quiet_NaN();
constexpr Point unsettled{{not_settled, not_settled}, {not_settled, not_settled}};

/// What is transmitted, state by state, in place of the positions: the base's displacement plus the mass's
/// own relative to it, or the force of spring and damper.
Trajectory transmitted(const SimulatedRun& run, bool of_motion, double sent) {
  Trajectory out = run.trajectory;
  for (std::size_t i = 0; i < out.size(); ++i)
    out.x[i] =
        of_motion
            ? sent * std::cos(run.drive.frequency * out.t[i] + run.drive.phase) + run.trajectory.x[i]
            : run.oscillator.stiffness * run.trajectory.x[i] + run.oscillator.damping * run.trajectory.v[i];
  return out;
}

/// The run at w. It starts at the exact steady motion, so that only the method's own difference has to die
/// down.
SimulateOptions run_at(const SimulateOptions& options, const Oscillator<double>& law,
                       const std::string& method, double w, const SteadyState& exact) {
  SimulateOptions run = options;
  const double start = run.drive_phase - exact.phase_lag;
  run.method = {method};
  run.motion_only = true;
  run.drive_frequency = {w};
  run.position = exact.amplitude * std::cos(start);
  run.velocity = -exact.amplitude * w * std::sin(start);
  run.until = std::log(1 / transient_left) / slowest_decay(law) + (measured_cycles + 1) * two_pi / w;
  return run;
}

/// The point at w; `at_w` is the law with its drive there.
Result<Point> settle(const SimulateOptions& options, const SimulatedRun& at_w, const std::string& method,
                     const Watch& watch) {
  const double w = at_w.drive.frequency;
  const Point exact{frequency_response(at_w.oscillator, at_w.drive.amplitude, w),
                    transmissibility(at_w.oscillator, w)};
  if (method == "exact") return exact;
  auto simulated =
      simulate(run_at(options, at_w.oscillator, method, w, exact.motion), without_progress(watch));
  if (!simulated) return simulated.error();
  const SimulatedRun& run = simulated->runs.front();
  if (run.outcome.status != Status::reached_end) return unsettled;
  const auto measured = measure_steady_state(run.trajectory, run.drive, measured_cycles);
  if (!measured) return measured.error();
  if (!measured->settled()) return unsettled;
  const double sent = sent_amplitude(options, run);
  const auto passed_on =
      measure_steady_state(transmitted(run, sends_motion(options), sent), run.drive, measured_cycles);
  if (!passed_on) return passed_on.error();
  return Point{{measured->amplitude, measured->phase_lag},
               {passed_on->amplitude / sent, passed_on->phase_lag}};
}

void add(ResonanceCurve& curve, const SimulateOptions& options, const SimulatedRun& at_w,
         const Point& point) {
  const double w = at_w.drive.frequency, natural = natural_frequency(at_w.oscillator);
  const double sent = sent_amplitude(options, at_w), ratio = w / natural;
  const std::string_view drive = drive_name(options);
  // An unbalance's own measure, m_u e/m, is F/(m w^2).
  const double unit = drive == "base"        ? sent
                      : drive == "unbalance" ? sent / (at_w.oscillator.mass * (w * w))
                                             : sent / at_w.oscillator.stiffness;
  curve.frequency.push_back(w);
  curve.frequency_ratio.push_back(ratio);
  curve.amplitude.push_back(point.motion.amplitude);
  curve.phase.push_back(point.motion.phase_lag);
  curve.amplification.push_back(point.motion.amplitude / unit);
  curve.transmissibility.push_back(point.transmission.amplitude);
  curve.transmitted_phase.push_back(point.transmission.phase_lag);
  curve.transmitted.push_back(point.transmission.amplitude * sent);
}

/// Empty if every run settled.
Notice notice_of(const ResonanceCurve& curve) {
  const auto& amplitudes = curve.amplitude;
  const auto missing =
      std::count_if(amplitudes.begin(), amplitudes.end(), [](double a) { return std::isnan(a); });
  if (missing == 0) return {};
  return Notice{"not_settled",
                {{"method", curve.method}, {"unsettled", missing}, {"frequencies", amplitudes.size()}}};
}

}  // namespace

Result<ResonanceResult> resonance(const ResonanceOptions& options, const Watch& watch) {
  const auto laws = each_damping(options);
  if (!laws) return laws.error();
  ResonanceResult result;
  result.of_motion = sends_motion(options.simulate);
  double work_done = 0;
  for (const SimulateOptions& law : *laws) {
    // Setting up a run at the first frequency checks all other options and fills in the defaults.
    SimulateOptions first = law;
    first.drive_frequency = {options.frequency_from};
    const auto runs = set_up_runs(first);
    if (!runs) return runs.error();
    if (const auto good = check(options, runs->front().oscillator); !good) return good.error();
    const double work = static_cast<double>(laws->size() * runs->size());
    for (SimulatedRun at_w : *runs) {
      const Oscillator<double>& o = at_w.oscillator;
      ResonanceCurve curve{.method = at_w.method, .damping_ratio = damping_ratio(o)};
      for (long long i = 0; i < options.points; ++i) {
        if (watch.interrupted()) return Error{"interrupted"};
        const double share = static_cast<double>(i) / static_cast<double>(options.points - 1);
        const double w = options.frequency_from + share * (options.frequency_to - options.frequency_from);
        if (const auto good = set_drive(law, w, at_w); !good) return good.error();
        const auto point = settle(law, at_w, curve.method, watch);
        if (!point) return point.error();
        add(curve, law, at_w, *point);
        if (watch.progress) watch.progress((work_done + share) / work);
      }
      ++work_done;
      if (auto notice = notice_of(curve); !notice.empty()) result.notices.push_back(std::move(notice));
      result.curves.push_back(std::move(curve));
    }
  }
  return result;
}

}  // namespace cromer::core
