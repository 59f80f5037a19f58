// Optional libraries, loaded when they are first needed: librsvg and cairo make PNG and PDF of an SVG,
// fontconfig knows the fonts.
#pragma once

#include <string>
#include <string_view>

#include "cromer/os/library.h"
#include "cromer/result.h"

namespace cromer::core {

/// Sets `function` to the library's function of that name; false where either is missing;
/// os::why_not_loaded() then tells. The library stays loaded.
template <class Function>
bool find_function(const char* library, const char* name, Function*& function) {
  void* const loaded = os::load_library(library);
  function = loaded ? reinterpret_cast<Function*>(os::symbol_of(loaded, name)) : nullptr;
  return function != nullptr;
}

/// Whether fontconfig has a font of this family; without fontconfig none is known.
bool is_installed(const std::string& font_family);

/// Two px for each of the SVG's, which is `width` times `height` [px]. An Error says what to install.
Result<std::string> png_of(std::string_view svg, double width, double height);

/// 3/4 pt for each px: as large as a browser prints it.
Result<std::string> pdf_of(std::string_view svg, double width, double height);

}  // namespace cromer::core
