// A table on paper.
#pragma once

#include <vector>

#include "cromer/report/page.h"
#include "cromer/report/strip.h"

namespace cromer::core {

/// A strip for each row, or for rows that share a cell; the header is repeated on each sheet. Columns are as
/// wide as their cells ask for; where they ask for too much, first words are wrapped, then the font becomes
/// smaller, at last words are broken.
std::vector<Strip> table_strips(const TableBlock& table, Typeface typeface, double width);

}  // namespace cromer::core
