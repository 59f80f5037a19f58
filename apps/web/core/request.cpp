#include "request.h"

#include <algorithm>

namespace cromer::core::page {

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
      return Error{"page_setting", {{"line", line}}};
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
  return core::assign(request.settings, options, request.task);
}

}  // namespace cromer::core::page
