// Names, numbers and tables as a terminal and a report show them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// "decay rate" for decay_rate.
std::string readable_name(std::string_view name);

/// The term of the law that a parameter belongs to, as a formula; "" for others.
std::string_view term_of(const Law& law, std::string_view parameter);

/// "viscous part of the decay rate" of the parameter that is_viscous_part() of the law; "" of others.
std::string viscous_part_in_words(const Law& law, std::string_view parameter,
                                  Language language = Language::english);

/// Value and standard error with the unit. The unit of a plain number is "1" or "".
std::string in_words(const Estimate& estimate, std::string_view unit);

/// "Euler-Cromer" for euler-cromer: the method's name as it is printed.
std::string method_in_words(std::string_view method);

/// "viscous damping, drag": the names of the law's terms.
std::string terms_in_words(const Law& law, Language language);

/// "lab.csv, Position (m), run 1", without a column where none was read.
std::string recording_title(const FittedRecording& fitted);

/// The SI unit of the fitted column, which is that of its equilibrium; "" if nothing was fitted.
std::string fitted_unit(const FittedRecording& fitted);

/// "5.8 %": two digits, whole percents from 100 on; "0 %" below 1e-12.
std::string percent(double part);

/// The same with its sign: "+5.8 %".
std::string percent_off(double part);

/// How many digits the end of an interval is written with: down to the second digit of half its width.
int digits_of_end(double end, double low, double high);

/// "between 19.9991 and 20.0005"; "to rounding" of ends that differ by no more.
std::string interval_text(double low, double high);

/// The files' names without their folders; as they are if that leaves two different files with one name.
std::vector<std::string> short_names(std::span<const std::string> files);

/// Rows that a table on the terminal has at most.
inline constexpr std::size_t most_rows = 24;

/// Rows of cells; the first row is the header. Columns are as wide as their widest cell, in characters.
/// Columns from `numbers_from` up to but not including `numbers_to` are aligned right.
std::string text_table(const std::vector<std::vector<std::string>>& rows, std::size_t numbers_from,
                       std::size_t numbers_to);

}  // namespace cromer::core
