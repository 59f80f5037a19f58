// A phone that runs the app phyphox with remote access allowed: what it says over HTTP, and a source of that.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/live/http_client.h"
#include "cromer/live/rows.h"
#include "cromer/live/source.h"
#include "cromer/live/timekeeper.h"
#include "cromer/result.h"

namespace cromer::core {

/// The buffers to record: a time and the values measured at it.
struct PhyphoxSet {
  std::string experiment;            ///< its title
  std::vector<std::string> buffers;  ///< the time's first
  Headings headings;                 ///< of each: "Time (s)", "Linear Acceleration x (m/s^2)", ...
};

/// From the answer to /config: the first exported set with a time, else the first sensor with one. An
/// experiment without a time is an Error that names it.
Result<PhyphoxSet> read_phyphox_config(std::string_view json);

/// "/get?t=full&y=full", or with `after` [s] only what came later: "/get?t=12.5&y=12.5|t".
std::string phyphox_query(const PhyphoxSet& set, std::optional<double> after);

struct PhyphoxAnswer {
  SampleRows rows;         ///< all values, NaN where the phone says null; rows without a time are left out
  std::size_t uneven = 0;  ///< values at the ends of longer buffers, which have no partner yet
  bool measuring = false;
};

/// From the answer to phyphox_query. Buffers that are filled while they are read are cut to the shortest; a
/// missing buffer and text that is no answer are Errors.
Result<PhyphoxAnswer> read_phyphox_answer(std::string_view json, const PhyphoxSet& set);

/// Asks for new samples ten times a second. Starts the measurement if the phone is not measuring, with a
/// notice, and leaves it running at the end: the phone's owner may want it. What the phone held in its
/// buffers before is not recorded.
class PhyphoxSource final : public Source {
 public:
  PhyphoxSource(std::string host, int port)
      : name_(host + ":" + std::to_string(port)), client_(std::move(host), port) {}

  Result<void> open() override;
  bool receive(double seconds, SampleRows& rows, std::vector<Remark>& notices) override;
  const Headings& headings() const override { return set_.headings; }

 private:
  Result<PhyphoxAnswer> ask();
  void take(const PhyphoxAnswer& answer, SampleRows& rows, std::vector<Remark>& notices);
  bool clock_began_anew();

  std::string name_;
  HttpClient client_;
  PhyphoxSet set_;
  std::vector<Remark> opening_;  ///< to be told with the first rows
  std::optional<double> after_;  ///< [s] the phone's time of the last sample
  Timekeeper clock_;
  bool measuring_ = false, reachable_ = true;
  double asked_at_ = 0, new_at_ = 0, lost_at_ = 0;  // [s]
};

}  // namespace cromer::core
