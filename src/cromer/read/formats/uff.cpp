#include "cromer/read/formats/uff.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "cromer/base/ascii.h"
#include "cromer/base/bit_cast.h"
#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/read/cells.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/encoding.h"
#include "cromer/read/in_file.h"
#include "cromer/read/rows.h"

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

namespace {

/// Lines and bytes of a file in which both occur.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  bool at_end() const { return rest_.empty(); }
  long line() const { return line_; }  ///< number of the line that next_line gives
  std::string_view peek_line() const {
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }
  std::string_view next_line() {
    const std::string_view line = peek_line();
    const std::size_t end = rest_.find('\n');
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    return line;
  }
  std::string_view next_bytes(std::size_t count) {
    const std::string_view bytes = rest_.substr(0, count);
    rest_.remove_prefix(bytes.size());
    return bytes;
  }

 private:
  std::string_view rest_;
  long line_ = 1;
};

/// Text among binary values as UTF-8; "" if it is not text.
std::string readable(std::string_view text) {
  const auto decoded = decode(text);
  return decoded ? std::string(decoded->text()) : std::string{};
}

bool is_delimiter(std::string_view line) { return trimmed(line) == "-1"; }

/// How the values of a 58b stand in the file.
struct Binary {
  bool used = false;
  bool little = true;
  double bytes = 0;
};

/// "    58b     1     2          11        4000 ...": byte order (1 little, 2 big), floating-point format (2
/// is IEEE 754), header lines, bytes.
Result<Binary> binary_of(std::string_view line) {
  const auto field = [&](std::size_t from, std::size_t width) {
    const Cell cell =
        read_cell(trimmed(from < line.size() ? line.substr(from, width) : std::string_view{}), '.');
    return cell.kind == CellKind::number ? cell.value : 0;
  };
  if (trimmed(line) == "58") return Binary{};
  if (field(13, 6) != 2) return Error{"dataset_not_ieee"};
  if (field(7, 6) != 1 && field(7, 6) != 2) return Error{"dataset_byte_order"};
  return Binary{true, field(7, 6) == 1, field(31, 12)};
}

template <class Bits, class Real>
double real_at(std::string_view bytes, std::size_t at, bool little) {
  Bits bits = 0;
  for (std::size_t k = 0; k < sizeof(Bits); ++k) {
    const std::size_t from = little ? sizeof(Bits) - 1 - k : k;
    bits = static_cast<Bits>(bits << 8) | static_cast<unsigned char>(bytes[at + from]);
  }
  return static_cast<double>(bit_cast<Real>(bits));
}

/// All numbers of a binary dataset in their order. Uneven ones are pairs, whose time is always a single.
std::vector<double> binary_values(std::string_view bytes, const UffFunction& head, bool little) {
  std::vector<double> values;
  const bool doubles = head.type == 4;
  for (std::size_t at = 0, k = 0;; ++k) {
    const bool eight = doubles && (head.even || k % 2 == 1);
    const std::size_t size = eight ? 8 : 4;
    if (at + size > bytes.size()) return values;
    values.push_back(eight ? real_at<std::uint64_t, double>(bytes, at, little)
                           : real_at<std::uint32_t, float>(bytes, at, little));
    at += size;
  }
}

/// Why a dataset is left out. Notices come in this order.
enum class Why { no_step, no_values, no_time_response, other_kind, complex };
using Reason = std::pair<Why, std::string>;  // with the kind

Notice notice_of(const Reason& reason) {
  switch (reason.first) {
    case Why::no_step:
      return Notice{"dataset_without_step"};
    case Why::no_values:
      return Notice{"dataset_without_values"};
    case Why::no_time_response:
      return Notice{"dataset_no_time_response"};
    case Why::other_kind:
      return Notice{"dataset_of_other_kind", {{"kind", reason.second}}};
    case Why::complex:
      break;
  }
  return Notice{"dataset_complex"};
}

/// Reads one dataset 58 behind its number; what cannot be a recording is left out with a reason.
class Responses {
 public:
  Result<void> read(Reader& reader, std::string_view number_line, long begins) {
    const auto binary = binary_of(number_line);
    if (!binary) return in_line(begins, binary.error());
    std::array<std::string_view, uff_header_lines> lines;
    for (std::string_view& line : lines) line = reader.next_line();
    const UffFunction head = uff_function(lines);
    const long first = reader.line();
    std::vector<double> numbers;
    std::vector<long> at;
    if (binary->used) {
      if (!(binary->bytes >= 0 && binary->bytes < 1e15)) return in_line(begins, Notice{"dataset_bytes"});
      numbers =
          binary_values(reader.next_bytes(static_cast<std::size_t>(binary->bytes)), head, binary->little);
      at.assign(numbers.size(), first);
    } else {
      std::vector<std::string_view> rows;
      while (!reader.at_end() && !is_delimiter(reader.peek_line())) rows.push_back(reader.next_line());
      auto stream = read_numbers(rows, 0, static_cast<std::size_t>(-1), false, first - 1);
      if (!stream) return stream.error();
      numbers = std::move(stream->values);
      at = std::move(stream->lines);
    }
    keep(head, std::move(numbers), at, begins);
    return {};
  }

