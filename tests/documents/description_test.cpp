// The page's types and the tables of the docs are made from the descriptions of the results. With
// CROMER_WRITE_DESCRIPTIONS=1 the test writes both files; without, it compares them.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "apps/web/core/described.h"
#include "cromer/documents/described/describe.h"
#include "cromer/documents/described/modes.h"
#include "cromer/documents/described/network_fit.h"
#include "cromer/documents/described/network_run.h"
#include "cromer/documents/described/recognise.h"
#include "cromer/documents/described/simulate.h"
#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/described/spring.h"
#include "cromer/documents/described/sweep.h"
#include "tests/support/expect_in.h"

namespace cromer::core {
namespace CROMER_FILE {

using described::is_optional;
using described::ItemOf;
using described::List;
using described::OptionalTraits;
using described::Text;
using described::ValueOf;

template <class Get, class Result>
using Got = std::remove_cvref_t<std::invoke_result_t<Get, const Result&>>;

/// Calls visit.operator()<T>() for the described struct T within a value of this type.
template <class Value, class Visit>
void within(Visit visit) {
  if constexpr (IsDescribed<Value>)
    visit.template operator()<Value>();
  else if constexpr (is_optional<Value>)
    within<typename OptionalTraits<Value>::Inner>(visit);
  else if constexpr (List<Value>)
    within<ItemOf<Value>>(visit);
}

class PageTypes {
 public:
  template <class Result>
  void add() {
    const std::string name(Described<Result>::name);
    if (!known_.insert(name).second) return;
    std::string bases, body = body_of<Result>(Described<Result>::entries, "  ", bases);
    text_ +=
        "\nexport interface " + name + (bases.empty() ? "" : " extends " + bases) + " {\n" + body + "}\n";
  }
  const std::string& text() const { return text_; }

 private:
  template <class Value>
  std::string type_of(bool finite) {
    if constexpr (IsDescribed<Value>) {
      add<Value>();
      return std::string(Described<Value>::name);
    } else if constexpr (is_optional<Value>) {
      using Inner = typename OptionalTraits<Value>::Inner;
      const std::string inner = type_of<Inner>(finite);
      return inner == "Maybe"                                     ? inner
             : inner == "number" && std::is_same_v<Inner, double> ? "Maybe"
                                                                  : inner + " | null";
    } else if constexpr (std::is_same_v<Value, bool>) {
      return "boolean";
    } else if constexpr (std::is_same_v<Value, double>) {
      return finite ? "number" : "Maybe";
    } else if constexpr (std::is_arithmetic_v<Value>) {
      return "number";
    } else if constexpr (std::is_same_v<Value, Notice>) {
      return "Said";
    } else if constexpr (std::is_same_v<Value, Pair>) {
      return finite ? "[number, number]" : "[Maybe, Maybe]";
    } else if constexpr (std::is_same_v<ItemOf<Value>, Parameter>) {
      return "Record<string, " + type_of<Parameter>(finite) + ">";
    } else if constexpr (std::is_same_v<ItemOf<Value>, double>) {
      return "Numbers";
    } else if constexpr (List<Value>) {
      return type_of<ItemOf<Value>>(finite) + "[]";
    } else {
      static_assert(Text<Value>, "this type has no description");
      return "string";
    }
  }

  static std::string line(std::string_view indent, std::string_view name, std::string_view type,
                          std::string_view unit, std::string_view meaning, bool left_out = false) {
    std::string text = std::string(indent) + "/** ";
    if (!unit.empty()) text += "[" + std::string(unit) + "] ";
    text += std::string(meaning) + " */\n";
    return text + std::string(indent) + std::string(name) + (left_out ? "?: " : ": ") + std::string(type) +
           "\n";
  }

  template <class Result, class Get>
  std::string entry(const Field<Get>& field, std::string_view indent, std::string&) {
    using Value = ValueOf<Field<Get>, Result>;
    using Shown = typename OptionalTraits<Value>::Inner;
    return line(indent, field.name,
                field.if_any ? type_of<Shown>(field.finite) : type_of<Value>(field.finite), field.unit,
                field.meaning, field.if_any);
  }
  template <class Result, class Get>
  std::string entry(const Estimated<Get>& each, std::string_view indent, std::string&) {
    return line(indent, each.name, each.finite ? "number" : "Maybe", each.unit, each.meaning) +
           line(indent, each.error_name, "Maybe", each.unit, "its standard error") +
           (each.interval ? line(indent, "confidence_95", "[Maybe, Maybe]", each.unit, "95 % interval") : "");
  }
  template <class Result, class When, class Entries>
  std::string entry(const Group<When, Entries>& group, std::string_view indent, std::string& bases) {
    const std::string inner = body_of<Result>(group.entries, std::string(indent) + "  ", bases);
    return line(indent, group.name,
                "{\n" + inner + std::string(indent) + "}" + (group.sometimes ? " | null" : ""), "",
                group.meaning);
  }
  template <class Result, class Get>
  std::string entry(const AllOf<Get>&, std::string_view, std::string& bases) {
    using Base = Got<Get, Result>;
    add<Base>();
    bases += (bases.empty() ? "" : ", ") + std::string(Described<Base>::name);
    return "";
  }
  template <class Result, class Get, class Sample>
  std::string entry(const ByName<Get, Sample>& named, std::string_view indent, std::string&) {
    std::string text;
    for (const Named& each : named.sample())
      text += line(indent, each.name, "Maybe", each.unit, each.meaning);
    return text;
  }
  template <class Result, class Get>
  std::string entry(const Notices<Get>&, std::string_view indent, std::string&) {
    return line(indent, "warnings", "Said[]", "", "what else there is to know, in sentences") +
           line(indent, "notices", "NoticeObject[]", "", "the same with code, severity and values");
  }

