// Where axes, frames, titles and notes stand in a figure.
#include "cromer/report/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/report/axis.h"
#include "cromer/report/heat_map.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace CROMER_FILE {

Panel line(std::vector<double> x, std::vector<double> y) {
  Panel panel;
  panel.x.name = "time t (s)";
  panel.y.name = "position x (cm)";
  panel.curves.emplace_back().x = std::move(x);
  panel.curves.back().y = std::move(y);
  return panel;
}

Figure of(std::vector<Panel> panels, int columns = 1, FigureSize size = FigureSize::single) {
  Figure figure;
  figure.panels = std::move(panels);
  figure.columns = columns;
  figure.size = size;
  return figure;
}

PlacedPanel sole(const Panel& panel, FigureSize size = FigureSize::single) {
  return lay_out(of({panel}, 1, size), Typeface::lato).panels[0];
}

const PlacedText* find(const PlacedPanel& panel, const std::string& words) {
  const auto found = std::find_if(panel.texts.begin(), panel.texts.end(),
                                  [&](const PlacedText& text) { return text.text == words; });
  if (found == panel.texts.end()) ADD_FAILURE() << "no \"" << words << "\"";
  static const PlacedText none;
  return found == panel.texts.end() ? &none : &*found;
}

double middle_y(const Box& box) { return box.y + box.height / 2; }
double middle_x(const Box& box) { return box.x + box.width / 2; }

TEST(Axes, EveryTickStandsAtItsValueWithItsNumberBeside) {
  const PlacedPanel panel = sole(line({0, 10}, {-0.9, 0.9}));
  const Box& f = panel.frame;
  for (const auto& [label, value] : {std::pair{"0", 0.0}, {"2", 2.0}, {"8", 8.0}, {"10", 10.0}}) {
    const auto number =
        std::find_if(panel.texts.begin(), panel.texts.end(), [&, label = label](const PlacedText& text) {
          return text.text == label && text.align == Align::centre && text.at.y > f.bottom();
        });
    ASSERT_NE(number, panel.texts.end()) << label;
    EXPECT_NEAR(number->at.x, f.x + f.width * value / 10, 1e-9);
    EXPECT_NEAR(middle_x(number->box), number->at.x, 1e-9);
    EXPECT_NEAR(middle_y(number->box), number->at.y, 1e-9);
    EXPECT_GT(number->box.y,
              f.bottom() + 4);  // half a character's height of 8 px: the tick's mark is in between
    EXPECT_DOUBLE_EQ(number->size, 11.5);
    EXPECT_EQ(number->colour, "#4A5361");
  }
  for (const auto& [label, value] : {std::pair{"−1", -1.0}, {"1", 1.0}}) {
    const auto number = std::find_if(panel.texts.begin(), panel.texts.end(),
                                     [&, l = label](const PlacedText& text) { return text.text == l; });
    ASSERT_NE(number, panel.texts.end()) << label;
    EXPECT_NEAR(number->at.y, f.y + f.height * (1 - value) / 2, 1e-9);
    EXPECT_EQ(number->align, Align::right);
    EXPECT_NEAR(number->box.right(), f.x - 8, 1e-9);
  }
  ASSERT_EQ(panel.x_ticks.size(), 6u);
  EXPECT_NEAR(panel.x_ticks[1].at, f.x + f.width / 5, 1e-9);
  EXPECT_FALSE(panel.x_ticks[1].minor);
  ASSERT_EQ(panel.y_ticks.size(), 5u);
  EXPECT_NEAR(panel.y_ticks[0].at, f.bottom(), 1e-9);
  EXPECT_NEAR(panel.y_ticks[4].at, f.y, 1e-9);
}

