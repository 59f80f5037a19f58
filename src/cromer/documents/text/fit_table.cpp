#include "cromer/documents/text/fit_table.h"
#include "cromer/documents/words/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cromer/base/quantity.h"
#include "cromer/documents/text/text_table.h"
#include "cromer/documents/text/words.h"
#include "cromer/read/column_kind.h"

namespace cromer::core {
namespace {

constexpr std::string_view shown[] = {"frequency", "decay_rate",      "drag", "friction", "cubic",
                                      "stiffness", "drag_coefficient"};

const Parameter* find(const FittedRecording& fitted, std::string_view name) {
  for (const auto* list : {&fitted.parameters, &fitted.derived})
    for (const auto& number : *list)
      if (number.name == name && std::isfinite(number.estimate.value)) return &number;
  return nullptr;
}

/// The quantities that one of the recordings has.
std::vector<std::string_view> columns_of(const std::vector<FittedRecording>& fits) {
  std::vector<std::string_view> names;
  for (const std::string_view name : shown)
    if (std::any_of(fits.begin(), fits.end(), [&](const auto& fitted) { return find(fitted, name); }))
      names.push_back(name);
  return names;
}

std::string_view without_folder(std::string_view file) {
  const auto slash = file.find_last_of('/');
  return slash == std::string_view::npos ? file : file.substr(slash + 1);
}

/// Files of different folders may have one name: then all keep their folders.
bool names_suffice(const std::vector<FittedRecording>& fits) {
  std::map<std::string_view, std::string_view> file_of;
  return std::all_of(fits.begin(), fits.end(), [&](const FittedRecording& fitted) {
    return file_of.emplace(without_folder(fitted.file), fitted.file).first->second == fitted.file;
  });
}

std::vector<std::string> row_of(const FittedRecording& fitted, const std::string& name,
                                const std::vector<std::string_view>& columns) {
  std::vector<std::string> row{name, fmt::format("{}", fitted.series.run),
                               fitted.succeeded() ? to_text(fitted.fit.law) : std::string(fitted.status())};
  const bool any = !fitted.parameters.empty();
  for (const auto column : columns) {
    const Parameter* number = find(fitted, column);
    row.push_back(!number ? ""
                          : format_concise({number->estimate.value, number->estimate.standard_error},
                                           number->unit == "1" ? "" : number->unit));
  }
  const std::string_view unit = si_unit_of(fitted.series.quantity);
  row.push_back(any ? fmt::format("{:.3g}{}{}", fitted.fit.residual.rms, unit.empty() ? "" : " ", unit) : "");
  row.push_back(in_words(fitted.fit.message));
  return row;
}

}  // namespace

std::string fit_table(const std::vector<FittedRecording>& fits) {
  if (fits.empty()) return "";
  const bool short_names = names_suffice(fits);
  const std::vector<std::string_view> columns = columns_of(fits);
  std::vector<std::vector<std::string>> rows{{"file", "run", "law"}};
  for (const auto column : columns) rows[0].push_back(readable_name(column));
  rows[0].emplace_back("residual (rms)");
  std::size_t failed = 0;
  for (const auto& fitted : fits) {
    rows.push_back(
        row_of(fitted, std::string(short_names ? without_folder(fitted.file) : fitted.file), columns));
    failed += !fitted.succeeded();
  }
  std::string out = text_table(rows, 1, 2);
  out += fmt::format("{} of {} fits succeeded\n", fits.size() - failed, fits.size());
  return out;
}

}  // namespace cromer::core
