#include "cromer/read/formats/program_file.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "cromer/base/ascii.h"

namespace cromer::core::dialects {
namespace {

struct ProgramFile {
  std::string_view ending, program, menu;
};

constexpr std::string_view pasco = "File > Export Data...";
constexpr ProgramFile program_files[] = {
    {".cap", "PASCO Capstone", pasco},
    {".ds", "PASCO DataStudio", pasco},
    {".cmbl", "Vernier Logger Pro", "File > Export As > CSV"},
    {".gambl", "Vernier Graphical Analysis", "File > Export > CSV"},
    {".trk", "Tracker", "File > Export > Data File..."},
    {".xlsx", "Excel", "File > Save As > CSV UTF-8"},
    {".xls", "Excel", "File > Save As > CSV UTF-8"},
    {".ods", "LibreOffice", "File > Save As > Text CSV"},
};

}  // namespace

Notice export_menu(std::string_view file) {
  const std::string name = lower(file);
  const auto found = std::find_if(std::begin(program_files), std::end(program_files),
                                  [&](const ProgramFile& each) { return name.ends_with(each.ending); });
  if (found == std::end(program_files)) return {};
  return Notice{"file_of_a_program", {{"program", found->program}, {"menu", found->menu}}};
}

}  // namespace cromer::core::dialects
