#include "cromer/base/grid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

constexpr double most_points = 9007199254740992.0;  // 2^53: beyond, points cannot be told apart

/// The text after the number that begins the piece.
std::string_view after_number(std::string_view piece) {
  const auto number = leading_number(piece);
  return number ? trimmed(piece.substr(number->length)) : std::string_view{};
}

Result<double> value_of(std::string_view piece, std::string_view unit_of_all, std::string_view si_unit) {
  const auto number = leading_number(piece);
  std::string whole(piece);
  if (number && number->length == piece.size() && !unit_of_all.empty()) whole.append(" ").append(unit_of_all);
  const auto quantity = parse_quantity(whole, si_unit);
  if (!quantity) return quantity.error();
  if (quantity->uncertainty != 0) return Error{"uncertainty_not_used", {{"text", piece}}};
  return quantity->value;
}

Error no_grid(std::string_view text, Notice what) {
  return Error{"no_grid", {{"text", text}, {"what", std::move(what)}}};
}

/// "0.5-2", "0.5..2": written as ranges are in prose.
bool is_range_in_prose(std::string_view text) {
  const std::string_view rest = after_number(text);
  for (const std::string_view to : {"..", "-", "–", "—"})
    if (rest.starts_with(to)) return leading_number(trimmed(rest.substr(to.size()))).has_value();
  return false;
}

Result<Grid> parse_list(std::string_view text, std::string_view si_unit) {
  if (is_range_in_prose(text)) return no_grid(text, Notice{"grid_without_points"});
  const auto pieces = split(text, ',');
  std::vector<double> values;
  for (const auto piece : pieces) {
    if (piece.empty()) return Error{"grid_value_empty", {{"text", text}}};
    const auto value = value_of(piece, after_number(pieces.back()), si_unit);
    if (!value) return value.error();
    values.push_back(*value);
  }
  return Grid(std::move(values));
}

Result<Grid> parse_range(std::string_view text, std::string_view si_unit) {
  const auto pieces = split(text, ':');
  const auto wrong = [&](Notice what) { return no_grid(text, std::move(what)); };
  if (pieces.size() != 3 && pieces.size() != 4)
    return wrong(Notice{"grid_of_pieces", {{"pieces", pieces.size()}}});
  const bool logarithmic = pieces.size() == 4;
  if (logarithmic && !pieces[3].starts_with("log"))
    return wrong(Notice{"grid_ends_with", {{"end", pieces[3]}}});

  const auto count = leading_number(pieces[2]);
  if (!count || count->value != std::floor(count->value) || !(count->value >= 0))
    return wrong(Notice{"grid_points_not_whole", {{"points", pieces[2]}}});
  if (count->value == 0) return wrong(Notice{"grid_of_no_points"});
  if (count->value > most_points) return wrong(Notice{"grid_points_not_told_apart"});
  const std::string_view unit =
      logarithmic ? trimmed(pieces[3].substr(3)) : trimmed(pieces[2].substr(count->length));
  if (logarithmic && count->length != pieces[2].size())
    return wrong(Notice{"grid_points_with_unit", {{"points", pieces[2]}}});

  const auto low = value_of(pieces[0], unit.empty() ? after_number(pieces[1]) : unit, si_unit);
  if (!low) return low.error();
  const auto high = value_of(pieces[1], unit, si_unit);
  if (!high) return high.error();
  if (count->value == 1 && *low != *high) return wrong(Notice{"grid_of_one_point"});
  if (logarithmic && !(*low > 0 && *high > 0)) return wrong(Notice{"grid_ends_not_positive"});
  return Grid(*low, *high, static_cast<std::uint64_t>(count->value), logarithmic);
}

}  // namespace

double Grid::operator[](std::uint64_t i) const {
  if (!list_.empty()) return list_[i];
  if (i == 0) return low_;
  if (i + 1 == size_) return high_;
  const double part = static_cast<double>(i) / static_cast<double>(size_ - 1);
  if (!logarithmic_) return low_ + part * (high_ - low_);
  const double from = std::log10(low_);
  return std::pow(10.0, from + part * (std::log10(high_) - from));
}

double Grid::lowest() const {
  return list_.empty() ? std::min(low_, high_) : *std::min_element(list_.begin(), list_.end());
}

double Grid::highest() const {
  return list_.empty() ? std::max(low_, high_) : *std::max_element(list_.begin(), list_.end());
}

Result<Grid> parse_grid(std::string_view text, std::string_view si_unit) {
  const std::string_view grid = trimmed(text);
  if (grid.empty()) return Error{"grid_empty"};
  return grid.find(':') == std::string_view::npos ? parse_list(grid, si_unit) : parse_range(grid, si_unit);
}

GridUnit unit_of_grid(std::string_view text, std::string_view si_unit) {
  const GridUnit si{std::string(si_unit), 1};
  const auto pieces = split(trimmed(text), text.find(':') == std::string_view::npos ? ',' : ':');
  const std::string_view last = pieces.back();
  std::string_view unit = last.starts_with("log") ? trimmed(last.substr(3)) : after_number(last);
  if (unit.empty() && pieces.size() > 2 && text.find(':') != std::string_view::npos)
    unit = after_number(pieces[1]);
  const auto expected = parse_unit(si_unit);
  if (unit.empty() || !expected) return si;
  const auto typed = parse_unit(unit, &expected->dimension);
  if (!typed || typed->dimension != expected->dimension || typed->offset != 0) return si;
  return {std::string(unit), typed->factor / expected->factor};
}

Result<void> fits_in_memory(double points, double bytes_per_point, double memory) {
  const double bytes = points * bytes_per_point;
  if (bytes <= (memory > 0 ? memory : 1e18)) return {};  // no vector can be longer
  if (memory > 0)
    return Error{"points_beyond_memory",
                 {{"points", points}, {"needed", bytes_in_words(bytes)}, {"memory", bytes_in_words(memory)}}};
  return Error{"points_too_many", {{"points", points}, {"needed", bytes_in_words(bytes)}}};
}

Result<std::vector<double>> values_of(const Grid& grid, double bytes_per_point, double memory) {
  if (auto good = fits_in_memory(static_cast<double>(grid.size()), bytes_per_point, memory); !good)
    return good.error();
  std::vector<double> values(grid.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = grid[i];
  return values;
}

}  // namespace cromer::core
