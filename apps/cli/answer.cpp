#include "answer.h"

#include "cromer/report/file.h"
#include "exit_status.h"
#include "message.h"

namespace cromer::core::cli {
namespace {

Result<void> write_output(const Answer& answer, const OutputOptions& output) {
  const std::string& file = output.output;
  if (file.empty()) return {};
  switch (*file_format(file, output.hdf5)) {
    case FileFormat::hdf5:
      // A sweep's rows are in its file already.
      return answer.tables ? write_tables(file, answer.tables()) : Result<void>{};
    case FileFormat::json:
      return write_file(file, answer.whole_json ? answer.whole_json() : answer.json());
    case FileFormat::csv:
      break;
  }
  const auto text = answer.csv();
  return text ? write_file(file, *text) : text.error();
}

}  // namespace

int give(const Answer& answer, const OutputOptions& output) {
  if (auto good = write_output(answer, output); !good) return refuse(good.error());
  if (answer.other_files)
    if (auto good = answer.other_files(); !good) return refuse(good.error());
  if (output.output != "-" && !print(output.json ? answer.json() : answer.text()))
    return refuse("standard output cannot be written");
  if (!output.plot.empty() && answer.figure) {
    const auto figure = answer.figure();
    if (!figure) return refuse(figure.error());
    if (auto good = write_plot(output.plot, *figure); !good) return refuse(good.error());
  }
  for (const std::string& failure : answer.failures) complain(failure);
  tell(answer.notices, output);
  return answer.good ? done : no_success;
}

}  // namespace cromer::core::cli
