#include "cromer/identify/law.h"

#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"

namespace cromer::core {
namespace {

// Of the terms that can be typed: all but the spring.
std::vector<std::string_view> typed_names() {
  std::vector<std::string_view> names;
  for_each_term([&]<class T>() {
    if (T::info.name != Spring::info.name) names.push_back(T::info.name);
  });
  return names;
}

Error unknown_term(std::string_view term) {
  if (term == "auto") return Error{"law_auto_in_sum"};
  std::vector<std::string_view> names = typed_names();
  names.push_back("auto");
  const std::string suggestion = nearest(term, names);
  const std::vector<std::string_view> typed = typed_names();
  return Error{suggestion.empty() ? "law_term_unknown" : "law_term_unknown_suggestion",
               {{"term", term},
                {"suggestion", suggestion},
                {"terms", std::vector<std::string>(typed.begin(), typed.end())}}};
}

}  // namespace

std::string law_names() {
  const std::vector<std::string_view> names = typed_names();
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + std::string(names[i]);
  return list;
}

Result<Law> parse_law(std::string_view text) {
  Law law;
  for (const std::string_view word : split(text, '+')) {
    const Law term =
        law_where([&](const TermInfo& info) { return info.name == word && word != Spring::info.name; });
    if (term == Law{}) return unknown_term(word);
    if (law.shares(term)) return Error{"law_term_twice", {{"term", word}}};
    law = law.with(term);
  }
  return law.shares(springs) ? law : law.with(law_with<Spring>);
}

std::string to_text(const Law& law) {
  std::string text;
  for_each_term([&]<class T>() {
    if (!law.has<T>() || T::info.name == Spring::info.name) return;
    if (!text.empty()) text += '+';
    text += T::info.name;
  });
  return text;
}

}  // namespace cromer::core
