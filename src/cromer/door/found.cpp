#include "cromer/door/found.h"

#include <algorithm>

#include "cromer/documents/csv.h"
#include "cromer/documents/text.h"
#include "cromer/door/results.h"

namespace cromer::core {
namespace {

/// How each result is written; a form that a result lacks is an Error.
struct Writer {
  std::string_view form;

  Result<std::string> operator()(const std::monostate&) const { return Error{"no_result"}; }

  Result<std::string> operator()(const ReadFile& read) const {
    if (form == "text") return inspect_text(read.inspection);
    if (form == "csv") return recording_csv(read.inspection.recording, read.options);
    return has_no_form();
  }

  Result<std::string> operator()(const std::vector<FittedRecording>& fits) const {
    if (form == "text") return fits.size() > 1 ? fit_table(fits) : fit_text(fits);
    if (form == "csv") return fit_csv(fits);
    return drawn(fit_figure(fits));
  }

  Result<std::string> operator()(const SimulateResult& result) const {
    if (form == "text") return simulate_text(result);
    if (form == "csv") return simulate_csv(result, no_command);
    return drawn(simulate_figure(result));
  }

  Result<std::string> operator()(const std::vector<CompareResult>& comparisons) const {
    if (form == "text") return compare_text(comparisons);
    if (form == "csv") return compare_csv(comparisons);
    return drawn(compare_figure(comparisons));
  }

  Result<std::string> operator()(const ListedMethods& methods) const {
    if (form == "text") return methods_text(methods.options, methods.rows);
    return has_no_form();
  }

  Result<std::string> operator()(const RecogniseResult& result) const {
    if (form == "text") return recognise_text(result);
    return has_no_form();
  }

  Result<std::string> operator()(const ModesResult& result) const {
    if (form == "text") return modes_text(result);
    if (form == "csv") return modes_csv(result);
    return drawn(modes_figure(result));
  }

  Result<std::string> operator()(const std::vector<NetworkRun>& runs) const {
    if (form == "text") return network_text(runs);
    if (form == "csv") return network_csv(runs, no_command);
    return drawn(network_figure(runs));
  }

  Result<std::string> operator()(const FittedNetwork& fitted) const {
    if (form == "text") return network_fit_text(fitted);
    if (form == "csv") return network_fit_csv(fitted);
    return drawn(network_fit_figure(fitted));
  }

  Result<std::string> operator()(const SpectrumResult& result) const {
    if (form == "text") return spectrum_text(result);
    if (result.interrupted) return Error{"no_result"};
    if (form == "csv") return spectrum_csv(result, no_command);
    return drawn(spectrum_figure(result));
  }

  Result<std::string> operator()(const SweepResult& result) const {
    if (form == "text") return sweep_text(result);
    if (form == "csv") return sweep_csv(result, no_command);
    const auto figure = sweep_figure(result);
    if (!figure) return figure.error();
    return drawn(*figure);
  }

  Error has_no_form() const { return Error{Notice{"no_such_form", {{"form", form}}}, "form"}; }
};

}  // namespace

std::string drawn(const Figure& figure) { return *draw(figure, FigureFormat::svg); }

Result<std::string> written_as(const Found& found, std::string_view form) {
  const std::vector<std::string> known{"text", "csv", "svg"};
  if (std::find(known.begin(), known.end(), form) == known.end())
    return Error{Notice{"word_not_known", {{"argument", "form"}, {"word", form}, {"known", known}}}, "form"};
  return std::visit(Writer{form}, found);
}

Result<Trajectory> motion_of_run(const Found& found, int run, std::span<const double> t) {
  if (const auto* fits = std::get_if<std::vector<FittedRecording>>(&found))
    for (const FittedRecording& each : *fits)
      if (each.series.run == run) return motion_at(each, t);
  return Error{Notice{"no_fit_of_that_run", {{"run", run}}}, "run"};
}

}  // namespace cromer::core
