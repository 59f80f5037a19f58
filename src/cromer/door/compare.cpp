#include "cromer/compare.h"

#include <memory>
#include <utility>

#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/tasks/compare/compare.h"

namespace cromer {

Result<Comparison> compare(const LawFit& fit, const CompareOptions& options) {
  if (!fit.detail) return Error{Notice{"fit_is_empty"}, "fit"};
  if (!fit.detail->fit.is_usable())
    return Error{Notice{"fit_without_law", {{"what", fit.detail->fit.message}}}, "fit"};
  core::CompareOptions asked;
  asked.fit = fit.detail->options;
  for (const Method& method : options.method) asked.method.push_back(method.name());
  asked.step = options.step;
  const core::Watching watching(options.progress);
  auto compared = core::compare_fitted(*fit.detail, asked, watching.watch());
  const bool of_arrays = fit.file.empty();
  if (!compared) return core::in_arguments(compared.error(), of_arrays);
  core::put_in_arguments(*compared, of_arrays);
  const auto detail = std::make_shared<const core::CompareResult>(*std::move(compared));
  Comparison comparison;
  comparison.fit = fit;
  for (const core::ComparedCurve& each : detail->curves)
    comparison.curves.push_back({text(each.label), core::to_text(each.law), each.step, each.trajectory,
                                 each.complete, each.rms, each.r_squared, each.amplitude_ratio_end,
                                 each.phase_drift, each.method});
  comparison.explanation = core::message_of(core::in_arguments(core::explanation(*detail), of_arrays));
  comparison.complete = detail->complete;
  comparison.interrupted = watching.watch().interrupted();
  comparison.notices = detail->notices;
  comparison.detail = detail;
  return comparison;
}

}  // namespace cromer