TEST(Axes, NamesStandAtTheirEnds) {
  const PlacedPanel plain = sole(line({0, 10}, {-0.9, 0.9}));
  const PlacedText &x = *find(plain, "time t (s)"), &y = *find(plain, "position x (cm)");
  EXPECT_EQ(x.align, Align::right);
  EXPECT_NEAR(x.box.right(), plain.frame.right(), 1e-9);
  EXPECT_GE(x.box.y, find(plain, "2")->box.bottom());
  EXPECT_LE(x.box.bottom(), 440);
  EXPECT_EQ(y.align, Align::left);
  EXPECT_LE(y.box.bottom(), plain.frame.y);
  EXPECT_GE(y.box.y, 0);
  EXPECT_NEAR(y.box.x, 6, 1e-9);
  EXPECT_FALSE(y.rotated);
  EXPECT_DOUBLE_EQ(x.size, 12);
  EXPECT_DOUBLE_EQ(y.size, 12);
  Panel titled = line({0, 10}, {-0.9, 0.9});
  titled.title = "Damped";
  const PlacedPanel under = sole(titled);
  const PlacedText &cx = *find(under, "time t (s)"), &cy = *find(under, "position x (cm)");
  EXPECT_EQ(cx.align, Align::centre);
  EXPECT_NEAR(cx.at.x, middle_x(under.frame), 1e-9);
  EXPECT_TRUE(cy.rotated);
  EXPECT_NEAR(cy.at.y, middle_y(under.frame), 1e-9);
  EXPECT_NEAR(middle_x(cy.box), cy.at.x, 1e-9);
  EXPECT_NEAR(middle_y(cy.box), cy.at.y, 1e-9);
  EXPECT_GT(cy.box.height, cy.box.width);
  EXPECT_LE(cy.box.right(), find(under, "−1")->box.x);
  EXPECT_GE(cy.box.x, 0);
  const PlacedText& title = *find(under, "Damped");
  EXPECT_EQ(title.align, Align::left);
  EXPECT_NEAR(title.box.x, 6, 1e-9);
  EXPECT_LE(title.box.bottom(), under.frame.y);
  EXPECT_GE(title.box.y, 0);
  EXPECT_DOUBLE_EQ(title.size, 13);
  EXPECT_EQ(title.colour, light_surface.ink);
}

TEST(Axes, ATitleTooLongIsSetSmallerButNotBelowARemark) {
  Panel panel = line({0, 1}, {0, 1});
  const double one = text_width("wwwwwwwwww", 13, false, Typeface::lato);
  for (const int count : {7, 8, 40}) {
    panel.title = "";
    for (int i = 0; i < count; ++i) panel.title += "wwwwwwwwww";
    const PlacedText title = *find(sole(panel), panel.title);
    const double room = 760 - 6 - 6;
    EXPECT_NEAR(title.size, count * one <= room ? 13 : std::max(11.0, 13 * room / (count * one)), 1e-9)
        << count;
  }
  EXPECT_LT(7 * one, 748);
}

TEST(Axes, TheFrameLeavesRoomForItsWords) {
  const double number = text_width("−0.5", 11.5, false, Typeface::lato);
  Panel panel = line({0, 10}, {-0.9, 0.9});
  Box f = sole(panel).frame;  // the edge, numbers, ticks; axis names above and below
  EXPECT_NEAR(f.x, 6 + number + 8, 1e-9);
  EXPECT_NEAR(f.y, 12 + 16, 1e-9);
  EXPECT_NEAR(f.right(), 760 - 18, 1e-9);
  EXPECT_NEAR(f.bottom(), 440 - (8 + 11.5 + 6 + 12 + 6), 1e-9);
  panel.y.name = panel.x.name = "";
  f = sole(panel).frame;
  EXPECT_NEAR(f.y, 12, 1e-9);
  EXPECT_NEAR(f.bottom(), 440 - (8 + 11.5 + 6), 1e-9);
  panel.title = "Damped";
  f = sole(panel).frame;
  EXPECT_NEAR(f.x, 6 + number + 8, 1e-9);
  EXPECT_NEAR(f.y, 13 + 17, 1e-9);
  panel.y.name = "x";
  EXPECT_NEAR(sole(panel).frame.x, 6 + number + 8 + 12 + 8, 1e-9);
}

