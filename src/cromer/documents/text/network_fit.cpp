#include <fmt/format.h>

#include <cmath>

#include "cromer/documents/text.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {

std::string network_fit_text(const FittedNetwork& fitted) {
  const std::string head = fmt::format("{}: {}", fitted.file, cromer::name(fitted.fit.status));
  if (fitted.fit.values.empty()) return head + ", " + in_words(fitted.message) + "\n";
  const std::vector<double>& t = fitted.channels.t;
  std::string text = fmt::format("{}, {} times, {:.10g} to {:.10g} s", head, t.size(), t.front(), t.back());
  if (fitted.network_file != given_network) text += ", network " + fitted.network_file;
  text += "\n\n";
  const Network& network = fitted.asked.network;
  std::vector<std::vector<std::string>> rows{{"link", "", "value", "95 %"}};
  for (std::size_t l = 0; l < network.links.size(); ++l)
    for (const Parameter& found : fitted.found_of(l))
      rows.push_back({name_of(network, network.links[l].from) + " – " + name_of(network, network.links[l].to),
                      readable_name(found.name), in_words(found.estimate, found.unit),
                      std::isfinite(found.estimate.standard_error)
                          ? interval_text(found.estimate.low, found.estimate.high)
                          : ""});
  text += text_table(rows, 2, 4) + "\n";
  const char* unit = network.angles ? "rad" : "m";
  rows = {{"mass", "column", "at rest it reads", "residual (rms)", "accounted for"}};
  for (std::size_t i = 0; i < fitted.fit.columns.size(); ++i) {
    const FittedColumn& column = fitted.fit.columns[i];
    rows.push_back({network.masses[i].name, fitted.channels.each[i].column, in_words(column.offset, unit),
                    fmt::format("{:.3g} {}", column.rms, unit), percent(column.explained)});
  }
  return text + text_table(rows, 2, 5);
}

}  // namespace cromer::core
