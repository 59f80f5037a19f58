// Do the intervals hold? For each law and each condition many simulated records are fitted and the 95 %
// intervals counted that hold the truth; then motions under a force; then the laws are left to the program to
// choose.
//
//   calibration [RECORDS] [--only TEXT] [--figure FILE.svg|png]
//
// RECORDS for each law and condition (2000), ten times as many in the base condition and with the viscous
// law: enough to judge the scatter to half a percent. --only takes those rows whose "law, condition" contains
// the text.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/calibration/calibrate.h"
#include "bench/calibration/coverage_figure.h"
#include "bench/calibration/forced_rows.h"
#include "cromer/documents/words/words.h"

namespace {

using namespace cromer::core::bench;

struct Options {
  std::size_t records = 2000;
  std::string only, figure;
};

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--only" && i + 1 < argc)
      options.only = argv[++i];
    else if (word == "--figure" && i + 1 < argc)
      options.figure = argv[++i];
    else if (const long records = std::atol(argv[i]); records > 0)
      options.records = static_cast<std::size_t>(records);
    else {
      std::fprintf(stderr, "usage: calibration [RECORDS] [--only TEXT] [--figure FILE.svg|png]\n");
      std::exit(2);
    }
  }
  return options;
}

// One line that rewrites itself, on a terminal only.
Progress progress_of(const std::string& row, std::size_t records) {
  if (!isatty(STDERR_FILENO)) return [](std::size_t) {};
  return [=](std::size_t done) {
    std::fprintf(stderr, "\r%-48s %zu of %zu\033[K%s", row.c_str(), done, records,
                 done + 50 > records ? "\r\033[K" : "");
  };
}

void print(const Tally& tally) {
  std::printf("%-22s %-26s %6zu %6.2f %6.1f ", tally.law, tally.condition, tally.records,
              100 * tally.failures, 100 * tally.on_bound);
  for (const ParameterTally& p : tally.parameters)
    std::printf(" | %.9s %.1f %.3f %.3f", p.name.c_str(), 100 * p.coverage, p.scatter, p.stated);
  std::printf("\n");
  std::fflush(stdout);
}

int write_figure(const std::vector<Tally>& tallies, const std::string& path) {
  const auto format = cromer::core::figure_format(path);
  const auto picture = format ? cromer::core::draw(coverage_figure(tallies), *format) : format.error();
  if (!picture) {
    std::fprintf(stderr, "calibration: --figure %s: %s\n", path.c_str(),
                 cromer::core::in_words(picture.error()).c_str());
    return 1;
  }
  std::FILE* file = std::fopen(path.c_str(), "wb");
  const bool written = file && std::fwrite(picture->data(), 1, picture->size(), file) == picture->size();
  if (!file || std::fclose(file) != 0 || !written) {
    std::fprintf(stderr, "calibration: cannot write %s\n", path.c_str());
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  std::printf(
      "%-22s %-26s %6s %6s %6s  | parameter, coverage of its 95 %% interval (%%), scatter over the "
      "Cramér-Rao bound\n",
      "law", "condition", "fits", "fail %", "at 0 %");
  std::printf("%66s  and standard error (both root mean square) over the Cramér-Rao bound\n", "");
  std::vector<Tally> tallies;
  for (const TrueLaw& law : true_laws)
    for (const Condition& condition : conditions) {
      const std::string row = std::string(law.law) + ", " + condition.name;
      if (row.find(options.only) == std::string::npos) continue;
      const bool cheap = std::string(law.law) == "viscous", base = std::string(condition.name) == "base";
      const std::size_t records = options.records * (cheap || base ? 10 : 1);
      tallies.push_back(calibrate(law, condition, records, progress_of(row, records)));
      print(tallies.back());
    }
  for (const ForcedRow& forced : forced_rows) {
    const std::string row = std::string(forced.law) + ", " + forced.condition;
    if (row.find(options.only) == std::string::npos) continue;
    tallies.push_back(calibrate(forced, options.records, progress_of(row, options.records)));
    print(tallies.back());
  }
  std::printf("\n%-22s %-17s %6s %9s %9s %9s\n", "auto, true law", "its weakest term", "fits", "right %",
              "needless %", "missed %");
  for (const double strength : {0.0, 6.5})  // as above, and as weak as a term may be that must be found
    for (const TrueLaw& law : true_laws) {
      const std::string row = std::string("auto, ") + law.law;
      const bool has_extra = std::string(law.law).find('+') != std::string::npos;
      if (row.find(options.only) == std::string::npos || (strength > 0 && !has_extra)) continue;
      const Choices c =
          choose(law, conditions[0], strength, options.records, progress_of(row, options.records));
      std::printf("%-22s %5.1f std. errors %6zu %9.2f %9.2f %9.2f\n", c.law, c.strength, c.records,
                  100 * c.right, 100 * c.needless, 100 * c.missed);
      std::fflush(stdout);
    }
  return options.figure.empty() ? 0 : write_figure(tallies, options.figure);
}
