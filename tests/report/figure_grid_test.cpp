#include "cromer/report/figure_grid.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace {

Figure of(FigureSize size, int columns, std::vector<int> spans) {
  Figure figure;
  figure.size = size;
  figure.columns = columns;
  for (const int span : spans) figure.panels.emplace_back().span = span;
  return figure;
}

TEST(FigureGrid, SizesAreThoseOfLookMd) {
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

}  // namespace
}  // namespace cromer::core
