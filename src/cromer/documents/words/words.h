// Notices and Errors in words: the one place where sentences are made.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cromer/notice.h"
#include "cromer/result.h"

namespace cromer::core {

/// Who is spoken to.
enum class Audience {
  command_line,  ///< "--drive-frequency"
  caller,        ///< "drive_frequency": of a library's arguments
  page,          ///< "drive frequency": of the lab in the browser, which has handles and buttons
};

struct Voice {
  Language language = Language::english;
  Audience audience = Audience::command_line;
};

/// A sentence, seldom two, without the last full stop. A code that is not in the catalogue is shown as it is.
std::string in_words(const Notice& notice, const Voice& voice = {});
std::string in_words(const Error& error, const Voice& voice = {});
std::vector<std::string> in_words(std::span<const Notice> notices, const Voice& voice = {});

/// German numbers have a decimal comma.
std::string with_comma(std::string text, Language language);

/// Worst first, otherwise in their order.
std::vector<Notice> worst_first(std::vector<Notice> notices);

/// "drive-frequency" becomes "drive_frequency". `of_arrays`: forces and motions are given as such, not in
/// columns or files.
std::string argument_of(std::string_view option, bool of_arrays = false);

/// The option that the sentence begins with, without its dashes; "" where it begins otherwise.
std::string first_option(const Notice& notice);

/// A word as a shell takes it: in single quotes where it would be taken apart.
std::string as_one_word(std::string_view word);

/// "cromer simulate --mass 1 --step 0.01": options with their values, or without one for a flag, as a command
/// of the program that a shell takes as it stands; "" without any.
std::string command_of(std::string_view command,
                       const std::vector<std::pair<std::string, std::string>>& options);

/// "wrong_if_ignored", "worth_knowing", "detail"
std::string_view name(Severity severity);

}  // namespace cromer::core
