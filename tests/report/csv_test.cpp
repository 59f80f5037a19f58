#include "cromer/report/csv.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace cromer {
namespace {

TEST(Csv, WritesHeaderCommentsTextAndMissingValues) {
  const std::vector<double> t{0, 0.5}, x{-1.25e-7, std::nan("")};
  const std::vector<CsvColumn> columns{
      {"run", std::string("euler-cromer")}, {"t (s)", t}, {"x, y \"(m)\"", x}};
  const std::vector<std::string> comments{"made by cromer", "two\nlines"};
  std::string out = "before\n";
  append_csv(out, columns, comments, true);
  EXPECT_EQ(out,
            "before\n# made by cromer\n# two\n# lines\nrun,t (s),\"x, y \"\"(m)\"\"\"\n"
            "euler-cromer,0,-1.25e-07\neuler-cromer,0.5,\n");
  std::string again;
  append_csv(again, columns, {}, false);
  EXPECT_EQ(again, "euler-cromer,0,-1.25e-07\neuler-cromer,0.5,\n");
}

TEST(Csv, EveryNumberReadsBackAsTheSameDouble) {
  std::mt19937_64 random(7);
  std::vector<double> numbers{
      0.1, 1e22, 1e23, 5e-324, std::numeric_limits<double>::max(), -0.0, 9007199254740993.0};
  while (numbers.size() < 20000) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) numbers.push_back(value);
  }
  std::string out;
  append_csv(out, std::vector<CsvColumn>{{"x", numbers}}, {}, false);
  const char* p = out.data();
  for (const double number : numbers) {
    double read = 0;
    p = std::from_chars(p, out.data() + out.size(), read).ptr;
    ASSERT_EQ(*p++, '\n');
    ASSERT_EQ(std::memcmp(&read, &number, sizeof read), 0) << number;
  }
  EXPECT_EQ(p, out.data() + out.size());
}

TEST(Csv, AQuotedTextIsOneCellInEveryRow) {
  const std::vector<double> x{1, 2};
  std::string out;
  append_csv(out, std::vector<CsvColumn>{{"run", std::string("ω = 3, damped")}, {"x", x}}, {}, false);
  EXPECT_EQ(out, "\"ω = 3, damped\",1\n\"ω = 3, damped\",2\n");
}

}  // namespace
}  // namespace cromer