TEST(Axes, NamesTakeAFourteenthOfAHundredOrWhatTheyNeed) {
  Panel panel = line({0, 10}, {0, 1});
  panel.curves[0].name = "x";
  EXPECT_NEAR(sole(panel).frame.right(), 0.86 * 760, 1e-9);
  panel.curves[0].name = "a_name_that_is_longer_than_it";
  const double width = text_width(panel.curves[0].name, 12, true, Typeface::lato);
  ASSERT_GT(width, 0.14 * 760);
  EXPECT_NEAR(sole(panel).frame.right(), 760 - width - 8 - 4, 1e-9);
  panel.curves[0].name = std::string(200, 'w');
  EXPECT_NEAR(sole(panel).frame.right(), 380, 1e-9);
  // Words break where they would take more than three tenths.
  panel.curves[0].name = "";
  for (int i = 0; i < 20; ++i) panel.curves[0].name += "word word ";
  EXPECT_GT(sole(panel).frame.right(), 0.7 * 760 - 12 - 1e-9);
  EXPECT_LT(sole(panel).frame.right(), 0.7 * 760 + 30);
}

TEST(ZeroLine, IsThereWhereZeroIsInsideTheFrame) {
  const PlacedPanel through = sole(line({-10, 10}, {-0.9, 0.9}));
  ASSERT_EQ(through.zero_lines.size(), 1u);
  const PlacedLine& zero = through.zero_lines[0];
  EXPECT_NEAR(zero.from.y, middle_y(through.frame), 1e-9);
  EXPECT_EQ(zero.from.y, zero.to.y);
  EXPECT_EQ(zero.from.x, through.frame.x);
  EXPECT_EQ(zero.to.x, through.frame.right());
  EXPECT_EQ(zero.colour, light_surface.zero_line);
  EXPECT_TRUE(sole(line({-10, 10}, {0, 0.9})).zero_lines.empty());
  EXPECT_TRUE(sole(line({-10, 10}, {-0.9, 0})).zero_lines.empty());
  EXPECT_TRUE(sole(line({-10, 10}, {5, 6})).zero_lines.empty());
  Panel phase = line({-10, 10}, {-0.9, 0.9});
  phase.phase_portrait = true;
  const PlacedPanel portrait = sole(phase, FigureSize::phase);
  ASSERT_EQ(portrait.zero_lines.size(), 2u);
  const PlacedLine& upright = portrait.zero_lines[1];
  EXPECT_NEAR(upright.from.x, middle_x(portrait.frame), 1e-9);
  EXPECT_EQ(upright.from.x, upright.to.x);
  EXPECT_EQ(upright.from.y, portrait.frame.y);
  EXPECT_EQ(upright.to.y, portrait.frame.bottom());
  phase.curves[0].x = {5, 6};
  EXPECT_EQ(sole(phase, FigureSize::phase).zero_lines.size(), 1u);
}

TEST(PhasePortrait, IsSquareAloneAndWiderBesideOthers) {
  Panel phase = line({-10, 10}, {-1, 1});
  phase.phase_portrait = true;
  const Panel plain = line({0, 10}, {0, 1});
  const Layout mixed = lay_out(of({plain, phase, plain, plain}, 2, FigureSize::wide), Typeface::lato);
  const Box &other = mixed.panels[0].frame, &f = mixed.panels[1].frame;
  EXPECT_NEAR(f.width, 1.35 * f.height, 1e-9);
  EXPECT_LT(other.right(), f.x);
  EXPECT_LE(f.right(), 1100);
  EXPECT_GT(f.right(), 1100 - 20);
  EXPECT_GT(other.width, 1.5 * f.width);  // it takes what the portrait leaves
  EXPECT_EQ(other.y, f.y);
  EXPECT_NEAR(other.bottom(), f.bottom(), 1e-9);
  // Its orbit stays round.
  const auto& piece = mixed.panels[1].curves[0].pieces[0];
  EXPECT_NEAR(std::abs(piece.front().x - piece.back().x), f.height / 1.1, 1e-6);
  EXPECT_NEAR(std::abs(piece.front().y - piece.back().y), f.height / 1.1, 1e-6);
  phase.x.low = -20, phase.x.high = 20;
  const Layout asked = lay_out(of({plain, phase}, 2, FigureSize::wide), Typeface::lato);
  const auto& narrow = asked.panels[1].curves[0].pieces[0];
  EXPECT_NEAR(std::abs(narrow.front().x - narrow.back().x), asked.panels[1].frame.width / 2, 1e-6);
}

