#include "targets.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

#include "cromer/base/quantity.h"
#include "cromer/base/utf8.h"
#include "cromer/documents/words/words.h"
#include "cromer/live/line_reader.h"
#include "cromer/study/study_file.h"

namespace cromer::core::fuzz {
namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

struct Read {
  SampleRows rows;
  std::vector<Remark> notices;
  std::size_t garbage = 0;
};

Read read_in_pieces(std::string_view bytes, bool within_line, double rate, std::size_t piece) {
  Read read;
  LineReader reader({.rate = rate}, within_line);
  reader.connected(99.99);
  for (std::size_t at = 0; at < bytes.size(); at += piece)
    reader.take(bytes.substr(at, piece), 100, read.rows, read.notices);
  reader.end(100, read.rows, read.notices);
  read.garbage = reader.garbage();
  return read;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

int live_lines(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool within_line = (data[0] & 1u) != 0;
  const double rate = (data[0] & 2u) != 0 ? 100 : 0;
  const std::string_view bytes = text_of(data + 1, size - 1);
  const Read whole = read_in_pieces(bytes, within_line, rate, bytes.size() + 1),
             pieces = read_in_pieces(bytes, within_line, rate, 1 + data[0] / 4);
  require(whole.garbage == pieces.garbage && whole.notices.size() == pieces.notices.size());
  require(whole.rows.size() == pieces.rows.size() && whole.rows.values.size() == pieces.rows.values.size());
  require(whole.rows.values.size() == whole.rows.size() * whole.rows.width);
  for (std::size_t i = 0; i < whole.rows.size(); ++i) {
    require(std::isfinite(whole.rows.t[i]) && whole.rows.t[i] == pieces.rows.t[i]);
    require(i == 0 || whole.rows.t[i] > whole.rows.t[i - 1]);
  }
  for (std::size_t i = 0; i < whole.rows.values.size(); ++i)
    require(same(whole.rows.values[i], pieces.rows.values[i]) && !std::isinf(whole.rows.values[i]));
  for (const Remark& notice : whole.notices) require(is_utf8(in_words(notice.what)));
  return 0;
}

int quantity(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  for (const std::string_view unit : {"m", "s", "kg", "N/m", "rad/s", "1", "K", "Hz"}) {
    const auto read = parse_quantity(text, unit);
    if (!read) {
      require(!in_words(read.error()).empty());
      continue;
    }
    require(std::isfinite(read->value) && read->uncertainty >= 0 && std::isfinite(read->uncertainty));
    require(is_utf8(format_quantity(*read, unit)));
    const auto again = parse_quantity(shortest(read->value), unit);
    require(again && again->value == read->value);
  }
  (void)parse_unit(text);
  return 0;
}

int study(const std::uint8_t* data, std::size_t size) {
  const auto read = read_study(text_of(data, size), "fuzz.toml");
  require(read || !in_words(read.error()).empty());
  return 0;
}

}  // namespace cromer::core::fuzz
