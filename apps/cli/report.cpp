#include <fmt/format.h>

#include <cstdio>
#include <ctime>

#include "commands.h"
#include "cromer/base/utf8.h"
#include "cromer/documents/words/words.h"
#include "cromer/os/process.h"
#include "cromer/study/write_report.h"
#include "cromer/version.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// "21 November 2026", of the machine's own calendar.
std::string today() {
  constexpr const char* months[] = {"January", "February", "March",     "April",   "May",      "June",
                                    "July",    "August",   "September", "October", "November", "December"};
  const std::tm date = os::local_time(std::time(nullptr));
  return fmt::format("{} {} {}", date.tm_mday, months[date.tm_mon], date.tm_year + 1900);
}

/// One line that is written over, on a terminal only.
StudyProgress progress_line(bool quiet) {
  if (quiet || !os::is_terminal(os::standard_error)) return {};
  return [](const std::string& what, double fraction) {
    std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100 * fraction, printable(what).c_str());
  };
}

}  // namespace

int run_report(const Arguments& arguments) {
  OutputOptions output;
  std::string folder;
  Syntax syntax{.command = "report",
                .description =
                    "Runs a study (a TOML file of tasks, figures and text) and writes its figures and one "
                    "page that opens offline.",
                .files = "STUDY.toml",
                .options = {},
                .example = "  cromer report studies/spring_lab.toml -o out/spring_lab"};
  syntax.options.push_back({"output", &folder, "", Range::any,
                            "the folder to write to; it is made if it is missing", "required", "Output"});
  add_output_options(syntax.options, output, {.files = false, .plot = false}, "");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (files.size() > 1)
    return refuse(fmt::format("cromer report takes one study, but {} are given", files.size()));
  if (folder.empty()) return refuse("cromer report needs -o FOLDER, where the report is to go");

  Watch watch = watching(output.quiet);
  watch.progress = {};
  const auto progress = progress_line(output.quiet);
  const auto report = write_report(files.front(), folder, today(), "cromer " CROMER_VERSION, watch, progress);
  if (progress) std::fputs("\r\033[K", stderr);
  if (!report) return refuse(report.error());
  const bool good = report->failure.empty();
  if (output.json && !print(to_json(*report))) return output_refused();
  if (!output.json && good && !print(report->index + "\n")) return output_refused();
  if (!good) complain(in_words(report->failure));
  if (!output.quiet)
    for (const Notice& shown : report->shown) complain("as this study is meant to show, " + in_words(shown));
  tell(report->notices, output);
  return good ? done : no_success;
}

}  // namespace cromer::core::cli
