// Which method made a run. The runs are made here, of each method as its textbook has it: of the linear law
// as a function of its matrix, without the project's own steps.
#include "cromer/tasks/recognise/recognise.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/methods/method_effect.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// ---- simulators of our own

struct Point {
  double x, v;
};

struct Matrix2 {
  double a, b, c, d;

  Matrix2 operator*(const Matrix2& o) const {
    return {a * o.a + b * o.c, a * o.b + b * o.d, c * o.a + d * o.c, c * o.b + d * o.d};
  }
  Matrix2 operator+(const Matrix2& o) const { return {a + o.a, b + o.b, c + o.c, d + o.d}; }
  Matrix2 operator*(double s) const { return {s * a, s * b, s * c, s * d}; }
  Matrix2 inverse() const {
    const double det = a * d - b * c;
    return {d / det, -b / det, -c / det, a / det};
  }
  Point operator*(const Point& y) const { return {a * y.x + b * y.v, c * y.x + d * y.v}; }
};

constexpr Matrix2 one{1, 0, 0, 1};

struct Linear {
  double stiffness, damping;  // per unit mass

  Matrix2 matrix() const { return {0, 1, -stiffness, -damping}; }
};

Matrix2 verlet(const Linear& law, double h) {
  // v' = v + h/2 (a(x, v) + a(x', v')), solved for v'
  const double k = law.stiffness, c = law.damping, e = 1 + h * c / 2;
  const double xx = 1 - h * h * k / 2, xv = h - h * h * c / 2;
  return {xx, xv, -h * k / 2 * (1 + xx) / e, (1 - h * c / 2 - h * k / 2 * xv) / e};
}

Matrix2 exact(const Linear& law, double h) {
  const double b = law.damping / 2, w = std::sqrt(law.stiffness - b * b), fall = std::exp(-b * h);
  const double c = std::cos(w * h), s = std::sin(w * h) / w;
  return Matrix2{c + b * s, s, -law.stiffness * s, c - b * s} * fall;
}

/// One step of the method of that name.
Matrix2 step_of(std::string_view method, const Linear& law, double h) {
  const Matrix2 z = law.matrix() * h, z2 = z * z;
  if (method == "forward-euler") return one + z;
  if (method == "euler-cromer") {
    const double x = -h * law.stiffness, v = 1 - h * law.damping;
    return {1 + h * x, h * v, x, v};
  }
  if (method == "implicit-euler") return (one + z * -1).inverse();
  if (method == "verlet") return verlet(law, h);
  if (method == "newmark" || method == "implicit-midpoint")
    return (one + z * -0.5).inverse() * (one + z * 0.5);
  if (method == "heun") return one + z + z2 * 0.5;
  if (method == "rk4") return one + z + z2 * 0.5 + z2 * z * (1.0 / 6) + z2 * z2 * (1.0 / 24);
  if (method == "yoshida4") {
    const double outer = 1 / (2 - std::cbrt(2.0)), inner = 1 - 2 * outer;
    return verlet(law, outer * h) * verlet(law, inner * h) * verlet(law, outer * h);
  }
  if (method == "gauss-legendre4")
    return (one + z * -0.5 + z2 * (1.0 / 12)).inverse() * (one + z * 0.5 + z2 * (1.0 / 12));
  return exact(law, h);
}

std::vector<Point> rows_by(const Matrix2& step, Point y, int every, int count) {
  std::vector<Point> rows{y};
  while (static_cast<int>(rows.size()) < count) {
    for (int i = 0; i < every; ++i) y = step * y;
    rows.push_back(y);
  }
  return rows;
}

