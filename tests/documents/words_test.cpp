// The catalogue of sentences, and how they are made. The sources are read: every code that is raised has its
// sentence in both languages, with all the values that it needs, and no sentence stands where it is raised.
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/catalogue.h"
#include "cromer/identify/motion/motion.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/recognise/recognise.h"
#include "cromer/tasks/record/options.h"
#include "cromer/tasks/simulate/laid_over.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::EndsWith;

constexpr Voice german{Language::german}, of_a_library{Language::english, Audience::caller},
    of_the_page{Language::english, Audience::page}, of_the_german_page{Language::german, Audience::page};

// ---- what a template may hold

TEST(Words, NumbersAreWrittenAsTheSentenceSays) {
  const Notice noisy{"too_noisy", {{"percent", 12.46}}};
  EXPECT_EQ(in_words(noisy), "too noisy: a sinusoid accounts for only 12.5 % of the variance");
  EXPECT_EQ(in_words(noisy, german), "zu viel Rauschen: eine Sinusschwingung erklärt nur 12,5 % der Varianz");
  const Notice many{"points_too_many", {{"points", 2e12}, {"needed", "3.5 TB"}}};
  EXPECT_EQ(in_words(many), "2e+12 points need 3.5 TB of memory; ask for fewer");
  EXPECT_EQ(in_words(many, german), "2e+12 Punkte brauchen 3,5 TB Speicher; bitte weniger verlangen");
}

TEST(Words, CountsHaveTheirNouns) {
  const auto lost = [](int rows) {
    return in_words(Notice{"bad_rows_left_out", {{"rows", rows}, {"line", 7}}});
  };
  EXPECT_EQ(lost(1), "1 bad row left out, the first in line 7");
  EXPECT_EQ(lost(3), "3 bad rows left out, the first in line 7");
  Notice of_arrays{"bad_rows_left_out", {{"rows", 1}, {"line", 7}}};
  of_arrays.of_arrays = true;
  EXPECT_EQ(in_words(of_arrays), "1 bad row left out, the first in sample 7");
}

TEST(Words, ListsAndBraces) {
  const std::vector<std::string> verbs{"read", "fit", "sweep"};
  const Notice none{"no_verb", {{"verb", "fut"}, {"verbs", verbs}}};
  EXPECT_EQ(in_words(none), "there is no verb \"fut\"; there are read, fit and sweep");
  EXPECT_EQ(in_words(none, german), "das Verb „fut“ gibt es nicht; es gibt read, fit und sweep");
  const Notice column{"no_such_column", {{"name", "y"}, {"columns", std::vector<std::string>{"\"x (m)\""}}}};
  EXPECT_EQ(in_words(column), "no column is called \"y\"; there are \"x (m)\"");
  EXPECT_EQ(in_words(column, german), "keine Spalte heißt „y“; es gibt „x (m)“");
  EXPECT_EQ(in_words(Notice{"body_is_no_object"}), "the body is no JSON object such as {\"for\": \"20 s\"}");
}

TEST(Words, ACodeThatIsNotInTheCatalogueIsShownAsItIs) {
  EXPECT_EQ(in_words(Notice{"no such sentence"}), "no such sentence");
  EXPECT_EQ(in_words(Notice{}), "");
}

TEST(Words, OptionsAreNamedAsTheReaderKnowsThem) {
  const Notice notice{"given_several_times", {{"option", "drive-frequency"}, {"times", 3}}};
  EXPECT_EQ(in_words(notice), "--drive-frequency is given 3 times; it takes one value");
  EXPECT_EQ(in_words(notice, of_a_library), "drive_frequency is given 3 times; it takes one value");
  EXPECT_EQ(in_words(notice, of_the_page), "drive frequency is given 3 times; it takes one value");
  EXPECT_EQ(first_option(notice), "drive-frequency");
}

