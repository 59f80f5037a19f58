#include "cromer/identify/start/two_lines.h"

#include <array>
#include <cmath>

namespace cromer::core::two_lines {
namespace {

// The model and, in `row`, its derivatives.
template <int size>
double value_at(const Parameters& p, double s, std::array<double, size>& row) {
  double value = p[0];
  row[0] = 1;
  for (const int at : first_of) {
    const bool decays = at + decay < size;
    const double fall = decays ? std::exp(-p[at + decay] * s) : 1, phase = p[at + frequency] * s;
    const double c = fall * std::cos(phase), d = fall * std::sin(phase);
    const double y = p[at + cosine] * c + p[at + sine] * d;
    value += y;
    row[at + frequency] = s * (p[at + sine] * c - p[at + cosine] * d);
    row[at + cosine] = c;
    row[at + sine] = d;
    if (decays) row[at + decay] = -s * y;
  }
  return value;
}

template <int size>
NormalEquations equations_at(const Record& record, const Parameters& p) {
  NormalEquations equations{.size = size};
  std::array<double, size> row{};
  for (std::size_t i = 0; i < record.t.size(); ++i) {
    const double r = record.y[i] - value_at<size>(p, record.t[i] - record.t.front(), row);
    equations.add_row(row, r);
  }
  return equations;
}

NormalEquations equations_of(const Record& record, const Parameters& p, int size) {
  return size == steady ? equations_at<steady>(record, p) : equations_at<decaying>(record, p);
}

}  // namespace

std::vector<double> residuals(const Record& record, const Parameters& p) {
  std::vector<double> left;
  std::array<double, decaying> row{};
  for (std::size_t i = 0; i < record.t.size(); ++i)
    left.push_back(record.y[i] - value_at<decaying>(p, record.t[i] - record.t.front(), row));
  return left;
}

std::optional<Parameters> with_amplitudes(const Record& record, Parameters p) {
  std::array<bool, max_parameters> linear{};
  linear[0] = true;
  p[0] = 0;
  for (const int at : first_of)
    for (const int i : {at + cosine, at + sine}) linear[i] = true, p[i] = 0;
  const NormalEquations equations = equations_at<decaying>(record, p);
  const ScaledCholesky factor(equations.matrix, equations.size, 1e-12, linear);
  if (!factor.ok()) return std::nullopt;
  const Parameters step = factor.solve(equations.right);
  for (int j = 0; j < equations.size; ++j) p[j] += step[j];
  return p;
}

LeastSquaresSummary fit(const Record& record, const Parameters& start, int size, double scale) {
  const auto model = [&](const Parameters& p) {
    if (p[first_of[0] + frequency] > 0 && p[first_of[1] + frequency] > 0)
      return equations_of(record, p, size);
    NormalEquations nowhere;
    nowhere.sum_of_squares = HUGE_VAL;
    return nowhere;
  };
  LeastSquaresOptions options;
  options.iteration_limit = 40;
  options.error_tolerance = 1e-3;
  options.scale = scale;
  options.residuals = static_cast<int>(record.t.size());
  return minimise(model, start, options);
}

}  // namespace cromer::core::two_lines
