#include "cromer/report/figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cromer/report/layout.h"
#include "cromer/report/process.h"
#include "cromer/report/tidy_svg.h"
#include "tests/support/xml.h"

namespace cromer {
namespace {

using testing::HasSubstr;
using testing::Not;

Curve swing(const std::string& role, double rate, double seconds = 8, double step = 0.01) {
  Curve curve;
  curve.role = role;
  for (int i = 0; i * step <= seconds; ++i) {
    const double t = i * step;
    curve.x.push_back(t);
    curve.y.push_back(3 * std::exp(-rate * t) * std::cos(6 * t));
  }
  return curve;
}

Panel three_methods() {
  Panel panel;
  panel.x.name = "time {/:Italic t} (s)";
  panel.y.name = "position {/:Italic x} (cm)";
  panel.curves = {swing("forward-euler", -0.06), swing("exact", 0.12), swing("euler-cromer", 0.12),
                  swing("implicit-euler", 0.3)};
  const char* names[] = {"forward Euler", "exact", "Euler-Cromer", "implicit Euler"};
  const char* remarks[] = {"grows, −0.060 1/s", "", "decays, 0.120 1/s", "too much, 0.299 1/s"};
  for (std::size_t i = 0; i < 4; ++i) panel.curves[i].name = names[i], panel.curves[i].remark = remarks[i];
  return panel;
}

Panel phase_portrait() {
  Panel panel;
  panel.phase_portrait = true;
  panel.x.name = "position (cm)";
  panel.y.name = "velocity (cm/s)";
  for (const auto& [role, rate, name] :
       {std::tuple{"forward-euler", -0.06, "forward Euler"}, {"euler-cromer", 0.12, "Euler-Cromer"}}) {
    Curve curve;
    curve.role = role, curve.name = name;
    for (int i = 0; i < 800; ++i) {
      curve.x.push_back(3 * std::exp(-rate * 0.01 * i) * std::cos(0.06 * i));
      curve.y.push_back(-18 * std::exp(-rate * 0.01 * i) * std::sin(0.06 * i));
    }
    panel.curves.push_back(curve);
  }
  panel.notes.push_back({"start", 3, 0, 0.9, 0.5, false, true, true});
  return panel;
}

Panel dense(Mark mark) {
  Panel panel;
  Curve curve = swing("measured", 0.01, 120);
  for (double& x : curve.y) x *= std::cos(0.001);
  curve.mark = mark;
  curve.name = "measured";
  panel.curves = {curve};
  return panel;
}

Figure of(std::vector<Panel> panels, FigureSize size = FigureSize::single) {
  Figure figure;
  figure.id = "figure-1";
  figure.title = "What is seen: {/:Italic x} & more";
  figure.size = size;
  figure.panels = std::move(panels);
  return figure;
}

std::vector<Figure> examples() {
  Panel log = three_methods();
  for (Curve& curve : log.curves) {
    for (double& x : curve.y) x = 1 + x * x;
  }
  log.y.logarithmic = true;
  log.markers.push_back({4, "end of part 1", "drive"});
  Figure grid = of({three_methods(), phase_portrait(), log}, FigureSize::wide);
  grid.columns = 2;
  grid.panels[0].span = 2;
  grid.panels[0].title = "Three methods";
  Figure shared = of({three_methods(), three_methods()});
  shared.shared_x = true;
  return {of({three_methods()}),
          of({three_methods()}, FigureSize::half),
          of({phase_portrait()}, FigureSize::phase),
          of({dense(Mark::dots)}),
          of({dense(Mark::band)}, FigureSize::half),
          of({log}),
          grid,
          shared,
          of({}),
          of({Panel{}})};
}

std::vector<PlacedText> texts_of(const Layout& layout) {
  std::vector<PlacedText> texts;
  for (const PlacedPanel& panel : layout.panels)
    texts.insert(texts.end(), panel.texts.begin(), panel.texts.end());
  return texts;
}

TEST(FigureLayout, NoTwoWordsOverlapAndNoneIsClipped) {
  for (const Typeface typeface : {Typeface::lato, Typeface::dejavu_sans}) {
    for (const Figure& figure : examples()) {
      const Layout layout = lay_out(figure, typeface);
      const auto texts = texts_of(layout);
      for (std::size_t i = 0; i < texts.size(); ++i) {
        const Box& a = texts[i].box;
        EXPECT_GE(a.x, -0.5) << texts[i].text;
        EXPECT_LE(a.right(), layout.width + 0.5) << texts[i].text;
        EXPECT_GE(a.y, -0.5) << texts[i].text;
        EXPECT_LE(a.bottom(), layout.height + 0.5) << texts[i].text;
        for (std::size_t j = 0; j < i; ++j) {
          Box b = texts[j].box;  // lines of one block touch
          b.y += 0.5, b.height -= 1;
          EXPECT_FALSE(a.overlaps(b)) << texts[i].text << " / " << texts[j].text;
        }
      }
    }
  }
}

TEST(FigureLayout, NamesAtTheRightStandInTheOrderOfTheCurves) {
  const auto texts = texts_of(lay_out(of({three_methods()}), Typeface::lato));
  const auto height = [&](const std::string& word) {
    for (const PlacedText& text : texts) {
      if (text.text == word) return text.at.y;
    }
    ADD_FAILURE() << word;
    return 0.0;
  };
  EXPECT_LT(height("forward Euler"), height("exact"));
  EXPECT_LT(height("exact"), height("Euler-Cromer"));
  EXPECT_LT(height("Euler-Cromer"), height("implicit Euler"));
  EXPECT_GE(height("Euler-Cromer") - height("exact"), 14);
}

TEST(FigureLayout, TheExactRoadLiesLowest) {
  const Layout layout = lay_out(of({three_methods()}), Typeface::lato);
  EXPECT_EQ(layout.panels[0].curves[0].colour, "#8A93A0");
  EXPECT_DOUBLE_EQ(layout.panels[0].curves[0].width, 4.5);
  EXPECT_NEAR(layout.panels[0].curves[1].width, 1.3, 1e-12);
}

TEST(FigureLayout, APhasePortraitIsSquare) {
  const Box frame = lay_out(of({phase_portrait()}, FigureSize::phase), Typeface::lato).panels[0].frame;
  EXPECT_DOUBLE_EQ(frame.width, frame.height);
}

TEST(FigureLayout, DenseDotsBecomeABandAndFewStayDots) {
  EXPECT_EQ(lay_out(of({dense(Mark::dots)}), Typeface::lato).panels[0].curves[0].mark, Mark::band);
  Panel few = dense(Mark::dots);
  few.curves[0].x.resize(300);
  few.curves[0].y.resize(300);
  EXPECT_EQ(lay_out(of({few}), Typeface::lato).panels[0].curves[0].mark, Mark::dots);
  few.curves[0].mark = Mark::band;
  EXPECT_EQ(lay_out(of({few}), Typeface::lato).panels[0].curves[0].mark, Mark::line);
}

TEST(FigureLayout, CrossesStayInTheFrameAndSetNoAxis) {
  Panel panel = three_methods();
  const PlacedPanel without = lay_out(of({panel}), Typeface::lato).panels[0];
  Curve aside;
  aside.role = "set-aside";
  aside.x = {1, 2, 3};
  aside.y = {50, 0, -1e6};
  aside.mark = Mark::crosses;
  aside.sets_axes = false;
  panel.curves.push_back(aside);
  const PlacedPanel placed = lay_out(of({panel}), Typeface::lato).panels[0];
  ASSERT_EQ(placed.y_ticks.size(), without.y_ticks.size());
  const PlacedCurve& crosses = placed.curves.back();
  ASSERT_EQ(crosses.pieces.size(), 6u);  // two strokes each
  for (const auto& stroke : crosses.pieces)
    for (const Spot& p : stroke) {
      EXPECT_GT(p.y, placed.frame.y);
      EXPECT_LT(p.y, placed.frame.bottom());
    }
}

TEST(FigureLayout, ABandIsBrokenWhereNothingWasMeasured) {
  Panel panel = dense(Mark::dots);
  Curve& curve = panel.curves[0];
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (curve.x[i] > 40 && curve.x[i] < 60) curve.y[i] = std::nan("");
  const PlacedPanel placed = lay_out(of({panel}), Typeface::lato).panels[0];
  const Band& band = placed.curves[0].band;
  ASSERT_EQ(placed.curves[0].mark, Mark::band);
  EXPECT_EQ(std::count_if(band.x.begin(), band.x.end(), [](double x) { return std::isnan(x); }), 1);
  const double from = placed.frame.x + placed.frame.width * 41 / 120,
               to = placed.frame.x + placed.frame.width * 59 / 120;
  for (const double x : band.x) EXPECT_FALSE(x > from && x < to) << x;
}

TEST(FigureLayout, LettersGoOnAfterZAndTheNoteStandsBelow) {
  Figure figure = of(std::vector<Panel>(28, three_methods()));
  figure.columns = 4;
  const double height = lay_out(figure, Typeface::lato).height;
  figure.note = "The first 28 of 40";
  const Layout layout = lay_out(figure, Typeface::lato);
  EXPECT_GT(layout.height, height);
  std::vector<std::string> words;
  for (const PlacedText& text : texts_of(layout)) words.push_back(text.text);
  EXPECT_THAT(words, testing::IsSupersetOf({"a", "z", "aa", "ab", "The first 28 of 40"}));
  EXPECT_GT(layout.panels.back().texts.back().at.y, height);
}

TEST(FigureLayout, TicksAreFewAndTheAxisReachesTheLast) {
  for (const Figure& figure : examples()) {
    for (const PlacedPanel& panel : lay_out(figure, Typeface::dejavu_sans).panels) {
      EXPECT_LE(std::count_if(panel.y_ticks.begin(), panel.y_ticks.end(),
                              [](const PlacedTick& t) { return !t.minor; }),
                6);
      EXPECT_GE(panel.x_ticks.size(), 2u);
    }
  }
  const PlacedPanel panel = lay_out(of({dense(Mark::band)}), Typeface::lato).panels[0];
  EXPECT_NEAR(panel.x_ticks.back().at, panel.frame.right(), 1e-6);  // 120 s
}

TEST(FigureScript, IsPureAndRunsNothing) {
  Figure figure = of({three_methods()});
  figure.panels[0].curves[0].name = "it's `touch /tmp/never` \n system('x') $(x)";
  const std::string script = gnuplot_script(figure, FigureFormat::svg);
  EXPECT_EQ(script, gnuplot_script(figure, FigureFormat::svg));
  EXPECT_THAT(script, HasSubstr("set encoding utf8"));
  EXPECT_THAT(script, HasSubstr("set minussign"));
  EXPECT_THAT(script, HasSubstr("$curve_1_1 << EOD"));
  EXPECT_THAT(script, HasSubstr("it’s"));
  EXPECT_THAT(script, Not(HasSubstr("`")));
  for (std::size_t start = 0; start < script.size();) {
    const std::size_t end = script.find('\n', start);
    const std::string line = script.substr(start, end - start);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\'') % 2, 0) << line;
    start = end + 1;
  }
}

