// The style sheet of a report.
#pragma once

#include <string>

namespace cromer::core {

/// CSS for the page of page.cpp: light and dark by the reader's choice, paper, narrow screens. The colours of
/// figures follow the palette in the dark.
std::string page_style();

}  // namespace cromer::core
