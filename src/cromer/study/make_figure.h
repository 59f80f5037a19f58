// From a study's description of a figure and the results to the figure itself.
#pragma once

#include <string>

#include "cromer/report/figure.h"
#include "cromer/result.h"
#include "cromer/study/results.h"
#include "cromer/study/study_file.h"

namespace cromer::core {

/// The figure with its numbers, its texts filled. Errors name the place in the study file.
Result<Figure> make_figure(const FigureSpec& spec, const Results& results);

/// The page's markup (*x*, x_{0}) as a figure's (enhanced_text.h).
std::string to_enhanced(const std::string& markup);

}  // namespace cromer::core