  Sets take() && {
    for (const auto& [reason, of] : left_out_)
      found_.notices.push_back(
          Notice{of.count > 1 ? "datasets_left_out" : "dataset_left_out",
                 {{"datasets", of.count}, {"what", notice_of(reason)}, {"line", of.line}}});
    return std::move(found_);
  }
  /// `kind` is a dataset number other than 58.
  void leave_out(Why why, long line, const std::string& kind = "") {
    LeftOut& of = left_out_[{why, kind}];
    if (of.count++ == 0) of.line = line;
  }

 private:
  void keep(const UffFunction& head, std::vector<double> numbers, const std::vector<long>& at, long begins) {
    if (head.type != 2 && head.type != 4) return leave_out(Why::complex, begins);
    const bool time = head.abscissa.kind == 17 || head.function == 1;
    if (!time) return leave_out(Why::no_time_response, begins);
    if (head.even && !is_step(head.step)) return leave_out(Why::no_step, begins);
    const std::size_t stride = head.even ? 1 : 2;
    std::size_t count = numbers.size() / stride;
    if (static_cast<double>(count) > head.points && head.points > 0)
      count = static_cast<std::size_t>(head.points);
    if (count == 0) return leave_out(Why::no_values, begins);
    if (head.points != static_cast<double>(count))
      found_.notices.push_back(Notice{
          "dataset_points", {{"line", begins}, {"promised", shortest(head.points)}, {"points", count}}});
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto finite = [](double value) { return std::isfinite(value) ? value : nan; };
    Set set;
    set.label = head.load_case > 0 ? concat({"load case ", std::to_string(head.load_case)}) : "no load case";
    const std::string name = readable(uff_name(head)), unit = readable(head.ordinate.unit);
    const std::string time_unit = readable(head.abscissa.unit);
    set.columns.push_back({"Time", "time", time_unit.empty() ? "s" : time_unit, 1, {}});
    set.columns.push_back({name, uff_quantity(head.ordinate, name), unit, 1, {}});
    for (std::size_t i = 0; i < count; ++i) {
      set.columns[0].values.push_back(head.even ? head.start + static_cast<double>(i) * head.step
                                                : finite(numbers[2 * i]));
      set.columns[1].values.push_back(finite(numbers[stride * i + stride - 1]));
      set.lines.push_back(at[stride * i]);
    }
    found_.sets.push_back(std::move(set));
  }

  Sets found_{.dialect = "UFF 58", .separator = ' ', .decimal = '.', .sets = {}, .notices = {}};
  struct LeftOut {
    std::size_t count = 0;
    long line = 0;  ///< of the first
  };
  std::map<Reason, LeftOut> left_out_;
};

}  // namespace

bool is_uff(std::string_view bytes) {
  const std::size_t first = std::min(bytes.find_first_not_of("\r\n"), bytes.size());
  Reader reader(bytes.substr(first));
  // Both stand at the right of six columns: a single column of numbers may begin with -1 and 58 too.
  const std::string_view delimiter = reader.next_line(), number = reader.next_line();
  if (!delimiter.starts_with("  ") || !is_delimiter(delimiter) || !number.starts_with("  ")) return false;
  const std::string_view kind = trimmed(number);
  const std::size_t digits = std::min(kind.find_first_not_of("0123456789"), kind.size());
  return digits > 0 && digits < 5 && (digits == kind.size() || kind.starts_with("58b"));
}

Result<Sets> read_uff(std::string_view bytes) {
  Reader reader(bytes);
  Responses responses;
  while (!reader.at_end()) {
    if (!is_delimiter(reader.next_line())) continue;
    if (reader.at_end()) break;
    const long begins = reader.line();
    const std::string_view number = reader.next_line();
    if (trimmed(number) == "58" || trimmed(number).starts_with("58b")) {
      if (const auto read = responses.read(reader, number, begins); !read) return read.error();
    } else if (trimmed(number) != "151" && trimmed(number) != "164") {  // of the model and its units
      responses.leave_out(Why::other_kind, begins, shown(readable(trimmed(number))));
    }
    // Skips to the delimiter that ends the dataset; line ends may stand before it.
    while (!reader.at_end() && !is_delimiter(reader.next_line())) continue;
  }
  Sets found = std::move(responses).take();
  if (!found.sets.empty()) return found;
  if (found.notices.empty()) return Error{"no_time_response"};
  return Error{"no_time_response_but", {{"what", found.notices.front()}}};
}

}  // namespace cromer::core::dialects
