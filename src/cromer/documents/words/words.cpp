#include "cromer/documents/words/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "cromer/base/ascii.h"
#include "cromer/base/length_unit.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

bool is_small(char c) { return c >= 'a' && c <= 'z'; }

std::string number_text(double value, std::string_view how) {
  if (how.size() < 3 || how.front() != '.') return shortest(value);
  int digits = 0;
  for (const char c : how.substr(1, how.size() - 2)) digits = 10 * digits + (c - '0');
  switch (how.back()) {
    case 'f':
      return fmt::format("{:.{}f}", value, digits);
    case 'e':
      return fmt::format("{:.{}e}", value, digits);
    default:
      // Not 5.1e+02 but 510.
      if (std::abs(value) >= std::pow(10, digits) && std::abs(value) < 1e6) {
        const double last = std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - digits);
        return fmt::format("{:.0f}", std::round(value / last) * last);
      }
      return fmt::format("{:.{}g}", value, digits);
  }
}

std::string joined(const std::vector<std::string>& parts, std::string_view between, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? last : between;
    text += parts[i];
  }
  return text;
}

std::string listed(const std::vector<std::string>& names, std::string_view how, Language language) {
  const bool german = language == Language::german;
  if (how == "and") return joined(names, ", ", german ? " und " : " and ");
  if (how == "or") return joined(names, ", ", german ? " oder " : " or ");
  return joined(names, ", ", ", ");
}

/// Titles of columns come in quotes.
std::vector<std::string> in_german_quotes(std::vector<std::string> names) {
  for (std::string& each : names)
    if (each.size() > 1 && each.front() == '"' && each.back() == '"')
      each = "„" + each.substr(1, each.size() - 2) + "“";
  return names;
}

std::string_view words_of(const Entry& entry, Language language) {
  return language == Language::german ? entry.german : entry.english;
}

/// Whether its first word is a value, as the name of a method or a column is: that is written as it is.
bool begins_with_name(const Notice& notice, Language language) {
  const Entry* entry = find_entry(notice.code);
  const std::string_view words = entry ? words_of(*entry, language) : std::string_view{};
  if (!words.starts_with('{')) return false;
  const std::string_view name = words.substr(1, words.find_first_of(":}") - 1);
  for (const NoticeValue& each : notice.values) {
    if (each.name != name) continue;
    if (const auto* parts = std::get_if<std::vector<Notice>>(&each.value))
      return !parts->empty() && begins_with_name(parts->front(), language);
    return true;
  }
  return false;
}

/// "row|rows": the first for one, the second otherwise.
std::string_view by_count(std::string_view words, double count) {
  const std::size_t bar = std::min(words.find('|'), words.size());
  return count == 1 ? words.substr(0, bar) : words.substr(std::min(bar + 1, words.size()));
}

/// Where the place ends that opens at `open`; alternatives hold others.
std::size_t closing(std::string_view words, std::size_t open) {
  std::size_t end = open;
  for (int depth = 0; end < words.size(); ++end) {
    depth += words[end] == '{' ? 1 : words[end] == '}' ? -1 : 0;
    if (depth == 0) break;
  }
  return end;
}

