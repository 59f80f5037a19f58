#include "cromer/live/line_reader.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

std::vector<std::string_view> split_at_blanks(std::string_view text) {
  std::vector<std::string_view> fields;
  while (!(text = trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    fields.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return fields;
}

/// The hard separator of a line, or a blank.
char separator_of(std::string_view text) {
  for (const char hard : {';', '\t', ','})
    if (text.find(hard) != std::string_view::npos) return hard;
  return ' ';
}

/// The number in a field; NaN if it is missing, nothing if the field is not wholly a number.
std::optional<double> number_of(std::string_view field, char decimal) {
  const std::string word = lower(field);
  if (word.empty() || word == "nan" || word == "null") return std::numeric_limits<double>::quiet_NaN();
  const auto number = leading_number(field, decimal);
  if (!number || number->length != field.size() || !std::isfinite(number->value)) return std::nullopt;
  return number->value;
}

bool is_text(std::string_view text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; });
}

bool is_word(std::string_view field) {
  return std::any_of(field.begin(), field.end(), [](char c) { return lower(c) >= 'a' && lower(c) <= 'z'; });
}

}  // namespace

DeviceLine read_line(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return {};
  if (text.front() == '#' || text.front() == '%') return {LineKind::comment};
  if (!is_text(text)) return {LineKind::garbage};
  const char separator = separator_of(text);
  const auto fields = separator == ' ' ? split_at_blanks(text) : split(text, separator);
  const char decimal =
      (separator == ';' || separator == '\t') && text.find('.') == std::string_view::npos ? ',' : '.';

  DeviceLine line{LineKind::numbers};
  std::size_t words = 0;
  for (const auto field : fields) {
    if (const auto number = number_of(field, decimal))
      line.numbers.push_back(*number);
    else
      words += is_word(field) && !is_digit(field.front());
    line.words.emplace_back(field);
  }
  if (line.numbers.size() == fields.size()) return {LineKind::numbers, std::move(line.numbers)};
  // Without hard separators a heading may hold blanks of its own.
  if (separator == ' ' && line.numbers.empty() && is_word(text) && !is_digit(text.front()))
    return {LineKind::words, {}, {std::string(text)}};
  if (words == fields.size()) return {LineKind::words, {}, std::move(line.words)};
  return {LineKind::garbage};
}

std::string shown(std::string_view text, std::size_t longest) {
  std::string out(text.substr(0, longest));
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > longest ? out + "..." : out;
}