TEST(Layers, AreBandRoadFitTheRestAndDots) {
  Panel panel;
  for (const char* role : {"constant-rate", "measured", "fitted", "exact", "verlet", "euler-cromer"}) {
    Curve& curve = panel.curves.emplace_back();
    curve.role = role;
    curve.x = {0, 1, 2};
    curve.y = {0, 1, 0};
  }
  panel.curves[1].mark = Mark::dots;
  panel.curves[2].road = true;  // a narrower road
  Curve& dense = panel.curves.emplace_back();
  dense.role = "drive";
  dense.mark = Mark::band;
  for (int i = 0; i < 20000; ++i) dense.x.push_back(i * 1e-4), dense.y.push_back(std::sin(2.0 * i));
  std::vector<std::string> colours;
  for (const PlacedCurve& curve : sole(panel).curves) colours.push_back(curve.colour);
  EXPECT_THAT(colours,
              testing::ElementsAre(style_of("drive").line, style_of("exact").line, style_of("fitted").line,
                                   style_of("verlet").line, style_of("euler-cromer").line,
                                   style_of("constant-rate").line, style_of("measured").line));
}

TEST(Rows, OfEqualPanelsShareTheirEdges) {
  Panel wide = line({0, 10}, {-90000, 90000});
  const Layout layout = lay_out(of({line({0, 10}, {0, 1}), wide}), Typeface::lato);
  const Box &above = layout.panels[0].frame, &below = layout.panels[1].frame;
  EXPECT_DOUBLE_EQ(above.x, below.x);
  EXPECT_DOUBLE_EQ(above.right(), below.right());
  EXPECT_DOUBLE_EQ(below.y - above.y, 310);
  EXPECT_DOUBLE_EQ(below.height, above.height);
  EXPECT_DOUBLE_EQ(layout.height, 620);
  EXPECT_LT(find(layout.panels[0], "time t (s)")->box.bottom(), 310);
  EXPECT_NEAR(find(layout.panels[0], "a")->at.y, find(layout.panels[1], "b")->at.y - 310, 1e-9);
  EXPECT_TRUE(find(layout.panels[0], "a")->bold);
}

TEST(Rows, ThatShareTheirAxisWriteItOnce) {
  Figure figure = of({line({0, 10}, {0, 1}), line({0, 10}, {0, 1}), line({0, 10}, {0, 1})});
  figure.shared_x = true;
  const Layout layout = lay_out(figure, Typeface::lato);
  for (std::size_t i = 0; i < 3; ++i) {
    const PlacedPanel& panel = layout.panels[i];
    const auto below = std::count_if(panel.texts.begin(), panel.texts.end(), [&](const PlacedText& text) {
      return text.at.y > panel.frame.bottom() + 5;
    });
    EXPECT_EQ(below, i < 2 ? 0 : 7) << i;
    EXPECT_EQ(panel.x_ticks.size(), 6u);
    EXPECT_GT(panel.frame.height, 200);
  }
  EXPECT_LT(layout.height, 3 * 310 - 50);
  EXPECT_NEAR(layout.panels[1].frame.y - layout.panels[0].frame.y, 310 - 12 - 11.5 - 8, 1e-9);
  EXPECT_NEAR(layout.panels[1].frame.height, layout.panels[0].frame.height, 1e-9);
  Figure one = of({line({0, 10}, {0, 1})});
  one.shared_x = true;
  EXPECT_DOUBLE_EQ(lay_out(one, Typeface::lato).height, 440);
}

