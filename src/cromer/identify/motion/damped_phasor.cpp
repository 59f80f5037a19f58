#include "cromer/identify/motion/damped_phasor.h"

#include <cmath>
#include <complex>

namespace cromer::core {
namespace {

using Phasor = std::complex<double>;

// Plain products: std::complex's operator* checks for infinities.
Phasor times(Phasor a, Phasor b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// Sums of s^k f over some samples for k = 0, 1, 2, with s the time from the origin.
template <class T>
struct Moments {
  T zero{}, one{}, two{};

  void add(double s, T f) {
    zero += f;
    one += s * f;
    two += s * s * f;
  }
};

// The phasor at the samples of one stretch, relative to its first sample, and the sums of its products.
struct Table {
  std::size_t count = 0;
  alignas(64) double s[longest_stretch];
  alignas(64) double c[longest_stretch];
  alignas(64) double d[longest_stretch];  // the sine
  Moments<Phasor> phasor;                 // of p
  Moments<double> norm;                   // of |p|^2
  Moments<Phasor> square;                 // of p^2

  void sum() {
    phasor = {};
    norm = {};
    square = {};
    for (std::size_t n = 0; n < count; ++n) {
      phasor.add(s[n], {c[n], d[n]});
      norm.add(s[n], c[n] * c[n] + d[n] * d[n]);
      square.add(s[n], {c[n] * c[n] - d[n] * d[n], 2 * c[n] * d[n]});
    }
  }

  void fill(double h, std::size_t samples, Phasor exponent) {
    count = samples;
    const Phasor factor = std::exp(exponent * h);
    Phasor p = 1;
    for (std::size_t n = 0; n < count; ++n) {
      if (n % 64 == 0) p = std::exp(exponent * (static_cast<double>(n) * h));
      s[n] = static_cast<double>(n) * h;
      c[n] = p.real();
      d[n] = p.imag();
      p = times(p, factor);
    }
    sum();
  }

  void fill(std::span<const double> t, Phasor exponent) {
    count = t.size();
    for (std::size_t n = 0; n < count; ++n) {
      s[n] = t[n] - t[0];
      const Phasor p = std::exp(exponent * s[n]);
      c[n] = p.real();
      d[n] = p.imag();
    }
    sum();
  }
};

// Sums over residuals r of one stretch.
struct ResidualSums {
  double r = 0, rr = 0, rc = 0, rd = 0, src = 0, srd = 0;
};

ResidualSums residual_sums(const double* y, const Table& table, double E, double alpha, double beta) {
  constexpr std::size_t lanes = 4;
  double r[lanes]{}, rr[lanes]{}, rc[lanes]{}, rd[lanes]{}, src[lanes]{}, srd[lanes]{};
  std::size_t n = 0;
  for (; n + lanes <= table.count; n += lanes)
    for (std::size_t l = 0; l < lanes; ++l) {
      const double e = y[n + l] - E - alpha * table.c[n + l] - beta * table.d[n + l];
      const double ec = e * table.c[n + l], ed = e * table.d[n + l];
      r[l] += e;
      rr[l] += e * e;
      rc[l] += ec;
      rd[l] += ed;
      src[l] += table.s[n + l] * ec;
      srd[l] += table.s[n + l] * ed;
    }
  ResidualSums sums;
  for (; n < table.count; ++n) {
    const double e = y[n] - E - alpha * table.c[n] - beta * table.d[n];
    sums.r += e;
    sums.rr += e * e;
    sums.rc += e * table.c[n];
    sums.rd += e * table.d[n];
    sums.src += table.s[n] * e * table.c[n];
    sums.srd += table.s[n] * e * table.d[n];
  }
  for (std::size_t l = 0; l < lanes; ++l) {
    sums.r += r[l];
    sums.rr += rr[l];
    sums.rc += rc[l];
    sums.rd += rd[l];
    sums.src += src[l];
    sums.srd += srd[l];
  }
  return sums;
}

// Visits the stretches with the table that serves each and the phasor at its first sample.
template <class Visit>
void for_each_stretch(const Record& record, const Sampling& sampling, Phasor exponent, Visit visit) {
  Table shared, own;
  for (const Stretch& stretch : sampling.stretches) {
    const double s0 = record.t[stretch.first] - record.t[0];
    const Phasor p0 = std::exp(exponent * s0);
    const Table* table = &own;
    if (!stretch.uniform) {
      own.fill(record.t.subspan(stretch.first, stretch.count), exponent);
    } else if (stretch.count == longest_stretch) {
      if (shared.count == 0) shared.fill(sampling.step, longest_stretch, exponent);
      table = &shared;
    } else {
      own.fill(sampling.step, stretch.count, exponent);
    }
    visit(stretch, *table, s0, p0);
  }
}

// Products of the basis {1, c, d, s c, s d} with itself and with the residuals.
struct BasisSums {
  double gram[5][5]{};
  double right[5]{};
  double sum_of_squares = 0;

  void add(const Table& table, double s0, Phasor p0, const ResidualSums& sums) {
    // Moments about the record's origin: s = s0 + local s, p = p0 * local p.
    const Phasor p02 = times(p0, p0);
    const double n02 = std::norm(p0);
    const Phasor P0 = times(p0, table.phasor.zero);
    const Phasor P1 = times(p0, s0 * table.phasor.zero + table.phasor.one);
    const double N0 = n02 * table.norm.zero;
    const double N1 = n02 * (s0 * table.norm.zero + table.norm.one);
    const double N2 = n02 * (s0 * s0 * table.norm.zero + 2 * s0 * table.norm.one + table.norm.two);
    const Phasor Q0 = times(p02, table.square.zero);
    const Phasor Q1 = times(p02, s0 * table.square.zero + table.square.one);
    const Phasor Q2 = times(p02, s0 * s0 * table.square.zero + 2 * s0 * table.square.one + table.square.two);

    // c² = (|p|² + Re p²)/2, d² = (|p|² - Re p²)/2, c d = Im p²/2.
    gram[0][0] += static_cast<double>(table.count);
    gram[0][1] += P0.real();
    gram[0][2] += P0.imag();
    gram[0][3] += P1.real();
    gram[0][4] += P1.imag();
    gram[1][1] += (N0 + Q0.real()) / 2;
    gram[1][2] += Q0.imag() / 2;
    gram[2][2] += (N0 - Q0.real()) / 2;
    gram[1][3] += (N1 + Q1.real()) / 2;
    gram[1][4] += Q1.imag() / 2;
    gram[2][3] += Q1.imag() / 2;
    gram[2][4] += (N1 - Q1.real()) / 2;
    gram[3][3] += (N2 + Q2.real()) / 2;
    gram[3][4] += Q2.imag() / 2;
    gram[4][4] += (N2 - Q2.real()) / 2;

    const Phasor R0 = times(p0, {sums.rc, sums.rd});
    const Phasor R1 = s0 * R0 + times(p0, {sums.src, sums.srd});
    right[0] += sums.r;
    right[1] += R0.real();
    right[2] += R0.imag();
    right[3] += R1.real();
    right[4] += R1.imag();
    sum_of_squares += sums.rr;
  }

  void mirror() {
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < i; ++j) gram[i][j] = gram[j][i];
  }
};

// The model's amplitudes turned to a stretch's own phasor: A c + B d = Re[(A - iB) p0 p].
void turn(double A, double B, Phasor p0, double& alpha, double& beta) {
  alpha = A * p0.real() + B * p0.imag();
  beta = B * p0.real() - A * p0.imag();
}

}  // namespace

DampedPhasor::DampedPhasor(const Record& record) : record_(record), sampling_(find_sampling(record.t)) {}

NormalEquations DampedPhasor::operator()(const Parameters& parameters) const {
  const double w = parameters[angular_frequency], g = parameters[decay_rate], E = parameters[equilibrium];
  const double A = parameters[cosine], B = parameters[sine];
  BasisSums basis;
  for_each_stretch(
      record_, sampling_, {-g, w}, [&](const Stretch& stretch, const Table& table, double s0, Phasor p0) {
        double alpha, beta;
        turn(A, B, p0, alpha, beta);
        basis.add(table, s0, p0, residual_sums(record_.y.data() + stretch.first, table, E, alpha, beta));
      });
  basis.mirror();

  // Derivatives in the basis {1, c, d, s c, s d}.
  const double derivative[parameter_count][5] = {
      {0, 0, 0, B, -A}, {0, 0, 0, -A, -B}, {1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}};
  NormalEquations equations;
  equations.size = parameter_count;
  equations.sum_of_squares = basis.sum_of_squares;
  for (int i = 0; i < parameter_count; ++i) {
    double row[5]{};
    for (int k = 0; k < 5; ++k) {
      equations.right[i] += derivative[i][k] * basis.right[k];
      for (int l = 0; l < 5; ++l) row[l] += derivative[i][k] * basis.gram[k][l];
    }
    for (int j = 0; j < parameter_count; ++j)
      for (int l = 0; l < 5; ++l) equations.matrix[i][j] += row[l] * derivative[j][l];
  }
  return equations;
}

DampedPhasor::Linear DampedPhasor::best_linear(double w, double g) const {
  BasisSums basis;
  for_each_stretch(
      record_, sampling_, {-g, w}, [&](const Stretch& stretch, const Table& table, double s0, Phasor p0) {
        basis.add(table, s0, p0, residual_sums(record_.y.data() + stretch.first, table, 0, 0, 0));
      });
  basis.mirror();
  SquareMatrix matrix{};
  Parameters right{};
  for (int i = 0; i < 3; ++i) {
    right[i] = basis.right[i];
    for (int j = 0; j < 3; ++j) matrix[i][j] = basis.gram[i][j];
  }
  const ScaledCholesky factor(matrix, 3, 0, all_free);
  if (!factor.ok()) return {0, 0, 0, basis.sum_of_squares};
  const Parameters x = factor.solve(right);
  double explained = 0;
  for (int i = 0; i < 3; ++i) explained += x[i] * right[i];
  return {x[0], x[1], x[2], basis.sum_of_squares - explained};
}

std::vector<double> DampedPhasor::swing(const Parameters& parameters) const {
  std::vector<double> result(record_.t.size());
  for_each_stretch(record_, sampling_, {-parameters[decay_rate], parameters[angular_frequency]},
                   [&](const Stretch& stretch, const Table& table, double, Phasor p0) {
                     double alpha, beta;
                     turn(parameters[cosine], parameters[sine], p0, alpha, beta);
                     double* at = result.data() + stretch.first;
                     for (std::size_t n = 0; n < table.count; ++n)
                       at[n] = alpha * table.c[n] + beta * table.d[n];
                   });
  return result;
}

void DampedPhasor::residuals(const Parameters& parameters, std::vector<double>& result) const {
  const double w = parameters[angular_frequency], g = parameters[decay_rate], E = parameters[equilibrium];
  result.resize(record_.y.size());
  for_each_stretch(record_, sampling_, {-g, w},
                   [&](const Stretch& stretch, const Table& table, double, Phasor p0) {
                     double alpha, beta;
                     turn(parameters[cosine], parameters[sine], p0, alpha, beta);
                     const double* y = record_.y.data() + stretch.first;
                     double* r = result.data() + stretch.first;
                     for (std::size_t n = 0; n < table.count; ++n)
                       r[n] = y[n] - E - alpha * table.c[n] - beta * table.d[n];
                   });
}

}  // namespace cromer::core
