// SVG as PNG and PDF, by librsvg and cairo where they are installed: loaded when they are first needed.
#pragma once

#include <string>
#include <string_view>

#include "cromer/result.h"

namespace cromer::core {

/// Two px for each of the SVG's, which is `width` times `height` [px]. An Error says what to install.
Result<std::string> png_of(std::string_view svg, double width, double height);

/// 3/4 pt for each px: as large as a browser prints it.
Result<std::string> pdf_of(std::string_view svg, double width, double height);

}  // namespace cromer::core
