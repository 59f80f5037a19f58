// The registry: the only list of methods. A new one is an include and an entry.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "cromer/base/nearest.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/methods/exact.h"
#include "cromer/methods/forward_euler.h"
#include "cromer/methods/gauss_legendre4.h"
#include "cromer/methods/generalized_alpha.h"
#include "cromer/methods/heun.h"
#include "cromer/methods/implicit_euler.h"
#include "cromer/methods/implicit_midpoint.h"
#include "cromer/methods/method_settings.h"
#include "cromer/methods/newmark.h"
#include "cromer/methods/rk4.h"
#include "cromer/methods/verlet.h"
#include "cromer/methods/yoshida4.h"
#include "cromer/result.h"

namespace cromer::core {

using AllMethods = std::tuple<ForwardEuler, EulerCromer, ImplicitEuler, Verlet, Newmark, ImplicitMidpoint,
                              GeneralizedAlpha, Heun, Rk4, Yoshida4, GaussLegendre4, DormandPrince, Exact>;

template <class M>
constexpr M make_method(const MethodSettings& settings) {
  M method;
  if constexpr (requires { method.newton; }) method.newton = settings.newton;
  if constexpr (requires { method.beta; }) method.beta = settings.beta;
  if constexpr (requires { method.gamma; }) method.gamma = settings.gamma;
  if constexpr (requires { method.rho_inf; }) method.rho_inf = settings.rho_inf;
  return method;
}

/// Names in the order of the list.
inline constexpr auto method_names = []<class... M>(std::type_identity<std::tuple<M...>>) {
  return std::array<std::string_view, sizeof...(M)>{M::info.name...};
}(std::type_identity<AllMethods>{});

/// What is known of each method, in the order of the list.
inline constexpr auto method_infos = []<class... M>(std::type_identity<std::tuple<M...>>) {
  return std::array<MethodInfo, sizeof...(M)>{M::info...};
}(std::type_identity<AllMethods>{});

/// The information on one method; nullptr if there is none of that name.
constexpr const MethodInfo* find_method(std::string_view name) {
  for (const MethodInfo& info : method_infos)
    if (info.name == name) return &info;
  return nullptr;
}

/// Calls f(method) for the method of that name, which must be in the list (find_method), and returns what f
/// returns: the same type, default constructible, for every method. The one look-up by name, outside every
/// loop.
template <class F>
auto visit_method(std::string_view name, const MethodSettings& settings, F&& f) {
  return [&]<class... M>(std::type_identity<std::tuple<M...>>) {
    using R = std::common_type_t<decltype(f(std::declval<const M&>()))...>;
    R result{};
    static_cast<void>(((M::info.name == name && (result = f(make_method<M>(settings)), true)) || ...));
    return result;
  }(std::type_identity<AllMethods>{});
}

/// Success, or an Error for a name that is not in the list, with the names near it.
inline Result<void> check_method_name(std::string_view name) {
  if (find_method(name)) return {};
  const std::vector<std::string> all(method_names.begin(), method_names.end());
  if (const auto near = nearest_names(name, method_names); !near.empty())
    return Error{"no_method_but", {{"method", name}, {"near", near}, {"methods", all}}};
  return Error{"no_method", {{"method", name}, {"methods", all}}};
}

}  // namespace cromer::core