TEST(FigureScript, AStepBeyondTheAxisLeavesItWithoutTicks) {
  Figure figure = of({three_methods()});
  figure.panels[0].y.low = 0.01;
  figure.panels[0].y.high = 3;
  figure.panels[0].y.step = 99;
  EXPECT_THAT(gnuplot_script(figure, FigureFormat::svg), HasSubstr("unset ytics"));
}

TEST(FigureScript, SaysSizeAndFontOfEachFormat) {
  const Figure figure = of({three_methods()});
  EXPECT_THAT(gnuplot_script(figure, FigureFormat::svg),
              HasSubstr("svg size 760,440 enhanced font 'sans-serif,13'"));
  EXPECT_THAT(gnuplot_script(figure, FigureFormat::png),
              HasSubstr("pngcairo size 1520,880 enhanced font 'Lato,13'"));
  EXPECT_THAT(gnuplot_script(figure, FigureFormat::png, Typeface::dejavu_sans),
              HasSubstr("font 'DejaVu Sans,"));
  EXPECT_THAT(gnuplot_script(figure, FigureFormat::pdf), HasSubstr("pdfcairo"));
}

TEST(FigureFormat, IsTheEndingOfTheName) {
  EXPECT_EQ(*figure_format("a.b/plot.svg"), FigureFormat::svg);
  EXPECT_EQ(*figure_format("PLOT.PNG"), FigureFormat::png);
  EXPECT_EQ(*figure_format("x.pdf"), FigureFormat::pdf);
  EXPECT_FALSE(figure_format("x.jpg").ok());
  EXPECT_FALSE(figure_format(".svg").ok());
  EXPECT_THAT(figure_format("x.jpg").error().message, HasSubstr(".svg, .png or .pdf"));
}

