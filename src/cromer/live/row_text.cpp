#include "cromer/live/row_text.h"

#include <cmath>

#include "cromer/base/number.h"

namespace cromer::core {
namespace {

void append_number(std::string& text, double value) {
  char digits[32];
  if (std::isfinite(value))
    text.append(digits, static_cast<std::size_t>(write_shortest(digits, value) - digits));
}

}  // namespace

void append_row(std::string& text, double t, std::span<const double> values) {
  append_number(text, t);
  for (const double value : values) {
    text += ',';
    append_number(text, value);
  }
  text += '\n';
}

}  // namespace cromer::core
