#include "cromer/live/phyphox_source.h"

#include <chrono>
#include <thread>

namespace cromer::core {
namespace {

constexpr double between_questions = 0.1;  // [s]
constexpr double patience = 3;             // [s] for one answer
constexpr double quiet_time = 1;           // [s] without a sample before the phone's clock is asked for

}  // namespace

Result<PhyphoxAnswer> PhyphoxSource::ask() {
  asked_at_ = steady_seconds();
  const auto text = client_.get(phyphox_query(set_, after_), patience);
  if (!text) return text.error();
  return read_phyphox_answer(*text, set_);
}

Result<void> PhyphoxSource::open() {
  const auto failed = [&](const Error& error) {
    return Error{"phyphox_failed", {{"address", name_}, {"what", error.notice}}};
  };
  const auto config = client_.get("/config", patience);
  if (!config) return failed(config.error());
  auto set = read_phyphox_config(*config);
  if (!set) return failed(set.error());
  set_ = *std::move(set);
  const auto before = ask();
  if (!before) return failed(before.error());
  // Where it goes on, also when it is started: the phone keeps its old samples, and its times go on from
  // them.
  if (before->rows.size() > 0) after_ = before->rows.t.back();
  if (!before->measuring) {
    if (const auto started = client_.get("/control?cmd=start", patience); !started)
      return failed(started.error());
    opening_.push_back({RemarkKind::device, Notice{"phyphox_started", {{"experiment", set_.experiment}}}});
  }
  measuring_ = true;
  new_at_ = steady_seconds();
  return {};
}

void PhyphoxSource::take(const PhyphoxAnswer& answer, Rows& rows, std::vector<Remark>& notices) {
  const double arrival = steady_seconds();
  for (std::size_t i = 0; i < answer.rows.size(); ++i) {
    const double t = answer.rows.t[i];
    // Sent again where the phone rounds the times that it writes.
    if (after_ && t <= *after_) continue;
    after_ = t;
    const Stamp stamp = clock_.of_device(t, arrival);
    if (stamp.notice) notices.push_back(*stamp.notice);
    rows.add(stamp.t, answer.rows.row(i));
    new_at_ = arrival;
  }
}

// After "clear" the phone's times begin at 0, and nothing is later than the last one.
bool PhyphoxSource::clock_began_anew() {
  if (!after_) return false;
  PhyphoxSet only_time{"", {set_.buffers.front()}, {}};
  const auto text = client_.get(phyphox_query(only_time, std::nullopt), patience);
  if (!text) return false;
  const auto held = read_phyphox_answer(*text, only_time);
  return held && (held->rows.size() == 0 || held->rows.t.back() < *after_);
}

bool PhyphoxSource::receive(double seconds, Rows& rows, std::vector<Remark>& notices) {
  rows.width = set_.buffers.size() - 1;
  notices.insert(notices.end(), opening_.begin(), opening_.end());
  opening_.clear();
  const double wait = std::min(seconds, asked_at_ + between_questions - steady_seconds());
  if (wait > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait));
  const auto answer = ask();
  if (!answer) {
    if (reachable_) {
      lost_at_ = steady_seconds();
      notices.push_back(
          {RemarkKind::connection,
           Notice{"phyphox_does_not_answer", {{"address", name_}, {"what", answer.error().notice}}}});
    } else {
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    }
    reachable_ = false;
    return true;
  }
  if (!reachable_)
    notices.push_back(
        {RemarkKind::connection,
         Notice{"phyphox_is_back", {{"address", name_}, {"duration", steady_seconds() - lost_at_}}}});
  reachable_ = true;
  take(*answer, rows, notices);
  if (answer->measuring != measuring_) {
    measuring_ = answer->measuring;
    notices.push_back(
        {RemarkKind::device, Notice{measuring_ ? "phyphox_measures_again" : "phyphox_stopped"}});
  }
  if (measuring_ && steady_seconds() - new_at_ > quiet_time) {
    if (clock_began_anew()) {
      after_.reset();  // what follows has times that jump back, which the clock is there for
      notices.push_back({RemarkKind::device, Notice{"phyphox_cleared"}});
    }
    new_at_ = steady_seconds();
  }
  return true;
}

}  // namespace cromer::core
