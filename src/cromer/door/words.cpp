#include "cromer/door/words.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

namespace cromer::core {
namespace {

/// Whether the notice is about a column of that name; where arrays were given, the column is one of them.
bool is_about(const Notice& notice, std::string_view array) {
  return std::any_of(notice.values.begin(), notice.values.end(), [&](const NoticeValue& each) {
    if (const auto* parts = std::get_if<std::vector<Notice>>(&each.value))
      return std::any_of(parts->begin(), parts->end(),
                         [&](const Notice& part) { return is_about(part, array); });
    const auto* text = std::get_if<std::string>(&each.value);
    return text && (each.name == "column" || each.name == "force") && text->starts_with(array);
  });
}

}  // namespace

Notice in_arguments(Notice notice, bool of_arrays) {
  notice.of_arrays = notice.of_arrays || of_arrays;
  return notice;
}

std::vector<Notice> in_arguments(std::vector<Notice> notices, bool of_arrays) {
  for (Notice& notice : notices) notice = in_arguments(std::move(notice), of_arrays);
  return notices;
}

Error in_arguments(Error error, bool of_arrays) {
  error.notice = in_arguments(std::move(error.notice), of_arrays);
  if (!error.argument.empty()) return error;
  error.argument = argument_of(first_option(error.notice), error.notice.of_arrays);
  for (const std::string_view array : {"force", "y"})
    if (error.notice.of_arrays && error.argument.empty() && is_about(error.notice, array))
      error.argument = array;
  return error;
}

std::string message_of(const Notice& notice) { return in_words(notice, Voice{.audience = Audience::caller}); }

}  // namespace cromer::core
