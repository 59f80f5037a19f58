#include "cromer/tasks/simulate/drive_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cromer/base/nearest.h"
#include "cromer/base/pi.h"
#include "cromer/model/band_limited.h"
#include "cromer/model/terms.h"

namespace cromer::core {
namespace {

constexpr int finer = 16;  // values for each interval of a band-limited recording

/// What each drive takes, as bits.
enum Needs : unsigned {
  amplitude = 1,
  frequency = 2,
  phase = 4,
  start = 8,
  duration = 16,
  to = 32,
  unbalance = 64,
  base = 128,
  file = 256,
};

struct Kind {
  std::string_view name;
  unsigned needs;  ///< must be given
  unsigned takes;  ///< may be given
};

constexpr Kind kinds[] = {
    {"harmonic", 0, amplitude | frequency | phase},
    {"step", amplitude, start},
    {"rectangular", amplitude | duration, start},
    {"half-sine", amplitude | duration, start},
    {"triangular", amplitude | duration, start},
    {"chirp", amplitude | frequency | to, phase | start | duration},
    {"logarithmic-chirp", amplitude | frequency | to, phase | start | duration},
    {"unbalance", frequency | unbalance, phase},
    {"base", frequency | base, phase},
};
constexpr Kind from_file{"", file, 0};

constexpr auto kind_names = [] {
  std::array<std::string_view, std::size(kinds)> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kinds[i].name;
  return names;
}();

const Kind* find_kind(std::string_view name) {
  for (const Kind& kind : kinds)
    if (kind.name == name) return &kind;
  return nullptr;
}

bool reads_file(const SimulateOptions& o) { return !o.drive_file.empty() || !o.base_motion.empty(); }

std::string_view asked_kind(const SimulateOptions& o) {
  return o.drive.empty() ? std::string_view("harmonic") : std::string_view(o.drive);
}

Result<void> check_needs(const SimulateOptions& o, const Kind& kind, const std::string& subject) {
  const bool reading = o.read.rate > 0 || !o.read.time_column.empty() || !o.read.delimiter.empty() ||
                       !o.read.decimal.empty() || o.read.skip_bad_rows;
  struct Given {
    std::string_view option;
    unsigned bit;
    bool given;
  };
  const Given all[] = {{"drive-amplitude", amplitude, o.drive_amplitude != 0},
                       {"drive-frequency", frequency, !o.drive_frequency.empty()},
                       {"drive-phase", phase, o.drive_phase != 0},
                       {"drive-start", start, o.drive_start.has_value()},
                       {"drive-duration", duration, o.drive_duration.has_value()},
                       {"drive-to", to, o.drive_to.has_value()},
                       {"unbalance-mass", unbalance, o.unbalance_mass.has_value()},
                       {"eccentricity", unbalance, o.eccentricity.has_value()},
                       {"base-displacement", base, o.base_displacement.has_value()},
                       {"drive-column", file, !o.drive_column.empty()},
                       {"between-samples", file, !o.between_samples.empty()}};
  for (const Given& one : all) {
    if (one.given && !((kind.needs | kind.takes) & one.bit))
      return Error{fmt::format("--{} has no effect with {}; leave one of them out", one.option, subject)};
    if (!one.given && (kind.needs & one.bit) && one.bit != file)
      return Error{fmt::format("{} needs --{}", subject, one.option)};
  }
  if (reading && !(kind.needs & file))
    return Error{
        "--rate, --time-column, --delimiter, --decimal and --skip-bad-rows read a --drive-file or a "
        "--base-motion, and none is given"};
  return {};
}

SampledDrive sampled_drive(const SimulateOptions& o) {
  const DriveRecord& record = *o.drive_record;
  // Ground that accelerates pushes the mass, seen from it, the other way.
  const double factor = o.base_motion.empty() ? 1 : -o.mass;
  SampledDrive drive;
  drive.spacing = record.spacing;
  std::vector<double> force = record.values;
  const BetweenSamples between = between_samples_of(o.between_samples).value_or(BetweenSamples::linear);
  if (between == BetweenSamples::band_limited) {
    force = refine_band_limited(force, finer);
    drive.spacing /= finer;
  } else {
    drive.between = between;
  }
  for (double& value : force) value *= factor;
  drive.force = std::make_shared<const std::vector<double>>(std::move(force));
  return drive;
}

PulseShape shape_of(std::string_view kind) {
  if (kind == "rectangular") return PulseShape::rectangular;
  if (kind == "half-sine") return PulseShape::half_sine;
  return kind == "triangular" ? PulseShape::triangular : PulseShape::step;
}

}  // namespace

std::string_view drive_name(const SimulateOptions& o) {
  if (!o.drive_file.empty()) return "drive-file";
  if (!o.base_motion.empty()) return "base-motion";
  const std::string_view kind = asked_kind(o);
  return kind == "harmonic" && !(o.drive_amplitude > 0) ? "none" : kind;
}

Result<void> check_drive(const SimulateOptions& o) {
  if (!o.drive_file.empty() && !o.base_motion.empty())
    return Error{"--drive-file and --base-motion both drive; give one of them"};
  if (reads_file(o)) {
    const std::string option = o.base_motion.empty() ? "--drive-file" : "--base-motion";
    if (!o.drive.empty())
      return Error{fmt::format("{} and --drive {} both drive; give one of them", option, o.drive)};
    if (!o.between_samples.empty() && !between_samples_of(o.between_samples))
      return Error{
          fmt::format("--between-samples: \"{}\" is none of linear, hold, band-limited", o.between_samples)};
    if (!o.drive_record) return Error{fmt::format("{}: the file's samples were not read", option)};
    return check_needs(o, from_file, option);
  }
  const Kind* kind = find_kind(asked_kind(o));
  if (!kind) {
    std::string message = fmt::format("--drive: there is no drive \"{}\"", o.drive);
    if (const std::string guess = nearest(o.drive, kind_names); !guess.empty())
      message += "; did you mean " + guess + "?";
    message += " (";
    for (std::size_t i = 0; i < kind_names.size(); ++i)
      message += (i ? ", " : "") + std::string(kind_names[i]);
    return Error{message + ")"};
  }
  if (auto good = check_needs(o, *kind, "--drive " + std::string(kind->name)); !good) return good;
  if (kind->name == "harmonic" && o.drive_amplitude > 0 && o.drive_frequency.empty())
    return Error{fmt::format("--drive-amplitude: {} N needs a --drive-frequency (0 is a constant force)",
                             shortest(o.drive_amplitude))};
  if (kind->name == "logarithmic-chirp")
    for (const double from : o.drive_frequency)
      if (!(from > 0 && *o.drive_to > 0))
        return Error{
            "--drive logarithmic-chirp: --drive-frequency and --drive-to must be positive; a sweep from or "
            "to 0 "
            "is --drive chirp"};
  return {};
}

std::optional<HarmonicDrive<double>> harmonic_drive(const SimulateOptions& o, double w, double mass) {
  const std::string_view kind = drive_name(o);
  const auto with = [&](double amplitude) { return HarmonicDrive<double>{amplitude, w, o.drive_phase}; };
  if (kind == "harmonic" || kind == "none") return with(o.drive_amplitude);
  if (kind == "unbalance") return with(*o.unbalance_mass * *o.eccentricity * (w * w));
  // -m y'' of y = Y cos(w t + phi)
  if (kind == "base") return with(mass * *o.base_displacement * (w * w));
  return std::nullopt;
}

Result<void> set_drive(const SimulateOptions& o, double w, SimulatedRun& run) {
  const std::string_view kind = drive_name(o);
  if (reads_file(o)) {
    run.general = sampled_drive(o);
  } else if (const auto harmonic = harmonic_drive(o, w, run.oscillator.mass)) {
    if (kind == "unbalance" && *o.unbalance_mass > o.mass)
      return Error{fmt::format("--unbalance-mass: it is part of --mass ({} kg), and cannot be {} kg",
                               shortest(o.mass), shortest(*o.unbalance_mass))};
    run.drive = *harmonic;
  } else if (kind == "chirp" || kind == "logarithmic-chirp") {
    run.drive.frequency = w;  // by which runs are told apart
    run.general = ChirpDrive<double>{.amplitude = o.drive_amplitude,
                                     .from = w,
                                     .to = *o.drive_to,
                                     .phase = o.drive_phase,
                                     .start = o.drive_start.value_or(0),
                                     .duration = o.drive_duration.value_or(0),
                                     .logarithmic = kind == "logarithmic-chirp"};
  } else {
    run.general = PulseDrive<double>{.shape = shape_of(kind),
                                     .amplitude = o.drive_amplitude,
                                     .start = o.drive_start.value_or(0),
                                     .duration = o.drive_duration.value_or(0)};
  }
  if (!std::isfinite(run.drive.amplitude))
    return Error{
        fmt::format("--drive {}: the force at {} rad/s is beyond the largest number", kind, shortest(w))};
  return {};
}

double drive_period(const SimulatedRun& run) {
  if (!run.general)
    return run.drive.amplitude > 0 && run.drive.frequency > 0 ? two_pi / run.drive.frequency : 0;
  if (const auto* pulse = std::get_if<PulseDrive<double>>(&*run.general)) return pulse->duration;
  if (const auto* chirp = std::get_if<ChirpDrive<double>>(&*run.general)) {
    const double highest = std::max(chirp->from, chirp->to);
    return highest > 0 ? two_pi / highest : 0;
  }
  return 0;
}

double drive_begin(const SimulatedRun& run) {
  if (!run.general) return 0;
  if (const auto* pulse = std::get_if<PulseDrive<double>>(&*run.general)) return pulse->start;
  if (const auto* chirp = std::get_if<ChirpDrive<double>>(&*run.general)) return chirp->start;
  return 0;
}

double drive_end(const SimulatedRun& run) {
  if (!run.general) return 0;
  if (const auto* pulse = std::get_if<PulseDrive<double>>(&*run.general))
    return pulse->start + pulse->duration;
  if (const auto* chirp = std::get_if<ChirpDrive<double>>(&*run.general))
    return chirp->start + chirp->duration;
  return std::get<SampledDrive>(*run.general).duration();
}

Result<void> end_drive(const SimulateOptions& o, SimulatedRun& run) {
  if (!run.general) return {};
  if (auto* chirp = std::get_if<ChirpDrive<double>>(&*run.general)) {
    if (run.method == "exact")
      return Error{
          fmt::format("--method exact: there is no closed form for --drive {}; choose another method, for "
                      "instance dormand-prince or rk4 with a short step",
                      o.drive)};
    if (!o.drive_duration) chirp->duration = run.until - chirp->start;
    if (!(chirp->duration > 0))
      return Error{
          fmt::format("--drive-start: the chirp begins at {} s, and the run ends at {} s; give --until",
                      shortest(chirp->start), shortest(run.until))};
  }
  if (run.method == "exact" && law_of(run.oscillator).has<Friction>())
    return Error{fmt::format(
        "--method exact: with friction there is no closed form under a drive ({}); leave one out or "
        "choose another method",
        drive_name(o))};
  if (const auto* sampled = std::get_if<SampledDrive>(&*run.general);
      sampled && run.until > sampled->duration() * (1 + 1e-9))
    return Error{
        fmt::format("--{}: the recording ends at {:.6g} s, before the run does ({} s); shorten --until",
                    drive_name(o), sampled->duration(), shortest(run.until))};
  return {};
}

}  // namespace cromer::core
