#include "cromer/documents/json.h"

#include <algorithm>
#include <span>
#include <type_traits>

#include "cromer/documents/described/compare.h"
#include "cromer/documents/described/fit.h"
#include "cromer/documents/described/inspect.h"
#include "cromer/documents/described/methods.h"
#include "cromer/documents/described/modes.h"
#include "cromer/documents/described/network_fit.h"
#include "cromer/documents/described/network_run.h"
#include "cromer/documents/described/recognise.h"
#include "cromer/documents/described/simulate.h"
#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/described/spring.h"
#include "cromer/documents/described/sweep.h"
#include "cromer/documents/json/described.h"
#include "cromer/tasks/fit/said_of_runs.h"

namespace cromer::core {

std::string to_json(const SimulateResult& result, bool with_states, const Voice& voice) {
  Json document;
  Json& runs = document["runs"] = Json::array();
  std::string message;
  for (const auto& run : result.runs) {
    runs.push_back(json_of(DescribedRun{run, result.options, with_states}, voice));
    if (!run.message.empty())
      message += (message.empty() ? "" : "; ") + run.label + ": " + in_words(run.message, voice);
  }
  add_notices(document, result.notices, voice);
  if (!message.empty()) document["message"] = message;
  return to_text(document, with_states);
}

std::string to_json(std::span<const MethodRow> methods, const Voice& voice) {
  Json document;
  Json& rows = document["methods"] = Json::array();
  for (const auto& method : methods) rows.push_back(json_of(method, voice));
  return to_text(document);
}

// The page has not these tasks, or has documents of its own for them.
#ifndef CROMER_PAGE

std::string to_json(const RecogniseResult& result, const Voice& voice) {
  Json document = json_of(result, voice);
  if (!result.ok()) document["message"] = said(result.words, voice);
  return to_text(document);
}

std::string to_json(std::span<const NetworkRun> runs, bool with_states, const Voice& voice) {
  Json all = Json::array();
  for (const NetworkRun& run : runs) {
    Json& document = all.emplace_back(json_of(NetworkDocument{run, with_states}, voice));
    if (!run.message.empty()) document["message"] = said(run.message, voice);
  }
  return to_text(runs.size() == 1 ? all.front() : Json{{"runs", std::move(all)}}, with_states);
}

std::string to_json(const FittedNetwork& fitted, const Voice& voice) {
  Json document = json_of(fitted, voice);
  if (!fitted.message.empty()) document["message"] = said(fitted.message, voice);
  return to_text(document);
}

std::string to_json(const ModesResult& result, const Voice& voice) { return to_text(json_of(result, voice)); }

std::string to_json(const SweepResult& result, bool with_rows, const Voice& voice) {
  return to_text(json_of(SweepDocument{result, with_rows}, voice), true);
}

std::string to_json(const SpectrumResult& result, bool with_fourier, const Voice& voice, bool with_curves) {
  return to_text(json_of(SpectrumDocument{result, with_fourier, with_curves}, voice), with_fourier);
}

std::string to_json(std::span<const MotionSpectra> motions, const Voice& voice,
                    std::span<const std::string> missing) {
  // Motion by motion: as a tree of values all of them would need ten times the memory.
  std::string out = "{\"motions\":[";
  std::size_t failed = 0;
  for (const MotionSpectra& motion : motions) {
    if (&motion != &motions.front()) out += ',';
    std::string one = to_text(json_of(motion, voice), true);
    one.erase(one.find_last_not_of('\n') + 1);
    out += one;
    failed += !motion.succeeded();
  }
  out += ']';
  if (failed > 0)
    out += ",\"message\":" +
           Json(said(Notice{"motions_failed", {{"failed", failed}, {"all", motions.size()}}}, voice)).dump();
  if (!missing.empty()) out += ",\"missing\":" + Json(missing).dump();
  return out + "}\n";
}

std::string to_json(const Inspection& inspection, bool with_values, const Voice& voice) {
  return to_text(json_of(InspectedFile{inspection, with_values}, voice), with_values);
}

namespace {

/// Puts notices that name their run into the place of those that do not.
template <class Result>
void name_the_run(Json& document, const Result& result, const Voice& voice) {
  if (document.contains("notices")) add_notices(document, said_of_runs(std::span(&result, 1)), voice);
}

template <class Result>
Json one_of_list(const Result& result, const Voice& voice) {
  Json document = json_of(result, voice);
  name_the_run(document, result, voice);
  if constexpr (std::is_same_v<Result, CompareResult>) name_the_run(document["fit"], result.recording, voice);
  return document;
}

/// {name: [...]}, with "message" if any of its fits failed.
template <class Result>
Json list_of(const char* name, std::span<const Result> results, std::size_t failed, const Voice& voice) {
  Json document;
  Json& list = document[name] = Json::array();
  for (const Result& each : results) list.push_back(one_of_list(each, voice));
  if (failed > 0)
    document["message"] = said(Notice{"fits_failed", {{"failed", failed}, {"all", results.size()}}}, voice);
  return document;
}

Json list_of(std::span<const FittedRecording> fits, const Voice& voice) {
  const auto failed = std::count_if(fits.begin(), fits.end(),
                                    [](const FittedRecording& fitted) { return !fitted.succeeded(); });
  return list_of("fits", fits, static_cast<std::size_t>(failed), voice);
}

}  // namespace

std::string to_json(std::span<const FittedRecording> fits, bool as_list, const Voice& voice,
                    std::span<const std::string> missing) {
  if (fits.size() == 1 && !as_list) return to_text(json_of(fits.front(), voice));
  Json all = list_of(fits, voice);
  if (!missing.empty()) all["missing"] = missing;
  return to_text(all);
}

std::string to_json(std::span<const CompareResult> comparisons, const Voice& voice) {
  if (comparisons.size() == 1) return to_text(json_of(comparisons.front(), voice));
  const auto failed =
      std::count_if(comparisons.begin(), comparisons.end(), [](const CompareResult& comparison) {
        return comparison.recording.fit.status != FitStatus::converged;
      });
  return to_text(list_of("comparisons", comparisons, static_cast<std::size_t>(failed), voice));
}

std::string to_json(const StaticStiffness& found) { return to_text(json_of(found, {})); }

std::string to_json(std::span<const FittedRecording> fits, const MassLine& line) {
  Json all = list_of(fits, {});
  all["mass_line"] = json_of(line, {});
  return to_text(all);
}

#endif

}  // namespace cromer::core
