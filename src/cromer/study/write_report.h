// A study becomes a folder: index.html, its figures as SVG files, and what was found as JSON.
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

/// The figure with its numbers, its texts filled. Errors name the place in the study file.
Result<Figure> make_figure(const FigureSpec& spec, const Results& results);

/// The page's markup (*x*, x_{0}) as a figure's (enhanced_text.h).
std::string to_enhanced(const std::string& markup);

/// A figure ready to be put on the page.
struct DrawnFigure {
  std::string svg, title, caption;
  double width = 1;
};

/// The page: texts filled, tables made, figures numbered in the order of the file. `footer` says which
/// versions made it.
Result<Page> make_page(const Study& study, const Results& results,
                       const std::map<std::string, DrawnFigure>& figures, const std::string& footer);

struct WrittenReport {
  std::string index;                 ///< path of index.html; empty if a task failed
  std::vector<std::string> figures;  ///< paths
  std::vector<Notice> notices;
  std::vector<Notice> shown;  ///< what the study is to show
  Notice failure;  ///< which task did not succeed, where in the study, and why; then nothing was written
};

/// Reads the study, runs it, draws its figures and only then writes; each file whole or not at all. `date` is
/// shown under the title ("21 November 2026"), and with it
/// `program` ("cromer 0.1.0"), which at the foot is followed by the versions of what drew and compiled.
Result<WrittenReport> write_report(const std::string& study_path, const std::string& folder,
                                   const std::string& date, const std::string& program,
                                   const Watch& watch = {}, const StudyProgress& progress = {});

/// {"index", "figures": [paths], "warnings", "notices", "shown"}, with "message" where a task failed.
std::string to_json(const WrittenReport& report);

}  // namespace cromer::core
