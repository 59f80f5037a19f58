// A report on sheets of paper: A4, as one PDF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/report/page.h"
#include "cromer/report/strip.h"

namespace cromer::core {

/// A4 [px].
inline constexpr double sheet_width = 210 * 96 / 25.4, sheet_height = 297 * 96 / 25.4;
inline constexpr double side_margin = 20 * 96 / 25.4, upper_margin = 18 * 96 / 25.4;

/// From the sheet's upper left corner.
using Sheet = std::vector<Printed>;

/// The page on sheets. No heading stands alone at the foot of a sheet; a table goes on over several sheets
/// and repeats its header; a figure is never cut and keeps its proportions.
std::vector<Sheet> sheets_of(const Page& page, Typeface typeface);

std::string to_svg(const Sheet& sheet, Typeface typeface, std::string_view language);

/// One PDF of all sheets, its texts selectable, in the light colours. An Error says what to install.
Result<std::string> to_pdf(const Page& page);

}  // namespace cromer::core
