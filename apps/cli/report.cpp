#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <optional>

#include "commands.h"
#include "cromer/base/ascii.h"
#include "cromer/base/utf8.h"
#include "cromer/documents/text.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/os/process.h"
#include "cromer/report/file.h"
#include "cromer/study/lab_report.h"
#include "cromer/study/static_report.h"
#include "cromer/study/write_report.h"
#include "cromer/tasks/fit/spring_options.h"
#include "cromer/tasks/open_recording.h"
#include "cromer/version.h"
#include "fit_files.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// "2026-11-21", of the machine's own calendar.
std::string today() {
  const std::tm date = os::local_time(std::time(nullptr));
  return fmt::format("{}-{:02}-{:02}", date.tm_year + 1900, date.tm_mon + 1, date.tm_mday);
}

/// One line that is written over, on a terminal only.
StudyProgress progress_line(bool quiet) {
  if (quiet || !os::is_terminal(os::standard_error)) return {};
  return [](const std::string& what, double fraction) {
    std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100 * fraction, printable(what).c_str());
  };
}

struct ReportOptions {
  FitOptions fit;
  SpringOptions spring;
  std::string title, author, course, text, language, front;
  std::string folder;
};

std::vector<Option> front_options_of(ReportOptions& o) {
  constexpr std::string_view group = "The page of one's own recordings";
  return {
      {"title", &o.title, "", Range::any, "its title", "names the recordings", group},
      {"author", &o.author, "", Range::any, "who wrote it", "nobody is named", group},
      {"course", &o.course, "", Range::any, "what it is written for", "none", group},
      {"text", &o.text, "", Range::any, "a text of one's own, under the summary", "none", group},
      {"language", &o.language, "", Range::any, "en or de", "en", group},
      {"front", &o.front, "", Range::any,
       "a TOML file with title, author, course, text, aim, apparatus, conclusion and language", "none",
       group},
  };
}

/// Options of fit for what a report has no place for.
bool is_of_terminal(const Option& option) {
  constexpr std::string_view names[] = {"goal", "textbook", "monte-carlo", "seed", "hold-out", "mass-line"};
  return std::find(std::begin(names), std::end(names), option.name) != std::end(names);
}

std::vector<Option> fit_options_of(ReportOptions& o) {
  std::vector<Option> options = options_of(o.fit);
  const std::vector<Option> of_spring = options_of(o.spring);
  options.insert(options.end(), of_spring.begin(), of_spring.end());
  std::erase_if(options, is_of_terminal);
  return options;
}

/// What the options say of the page, over what the --front file says.
Result<ReportFront> front_of(const ReportOptions& options) {
  ReportFront front;
  if (!options.front.empty()) {
    const auto bytes = read_file(options.front);
    if (!bytes) return bytes.error();
    auto read = read_report_front(*bytes, options.front);
    if (!read) return read.error();
    front = *std::move(read);
  }
  if (!options.title.empty()) front.title = options.title;
  if (!options.author.empty()) front.author = options.author;
  if (!options.course.empty()) front.course = options.course;
  if (!options.text.empty()) front.text = options.text;
  if (lower(options.language) == "de") front.language = Language::german;
  if (lower(options.language) == "en") front.language = Language::english;
  return front;
}

bool is_study(const std::string& file) { return file.ends_with(".toml"); }

/// From the folder's study to the recording.
std::string path_from(const std::string& folder, const std::string& file) {
  std::error_code none;
  return std::filesystem::proximate(file, std::filesystem::absolute(folder, none), none).generic_string();
}

/// The fits, those of free motions also compared with simulations.
std::vector<ReportedRecording> report_of(std::vector<FittedRecording> fits, const ReportOptions& options,
                                         const Watch& watch) {
  std::vector<ReportedRecording> recordings(fits.size());
  for_each_file(fits.size(), watch, [&](std::size_t i, const Watch& of_one) {
    ReportedRecording& each = recordings[i];
    each.path = path_from(options.folder, fits[i].file);
    each.fitted = std::move(fits[i]);
    if (!each.fitted.succeeded() || each.fitted.driven) return;
    CompareOptions compare;
    compare.fit = options.fit;
    compare.method = {report_method};
    if (auto compared = compare_fitted(each.fitted, compare, of_one)) each.compared = *std::move(compared);
  });
  return recordings;
}