std::string option_for(Audience audience, std::string_view option, bool of_arrays) {
  switch (audience) {
    case Audience::command_line:
      return "--" + std::string(option);
    case Audience::caller:
      return argument_of(option, of_arrays);
    case Audience::page:
      break;
  }
  std::string words(option);
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

/// The bar of "program|page" that stands in no place of its own.
std::size_t bar_of(std::string_view both) {
  std::size_t at = 0;
  while (at < both.size() && both[at] != '|') at = both[at] == '{' ? closing(both, at) + 1 : at + 1;
  return std::min(at, both.size());
}

/// One sentence being made.
class Sentence {
 public:
  Sentence(const Notice& notice, const Voice& voice) : notice_(notice), voice_(voice) {}

  std::string made_of(std::string_view words) {
    add(words);
    return std::move(text_);
  }

 private:
  void add(std::string_view words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const char c = words[i];
      if ((c == '{' || c == '}') && words.substr(i + 1, 1) == words.substr(i, 1)) {
        text_ += c;
        ++i;
      } else if (c == '{') {
        const std::size_t end = closing(words, i);
        put(words.substr(i + 1, end - i - 1));
        i = end;
      } else {
        text_ += c;
      }
    }
  }

  const NoticeValue* find(std::string_view name) const {
    for (const NoticeValue& each : notice_.values)
      if (each.name == name) return &each;
    return nullptr;
  }

  void put(std::string_view place) {
    if (place.starts_with('|')) {
      place.remove_prefix(1);
      const std::size_t bar = bar_of(place);
      add(voice_.audience == Audience::page ? place.substr(std::min(bar + 1, place.size()))
                                            : place.substr(0, bar));
      return;
    }
    if (place.starts_with("--")) {
      put_option(place.substr(2));
      return;
    }
    const bool counts_lines = place.starts_with('@');
    if (counts_lines) {
      place.remove_prefix(1);
      text_ += voice_.language == Language::german ? (notice_.of_arrays ? "Messwert " : "Zeile ")
                                                   : (notice_.of_arrays ? "sample " : "line ");
    }
    const std::size_t end = std::min(place.find_first_of(":?"), place.size());
    const NoticeValue* value = find(place.substr(0, end));
    const bool alone = end < place.size() && place[end] == '?';
    const std::string_view how = end < place.size() ? place.substr(end + 1) : std::string_view{};
    if (!value) {
      text_ += '{' + std::string(place) + '}';
      return;
    }
    std::visit([&](const auto& held) { put_value(held, how, alone); }, value->value);
  }

  template <class Number>
  void put_number(Number number, const std::string& written, std::string_view how, bool alone) {
    if (!alone) text_ += with_comma(written, voice_.language);
    if (how.find('|') == how.npos) return;
    if (!alone) text_ += ' ';
    text_ += by_count(how, static_cast<double>(number));
  }

  void put_value(double number, std::string_view how, bool alone) {
    if (how == "length") {  // metres, in the unit that suits them
      const LengthUnit unit = length_unit(std::abs(number));
      text_ += with_comma(number_text(number / unit.metres, ".2g"), voice_.language) + ' ';
      text_ += unit.symbol;
      return;
    }
    put_number(number, number_text(number, how), how, alone);
  }
  void put_value(long long count, std::string_view how, bool alone) {
    put_number(count,
               how.starts_with('.') ? number_text(static_cast<double>(count), how) : fmt::format("{}", count),
               how, alone);
  }
  void put_option(std::string_view option) {
    text_ += option_for(voice_.audience, option, notice_.of_arrays);
  }
  void put_value(const std::string& text, std::string_view how, bool) {
    if (how == "option") return put_option(text);
    if (how == " " && !text.empty()) text_ += ' ';
    text_ += how == "n" ? with_comma(text, voice_.language) : text;
  }
  void put_value(const std::vector<std::string>& names, std::string_view how, bool alone) {
    if (how.find('|') != how.npos) return put_number(names.size(), "", how, alone);
    text_ +=
        listed(voice_.language == Language::german ? in_german_quotes(names) : names, how, voice_.language);
  }
  void put_value(const std::vector<Notice>& notices, std::string_view how, bool) {
    std::vector<std::string> sentences;
    for (Notice each : notices) {
      each.of_arrays = each.of_arrays || notice_.of_arrays;
      sentences.push_back(in_words(each, voice_));
    }
    if (how == "A" && !sentences.empty() && !sentences[0].empty() && is_small(sentences[0][0]) &&
        !begins_with_name(notices[0], voice_.language))
      sentences[0][0] = static_cast<char>(sentences[0][0] - 'a' + 'A');
    text_ += how.empty() || how == "A" ? joined(sentences, "; ", "; ")
                                       : listed(sentences, how == "," ? "" : how, voice_.language);
  }

  const Notice& notice_;
  const Voice& voice_;
  std::string text_;
};

}  // namespace

