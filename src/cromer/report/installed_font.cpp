#include "cromer/report/installed_font.h"

#include "cromer/report/shared_library.h"

namespace cromer::core {
namespace {

// As in fontconfig/fontconfig.h, version 2.
struct FcConfig;
struct FcPattern;
constexpr int match_pattern = 0, is_match = 0;  // FcMatchPattern, FcResultMatch

struct Fontconfig {
  FcPattern* (*parse)(const char* name);
  int (*substitute)(FcConfig*, FcPattern*, int kind);
  void (*default_substitute)(FcPattern*);
  FcPattern* (*match)(FcConfig*, FcPattern*, int* result);
  int (*get_string)(const FcPattern*, const char* object, int index, char** value);
  void (*destroy)(FcPattern*);

  bool load() {
    constexpr const char* library = "libfontconfig.so.1";
    return find_function(library, "FcNameParse", parse) &&
           find_function(library, "FcConfigSubstitute", substitute) &&
           find_function(library, "FcDefaultSubstitute", default_substitute) &&
           find_function(library, "FcFontMatch", match) &&
           find_function(library, "FcPatternGetString", get_string) &&
           find_function(library, "FcPatternDestroy", destroy);
  }

  /// The family of the nearest font, of the current configuration.
  std::string nearest(const std::string& family) const {
    FcPattern* const asked = parse(family.c_str());
    if (!asked) return "";
    substitute(nullptr, asked, match_pattern);
    default_substitute(asked);
    int result = 0;
    FcPattern* const found = match(nullptr, asked, &result);
    destroy(asked);
    if (!found) return "";
    char* name = nullptr;
    const bool named = get_string(found, "family", 0, &name) == is_match;
    const std::string nearest = named ? name : "";
    destroy(found);
    return nearest;
  }
};

}  // namespace

bool is_installed(const std::string& font_family) {
  Fontconfig fontconfig;
  return fontconfig.load() && fontconfig.nearest(font_family) == font_family;
}

}  // namespace cromer::core