TEST(Rows, AboveAndBelowAPortraitWriteTheirAxis) {
  Panel phase = line({-10, 10}, {-1, 1});
  phase.phase_portrait = true;
  Figure figure =
      of({line({0, 10}, {0, 1}), line({0, 10}, {0, 1}), phase, line({0, 10}, {0, 1})}, 1, FigureSize::wide);
  figure.shared_x = true;
  const Layout layout = lay_out(figure, Typeface::lato);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    const PlacedPanel& panel = layout.panels[i];
    const bool numbers = std::any_of(panel.texts.begin(), panel.texts.end(), [&](const PlacedText& text) {
      return text.at.y > panel.frame.bottom() + 5;
    });
    EXPECT_EQ(numbers, i > 0) << i;
  }
  const Box& portrait = layout.panels[2].frame;
  EXPECT_NEAR(portrait.width, portrait.height, 1e-9);
  EXPECT_GT(portrait.height, 1.4 * layout.panels[1].frame.height);
  EXPECT_GT(layout.panels[3].frame.y, portrait.bottom());
}

TEST(Columns, PanelsStandBesideEachOtherAsWideAsTheySpan) {
  Panel two = line({0, 10}, {0, 1});
  two.span = 2;
  const Layout layout =
      lay_out(of({two, line({0, 10}, {0, 1}), line({0, 10}, {0, 1})}, 3, FigureSize::wide), Typeface::lato);
  const Box &a = layout.panels[0].frame, &b = layout.panels[1].frame, &c = layout.panels[2].frame;
  const double column = 1100.0 / 3;
  EXPECT_LT(a.right(), 2 * column);
  EXPECT_GT(a.right(), 1.8 * column);
  EXPECT_GT(b.x, 2 * column);
  EXPECT_LT(b.right(), 1100);
  EXPECT_GT(c.y, b.bottom());
  EXPECT_LT(c.right(), column);
  EXPECT_NEAR(b.width, c.width, 1e-9);
  EXPECT_NEAR(find(layout.panels[2], "c")->size, 13 * 1.15, 1e-9);
  const Layout smaller = lay_out(of({line({0, 10}, {0, 1})}), Typeface::lato, 1);
  EXPECT_NEAR(find(smaller.panels[0], "time t (s)")->size, 11, 1e-9);
}

TEST(FigureKey, ShowsEachLookBesideItsNameBetweenPanelsAndNote) {
  Figure figure = of({line({0, 1}, {0, 1})});
  figure.note = "The first of two.";
  const Layout without = lay_out(figure, Typeface::lato);
  for (const char* role : {"measured", "fitted", "set-aside"}) {
    Curve& curve = figure.key.emplace_back();
    curve.role = curve.name = role;
  }
  figure.key[0].mark = Mark::dots;
  figure.key[2].mark = Mark::crosses;
  const Layout layout = lay_out(figure, Typeface::lato);
  EXPECT_GT(layout.height, without.height + 12);
  EXPECT_EQ(layout.height, std::floor(layout.height));
  const PlacedPanel& panel = layout.panels[0];
  const PlacedText *dots = find(panel, "measured"), *fit = find(panel, "fitted"),
                   *crosses = find(panel, "set-aside");
  EXPECT_GT(dots->at.y, find(panel, "time t (s)")->at.y);
  EXPECT_LT(dots->at.y, find(panel, figure.note)->at.y);
  EXPECT_LT(dots->box.right(), fit->at.x);
  EXPECT_LT(fit->box.right(), crosses->at.x);
  ASSERT_EQ(panel.dots.size(), 1u);
  EXPECT_LT(panel.dots[0].x, dots->at.x);
  ASSERT_EQ(panel.leaders.size(), 3u);  // a line and the two strokes of a cross
  EXPECT_EQ(panel.leaders[0].colour, style_of("fitted").line);
  EXPECT_LT(panel.leaders[0].to.x, fit->at.x);
  EXPECT_LT(panel.leaders[1].to.x, crosses->at.x);
  // Names that do not fit beside each other go on below.
  for (Curve& curve : figure.key) curve.name = std::string(60, 'n');
  EXPECT_GT(lay_out(figure, Typeface::lato).height, layout.height + 12);
}