TEST(Words, ThePageHasHandlesWhereTheProgramHasOptions) {
  const Notice cut{"tops_cut_off"};
  EXPECT_THAT(in_words(cut), EndsWith("choose the later part with --from"));
  EXPECT_THAT(in_words(cut, of_a_library), EndsWith("choose the later part with from"));
  EXPECT_THAT(in_words(cut, of_the_page), EndsWith("choose the later part with the handles"));
  EXPECT_THAT(in_words(cut, of_the_german_page), EndsWith("bitte den späteren Teil mit den Griffen wählen"));
  const Notice alike{"columns_alike", {{"columns", std::vector<std::string>{"x", "y"}}, {"first", "x"}}};
  EXPECT_EQ(in_words(alike),
            "several columns are alike: x, y; say which with --column, for instance --column \"x\"; "
            "\"modes\" finds "
            "the natural frequencies of coupled motions from all of them");
  EXPECT_EQ(in_words(alike, of_the_page), "several columns are alike: x, y; choose one, for instance \"x\"");
  // either may be empty
  EXPECT_EQ(in_words(Notice{"no_time_column"}, of_the_page),
            "there is no time column: give the samples per second");
}

TEST(Words, APartHasItsOwnSentence) {
  const Notice part{"in_file", {{"file", "a.csv"}, {"what", Notice{"no_memory_for_file"}}}};
  EXPECT_EQ(in_words(part), "a.csv: not enough memory for this file");
  EXPECT_EQ(in_words(part, german), "a.csv: für diese Datei reicht der Speicher nicht");
}

TEST(Words, ANameKeepsItsSmallLettersAtTheHeadOfASentence) {
  const Notice maker{"maker_with_step", {{"method", "euler-cromer"}, {"step", 0.02}}};
  const auto sentence = [](const Notice& what) {
    return in_words(Notice{"answer_as_sentence", {{"what", what}}});
  };
  EXPECT_EQ(sentence(maker), "euler-cromer with a step of 0.02 s.");
  const Notice made{"rows_made_by", {{"maker", maker}, {"same", ""}, {"others", ""}, {"added", ""}}};
  EXPECT_EQ(sentence(made), "euler-cromer with a step of 0.02 s made these rows.");
  EXPECT_EQ(sentence(Notice{"no_method_gets_through"}), "No method gets through with this law.");
}

TEST(Words, AClauseWeighsAsMuchAsTheWorstOfItsParts) {
  const Notice slight{"file_lists_more"};
  const Notice middle{"lines_no_samples", {{"lines", 2}}};
  EXPECT_EQ(severity(slight), Severity::detail);
  EXPECT_EQ(severity(Notice{"in_file", {{"file", "a"}, {"what", slight}}}), Severity::detail);
  EXPECT_EQ(severity(Notice{"in_file", {{"file", "a"}, {"what", std::vector{slight, middle}}}}),
            Severity::worth_knowing);
}

TEST(Words, WorstComesFirst) {
  const auto sorted = worst_first({Notice{"file_lists_more"}, Notice{"lines_no_samples", {{"lines", 2}}}});
  EXPECT_EQ(sorted[0].code, "lines_no_samples");
}

// ---- the catalogue and the sources

/// The names between braces: {rate:.3g} is rate. Options and doubled braces are none.
std::set<std::string> places_of(std::string_view words) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != '{') continue;
    if (words.substr(i + 1, 1) == "{") {
      ++i;
      continue;
    }
    const std::size_t end = words.find('}', i);
    std::string_view place = words.substr(i + 1, end - i - 1);
    if (place.starts_with("|")) continue;  // what it holds follows
    i = end;
    if (place.starts_with("--")) continue;
    if (place.starts_with("@")) place.remove_prefix(1);
    names.emplace(place.substr(0, place.find_first_of(":?")));
  }
  return names;
}

std::set<std::string> options_in(std::string_view words) {
  std::set<std::string> names;
  const std::string text(words);
  const std::regex option(R"(\{--([a-z0-9-]+)\})");
  for (std::sregex_iterator found(text.begin(), text.end(), option), end; found != end; ++found)
    names.insert((*found)[1]);
  return names;
}

