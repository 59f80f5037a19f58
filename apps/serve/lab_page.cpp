#include "apps/serve/lab_page.h"

#include <filesystem>

#include "cromer/os/process.h"

namespace cromer::core::serve {
namespace {

const std::string head =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Cromer</title>"
    "<meta name=\"viewport\" content=\"width=device-width\">"
    "<style>body{font:16px/1.5 sans-serif;max-width:40em;margin:4em auto;padding:0 1em}</style>";

}  // namespace

std::string find_lab_page() {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path program = os::program();
  if (program.empty()) return "";
  const fs::path folder = program.parent_path();  // build/release, or bin
  for (const fs::path& place : {folder.parent_path() / "page" / "cromer-lab.html",
                                folder.parent_path() / "share" / "cromer" / "cromer-lab.html"})
    if (fs::is_regular_file(place, failed)) return place.string();
  return "";
}

std::string page_is_missing() {
  return head +
         "<h1>The lab is not built yet</h1><p>Run <code>./dev page</code> in the clone of Cromer and load "
         "this page again. Recording works without it: the addresses are in "
         "<code>docs/recording.md</code>.</p></html>\n";
}

std::string token_is_missing() {
  return head +
         "<h1>The address is not complete</h1><p>This lab is open to those who were given its address: "
         "open it whole, as <code>cromer serve</code> printed it, up to the end of "
         "<code>?token=…</code>. Each start of the program makes a new one.</p>"
         "<p lang=\"de\">Die Adresse ist unvollständig oder veraltet: Öffnen Sie sie ganz, so wie "
         "<code>cromer serve</code> sie ausgegeben hat, bis zum Ende von <code>?token=…</code>. "
         "Jeder Start des Programms ergibt eine neue.</p></html>\n";
}

}  // namespace cromer::core::serve
