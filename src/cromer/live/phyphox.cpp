#include "cromer/live/phyphox.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "cromer/base/ascii.h"
#include "cromer/base/quantity.h"
#include "cromer/live/rows.h"

namespace cromer::core {
namespace {

using Json = nlohmann::json;

constexpr int deepest = 64;

/// A discarded value if the text is no JSON, or JSON of absurd depth.
Json parsed(std::string_view text) {
  return Json::parse(
      text, [](int depth, Json::parse_event_t, Json&) { return depth < deepest; }, false);
}

std::string text_at(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

const Json& list_at(const Json& object, const char* key) {
  static const Json none = Json::array();
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_array() ? *found : none;
}

bool is_time(std::string_view label) {
  const std::string name = lower(label);
  return name.starts_with("time") || name.starts_with("t (s)") || name.starts_with("zeit");
}

/// The buffers of one exported set.
PhyphoxSet exported(const Json& set) {
  PhyphoxSet found;
  for (const Json& source : list_at(set, "sources")) {
    const std::string label = text_at(source, "label"), buffer = text_at(source, "buffer");
    if (buffer.empty()) continue;
    const bool time = is_time(label);
    if (time && !found.buffers.empty() && is_time(found.headings.front())) continue;
    const auto at = [time](auto& list) { return time ? list.begin() : list.end(); };
    found.buffers.insert(at(found.buffers), buffer);
    found.headings.insert(at(found.headings), label);
  }
  if (found.buffers.size() < 2 || !is_time(found.headings.front())) return {};
  found.headings.front() = "Time (s)";
  return found;
}

/// The buffers of a sensor: {"source": "accelerometer", "outputs": [{"x": "accX"}, ..., {"t": "acc_time"}]}
PhyphoxSet sensed(const Json& input) {
  PhyphoxSet found;
  std::string time;
  for (const Json& output : list_at(input, "outputs")) {
    if (!output.is_object()) continue;
    for (const auto& [component, buffer] : output.items()) {
      if (!buffer.is_string()) continue;
      if (component == "t") {
        time = buffer.get<std::string>();
      } else {
        found.buffers.push_back(buffer.get<std::string>());
        found.headings.push_back(text_at(input, "source") + " " + component);
      }
    }
  }
  if (time.empty() || found.buffers.empty()) return {};
  found.buffers.insert(found.buffers.begin(), time);
  found.headings.insert(found.headings.begin(), "Time (s)");
  return found;
}

std::string percent_encoded(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool plain =
        is_digit(c) || (lower(c) >= 'a' && lower(c) <= 'z') || c == '_' || c == '-' || c == '.';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

}  // namespace

Result<PhyphoxSet> read_phyphox_config(std::string_view json) {
  const Json config = parsed(json);
  if (!config.is_object()) return Error{"phyphox_config_unreadable"};
  PhyphoxSet found;
  for (const Json& set : list_at(config, "export"))
    if (found.buffers.empty()) found = exported(set);
  for (const Json& input : list_at(config, "inputs"))
    if (found.buffers.empty()) found = sensed(input);
  const std::string title = text_at(config, "title");
  if (found.buffers.empty()) return Error{"phyphox_experiment_without_times", {{"experiment", title}}};
  found.experiment = title;
  for (auto& heading : found.headings) heading = plain_heading(std::move(heading));
  return found;
}

std::string phyphox_query(const PhyphoxSet& set, std::optional<double> after) {
  std::string query = "/get?";
  const std::string time = percent_encoded(set.buffers.front());
  for (std::size_t i = 0; i < set.buffers.size(); ++i) {
    if (i > 0) query += '&';
    query += percent_encoded(set.buffers[i]) + "=" + (after ? shortest(*after) : "full");
    if (after && i > 0) query += "%7C" + time;
  }
  return query;
}

Result<PhyphoxAnswer> read_phyphox_answer(std::string_view json, const PhyphoxSet& set) {
  const Json document = parsed(json);
  if (!document.is_object() || !document.contains("buffer") || !document["buffer"].is_object())
    return Error{"phyphox_answer_unreadable"};
  const Json& held = document["buffer"];
  std::vector<const Json*> columns;
  std::size_t rows = std::numeric_limits<std::size_t>::max(), longest = 0;
  for (const auto& name : set.buffers) {
    const auto found = held.find(name);
    if (found == held.end()) return Error{"phyphox_buffer_gone", {{"buffer", name}}};
    columns.push_back(&list_at(*found, "buffer"));
    rows = std::min(rows, columns.back()->size());
    longest = std::max(longest, columns.back()->size());
  }
  PhyphoxAnswer answer;
  answer.uneven = longest - rows;
  answer.rows.width = columns.size() - 1;
  const auto number = [](const Json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<double> values(answer.rows.width);
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = number((*columns.front())[i]);
    if (!(t == t)) continue;
    for (std::size_t c = 0; c < values.size(); ++c) values[c] = number((*columns[c + 1])[i]);
    answer.rows.add(t, values);
  }
  const auto status = document.find("status");
  if (status != document.end() && status->is_object()) {
    const auto measuring = status->find("measuring");
    answer.measuring = measuring != status->end() && measuring->is_boolean() && measuring->get<bool>();
  }
  return answer;
}

namespace {

constexpr double between_questions = 0.1;  // [s]
constexpr double answer_timeout = 3;       // [s]
constexpr double quiet_time = 1;           // [s] without a sample before the phone's clock is asked for

}  // namespace

Result<PhyphoxAnswer> PhyphoxSource::ask() {
  asked_at_ = steady_seconds();
  const auto text = client_.get(phyphox_query(set_, after_), answer_timeout);
  if (!text) return text.error();
  return read_phyphox_answer(*text, set_);
}

Result<void> PhyphoxSource::open() {
  const auto failed = [&](const Error& error) {
    return Error{"phyphox_failed", {{"address", name_}, {"what", error.notice}}};
  };
  const auto config = client_.get("/config", answer_timeout);
  if (!config) return failed(config.error());
  auto set = read_phyphox_config(*config);
  if (!set) return failed(set.error());
  set_ = *std::move(set);
  const auto before = ask();
  if (!before) return failed(before.error());
  // Recording begins behind the phone's last sample, even if it is started here: it keeps its old samples,
  // and its times go on from them.
  if (before->rows.size() > 0) after_ = before->rows.t.back();
  if (!before->measuring) {
    if (const auto started = client_.get("/control?cmd=start", answer_timeout); !started)
      return failed(started.error());
    opening_.push_back({RemarkKind::device, Notice{"phyphox_started", {{"experiment", set_.experiment}}}});
  }
  measuring_ = true;
  new_at_ = steady_seconds();
  return {};
}

void PhyphoxSource::take(const PhyphoxAnswer& answer, SampleRows& rows, std::vector<Remark>& notices) {
  const double arrival = steady_seconds();
  for (std::size_t i = 0; i < answer.rows.size(); ++i) {
    const double t = answer.rows.t[i];
    // The phone sends a sample again if it rounds the times that it writes.
    if (after_ && t <= *after_) continue;
    after_ = t;
    const Stamp stamp = clock_.of_device(t, arrival);
    if (stamp.notice) notices.push_back(*stamp.notice);
    rows.add(stamp.t, answer.rows.row(i));
    new_at_ = arrival;
  }
}

// After "clear" the phone's times begin at 0, and no sample is later than the last one recorded.
bool PhyphoxSource::clock_began_anew() {
  if (!after_) return false;
  PhyphoxSet only_time{"", {set_.buffers.front()}, {}};
  const auto text = client_.get(phyphox_query(only_time, std::nullopt), answer_timeout);
  if (!text) return false;
  const auto held = read_phyphox_answer(*text, only_time);
  return held && (held->rows.size() == 0 || held->rows.t.back() < *after_);
}

bool PhyphoxSource::receive(double seconds, SampleRows& rows, std::vector<Remark>& notices) {
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