/// Generalized-alpha with rho_inf = 0.8, from where it has run for `before` steps.
std::vector<Point> generalized_alpha_rows(const Linear& law, Point y, double h, int every, int count,
                                          int before = 0) {
  const double r = 0.8, am = (2 * r - 1) / (1 + r), af = r / (1 + r), g = 0.5 - am + af,
               b = 1 / ((1 + r) * (1 + r));
  const double k = law.stiffness, c = law.damping;
  double a = -k * y.x - c * y.v;
  std::vector<Point> rows;
  for (int n = 0; static_cast<int>(rows.size()) < count; ++n) {
    if (n >= before && (n - before) % every == 0) rows.push_back(y);
    const Point p{y.x + h * y.v + h * h * (0.5 - b) * a, y.v + h * (1 - g) * a};
    const double next = (-am * a - k * ((1 - af) * p.x + af * y.x) - c * ((1 - af) * p.v + af * y.v)) /
                        (1 - am + (1 - af) * (k * h * h * b + c * h * g));
    y = {p.x + h * h * b * next, p.v + h * g * next};
    a = next;
  }
  return rows;
}

/// Any law by steps.
std::vector<Point> rows_of(const std::function<Point(const Point&)>& step, Point y, int every, int count) {
  std::vector<Point> rows{y};
  while (static_cast<int>(rows.size()) < count) {
    for (int i = 0; i < every; ++i) y = step(y);
    rows.push_back(y);
  }
  return rows;
}

// ---- files

std::string file_of(const std::vector<Point>& rows, double spacing, int digits) {
  std::string text = "t (s),x (m),v (m/s)\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += fmt::format("{:.{}g},{:.{}g},{:.{}g}\n", static_cast<double>(i) * spacing, digits, rows[i].x,
                        digits, rows[i].v, digits);
  return text;
}

RecogniseOptions law_options(const Linear& law) {
  RecogniseOptions options;
  options.simulate.stiffness = law.stiffness;
  options.simulate.damping = law.damping;
  return options;
}

Result<RecogniseResult> recognised(const std::string& file, const RecogniseOptions& options) {
  const auto recording = read_recording(file, "run.csv", options.read);
  if (!recording) return recording.error();
  return recognise(*recording, options);
}

std::string refusal(const std::string& file, const RecogniseOptions& options = {}) {
  const auto result = recognised(file, options);
  return result ? "" : in_words(result.error());
}

bool names(const RecognisedMethod& found, std::string_view method) {
  return found.method == method ||
         std::find(found.same_map.begin(), found.same_map.end(), method) != found.same_map.end();
}

const Linear spring{.stiffness = 80, .damping = 0.1};  // w0 = 8.94 rad/s
constexpr Point start{0.05, 0.1};

// ---- tests

// Steps and laws drawn by chance, rows every 1 to 5 steps, 6 to 17 digits: at least 95 of 100 are right.
TEST(Recognise, FindsMethodAndStepOfBlindCases) {
  std::mt19937_64 chance(20261126);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<>()(chance);
  };
  int cases = 0, right = 0;
  std::string wrong;
  for (const std::string_view method : method_names) {
    if (find_method(method)->is_adaptive()) continue;
    for (int i = 0; i < 8; ++i) {
      const double w = std::pow(10, between(-0.5, 1.5)), ratio = i % 2 == 0 ? 0 : between(0.001, 0.1);
      const Linear law{w * w, 2 * ratio * w};
      const double h = std::stod(fmt::format("{:.3g}", std::pow(10, between(-1.5, -0.3)) / w));
      const int every = static_cast<int>(between(1, 6)), digits = static_cast<int>(between(6, 18));
      const double phase = between(0, 6.28);
      const Point y{std::cos(phase), -w * std::sin(phase)};
      const auto rows = method == "generalized-alpha" ? generalized_alpha_rows(law, y, h, every, 200)
                                                      : rows_by(step_of(method, law, h), y, every, 200);
      const auto result = recognised(file_of(rows, h * every, digits), law_options(law));
      ASSERT_TRUE(result.ok()) << in_words(result.error());
      const RecognisedMethod& best = result->recognised.front();
      const bool good = result->ok() && names(best, method) &&
                        (method == "exact" ? !best.step : best.step && std::abs(*best.step / h - 1) < 1e-5);
      ++cases;
      right += good;
      if (!good) wrong += fmt::format("{} step {} every {}: {}\n", method, h, every, in_words(result->words));
    }
  }
  EXPECT_GE(right, 0.95 * cases) << wrong;
}

