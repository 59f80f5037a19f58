// Every term of the registry, held to what its header says.
#include "cromer/model/terms/all.h"

#include <gtest/gtest.h>

#include <set>
#include <span>
#include <string>

#include "cromer/base/dual.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/law.h"
#include "cromer/model/law_force.h"
#include "cromer/model/terms/term.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

using D = Dual<double, 1>;

/// Calls f.operator()<T>() for every term without an inner state.
template <class F>
void for_each_force(F&& f) {
  for_each_term([&]<class T>() {
    if constexpr (!HasInnerState<T>) f.template operator()<T>();
  });
}

double slope(double from, double to, double h) { return (to - from) / (2 * h); }

TEST(Terms, TheirForcesHaveTheDerivativesOfTheirDifferences) {
  const double h = 1e-5;
  for_each_force([&]<class T>() {
    for (const double x : {-0.8, 0.3})
      for (const double v : {-0.5, 1.2})
        for (const double p : {-0.7, 2.0}) {
          const auto along = [&](double to_x, double to_v, double to_p) {
            return slope(T::force(x - h * to_x, v - h * to_v, p - h * to_p),
                         T::force(x + h * to_x, v + h * to_v, p + h * to_p), h);
          };
          const D by_x(T::force(D::variable(x, 0), v, p)), by_v(T::force(x, D::variable(v, 0), p)),
              by_p(T::force(x, v, D::variable(p, 0)));
          EXPECT_NEAR(by_x.derivative[0], along(1, 0, 0), 1e-8) << T::info.name;
          EXPECT_NEAR(by_v.derivative[0], along(0, 1, 0), 1e-8) << T::info.name;
          EXPECT_NEAR(by_p.derivative[0], along(0, 0, 1), 1e-8) << T::info.name;
        }
  });
}

TEST(Terms, TheirForcesAreTheSlopesOfTheirEnergies) {
  for_each_force([&]<class T>() {
    constexpr bool stores = requires { T::energy(0.3, 1.3); };
    EXPECT_EQ(stores, T::info.acts_at_rest) << T::info.name;
    if constexpr (stores) {
      for (const double x : {-0.8, 0.3}) {
        EXPECT_NEAR(T::energy(D::variable(x, 0), 1.3).derivative[0], T::force(x, 0.0, 1.3), 1e-15)
            << T::info.name;
      }
    } else {
      EXPECT_EQ(T::force(0.7, 0.0, 1.3), 0) << T::info.name;
    }
  });
}

TEST(Terms, ThatDampOnlyTake) {
  for_each_force([]<class T>() {
    if constexpr (T::info.damps) {
      for (const double x : {-0.8, 0.3})
        for (const double v : {-0.5, 1.2}) EXPECT_GT(T::force(x, v, 1.3) * v, 0) << T::info.name;
    }
  });
}

TEST(Terms, HaveNamesOfTheirOwnAndUnitsThatAreKnown) {
  std::set<std::string> names, options;
  for_each_term([&]<class T>() {
    EXPECT_TRUE(names.insert(std::string(T::info.name)).second) << T::info.name;
    for (const CoefficientInfo& each : T::coefficients) {
      EXPECT_TRUE(options.insert(std::string(each.option)).second) << each.option;
      EXPECT_FALSE(each.meaning.empty());
    }
  });
  EXPECT_EQ(unit_of(Spring::coefficients[0]), "N/m");
  EXPECT_EQ(unit_of(Viscous::coefficients[0]), "kg/s");
  EXPECT_EQ(unit_of(Drag::coefficients[0]), "kg/m");
  EXPECT_EQ(unit_of(Friction::coefficients[0]), "N");
  EXPECT_EQ(unit_of(Quintic::coefficients[0]), "N/m^5");
  EXPECT_EQ(unit_of(VanDerPol::coefficients[0]), "kg/(m^2 s)");
  EXPECT_EQ(unit_of(Hysteresis::coefficients[1]), "1/m");
}

std::string options_of(std::span<const CoefficientInfo> coefficients) {
  std::string text;
  for (const CoefficientInfo& each : coefficients) {
    text.append(text.empty() ? "`--" : "; `--").append(each.option).append("` ").append(each.symbol);
    text += " [" + unit_of(each) + "]";
    if (each.sign == Sign::not_negative) text += " at least 0";
  }
  return text;
}

/// The table of terms of docs/methods.md, as their headers have it.
std::string terms_in_markdown() {
  std::string table =
      "| term | force | coefficients | what makes such a force | source |\n"
      "|---|---|---|---|---|\n";
  for_each_term([&]<class T>() {
    table.append("| ").append(T::info.name).append(" | ");
    for (const char c : T::info.formula) table.append(c == '|' ? "\\" : "").append(1, c);
    table.append(" | ").append(options_of(T::coefficients)).append(" | ");
    table.append(T::info.meaning).append(" | ").append(T::info.source).append(" |\n");
  });
  return table;
}

TEST(Terms, StandInTheTableOfTheMethodsPage) {
  const std::string page = bytes_of(CROMER_SOURCE_DIR "/docs/methods.md");
  EXPECT_NE(page.find(terms_in_markdown()), std::string::npos) << "put this table into docs/methods.md:\n"
                                                               << terms_in_markdown();
}

TEST(Terms, NameTheirCoefficientsInTheirFormulas) {
  for_each_term([]<class T>() {
    for (const CoefficientInfo& each : T::coefficients)
      EXPECT_NE(T::info.formula.find(each.symbol), std::string_view::npos) << each.option;
  });
}

TEST(Terms, OfEverySetAccelerateAlikeHoweverTheyAreCompiled) {
  // AnyTerms, the shared code of DrivenOscillator and the one written for a set: to the bit.
  for (std::uint32_t bits = 0; bits < (std::uint32_t{1} << term_count); ++bits) {
    const Law law = Law{bits & smooth_terms.terms}.with(law_with<Spring>);
    if ((law.terms | law_with<Friction, Hysteresis>.terms) != (bits | law_with<Friction, Hysteresis>.terms))
      continue;
    Oscillator<double> o{.stiffness = 3.3};
    for_each_term([&]<class T>() {
      if (law.has<T>()) o.*T::template members<double>[0] = T::info.damps ? 0.37 : -1.9;
    });
    EXPECT_EQ(law_of(o), law);
    const HarmonicForce<double> force{1.3, 2.1, 0.4};
    const AnyTerms any(o, force);
    const DrivenOscillator<double, Terms{.drive = true, .law = any_terms}> shared(o, force);
    const DrivenOscillator<double, Terms{.drive = true, .law = smooth_terms}> whole(o, force);
    for (const double x : {-0.31, 1.7})
      for (const double v : {-2.3, 0.77}) {
        const double expected = any.acceleration(0.9, x, v);
        EXPECT_EQ(shared.acceleration(0.9, x, v), expected) << bits;
        EXPECT_EQ(whole.acceleration(0.9, x, v), expected) << bits;
        with_smooth_terms<true>(o, force, [&](const auto& system) {
          EXPECT_EQ(system.acceleration(0.9, x, v), expected) << bits;
        });
      }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
