// Options defined once: the command line, the study file and the tasks' own checks all read these tables.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/result.h"

namespace cromer {
struct ReadOptions;
}

namespace cromer::core {

struct SimulateOptions;
struct FitOptions;
struct CompareOptions;
struct MethodsOptions;
struct RecogniseOptions;
struct SweepOptions;
struct SpectrumOptions;

/// What a value must satisfy.
enum class Range {
  any,
  positive,
  not_negative,
  at_least_one,
  fraction,
  tolerance,
  accuracy,
  air_temperature,
  sampling_rate,
  trials  ///< of a Monte Carlo
};

/// The constraint as it follows "it must": "be positive"; empty for any.
Notice constraint(Range range);

/// A text of --help. The page has no --help and must be small: there it is empty.
class HelpText {
 public:
  HelpText() = default;
#ifdef CROMER_PAGE
  HelpText(const char*) {}       // NOLINT: implicit on purpose
  HelpText(std::string_view) {}  // NOLINT
#else
  HelpText(const char* text) : text_(text) {}       // NOLINT: implicit on purpose
  HelpText(std::string_view text) : text_(text) {}  // NOLINT
#endif

  operator std::string_view() const { return text_; }  // NOLINT

 private:
  std::string_view text_;
};

/// One option: where its value goes, in which unit, and what it means.
struct Option {
  using Target = std::variant<double*, std::optional<double>*, std::vector<double>*, std::optional<Quantity>*,
                              std::vector<Quantity>*, std::optional<int>*, long long*, unsigned long long*,
                              bool*, std::string*, std::vector<std::string>*>;

  std::string_view name;  ///< as typed, without dashes: "drive-frequency"; "drive_frequency" in a study file
  Target target;          ///< outlives the Option
  std::string_view unit;  ///< SI unit of the value; "" for a plain number or a text; "Hz" counts per second
  Range range = Range::any;
  HelpText help;                  ///< what it is, in a few words
  std::string_view default_text;  ///< what holds when it is not given; "" if nothing does
  std::string_view group;         ///< heading in --help
  bool* asked = nullptr;          ///< set to true when the option is given
  /// A number that is typed without a unit and is as large as this may be meant in a smaller one.
  double doubtful_from = std::numeric_limits<double>::infinity();

  bool is_flag() const { return std::holds_alternative<bool*>(target); }
  /// May be given several times; each time adds a value. Quantities may also stand between commas: "48 g, 68
  /// g".
  bool is_list() const {
    return std::holds_alternative<std::vector<double>*>(target) ||
           std::holds_alternative<std::vector<Quantity>*>(target) ||
           std::holds_alternative<std::vector<std::string>*>(target);
  }
  bool has_uncertainty() const {
    return std::holds_alternative<std::optional<Quantity>*>(target) ||
           std::holds_alternative<std::vector<Quantity>*>(target);
  }
  /// Holds words rather than a number.
  bool is_text() const {
    return std::holds_alternative<std::string*>(target) ||
           std::holds_alternative<std::vector<std::string>*>(target);
  }
};

/// The tables, in the order of --help. The pointers go into the struct given.
std::vector<Option> options_of(SimulateOptions& options);
std::vector<Option> options_of(ReadOptions& options);
std::vector<Option> options_of(FitOptions& options);  ///< with those of its ReadOptions
std::vector<Option> options_of(
    CompareOptions& options);  ///< with those of its FitOptions but the driven ones
std::vector<Option> options_of(MethodsOptions& options);
/// With those of its MethodsOptions, the law of simulate and those of its ReadOptions: all that `methods`
/// takes.
std::vector<Option> options_of(RecogniseOptions& options);
/// Options of simulate that can have a grid are texts here, whatever their unit.
std::vector<Option> options_of(SweepOptions& options);
std::vector<Option> options_of(SpectrumOptions& options);  ///< with those of its ReadOptions

/// Reads `text` (a quantity with unit, a whole number, a word, "true" or "false" for a flag) into the target;
/// a list grows by one. An Error names the option, the text and what was expected.
Result<void> assign(const Option& option, std::string_view text);

/// One option as it was given: its name and its value as text.
using TypedOption = std::pair<std::string, std::string>;

/// Puts every setting into its option, and checks it. The Error names an option that is not in the table,
/// with the nearest one, or says what is wrong with the value. `task` is the one whose options they are.
Result<void> assign(const std::vector<TypedOption>& settings, const std::vector<Option>& options,
                    std::string_view task);

/// Checks that the target's present value is finite and in the option's range; the Error names option, value
/// and constraint.
Result<void> check(const Option& option);

}  // namespace cromer::core
