// dormand-prince beside odeint's dopri5 (dense output) and SUNDIALS (where installed) at equal error: every
// solver runs at many tolerances; the time for an error is read off between them. All give the states at 801
// rows. Prints lines of tab-separated "row, who, seconds"; bench/run makes the table.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "bench/cases.h"
#include "bench/stopwatch.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"
#ifdef CROMER_SUNDIALS
#include "bench/sundials.h"
#endif

namespace {

namespace odeint = boost::numeric::odeint;
using namespace cromer::core;
using bench::ForcedRun;
using cromer::State;

constexpr double row_spacing = 0.1;  // [s]
constexpr double tolerances[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13};

/// One solver on one law: fills the positions at the rows, says how many evaluations it took.
struct Solver {
  std::string who;
  std::function<long long(double tolerance, std::vector<double>& x)> run;
};

template <Terms terms>
long long ours(const ForcedRun& run, double tolerance, std::vector<double>& x) {
  const DrivenOscillator<double, terms> system(run.oscillator,
                                               {run.drive.amplitude, run.drive.frequency, run.drive.phase});
  const auto outcome =
      solve(system, DormandPrince{}, run.interval, run.start, StepControl(row_spacing, tolerance),
            [&](double, const State<double>& y) { x.push_back(y.x); });
  return outcome.counts.evaluations;
}

template <Terms terms>
long long odeints(const ForcedRun& run, double tolerance, std::vector<double>& x) {
  using Vector = std::array<double, 2>;
  long long evaluations = 0;
  const auto law = [&](const Vector& y, Vector& slope, double t) {
    ++evaluations;
    slope = {y[1], bench::acceleration<terms>(run, t, y[0], y[1])};
  };
  Vector y{run.start.x, run.start.v};
  auto stepper = odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<Vector>());
  odeint::integrate_const(stepper, law, y, run.interval.from, run.interval.until + row_spacing / 2,
                          row_spacing, [&](const Vector& u, double) { x.push_back(u[0]); });
  return evaluations;
}

template <Terms terms>
std::vector<Solver> solvers(const ForcedRun& run) {
  std::vector<Solver> all{
      {"cromer", [&run](double tolerance, auto& x) { return ours<terms>(run, tolerance, x); }},
      {"odeint dopri5", [&run](double tolerance, auto& x) { return odeints<terms>(run, tolerance, x); }}};
#ifdef CROMER_SUNDIALS
  all.push_back({"CVODE Adams", [&run](double tolerance, auto& x) {
                   return bench::cvode<terms>(run, row_spacing, tolerance, x);
                 }});
  all.push_back({"ARKODE dopri5", [&run](double tolerance, auto& x) {
                   return bench::arkode<terms>(run, row_spacing, tolerance, x);
                 }});
#endif
  return all;
}

double largest_error(const std::vector<double>& x, const std::vector<double>& truth) {
  if (x.size() < truth.size()) return 1e300;
  double error = 0, size = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    error = std::max(error, std::abs(x[i] - truth[i]));
    size = std::max(size, std::abs(truth[i]));
  }
  return error / size;
}

/// y at this error, on the lines through log y against log error; 0 outside.
double at(double error, const std::vector<double>& errors, const std::vector<double>& y) {
  for (std::size_t i = 1; i < errors.size(); ++i)
    if (errors[i - 1] > error && errors[i] <= error)
      return y[i - 1] *
             std::pow(y[i] / y[i - 1], std::log(error / errors[i - 1]) / std::log(errors[i] / errors[i - 1]));
  return 0;
}

template <Terms terms>
void compare(const ForcedRun& run, int rounds) {
  std::vector<double> truth;
  ours<terms>(run, 1e-15, truth);
  for (const Solver& solver : solvers<terms>(run)) {
    std::vector<double> errors, seconds, per_evaluation;
    for (const double tolerance : tolerances) {
      std::vector<double> x;
      x.reserve(truth.size() + 1);
      const auto evaluations = static_cast<double>(solver.run(tolerance, x));
      errors.push_back(largest_error(x, truth));
      seconds.push_back(bench::medians<std::function<void()>>({[&] {
                                                                x.clear();
                                                                solver.run(tolerance, x);
                                                              }},
                                                              rounds)
                            .front());
      per_evaluation.push_back(seconds.back() / evaluations);
    }
    for (const double error : {1e-4, 1e-6, 1e-8, 1e-10})
      if (const double s = at(error, errors, seconds); s > 0)
        std::printf("%s, error %.0e\t%s\t%.9g\n", run.name, error, solver.who.c_str(), s);
    if (const double s = at(1e-8, errors, per_evaluation); s > 0)
      std::printf("%s, an evaluation\t%s\t%.9g\n", run.name, solver.who.c_str(), s);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 31;
  compare<bench::linear_terms>(bench::forced_runs[0], rounds);
  compare<bench::all_smooth_terms>(bench::forced_runs[1], rounds);
  compare<bench::duffing_terms>(bench::forced_runs[2], rounds);
#ifndef CROMER_SUNDIALS
  std::fprintf(stderr, "SUNDIALS was not found when this was built: skipped\n");
#endif
}
