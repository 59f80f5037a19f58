#include "any_method.h"

#include "cromer/methods/all.h"

namespace cromer::core::page {
namespace {

/// Owns its method, because those of the registry are temporary.
template <class M>
class Owning final : public Stepper {
 public:
  Owning(const AnyTerms& system, const M& method, double t, const State<double>& y)
      : method_(method), stepper_(system, method_, t, y) {}

  Trial<double> step(double t, double h, const State<double>& y) override { return stepper_.step(t, h, y); }
  Trial<double> part(double t, double h, const State<double>& y) const override {
    return stepper_.part(t, h, y);
  }
  double* carried() override { return stepper_.carried(); }
  double acceleration(double t, const State<double>& y) const override { return stepper_.acceleration(t, y); }
  const MethodInfo& info() const override { return M::info; }
  double zero_spacing() const override { return stepper_.zero_spacing(); }

 private:
  M method_;
  StepperOf<AnyTerms, M, double> stepper_;
};

}  // namespace

std::unique_ptr<Stepper> stepper_of(std::string_view method, const MethodSettings& settings,
                                    const AnyTerms& system, double t, const State<double>& y) {
  return visit_method(method, settings, [&]<class M>(const M& named) -> std::unique_ptr<Stepper> {
    return std::make_unique<Owning<M>>(system, named, t, y);
  });
}

}  // namespace cromer::core::page
