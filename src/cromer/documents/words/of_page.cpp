#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

// apps/web/core
constexpr Entry entries[] = {
    {"page_setting", error, "\"{line}\" is not option=value", "„{line}“ ist nicht Option=Wert"},
    {"nothing_drives_it", error, "{--drive-amplitude}: nothing drives it",
     "{--drive-amplitude}: nichts treibt den Schwinger an"},
    {"page_drives_by_sine", error,
     "{--drive} {drive}: the page drives by a sine; run the others with the program",
     "{--drive} {drive}: die Seite treibt mit einem Sinus an; alles andere rechnet das Programm"},
    {"page_has_no_recorded_drive", error, "the page drives by a sine; run recorded drives with the program",
     "die Seite treibt mit einem Sinus an; aufgenommene Antriebe rechnet das Programm"},
    {"program_only", error, "{option:option}: run it with the program",
     "{option:option}: das rechnet das Programm"},
    {"page_task", error, "there is no task \"{task}\"", "die Aufgabe „{task}“ gibt es nicht"},
};

}  // namespace

const std::span<const Entry> words_of_page = entries;

}  // namespace cromer::core
