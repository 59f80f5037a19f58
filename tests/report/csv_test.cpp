#include "cromer/report/csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace cromer::core {
namespace CROMER_FILE {

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

TEST(Csv, HoldsMoreRowsThanItTakesMemoryForAtOnce) {
  for (const std::size_t rows : {4095u, 4096u, 4097u, 12289u}) {
    std::vector<double> x(rows, -2.2250738585072014e-308);
    x[rows - 1] = 7;
    const std::string long_text(200, 'r');
    std::string out;
    append_csv(out, std::vector<CsvColumn>{{"x", x}, {"run", long_text}, {"y", x}}, {}, true);
    EXPECT_EQ(static_cast<std::size_t>(std::count(out.begin(), out.end(), '\n')), rows + 1);
    EXPECT_TRUE(out.ends_with("\n7," + long_text + ",7\n"));
    EXPECT_TRUE(
        out.starts_with("x,run,y\n-2.2250738585072014e-308," + long_text + ",-2.2250738585072014e-308\n"));
  }
}

TEST(Csv, AShorterColumnEndsInEmptyCells) {
  const std::vector<double> two{1, 2}, one{5};
  std::string out;
  append_csv(out, std::vector<CsvColumn>{{"a", two}, {"b", one}}, {}, false);
  EXPECT_EQ(out, "1,5\n2,\n");
  out.clear();
  append_csv(out, std::vector<CsvColumn>{{"a", std::string("t")}}, {}, true);
  EXPECT_EQ(out, "a\n");
  out.clear();
  append_csv(out, {}, std::vector<std::string>{"\n\nx\n"}, false);
  EXPECT_EQ(out, "# \n# \n# x\n# \n");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
