#include "cromer/study/json/documents.h"
#include "cromer/study/json/json.h"
#include "cromer/study/json/recording.h"

namespace cromer {
namespace {

Json quantities(const std::vector<NamedEstimate>& estimates) {
  Json object = Json::object();
  for (const auto& [name, estimate, unit] : estimates)
    object[name] = {{"value", estimate.value},
                    {"standard_error", estimate.standard_error},
                    {"confidence_95", {estimate.low, estimate.high}},
                    {"unit", unit}};
  return object;
}

Json decay_segments(const std::vector<DecaySegment>& segments) {
  Json list = Json::array();
  for (const auto& segment : segments)
    list.push_back({{"from", segment.from},
                    {"to", segment.to},
                    {"rate", segment.rate.value},
                    {"standard_error", segment.rate.standard_error}});
  return list;
}

Json reynolds(const FittedRecording& fitted) {
  if (!fitted.reynolds_max) return nullptr;
  Json windows = Json::array();
  for (const auto& window : fitted.reynolds) windows.push_back({{"t", window.t}, {"value", window.value}});
  Json object = {{"max", fitted.reynolds_max->value},
                 {"standard_error", fitted.reynolds_max->standard_error},
                 {"t", fitted.reynolds_max_t}};
  object["windows"] = std::move(windows);
  return object;
}

Json document(const FittedRecording& fitted) {
  const FreeDecay& fit = fitted.fit;
  Json object;
  object["recording"] = recording_object(fitted);
  object["law"] = to_text(fit.law);
  object["status"] = name(fit.status);
  if (fit.status != FitStatus::converged) object["message"] = fit.message;
  object["iterations"] = fit.iterations;
  object["between_samples"] = nullptr;  // only a recorded force has anything between its samples
  object["parameters"] = quantities(fitted.parameters);
  object["derived"] = quantities(fitted.derived);
  object["simulate"] = fitted.simulate.empty() ? Json(nullptr) : Json(fitted.simulate);
  object["residual"] = {{"rms", fit.residual.rms},
                        {"normality", fit.residual.normality},
                        {"autocorrelation", fit.residual.autocorrelation},
                        {"white", fit.residual.white}};
  Json& candidates = object["candidates"] = Json::array();
  for (const auto& candidate : fitted.candidates)
    candidates.push_back({{"law", to_text(candidate.law)}, {"rms", candidate.rms}, {"bic", candidate.bic}});
  object["decay_segments"] = decay_segments(fitted.segments);
  object["decay_rate_mean"] = fitted.decay_rate_mean ? Json(fitted.decay_rate_mean->value) : Json(nullptr);
  object["decay_rate_mean_standard_error"] =
      fitted.decay_rate_mean ? Json(fitted.decay_rate_mean->standard_error) : Json(nullptr);
  object["reynolds"] = reynolds(fitted);
  object["warnings"] = fitted.warnings;
  return object;
}

}  // namespace

Json recording_object(const FittedRecording& fitted) {
  const Series& series = fitted.series;
  const bool any = !series.t.empty();
  Json object;
  object["file"] = fitted.file;
  object["column"] = series.column;
  object["observed"] = series.quantity.empty() ? Json(nullptr) : Json(series.quantity);
  object["run"] = series.run;
  object["samples"] = fitted.samples;
  object["used"] = series.t.size();
  object["from"] = any ? Json(series.t.front()) : Json(nullptr);
  object["to"] = any ? Json(series.t.back()) : Json(nullptr);
  object["rate"] = or_null(series.rate);
  object["duration"] = any ? Json(series.t.back() - series.t.front()) : Json(nullptr);
  object["gaps"] = series.gaps.size();
  object["outliers"] = series.outliers.size();
  return object;
}

std::string to_json(std::span<const FittedRecording> fits) {
  if (fits.size() == 1) return to_text(document(fits.front()));
  Json all;
  Json& list = all["fits"] = Json::array();
  std::size_t failed = 0;
  for (const auto& fitted : fits) {
    list.push_back(document(fitted));
    failed += fitted.fit.status != FitStatus::converged;
  }
  if (failed > 0)
    all["message"] = std::to_string(failed) + " of " + std::to_string(fits.size()) + " fits did not succeed";
  return to_text(all);
}

}  // namespace cromer
