#include "cromer/tasks/record/live_fit.h"

#include <algorithm>
#include <cmath>

#include "cromer/live/rows.h"

namespace cromer::core {
namespace {

constexpr std::size_t fewest = 20;  // rows

/// What the fit leaves of the swing's spread; 1 where there is no fit.
double unexplained(const FittedRecording& fitted) {
  if (!fitted.succeeded()) return 1;
  double mean = 0, squares = 0, n = 0;
  for (const double y : fitted.series.y) {
    ++n;
    const double from_mean = y - mean;
    mean += from_mean / n;
    squares += from_mean * (y - mean);
  }
  return squares > 0 ? fitted.fit.residual.rms / std::sqrt(squares / n) : 1;
}

std::string csv(const Rows& rows, std::size_t column, const std::string& heading) {
  std::string text = "Time (s)," + heading + "\n";
  for (std::size_t i = std::max(rows.size(), live_fit_rows) - live_fit_rows; i < rows.size(); ++i)
    append_row(text, rows.t[i], rows.row(i).subspan(column, 1));
  return text;
}

}  // namespace

std::optional<FittedRecording> live_fit(const Rows& rows, const Headings& headings, std::string_view column,
                                        const Watch& watch) {
  std::optional<FittedRecording> best;
  if (rows.size() < fewest) return best;
  FitOptions options;
  options.law = "viscous";
  options.recognise_drive = false;
  for (std::size_t c = 0; c < rows.width && c + 1 < headings.size(); ++c) {
    if (!column.empty() && !is_named(headings[c + 1], column)) continue;
    auto fits = fit(csv(rows, c, headings[c + 1]), "recording", options, watch);
    if (!fits || fits->empty() || watch.interrupted()) continue;
    if (!best || unexplained(fits->front()) < unexplained(*best)) best = std::move(fits->front());
  }
  return best;
}

}  // namespace cromer::core
