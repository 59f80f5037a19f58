#include "cromer/compare.h"

#include <memory>
#include <utility>

#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/study/task/compare.h"

namespace cromer {

Result<Comparison> compare(const LawFit& fit, const CompareOptions& options) {
  if (!fit.detail) return Error{"the fit is empty: fit() fills one", "fit"};
  if (!fit.detail->fit.is_usable()) return Error{"the fit has no law to be compared: " + fit.message, "fit"};
  core::CompareOptions asked;
  asked.fit = fit.detail->options;
  asked.method = options.method.name();
  asked.step = options.step;
  const core::Watching watching(options.progress);
  auto compared = core::compare_fitted(*fit.detail, asked, watching.watch());
  if (!compared) return core::in_arguments(compared.error(), fit.file.empty());
  const auto detail = std::make_shared<const core::CompareResult>(*std::move(compared));
  Comparison comparison;
  comparison.fit = fit;
  for (const core::ComparedCurve& each : detail->curves)
    comparison.curves.push_back({each.label, core::to_text(each.law), each.step, each.trajectory,
                                 each.complete, each.rms, each.r_squared, each.amplitude_ratio_end,
                                 each.phase_drift});
  comparison.explanation = core::in_arguments(core::explanation(*detail), fit.file.empty());
  comparison.complete = detail->complete;
  comparison.interrupted = watching.watch().interrupted();
  comparison.warnings = core::in_arguments(detail->warnings, fit.file.empty());
  comparison.detail = detail;
  return comparison;
}

}  // namespace cromer