/// Writes a study to the folder, and gives its path. A study there that was changed by hand is an Error.
Result<std::string> write_study(const std::string& study, const std::string& folder) {
  const std::string path = folder + "/study.toml";
  if (std::filesystem::exists(path))
    if (const auto there = read_file(path); there && !is_as_made(*there))
      return Error{"study_was_changed", {{"file", path}, {"folder", folder}}};
  if (const auto made = make_folder(folder); !made) return made.error();
  if (const auto done = write_file(path, study); !done) return done.error();
  return path;
}

/// A report of recordings: its study, and what was found.
struct OwnReport {
  std::string study;
  std::vector<ReportedRecording> recordings;
  std::optional<StaticStiffness> held{};  ///< instead of recordings
  std::vector<Notice> notices;
  std::vector<std::string> failures;
};

/// Fits the recordings and makes their study. An exit status where there is nothing to report.
std::optional<int> fit_swings(const std::vector<std::string>& files, const ReportOptions& options,
                              const std::vector<TypedOption>& given, const ReportFront& front,
                              const Watch& watch, OwnReport& own) {
  if (auto good = check_fit_options(options.fit); !good) return refuse(good.error());
  const auto found = recording_files(files);
  if (!found) return refuse(found.error());
  // A page without one of them is not what was asked for.
  bool are_there = true;
  for (const std::string& file : found->files)
    if (std::error_code none; file != "-" && !std::filesystem::exists(file, none))
      if (const auto bytes = read_file(file); !bytes) {
        are_there = false;
        refuse(bytes.error());
      }
  if (!are_there) return wrong_input;
  auto fits = fit_all(*found, options.fit, watch);
  if (fits) own.recordings = report_of(*std::move(fits), options, watch);
  clear_progress();
  if (!fits) return refuse(fits.error());
  if (watch.interrupted()) {
    complain("interrupted before the report was made");
    return no_success;
  }
  for (const ReportedRecording& each : own.recordings) {
    own.notices.insert(own.notices.end(), each.fitted.notices.begin(), each.fitted.notices.end());
    if (!each.fitted.succeeded()) own.failures.push_back(failure_text(each.fitted));
  }
  if (std::all_of(own.recordings.begin(), own.recordings.end(),
                  [](const ReportedRecording& each) { return each.fitted.wrong_input; })) {
    for (const std::string& each : own.failures) complain(each);
    return wrong_input;
  }
  own.study = lab_report(own.recordings, given, front);
  return std::nullopt;
}

/// Fits masses at rest and makes their study. An exit status where there is nothing to report.
std::optional<int> fit_held_masses(const std::vector<std::string>& files, const ReportOptions& options,
                                   const std::vector<TypedOption>& given, const ReportFront& front,
                                   OwnReport& own) {
  const auto recordings = recording_files(files);
  if (!recordings) return refuse(recordings.error());
  const auto opened = open_recordings(recordings->files, options.fit.read);
  if (!opened) return refuse(opened.error());
  auto found = fit_static(*opened, static_options(options.fit, options.spring));
  if (!found) return refuse(found.error());
  own.held = *std::move(found);
  own.notices = own.held->notices;
  std::vector<std::string> paths;
  for (const std::string& file : recordings->files) paths.push_back(path_from(options.folder, file));
  own.study = static_report(*own.held, paths, short_names(recordings->files), given, front);
  return std::nullopt;
}

/// The name without its ending where it is that of a kind of file that no report is; else "".
std::string without_ending(const std::string& name) {
  for (const std::string_view ending : {".html", ".htm", ".docx", ".doc", ".odt", ".rtf", ".tex", ".md",
                                        ".txt", ".svg", ".png", ".csv", ".json", ".xlsx"})
    if (name.size() > ending.size() && name.ends_with(ending))
      return name.substr(0, name.size() - ending.size());
  return "";
}

/// `notices`: in place of the study's own.
int finish(Result<WrittenReport> report, const OutputOptions& output,
           const std::vector<std::string>& failures, std::optional<std::vector<Notice>> notices) {
  if (!report) return refuse(report.error());
  const bool good = report->failure.empty();
  if (notices) report->notices = *std::move(notices);
  if (output.json && !print(to_json(*report))) return output_refused();
  if (!output.json && good && !print((report->pdf.empty() ? report->index : report->pdf) + "\n"))
    return output_refused();
  if (!good) complain(in_words(report->failure));
  for (const std::string& each : failures) complain(each);
  if (!output.quiet)
    for (const Notice& shown : report->shown) complain("as this study is meant to show, " + in_words(shown));
  tell(report->notices, output);
  return good && failures.empty() ? done : no_success;
}

}  // namespace

