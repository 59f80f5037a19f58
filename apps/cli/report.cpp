#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "commands.h"
#include "cromer/base/utf8.h"
#include "cromer/study/study_json.h"
#include "cromer/study/write_report.h"
#include "cromer/version.h"
#include "exit_status.h"
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
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  localtime_r(&now, &date);
  return fmt::format("{} {} {}", date.tm_mday, months[date.tm_mon], date.tm_year + 1900);
}

/// One line that is written over, on a terminal only.
StudyProgress progress_line(bool quiet) {
  if (quiet || !isatty(STDERR_FILENO)) return {};
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
                            "the folder to write to; made where it is missing", "required", "Output"});
  add_output_options(syntax.options, output, {.files = false, .plot = false}, "");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (files.size() > 1)
    return refuse(fmt::format("cromer report takes one study, but {} are given", files.size()));
  if (folder.empty()) return refuse("cromer report needs -o FOLDER, where the report is to go");

  Watch watch = watching(output.quiet);
  watch.progress = {};
  // What is said before a run is not said again at the end.
  std::vector<std::string> said;
  watch.warn = [&](const std::vector<std::string>& warnings) {
    if (!output.quiet && isatty(STDERR_FILENO)) std::fputs("\r\033[K", stderr);
    warn(warnings, output.quiet);
    said.insert(said.end(), warnings.begin(), warnings.end());
  };
  const auto progress = progress_line(output.quiet);
  const auto report = write_report(files.front(), folder, today(), "cromer " CROMER_VERSION, watch, progress);
  if (progress) std::fputs("\r\033[K", stderr);
  if (!report) return refuse(report.error().message);
  std::vector<std::string> unsaid;
  for (const std::string& warning : report->warnings)
    if (std::find(said.begin(), said.end(), warning) == said.end()) unsaid.push_back(warning);
  warn(unsaid, output.quiet);
  if (!output.quiet)
    for (const std::string& shown : report->shown) complain("as this study is to show, " + shown);
  if (!report->failure.empty()) complain(report->failure);
  if (output.json && !print(to_json(*report))) return refuse("standard output cannot be written");
  if (!report->failure.empty()) return no_success;
  if (!output.json) print(report->index + "\n");
  return done;
}

}  // namespace cromer::core::cli
