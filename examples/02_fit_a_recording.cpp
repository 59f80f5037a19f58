// From a logger's file to the law of motion, each number with its uncertainty.
#include <cromer/cromer.h>

#include <cstdio>
#include <string>

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : "data";
  const auto swing = cromer::read_file(folder + "/recording2.csv");
  if (!swing) return std::fprintf(stderr, "%s\n", swing.error().message().c_str()), 2;
  const auto fits = cromer::fit(*swing, {.mass = {0.2176, 0.0003}});
  if (!fits) return std::fprintf(stderr, "%s\n", fits.error().message().c_str()), 2;
  for (const cromer::LawFit& fit : *fits) {
    std::printf("run %d: %s\n", fit.run, fit.law.c_str());
    for (const cromer::Parameter& each : fit.parameters) {
      const cromer::Quantity number{each.estimate.value, each.estimate.standard_error};
      std::printf("  %-18s %s\n", each.name.c_str(), cromer::format_quantity(number, each.unit).c_str());
    }
  }
}