TEST(Recognise, SaysWhatTheMethodAdded) {
  const double h = 0.01;
  for (const std::string_view method : {"forward-euler", "euler-cromer", "implicit-euler", "heun"}) {
    const auto result = recognised(file_of(rows_by(step_of(method, spring, h), start, 2, 200), 2 * h, 9),
                                   law_options(spring));
    ASSERT_TRUE(result.ok());
    const RecognisedMethod& best = result->recognised.front();
    EXPECT_EQ(best.method, method);
    EXPECT_EQ(best.steps_per_row, 2);
    const LinearLaw<double> law{.decay_rate = spring.damping / 2, .stiffness = spring.stiffness};
    const auto effect = method_effect(method, {}, law, h, false);
    EXPECT_NEAR(best.decay_rate_added.value_or(0), *effect->effective.decay_rate - law.decay_rate, 1e-12);
    EXPECT_NEAR(best.frequency_shift.value_or(0),
                *effect->effective.angular_frequency - damped_frequency(law), 1e-12);
    EXPECT_LT(best.distance, 2 * result->rounding);
  }
}

TEST(Recognise, NamesMethodsOfTheSameMap) {
  const double h = 0.01;
  const auto linear =
      recognised(file_of(rows_by(step_of("newmark", spring, h), start, 1, 200), h, 12), law_options(spring));
  ASSERT_TRUE(linear.ok());
  EXPECT_EQ(linear->recognised.front().method, "newmark");
  EXPECT_THAT(linear->recognised.front().same_map, ElementsAre("implicit-midpoint"));
  // With beta = 0 and without damping newmark is verlet.
  const Linear undamped{80, 0};
  RecogniseOptions options = law_options(undamped);
  options.methods.beta = 0;
  const auto central = recognised(file_of(rows_by(verlet(undamped, h), start, 1, 200), h, 12), options);
  ASSERT_TRUE(central.ok());
  EXPECT_EQ(central->recognised.front().method, "verlet");
  EXPECT_THAT(central->recognised.front().same_map, ElementsAre("newmark"));
}

/// Of x'' = -80 x - 0.1 v - 15000 x^3 - 0.3 v|v|.
double pull(const Point& y) {
  return -80 * y.x - 0.1 * y.v - 15000 * y.x * y.x * y.x - 0.3 * y.v * std::abs(y.v);
}

RecogniseOptions bent_law() {
  RecogniseOptions options = law_options(spring);
  options.simulate.law.cubic = 15000;
  options.simulate.law.drag = 0.3;
  return options;
}

Point semi_implicit(const Point& y, double h) {
  const double v = y.v + h * pull(y);
  return {y.x + h * v, v};
}

TEST(Recognise, KnowsMethodsUnderABentSpringAndDrag) {
  const double h = 0.01;
  const auto by = [&](const auto& step) {
    const auto result = recognised(file_of(rows_of(step, start, 3, 200), 3 * h, 9), bent_law());
    EXPECT_TRUE(result.ok());
    return *result;
  };
  const RecogniseResult cromer = by([&](const Point& y) { return semi_implicit(y, h); });
  EXPECT_EQ(cromer.verdict, Verdict::made);
  EXPECT_EQ(cromer.recognised.front().method, "euler-cromer");
  EXPECT_NEAR(*cromer.recognised.front().step, h, 1e-12);
  EXPECT_TRUE(cromer.recognised.front().frequency_shift.has_value());
  const RecogniseResult midpoint = by([&](const Point& y) {
    const Point middle{y.x + h / 2 * y.v, y.v + h / 2 * pull(y)};
    return Point{y.x + h * middle.v, y.v + h * pull(middle)};
  });
  // The explicit midpoint rule is none of the methods; under a linear law it would be heun.
  EXPECT_EQ(midpoint.verdict, Verdict::none);
  EXPECT_THAT(in_words(midpoint.words), HasSubstr("none of the methods made these rows"));
}

