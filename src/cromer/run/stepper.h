// A method at work on a system, with its types forgotten: what the loops that look into every step see.
#pragma once

#include <limits>

#include "cromer/base/state.h"
#include "cromer/methods/method.h"

namespace cromer::core {

/// One step out of line, for where a call does not count: compiled once for each system and method.
template <class S, class M, class Real, class Memory>
[[gnu::noinline]] Trial<Real> one_step(const S& system, const M& method, double t, double h,
                                       const State<Real>& y, Memory& memory) {
  return method.step(system, t, h, y, memory);
}

class Stepper {
 public:
  virtual ~Stepper() = default;

  /// From y at t to t + h; the next step goes on from there.
  virtual Trial<double> step(double t, double h, const State<double>& y) = 0;

  /// A step from where the last one began, which leaves no trace: what part of it gives.
  virtual Trial<double> part(double t, double h, const State<double>& y) const = 0;

  /// The acceleration of its own that the method keeps from step to step; nullptr where it keeps none.
  virtual double* carried() = 0;

  virtual const MethodInfo& info() const = 0;

  /// No two zeros of the velocity lie closer [s]; infinite where the system does not say (then the step is
  /// the caller's choice).
  virtual double zero_spacing() const = 0;
};

/// system and method outlive it.
template <class S, class M>
requires Method<M, S, double>
class StepperOf final : public Stepper {
 public:
  /// For a run from y at t.
  StepperOf(const S& system, const M& method, double t, const State<double>& y)
      : system_(system), method_(method), memory_(method.start(system, t, y)), before_(memory_) {}

  Trial<double> step(double t, double h, const State<double>& y) override {
    before_ = memory_;
    return one_step(system_, method_, t, h, y, memory_);
  }

  Trial<double> part(double t, double h, const State<double>& y) const override {
    auto copy = before_;
    return one_step(system_, method_, t, h, y, copy);
  }

  double* carried() override {
    if constexpr (CarriesAcceleration<M, typename M::template Memory<double>>)
      return &method_.carried(memory_);
    else
      return nullptr;
  }

  const MethodInfo& info() const override { return M::info; }

  double zero_spacing() const override {
    if constexpr (requires { system_.zero_spacing(); }) return system_.zero_spacing();
    return std::numeric_limits<double>::infinity();
  }

 private:
  const S& system_;
  const M& method_;
  typename M::template Memory<double> memory_, before_;
};

}  // namespace cromer::core
