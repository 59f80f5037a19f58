// ZIP archives made here, as phyphox exports them, and damaged ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "cromer/base/concat.h"
#include "cromer/record/dialects/columns.h"
#include "cromer/record/dialects/recording.h"

namespace cromer {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::string little(std::size_t value, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k) & 0xFFu);
  return text;
}

std::string deflated(const std::string& text) {
  std::string packed(text.size() + 100, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string input = text;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

struct File {
  std::string name, text;
};

/// An archive by the specification: local headers with their data, the directory, its end.
std::string zipped(const std::vector<File>& files, bool pack = true, std::size_t flags = 0) {
  std::string data, directory;
  for (const File& file : files) {
    const std::string packed = pack ? deflated(file.text) : file.text;
    const auto* bytes = reinterpret_cast<const Bytef*>(file.text.data());
    const std::string about =
        concat({little(20, 2), little(flags, 2), little(pack ? 8 : 0, 2), little(0, 4),
                little(crc32(0, bytes, static_cast<uInt>(file.text.size())), 4), little(packed.size(), 4),
                little(file.text.size(), 4), little(file.name.size(), 2), little(0, 2)});
    directory += concat({"PK\x01\x02", little(20, 2), about, little(0, 2), little(0, 2), little(0, 2),
                         little(0, 4), little(data.size(), 4), file.name});
    data += concat({"PK\x03\x04", about, file.name, packed});
  }
  const std::string end =
      concat({"PK\x05\x06", little(0, 4), little(files.size(), 2), little(files.size(), 2),
              little(directory.size(), 4), little(data.size(), 4), little(0, 2)});
  return data + directory + end;
}

const std::string gyro =
    "\"Time (s)\",\"Gyroscope x (rad/s)\"\n0.0E0,1.5E0\n1.0E-1,-2.5E0\n2.0E-1,NaN\n3.0E-1,1.0E0\n";
const std::string acceleration = "\"Time (s)\";\"Acceleration x (m/s^2)\"\n0,0E0;1,5E0\n1,0E-1;2,5E0\n";
const File meta{"meta/device.csv", "\"property\",\"value\"\n\"version\",\"1.1\"\n"};

std::string refusal(const std::string& bytes) {
  const auto recording = read_recording(bytes, "export.zip", {});
  return recording ? "read" : recording.error().message;
}

TEST(Archive, OneDataSetIsOneRecording) {
  for (const bool pack : {true, false}) {
    const auto r = read_recording(zipped({{"Raw Data.csv", gyro}, meta}, pack), "export.zip", {});
    ASSERT_TRUE(r.ok()) << r.error().message;
    EXPECT_EQ(r->dialect.name, "phyphox ZIP");
    EXPECT_EQ(runs(*r).size(), 1u);
    const auto series = take_series(*r, "", 1, {});
    ASSERT_TRUE(series.ok()) << series.error().message;
    EXPECT_THAT(series->y, ElementsAre(1.5, -2.5, 1));
    EXPECT_THAT(series->lines, ElementsAre(2, 3, 5));
  }
}

TEST(Archive, DataSetsAreRunsCalledByTheirFiles) {
  const auto r = read_recording(zipped({{"a/Accelerometer.csv", acceleration},
                                        {"a/Gyroscope.csv", gyro},
                                        {"a/Results.csv", "\"f (Hz)\"\n1.5E0\n"},
                                        {"a/meta/time.csv", "\"event\"\n\"START\"\n"}}),
                                "export.zip", {});
  ASSERT_TRUE(r.ok()) << r.error().message;
  EXPECT_THAT(runs(*r), ElementsAre(1, 2));
  EXPECT_EQ(column_title(r->table.columns.at(3)), "Gyroscope x (rad/s)");
  EXPECT_THAT(r->table.columns[1].values, ElementsAre(1.5, 2.5, testing::IsNan(), testing::IsNan()));
  EXPECT_THAT(r->warnings, Contains("run 2 is called \"Gyroscope\" in the file"));
  EXPECT_THAT(r->warnings, Contains("left out of the archive: \"Results\": it has no times"));
}

TEST(Archive, WhatCannotBeReadIsRefused) {
  const std::string good = zipped({{"Raw Data.csv", gyro}});
  EXPECT_THAT(refusal(good.substr(0, good.size() - 30)), HasSubstr("damaged"));
  std::string flipped = good;
  flipped[60] = static_cast<char>(flipped[60] ^ 0x40);
  EXPECT_THAT(refusal(flipped), HasSubstr("damaged"));
  EXPECT_THAT(refusal(zipped({{"Raw Data.csv", gyro}}, true, 1)), HasSubstr("password"));
  EXPECT_THAT(refusal(zipped({{"[Content_Types].xml", "<x/>"}})),
              HasSubstr("spreadsheet: export the sheet as CSV"));
  EXPECT_THAT(refusal(zipped({meta})), HasSubstr("holds no CSV file"));
  EXPECT_THAT(refusal(zipped({{"Raw Data.csv", std::string(2'000'000, ' ')}})),
              HasSubstr("far more than its size"));
  EXPECT_THAT(refusal(zipped({{"Raw Data.csv", "t,x\n0,1\n1,abc\n2,3\n"}})),
              HasSubstr("export.zip: \"Raw Data\":3: column \"x\": \"abc\" is not a number"));
}

}  // namespace
}  // namespace cromer
