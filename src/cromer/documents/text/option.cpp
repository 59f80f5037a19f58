#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

std::string option_text(const Option& option) {
  std::string text(option.help);
  // The other ranges stand in the option's own words.
  constexpr Range said[] = {Range::positive, Range::not_negative, Range::at_least_one, Range::fraction,
                            Range::air_temperature};
  if (std::find(std::begin(said), std::end(said), option.range) != std::end(said))
    text += fmt::format("; must {}", in_words(constraint(option.range)));
  if (!option.default_text.empty()) text += fmt::format(" [{}]", option.default_text);
  return text;
}

}  // namespace cromer::core
