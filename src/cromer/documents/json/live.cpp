#include "cromer/documents/json/live.h"

#include "cromer/documents/json/described.h"
#include "cromer/documents/json/json.h"

namespace cromer::core {
namespace {

constexpr bool on_one_line = true;
constexpr Voice german{Language::german};
constexpr Voice on_page{Language::english, Audience::page}, on_german_page{Language::german, Audience::page};

std::string_view kind_name(RemarkKind kind) {
  switch (kind) {
    case RemarkKind::garbage:
      return "garbage";
    case RemarkKind::clock:
      return "clock";
    case RemarkKind::gap:
      return "gap";
    case RemarkKind::connection:
      return "connection";
    case RemarkKind::device:
      return "device";
    case RemarkKind::option:
      break;
  }
  return "option";
}

/// In both languages: the page shows the one it is in.
void add_message(Json& object, const Notice& message, const Voice& in_english, const Voice& in_german) {
  object["message"] = in_words(message, in_english);
  object["message_german"] = in_words(message, in_german);
}

Json times_object(const SampleTimes& times) {
  if (times.by == TimesBy::nothing) return nullptr;
  Json object{{"by", name(times.by)}};
  if (times.by_rate + times.by_arrival > 0) {
    object["rate"] = described::value_json(unless_zero(times.rate), {});
    object["longest_delay"] = times.longest_delay;
    object["by_rate"] = times.by_rate;
    object["by_arrival"] = times.by_arrival;
  }
  return object;
}

Json status_object(const std::string& recording, const RecorderStatus& status, const Headings& headings) {
  Json object{{"recording", described::value_json(unless_empty(recording), {})},
              {"running", status.running},
              {"samples", status.samples},
              {"from", status.begin},
              {"to", status.end},
              {"duration", status.end - status.begin},
              {"rate", described::value_json(unless_zero(status.rate), {})},
              {"times", times_object(status.times)},
              {"last", status.last},
              {"garbage", status.garbage},
              {"columns", headings}};
  if (!status.failure.empty()) add_message(object, status.failure, {}, german);
  return object;
}

Json notices_of(std::span<const Remark> notices) {
  Json list = Json::array();
  for (const Remark& notice : notices)
    list.push_back({{"kind", kind_name(notice.kind)},
                    {"text", in_words(notice.what)},
                    {"german", in_words(notice.what, german)}});
  return list;
}

}  // namespace

std::string live_status_json(const std::string& source, std::optional<double> duration,
                             const std::string& recording, const RecorderStatus& status,
                             const Headings& headings) {
  Json object{{"source", described::value_json(unless_empty(source), {})},
              {"for", described::value_json(duration, {})}};
  object.update(status_object(recording, status, headings));
  return to_text(object, on_one_line);
}

std::string live_samples_json(std::size_t first, const SampleRows& rows) {
  Json values = Json::array();
  for (std::size_t c = 0; c < rows.width; ++c) {
    Json column = Json::array();
    for (std::size_t i = 0; i < rows.size(); ++i) column.push_back(rows.row(i)[c]);
    values.push_back(std::move(column));
  }
  return to_text(Json{{"first", first}, {"t", rows.t}, {"values", std::move(values)}}, on_one_line);
}

std::string live_fit_json(const FittedRecording& fitted) {
  Json object{
      {"column", fitted.series.column}, {"status", fitted.status()}, {"samples", fitted.series.t.size()}};
  if (!fitted.series.t.empty())
    object["from"] = fitted.series.t.front(), object["to"] = fitted.series.t.back();
  if (fitted.succeeded()) {
    object["law"] = to_text(fitted.fit.law);
    object["coefficients"] = coefficient_names(fitted.fit.law, fitted.parameters);
    object["parameters"] = described::value_json(fitted.parameters, {});
    object["derived"] = described::value_json(fitted.derived, {});
  } else {
    add_message(object, fitted.fit.message, on_page, on_german_page);
  }
  return to_text(object, on_one_line);
}

std::string live_notices_json(std::span<const Remark> notices) {
  return to_text(Json{{"notices", notices_of(notices)}}, on_one_line);
}

std::string recording_json(const std::string& recording, const RecorderStatus& status,
                           const Headings& headings, std::span<const Remark> notices) {
  Json object = status_object(recording, status, headings);
  object["notices"] = notices_of(notices);
  return to_text(object);
}

std::string message_json(const std::string& message) {
  return to_text(Json{{"message", message}}, on_one_line);
}

}  // namespace cromer::core
