// Optional libraries, loaded when they are first needed: librsvg and cairo make PNG and PDF of an SVG,
// fontconfig knows the fonts.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cromer/os/library.h"
#include "cromer/report/enhanced_text.h"
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

/// What this machine draws in: Lato where it is installed, else DejaVu Sans, fontconfig's own stand-in.
Typeface installed_typeface();

/// The typeface's name for an SVG.
std::string_view font_family(Typeface typeface);

/// Two px for each of the SVG's, which is `width` times `height` [px]. An Error says what to install.
Result<std::string> png_of(std::string_view svg, double width, double height);

/// 3/4 pt for each px: as large as a browser prints it.
Result<std::string> pdf_of(std::string_view svg, double width, double height);

/// The same with a page for each SVG and, unless it is empty, a title for those who open the file.
Result<std::string> pdf_of_pages(std::span<const std::string_view> svgs, double width, double height,
                                 const std::string& title);

}  // namespace cromer::core
