// The picture itself: where gnuplot has put what the layout says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cromer/report/figure.h"
#include "cromer/report/layout.h"
#include "cromer/report/process.h"

namespace cromer {
namespace {

std::vector<std::vector<double>> paths_of(const std::string& svg, const std::string& colour) {
  std::vector<std::vector<double>> paths;
  const std::string begin = "<path stroke=\"" + colour + "\"";
  for (std::size_t at = 0; (at = svg.find(begin, at)) != std::string::npos; ++at) {
    const std::size_t d = svg.find(" d=\"M", at) + 5;
    std::vector<double>& numbers = paths.emplace_back();
    for (const char* p = svg.c_str() + d; *p != '"';) {
      char* end = nullptr;
      const double value = std::strtod(p, &end);
      if (end != p) numbers.push_back(value);
      p = end != p ? end : p + 1;
    }
  }
  return paths;
}

TEST(Drawing, TheCurvePassesWhereTheDataAre) {
  if (gnuplot_version().empty()) GTEST_SKIP() << "gnuplot is not installed";
  Figure figure;
  Panel& panel = figure.panels.emplace_back();
  Curve& curve = panel.curves.emplace_back();
  curve.role = "euler-cromer";
  curve.x = {0, 2, 5, 10};
  curve.y = {-0.9, 0.9, 0.1, 0.5};
  const auto svg = draw(figure, FigureFormat::svg);
  ASSERT_TRUE(svg.ok());
  const Box f = lay_out(figure, Typeface::dejavu_sans).panels[0].frame;
  const auto paths = paths_of(*svg, "#0072B2");
  ASSERT_EQ(paths.size(), 1u);
  ASSERT_EQ(paths[0].size(), 8u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(paths[0][2 * i], f.x + f.width * curve.x[i] / 10, 0.6) << i;
    EXPECT_NEAR(paths[0][2 * i + 1], f.y + f.height * (1 - curve.y[i]) / 2, 0.6) << i;
  }
}

TEST(Drawing, SaysWhatGnuplotComplainsOf) {
  const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
  std::string folder = "/tmp/cromer-gnuplot-XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const auto answer = [&](const std::string& script) {
    const auto made =
        run_process({"/bin/sh", "-c", "cat > " + folder + "/gnuplot; chmod +x " + folder + "/gnuplot"},
                    "#!/bin/sh\n" + script + "\n");
    EXPECT_TRUE(made.ok());
    ::setenv("PATH", (folder + ":" + path).c_str(), 1);
    Figure figure;
    figure.id = "figure-7";
    const auto drawn = draw(figure, FigureFormat::svg);
    ::setenv("PATH", path.c_str(), 1);
    return drawn.ok() ? "drawn" : drawn.error().message;
  };
  EXPECT_EQ(answer("exit 0"), "gnuplot could not draw figure-7: it wrote no picture");
  EXPECT_EQ(answer("printf '\\n   ^\\nline 0: no\\nmore' >&2; echo x; exit 3"),
            "gnuplot could not draw figure-7: line 0: no");
  EXPECT_EQ(answer("printf 'no end' >&2; exit 1"), "gnuplot could not draw figure-7: no end");
  EXPECT_THAT(answer("echo 'unknown or ambiguous terminal type' >&2; exit 1"),
              testing::HasSubstr("this gnuplot lacks that format, gnuplot-nox and gnuplot-qt have it"));
  EXPECT_EQ(answer("echo '<svg></svg>'"), "drawn");
  ::setenv("PATH", (folder + ":" + path).c_str(), 1);
  EXPECT_EQ(gnuplot_version(), "<svg></svg>");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(run_process({"rm", "-r", folder}, "").ok());
}

TEST(Process, ASignalIsAStatusAboveAHundredAndTwentyEight) {
  EXPECT_EQ(run_process({"/bin/sh", "-c", "kill -9 $$"}, "")->exit_status, 128 + 9);
  const auto both = run_process({"/bin/sh", "-c", "cat; echo wrong >&2; exit 7"}, "in");
  EXPECT_EQ(both->out, "in");
  EXPECT_EQ(both->err, "wrong\n");
  EXPECT_EQ(both->exit_status, 7);
  EXPECT_EQ(run_process({"/no/such/program"}, "").error().message, "No such file or directory");
}

}  // namespace
}  // namespace cromer