TEST(Recognise, SeesThatThePositionWasSteppedFirst) {
  for (int i = 0; i < 6; ++i) {
    const double h = 0.01 + 0.0083 * i;
    const auto step = [&](const Point& y) {
      const double x = y.x + h * y.v;
      return Point{x, y.v + h * pull({x, y.v})};
    };
    const int each = i % 2 + 1;
    const Point begin = i % 3 == 0 ? Point{start.x, 0} : start;
    const auto result = recognised(file_of(rows_of(step, begin, each, 200), each * h, 12), bent_law());
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result->verdict, Verdict::made) << h;
    EXPECT_EQ(result->recognised.front().method, "euler-cromer") << h;
    EXPECT_TRUE(result->recognised.front().velocity_ahead) << h;
  }
}

TEST(Recognise, TakesAPartOfARunOfAMethodThatCarriesAnAcceleration) {
  const auto rows = generalized_alpha_rows(spring, start, 0.02, 2, 250, 47);
  const auto result = recognised(file_of(rows, 0.04, 16), law_options(spring));
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->verdict, Verdict::made);
  EXPECT_EQ(result->recognised.front().method, "generalized-alpha");
}

TEST(Recognise, TakesNumbersInSinglePrecision) {
  float x = 0.05f, v = 0.1f;
  const float h = 1.0f / 60;
  std::vector<Point> rows;
  for (int i = 0; i < 300; ++i) {
    rows.push_back({x, v});
    v += h * (-80 * x - 0.1f * v);
    x += h * v;
  }
  const auto result = recognised(file_of(rows, 1.0 / 60, 9), law_options(spring));
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->verdict, Verdict::made);
  EXPECT_EQ(result->recognised.front().method, "euler-cromer");
  EXPECT_NEAR(*result->recognised.front().step, 1.0 / 60, 1e-8);
}

TEST(Recognise, FitsTheLawWhereNoneIsGiven) {
  const auto result = recognised(file_of(rows_by(step_of("rk4", spring, 0.01), start, 2, 250), 0.02, 12), {});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->law_fitted);
  EXPECT_EQ(result->recognised.front().method, "rk4");
  EXPECT_NEAR(*result->natural_frequency, std::sqrt(80), 1e-8);
  // An implicit Euler step is an Euler-Cromer step of another law: two answers, and it is said.
  const auto both =
      recognised(file_of(rows_by(step_of("euler-cromer", spring, 0.01), start, 2, 250), 0.02, 9), {});
  ASSERT_TRUE(both.ok());
  EXPECT_EQ(both->recognised.front().method, "euler-cromer");
  EXPECT_EQ(both->alike, 2u);
  EXPECT_THAT(in_words(both->words), HasSubstr("1 other below it"));
}

// The motion that is seen may be far from the law: forward Euler makes growth of a decay.
TEST(Recognise, FitsTheLawOfAMethodThatChangesItMuch) {
  const Linear law{.stiffness = 25, .damping = 0.3};
  for (const char* method : {"forward-euler", "heun"})
    for (const int every : {2, 7}) {
      const auto rows = rows_by(step_of(method, law, 0.02), start, every, 300);
      const auto result = recognised(file_of(rows, 0.02 * every, 12), {});
      ASSERT_TRUE(result.ok());
      const RecognisedMethod& first = result->recognised.front();
      EXPECT_EQ(first.method, method) << every;
      EXPECT_EQ(first.steps_per_row, every);
      EXPECT_NEAR(*first.step, 0.02, 1e-7);
      EXPECT_NEAR(*result->damping_ratio, 0.03, 1e-6) << method << every;
    }
}

