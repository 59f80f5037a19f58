// Files made to cost time or memory that their size does not announce: read or refused, in memory
// proportional to their size. A loop that is quadratic in their length does not end within the test's time.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "cromer/base/concat.h"
#include "memory_meter.h"
#include "tests/support/archive_of.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace cromer::core {
namespace {

constexpr std::size_t million = 1'000'000;

std::string times(std::size_t count, std::string_view piece) {
  std::string text;
  text.reserve(count * piece.size());
  for (std::size_t i = 0; i < count; ++i) text.append(piece);
  return text;
}

/// A file, and the fuzzer's first byte for how it is read: 1 skips bad rows, 32 calls it .AT2.
struct Hostile {
  const char* name;
  std::string (*file)();
  char options = 0;
  std::size_t most_times = 200;  ///< its size
};

void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.name; }

class HostileFiles : public testing::TestWithParam<Hostile> {};

TEST_P(HostileFiles, CostMemoryInProportion) {
  const std::string bytes = GetParam().options + GetParam().file();
  const std::size_t most = most_bytes_held([&] {
    EXPECT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), 0);
  });
  // An empty line costs two words for its byte, a value five and more for two bytes; what is packed may be
  // fifty times as long.
  EXPECT_LT(most, GetParam().most_times * bytes.size() + million);
  RecordProperty("times_its_size", static_cast<int>(most / bytes.size()));
}

/// A bomb where the text repeats itself.
std::string zipped(const std::string& text) { return archive_of({{"a.csv", text}}); }

/// Dataset 58 that announces a million million points and holds two, as text or as binary.
std::string uff(bool binary) {
  std::string text = "    -1\n";
  text += binary ? concat({"    58b     1     2          11", "  1000000000000", times(38, " "), "\n"})
                 : std::string("    58\n");
  text += "Response\nNONE\nNONE\nNONE\nNONE\n";
  text += "    1         0    1         0 NONE               1   3 NONE               0   0\n";
  text += "         2 1000000000     1  0.00000E+00  1.00000E-02  0.00000E+00\n";
  text += "        17    0    0    0 Time                 s                   \n";
  text += "        12    0    0    0 Acceleration         m/s^2               \n";
  text += "         0    0    0    0 NONE                 NONE                \n";
  text += "         0    0    0    0 NONE                 NONE                \n";
  return text + (binary ? std::string(8, '\1') : "  1.00000E+00  2.00000E+00\n") + "    -1\n";
}

const std::string labview = "LabVIEW Measurement\nSeparator\tTab\nX_Columns\tOne\n***End_of_Header***\n\n";
const std::string segment = "Channels\t1\n***End_of_Header***\n";
const std::string vernier = "Vernier Format 2\nLab.cmbl 1/1/2020 12:00:00\n";

/// Rows that hardly pack.
std::string random_rows(std::size_t count) {
  std::string text;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < count; ++i)
    for (const char end : {',', '\n'}) {
      state = state * 1664525 + 1013904223;
      text += std::to_string(state) + end;
    }
  return text;
}

std::string numbered_runs(int count) {
  std::string text = "run,t,x\n";
  for (int i = 0; i < 3 * count; ++i)
    text += concat({std::to_string(i / 3), ",", std::to_string(i % 3), ",1\n"});
  return text;
}

const Hostile hostile_files[] = {
    {"a zip bomb", [] { return zipped(times(5 * million, "0,0\n")); }},
    {"a zip that unpacks to nearly as much as is allowed",
     [] { return zipped(times(million, "0,0\n") + random_rows(million / 100)); }, 0, 2000},
    {"uff of 1e12 points", [] { return uff(false); }},
    {"binary uff of 1e12 bytes", [] { return uff(true); }},
    {"a hundred thousand datasets",
     [] { return times(100'000, "    -1\n    58\n" + times(11, "\n") + "    -1\n"); }},
    {"peer of 1e300 values", [] { return std::string("Motion\nNPTS= 1e300, DT= 0.01 SEC\n 1.0 2.0 3.0\n"); },
     32},
    {"a million columns", [] { return times(million, "a,") + "\n" + times(million, "1,") + "\n"; }},
    {"a million columns of one row", [] { return times(million, "1,"); }},
    {"a million columns of labview",
     [] { return labview + segment + times(million, "a\t") + "a\n" + times(60, "1\t2\n"); }},
    {"a million columns of vernier",
     [] { return vernier + "Run\n" + times(million, "a\t") + "a\na\ns\n" + times(60, "1\t2\n"); }},
    {"a line of a million letters", [] { return times(million, "x"); }},
    {"a line of a million letters above rows",
     [] { return times(million, "x") + ",y\n" + times(20, "1,2\n"); }},
    {"a line of a million digits", [] { return times(million, "7"); }},
    {"a line of a million commas", [] { return times(million, ","); }},
    {"a line of a million blanks", [] { return times(million, " "); }},
    {"a line of a million quotes", [] { return times(million, "\""); }},
    {"a line of quoted blanks", [] { return times(million / 3, "\"\" ") + "\n1 2\n2 3\n"; }},
    {"a line of a million brackets", [] { return times(million, "(") + "\n1 2\n2 3\n"; }},
    {"a bracket never closed", [] { return "(" + times(million / 2, "a ") + "\n1 2\n2 3\n"; }},
    {"a million empty lines", [] { return times(million, "\n"); }},
    {"a million empty lines among wide rows",
     [] { return times(100, times(1000, "1,") + "1\n") + times(million, "\n"); }},
    {"a million short rows among wide ones",
     [] { return times(400, times(1000, "1,") + "1\n") + times(million, "1\n"); }},
    {"a million rows without a number among wide ones",
     [] { return times(400, times(1000, "1,") + "1\n") + times(million, "-\n"); }},
    {"a million lines ended by CR", [] { return times(million, "\r"); }},
    {"rows ended by CR", [] { return "t,x\r" + times(million / 4, "1,2\r"); }},
    {"rows ended by CR, and one LF", [] { return "t,x\r" + times(million / 4, "1,2\r") + "\n"; }},
    {"a million zero bytes", [] { return std::string(million, '\0'); }},
    {"rows with a zero byte", [] { return "t,x\n" + times(million / 4, "1,2\n") + std::string(1, '\0'); }},
    {"a million zeros of utf-16", [] { return times(million, std::string("0\0", 2)); }},
    {"half a million words under a name as long",
     [] {
       return "t," + times(million / 2, "x") + "\n" + times(million / 4, "1,2\n") +
              times(million / 4, "1,x\n");
     },
     1},
    {"a hundred thousand sets of vernier", [] { return vernier + times(100'000, "R\na\nb\nc\n\n1\n"); }},
    {"two thousand sets of vernier", [] { return vernier + times(2000, "R\na\tb\nb\nc\n\n1\t2\n"); }},
    {"a hundred thousand segments of labview",
     [] { return labview + times(100'000, segment + "X_Value\ta\n1\t2\n0\t1\n"); }},
    {"sets of vernier with many columns",
     [] {
       return vernier + times(40, "R\n" + times(1999, "t\t") + "t\nb\ns\n\n" + times(1999, "1\t") + "1\n");
     }},
    {"three thousand runs", [] { return numbered_runs(3000); }},
};

INSTANTIATE_TEST_SUITE_P(Files, HostileFiles, testing::ValuesIn(hostile_files));

}  // namespace
}  // namespace cromer::core
