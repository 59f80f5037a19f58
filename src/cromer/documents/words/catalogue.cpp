#include "cromer/documents/words/catalogue.h"

#include <algorithm>
#include <array>
#include <vector>

namespace cromer::core {

std::span<const std::span<const Entry>> catalogue() {
  static const std::array all = {
      words_of_base,     words_of_read,   words_of_identify,     words_of_fit,       words_of_simulate,
      words_of_options,  words_of_page,   words_of_modes,
#ifndef CROMER_PAGE  // which has not the tasks that say these
      words_of_live,     words_of_sweep,  words_of_spectrum,     words_of_files,     words_of_study,
      words_of_door,     words_of_masses, words_of_program,      words_of_recognise, words_of_report,
      words_of_networks, words_of_curves, words_of_program_fits,
#endif
  };
  return all;
}

const Entry* find_entry(std::string_view code) {
  static const std::vector<const Entry*> sorted = [] {
    std::vector<const Entry*> entries;
    for (const auto& part : catalogue())
      for (const Entry& entry : part) entries.push_back(&entry);
    std::sort(entries.begin(), entries.end(), [](auto* a, auto* b) { return a->code < b->code; });
    return entries;
  }();
  const auto at =
      std::lower_bound(sorted.begin(), sorted.end(), code,
                       [](const Entry* entry, std::string_view wanted) { return entry->code < wanted; });
  return at != sorted.end() && (*at)->code == code ? *at : nullptr;
}

}  // namespace cromer::core
