#include "cromer/read/formats/uff_function.h"

#include <cmath>

#include "cromer/base/concat.h"
#include "cromer/read/cells.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/lines.h"

namespace cromer::core::dialects {
namespace {

std::string_view field(std::string_view line, std::size_t from, std::size_t width) {
  return from < line.size() ? trimmed(line.substr(from, width)) : std::string_view{};
}

double number(std::string_view line, std::size_t from, std::size_t width) {
  const Cell cell = read_cell(field(line, from, width), '.');
  return cell.kind == CellKind::number ? cell.value : 0;
}

int whole(std::string_view line, std::size_t from, std::size_t width) {
  const double value = number(line, from, width);
  return std::fabs(value) < 1e9 ? static_cast<int>(value) : 0;
}

UffAxis axis(std::string_view line) {
  const auto text = [](std::string_view cell) { return cell == "NONE" ? std::string{} : std::string(cell); };
  return {whole(line, 0, 10), text(field(line, 26, 20)), text(field(line, 47, 20))};
}

struct Kind {
  int kind;
  std::string_view name, quantity;
};
constexpr Kind kinds[] = {{8, "Displacement", "position"},      {11, "Velocity", "velocity"},
                          {12, "Acceleration", "acceleration"}, {13, "Force", "force"},
                          {9, "Reaction force", "force"},       {17, "Time", "time"}};

}  // namespace

UffFunction uff_function(const std::array<std::string_view, uff_header_lines>& lines) {
  UffFunction read;
  read.identity = trimmed(lines[0]);
  read.function = whole(lines[5], 0, 5);
  read.load_case = whole(lines[5], 20, 10);
  read.node = whole(lines[5], 41, 10);
  read.direction = whole(lines[5], 51, 4);
  read.type = whole(lines[6], 0, 10);
  read.points = number(lines[6], 10, 10);
  read.even = whole(lines[6], 20, 10) == 1;
  read.start = number(lines[6], 30, 13);
  read.step = number(lines[6], 43, 13);
  read.abscissa = axis(lines[7]);
  read.ordinate = axis(lines[8]);
  return read;
}

std::string uff_name(const UffFunction& function) {
  std::string name = function.ordinate.label;
  for (const Kind& known : kinds)
    if (name.empty() && known.kind == function.ordinate.kind) name = known.name;
  if (name.empty())
    name = function.identity.empty() || function.identity == "NONE" ? "Response" : function.identity;
  if (function.node > 0) name += concat({" ", std::to_string(function.node)});
  constexpr std::string_view axes[] = {"", "X", "Y", "Z", "RX", "RY", "RZ"};
  const auto direction = static_cast<std::size_t>(std::abs(function.direction));
  if (direction > 0 && direction < std::size(axes))
    name += concat({" ", function.direction > 0 ? "+" : "-", axes[direction]});
  return name;
}

std::string uff_quantity(const UffAxis& axis, std::string_view name) {
  if (!axis.unit.empty())
    if (std::string by_unit = quantity_of(name, axis.unit); !by_unit.empty()) return by_unit;
  for (const Kind& known : kinds)
    if (known.kind == axis.kind) return std::string(known.quantity);
  return quantity_of(name, axis.unit);
}

}  // namespace cromer::core::dialects