bool have_gnuplot() {
  const auto version = run_process({"gnuplot", "--version"}, "");
  return version.ok() && version->exit_status == 0;
}

TEST(Draw, DrawsEveryExampleInAllThreeFormats) {
  if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  for (const Figure& figure : examples()) {
    const auto svg = draw(figure, FigureFormat::svg);
    ASSERT_TRUE(svg.ok()) << svg.error().message;
    EXPECT_EQ(test::xml_fault(*svg), "");
    EXPECT_LT(svg->size(), 150000u);
    EXPECT_THAT(*svg, HasSubstr("role=\"img\""));
    EXPECT_THAT(*svg, HasSubstr("aria-label=\"What is seen: x &amp; more\""));
    EXPECT_THAT(*svg, HasSubstr("viewBox=\"0 0 "));
    EXPECT_THAT(*svg, Not(HasSubstr(" id=")));
    EXPECT_THAT(*svg, Not(HasSubstr("currentColor")));
    for (const Panel& panel : figure.panels) {
      for (const Curve& curve : panel.curves) EXPECT_THAT(*svg, HasSubstr(curve.name));
    }
  }
  const auto png = draw(examples()[6], FigureFormat::png);
  ASSERT_TRUE(png.ok()) << png.error().message;
  EXPECT_EQ(png->substr(1, 3), "PNG");
  const auto pdf = draw(examples()[0], FigureFormat::pdf);
  ASSERT_TRUE(pdf.ok()) << pdf.error().message;
  EXPECT_EQ(pdf->substr(0, 5), "%PDF-");
  EXPECT_THAT(*pdf, HasSubstr("/MediaBox [ 0 0 570 3"));  // 760 px of 3/4 pt
}

