#include "cromer/run/root.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cromer::core {

double find_root(FunctionRef<double(double)> f, double a, double fa, double b, double fb) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  if (fb == 0) return b;
  if (fa == 0) return a;
  if ((fa > 0) == (fb > 0)) return std::abs(fa) < std::abs(fb) ? a : b;
  const bool positive_after = fb > 0;
  const double resolution = epsilon * std::max(std::abs(a), std::abs(b));
  double x1 = b, f1 = fb, x2 = a, f2 = fa;  // the newest, and the one across the root
  double t = 0.5;
  for (int i = 0; i < 200; ++i) {
    const double x = x1 + t * (x2 - x1), fx = f(x);
    if (fx == 0) return x;
    double x3 = x1, f3 = f1;
    if ((fx > 0) != (f1 > 0)) x3 = x2, f3 = f2, x2 = x1, f2 = f1;
    x1 = x, f1 = fx;
    const double width = std::abs(x2 - x1), least = resolution / width;
    if (!(least < 0.5)) break;
    const double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
    t = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      t = f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
    t = std::clamp(t, least, 1 - least);
  }
  return (f1 > 0) == positive_after ? x1 : x2;
}

}  // namespace cromer::core
