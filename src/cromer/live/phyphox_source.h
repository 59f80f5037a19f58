// A phone that runs phyphox with remote access allowed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cromer/live/http_client.h"
#include "cromer/live/phyphox.h"
#include "cromer/live/source.h"
#include "cromer/live/timekeeper.h"

namespace cromer::core {

/// Asks ten times a second for what is new. Starts the measurement if the phone is not measuring, and says
/// so; it is left running at the end, since the phone's owner may want it. What the phone's buffers held
/// before is not recorded.
class PhyphoxSource final : public Source {
 public:
  PhyphoxSource(std::string host, int port)
      : name_(host + ":" + std::to_string(port)), client_(std::move(host), port) {}

  Result<void> open() override;
  bool receive(double seconds, Rows& rows, std::vector<Remark>& notices) override;
  const Headings& headings() const override { return set_.headings; }

 private:
  Result<PhyphoxAnswer> ask();
  void take(const PhyphoxAnswer& answer, Rows& rows, std::vector<Remark>& notices);
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
