// Gauss's rule of eight points: means over an interval, exact for polynomials up to degree 15.
#pragma once

namespace cromer::core {

/// The mean of f over [from, to]; f may give another type than its argument's.
template <class T, class F>
auto mean_over(const T& from, const T& to, const F& f) {
  // Nodes and weights on [-1, 1]: M. Abramowitz & I. A. Stegun, Handbook, table 25.4.
  constexpr double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  const T middle = 0.5 * (from + to), half = 0.5 * (to - from);
  decltype(f(middle)) sum = 0.0;
  for (int i = 0; i < 4; ++i)
    sum += (0.5 * weight[i]) * (f(T(middle + node[i] * half)) + f(T(middle - node[i] * half)));
  return sum;
}

}  // namespace cromer::core
