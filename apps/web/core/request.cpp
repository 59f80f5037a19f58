#include "request.h"

#include <algorithm>

#include "cromer/base/nearest.h"

namespace cromer::page {
namespace {

Error unknown(std::string_view name, const Request& request, const std::vector<Option>& options) {
  std::vector<std::string_view> names;
  for (const Option& option : options) names.push_back(option.name);
  const std::string near = nearest(name, names);
  std::string message = "--" + std::string(name) + " is no option of " + request.task;
  if (!near.empty()) message += "; did you mean --" + near + "?";
  return Error{message};
}

}  // namespace

Result<Request> read_request(std::string_view text) {
  Request request;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = text.substr(from, end - from);
    from = end + 1;
    if (line.empty()) continue;
    const std::size_t equals = line.find('=');
    if (request.task.empty())
      request.task = line;
    else if (equals == std::string_view::npos)
      return Error{"\"" + std::string(line) + "\" is not option=value"};
    else
      request.settings.emplace_back(line.substr(0, equals), line.substr(equals + 1));
  }
  if (const std::string name = take(request, "file-name"); !name.empty()) request.file_name = name;
  return request;
}

std::string take(Request& request, std::string_view name, std::string_view otherwise) {
  auto& settings = request.settings;
  const auto at =
      std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.first == name; });
  if (at == settings.end()) return std::string(otherwise);
  std::string value = std::move(at->second);
  settings.erase(at);
  return value;
}

Result<void> assign(const Request& request, const std::vector<Option>& options) {
  for (const auto& setting : request.settings) {
    const auto option = std::find_if(options.begin(), options.end(),
                                     [&](const Option& each) { return each.name == setting.first; });
    if (option == options.end()) return unknown(setting.first, request, options);
    if (auto good = cromer::assign(*option, setting.second); !good) return good;
    if (auto good = check(*option); !good) return good;
    if (option->asked) *option->asked = true;
  }
  return {};
}

}  // namespace cromer::page
