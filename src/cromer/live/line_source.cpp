#include "cromer/live/line_source.h"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "cromer/live/phyphox.h"
#include "cromer/os/file.h"

namespace cromer::core {

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Result<void> LineSource::open() {
  auto line = connect_();
  if (!line) return line.error();
  line_ = *std::move(line);
  reader_.connected(steady_seconds());
  return {};
}

bool LineSource::come_back(double seconds, std::vector<Remark>& notices) {
  if (auto line = connect_()) {
    line_ = *std::move(line);
    reader_.connected(steady_seconds());
    notices.push_back(
        {RemarkKind::connection,
         Notice{"source_is_back", {{"source", name_}, {"duration", steady_seconds() - lost_at_}}}});
  } else {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }
  return true;
}

bool LineSource::receive(double seconds, SampleRows& rows, std::vector<Remark>& notices) {
  const bool more = read(seconds, rows, notices);
  reader_.release(steady_seconds(), rows, notices);
  return more;
}

bool LineSource::read(double seconds, SampleRows& rows, std::vector<Remark>& notices) {
  if (!line_.is_open()) return come_back(seconds, notices);
  if (!readable(line_, seconds)) return true;
  char bytes[4096];
  const auto count = os::read(line_.number(), bytes, sizeof bytes);
  const double arrival = steady_seconds();
  if (count > 0) {
    reader_.take({bytes, static_cast<std::size_t>(count)}, arrival, rows, notices);
    return true;
  }
  if (count < 0 && errno == EAGAIN) return true;
  if (!comes_back_) {
    reader_.end(arrival, rows, notices);
    return false;
  }
  line_.close();
  lost_at_ = arrival;
  reader_.connection_lost(rows, notices);
  notices.push_back({RemarkKind::connection, Notice{"source_is_gone", {{"source", name_}}}});
  return true;
}

std::unique_ptr<Source> make_source(const SourceName& name, const LineSettings& lines) {
  switch (name.kind) {
    case SourceKind::serial:
      return std::make_unique<LineSource>(
          name.place, [name] { return open_serial(name.place, name.number); }, true, true, lines);
    case SourceKind::tcp:
      return std::make_unique<LineSource>(
          fmt::format("{}:{}", name.place, name.number),
          [name] { return open_tcp(name.place, name.number, 3); }, true, false, lines);
    case SourceKind::phyphox:
      return std::make_unique<PhyphoxSource>(name.place, name.number);
    case SourceKind::standard_input:
      break;
  }
  return std::make_unique<LineSource>(
      "standard input", [] { return Result<Descriptor>(standard_input_again()); }, false, false, lines);
}

}  // namespace cromer::core