bool is_option_of_page(std::string_view name) {
  ReportOptions options;
  const std::vector<Option> front = front_options_of(options);
  return std::any_of(front.begin(), front.end(), [&](const Option& option) { return option.name == name; });
}

int run_report(const Arguments& arguments) {
  OutputOptions output;
  ReportOptions options;
  Syntax syntax{
      .command = "report",
      .description =
          "A report with its figures, on one page that opens offline: of your own recordings (their "
          "laws, what two Euler methods make of them, and the study file it was made by, to be edited), "
          "or of a study (a TOML file of tasks, figures and text).",
      .files = "FILE|FOLDER|STUDY.toml...",
      .options = fit_options_of(options),
      .example =
          "  cromer report lab.csv --mass \"217.6 ± 0.3 g\" --disc-diameter \"12 cm\" -o report\n"
          "  cromer report held.csv --static --masses \"48.4 g, 67.95 g, 87.96 g\" -o report\n"
          "  cromer report lab.csv --author \"A. Student\" -o lab.pdf\n"
          "  cromer report studies/spring_lab.toml -o out/spring_lab"};
  const auto of_front = front_options_of(options);
  syntax.options.insert(syntax.options.end(), of_front.begin(), of_front.end());
  syntax.options.push_back(
      {"output", &options.folder, "", Range::any,
       "the folder to write to, made if it is missing; or FILE.pdf: that, and the folder FILE", "required",
       "Output"});
  add_output_options(syntax.options, output, {.files = false, .plot = false}, "");
  std::vector<std::string> files;
  std::vector<TypedOption> given;
  if (const auto status = parse(syntax, arguments, files, &given)) return *status;
  const auto in_fit = fit_options_of(options);
  const auto is_of_fit = [&](const TypedOption& typed) {
    return std::any_of(in_fit.begin(), in_fit.end(),
                       [&](const Option& each) { return each.name == typed.first; });
  };
  const bool of_study = std::any_of(files.begin(), files.end(), is_study);
  if (of_study && files.size() > 1)
    return refuse(
        fmt::format("cromer report takes one study, or recordings, but {} files are given", files.size()));
  for (const TypedOption& typed : given)
    if (of_study &&
        (is_of_fit(typed) || std::any_of(of_front.begin(), of_front.end(),
                                         [&](const Option& each) { return each.name == typed.first; })))
      return refuse(fmt::format("--{}: a study says this itself, in {}", typed.first, files.front()));
  if (const std::string language = lower(options.language);
      !language.empty() && language != "en" && language != "de")
    return refuse(fmt::format("--language {}: it must be en or de", options.language));
  if (auto good = check_spring_options(options.spring, true); !good) return refuse(good.error());
  if (options.folder.empty()) return refuse("cromer report needs -o FOLDER, where the report is to go");
  std::string pdf;
  if (const std::string name = without_ending(options.folder); !name.empty())
    return refuse(fmt::format("-o {0}: a report is a folder or a PDF; write -o {1} or -o {1}.pdf",
                              options.folder, name));
  if (lower(options.folder).ends_with(".pdf")) {
    pdf = options.folder;
    options.folder.erase(pdf.size() - 4);
    if (options.folder.empty() || options.folder.ends_with('/'))
      return refuse("-o " + pdf + ": the file needs a name");
    if (const auto good = check_writable(pdf); !good) return refuse(good.error());
  }

  Watch watch = watching(output.quiet);
  OwnReport own;
  std::optional<std::vector<Notice>> notices;
  std::string study = files.front();
  if (!of_study) {
    const auto front = front_of(options);
    if (!front) return refuse(front.error());
    std::erase_if(given, [&](const TypedOption& typed) { return !is_of_fit(typed); });
    if (const auto status = options.spring.held ? fit_held_masses(files, options, given, *front, own)
                                                : fit_swings(files, options, given, *front, watch, own))
      return *status;
    const auto path = write_study(own.study, options.folder);
    if (!path) return refuse(path.error());
    study = *path;
    notices = own.notices;
  }
  watch.progress = {};
  const auto progress = progress_line(output.quiet);
  const auto report = write_report(study, options.folder, today(), "cromer " CROMER_VERSION, watch, progress,
                                   own.held ? known_results(*own.held) : known_results(own.recordings), pdf);
  if (progress) std::fputs("\r\033[K", stderr);
  return finish(report, output, own.failures, std::move(notices));
}

}  // namespace cromer::core::cli