TEST(FigureNote, StandsAtTheLeftBelowThePanels) {
  Figure figure = of({line({0, 10}, {0, 1})});
  figure.note = "The first of two";
  const Layout layout = lay_out(figure, Typeface::lato);
  const PlacedText& note = *find(layout.panels[0], figure.note);
  EXPECT_DOUBLE_EQ(layout.height, 440 + 22);
  EXPECT_GE(note.box.y, 440);
  EXPECT_LE(note.box.bottom(), layout.height);
  EXPECT_EQ(note.box.x, 6);
  EXPECT_EQ(note.size, 11);
  EXPECT_EQ(note.colour, light_surface.text_2);
}

TEST(HeatMapPanel, TheBarStandsBesideTheMapWithItsNumbers) {
  Panel panel;
  panel.x.name = "x (m)", panel.y.name = "y (m)";
  panel.map = HeatMap{.x = {0, 1, 2}, .y = {-1, 1}, .z = {0, 1, 2, 3, 4, 5}, .name = "amplitude (cm)"};
  const PlacedPanel placed = sole(panel);
  ASSERT_TRUE(placed.map.has_value());
  const Box &f = placed.frame, &bar = placed.map->bar;
  EXPECT_EQ(bar.y, f.y);
  EXPECT_EQ(bar.height, f.height);
  EXPECT_EQ(bar.x, f.right() + 16);
  EXPECT_EQ(bar.width, 14);
  EXPECT_TRUE(placed.zero_lines.empty());
  EXPECT_TRUE(placed.curves.empty());
  ASSERT_EQ(placed.leaders.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(placed.leaders[i].from.y, f.bottom() - f.height * static_cast<double>(i) / 5, 1e-9);
    EXPECT_EQ(placed.leaders[i].from.x, bar.right());
    EXPECT_EQ(placed.leaders[i].to.x, bar.right() + 3);
    EXPECT_EQ(placed.leaders[i].to.y, placed.leaders[i].from.y);
  }
  const PlacedText &five = *find(placed, "5"), &name = *find(placed, "amplitude (cm)");
  EXPECT_NEAR(five.at.y, f.y, 1e-9);
  EXPECT_EQ(five.align, Align::left);
  EXPECT_NEAR(five.box.x, bar.right() + 8, 1e-9);
  EXPECT_TRUE(name.rotated);
  EXPECT_NEAR(name.at.y, middle_y(f), 1e-9);
  EXPECT_NEAR(middle_x(name.box), name.at.x, 1e-9);
  EXPECT_NEAR(middle_y(name.box), name.at.y, 1e-9);
  EXPECT_GT(name.box.height, name.box.width);
  EXPECT_GE(name.box.x, five.box.right());
  EXPECT_NEAR(name.at.x, 760 - 6 - 4, 1e-9);  // half its height and 4 px from the figure's edge
  EXPECT_NEAR(f.right(), 760 - (16 + 14 + 8 + five.box.width + 12 + 14), 1e-9);
  panel.map->decades = true;
  panel.map->z = {0.1, 1, 10, 100, 1000, 1e4};
  const PlacedPanel decades = sole(panel);
  EXPECT_EQ(std::count_if(decades.leaders.begin(), decades.leaders.end(),
                          [](const PlacedLine& mark) { return mark.to.x - mark.from.x < 2; }),
            40);  // eight between each two decades
}

TEST(Ticks, AWideFrameHasMoreAndLongNumbersFewer) {
  Panel panel = line({0, 8}, {0, 1});
  EXPECT_EQ(sole(panel).x_ticks.size(), 5u);                    // seven at most: every second
  EXPECT_EQ(sole(panel, FigureSize::wide).x_ticks.size(), 9u);  // nine
  EXPECT_EQ(sole(panel, FigureSize::half).x_ticks.size(), 5u);
  for (double end = 1e-9; end < 1e9; end *= 1.37) {
    panel.curves[0].x = {0, end};
    const PlacedPanel placed = sole(panel, FigureSize::half);
    EXPECT_GE(placed.x_ticks.size(), 2u) << end;
    double last = -100;
    for (const PlacedText& number : placed.texts) {
      if (number.align != Align::centre || number.at.y < placed.frame.bottom()) continue;
      EXPECT_GT(number.box.x, last + 7) << end;  // half of the 14 px that are reckoned
      last = number.box.right();
    }
  }
  panel.curves[0].x = {0, 8};
  panel.x.step = 1;
  EXPECT_EQ(sole(panel, FigureSize::half).x_ticks.size(), 9u);  // as asked for
}