/// Numbers of the sentence itself, with a point; but 0, which is "positive" in one language only.
std::multiset<std::string> numbers_in(std::string_view words) {
  std::multiset<std::string> numbers;
  const std::string text = std::regex_replace(std::string(words), std::regex(R"(\{[^{}|]*\})"), "");
  const std::regex number(R"(\d+([.,]\d+)*(e\d+)?)");
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
    std::string each = found->str();
    std::replace(each.begin(), each.end(), ',', '.');
    if (each != "0") numbers.insert(each);
  }
  return numbers;
}

TEST(Catalogue, HasEachCodeOnceInBothLanguages) {
  std::set<std::string_view> codes;
  for (const auto& part : catalogue())
    for (const Entry& entry : part) {
      EXPECT_TRUE(codes.insert(entry.code).second) << entry.code << " stands twice";
      EXPECT_FALSE(entry.english.empty()) << entry.code;
      EXPECT_FALSE(entry.german.empty()) << entry.code;
      const auto english = places_of(entry.english), foreign = places_of(entry.german);
      EXPECT_EQ(english, foreign) << entry.code << ": both sentences name the same values";
      EXPECT_EQ(options_in(entry.english), options_in(entry.german)) << entry.code;
      EXPECT_EQ(numbers_in(entry.english), numbers_in(entry.german)) << entry.code;
      EXPECT_EQ(find_entry(entry.code), &entry);
    }
  EXPECT_GT(codes.size(), 500u);
}

TEST(Catalogue, NamesEachMethodTermAndNumberOfAFit) {
  for (const std::string_view method : method_names) EXPECT_TRUE(find_entry(method)) << method;
  for (const std::string_view number : derived_names) EXPECT_TRUE(find_entry(number)) << number;
  for_each_term([]<class T>() {
    if constexpr (!std::is_same_v<T, Spring>) {
      EXPECT_NE(terms_in_words(law_with<T>, Language::german), with_underscores(T::info.name));
    }
  });
}

TEST(Words, CallTheDecayRateAPartWhereOtherTermsChangeIt) {
  for (const char* law :
       {"viscous+drag", "viscous+friction", "viscous+cubic", "viscous+pendulum", "viscous+van-der-pol"})
    EXPECT_TRUE(is_viscous_part(law_of(law), "decay_rate")) << law;
  EXPECT_FALSE(is_viscous_part(law_of("viscous"), "decay_rate"));
  EXPECT_FALSE(is_viscous_part(law_of("viscous+drag"), "drag"));
}

TEST(Catalogue, NamesOnlyOptionsThatThereAre) {
  // What apps/cli and studies have beside the tables of the tasks.
  std::set<std::string> known{"output",       "plot",           "json",    "quiet",    "verbose",
                              "help",         "motion",         "fourier", "files",    "tripartite",
                              "static",       "mass-line",      "masses",  "gravity",  "resume",
                              "trajectories", "every",          "address", "points",   "frequency-from",
                              "frequency-to", "damping-ratios", "longest", "halvings", "port",
                              "page",         "panels",         "network"};
  const auto add = [&](auto options) {
    for (const Option& option : options_of(options)) known.emplace(option.name);
  };
  add(SimulateOptions{});
  add(OverOptions{});
  add(FitOptions{});
  add(CompareOptions{});
  add(ModesOptions{});
  add(RecogniseOptions{});
  add(SweepOptions{});
  add(SpectrumOptions{});
  add(RecordOptions{});
  for (const auto& part : catalogue())
    for (const Entry& entry : part)
      for (const std::string_view words : {entry.english, entry.german}) {
        for (const std::string& option : options_in(words))
          EXPECT_TRUE(known.count(option)) << entry.code << " names --" << option;
        // Of another program: srun --mpi=pmix.
        EXPECT_TRUE(std::string(words).find(" --") == std::string::npos || words.find("srun") != words.npos)
            << entry.code << ": write an option as {--name}";
      }
}

