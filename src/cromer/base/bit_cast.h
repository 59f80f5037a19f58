// The bits of one type as another: std::bit_cast, which the page's standard library lacks.
#pragma once

namespace cromer::core {

template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

}  // namespace cromer::core
