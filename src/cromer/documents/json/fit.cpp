#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/estimate.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"
#include "cromer/documents/json/recording.h"

namespace cromer::core {
namespace {

Json quantities(const std::vector<Parameter>& estimates) {
  Json object = Json::object();
  for (const auto& [name, estimate, unit] : estimates) object[name] = estimate_object(estimate, unit);
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

Json keulegan_carpenter(const FittedRecording& fitted) {
  if (!fitted.keulegan_carpenter) return nullptr;
  const Estimate& number = *fitted.keulegan_carpenter;
  return {{"max", number.value},
          {"standard_error", number.standard_error},
          {"confidence_95", {number.low, number.high}}};
}

Json decay_by_amplitude(const std::vector<AmplitudeRate>& rates) {
  Json list = Json::array();
  for (const auto& each : rates)
    list.push_back({{"amplitude", each.amplitude},
                    {"rate", each.rate.value},
                    {"standard_error", each.rate.standard_error},
                    {"confidence_95", {each.rate.low, each.rate.high}},
                    {"law_rate", each.law_rate},
                    {"from", each.from},
                    {"to", each.to}});
  return list;
}

Json stiffness_budget(const std::vector<Contribution>& budget) {
  Json list = Json::array();
  for (const auto& each : budget)
    list.push_back({{"quantity", each.quantity},
                    {"value", each.value},
                    {"standard_uncertainty", each.standard_uncertainty},
                    {"unit", each.unit},
                    {"sensitivity", each.sensitivity},
                    {"contribution", each.contribution},
                    {"share", each.share}});
  return list;
}

Json monte_carlo(const FittedRecording& fitted) {
  const Estimate* stiffness = fitted.find("stiffness");
  if (!fitted.monte_carlo || !stiffness) return nullptr;
  const MonteCarlo& trials = *fitted.monte_carlo;
  return {{"quantity", "stiffness"},
          {"trials", trials.trials},
          {"seed", trials.seed},
          {"mean", trials.mean},
          {"standard_deviation", trials.standard_deviation},
          {"interval_95", {trials.low, trials.high}},
          {"propagated",
           {{"value", stiffness->value},
            {"standard_error", stiffness->standard_error},
            {"confidence_95", {stiffness->low, stiffness->high}}}},
          {"unit", "N/m"}};
}

Json plan(const std::optional<RecordingPlan>& planned, const Voice& voice) {
  if (!planned) return nullptr;
  return {{"quantity", planned->quantity},
          {"unit", planned->unit},
          {"goal", planned->goal},
          {"now", planned->now},
          {"met", planned->met},
          {"possible", planned->possible},
          {"duration", planned->duration},
          {"best", planned->possible ? Json(nullptr) : Json(planned->best)},
          {"text", said(planned->text, voice)}};
}

Json textbook(const FittedRecording& fitted, const Voice& voice) {
  if (!fitted.textbook) return nullptr;
  Json object;
  object["logarithmic_decrement"] = nullptr;
  if (const auto& peaks = fitted.textbook->decrement)
    object["logarithmic_decrement"] = {{"value", peaks->value},
                                       {"standard_error", peaks->standard_error},
                                       {"peaks", peaks->peaks},
                                       {"bias", said(TextbookDamping::decrement_bias(), voice)}};
  object["half_power_bandwidth"] = nullptr;
  if (const auto& line = fitted.textbook->bandwidth)
    object["half_power_bandwidth"] = {
        {"value", line->width},
        {"unit", "rad/s"},
        {"decay_rate", line->width / 2},
        {"damping_ratio", line->width / (2 * line->angular_frequency)},
        {"narrowest", line->narrowest},
        {"bias", "too wide unless the record lasts until the swing has died down"}};
  return object;
}

// Of the fitted parameters; the diagonal is the squares of their standard errors.
Json covariance(const LawFit& fit) {
  Json matrix = Json::array();
  const std::size_t n = fit.names.size();
  for (std::size_t i = 0; i < n; ++i) {
    Json row = Json::array();
    for (std::size_t j = 0; j < n; ++j) row.push_back(fit.covariance[i * n + j]);
    matrix.push_back(std::move(row));
  }
  return {{"parameters", fit.names}, {"matrix", std::move(matrix)}};
}

Json modes(const std::vector<Mode>& found) {
  Json list = Json::array();
  for (const Mode& mode : found)
    list.push_back({{"angular_frequency", mode.angular_frequency.value},
                    {"angular_frequency_standard_error", mode.angular_frequency.standard_error},
                    {"decay_rate", mode.decay_rate.value},
                    {"decay_rate_standard_error", mode.decay_rate.standard_error},
                    {"amplitude", mode.amplitude},
                    {"amplitude_standard_error", mode.amplitude_error}});
  return list;
}

}  // namespace

Json fit_object(const FittedRecording& fitted, const Voice& voice) {
  const LawFit& fit = fitted.fit;
  Json object;
  object["recording"] = recording_object(fitted);
  object["law"] = fitted.wrong_input ? Json(nullptr) : Json(to_text(fit.law));
  object["status"] = fitted.status();
  if (!fitted.succeeded()) object["message"] = said(fit.message, voice);
  if (fitted.wrong_input) return object;
  object["iterations"] = fit.iterations;
  // Only a recorded force has anything between its samples.
  object["between_samples"] = or_null(fitted.between_samples);
  object["parameters"] = quantities(fitted.parameters);
  object["covariance"] = fitted.parameters.empty() ? Json(nullptr) : covariance(fit);
  object["derived"] = quantities(fitted.derived);
  object["simulate"] = or_null(fitted.simulate);
  object["residual"] = {{"rms", fit.residual.rms},
                        {"normality", fit.residual.normality},
                        {"autocorrelation", fit.residual.autocorrelation},
                        {"white", fit.residual.white}};
  Json& candidates = object["candidates"] = Json::array();
  for (const auto& candidate : fitted.candidates) {
    candidates.push_back({{"law", to_text(candidate.law)}, {"rms", candidate.rms}, {"bic", candidate.bic}});
    if (!candidate.between_samples.empty()) candidates.back()["between_samples"] = candidate.between_samples;
  }
  object["modes"] = modes(fitted.modes);
  if (fitted.held_out)
    object["held_out"] = {{"from", fitted.held_out->from},
                          {"to", fitted.held_out->to},
                          {"samples", fitted.held_out->samples},
                          {"rms", fitted.held_out->rms}};
  object["decay_segments"] = decay_segments(fitted.segments);
  object["decay_rate_mean"] = fitted.decay_rate_mean ? Json(fitted.decay_rate_mean->value) : Json(nullptr);
  object["decay_rate_mean_standard_error"] =
      fitted.decay_rate_mean ? Json(fitted.decay_rate_mean->standard_error) : Json(nullptr);
  object["decay_by_amplitude"] = decay_by_amplitude(fitted.decay_by_amplitude);
  object["reynolds"] = reynolds(fitted);
  object["keulegan_carpenter"] = keulegan_carpenter(fitted);
  object["stiffness_budget"] = stiffness_budget(fitted.stiffness_budget);
  object["monte_carlo"] = monte_carlo(fitted);
  object["plan"] = plan(fitted.plan, voice);
  object["textbook"] = textbook(fitted, voice);
  add_notices(object, fitted.notices, voice);
  return object;
}

Json recording_object(const FittedRecording& fitted) {
  const Series& series = fitted.series;
  const bool any = !series.t.empty();
  Json object;
  object["file"] = fitted.file;
  object["column"] = series.column;
  object["observed"] = or_null(series.quantity);
  object["run"] = series.run;
  object["samples"] = fitted.samples;
  object["used"] = fitted.used();
  object["from"] = any ? Json(series.t.front()) : Json(nullptr);
  object["to"] = any ? Json(series.t.back()) : Json(nullptr);
  object["rate"] = or_null(series.rate);
  object["duration"] = any ? Json(series.t.back() - series.t.front()) : Json(nullptr);
  object["gaps"] = series.gaps.size();
  object["outliers"] = series.outliers.size();
  return object;
}

std::string to_json(std::span<const FittedRecording> fits, bool as_list, const Voice& voice) {
  if (fits.size() == 1 && !as_list) return to_text(fit_object(fits.front(), voice));
  Json all;
  Json& list = all["fits"] = Json::array();
  std::size_t failed = 0;
  for (const auto& fitted : fits) {
    list.push_back(fit_object(fitted, voice));
    failed += !fitted.succeeded();
  }
  if (failed > 0)
    all["message"] = std::to_string(failed) + " of " + std::to_string(fits.size()) + " fits did not succeed";
  return to_text(all);
}

}  // namespace cromer::core
