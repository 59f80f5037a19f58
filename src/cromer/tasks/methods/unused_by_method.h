// Which options of the methods a method makes no use of.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/base/add_once.h"
#include "cromer/methods/all.h"
#include "cromer/notice.h"

namespace cromer::core {

/// Whether the method chooses its steps, or solves an equation in every step (or only if the force depends on
/// the velocity).
bool uses_tolerance(std::string_view method);

/// Says which of beta, gamma, rho_inf and tolerance (if there is one) are given to a method without use for
/// them.
template <class Options>
void say_unused_by_method(std::string_view method, const Options& options, std::vector<Notice>& notices) {
  const auto no_effect = [&](std::string_view option) {
    add_once(notices, Notice{"no_effect_on_method", {{"option", option}, {"method", method}}});
  };
  if constexpr (requires { options.tolerance; })
    if (options.tolerance && !uses_tolerance(method)) no_effect("tolerance");
  if (method != Newmark::info.name) {
    if (options.beta) no_effect("beta");
    if (options.gamma) no_effect("gamma");
  }
  if (options.rho_inf && method != GeneralizedAlpha::info.name) no_effect("rho-inf");
}

}  // namespace cromer::core
