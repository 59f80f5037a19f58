#include "cromer/study/lab_page.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "cromer/documents/text/words.h"

namespace cromer::core {
namespace {

constexpr std::string_view mark_of_file = "# cromer report ";

/// A sum that changes with the text (Fowler, Noll and Vo's FNV-1a, 64 bits).
std::string sum_of(std::string_view text) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return fmt::format("{:016x}", sum);
}

}  // namespace

void LabPage::begin(const std::string& title, const std::string& summary) {
  head_.text("title", front_.title.empty() ? title : verbatim(front_.title));
  std::string byline = verbatim(front_.author);
  if (!front_.course.empty()) byline += (byline.empty() ? "" : " · ") + verbatim(front_.course);
  head_.text("byline", byline);
  head_.text("summary", summary);
  if (front_.language == Language::german) head_.text("language", "de");
}

void LabPage::own_parts() {
  own(front_.text, "");
  own(front_.aim, "report_aim");
  own(front_.apparatus, "report_apparatus");
}

std::string LabPage::end() {
  own(front_.conclusion, "report_conclusion");
  const std::string body =
      in_words(Notice{"report_file_head"}, {front_.language}) + "\n" + head_.written() + page_.written();
  return std::string(mark_of_file) + sum_of(body) + "\n" + body;
}

void LabPage::own(const std::string& text, std::string_view heading) {
  if (text.empty()) return;
  if (!heading.empty()) page_.heading(in_words(Notice{std::string(heading)}, {front_.language}));
  page_.paragraph(verbatim(text));
}

std::string interval_of(const std::string& name, const Estimate& e, Language language) {
  // Without an upper end the interval is as wide as the lower one tells.
  const bool open = std::isinf(e.high);
  const double low = e.low, high = open ? 2 * e.value - low : e.high;
  const auto written = [&](std::string_view end, double value) {
    return fmt::format("{{{}.{}, {}, bare}}", name, end, digits_of_end(value, low, high));
  };
  Notice interval{open ? "report_at_least" : "report_interval", {{"low", written("low", low)}}};
  if (!open) interval.values.push_back({"high", written("high", high)});
  return in_words(interval, {language});
}

bool is_as_made(std::string_view study) {
  const std::size_t line = study.find('\n');
  return study.starts_with(mark_of_file) && line != study.npos &&
         study.substr(mark_of_file.size(), line - mark_of_file.size()) == sum_of(study.substr(line + 1));
}

}  // namespace cromer::core
