#include "lab_page.h"

#include <filesystem>

namespace cromer::cli {

std::string find_lab_page() {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (failed) return "";
  const fs::path folder = program.parent_path();  // build/release, or bin
  for (const fs::path& place : {folder.parent_path() / "page" / "cromer-lab.html",
                                folder.parent_path() / "share" / "cromer" / "cromer-lab.html"})
    if (fs::is_regular_file(place, failed)) return place.string();
  return "";
}

std::string page_is_missing() {
  return "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Cromer</title>"
         "<style>body{font:16px/1.5 sans-serif;max-width:40em;margin:4em auto;padding:0 1em}</style>"
         "<h1>The lab is not built yet</h1><p>Run <code>./dev page</code> in the clone of Cromer and load "
         "this page "
         "again. Recording works without it: the addresses are in "
         "<code>docs/recording.md</code>.</p></html>\n";
}

}  // namespace cromer::cli
