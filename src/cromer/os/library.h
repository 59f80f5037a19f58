// Libraries that are loaded while the program runs.
#pragma once

#include <string>

namespace cromer::core::os {

/// Whether its symbols are for this program alone, or for the libraries too that are loaded later.
enum class Symbols { own, everybodys };

/// Loads a library by its path, or by its name from where the system looks; it stays loaded. nullptr where
/// that fails: `why_not_loaded()` tells.
void* load_library(const std::string& name, Symbols symbols = Symbols::own);
std::string why_not_loaded();

/// Of a loaded library; nullptr where it has none of that name.
void* symbol_of(void* library, const char* name);

}  // namespace cromer::core::os