  template <class Result, class Entries>
  std::string body_of(const Entries& entries, std::string indent, std::string& bases) {
    std::string body;
    for_each_entry(entries, [&](const auto& each) { body += entry<Result>(each, indent, bases); });
    return body;
  }

  std::set<std::string> known_;
  std::string text_;
};

/// A row "| `residual.rms` | unit | meaning |" for each entry of a document.
class DocsTable {
 public:
  template <class Result>
  void add(std::string_view prefix = "") {
    rows<Result>(Described<Result>::entries, prefix);
  }
  const std::string& text() const { return text_; }

 private:
  /// Two entries may share a name if each may be left out.
  void row(const std::string& path, std::string_view unit, std::string_view meaning, bool left_out = false) {
    EXPECT_FALSE(meaning.empty()) << path;
    const auto [known, is_new] = known_.emplace(path, left_out);
    EXPECT_TRUE(is_new || (left_out && known->second)) << path << " stands twice";
    text_ += "| `" + path + "` | " + std::string(unit) + " | " + std::string(meaning) + " |\n";
  }

  template <class Value>
  static std::string path_of(const std::string& path) {
    if constexpr (is_optional<Value>)
      return path_of<typename OptionalTraits<Value>::Inner>(path);
    else if constexpr (std::is_same_v<ItemOf<Value>, Parameter>)
      return path + ".NAME";
    else if constexpr (List<Value>)
      return path + "[]";
    else
      return path;
  }

  template <class Result, class Get>
  void entry(const Field<Get>& field, std::string_view prefix) {
    using Value = ValueOf<Field<Get>, Result>;
    const std::string path = std::string(prefix) + std::string(field.name);
    row(path, field.unit, field.meaning, field.if_any);
    within<Value>([&]<class Inner>() { add<Inner>(path_of<Value>(path) + "."); });
  }
  template <class Result, class Get>
  void entry(const Estimated<Get>& each, std::string_view prefix) {
    row(std::string(prefix) + std::string(each.name), each.unit, each.meaning);
    row(std::string(prefix) + std::string(each.error_name), each.unit, "its standard error");
    if (each.interval) row(std::string(prefix) + "confidence_95", each.unit, "95 % interval");
  }
  template <class Result, class When, class Entries>
  void entry(const Group<When, Entries>& group, std::string_view prefix) {
    const std::string path = std::string(prefix) + std::string(group.name);
    row(path, "", group.meaning);
    rows<Result>(group.entries, path + ".");
  }
  template <class Result, class Get>
  void entry(const AllOf<Get>&, std::string_view prefix) {
    add<Got<Get, Result>>(prefix);
  }
  template <class Result, class Get, class Sample>
  void entry(const ByName<Get, Sample>& named, std::string_view prefix) {
    for (const Named& each : named.sample()) row(std::string(prefix) + each.name, each.unit, each.meaning);
  }
  template <class Result, class Get>
  void entry(const Notices<Get>&, std::string_view prefix) {
    row(std::string(prefix) + "warnings[]", "", "what else there is to know, in sentences");
    row(std::string(prefix) + "notices[]", "", "the same as `code`, `severity`, `text` and `values`");
  }
  template <class Result, class Entries>
  void rows(const Entries& entries, std::string_view prefix) {
    for_each_entry(entries, [&](const auto& each) { entry<Result>(each, prefix); });
  }

  std::map<std::string, bool> known_;
  std::string text_;
};

template <class Result>
std::string table(std::string_view heading) {
  DocsTable rows;
  rows.add<Result>();
  return "\n## " + std::string(heading) + "\n\n| name | unit | what it is |\n|---|---|---|\n" + rows.text();
}

TEST(Descriptions, AreThePagesTypes) {
  PageTypes types;
  types.add<page::InspectedOnPage>();
  types.add<page::FitOnPage>();
  types.add<page::ComparedOnPage>();
  types.add<DescribedRun>();
  types.add<MethodRow>();
  types.add<page::MethodResonance>();
  types.add<ModesResult>();
  expect_in("apps/web/src/core/documents.ts",
            "// What the core's documents consist of: written by tests/documents/description_test.cpp from\n"
            "// src/cromer/documents/described, with CROMER_WRITE_DESCRIPTIONS=1. SI units.\n"
            "import type { Maybe, Numbers } from './numbers'\n"
            "import type { NoticeObject, Said } from '../words/said'\n" +
                types.text());
}

TEST(Descriptions, AreTheTableOfTheDocs) {
  expect_in(
      "docs/results.md",
      "# What the results consist of\n\n"
      "The entries of the JSON documents, as `--json` prints them and the library gives them. A name "
      "that ends\n"
      "in `[]` is a list; `NAME` stands for the name of a parameter. A number that is not known or not "
      "finite is\n"
      "null. `SI` and `of the column` stand for the SI unit of the column. A document of several runs has "
      "its\n"
      "`warnings` (texts) and `notices` (`code`, `severity`, `text`, `values`) at its top as well.\n" +
          table<FittedRecording>("fit") + table<CompareResult>("compare") +
          table<DescribedRun>("simulate: each of `runs[]`") +
          table<MethodRow>("methods: each of `methods[]`") +
          table<NetworkDocument>("simulate with a network") + table<FittedNetwork>("fit with a network") +
          table<ModesResult>("modes") + table<RecogniseResult>("methods with a run to recognise") +
          table<InspectedFile>("inspect") + table<SweepDocument>("sweep") +
          table<SpectrumDocument>("spectrum; of many recordings each of `motions[]`, with its `files`, or "
                                  "`files` and `message` alone") +
          table<StaticStiffness>("fit with held masses") + table<MassLine>("fit: `mass_line`"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
