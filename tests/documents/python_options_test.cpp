// The Python package's arguments are made from the tables of options. With CROMER_WRITE_DESCRIPTIONS=1 the
// test writes the file; without, it compares it.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "cromer/documents/text.h"
#include "cromer/tasks/modes/modes.h"
#include "tests/support/expect_in.h"

namespace cromer::core {
namespace CROMER_FILE {

struct TypeOf {
  bool grid;  ///< a text may be a number or an array

  std::string operator()(double*) const { return "Value"; }
  std::string operator()(std::optional<double>*) const { return "Value"; }
  std::string operator()(std::vector<double>*) const { return "Union[Value, Sequence[Value]]"; }
  std::string operator()(std::optional<Quantity>*) const { return "Uncertain"; }
  std::string operator()(std::vector<Quantity>*) const { return "Uncertain"; }
  std::string operator()(std::optional<int>*) const { return "int"; }
  std::string operator()(long long*) const { return "int"; }
  std::string operator()(unsigned long long*) const { return "int"; }
  std::string operator()(bool*) const { return "bool"; }
  std::string operator()(std::string*) const { return grid ? "Grid" : "str"; }
  std::string operator()(std::vector<std::string>*) const {
    return grid ? "Union[Grid, Sequence[Value]]" : "Union[str, Sequence[str]]";
  }
};

std::string argument(std::string_view option) {
  std::string name(option);
  std::replace(name.begin(), name.end(), '-', '_');
  return name == "from" ? "from_" : name;  // a word of Python's own
}

/// "without segment" for "without --segment".
std::string in_arguments(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "--") != 0) {
      out += text[i++];
      continue;
    }
    const std::size_t end =
        std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-", i), text.size());
    out += argument(std::string_view(text).substr(i + 2, end - i - 2));
    i = end;
  }
  return out;
}

/// "text" as Python has it.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// `own`: an option that the verb has as an argument with a type of its own.
template <class Options>
void append(std::string& types, std::string& table, const std::string& verb, const std::string& name,
            const std::string& own = "") {
  Options options;
  types += "\n\nclass " + name + "(TypedDict, total=False):\n";
  table += "    " + quoted(verb) + ": {\n";
  for (const Option& option : options_of(options)) {
    if (option.name == own) continue;
    const bool grid = option.is_text() && !option.unit.empty();
    const std::string type = std::visit(TypeOf{grid}, option.target);
    types += "    " + argument(option.name) + ": " + type + "\n";
    const std::string unit =
        option.unit.empty() || option.unit == "1" ? "" : "[" + std::string(option.unit) + "] ";
    table += "        " + quoted(argument(option.name)) + ": (" + quoted(type) + ", " +
             quoted(unit + in_arguments(option_text(option))) + "),\n";
  }
  table += "    },\n";
}

TEST(Descriptions, AreThePythonPackagesArguments) {
  std::string types, table;
  append<ReadOptions>(types, table, "read", "ReadOptions");
  append<FitOptions>(types, table, "fit", "FitOptions");
  append<SimulateOptions>(types, table, "simulate", "SimulateOptions", "method");
  append<CompareOptions>(types, table, "compare", "CompareOptions", "method");
  append<RecogniseOptions>(types, table, "methods", "MethodsOptions", "recognise");
  append<ModesOptions>(types, table, "modes", "ModesOptions");
  append<SweepOptions>(types, table, "sweep", "SweepOptions");
  append<SpectrumOptions>(types, table, "spectrum", "SpectrumOptions", "periods");
  expect_in("python/cromer/_options.py",
            "\"\"\"What the verbs take: written by tests/documents/python_options_test.cpp from the tables "
            "of options, "
            "with\nCROMER_WRITE_DESCRIPTIONS=1.\"\"\"\n\n"
            "from __future__ import annotations\n\n"
            "from typing import Dict, Sequence, Tuple, TypedDict, Union\n\n"
            "from ._types import Grid, Uncertain, Value\n" +
                types +
                "\n\n#: Of each verb's arguments the type, and in brackets the unit, what it is, and in "
                "brackets the "
                "default.\nARGUMENTS: Dict[str, Dict[str, Tuple[str, str]]] = {\n" +
                table + "}\n");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
