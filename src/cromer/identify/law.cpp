#include "cromer/identify/law.h"

#include <array>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"

namespace cromer {
namespace {

struct Term {
  std::string_view name;
  bool Law::*member;
};

constexpr std::array<Term, 5> terms{{{"viscous", &Law::viscous},
                                     {"drag", &Law::drag},
                                     {"friction", &Law::friction},
                                     {"cubic", &Law::cubic},
                                     {"pendulum", &Law::pendulum}}};

Error unknown_term(std::string_view term) {
  constexpr std::array<std::string_view, 6> names{"viscous", "drag", "friction", "cubic", "pendulum", "auto"};
  const std::string suggestion = nearest(term, names);
  std::string message = "--law: \"" + std::string(term) + "\" is not a term";
  message += suggestion.empty() ? "." : "; did you mean " + suggestion + "?";
  return Error{message + " A law is auto, or a sum of viscous, drag, friction, cubic and pendulum"};
}

}  // namespace

Result<Law> parse_law(std::string_view text) {
  Law law{.viscous = false};
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find('+', begin);
    const std::string_view word =
        trimmed(text.substr(begin, end == std::string_view::npos ? end : end - begin));
    const Term* found = nullptr;
    for (const Term& term : terms)
      if (term.name == word) found = &term;
    if (!found) return unknown_term(word);
    if (law.*(found->member)) return Error{"--law: the term " + std::string(word) + " is named twice"};
    law.*(found->member) = true;
    if (end == std::string_view::npos) return law;
    begin = end + 1;
  }
}

std::string to_text(const Law& law) {
  std::string text;
  for (const Term& term : terms) {
    if (!(law.*term.member)) continue;
    if (!text.empty()) text += '+';
    text += term.name;
  }
  return text;
}

}  // namespace cromer
