#include "message.h"

#include <algorithm>
#include <cstdio>

#include "commands.h"
#include "cromer/base/utf8.h"
#include "cromer/documents/words/words.h"
#include "cromer/os/process.h"

namespace cromer::core::cli {
namespace {

bool silent = false;

constexpr std::string_view begin = "cromer: ";

/// Broken at blanks into lines of that width, with what begins a message before the first and blanks before
/// the others; as it is where the width is too small, or 0.
std::string wrapped(const std::string& text, std::size_t width) {
  constexpr std::size_t narrowest = 30;
  if (width < narrowest) return text;
  const std::size_t room = width - begin.size();
  std::string out;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = std::string_view(text).substr(at, end - at);
    const auto letters = static_cast<std::size_t>(
        std::count_if(word.begin(), word.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    if (column > 0 && column + 1 + letters > room) {
      out += '\n' + std::string(begin.size(), ' ');
      column = 0;
    } else if (at > 0) {
      out += ' ';
      ++column;
    }
    out += word;
    column += letters;
    at = end + 1;
  }
  return out;
}

}  // namespace

void fall_silent() {
  silent = true;
  os::discard_standard_output();
}

void complain(std::string_view message) {
  if (silent) return;
  std::fprintf(stderr, "%s%s\n", begin.data(), printable(message).c_str());
}

void complain(const Error& error) { complain(in_words(error)); }

int refuse(std::string_view message) {
  complain(message);
  return wrong_input;
}

int refuse(const Error& error) { return refuse(in_words(error)); }

void tell(const std::vector<Notice>& notices, bool all) {
  const std::size_t width = os::terminal_width();
  constexpr std::size_t most = 3;
  const std::size_t shown = all || width == 0 || notices.size() <= most + 1 ? notices.size() : most;
  const std::vector<Notice> sorted = worst_first(notices);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string_view kind = severity(sorted[i]) == Severity::detail ? "note: " : "warning: ";
    complain(wrapped(std::string(kind) + in_words(sorted[i]), width));
  }
  if (shown < sorted.size())
    complain(wrapped(std::to_string(sorted.size() - shown) + " more notices; --verbose shows them", width));
}

}  // namespace cromer::core::cli