std::string with_comma(std::string text, Language language) {
  if (language == Language::german)
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
      if (text[i] == '.' && is_digit(text[i - 1]) && is_digit(text[i + 1])) text[i] = ',';
  return text;
}

std::string in_words(const Notice& notice, const Voice& voice) {
  const Entry* entry = find_entry(notice.code);
  if (!entry) return notice.code;
  return Sentence(notice, voice).made_of(words_of(*entry, voice.language));
}

std::string in_words(const Error& error, const Voice& voice) { return in_words(error.notice, voice); }

std::vector<std::string> in_words(std::span<const Notice> notices, const Voice& voice) {
  std::vector<std::string> sentences;
  for (const Notice& notice : notices) sentences.push_back(in_words(notice, voice));
  return sentences;
}

std::vector<Notice> worst_first(std::vector<Notice> notices) {
  std::stable_sort(notices.begin(), notices.end(),
                   [](const Notice& a, const Notice& b) { return severity(a) < severity(b); });
  return notices;
}

std::string argument_of(std::string_view option, bool of_arrays) {
  if (of_arrays && (option == "force-column" || option == "drive-file")) return "force";
  if (of_arrays && option == "base-motion") return "acceleration";
  return with_underscores(option);
}

std::string first_option(const Notice& notice) {
  const Entry* entry = find_entry(notice.code);
  if (!entry) return {};
  const std::string_view words = entry->english;
  if (words.starts_with("{--")) return std::string(words.substr(3, words.find('}') - 3));
  for (const NoticeValue& each : notice.values)
    if (const auto* option = std::get_if<std::string>(&each.value);
        option && words.starts_with("{" + each.name + ":option}"))
      return *option;
  // "{what}: ...": what the part begins with.
  for (const NoticeValue& each : notice.values)
    if (const auto* parts = std::get_if<std::vector<Notice>>(&each.value);
        parts && parts->size() == 1 && words.starts_with("{" + each.name + "}"))
      return first_option(parts->front());
  return {};
}

std::string as_one_word(std::string_view word) {
  if (!word.empty() && word.find_first_of(" \t\n\"'$*?;&|<>()`\\#~!{}[]") == word.npos)
    return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

std::string command_of(std::string_view command,
                       const std::vector<std::pair<std::string, std::string>>& options) {
  if (options.empty()) return "";
  std::string line = "cromer " + std::string(command);
  for (const auto& [option, value] : options)
    line += " --" + option + (value.empty() ? "" : " " + as_one_word(value));
  return line;
}

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::wrong_if_ignored:
      return "wrong_if_ignored";
    case Severity::worth_knowing:
      return "worth_knowing";
    case Severity::detail:
      break;
  }
  return "detail";
}

}  // namespace cromer::core

namespace cromer {

Severity severity(const Notice& notice) {
  const core::Entry* entry = core::find_entry(notice.code);
  if (!entry || entry->use == core::Use::error) return Severity::wrong_if_ignored;
  if (entry->use == core::Use::wrong_if_ignored) return Severity::wrong_if_ignored;
  if (entry->use == core::Use::worth_knowing) return Severity::worth_knowing;
  if (entry->use == core::Use::detail) return Severity::detail;
  // A clause around others weighs as much as the worst of them.
  Severity worst = Severity::detail;
  for (const NoticeValue& each : notice.values)
    if (const auto* parts = std::get_if<std::vector<Notice>>(&each.value))
      for (const Notice& part : *parts) worst = std::min(worst, severity(part));
  return worst;
}

std::string text(const Notice& notice, Language language) {
  return core::in_words(notice, {language, core::Audience::caller});
}

}  // namespace cromer
