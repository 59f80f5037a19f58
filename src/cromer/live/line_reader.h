// From the bytes of a device that writes `time value` or `value` lines to rows. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/live/arrival_clock.h"
#include "cromer/live/rows.h"
#include "cromer/live/timekeeper.h"
#include "cromer/result.h"

namespace cromer::core {

/// What a line turned out to be. A comment begins with # or %.
enum class LineKind { blank, comment, numbers, words, garbage };

struct Line {
  LineKind kind = LineKind::blank;
  std::vector<double> numbers{};     ///< of a line of numbers; NaN where one is missing
  std::vector<std::string> words{};  ///< of a line without any number: what may be a heading
};

/// Fields end at commas, semicolons, tabs or blanks. Beside semicolons or tabs a comma is a decimal mark; a
/// lone `12,5` is two fields. An empty field, nan and null are missing values; a line of missing values only
/// is one of numbers. Numbers and words mixed, or bytes that are no text, are garbage.
Line read_line(std::string_view text);

/// Text fit to be shown to a person: at most `longest` characters and then "...", what is not printable ASCII
/// as "?".
std::string shown(std::string_view text, std::size_t longest = 40);

struct LineSettings {
  double rate = 0;         ///< [1/s] of lines without a time; 0: found from their arrival
  double time_unit = 0;    ///< [s] of the device's times; 0: what its heading says, else 1
  std::string headings{};  ///< of the values, comma between; "": the device's own, else "Value"
};

/// The first line of numbers says how many there are in each; one number is a value, more are a time and
/// values. A line of words right before it is a heading if it has a name for each number and states a unit or
/// more than one name; `Time (ms)` scales the times. All else is garbage: counted, reported with its number
/// (of the lines that are not empty) and text. A device may be opened in the middle of a line. Its first line
/// is taken if the device was silent before it (not after a lost connection), or if its time has the form of
/// the next line's; else it is left out and reported. Lines without a time, where no rate is given, are held
/// back for a while: ArrivalClock.
class LineReader {
 public:
  LineReader(LineSettings settings, bool may_begin_within_line)
      : settings_(std::move(settings)),
        clock_(settings_.rate),
        may_begin_within_line_(may_begin_within_line) {
    connected(0);
  }

  /// A connection has been made, the first or another, at this time [s]: what comes begins anew.
  void connected(double at);

  /// Adds what the bytes complete to `rows` and `notices`; the rest is kept for the next time.
  void take(std::string_view bytes, double arrival, Rows& rows, std::vector<Remark>& notices);

  /// Adds what has been held back long enough; to be called some times a second, whether anything comes or
  /// not.
  void release(double now, Rows& rows, std::vector<Remark>& notices);
  /// Adds all that is held back: nothing more will come, or be waited for.
  void release_all(Rows& rows, std::vector<Remark>& notices);

  /// The input has ended: a last line without its end is taken, or after a lost connection dropped.
  void end(double arrival, Rows& rows, std::vector<Remark>& notices);
  void connection_lost(Rows& rows, std::vector<Remark>& notices);

  /// Empty until the first row.
  const Headings& headings() const { return headings_; }
  std::size_t garbage() const { return garbage_; }
  double pace() const { return timed_ ? clock_.pace() : 0; }
  SampleTimes times() const;

 private:
  struct FirstLine {
    std::string text;
    double arrival;  // [s]
  };

  void take_any_line(std::string_view text, double arrival, Rows& rows, std::vector<Remark>& notices);
  void take_line(std::string_view text, double arrival, Rows& rows, std::vector<Remark>& notices);
  void judge_first(std::string_view next, Rows& rows, std::vector<Remark>& notices);
  double in_seconds(double device) const;
  void begin(std::size_t fields);
  void refuse(std::string_view text, long line, std::vector<Remark>& notices);
  void let_go(const std::vector<double>& times, Rows& rows);

  LineSettings settings_;
  Timekeeper clock_;
  ArrivalClock arrivals_;
  std::vector<double> held_;  ///< values that wait for their times
  bool may_begin_within_line_;
  double connected_ = 0;              // [s]
  bool lost_ = false;                 ///< a connection was lost: what comes first may be the rest of a line
  bool at_beginning_ = true;          ///< no line has come since the connection was made
  bool surely_whole_ = true;          ///< the next line is known to be whole
  std::optional<FirstLine> first_{};  ///< the first line, until the next one shows whether it is whole
  bool too_long_ = false;  ///< what comes up to the next line's end is part of a line already refused
  std::string partial_;
  long line_ = 0;
  std::size_t fields_ = 0;  ///< 0 until the first line of numbers
  bool timed_ = false;
  double to_seconds_ = 1;
  std::size_t garbage_ = 0;
  std::vector<std::string> heading_;  ///< the last line of words before the first numbers
  std::string heading_text_;
  long heading_line_ = 0;
  Headings headings_;
};

}  // namespace cromer::core