TEST(Recognise, SaysThatTheLawIsAnother) {
  Linear wrong = spring;
  wrong.stiffness *= 1.02;
  const auto result =
      recognised(file_of(rows_by(step_of("rk4", spring, 0.02), start, 2, 250), 0.04, 12), law_options(wrong));
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->verdict, Verdict::other_law);
  EXPECT_FALSE(result->ok());
  EXPECT_THAT(in_words(result->words), HasSubstr("check the law"));
  EXPECT_NEAR(*result->natural_frequency, std::sqrt(80), 1e-8);
}

TEST(Recognise, DoesNotForceAnAnswerOnNoise) {
  std::mt19937_64 chance(7);
  std::normal_distribution<> noise;
  auto rows = rows_by(step_of("exact", spring, 0.02), start, 1, 250);
  for (Point& y : rows) y = {y.x + 3e-4 * noise(chance), y.v + 3e-3 * noise(chance)};
  const auto result = recognised(file_of(rows, 0.02, 6), law_options(spring));
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->verdict, Verdict::none);
  EXPECT_THAT(in_words(result->words), HasSubstr("others are as far off"));
}

TEST(Recognise, TriesOneStepIfAsked) {
  const std::string file = file_of(rows_by(step_of("verlet", spring, 0.01), start, 4, 100), 0.04, 9);
  RecogniseOptions options = law_options(spring);
  options.methods.step = 0.01;
  EXPECT_EQ((*recognised(file, options)).recognised.front().method, "verlet");
  options.methods.step = 0.02;
  EXPECT_EQ((*recognised(file, options)).verdict, Verdict::none);
  options.methods.step = 0.015;
  EXPECT_THAT(refusal(file, options), HasSubstr("no whole number of steps of 0.015 s"));
}

TEST(Recognise, TriesTheStepThatIsAskedForHoweverManyAreBetweenTwoRows) {
  for (const int every : {40, 500}) {
    const double h = 0.08 / every;
    const auto rows = rows_of([&](const Point& y) { return semi_implicit(y, h); }, start, every, 600);
    RecogniseOptions options = bent_law();
    options.methods.step = h;
    const auto result = recognised(file_of(rows, 0.08, 12), options);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result->verdict, Verdict::made);
    EXPECT_EQ(result->recognised.front().method, "euler-cromer");
    EXPECT_EQ(result->recognised.front().steps_per_row, every);
    options.methods.step = 1e-9;
    EXPECT_THAT(refusal(file_of(rows, 0.08, 12), options), HasSubstr("at most 500 are tried"));
  }
}

TEST(Recognise, RefusesWhatIsNoRun) {
  EXPECT_THAT(refusal("t (s),x (m)\n0,1\n1,2\n2,3\n"), HasSubstr("which column is the velocity?"));
  EXPECT_THAT(refusal("t (s),x (m),v (m/s)\n0,1,0\n1,2,0\n2,3,1\n"), HasSubstr("3 rows"));
  EXPECT_THAT(refusal("t (s),x (m),v (m/s)\n0,1,0\n1,2,0\n2,3,1\n3.5,1,1\n4,2,2\n5,1,1\n6,2,1\n"),
              HasSubstr("not evenly spaced"));
  EXPECT_THAT(refusal("t (s),x (m),v (m/s)\n0,1,0\n1,,0\n2,3,1\n3,1,1\n4,2,2\n5,1,1\n6,2,1\n"),
              HasSubstr("is missing"));
  EXPECT_THAT(refusal("t (s),x (m),v (m/s)\n0,0,0\n1,0,0\n2,0,0\n3,0,0\n4,0,0\n5,0,0\n6,0,0\n"),
              HasSubstr("nothing moves"));
  RecogniseOptions options;
  options.simulate.damping = 0.1;
  const std::string file = file_of(rows_by(step_of("verlet", spring, 0.01), start, 4, 100), 0.04, 9);
  EXPECT_THAT(refusal(file, options), HasSubstr("the law has no spring"));
  options.methods.natural_frequency = -1;
  EXPECT_THAT(refusal(file, options), HasSubstr("positive"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
