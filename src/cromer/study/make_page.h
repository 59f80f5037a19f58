// From a study's blocks and the results to the page of its report.
#pragma once

#include <map>
#include <string>

#include "cromer/report/page.h"
#include "cromer/result.h"
#include "cromer/study/results.h"
#include "cromer/study/study_file.h"

namespace cromer::core {

/// A figure ready to be put on the page.
struct DrawnFigure {
  std::string svg, title, caption;
  double width = 1;
};

/// The page: texts filled, tables made, figures numbered in the order of the file. `footer` says which
/// versions made it.
Result<Page> make_page(const Study& study, const Results& results,
                       const std::map<std::string, DrawnFigure>& figures, const std::string& footer);

}  // namespace cromer::core
