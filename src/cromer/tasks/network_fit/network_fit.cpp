#include "cromer/tasks/network_fit/network_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cromer/analysis/complex_modes.h"
#include "cromer/base/pi.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/modal/modal_analysis.h"
#include "cromer/identify/modal/still_beginning.h"
#include "cromer/model/linear_network.h"
#include "cromer/read/in_file.h"
#include "cromer/tasks/modes/modes_options.h"

namespace cromer::core {
namespace {

constexpr std::array fit_options{"run",         "from",      "to",      "rate",
                                 "time-column", "delimiter", "decimal", "skip-bad-rows"};

bool is_driven(const Network& network) {
  return std::any_of(network.masses.begin(), network.masses.end(),
                     [](const NetworkMass& mass) { return mass.drive.amplitude > 0; });
}

/// The channels, which must outlive it.
ModalRecord modal_record(const Channels& complete) {
  ModalRecord record;
  for (const Channel& channel : complete.each) record.channels.emplace_back(channel.y);
  set_times(record, complete.t);
  return record;
}

/// Where nothing moves at first, and no beginning was chosen, the samples from the motion's own beginning on.
/// Under a drive a motion may grow that was there before.
Result<void> leave_stillness_out(FittedNetwork& result, const FitOptions& options) {
  if (options.from || is_driven(result.asked.network)) return {};
  Channels complete = result.channels;
  leave_out_incomplete(complete);
  if (complete.t.size() < fewest_modal_samples) return {};
  const ModalRecord record = modal_record(complete);
  if (still_samples(record) == 0) return {};
  const ModalAnalysis found = find_modes(record);
  if (found.still == 0) return {};
  result.notices.push_back(still_before_motion(record, found.still, found.released));
  return crop(result.channels, complete.t[found.still], {});
}

/// A column of positions, or of angles, for each mass.
Result<void> check_columns(const Channels& channels, const NetworkFile& network, const std::string& file) {
  std::vector<std::string> columns;
  for (const Channel& channel : channels.each) columns.push_back(channel.column);
  if (auto good = check_a_column_for_each_mass(columns, network.network, file); !good) return good;
  const char* wanted = network.network.angles ? "angle" : "position";
  if (!channels.quantity.empty() && channels.quantity != wanted)
    return Error{"network_of_another_quantity", {{"file", file}, {"quantity", channels.quantity}}};
  for (const Channel& channel : channels.each)
    if (channel.missing == channels.t.size())
      return Error{in_file(
          file, Notice{"column_without_values", {{"column", channel.column}, {"run", channels.run}}})};
  return {};
}

/// The fit follows smooth motions.
Result<void> check_terms(const Network& network, const std::string& file) {
  const Law law = law_of(network).without(smooth_terms);
  for (std::size_t i = 0; i < term_count; ++i)
    if (law.has(i)) return Error{"term_not_in_networks", {{"file", file}, {"term", term_infos[i].name}}};
  return {};
}

Result<void> check_sought(const NetworkFile& network, const std::string& file) {
  if (network.open.empty()) return Error{"network_seeks_nothing", {{"file", file}}};
  const std::size_t masses = network.network.masses.size(), most = most_sought(masses);
  if (network.open.size() > most)
    return Error{"too_much_sought",
                 {{"file", file}, {"sought", network.open.size()}, {"masses", masses}, {"most", most}}};
  return {};
}

/// "stiffness of left–right"; of several links there the second is "stiffness of left–right 2".
Notice value_of_link(const FittedNetwork& result, std::size_t value) {
  const Network& network = result.asked.network;
  const OpenValue& open = result.asked.open[value];
  const NetworkLink& link = network.links[open.value.link];
  std::string to = name_of(network, link.to);
  if (const std::size_t before = static_cast<std::size_t>(std::count_if(
          network.links.begin(), network.links.begin() + static_cast<std::ptrdiff_t>(open.value.link),
          [&](const NetworkLink& other) { return other.from == link.from && other.to == link.to; }));
      before > 0)
    to += " " + std::to_string(before + 1);
  return Notice{"value_of_link", {{"value", open.key}, {"from", name_of(network, link.from)}, {"to", to}}};
}

/// Of which the network accounts for least.
const FittedColumn& worst_column(const FittedNetwork& result) {
  return *std::min_element(result.fit.columns.begin(), result.fit.columns.end(),
                           [](const auto& a, const auto& b) { return a.explained < b.explained; });
}

Notice explains_little(const FittedNetwork& result) {
  const FittedColumn& worst = worst_column(result);
  const auto at = static_cast<std::size_t>(&worst - result.fit.columns.data());
  return Notice{"network_explains_little",
                {{"column", result.channels.each[at].column},
                 {"percent", 100 * std::max(0.0, worst.explained)},
                 {"hint", Notice{"columns_may_be_swapped"}}}};
}

/// Why the fit did not succeed.
Notice why_no_success(const FittedNetwork& result) {
  switch (result.fit.status) {
    case FitStatus::converged:
      return {};
    case FitStatus::too_short:
      return Notice{"network_record_too_short"};
    case FitStatus::no_oscillation: {
      for (const Channel& channel : result.channels.each)
        if (never_changes(channel)) return Notice{"column_never_changes", {{"column", channel.column}}};
      return Notice{"network_record_too_short"};
    }
    case FitStatus::too_noisy:
      return explains_little(result);
    case FitStatus::undetermined: {
      // What another network moves tells nothing of this one's values.
      if (!explains(result.fit.columns)) return explains_little(result);
      std::vector<Notice> values;
      for (const std::size_t j : result.fit.undetermined) values.push_back(value_of_link(result, j));
      if (values.size() == 1) return Notice{"network_value_undetermined", {{"value", values.front()}}};
      return Notice{"network_values_undetermined", {{"values", values}}};
    }
    default: {
      const Notice hint{"columns_may_be_swapped"};
      if (result.fit.runs_away) return Notice{"network_runs_away", {{"hint", hint}}};
      return Notice{"network_not_converged", {{"iterations", result.fit.iterations}, {"hint", hint}}};
    }
  }
}

/// What is left of a column, if it is no noise.
struct MotionLeft {
  double times_noise = 0;  ///< from sample to sample; 0 where it does not exceed that
  double line = 0;         // [Hz] of the mode that it swings in; 0: in none
};

/// |eigenvalue| [rad/s].
double size_of_eigenvalue(const ComplexMode& mode) { return std::sqrt(std::abs(mode.law().stiffness)); }

/// Left of a motion is what dies down as the whole does, or swings as a mode does.
MotionLeft motion_left_of(const FittedNetwork& result, std::size_t column,
                          const std::vector<ComplexMode>& modes) {
  const Channel& channel = result.channels.each[column];
  std::vector<double> t, left, values;
  for (std::size_t n = 0; n < channel.y.size(); ++n)
    if (!std::isnan(channel.y[n])) {
      t.push_back(result.channels.t[n]);
      left.push_back(result.fit.columns[column].residual[n]);
      values.push_back(channel.y[n]);
    }
  const double noise = noise_of(left), rms = result.fit.columns[column].rms;
  if (is_arithmetic(rms, values) || rms <= channel.resolution) return {};
  MotionLeft found;
  for (const ComplexMode& mode : modes) {
    const double w = size_of_eigenvalue(mode);
    if (w > 0 && leaves_a_line(t, left, mode.law().decay_rate, w)) found.line = w / two_pi;
  }
  constexpr double falls = 4;
  if (exceeds_noise(values, channel.resolution, rms, autocorrelations(left, 1)[1], noise) &&
      (found.line > 0 || dies_down(left, falls)))
    found.times_noise = times_noise(rms, noise);
  return found;
}

/// Which column shows most that the network leaves a motion, or the first that a line is left of below the
/// noise; empty where none does.
Notice motion_left(const FittedNetwork& result) {
  const std::vector<ComplexMode> modes = complex_modes(linearised(result.fit.network));
  Notice line;
  std::size_t worst = 0;
  double most = 0;
  for (std::size_t i = 0; i < result.fit.columns.size(); ++i) {
    const MotionLeft left = motion_left_of(result, i, modes);
    if (left.times_noise > most) most = left.times_noise, worst = i;
    if (left.line > 0 && line.empty())
      line = Notice{"network_leaves_a_line",
                    {{"column", result.channels.each[i].column}, {"frequency", left.line}}};
  }
  if (most == 0) return line;
  return Notice{"network_leaves_a_motion", {{"column", result.channels.each[worst].column}, {"times", most}}};
}

/// A mode that the recording shows and a linear network lacks, where the network does not account for nearly
/// all: the fit may have ended beside the best values. Empty where there is none.
Notice mode_that_is_lacking(const FittedNetwork& result) {
  constexpr double nearly_all = 0.98, near = 0.03, standard_errors = 5;
  const Network& network = result.fit.network;
  if (is_driven(network) || !is_linear(law_of(network)) || worst_column(result).explained > nearly_all)
    return {};
  Channels complete = result.channels;
  leave_out_incomplete(complete);
  if (complete.t.size() < fewest_modal_samples) return {};
  const ModalAnalysis found = find_modes(modal_record(complete));
  if (found.motion != ModalMotion::free_decay || found.modes.size() > network.masses.size()) return {};
  const std::vector<ComplexMode> modes = complex_modes(linearised(network));
  for (const MeasuredMode& mode : found.modes) {
    const double f = mode.frequency.value,
                 reach = std::max(near * f, standard_errors * mode.frequency.standard_error);
    const bool has_it = std::any_of(modes.begin(), modes.end(), [&](const ComplexMode& each) {
      return std::abs(size_of_eigenvalue(each) / two_pi - f) < reach;
    });
    if (!has_it) return Notice{"network_lacks_a_mode", {{"frequency", f}}};
  }
  return {};
}

/// A mode of the fitted network that samples at even times show as a slower one; empty where there is none.
Notice mode_above_half_rate(const FittedNetwork& result) {
  const double rate = result.channels.rate;
  if (rate <= 0) return {};
  for (const ComplexMode& mode : complex_modes(linearised(result.fit.network))) {
    const double w = size_of_eigenvalue(mode), frequency = w / two_pi;
    if (frequency > rate / 2 && mode.law().decay_rate < w)
      return Notice{"network_above_half_rate",
                    {{"frequency", frequency},
                     {"half", rate / 2},
                     {"mirror", std::abs(std::remainder(frequency, rate))}}};
  }
  return {};
}

void add_doubts(FittedNetwork& result) {
  if (!result.succeeded()) return;
  if (Notice above = mode_above_half_rate(result); !above.empty()) result.notices.push_back(std::move(above));
  if (Notice left = motion_left(result); !left.empty()) result.notices.push_back(std::move(left));
  if (Notice lacking = mode_that_is_lacking(result); !lacking.empty())
    result.notices.push_back(std::move(lacking));
  for (std::size_t j = 0; j < result.fit.values.size(); ++j) {
    const Estimate& found = result.fit.values[j];
    if (!std::isfinite(found.standard_error)) continue;
    const NetworkLink& link = result.asked.network.links[result.asked.open[j].value.link];
    if (found.low <= 0 && found.high >= 0)
      result.notices.push_back(Notice{"network_value_may_be_zero", {{"what", value_of_link(result, j)}}});
    else if (found.high < 0 && result.asked.open[j].key == "stiffness" && link.from != ground &&
             link.to != ground)
      result.notices.push_back(Notice{"network_pushes_apart", {{"what", value_of_link(result, j)}}});
  }
}

}  // namespace

std::vector<Parameter> FittedNetwork::found_of(std::size_t link) const {
  std::vector<Parameter> found;
  for (std::size_t j = 0; j < fit.values.size(); ++j)
    if (asked.open[j].value.link == link)
      found.push_back({asked.open[j].key, fit.values[j], asked.open[j].unit});
  return found;
}

bool is_fit_option_of_networks(std::string_view option) {
  return std::find(fit_options.begin(), fit_options.end(), option) != fit_options.end();
}

Result<FittedNetwork> fit_network(const Recording& recording, const NetworkFile& network,
                                  const std::string& network_file, const FitOptions& options,
                                  const Watch& watch) {
  if (auto good = check_terms(network.network, network_file); !good) return good.error();
  if (auto good = check_sought(network, network_file); !good) return good.error();
  auto channels = take_channels(recording, options.run, options.read);
  if (!channels) return channels.error();
  FittedNetwork result{.file = recording.file,
                       .network_file = network_file,
                       .channels = *std::move(channels),
                       .asked = network};
  if (auto good = crop(result.channels, options.from, options.to); !good) return good.error();
  if (auto good = check_columns(result.channels, network, recording.file); !good) return good.error();
  if (auto good = check_no_channel_dies(result.channels, recording.file); !good) return good.error();
  result.notices = recording.notices;
  result.notices.insert(result.notices.end(), result.channels.notices.begin(), result.channels.notices.end());

  if (auto good = leave_stillness_out(result, options); !good) return good.error();
  if (result.channels.t.size() >= fewest_modal_samples) {
    ModalRecord clock;
    set_times(clock, result.channels.t);
    if (Notice drifts = drifting_clock(clock); !drifts.empty()) result.notices.push_back(std::move(drifts));
  }
  NetworkRecord record{result.channels.t, {}};
  for (const Channel& channel : result.channels.each) record.y.emplace_back(channel.y);
  std::vector<SoughtValue> sought;
  for (const OpenValue& each : network.open) sought.push_back(each.value);
  result.fit = fit_network(network.network, sought, record, watch);
  result.message = why_no_success(result);
  add_doubts(result);
  return result;
}

}  // namespace cromer::core
