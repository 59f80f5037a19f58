#include "cromer/tasks/simulate/drive_setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cromer/base/nearest.h"
#include "cromer/base/pi.h"
#include "cromer/model/between_samples.h"
#include "cromer/model/law_force.h"

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

/// The option that names the file.
Notice file_option(const SimulateOptions& o) {
  return o.base_motion.empty() ? Notice{"drive_file_option"} : Notice{"base_motion_option"};
}

Result<void> check_needs(const SimulateOptions& o, const Kind& kind, const Notice& subject) {
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
      return Error{"no_effect_with_drive", {{"option", one.option}, {"drive", subject}}};
    if (!one.given && (kind.needs & one.bit) && one.bit != file)
      return Error{"drive_needs_option", {{"drive", subject}, {"option", one.option}}};
  }
  if (reading && !(kind.needs & file)) return Error{"nothing_to_read"};
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
  if (!o.drive_file.empty() && !o.base_motion.empty()) return Error{"two_recorded_drives"};
  if (reads_file(o)) {
    const Notice option = file_option(o);
    if (!o.drive.empty()) return Error{"recording_and_drive", {{"recording", option}, {"drive", o.drive}}};
    if (!o.between_samples.empty() && !between_samples_of(o.between_samples))
      return Error{"no_such_between_samples", {{"word", o.between_samples}}};
    if (!o.drive_record) return Error{"samples_not_read", {{"recording", option}}};
    return check_needs(o, from_file, option);
  }
  const Kind* kind = find_kind(asked_kind(o));
  if (!kind) {
    const std::vector<std::string> all(kind_names.begin(), kind_names.end());
    if (const std::string near = nearest(o.drive, kind_names); !near.empty())
      return Error{"no_drive_but", {{"drive", o.drive}, {"near", near}, {"drives", all}}};
    return Error{"no_drive", {{"drive", o.drive}, {"drives", all}}};
  }
  if (auto good = check_needs(o, *kind, Notice{"drive_option", {{"drive", kind->name}}}); !good) return good;
  if (kind->name == "harmonic" && o.drive_amplitude > 0 && o.drive_frequency.empty())
    return Error{"drive_needs_frequency", {{"amplitude", o.drive_amplitude}}};
  if (kind->name == "logarithmic-chirp")
    for (const double from : o.drive_frequency)
      if (!(from > 0 && *o.drive_to > 0)) return Error{"logarithmic_chirp_not_positive"};
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
      return Error{"unbalance_heavier_than_mass", {{"mass", o.mass}, {"unbalance", *o.unbalance_mass}}};
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
    return Error{"drive_too_large", {{"drive", kind}, {"frequency", w}}};
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
    if (run.method == "exact") return Error{"exact_under_chirp", {{"drive", o.drive}}};
    if (!o.drive_duration) chirp->duration = run.until - chirp->start;
    if (!(chirp->duration > 0))
      return Error{"chirp_begins_after_end", {{"start", chirp->start}, {"until", run.until}}};
  }
  if (run.method == "exact" && law_of(run.oscillator).has<Friction>())
    return Error{"exact_with_friction_under", {{"drive", drive_name(o)}}};
  if (const auto* sampled = std::get_if<SampledDrive>(&*run.general);
      sampled && run.until > sampled->duration() * (1 + 1e-9))
    return Error{"recording_ends_before_run",
                 {{"recording", file_option(o)}, {"end", sampled->duration()}, {"until", run.until}}};
  return {};
}

}  // namespace cromer::core
