// A reference to anything that can be called, its type erased.
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace cromer::core {

template <class Signature>
class FunctionRef;

/// Refers to something callable that outlives it; costs one indirect call and allocates nothing. A function
/// that takes one is compiled once, not once for every caller.
template <class R, class... A>
class FunctionRef<R(A...)> {
 public:
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, FunctionRef> && std::is_invocable_r_v<R, F&, A...>)
      FunctionRef(F&& f)  // NOLINT: what can be called is a function
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(f)))),
        call_([](void* object, A... arguments) -> R {
          return (*static_cast<std::remove_reference_t<F>*>(object))(std::forward<A>(arguments)...);
        }) {}

  R operator()(A... arguments) const { return call_(object_, std::forward<A>(arguments)...); }

 private:
  void* object_;
  R (*call_)(void*, A...);
};

}  // namespace cromer::core
