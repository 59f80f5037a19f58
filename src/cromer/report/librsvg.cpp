#include "cromer/report/librsvg.h"

#include <cmath>
#include <cstdint>
#include <memory>

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

Typeface installed_typeface() {
  static const bool has_lato = is_installed("Lato");
  return has_lato ? Typeface::lato : Typeface::dejavu_sans;
}

std::string_view font_family(Typeface typeface) {
  return typeface == Typeface::lato ? "Lato, sans-serif" : "'DejaVu Sans', sans-serif";
}

namespace {

constexpr double png_scale = 2, pt_per_px = 0.75;

// As in librsvg/rsvg.h (2.46), cairo.h, cairo-pdf.h (1.16) and glib.h (2).
struct Handle;
struct Surface;
struct Context;
struct Viewport {
  double x, y, width, height;
};
struct GError {
  std::uint32_t domain;
  int code;
  char* message;
};
using Write = int (*)(void* closure, const unsigned char* bytes, unsigned count);
// CAIRO_FORMAT_RGB24, CAIRO_STATUS_SUCCESS, CAIRO_PDF_METADATA_TITLE
constexpr int rgb24 = 1, success = 0, title_entry = 0;

struct Libraries {
  Handle* (*new_from_data)(const unsigned char* bytes, std::size_t count, GError**);
  int (*render_document)(Handle*, Context*, const Viewport*, GError**);
  Surface* (*image_surface)(int format, int width, int height);
  Surface* (*pdf_surface)(Write, void* closure, double width_pt, double height_pt);
  int (*write_png)(Surface*, Write, void* closure);
  void (*set_metadata)(Surface*, int what, const char* text);
  void (*show_page)(Surface*);
  void (*finish)(Surface*);
  int (*surface_status)(Surface*);
  void (*surface_destroy)(Surface*);
  Context* (*context_of)(Surface*);
  void (*context_destroy)(Context*);
  const char* (*status_text)(int status);
  void (*unref)(void*);
  void (*error_free)(GError*);

  bool load() {
    constexpr const char *rsvg = "librsvg-2.so.2", *cairo = "libcairo.so.2";
    return find_function(rsvg, "rsvg_handle_new_from_data", new_from_data) &&
           find_function(rsvg, "rsvg_handle_render_document", render_document) &&
           find_function(cairo, "cairo_image_surface_create", image_surface) &&
           find_function(cairo, "cairo_pdf_surface_create_for_stream", pdf_surface) &&
           find_function(cairo, "cairo_surface_write_to_png_stream", write_png) &&
           find_function(cairo, "cairo_pdf_surface_set_metadata", set_metadata) &&
           find_function(cairo, "cairo_surface_show_page", show_page) &&
           find_function(cairo, "cairo_surface_finish", finish) &&
           find_function(cairo, "cairo_surface_status", surface_status) &&
           find_function(cairo, "cairo_surface_destroy", surface_destroy) &&
           find_function(cairo, "cairo_create", context_of) &&
           find_function(cairo, "cairo_destroy", context_destroy) &&
           find_function(cairo, "cairo_status_to_string", status_text) &&
           find_function("libgobject-2.0.so.0", "g_object_unref", unref) &&
           find_function("libglib-2.0.so.0", "g_error_free", error_free);
  }
};

const Result<Libraries>& libraries() {
  static const Result<Libraries> loaded = []() -> Result<Libraries> {
    Libraries found;
    if (found.load()) return found;
    return Error{"librsvg_is_missing", {{"why", os::why_not_loaded()}}};
  }();
  return loaded;
}

int append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return success;
}

Error not_drawn(std::string_view reason) { return Error{"librsvg_failed", {{"why", reason}}}; }

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

class Renderer {
 public:
  explicit Renderer(const Libraries& libraries) : lib_(libraries) {}

  Result<std::string> png(std::string_view svg, double width, double height) {
    const auto px = [](double size) { return static_cast<int>(std::lround(png_scale * size)); };
    const auto surface = owned(lib_.image_surface(rgb24, px(width), px(height)));
    if (const auto drawn = draw(svg, surface.get(), png_scale * width, png_scale * height); !drawn)
      return drawn.error();
    std::string bytes;
    if (const auto written = done(lib_.write_png(surface.get(), append, &bytes)); !written)
      return written.error();
    return bytes;
  }

  Result<std::string> pdf(std::span<const std::string_view> svgs, double width, double height,
                          const std::string& title) {
    const double width_pt = pt_per_px * width, height_pt = pt_per_px * height;
    std::string bytes;
    const auto surface = owned(lib_.pdf_surface(append, &bytes, width_pt, height_pt));
    if (!title.empty()) lib_.set_metadata(surface.get(), title_entry, title.c_str());
    for (const std::string_view& svg : svgs) {
      if (&svg != &svgs.front()) lib_.show_page(surface.get());
      if (const auto drawn = draw(svg, surface.get(), width_pt, height_pt); !drawn) return drawn.error();
    }
    lib_.finish(surface.get());
    if (const auto finished = done(lib_.surface_status(surface.get())); !finished) return finished.error();
    return bytes;
  }

 private:
  Owned<Surface> owned(Surface* surface) const { return {surface, lib_.surface_destroy}; }

  Result<void> done(int status) const {
    if (status != success) return not_drawn(lib_.status_text(status));
    return {};
  }

  /// Fills the surface, unless cairo could not make it.
  Result<void> draw(std::string_view svg, Surface* surface, double width, double height) const {
    if (const auto made = done(lib_.surface_status(surface)); !made) return made.error();
    GError* failed = nullptr;
    const std::unique_ptr<Handle, void (*)(void*)> handle(
        lib_.new_from_data(reinterpret_cast<const unsigned char*>(svg.data()), svg.size(), &failed),
        lib_.unref);
    if (!handle) return reason_of(failed);
    const Owned<Context> context(lib_.context_of(surface), lib_.context_destroy);
    const Viewport all{0, 0, width, height};
    if (!lib_.render_document(handle.get(), context.get(), &all, &failed)) return reason_of(failed);
    return {};
  }

  Error reason_of(GError* failed) const {
    if (!failed) return Error{"librsvg_failed", {{"why", Notice{"no_reason_given"}}}};
    const Error error = not_drawn(failed->message);
    lib_.error_free(failed);
    return error;
  }

  const Libraries& lib_;
};

}  // namespace

Result<std::string> png_of(std::string_view svg, double width, double height) {
  if (!libraries()) return libraries().error();
  return Renderer(*libraries()).png(svg, width, height);
}

Result<std::string> pdf_of(std::string_view svg, double width, double height) {
  return pdf_of_pages({&svg, 1}, width, height, "");
}

Result<std::string> pdf_of_pages(std::span<const std::string_view> svgs, double width, double height,
                                 const std::string& title) {
  if (!libraries()) return libraries().error();
  return Renderer(*libraries()).pdf(svgs, width, height, title);
}

}  // namespace cromer::core
