// A recording's file, a mass with its uncertainty: how stiff is the spring?
#include <cstdio>
#include <string>

#include "cromer/base/quantity.h"
#include "cromer/report/read_file.h"
#include "cromer/study/task/fit.h"

int main(int count, char** words) {
  using namespace cromer;
  const std::string file = std::string(count > 1 ? words[1] : "data") + "/recording2.csv";
  const auto bytes = read_file(file);
  if (!bytes) return std::fprintf(stderr, "%s\n", bytes.error().message.c_str()), 2;

  FitOptions options;
  options.mass = Quantity{0.2176, 0.0003};  // kg
  const auto fits = fit(*bytes, file, options);
  if (!fits) return std::fprintf(stderr, "%s\n", fits.error().message.c_str()), 2;

  const FittedRecording& found = fits->front();
  std::printf("law: %s\n", to_text(found.fit.law).c_str());
  for (const NamedEstimate& each : found.parameters)
    std::printf("%-20s %s\n", each.name.c_str(),
                format_quantity({each.estimate.value, each.estimate.standard_error}, each.unit).c_str());
  return found.find("stiffness") ? 0 : 1;
}
