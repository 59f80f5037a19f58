#include "cromer/study/write_report.h"

#include <filesystem>
#include <map>
#include <system_error>

#include "cromer/report/file.h"
#include "cromer/study/make_figure.h"
#include "cromer/study/make_page.h"
#include "cromer/study/study_json.h"

namespace cromer::core {
namespace {

Result<std::map<std::string, DrawnFigure>> draw_figures(const Study& study, const Results& results,
                                                        const Watch& watch) {
  std::map<std::string, DrawnFigure> drawn;
  for (const FigureSpec& spec : study.figures) {
    if (watch.interrupted())
      return spec.place.error(Notice{"interrupted_before", {{"figure", spec.look.id}}});
    auto figure = make_figure(spec, results);
    if (!figure) return figure.error();
    auto svg = draw(*figure, FigureFormat::svg);
    if (!svg) return spec.place.error(svg.error().notice);
    drawn[spec.look.id] = DrawnFigure{std::move(*svg), figure->title, figure->caption, spec.width};
  }
  return drawn;
}

std::string versions(const std::string& program) {
#if defined(__clang__)
  return program + " · compiled by clang " __clang_version__;
#else
  return program + " · compiled by g++ " __VERSION__;
#endif
}

Result<void> make_folder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"folder_not_made", {{"folder", folder}, {"why", failed.message()}}};
  return check_writable(folder + "/index.html");
}

// A folder that was made for a report which was then not written goes again.
class FolderInWaiting {
 public:
  explicit FolderInWaiting(const std::string& folder)
      : folder_(folder), was_there_(std::filesystem::exists(folder)) {}
  ~FolderInWaiting() {
    std::error_code none;
    if (!was_there_ && std::filesystem::is_empty(folder_, none)) std::filesystem::remove(folder_, none);
  }
  FolderInWaiting(const FolderInWaiting&) = delete;
  FolderInWaiting& operator=(const FolderInWaiting&) = delete;

 private:
  std::string folder_;
  bool was_there_;
};

}  // namespace

Result<WrittenReport> write_report(const std::string& study_path, const std::string& folder,
                                   const std::string& date, const std::string& program, const Watch& watch,
                                   const StudyProgress& progress) {
  const auto bytes = read_file(study_path);
  if (!bytes) return bytes.error();
  auto study = read_study(*bytes, study_path);
  if (!study) return study.error();
  const FolderInWaiting in_waiting(folder);
  if (const auto made = make_folder(folder); !made) return made.error();

  auto run = run_study(*study, watch, progress);
  if (!run) return run.error();
  WrittenReport written{"", {}, run->notices, run->shown, run->failure};
  if (!run->failure.empty()) return written;
  if (progress) progress("figures", 1);
  const auto figures = draw_figures(*study, run->results, watch);
  if (!figures) return figures.error();
  study->byline += (study->byline.empty() ? "" : " · ") + date + " · " + program;
  const auto page = make_page(*study, run->results, *figures, versions(program));
  if (!page) return page.error();

  for (const auto& [id, figure] : *figures) {
    written.figures.push_back(folder + "/" + id + ".svg");
    if (const auto done = write_file(written.figures.back(), figure.svg); !done) return done.error();
  }
  if (const auto done = write_file(folder + "/results.json", to_json(run->results)); !done)
    return done.error();
  written.index = folder + "/index.html";
  if (const auto done = write_file(written.index, to_html(*page)); !done) return done.error();
  return written;
}

}  // namespace cromer::core
