// PEER strong-motion records: .AT2 (acceleration, g), .VT2 (velocity, cm/s), .DT2 (displacement, cm). Header
// lines with the quantity, the number of values NPTS and the step DT; then several values a line.
// Source: PEER NGA databases; older records write "4096 0.01 NPTS, DT", records of the NRC have seven lines.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/base/quantity.h"
#include "cromer/read/cells.h"
#include "cromer/read/formats/own_structures.h"
#include "cromer/read/in_file.h"
#include "cromer/read/rows.h"

namespace cromer::core::dialects {
namespace {

std::string capitals(std::string_view text) {
  std::string large(text);
  for (char& c : large)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return large;
}

/// "NPTS=  7997, DT=   .0050 SEC," or "4096 0.01 NPTS, DT".
struct Counted {
  double count = 0, step = 0;  ///< step in s
  std::size_t line = 0;        ///< index
};

std::optional<double> number_behind(std::string_view text, std::string_view tag) {
  const std::size_t at = text.find(tag);
  if (at == std::string_view::npos) return std::nullopt;
  text.remove_prefix(at + tag.size());
  text.remove_prefix(std::min(text.find_first_not_of(" =:"), text.size()));
  const auto number = leading_number(text);
  return number ? std::optional(number->value) : std::nullopt;
}

std::optional<Counted> counted_line(const std::vector<std::string_view>& lines) {
  constexpr std::size_t header_lines = 20;
  std::vector<std::string_view> cells;
  for (std::size_t i = 0; i < std::min(header_lines, lines.size()); ++i) {
    if (is_comment(lines[i])) continue;
    const std::string line = capitals(lines[i]);
    const std::size_t npts = line.find("NPTS"), dt = line.find("DT", npts == std::string::npos ? 0 : npts);
    if (npts == std::string::npos || dt == std::string::npos) continue;
    const auto count = number_behind(line, "NPTS"), step = number_behind(line, "DT");
    if (count && step) return Counted{*count, *step, i};
    split_cells(lines[i], Layout{' ', '.', 1}, cells);
    if (cells.size() < 4) continue;
    const Cell first = read_cell(cells[0], '.'), second = read_cell(cells[1], '.');
    if (first.kind == CellKind::number && second.kind == CellKind::number)
      return Counted{first.value, second.value, i};
  }
  return std::nullopt;
}

/// What the values are, from the header's words or the file's ending.
Column values_of(const std::vector<std::string_view>& lines, std::size_t header, std::string_view file) {
  struct Kind {
    std::string_view word, ending, name, quantity, unit;
  };
  constexpr Kind kinds[] = {{"ACCELERATION", ".AT2", "Acceleration", "acceleration", "g"},
                            {"VELOCITY", ".VT2", "Velocity", "velocity", "cm/s"},
                            {"DISPLACEMENT", ".DT2", "Displacement", "position", "cm"}};
  const std::string ending = capitals(file.substr(file.size() - std::min<std::size_t>(4, file.size())));
  const Kind* found = nullptr;
  std::string unit;
  for (std::size_t i = 0; i < header; ++i) {
    const std::string line = capitals(lines[i]);
    // "PACIFIC ENGINEERING ... STRONG-MOTION DATA" says nothing; "ACCELERATION TIME SERIES IN UNITS OF G"
    // says it all.
    for (const Kind& kind : kinds)
      if (!found && line.find(kind.word) != std::string::npos) found = &kind;
    const std::size_t at = line.find("UNITS OF ");
    if (at == std::string::npos || !unit.empty()) continue;
    const std::size_t from = std::min(line.find_first_not_of(' ', at + 9), line.size());
    unit = line.substr(from, std::min(line.find_first_of(" .,;", from), line.size()) - from);
  }
  for (const Kind& kind : kinds)
    if (!found && ending == kind.ending) found = &kind;
  if (!found) return {"column 2", "", "", 1, {}};
  if (unit.empty())
    return {std::string(found->name), std::string(found->quantity), std::string(found->unit), 1, {}};
  unit = lower(unit);
  if (unit.ends_with("/sec2") || unit.ends_with("/sec/sec"))
    unit = unit.substr(0, unit.find('/')).append("/s^2");
  if (unit.ends_with("/sec")) unit.resize(unit.size() - 2);
  return {std::string(found->name), std::string(found->quantity), unit, 1, {}};
}

/// Event, date and station of "Loma Prieta, 10/18/1989, Corralitos, 90", the second line of PEER's files: all
/// but the direction, its last cell. Empty if there is no such line above `header`.
std::string motion_of(const std::vector<std::string_view>& lines, std::size_t header) {
  if (header < 2) return "";
  const std::string_view line = lines[1];
  const std::size_t last = line.rfind(',');
  if (last == std::string_view::npos || line.find(',') == last) return "";
  return std::string(trimmed(line.substr(0, last)));
}

/// How many numbers follow those taken.
std::size_t numbers_behind(const std::vector<std::string_view>& lines, const NumberStream& taken) {
  const long last = taken.lines.back();
  const auto on_last = static_cast<std::size_t>(std::count(taken.lines.begin(), taken.lines.end(), last));
  const auto all =
      read_numbers(lines, static_cast<std::size_t>(last) - 1, static_cast<std::size_t>(-1), true);
  return all && all->values.size() > on_last ? all->values.size() - on_last : 0;
}

bool is_peer(const Source& source) {
  const auto head = counted_line(source.lines);
  if (!head) return false;
  // Numbers follow, and nothing else.
  for (std::size_t i = head->line + 1; i < source.lines.size(); ++i)
    if (!is_blank(source.lines[i])) return leading_number(trimmed(source.lines[i])).has_value();
  return true;
}

/// Reads values one after the other, up to NPTS, even if nothing but a minus sign separates them.
Result<Sets> read_peer(const Source& source) {
  const Counted head = *counted_line(source.lines);
  const long at = static_cast<long>(head.line) + 1;
  if (!is_step(head.step)) return in_line(at, Notice{"peer_step"});
  if (!(head.count >= 1) || head.count != std::floor(head.count)) return in_line(at, Notice{"peer_count"});
  constexpr double most = 1e15;  // no file is that long; a whole number of it fits
  auto stream =
      read_numbers(source.lines, head.line + 1, static_cast<std::size_t>(std::min(head.count, most)), false);
  if (!stream) return stream.error();
  const std::size_t count = stream->values.size();
  if (count == 0) return in_line(at, Notice{"peer_without_values"});

  Sets found{.dialect = "PEER", .separator = ' ', .decimal = '.', .sets = {}, .notices = {}};
  if (static_cast<double>(count) < head.count)
    found.notices.push_back(
        Notice{"peer_fewer_values", {{"promised", shortest(head.count)}, {"values", count}}});
  else if (const std::size_t more = numbers_behind(source.lines, *stream); more > 0)
    found.notices.push_back(Notice{"peer_more_values", {{"more", more}, {"values", count}}});
  found.motion = motion_of(source.lines, head.line);
  Set set;
  set.columns.push_back({"Time", "time", "s", 1, {}});
  for (std::size_t i = 0; i < count; ++i)
    set.columns.front().values.push_back(static_cast<double>(i) * head.step);
  set.columns.push_back(values_of(source.lines, head.line, source.file));
  set.columns.back().values = std::move(stream->values);
  set.lines = std::move(stream->lines);
  found.sets.push_back(std::move(set));
  return found;
}

}  // namespace

const OwnStructure peer{is_peer, read_peer};

}  // namespace cromer::core::dialects
