// W1: one forced run, all states kept; ours beside Boost odeint with the cosine in every evaluation. Then the
// writing of its rows. Prints lines of tab-separated "row, who, seconds"; bench/run adds the peers and makes
// the table.
#include <array>
#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/explicit_generic_rk.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "bench/cases.h"
#include "bench/stopwatch.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/report/csv.h"
#include "cromer/tasks/simulate/run_law.h"

namespace {

namespace odeint = boost::numeric::odeint;
using namespace cromer::core;
using bench::ForcedRun;

struct Timed {
  std::string row, who;
  std::function<void()> work;
};

/// What a run leaves behind, so that rows can be compared and no work is optimised away.
struct Kept {
  std::vector<double> t, x, v;
};

void ours(const ForcedRun& run, std::string_view method, KeepEvery& keep) {
  keep.clear();
  run_law({.oscillator = run.oscillator,
           .drive = run.drive,
           .method = method,
           .interval = run.interval,
           .start = run.start,
           .control = run.step},
          keep);
}

using OdeintState = std::array<double, 2>;

/// The law as odeint wants it, with the terms the run has.
template <Terms terms>
struct OdeintLaw {
  const ForcedRun& run;

  template <class Vector>
  void operator()(const Vector& y, Vector& dydt, double t) const {
    dydt[0] = y[1];
    dydt[1] = bench::acceleration<terms>(run, t, y[0], y[1]);
  }
};

/// Euler-Cromer as a stepper of odeint: its own symplectic_euler knows neither time nor velocity in the
/// force.
struct OdeintEulerCromer {
  using state_type = OdeintState;
  using deriv_type = OdeintState;
  using value_type = double;
  using time_type = double;
  using order_type = unsigned short;
  using stepper_category = odeint::stepper_tag;

  static order_type order() { return 1; }

  template <class Law>
  void do_step(const Law& law, OdeintState& y, double t, double h) const {
    OdeintState dydt;
    law(y, dydt, t);
    y[1] += h * dydt[1];
    y[0] += h * y[1];
  }
};

/// Keeps what odeint tells.
struct Keeper {
  Kept& kept;

  template <class Vector>
  void operator()(const Vector& u, double t) const {
    kept.t.push_back(t);
    kept.x.push_back(u[0]);
    kept.v.push_back(u[1]);
  }
};

void forget(Kept& kept) {
  kept.t.clear();
  kept.x.clear();
  kept.v.clear();
}

template <Terms terms, class Stepper>
void odeints(const ForcedRun& run, Stepper stepper, Kept& kept) {
  forget(kept);
  OdeintState y{run.start.x, run.start.v};
  const auto steps = static_cast<std::size_t>(count_steps(run.interval, run.step).whole);
  odeint::integrate_n_steps(stepper, OdeintLaw<terms>{run}, y, run.interval.from, run.step, steps,
                            Keeper{kept});
}

/// Adaptive, at our default tolerance, with a row a step by its dense output.
template <Terms terms>
void odeints_dopri5(const ForcedRun& run, Kept& kept) {
  forget(kept);
  OdeintState y{run.start.x, run.start.v};
  constexpr double tolerance = StepControl::default_tolerance;
  auto stepper = odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<OdeintState>());
  odeint::integrate_const(stepper, OdeintLaw<terms>{run}, y, run.interval.from,
                          run.interval.until + run.step / 2, run.step, Keeper{kept});
}

/// Heun's method by its table: odeint has no stepper of that name.
auto odeints_heun() {
  using Stepper = odeint::explicit_generic_rk<2, 2, OdeintState>;
  const boost::array<double, 1> second{1.0};
  return Stepper(boost::fusion::make_vector(second), boost::array<double, 2>{0.5, 0.5},
                 boost::array<double, 2>{0.0, 1.0});
}

/// What odeint has of our methods. It has no Newmark, generalized-alpha or Gauss; its symplectic ones take no
/// force that depends on the velocity; its implicit Euler (uBLAS of Boost 1.74) does not compile as C++20.
template <Terms terms>
void add_odeint(std::vector<Timed>& works, const ForcedRun& run, Kept& kept) {
  const auto add = [&](const char* method, auto work) {
    works.push_back({std::string(run.name) + ", " + method, "odeint", std::move(work)});
  };
  add("forward-euler", [&] { odeints<terms>(run, odeint::euler<OdeintState>(), kept); });
  add("euler-cromer", [&] { odeints<terms>(run, OdeintEulerCromer(), kept); });
  add("heun", [&] { odeints<terms>(run, odeints_heun(), kept); });
  add("rk4", [&] { odeints<terms>(run, odeint::runge_kutta4<OdeintState>(), kept); });
  add("dormand-prince", [&] { odeints_dopri5<terms>(run, kept); });
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 201;
  const Steps steps = count_steps(bench::forced_runs[0].interval, bench::forced_runs[0].step);
  // Memory for the states is taken once for both sides: fresh pages cost as much as the run.
  KeepEvery keep(1, steps);
  Kept kept;
  for (auto* column : {&kept.t, &kept.x, &kept.v})
    column->reserve(static_cast<std::size_t>(number_of_kept_states(steps, 1)));

  std::vector<Timed> works;
  for (const ForcedRun& run : bench::forced_runs) {
    for (const std::string_view method : method_names) {
      if (method == "exact" && !why_not_exact(run.oscillator).empty()) continue;
      works.push_back({std::string(run.name) + ", " + std::string(method), "cromer",
                       [&, method] { ours(run, method, keep); }});
    }
  }
  add_odeint<bench::linear_terms>(works, bench::forced_runs[0], kept);
  add_odeint<bench::all_smooth_terms>(works, bench::forced_runs[1], kept);
  add_odeint<bench::duffing_terms>(works, bench::forced_runs[2], kept);

  ours(bench::forced_runs[0], "euler-cromer", keep);
  const cromer::Trajectory rows = KeepEvery(keep).take();
  std::string text;
  const std::vector<CsvColumn> columns{{"t (s)", std::span<const double>(rows.t)},
                                       {"x (m)", std::span<const double>(rows.x)},
                                       {"v (m/s)", std::span<const double>(rows.v)}};
  works.push_back({"writing 8000 rows x 3", "cromer", [&] {
                     text.clear();
                     append_csv(text, columns, {}, true);
                   }});
  std::vector<char> buffer(100);
  std::string printed;
  works.push_back({"writing 8000 rows x 3", "printf", [&] {
                     printed.clear();
                     for (std::size_t i = 0; i < rows.size(); ++i)
                       printed.append(buffer.data(), static_cast<std::size_t>(std::snprintf(
                                                         buffer.data(), buffer.size(), "%.17g,%.17g,%.17g\n",
                                                         rows.t[i], rows.x[i], rows.v[i])));
                   }});

  std::vector<std::function<void()>> bare;
  for (const Timed& timed : works) bare.push_back(timed.work);
  const std::vector<double> seconds = bench::medians(bare, rounds);
  for (std::size_t i = 0; i < works.size(); ++i)
    std::printf("%s\t%s\t%.9g\n", works[i].row.c_str(), works[i].who.c_str(), seconds[i]);
}
