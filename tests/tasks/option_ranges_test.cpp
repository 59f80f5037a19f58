// Options of fit, compare, methods, sweep and spectrum at the ends of their ranges: what the tables say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/methods/methods.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/option_owner.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {
namespace CROMER_FILE {

/// What a table's options take.
template <class Options>
class Table {
 public:
  bool takes(std::string_view name, std::string_view text) {
    for (const Option& option : table_)
      if (option.name == name) return assign(option, text).ok();
    ADD_FAILURE() << "no option " << name;
    return false;
  }
  bool has(std::string_view name) const {
    for (const Option& option : table_)
      if (option.name == name) return true;
    return false;
  }
  void positive(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      EXPECT_TRUE(takes(name, "1")) << name;
      EXPECT_FALSE(takes(name, "0")) << name;
    }
  }
  void not_negative(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      EXPECT_TRUE(takes(name, "0")) << name;
      EXPECT_FALSE(takes(name, "-1")) << name;
    }
  }
  void fraction(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      EXPECT_TRUE(takes(name, "0") && takes(name, "1")) << name;
      EXPECT_FALSE(takes(name, "-0.1") || takes(name, "1.1")) << name;
    }
  }

  Options options;

 private:
  std::vector<Option> table_ = options_of(options);
};

TEST(OptionRanges, OfFit) {
  Table<FitOptions> fit;
  fit.positive({"run", "mass", "disc-diameter", "segment", "segments"});
  EXPECT_TRUE(fit.takes("monte-carlo", "1000") && fit.takes("monte-carlo", "10000000"));
  EXPECT_FALSE(fit.takes("monte-carlo", "999") || fit.takes("monte-carlo", "10000001"));
  EXPECT_TRUE(fit.takes("rate", "1e-6") && fit.takes("rate", "1e12"));
  EXPECT_FALSE(fit.takes("rate", "0.9e-6") || fit.takes("rate", "1.1e12") || fit.takes("rate", "0"));
  fit.not_negative({"spring-mass"});
  fit.fraction({"hold-out"});
  EXPECT_TRUE(fit.takes("from", "-1") && fit.takes("to", "-1"));
  EXPECT_TRUE(fit.takes("hysteresis-exponent", "1"));
  EXPECT_FALSE(fit.takes("hysteresis-exponent", "0.9"));
  EXPECT_TRUE(fit.takes("temperature", "100 K") && fit.takes("temperature", "1900 K"));
  EXPECT_FALSE(fit.takes("temperature", "99 K") || fit.takes("temperature", "1901 K"));
  EXPECT_FALSE(fit.options.seed_given);
  EXPECT_TRUE(fit.takes("seed", "0"));
  EXPECT_TRUE(fit.options.seed_given);
  for (const char* flag : {"no-spring", "textbook", "skip-bad-rows"})
    EXPECT_TRUE(fit.takes(flag, "true")) << flag;
  EXPECT_TRUE(fit.options.no_spring && fit.options.textbook && fit.options.read.skip_bad_rows);
}

TEST(OptionRanges, OfCompareAreThoseOfFreeFits) {
  Table<CompareOptions> compare;
  compare.positive({"mass", "step"});
  for (const char* driven : {"force-column", "between-samples", "drive-frequency", "hold-out", "no-spring"})
    EXPECT_FALSE(compare.has(driven)) << driven;
  for (const char* free : {"column", "law", "goal", "textbook", "rate", "method"})
    EXPECT_TRUE(compare.has(free)) << free;
}

TEST(OptionRanges, OfMethods) {
  Table<MethodsOptions> methods;
  methods.positive({"natural-frequency", "step"});
  methods.not_negative({"damping-ratio"});
  methods.fraction({"beta", "gamma", "rho-inf"});
  EXPECT_TRUE(methods.takes("markdown", "true"));
  EXPECT_TRUE(methods.options.markdown);
}

TEST(OptionRanges, OfSweepAndSpectrum) {
  Table<SweepOptions> sweep;
  sweep.positive({"threads"});
  sweep.not_negative({"settle"});
  EXPECT_FALSE(sweep.has("sensor-noise") || sweep.has("hysteresis-stiffness") ||
               sweep.has("hysteresis-exponent") || sweep.has("accuracy"));
  EXPECT_TRUE(sweep.has("loss-factor") && sweep.has("cubic") && sweep.has("static-friction"));
  Table<SpectrumOptions> spectrum;
  spectrum.positive({"run", "rate"});
  EXPECT_TRUE(spectrum.takes("shock", "true") && spectrum.takes("in-g", "true"));
  EXPECT_TRUE(spectrum.options.shock && spectrum.options.in_g);
}

TEST(OptionOwner, IsTheFirstCommandThatHasIt) {
  EXPECT_EQ(option_owner("mass"), "fit");
  EXPECT_EQ(option_owner("disc-diameter"), "fit");
  EXPECT_EQ(option_owner("method"), "simulate");
  EXPECT_EQ(option_owner("markdown"), "methods");
  EXPECT_EQ(option_owner("ductility"), "spectrum");
  EXPECT_EQ(option_owner("of-method"), "modes");
  EXPECT_EQ(option_owner("nothing"), "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