TEST(Catalogue, TellsThePageNothingOfOptions) {
  for (const auto& part : catalogue())
    for (const Entry& entry : part)
      for (const Voice& voice : {of_the_page, of_the_german_page}) {
        const std::string text = in_words(Notice{std::string(entry.code)}, voice);
        EXPECT_TRUE(text.find("--") == text.npos || text.find("srun") != text.npos) << text;
      }
}

/// One place where a notice or an Error is made: codes, and the names of its values.
struct Raised {
  std::string file;
  std::vector<std::string> codes;
  std::set<std::string> names;
};

/// Where the bracket that opens at `begin` closes.
std::size_t closing(const std::string& text, std::size_t begin) {
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (text[i] == '"')
      for (++i; text[i] != '"'; ++i) i += text[i] == '\\';
    else if (text[i] == '{' || text[i] == '(')
      ++depth;
    else if ((text[i] == '}' || text[i] == ')') && --depth == 0)
      return i;
  }
  return text.size();
}

std::vector<std::string> literals_in(const std::string& text) {
  std::vector<std::string> all;
  const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
  for (std::sregex_iterator found(text.begin(), text.end(), literal), end; found != end; ++found)
    if (!(*found)[1].str().empty()) all.push_back((*found)[1]);
  return all;
}

std::vector<std::filesystem::path> sources() {
  std::vector<std::filesystem::path> all;
  const std::filesystem::path root = CROMER_SOURCE_DIR;
  for (const char* folder : {"src/cromer", "apps/cli", "apps/serve", "apps/web/core"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::string path = entry.path().string();
      const bool source = path.ends_with(".cpp") || path.ends_with(".h");
      if (source && path.find("documents/words") == std::string::npos) all.push_back(entry.path());
    }
  return all;
}

std::vector<Raised> all_raised() {
  std::vector<Raised> all;
  const std::regex comment("//[^\n]*"), made(R"(\b(Notice|Error)\s*[{(])"),
      name(R"re(\{\s*"([a-z0-9_]+)"\s*,)re"), values(R"(,\s*\{)");
  for (const auto& path : sources()) {
    const std::string text = std::regex_replace(bytes_of(path), comment, "");
    for (std::sregex_iterator found(text.begin(), text.end(), made), end; found != end; ++found) {
      const auto open = static_cast<std::size_t>(found->position() + found->length() - 1);
      const std::string body = text.substr(open + 1, closing(text, open) - open - 1);
      // Error{Notice{...}, "argument"}: the notice is found by itself.
      if (body.starts_with("Notice") || body.starts_with("core::Notice")) continue;
      std::smatch begins;
      const std::string head = std::regex_search(body, begins, values)
                                   ? body.substr(0, static_cast<std::size_t>(begins.position()))
                                   : body;
      Raised raised{path.filename().string(), literals_in(head), {}};
      if (raised.codes.empty()) continue;
      for (std::sregex_iterator each(body.begin(), body.end(), name); each != end; ++each)
        raised.names.insert((*each)[1]);
      all.push_back(std::move(raised));
    }
  }
  return all;
}

TEST(Catalogue, HasASentenceForEverythingThatIsRaised) {
  const auto raised = all_raised();
  EXPECT_GT(raised.size(), 500u);
  for (const Raised& each : raised)
    for (const std::string& code : each.codes) {
      const Entry* entry = find_entry(code);
      ASSERT_TRUE(entry) << each.file << " raises \"" << code << "\", which is not in documents/words";
      for (const std::string& place : places_of(entry->english))
        EXPECT_TRUE(each.names.count(place))
            << each.file << " raises " << code << " without {" << place << "}";
    }
}

TEST(Catalogue, HasNothingThatNobodyRaises) {
  std::string all;
  for (const auto& path : sources()) all += bytes_of(path);
  for (const auto& part : catalogue())
    for (const Entry& entry : part)
      EXPECT_NE(all.find("\"" + std::string(entry.code) + "\""), std::string::npos) << entry.code;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
