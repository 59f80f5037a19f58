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

/// What a line is. A comment begins with # or %.
enum class LineKind { blank, comment, numbers, words, garbage };

struct DeviceLine {
  LineKind kind = LineKind::blank;
  std::vector<double> numbers{};     ///< of a line of numbers; NaN where one is missing
  std::vector<std::string> words{};  ///< of a line without numbers, which may be a heading
};

/// Fields end at commas, semicolons, tabs or blanks. Beside semicolons or tabs a comma is a decimal mark; a
/// lone `12,5` is two fields. An empty field, nan and null are missing values; a line of missing values only
/// is one of numbers. Numbers and words mixed, or bytes that are no text, are garbage.
DeviceLine read_line(std::string_view text);

/// A text as it is shown to people: at most `longest` characters and then "...", with "?" for all that is not
/// printable ASCII.
std::string shown(std::string_view text, std::size_t longest = 40);

struct LineSettings {
  double rate = 0;         ///< [1/s] of lines without a time; 0: found from their arrival
  double time_unit = 0;    ///< [s] of the device's times; 0: what its heading says, else 1
  std::string headings{};  ///< of the values, comma between; "": the device's own, else "Value"
};

/// The first line of numbers sets how many each line has: one number is a value, more are a time and values.
/// A line of words right before it is a heading if it has a name for each number, and a unit or several
/// names; `Time (ms)` scales the times. All else is garbage: it is counted, and reported with its text and
/// number (empty lines not counted). A device may be opened in the middle of a line. Its first line is taken
/// if the device was silent before it (not after a lost connection), or if its time has the form of the next
/// line's; else it is left out and reported. Without times and without a rate, lines are held back for a
/// while: ArrivalClock.
class LineReader {
 public:
  LineReader(LineSettings settings, bool may_begin_within_line)
      : settings_(std::move(settings)),
        clock_(settings_.rate),
        may_begin_within_line_(may_begin_within_line) {
    connected(0);
  }

  /// A connection was made, the first or a later one, at this time [s]: lines begin anew.
  void connected(double at);

  /// Adds the lines that the bytes complete to `rows` and `notices`; keeps the rest for the next call.
  void take(std::string_view bytes, double arrival, SampleRows& rows, std::vector<Remark>& notices);

  /// Adds what was held back long enough. Call it some times a second, even if nothing comes.
  void release(double now, SampleRows& rows, std::vector<Remark>& notices);
  /// Adds all that is held back.
  void release_all(SampleRows& rows, std::vector<Remark>& notices);

  /// The input has ended: a last line without its end is taken; after a lost connection it is dropped.
  void end(double arrival, SampleRows& rows, std::vector<Remark>& notices);
  void connection_lost(SampleRows& rows, std::vector<Remark>& notices);

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

  void take_any_line(std::string_view text, double arrival, SampleRows& rows, std::vector<Remark>& notices);
  void take_line(std::string_view text, double arrival, SampleRows& rows, std::vector<Remark>& notices);
  void judge_first(std::string_view next, SampleRows& rows, std::vector<Remark>& notices);
  double in_seconds(double device) const;
  void begin(std::size_t fields);
  void refuse(std::string_view text, long line, std::vector<Remark>& notices);
  void let_go(const std::vector<double>& times, SampleRows& rows);

  LineSettings settings_;
  Timekeeper clock_;
  ArrivalClock arrivals_;
  std::vector<double> held_;  ///< values that wait for their times
  bool may_begin_within_line_;
  double connected_ = 0;              // [s]
  bool lost_ = false;                 ///< after a lost connection the first bytes may be the rest of a line
  bool at_beginning_ = true;          ///< no line has come since the connection was made
  bool surely_whole_ = true;          ///< the next line is known to be whole
  std::optional<FirstLine> first_{};  ///< the first line, until the next one shows whether it is whole
  bool too_long_ = false;             ///< bytes up to the next line end belong to a line already refused
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
