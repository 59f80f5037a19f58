// Names, numbers and tables as a terminal shows them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// "decay rate" for decay_rate.
std::string readable_name(std::string_view name);

/// Value and standard error with the unit; that of a plain number is "1" or "".
std::string in_words(const Estimate& estimate, std::string_view unit);

/// The SI unit of the column that was fitted, as its equilibrium has it; "" where nothing was fitted.
std::string fitted_unit(const FittedRecording& fitted);

/// "5.8 %": two digits, whole percents from 100 on; "0 %" where only rounding is left.
std::string percent(double part);

/// The same with its sign: "+5.8 %".
std::string percent_off(double part);

/// "between 19.99912 and 20.00054", with so many digits that the interval's width has three.
std::string interval_text(double low, double high);

/// Rows of cells under a header, columns as wide as their widest cell (in characters, not bytes); the columns
/// from `numbers_from` to `numbers_to` (exclusive) are flushed right.
std::string text_table(const std::vector<std::vector<std::string>>& rows, std::size_t numbers_from,
                       std::size_t numbers_to);

}  // namespace cromer::core