TEST(Axes, NumbersOfALogarithmicAxisStandAtTheirRatios) {
  Panel panel = line({1, 1000}, {0, 1});
  panel.x.logarithmic = true;
  const PlacedPanel placed = sole(panel);
  ASSERT_EQ(placed.x_ticks.size(), 28u);
  EXPECT_EQ(std::count_if(placed.x_ticks.begin(), placed.x_ticks.end(),
                          [](const PlacedTick& t) { return t.minor; }),
            24);
  EXPECT_NEAR(find(placed, "10")->at.x, placed.frame.x + placed.frame.width / 3, 1e-9);
  EXPECT_NEAR(find(placed, "1000")->at.x, placed.frame.right(), 1e-9);
}

Figure of(FigureSize size, int columns, std::vector<int> spans) {
  Figure figure;
  figure.size = size;
  figure.columns = columns;
  for (const int span : spans) figure.panels.emplace_back().span = span;
  return figure;
}

TEST(FigureGrid, HasItsSizes) {
  const auto size = [](FigureSize s, int rows, int columns = 1) {
    const Canvas canvas = canvas_of(of(s, columns, {1}), rows);
    return std::pair(canvas.width, canvas.row_height);
  };
  EXPECT_EQ(size(FigureSize::single, 1), std::pair(760.0, 440.0));
  EXPECT_EQ(size(FigureSize::wide, 1), std::pair(1100.0, 440.0));
  EXPECT_EQ(size(FigureSize::phase, 1), std::pair(480.0, 440.0));
  EXPECT_EQ(size(FigureSize::phase, 2, 3), std::pair(1440.0, 440.0));
  EXPECT_EQ(size(FigureSize::phase, 1, 0), std::pair(480.0, 440.0));
  EXPECT_EQ(size(FigureSize::half, 1), std::pair(420.0, 300.0));
  EXPECT_EQ(size(FigureSize::tall, 1), std::pair(420.0, 385.0));
  EXPECT_EQ(size(FigureSize::single, 2), std::pair(760.0, 310.0));
  EXPECT_EQ(size(FigureSize::wide, 2), std::pair(1100.0, 310.0));
  EXPECT_EQ(size(FigureSize::half, 2), std::pair(420.0, 230.0));
  EXPECT_EQ(size(FigureSize::tall, 2), std::pair(420.0, 230.0));
  EXPECT_EQ(canvas_of(of(FigureSize::single, 1, {1}), 1).text_scale, 1);
  EXPECT_GT(canvas_of(of(FigureSize::wide, 1, {1}), 1).text_scale, 1.1);
}

TEST(FigureGrid, LettersCountLikeColumnsOfASpreadsheet) {
  EXPECT_EQ(letter_of(0), "a");
  EXPECT_EQ(letter_of(25), "z");
  EXPECT_EQ(letter_of(26), "aa");
  EXPECT_EQ(letter_of(51), "az");
  EXPECT_EQ(letter_of(52), "ba");
  EXPECT_EQ(letter_of(701), "zz");
  EXPECT_EQ(letter_of(702), "aaa");
}

TEST(FigureGrid, ARowEndsWhereTheNextPanelDoesNotFit) {
  using Rows = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(rows_of(of(FigureSize::single, 2, {1, 1, 1})), (Rows{{0, 1}, {2}}));
  EXPECT_EQ(rows_of(of(FigureSize::single, 3, {1, 2, 2, 1})), (Rows{{0, 1}, {2, 3}}));
  EXPECT_EQ(rows_of(of(FigureSize::single, 3, {2, 2, 3})), (Rows{{0}, {1}, {2}}));
  EXPECT_EQ(rows_of(of(FigureSize::single, 2, {9, 0, -3})), (Rows{{0}, {1, 2}}));
  EXPECT_EQ(rows_of(of(FigureSize::single, 0, {1, 1})), (Rows{{0}, {1}}));
  EXPECT_EQ(rows_of(of(FigureSize::single, 2, {})), Rows{});
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
