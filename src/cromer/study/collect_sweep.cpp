#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/documents/words/words.h"
#include "cromer/study/collect.h"

namespace cromer::core {
namespace {

constexpr std::uint64_t most_named_points = 1000;

/// "drive_frequency (rad/s)" as name and unit.
struct ColumnHeading {
  std::string name, unit;
};

ColumnHeading heading_of(const std::string& column) {
  const std::size_t bracket = column.find(" (");
  if (bracket == std::string::npos) return {column, ""};
  return {column.substr(0, bracket), column.substr(bracket + 2, column.size() - bracket - 3)};
}

std::string axis_name(std::string name) {
  if (name == "x" || name == "v") return "*" + name + "*";
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

class Collector {
 public:
  Collector(const SweepResult& result, Results& results)
      : all_(result), results_(results), width_(result.plan.rows.columns.size() - 1) {
    for (std::size_t i = 0; i < width_; ++i) headings_.push_back(heading_of(result.plan.rows.columns[i]));
  }

  /// One curve over the innermost option: `points` rows from `first` on.
  void curve(const std::string& name, std::uint64_t first, std::uint64_t points) const {
    const std::size_t inner = all_.plan.swept.size() - 1;
    results_.set(name + ".label", label(first, inner));
    for (std::size_t i = 0; i < inner; ++i) set(name, first, i);
    for (std::size_t i = inner; i < width_; ++i) {
      std::vector<double> values;
      for (std::uint64_t k = 0; k < points; ++k) values.push_back(at(first + k, i));
      if (i > inner) extremes(name, values, first, i);
      results_.set_column(name + "." + headings_[i].name, std::move(values), headings_[i].unit,
                          axis_name(headings_[i].name));
    }
  }

  void point(const std::string& name, std::uint64_t row) const {
    results_.set(name + ".label", label(row, all_.plan.swept.size()));
    for (std::size_t i = 0; i < width_; ++i) set(name, row, i);
  }

 private:
  double at(std::uint64_t row, std::size_t column) const { return all_.rows[row * width_ + column]; }

  void set(const std::string& name, std::uint64_t row, std::size_t column) const {
    results_.set(name + "." + headings_[column].name, at(row, column), headings_[column].unit);
  }

  /// The first `options` values of a row in words, in the units of their grids; the method if there are none.
  std::string label(std::uint64_t row, std::size_t options) const {
    std::string text;
    for (std::size_t i = 0; i < options; ++i) {
      const SweptOption& option = all_.plan.swept[i];
      const std::string unit = heading_of(option.shown).unit;
      text += fmt::format("{}{} {:.6g}{}{}", i ? ", " : "", axis_name(headings_[i].name),
                          at(row, i) / option.shown_unit, unit.empty() ? "" : " ", unit);
    }
    return text.empty() ? all_.plan.method : text;
  }

  void extremes(const std::string& name, const std::vector<double>& values, std::uint64_t first,
                std::size_t column) const {
    const std::size_t inner = all_.plan.swept.size() - 1;
    const auto say = [&](const char* which, auto better) {
      std::size_t best = values.size();
      for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isnan(values[k]) && (best == values.size() || better(values[k], values[best]))) best = k;
      const bool any = best < values.size();
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      const std::string fact = name + "." + headings_[column].name + "." + which;
      results_.set(fact, any ? values[best] : none, headings_[column].unit);
      results_.set(fact + "_at", any ? at(first + best, inner) : none, headings_[inner].unit);
    };
    say("smallest", [](double a, double b) { return a < b; });
    say("largest", [](double a, double b) { return a > b; });
  }

  const SweepResult& all_;
  Results& results_;
  std::size_t width_;
  std::vector<ColumnHeading> headings_;
};

}  // namespace

void collect(const std::string& id, const SweepResult& all, Results& results) {
  results.set(id + ".points", static_cast<double>(all.plan.rows.rows));
  results.set(id + ".not_settled", static_cast<double>(all.counts.not_settled));
  results.set(id + ".not_finite", static_cast<double>(all.counts.not_finite));
  results.set(id + ".method", all.plan.method);
  results.set(id + ".way", in_words(all.plan.way));
  results.set(id + ".steps", in_words(all.plan.steps));
  const Collector collector(all, results);
  const std::uint64_t points = all.plan.swept.back().points, curves = all.plan.rows.rows / points;
  for (std::uint64_t n = 0; n < curves; ++n)
    collector.curve(fmt::format("{}.{}", id, n + 1), n * points, points);
  if (all.plan.rows.rows > most_named_points) return;
  for (std::uint64_t row = 0; row < all.plan.rows.rows; ++row)
    collector.point(fmt::format("{}.point.{}", id, row + 1), row);
}

}  // namespace cromer::core
