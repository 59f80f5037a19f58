#include "cromer/tasks/record/live_fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>

#include "cromer/live/rows.h"

namespace cromer::core {
namespace {

constexpr std::size_t fewest = 20;  // rows

/// RMS of the residuals over the standard deviation of the samples; 1 if there is no fit.
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

std::string csv(const SampleRows& rows, std::size_t column, const std::string& heading) {
  std::string text = "Time (s)," + heading + "\n";
  for (std::size_t i = std::max(rows.size(), live_fit_rows) - live_fit_rows; i < rows.size(); ++i)
    append_row(text, rows.t[i], rows.row(i).subspan(column, 1));
  return text;
}

}  // namespace

std::optional<FittedRecording> live_fit(const SampleRows& rows, const Headings& headings,
                                        std::string_view column, const Watch& watch) {
  std::optional<FittedRecording> best;
  if (rows.size() < fewest) return best;
  FitOptions options;
  options.law = "viscous";
  options.recognise_drive = false;
  for (std::size_t c = 0; c < rows.width && c + 1 < headings.size(); ++c) {
    if (!column.empty() && !is_named(headings[c + 1], column)) continue;
    const auto recording = read_recording(csv(rows, c, headings[c + 1]), "recording", {});
    if (!recording) continue;
    auto fits = fit(*recording, options, watch);
    if (!fits || fits->empty() || watch.interrupted()) continue;
    if (!best || unexplained(fits->front()) < unexplained(*best)) best = std::move(fits->front());
  }
  return best;
}

LiveFitter::LiveFitter(const Recorder& recorder, std::string column)
    : recorder_(recorder), column_(std::move(column)), thread_([this] { work(); }) {}

LiveFitter::~LiveFitter() {
  stop_ = true;
  thread_.join();
}

std::shared_ptr<const FittedRecording> LiveFitter::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

// Without memory there is no fit for a while; the recording goes on.
void LiveFitter::work() {
  while (!stop_) {
    try {
      fit_again_and_again();
    } catch (const std::bad_alloc&) {
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  }
}

void LiveFitter::fit_again_and_again() {
  SampleRows rows;
  // Only what is fitted: a copy of all rows might be too much again.
  const std::size_t held = recorder_.status().samples;
  std::size_t seen = held - std::min(held, live_fit_rows);  // of the recorder's rows
  double next = steady_seconds() + 1;
  while (!stop_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double begun = steady_seconds();
    if (begun < next) continue;
    next = begun + 1;
    const SampleRows more = recorder_.rows_since(seen);
    if (more.size() == 0) continue;
    seen += more.size();
    rows.add(more);
    rows.keep_last(live_fit_rows);
    Watch watch;
    watch.interrupt = &stop_;
    auto found = live_fit(rows, recorder_.headings(), column_, watch);
    next = std::max(next, begun + 3 * (steady_seconds() - begun));
    if (!found || stop_) continue;
    const std::lock_guard lock(mutex_);
    latest_ = std::make_shared<const FittedRecording>(*std::move(found));
    ++count_;
  }
}

}  // namespace cromer::core
