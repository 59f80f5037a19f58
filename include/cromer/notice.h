// What there is to say beside the numbers: data, from which text() makes a sentence.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <cromer/export.h>

namespace cromer {

enum class Language { english, german };

/// How much a notice matters.
enum class Severity {
  wrong_if_ignored,  ///< a number does not mean what it seems to mean
  worth_knowing,     ///< how far the numbers go, and what was assumed
  detail,            ///< what was done on the way
};

struct NoticeValue;

/// One thing to say: a code that stays the same from version to version, and what stands in its sentence.
struct Notice {
  std::string code;  ///< "unit_assumed"; "" where there is nothing to say
  std::vector<NoticeValue> values;
  bool of_arrays = false;  ///< about arrays: places are samples, not lines of a file

  Notice();
  Notice(std::string code);  // NOLINT: implicit on purpose
  Notice(const char* code, std::initializer_list<NoticeValue> values);
  bool empty() const { return code.empty(); }
  friend bool operator==(const Notice&, const Notice&);
};

/// A number in SI units, a count, a name as the file or its user wrote it, several names, or a part that
/// is a notice itself.
struct NoticeValue {
  std::string name;  ///< "column"
  std::variant<double, long long, std::string, std::vector<std::string>, std::vector<Notice>> value;

  template <std::floating_point Number>
  NoticeValue(const char* value_name, Number number) : name(value_name), value(double{number}) {}
  template <std::integral Count>
  NoticeValue(const char* value_name, Count count) : name(value_name), value(static_cast<long long>(count)) {}
  template <std::convertible_to<std::string_view> Text>
  NoticeValue(const char* value_name, const Text& text)
      : name(value_name), value(std::string(std::string_view(text))) {}
  NoticeValue(const char* value_name, std::vector<std::string> names)
      : name(value_name), value(std::move(names)) {}
  NoticeValue(const char* value_name, Notice notice)
      : name(value_name), value(std::vector<Notice>{std::move(notice)}) {}
  NoticeValue(const char* value_name, std::vector<Notice> notices)
      : name(value_name), value(std::move(notices)) {}
  friend bool operator==(const NoticeValue&, const NoticeValue&) = default;
};

inline Notice::Notice() = default;
inline Notice::Notice(std::string notice_code) : code(std::move(notice_code)) {}
inline Notice::Notice(const char* notice_code, std::initializer_list<NoticeValue> notice_values)
    : code(notice_code), values(notice_values) {}
inline bool operator==(const Notice& a, const Notice& b) {
  return a.code == b.code && a.values == b.values && a.of_arrays == b.of_arrays;
}

/// Of an Error's notice, and of a code that is not known: wrong_if_ignored.
CROMER_API Severity severity(const Notice& notice);

/// A sentence for people, seldom two, without the last full stop. It names arguments as their fields are
/// called.
CROMER_API std::string text(const Notice& notice, Language language = Language::english);

}  // namespace cromer
