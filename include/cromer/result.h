// A value, or the error that prevented it. Bad input travels as a Result, never as an exception.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <cromer/notice.h>

namespace cromer {

/// What went wrong and what to do about it.
struct Error {
  Notice notice;
  std::string
      argument{};  ///< the argument at fault, as its field is called: "step"; "" where it is not a single one

  Error(Notice what, std::string argument_at_fault = {})  // NOLINT: implicit on purpose
      : notice(std::move(what)), argument(std::move(argument_at_fault)) {}
  explicit Error(const char* code, std::initializer_list<NoticeValue> values = {}) : notice(code, values) {}

  /// A sentence that its reader can act on, without the last full stop. It names arguments as their fields
  /// are called.
  std::string message(Language language = Language::english) const { return text(notice, language); }
};

/// Holds a T or the Error that prevented it.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit on purpose
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Only when ok(); else std::get throws.
  T& value() & { return std::get<0>(content_); }
  const T& value() const& { return std::get<0>(content_); }
  T&& value() && { return std::get<0>(std::move(content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// Only when not ok(); else std::get throws.
  const Error& error() const { return std::get<1>(content_); }

 private:
  std::variant<T, Error> content_;
};

/// Success, or the Error that prevented it.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit on purpose

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const {
    assert(error_);
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace cromer
