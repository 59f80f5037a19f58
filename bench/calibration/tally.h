// What the fits of many records of one law under one condition came to.
#pragma once

#include <string>
#include <vector>

namespace cromer::core::bench {

struct ParameterTally {
  std::string name;
  double coverage = 0;  ///< share of the 95 % intervals that hold the truth
  double scatter = 0;   ///< root mean square error over the Cramér-Rao bound
  double stated = 0;    ///< root mean square of the standard errors over that bound
  double strength = 0;  ///< the truth over the bound: how many standard errors the parameter is worth
};

struct Tally {
  const char* law = "";
  const char* condition = "";
  std::size_t records = 0;
  double failures = 0;  ///< share without a converged fit; the others are what the rest is about
  double on_bound = 0;  ///< share with a coefficient that would be negative and was kept at 0
  std::vector<ParameterTally> parameters;
};

}  // namespace cromer::core::bench
