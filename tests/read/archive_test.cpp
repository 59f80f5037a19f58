// ZIP archives made here, as phyphox exports them, and damaged ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/read/archives.h"

namespace cromer::core {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string gyro =
    "\"Time (s)\",\"Gyroscope x (rad/s)\"\n0.0E0,1.5E0\n1.0E-1,-2.5E0\n2.0E-1,NaN\n3.0E-1,1.0E0\n";
const std::string acceleration = "\"Time (s)\";\"Acceleration x (m/s^2)\"\n0,0E0;1,5E0\n1,0E-1;2,5E0\n";
const File meta{"meta/device.csv", "\"property\",\"value\"\n\"version\",\"1.1\"\n"};

std::string refusal(const std::string& bytes) {
  const auto recording = read_recording(bytes, "export.zip", {});
  return recording ? "read" : in_words(recording.error());
}

TEST(Archive, OneDataSetIsOneRecording) {
  for (const bool pack : {true, false}) {
    const auto r = read_recording(zipped({{"Raw Data.csv", gyro}, meta}, pack), "export.zip", {});
    ASSERT_TRUE(r.ok()) << in_words(r.error());
    EXPECT_EQ(r->dialect.name, "phyphox ZIP");
    EXPECT_EQ(runs(*r).size(), 1u);
    const auto series = take_series(*r, "", 1, {});
    ASSERT_TRUE(series.ok()) << in_words(series.error());
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
  ASSERT_TRUE(r.ok()) << in_words(r.error());
  EXPECT_THAT(runs(*r), ElementsAre(1, 2));
  EXPECT_EQ(column_title(r->table.columns.at(3)), "Gyroscope x (rad/s)");
  EXPECT_THAT(r->table.columns[1].values, ElementsAre(1.5, 2.5, testing::IsNan(), testing::IsNan()));
  EXPECT_THAT(in_words(r->notices), Contains("run 2 is called \"Gyroscope\" in the file"));
  EXPECT_THAT(in_words(r->notices), Contains("left out of the archive: \"Results\": it has no times"));
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

const std::string table = "t (s),x (m)\n0,1\n1,2\n2,4\n";

std::vector<std::string> warnings_of(const std::vector<File>& files) {
  const auto recording = read_recording(zipped(files), "export.zip", {});
  EXPECT_TRUE(recording.ok()) << in_words(recording.error());
  return recording ? in_words(recording->notices) : std::vector<std::string>{};
}

std::string dialect_of(const std::vector<File>& files) {
  return read_recording(zipped(files), "export.zip", {})->dialect.name;
}

TEST(Archive, OnlyFilesThatEndAsTextAreLookedAt) {
  for (const char* name : {"a.csv", "a.TXT", "a.tsv", "b/a.dat", "csv.csv.txt", ".csv"})
    EXPECT_EQ(dialect_of({{name, table}, {"b.png", "\x89PNG"}, {"csv", "?"}}), "plain in ZIP") << name;
  for (const char* name : {"a.png", "csv", "acsv", ""})
    EXPECT_EQ(refusal(zipped({{name, table}})), "export.zip: the ZIP archive holds no CSV file") << name;
  EXPECT_EQ(refusal(zipped({{"content.xml", "<x/>"}})),
            "export.zip: this is a spreadsheet: export the sheet as CSV");
}

TEST(Archive, NotesOfPhonesAreNoData) {
  for (const char* notes : {"meta/time.csv", "a/meta/time.csv"})
    EXPECT_EQ(dialect_of({{"a.csv", table}, {notes, "t (s),x (m)\n5,6\n6,7\n"}}), "phyphox ZIP") << notes;
  EXPECT_EQ(warnings_of({{"__MACOSX/._a.csv", "abc"}, {"a.csv", table}}).size(), 0u);
  EXPECT_EQ(dialect_of({{"a.csv", gyro}}), "phyphox ZIP");
}

TEST(Archive, WhatCannotBeReadBesideTheOthersIsSaid) {
  EXPECT_THAT(warnings_of({{"b/bad.csv", "t,x\n0,1\n1,abc\n"}, {"a.csv", table}, {"empty.csv", ""}}),
              ElementsAre("left out of the archive: \"bad\":3: column \"x\": \"abc\" is not a number; "
                          "--skip-bad-rows drops such rows",
                          "left out of the archive: \"empty\": the file is empty"));
  EXPECT_THAT(refusal(zipped({{"a.csv", ""}, {"b.csv", "abc"}})), HasSubstr("\"a\": the file is empty"));
}

TEST(Archive, WarningsNameTheFileWhereThereAreSeveral) {
  EXPECT_THAT(warnings_of({{"a.csv", "0 1\n1 2\n2 4\n"}}),
              ElementsAre("\"column 1\" runs evenly upward: it is taken as the time in seconds"));
  const std::string nine = "t;x\n0;1,25\n1;1,25\n2;1,25\n3;1,25\n4;1,25\n5;1,25\n6;1,25\n7;1,25\n8;1,2";
  EXPECT_THAT(warnings_of({{"a.csv", nine}}), Contains(testing::StartsWith("the last line, 10")));
  EXPECT_THAT(warnings_of({{"a.csv", nine}, {"b.csv", table}}),
              Contains(testing::StartsWith("\"a\": the last line, 10")));
  EXPECT_THAT(warnings_of({{"a.csv", table}, {"b.csv", table}}),
              ElementsAre("run 1 is called \"a\" in the file", "run 2 is called \"b\" in the file"));
}

TEST(Archive, FilesWithoutTimesAreReadWhereNoneHasThem) {
  const auto r =
      read_recording(zipped({{"a.csv", "x (m)\n5\n6\n"}, {"b.csv", "x (m)\n7\n6\n"}}), "e.zip", {});
  ASSERT_TRUE(r.ok()) << in_words(r.error());
  EXPECT_THAT(runs(*r), ElementsAre(1, 2));
  EXPECT_TRUE(r->named);
}

}  // namespace
}  // namespace cromer::core
