#include "cromer/identify/mean_decay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/analysis/amplitude_decay.h"
#include "cromer/base/quantity.h"
#include "cromer/identify/describe_fit.h"

namespace cromer {
namespace {

// Each damping term with the rate it makes per unit of its coefficient.
std::vector<std::pair<std::string_view, double>> parts_of(const FreeDecay& fit, double amplitude) {
  const double w = fit.angular_frequency.value;
  std::vector<std::pair<std::string_view, double>> parts;
  if (fit.law.viscous) parts.emplace_back("decay_rate", 0.0);
  if (fit.drag) parts.emplace_back("drag", 0.0);
  if (fit.friction) parts.emplace_back("friction", 0.0);
  for (auto& [name, per_unit] : parts) {
    AmplitudeDecay one{.angular_frequency = w, .decay_rate = 0, .drag = 0, .friction = 0};
    (name == "decay_rate" ? one.decay_rate : name == "drag" ? one.drag : one.friction) = 1;
    per_unit = one.rate(amplitude);
  }
  return parts;
}

}  // namespace

MeanDecay mean_decay(const FreeDecay& fit, const Record& record) {
  MeanDecay decay;
  const double w = fit.angular_frequency.value;
  decay.amplitude = centred_norm(record.y) * std::sqrt(2 / static_cast<double>(record.y.size())) /
                    std::pow(w, record.derivative);
  const auto parts = parts_of(fit, decay.amplitude);
  double rate = 0, variance = 0;
  for (const auto& [name, per_unit] : parts) {
    rate += per_unit * (name == "decay_rate" ? fit.decay_rate
                        : name == "drag"     ? *fit.drag
                                             : *fit.friction)
                           .value;
    for (const auto& [other, per_other] : parts)
      variance += per_unit * per_other * fit.covariance_of(name, other);
  }
  decay.rate = make_estimate(rate, std::sqrt(std::max(0.0, variance)), fit.student);
  return decay;
}

bool dampings_are_collinear(const FreeDecay& fit) {
  constexpr double collinear = -0.9;
  for (const auto& [one, other] : {std::pair{"decay_rate", "drag"}, std::pair{"decay_rate", "friction"},
                                   std::pair{"drag", "friction"}}) {
    const double variances = fit.covariance_of(one, one) * fit.covariance_of(other, other);
    if (variances > 0 && fit.covariance_of(one, other) < collinear * std::sqrt(variances)) return true;
  }
  return false;
}

std::string to_text(const MeanDecay& decay) {
  return fmt::format("decay rate {} at the record's mean amplitude",
                     format_quantity({decay.rate.value, decay.rate.standard_error}, "1/s"));
}

}  // namespace cromer
