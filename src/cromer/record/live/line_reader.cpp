#include "cromer/record/live/line_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/base/quantity.h"
#include "cromer/record/live/headings.h"

namespace cromer {
namespace {

constexpr std::size_t longest_line = 1000;  // bytes
constexpr std::size_t widest = 32;          // numbers in a line

/// "Time (ms)" in seconds: 0.001; nothing where no unit of time stands in brackets.
std::optional<double> seconds_of(std::string_view heading) {
  const std::size_t open = heading.find_first_of("(["), close = heading.find_last_of(")]");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return std::nullopt;
  const auto unit = parse_unit(heading.substr(open + 1, close - open - 1));
  if (!unit || unit->dimension != Dimension{.second = 1}) return std::nullopt;
  return unit->factor;
}

/// Words as a device announces them are those of a heading if there is one for each number and they say more
/// than "ready" does.
bool is_heading(const std::vector<std::string>& words, std::size_t fields) {
  if (words.size() != fields) return false;
  return fields > 1 || words.front().find_first_of("([") != std::string::npos;
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (;;) {
    const std::size_t end = text.find(',');
    names.emplace_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return names;
    text.remove_prefix(end + 1);
  }
}

}  // namespace

void LineReader::take(std::string_view bytes, double arrival, Rows& rows, std::vector<Notice>& notices) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find_first_of("\n\r");
    const std::string_view piece = bytes.substr(0, end);
    bytes.remove_prefix(std::min(bytes.size(), end == std::string_view::npos ? end : end + 1));
    if (!too_long_) partial_ += piece;
    if (partial_.size() > longest_line) {
      ++line_;
      if (!within_line_) refuse(partial_, line_, notices);
      partial_.clear();
      too_long_ = true;
    }
    if (end == std::string_view::npos) return;
    if (!partial_.empty()) {
      ++line_;
      if (!within_line_) take_line(partial_, arrival, rows, notices);
      partial_.clear();
    }
    within_line_ = too_long_ = false;
  }
}

void LineReader::end(double arrival, Rows& rows, std::vector<Notice>& notices) {
  if (!partial_.empty() && !within_line_) ++line_, take_line(partial_, arrival, rows, notices);
  partial_.clear();
  release_all(rows, notices);
}

void LineReader::let_go(const std::vector<double>& times, Rows& rows) {
  if (!times.empty()) rows.width = 1;
  for (std::size_t i = 0; i < times.size(); ++i) rows.add(times[i], {&held_[i], 1});
  held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(times.size()));
}

void LineReader::release(double now, Rows& rows, std::vector<Notice>& notices) {
  std::vector<double> times;
  arrivals_.release(now, times, notices);
  let_go(times, rows);
}

void LineReader::release_all(Rows& rows, std::vector<Notice>& notices) {
  std::vector<double> times;
  arrivals_.release_all(times, notices);
  let_go(times, rows);
}

SampleTimes LineReader::times() const {
  if (fields_ == 0) return {};
  if (timed_) return {TimesBy::device};
  return settings_.rate > 0 ? SampleTimes{TimesBy::count} : arrivals_.sample_times();
}

void LineReader::connection_lost() {
  partial_.clear();
  too_long_ = false;
  within_line_ = true;
}

void LineReader::refuse(std::string_view text, long line, std::vector<Notice>& notices) {
  ++garbage_;
  notices.push_back({NoticeKind::garbage, fmt::format("line {} is no sample: \"{}\"", line, shown(text))});
}

// 1234 ms are 1.234 s, not 1.2340000000000002.
double LineReader::in_seconds(double device) const {
  return to_seconds_ == 1 ? device : to_15_digits(device * to_seconds_);
}

void LineReader::begin(std::size_t fields) {
  fields_ = fields;
  timed_ = fields > 1;
  const std::size_t values = timed_ ? fields - 1 : 1;
  if (is_heading(heading_, fields)) {
    headings_ = heading_;
    if (timed_) {
      to_seconds_ = seconds_of(headings_.front()).value_or(1);
      headings_.erase(headings_.begin());
    }
  } else {
    headings_.clear();
    for (std::size_t i = 1; i <= values; ++i)
      headings_.push_back(values == 1 ? "Value" : fmt::format("Value {}", i));
  }
  if (!settings_.headings.empty()) {
    const auto names = names_in(settings_.headings);
    for (std::size_t i = 0; i < std::min(names.size(), values); ++i) headings_[i] = names[i];
  }
  if (settings_.time_unit > 0) to_seconds_ = settings_.time_unit;
  headings_.insert(headings_.begin(), "Time (s)");
  for (auto& heading : headings_) heading = plain_heading(std::move(heading));
}

void LineReader::take_line(std::string_view text, double arrival, Rows& rows, std::vector<Notice>& notices) {
  Line line = read_line(text);
  if (line.kind == LineKind::blank || line.kind == LineKind::comment) return;
  // A device that begins anew announces its columns again.
  if (line.kind == LineKind::words && !heading_.empty() && text == heading_text_) return;
  if (line.kind == LineKind::words && fields_ == 0) {
    if (!heading_.empty()) refuse(heading_text_, heading_line_, notices);
    heading_ = std::move(line.words);
    heading_text_ = text;
    heading_line_ = line_;
    return;
  }
  const std::size_t fields = line.numbers.size();
  const bool whole = line.kind == LineKind::numbers && fields <= widest &&
                     (fields_ == 0 || fields == fields_) && !(fields > 1 && std::isnan(line.numbers.front()));
  if (!whole) return refuse(text, line_, notices);
  if (fields_ == 0) {
    begin(fields);
    if (!heading_.empty() && !is_heading(heading_, fields)) refuse(heading_text_, heading_line_, notices);
    rows.width = timed_ ? fields - 1 : 1;
  }
  if (!timed_ && !(settings_.rate > 0)) {
    arrivals_.take(arrival);
    held_.push_back(line.numbers.front());
    return;
  }
  const std::span<const double> values(line.numbers.data() + (timed_ ? 1 : 0), fields - (timed_ ? 1 : 0));
  const Stamp stamp =
      timed_ ? clock_.of_device(in_seconds(line.numbers.front()), arrival) : clock_.of_count(arrival);
  if (stamp.notice) notices.push_back(*stamp.notice);
  rows.add(stamp.t, values);
}

}  // namespace cromer
