#include "cromer/documents/json/json.h"

#include <utility>
#include <variant>

namespace cromer::core {
namespace {

Json values_object(const Notice& notice);

Json value_of(const std::vector<Notice>& parts) {
  const auto part = [](const Notice& notice) {
    return Json{{"code", notice.code}, {"values", values_object(notice)}};
  };
  if (parts.size() == 1) return part(parts.front());
  Json list = Json::array();
  for (const Notice& each : parts) list.push_back(part(each));
  return list;
}

template <class Value>
Json value_of(const Value& value) {
  return value;
}

void add_value(Json& object, const NoticeValue& each) {
  object[each.name] = std::visit([](const auto& value) { return value_of(value); }, each.value);
}

Json values_object(const Notice& notice) {
  Json object = Json::object();
  for (const NoticeValue& each : notice.values) add_value(object, each);
  return object;
}

/// What is said of a run, or of several.
const Notice* said_of_run(const Notice& notice) {
  if (notice.code != "in_run" && notice.code != "in_runs") return nullptr;
  return &std::get<std::vector<Notice>>(notice.values.at(1).value).front();
}

}  // namespace

Json said(const Notice& notice, [[maybe_unused]] const Voice& voice) {
#ifdef CROMER_PAGE
  return {{"en", in_words(notice, {Language::english, Audience::page})},
          {"de", in_words(notice, {Language::german, Audience::page})}};
#else
  return in_words(notice, voice);
#endif
}

Json notice_object(const Notice& notice, const Voice& voice) {
  // A code stays the same, of how many runs ever it is said.
  const Notice* inner = said_of_run(notice);
  Json values = values_object(inner ? *inner : notice);
  if (inner) add_value(values, notice.values.front());
  return {{"code", inner ? inner->code : notice.code},
          {"severity", name(severity(notice))},
          {"text", said(notice, voice)},
          {"values", std::move(values)}};
}

Json refusal_object(const Notice& why, std::string_view argument, const Voice& voice) {
  Json object = notice_object(why, voice);
  return {{"message", object["text"]},
          {"argument", argument.empty() ? Json(nullptr) : Json(argument)},
          {"code", object["code"]},
          {"values", object["values"]}};
}

void add_notices(Json& object, std::span<const Notice> notices, const Voice& voice) {
  Json texts = Json::array(), objects = Json::array();
  for (const Notice& notice : notices) {
    texts.push_back(said(notice, voice));
    objects.push_back(notice_object(notice, voice));
  }
  object["warnings"] = std::move(texts);
  object["notices"] = std::move(objects);
}

}  // namespace cromer::core
