// The waveform of the viscous law and its derivatives, summed over a record in one pass.
//
//   y(t) = E + exp(-g s) (A cos(w s) + B sin(w s)),   s = t - t0
//
// with t0 the first sample's time and w the damped angular frequency.
//
// The five derivatives are combinations of 1, c, d, s c and s d, where c + i d = exp((-g + i w) s): their
// products over a stretch of equal steps follow from those over a table of one stretch, turned and shifted.
// Only the residuals meet every sample.
#pragma once

#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/least_squares/sampling.h"
#include "cromer/identify/record.h"

namespace cromer::core {

class DampedPhasor {
 public:
  /// Order of the parameters.
  enum Parameter { angular_frequency, decay_rate, equilibrium, cosine, sine, parameter_count };

  /// Keeps the spans: the record must outlive it. `record.t` has at least one sample.
  explicit DampedPhasor(const Record& record);

  /// Normal equations at w > 0 [rad/s, damped], g [1/s], E, A, B [unit of y]. Their entries are exact to
  /// about 1e-13 of their size.
  NormalEquations operator()(const Parameters& parameters) const;

  struct Linear {
    double equilibrium, cosine, sine;
    double sum_of_squares;  ///< what remains
  };

  /// The E, A and B that fit best at the given w and g. Accuracy suffices for start values only.
  Linear best_linear(double w, double g) const;

  /// data - model.
  void residuals(const Parameters& parameters, std::vector<double>& result) const;

  /// The model at the samples, without its equilibrium; the data are not looked at.
  std::vector<double> swing(const Parameters& parameters) const;

 private:
  Record record_;
  Sampling sampling_;
};

}  // namespace cromer::core
