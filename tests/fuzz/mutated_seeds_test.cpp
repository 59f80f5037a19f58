// Each target on its seeds and on what becomes of them by some thousands of changes, the same in every run.
// The fuzzers themselves reach further (see CMakeLists.txt); this sees what a change of the code breaks at
// once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "targets.h"
#include "tests/support/bytes_of.h"
#include "tests/support/cases.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);  // of a recording

namespace cromer::core::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> seeds_in(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> seeds;
  for (const fs::path& path : paths) seeds.push_back(bytes_of(path));
  return seeds;
}

std::string changed(std::string text, const std::string& other, std::mt19937& engine) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : engine() % n; };
  constexpr std::string_view hard = "0123456789.,;+-eE \t\r\n\"'[]{}=()#%\x1b\xC2\xB1\xE2\x88\x92\xff\x00";
  for (std::size_t count = 1 + below(6); count > 0; --count) {
    const std::size_t at = below(text.size() + 1), length = below(12);
    switch (below(6)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, 1, hard[below(hard.size())]);
        break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(engine());
        break;
      case 3:
        text.insert(at, text.substr(below(text.size() + 1), length));
        break;
      case 4:
        text.insert(at, other.substr(below(other.size() + 1), 4 * length));
        break;
      default:
        text.resize(std::min(text.size(), at + length));
    }
  }
  return text;
}

struct Fuzzed {
  const char *name, *folder;
  Target target;
  int times;
};

void PrintTo(const Fuzzed& fuzzed, std::ostream* out) { *out << fuzzed.name; }

class MutatedSeeds : public testing::TestWithParam<Fuzzed> {};

TEST_P(MutatedSeeds, AreReadOrRefused) {
  const auto [name, folder, target, usual] = GetParam();
  const std::vector<std::string> seeds = seeds_in(fs::path(CROMER_SOURCE_DIR) / "tests" / "fuzz" / folder);
  // Many more by hand: CROMER_FUZZ_TIMES=50000 test_fuzz_targets
  const char* wanted = std::getenv("CROMER_FUZZ_TIMES");
  const int times = wanted ? std::atoi(wanted) : cases(usual);
  ASSERT_GE(seeds.size(), 3u);
  std::mt19937 engine(7);
  for (int i = 0; i < times; ++i) {
    const std::string& seed = seeds[engine() % seeds.size()];
    const std::string bytes = static_cast<std::size_t>(i) < seeds.size()
                                  ? seeds[static_cast<std::size_t>(i)]
                                  : changed(seed, seeds[engine() % seeds.size()], engine);
    // A copy that ends where the bytes do: reading beyond it is seen by the sanitizers.
    const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
    EXPECT_EQ(target(copy.data(), copy.size()), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, MutatedSeeds,
                         testing::Values(Fuzzed{"live_lines", "seeds/live_lines", live_lines, 600000},
                                         Fuzzed{"quantity", "seeds/quantity", quantity, 500000},
                                         Fuzzed{"http", "seeds/http", http, 30000},
                                         Fuzzed{"study", "seeds/study", study, 12000},
                                         Fuzzed{"recording", "corpus", LLVMFuzzerTestOneInput, 120000}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace cromer::core::fuzz