namespace {

constexpr std::size_t longest_line = 1000;  // bytes
constexpr std::size_t widest = 32;          // numbers in a line

/// "Time (ms)" in seconds: 0.001; nothing if there is no unit of time in brackets.
std::optional<double> seconds_of(std::string_view heading) {
  const std::size_t open = heading.find_first_of("(["), close = heading.find_last_of(")]");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return std::nullopt;
  const auto unit = parse_unit(heading.substr(open + 1, close - open - 1));
  if (!unit || unit->dimension != Dimension{.second = 1}) return std::nullopt;
  return unit->factor;
}

/// A device's words are a heading if there is one for each number and they say more than "ready" does.
bool is_heading(const std::vector<std::string>& words, std::size_t fields) {
  if (words.size() != fields) return false;
  return fields > 1 || words.front().find_first_of("([") != std::string::npos;
}

/// How many digits the number at the beginning of a text has before its decimal mark; nothing if there is no
/// number.
std::optional<std::size_t> leading_digits(std::string_view text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  return count > 0 ? std::optional(count) : std::nullopt;
}

/// Whether a line of a time and values is whole, as the next one shows: a time that lost its first digits has
/// fewer of them, or has lost its decimal mark, or does not come before the next.
bool has_form_of(std::string_view text, std::string_view next) {
  const DeviceLine line = read_line(text), after = read_line(next);
  if (line.kind != LineKind::numbers || after.kind != LineKind::numbers) return false;
  if (line.numbers.size() != after.numbers.size() || line.numbers.size() < 2) return false;
  const double t = line.numbers.front(), later = after.numbers.front();
  const auto digits = leading_digits(trimmed(text)), digits_after = leading_digits(trimmed(next));
  if (!digits || !digits_after || !(t < later)) return false;
  const auto has_mark = [](std::string_view line_text, std::size_t place) {
    return place < line_text.size() && line_text[place] == '.';
  };
  if (has_mark(trimmed(text), *digits) != has_mark(trimmed(next), *digits_after)) return false;
  // From 9.99 to 10.00 the time gains a digit in a small step; from 9.99, the rest of 19.99, to 20.00 the
  // step is large.
  return digits == digits_after || (*digits_after == *digits + 1 && later - t < 0.1 * later);
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

void LineReader::connected(double at) {
  connected_ = at;
  at_beginning_ = true;
  surely_whole_ = !may_begin_within_line_;
}

void LineReader::take(std::string_view bytes, double arrival, SampleRows& rows,
                      std::vector<Remark>& notices) {
  constexpr double silence = 0.03;  // [s] more than the bytes of a line wait for each other, on USB too
  if (at_beginning_ && !lost_ && partial_.empty() && arrival - connected_ > silence) surely_whole_ = true;
  while (!bytes.empty()) {
    const std::size_t end = bytes.find_first_of("\n\r");
    const std::string_view piece = bytes.substr(0, end);
    bytes.remove_prefix(std::min(bytes.size(), end == std::string_view::npos ? end : end + 1));
    if (!too_long_) partial_ += piece;
    if (partial_.size() > longest_line) {
      ++line_;
      refuse(partial_, line_, notices);
      partial_.clear();
      too_long_ = true;
    }
    if (end == std::string_view::npos) return;
    if (!partial_.empty()) take_any_line(std::exchange(partial_, ""), arrival, rows, notices);
    at_beginning_ = too_long_ = false;
    surely_whole_ = true;
  }
}

void LineReader::take_any_line(std::string_view text, double arrival, SampleRows& rows,
                               std::vector<Remark>& notices) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  ++line_;
  if (at_beginning_ && text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (first_) judge_first(text, rows, notices);
  if (surely_whole_)
    take_line(text, arrival, rows, notices);
  else
    first_ = FirstLine{std::string(text), arrival};
}

void LineReader::judge_first(std::string_view next, SampleRows& rows, std::vector<Remark>& notices) {
  const FirstLine first = *std::exchange(first_, std::nullopt);
  if (has_form_of(first.text, next)) {
    take_line(first.text, first.arrival, rows, notices);
  } else {
    notices.push_back({RemarkKind::connection, Notice{"first_line_left_out", {{"text", shown(first.text)}}}});
  }
}

void LineReader::end(double arrival, SampleRows& rows, std::vector<Remark>& notices) {
  if (!partial_.empty()) take_any_line(std::exchange(partial_, ""), arrival, rows, notices);
  release_all(rows, notices);
}

void LineReader::let_go(const std::vector<double>& times, SampleRows& rows) {
  if (!times.empty()) rows.width = 1;
  for (std::size_t i = 0; i < times.size(); ++i) rows.add(times[i], {&held_[i], 1});
  held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(times.size()));
}

void LineReader::release(double now, SampleRows& rows, std::vector<Remark>& notices) {
  std::vector<double> times;
  arrivals_.release(now, times, notices);
  let_go(times, rows);
}

void LineReader::release_all(SampleRows& rows, std::vector<Remark>& notices) {
  if (first_) judge_first("", rows, notices);
  std::vector<double> times;
  arrivals_.release_all(times, notices);
  let_go(times, rows);
}

SampleTimes LineReader::times() const {
  if (fields_ == 0) return {};
  if (timed_) return {TimesBy::device};
  return settings_.rate > 0 ? SampleTimes{TimesBy::count} : arrivals_.sample_times();
}

void LineReader::connection_lost(SampleRows& rows, std::vector<Remark>& notices) {
  if (first_) judge_first("", rows, notices);
  partial_.clear();
  too_long_ = false;
  lost_ = true;
}

void LineReader::refuse(std::string_view text, long line, std::vector<Remark>& notices) {
  ++garbage_;
  notices.push_back(
      {RemarkKind::garbage, Notice{"line_is_no_sample", {{"line", line}, {"text", shown(text)}}}});
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

void LineReader::take_line(std::string_view text, double arrival, SampleRows& rows,
                           std::vector<Remark>& notices) {
  DeviceLine line = read_line(text);
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

}  // namespace cromer::core