TEST(Draw, IsWellFormedWhateverTheNames) {
  if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  for (const std::string name :
       {"a]]>b", "x<y>z & \"q\"", "\x1b[31mred\a", "broken \xff\xc3", "\xEF\xBF\xBE"}) {
    Figure figure = of({three_methods()});
    figure.title = name;
    for (std::string* text :
         {&figure.panels[0].curves[0].name, &figure.panels[0].x.name, &figure.panels[0].title})
      *text = name;
    const auto svg = draw(figure, FigureFormat::svg);
    ASSERT_TRUE(svg.ok()) << svg.error().message;
    EXPECT_EQ(test::xml_fault(*svg), "") << name;
  }
}

TEST(Draw, RunsNoCommandHiddenInAName) {
  if (!have_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  const auto trace = std::filesystem::temp_directory_path() / ("cromer-trace-" + std::to_string(std::rand()));
  Figure figure = of({three_methods()});
  for (std::string* text :
       {&figure.panels[0].curves[0].name, &figure.panels[0].x.name, &figure.panels[0].title}) {
    *text =
        "'`touch " + trace.string() + "`\nsystem('touch " + trace.string() + "')\n!touch " + trace.string();
  }
  const auto drawn = draw(figure, FigureFormat::svg);
  EXPECT_TRUE(drawn.ok()) << drawn.error().message;
  EXPECT_FALSE(std::filesystem::exists(trace));
}

TEST(Draw, WithoutGnuplotSaysWhatToInstall) {
  const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
  ::setenv("PATH", "/nonexistent", 1);
  const auto drawn = draw(of({three_methods()}), FigureFormat::svg);
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(drawn.ok());
  EXPECT_THAT(drawn.error().message, HasSubstr("gnuplot-nox"));
}

TEST(Process, CarriesMuchInBothDirectionsAndTheExitStatus) {
  const std::string much(3000000, 'x');
  const auto echoed = run_process({"cat"}, much);
  ASSERT_TRUE(echoed.ok());
  EXPECT_EQ(echoed->out, much);
  const auto deaf = run_process({"true"}, much);  // reads nothing: no broken pipe
  ASSERT_TRUE(deaf.ok());
  EXPECT_EQ(deaf->exit_status, 0);
  EXPECT_EQ(run_process({"false"}, "")->exit_status, 1);
  EXPECT_FALSE(run_process({"/no/such/program"}, "").ok());
}

TEST(TidySvg, FlattensWhatGnuplotWrites) {
  const std::string svg = tidy_svg(
      "<svg viewBox=\"0 0 10 20\"><title>t</title><defs><circle id='gpPt6'/></defs>"
      "<g fill=\"none\" color=\"black\" stroke=\"currentColor\" stroke-width=\"1.30\">\n<path stroke='rgb(  "
      "0, 114, 178)'  d='M1.00,2.50 L3.25,4.00 '/></g>"
      "<g color=\"red\" stroke=\"currentColor\"><use xlink:href='#gpPt6' transform='translate(1.00,2.00) "
      "scale(1.2)' color='rgb( 23,  28,  36)'/>"
      "<use xlink:href='#gpPt6' transform='translate(3.00,4.00) scale(1.2)' color='rgb( 23,  28,  36)'/></g>"
      "<g transform=\"translate(5.00,6.00)\" stroke=\"none\" fill=\"rgb(74,83,97)\" font-size=\"12.00\" "
      "text-anchor=\"end\">"
      "<text><tspan font-family=\"sans-serif\" >a &lt; </tspan><tspan font-family=\"sans-serif\" "
      "font-style=\"italic\" >x</tspan></text></g></svg>",
      "Two <things>");
  EXPECT_THAT(svg, HasSubstr("<path stroke=\"#0072B2\" stroke-width=\"1.3\" d=\"M1 2.5 3.25 4\"/>"));
  EXPECT_THAT(
      svg,
      HasSubstr(
          "<path stroke=\"#171C24\" stroke-width=\"2.6\" stroke-linecap=\"round\" d=\"M1 2h0M3 4h0\"/>"));
  EXPECT_THAT(svg, HasSubstr(">a &lt; <tspan font-style=\"italic\">x</tspan></text>"));
  EXPECT_THAT(svg, HasSubstr("aria-label=\"Two &lt;things&gt;\""));
  EXPECT_THAT(svg, Not(HasSubstr("title")));
  EXPECT_THAT(svg, Not(HasSubstr("gpPt6")));
  EXPECT_THAT(tidy_svg("", ""), HasSubstr("<svg"));
  EXPECT_THAT(tidy_svg("<svg><path d='", ""), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace cromer
