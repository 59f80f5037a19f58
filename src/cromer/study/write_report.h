// The report of a study is a folder: index.html, the figures as SVG files, and the results as JSON.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/report/figure.h"
#include "cromer/report/page.h"
#include "cromer/result.h"
#include "cromer/study/results.h"
#include "cromer/study/run_study.h"
#include "cromer/study/study_file.h"

namespace cromer::core {

/// A figure with its numbers, and results filled into its texts. Errors name the place in the study file.
Result<Figure> make_figure(const FigureSpec& spec, const Results& results);

/// Markup of the page (*x*, x_{0}) as markup of figures (enhanced_text.h).
std::string to_enhanced(const std::string& markup);

/// A figure as it is put on the page.
struct DrawnFigure {
  std::string svg, title, caption;
  double width = 1;
};

/// The page: its texts with results, its tables, and its figures, numbered in the order of the file. `footer`
/// names the versions that made it.
Result<Page> make_page(const Study& study, const Results& results,
                       const std::map<std::string, DrawnFigure>& figures, const std::string& footer);

struct WrittenReport {
  std::string index;                 ///< path of index.html; empty if a task failed
  std::vector<std::string> figures;  ///< paths
  std::vector<Notice> notices;
  std::vector<Notice> shown;  ///< notices that the study is meant to show
  Notice failure;     ///< the task that did not succeed, where it is in the study, and why; then nothing was
                      ///< written
  std::string pdf{};  ///< path of the whole page as PDF, if it was asked for
};

/// Makes the folder of a report if it is missing; an Error where nothing can be written to it.
Result<void> make_folder(const std::string& folder);

/// Reads the study, runs it and draws its figures; only then it writes, each file whole or not at all. `date`
/// ("21 November 2026") and `program` ("cromer 0.1.0") stand under the title; the foot names the compiler as
/// well. `pdf`: a file for the whole page.
Result<WrittenReport> write_report(const std::string& study_path, const std::string& folder,
                                   const std::string& date, const std::string& program,
                                   const Watch& watch = {}, const StudyProgress& progress = {},
                                   const KnownResults& known = {}, const std::string& pdf = "");

/// {"index", "figures": [paths], "warnings", "notices", "shown"}, with "message" if a task failed.
std::string to_json(const WrittenReport& report);

}  // namespace cromer::core
