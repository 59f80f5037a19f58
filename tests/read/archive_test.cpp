// ZIP archives made here, as phyphox exports them, damaged ones, and where the limits are.
#include "cromer/read/formats/archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/support/archive_of.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::HasSubstr;

std::string names_of(const std::string& bytes) {
  const auto entries = zip_directory(bytes);
  if (!entries) return in_words(entries.error());
  std::string all;
  for (const ZipEntry& entry : *entries) all += entry.name + ";";
  return all;
}

/// What comes of the first file.
std::string content_of(const std::string& bytes) {
  const auto entries = zip_directory(bytes);
  if (!entries) return in_words(entries.error());
  const auto content = unzip(bytes, entries->front());
  return content ? *content : in_words(content.error());
}

std::size_t directory_of(const std::string& bytes) { return bytes.find("PK\x01\x02"); }

/// With so many bytes written over.
std::string with(std::string bytes, std::size_t at, const std::string& written) {
  return bytes.replace(at, written.size(), written);
}

const std::string abc = archive_of({{"a.csv", "0,1\n1,2\n"}, {"b.csv", "0,3\n"}, {"c.csv", "5\n"}}, false);
const std::string damaged = "the ZIP archive is damaged or not complete: export it again";

TEST(Zip, BeginsWithAFileOrIsEmpty) {
  EXPECT_TRUE(is_zip(abc));
  EXPECT_TRUE(is_zip(archive_of({})));
  EXPECT_FALSE(is_zip(abc.substr(1)));
  EXPECT_EQ(names_of(archive_of({})), "");
}

TEST(Zip, AThousandFilesAreRead) {
  std::vector<ArchivedFile> files(1000, {"a", ""});
  EXPECT_EQ(zip_directory(archive_of(files))->size(), 1000u);
  files.push_back({"a", ""});
  EXPECT_EQ(names_of(archive_of(files)), "the ZIP archive holds more than 1000 files: unpack it");
}

// Versions, times, attributes and the flags that say nothing of its packing.
TEST(Zip, WhatIsNotLookedAtMayBeAnything) {
  for (const bool pack : {false, true}) {
    std::string bytes = archive_of({{"a.csv", "0,1\n1,2\n"}}, pack);
    const std::string plain = content_of(bytes);
    const std::size_t directory = directory_of(bytes), end = bytes.size() - 22;
    for (const std::size_t at :
         {4u, 5u, 6u, 7u, 9u, 12u, 13u, 14u, 15u, 34u, 35u, 36u, 37u, 38u, 39u, 40u, 41u})
      bytes[directory + at] = '\xFF';
    bytes[directory + 8] = '\xFE';
    for (std::size_t at = 4; at < 26; ++at) bytes[at] = '\xFF';
    for (const std::size_t at : {4u, 5u, 6u, 7u, 8u, 9u, 12u, 13u, 14u, 15u}) bytes[end + at] = '\xFF';
    EXPECT_EQ(names_of(bytes), "a.csv;");
    EXPECT_EQ(content_of(bytes), plain);
    EXPECT_EQ(plain, "0,1\n1,2\n");
  }
}

TEST(Zip, ACommentMayEndIt) {
  EXPECT_EQ(names_of(abc), "a.csv;b.csv;c.csv;");
  EXPECT_EQ(names_of(abc + std::string(65535, ' ')), "a.csv;b.csv;c.csv;");
  EXPECT_EQ(names_of(abc + std::string(65536, ' ')), damaged);
  EXPECT_EQ(names_of(abc.substr(0, abc.size() - 1)), damaged);
  EXPECT_EQ(names_of(abc.substr(0, abc.size() - 22)), damaged);
}

TEST(Zip, ADamagedDirectoryIsRefused) {
  const std::size_t directory = directory_of(abc), end = abc.size() - 22;
  EXPECT_EQ(names_of(with(abc, end + 10, little(4, 2))), damaged);
  EXPECT_EQ(names_of(with(abc, end + 16, little(abc.size(), 4))), damaged);
  EXPECT_EQ(names_of(with(abc, directory, "PK\x01\x03")), damaged);
  EXPECT_EQ(names_of(with(abc, directory + 51 + 51, "xx")), damaged);
  // A name that would go on into the end; the last byte of it is still a name.
  EXPECT_EQ(names_of(with(abc, end - 51 + 28, little(6, 2))), damaged);
  EXPECT_EQ(names_of(with(abc, end - 51 + 28, little(4, 2))), "a.csv;b.csv;c.cs;");
  // All that is packed fits into the archive.
  EXPECT_EQ(names_of(with(abc, directory + 20, little(abc.size() - 6, 4))), "a.csv;b.csv;c.csv;");
  EXPECT_EQ(names_of(with(abc, directory + 20, little(abc.size() - 5, 4))), damaged);
}

TEST(Zip, ExtrasAndCommentsOfFilesArePassedOver) {
  const std::size_t directory = directory_of(abc), first_ends = directory + 46 + 5;
  const auto begun_later = [&](std::size_t by, std::string bytes) {
    bytes.insert(first_ends, std::string(by, 'x'));
    return bytes;
  };
  EXPECT_EQ(names_of(begun_later(300, with(abc, directory + 30, little(300, 2)))), "a.csv;b.csv;c.csv;");
  EXPECT_EQ(names_of(begun_later(300, with(abc, directory + 32, little(300, 2)))), "a.csv;b.csv;c.csv;");
  EXPECT_EQ(
      names_of(begun_later(3, with(with(abc, directory + 30, little(1, 2)), directory + 32, little(2, 2)))),
      "a.csv;b.csv;c.csv;");
}

TEST(Zip, EachFileHasWhatItsEntrySays) {
  const std::string bytes = archive_of({{"folder/a.csv", std::string(300, 'a')}, {"b", "0,3\n"}}, true, 1);
  const auto entries = *zip_directory(bytes);
  EXPECT_EQ(entries[0].name, "folder/a.csv");
  EXPECT_EQ(entries[0].method, 8u);
  EXPECT_EQ(entries[0].size, 300u);
  EXPECT_EQ(entries[0].packed, deflated(std::string(300, 'a')).size());
  EXPECT_EQ(entries[0].offset, 0u);
  EXPECT_EQ(entries[1].offset, 30 + 12 + entries[0].packed);
  EXPECT_TRUE(entries[1].encrypted);
  EXPECT_FALSE((*zip_directory(archive_of({{"b", "1"}}, true, 2)))[0].encrypted);
  EXPECT_EQ(entries[1].checksum, crc32(0, reinterpret_cast<const Bytef*>("0,3\n"), 4));
}

TEST(Zip, FilesAreStoredOrDeflated) {
  const std::string text = "0,1\n1,2\n";
  for (const bool pack : {true, false}) EXPECT_EQ(content_of(archive_of({{"a", text}}, pack)), text);
  const std::string one = archive_of({{"a", text}}, false);
  const std::size_t directory = directory_of(one);
  EXPECT_EQ(content_of(with(one, directory + 10, little(9, 2))),
            "the ZIP archive is packed by a method other than deflate: unpack it");
  EXPECT_EQ(content_of(with(one, directory + 8, little(1, 2))),
            "the ZIP archive is locked with a password: export it without");
  EXPECT_EQ(content_of(with(one, directory + 16, little(7, 4))), damaged);
  EXPECT_EQ(content_of(with(one, directory + 24, little(7, 4))), damaged);
  EXPECT_EQ(content_of(with(one, directory + 42, little(1, 4))), damaged);
  EXPECT_EQ(content_of(with(one, directory + 42, little(one.size(), 4))), damaged);
  // What stands between the local header and the data is passed over.
  std::string extra = with(one, 28, little(300, 2));
  extra.insert(31, std::string(300, 'x'));
  EXPECT_EQ(content_of(with(extra, extra.size() - 6, little(directory + 300, 4))), text);
  const std::string packed = archive_of({{"a", text}});
  EXPECT_EQ(content_of(with(packed, directory_of(packed) + 24, little(9, 4))), damaged);
  EXPECT_EQ(content_of(with(packed, 31, "\xFF\xFF")), damaged);
}

TEST(Zip, AFileEndsWithinTheArchive) {
  const std::string bytes = std::string("PK\x03\x04", 4) + std::string(26, '\0') + "12345";
  const auto read = [&](std::size_t packed, std::size_t offset = 0) {
    ZipEntry entry;
    entry.packed = entry.size = packed;
    entry.offset = offset;
    entry.checksum = static_cast<unsigned>(crc32(0, reinterpret_cast<const Bytef*>("12345"), 5));
    const auto content = unzip(bytes, entry);
    return content ? *content : in_words(content.error());
  };
  EXPECT_EQ(read(5), "12345");
  EXPECT_EQ(read(6), damaged);
  EXPECT_EQ(read(4), damaged);
  ZipEntry empty;
  EXPECT_EQ(unzip(bytes.substr(0, 30), empty).value(), "");
  EXPECT_FALSE(unzip(bytes.substr(0, 29), empty).ok());
  EXPECT_FALSE(unzip(std::string(bytes).replace(26, 1, "\x06"), empty).ok());
  EXPECT_TRUE(unzip(std::string(bytes).replace(26, 1, "\x05"), empty).ok());
}

TEST(Zip, FiftyTimesItsPackedSizeAndTenKilobytesAreUnpacked) {
  const auto claims = [](std::size_t size) {
    std::string packed = deflated(std::string(size, ' '));
    packed.resize(40, ' ');  // behind the end nothing is read
    const std::string bytes = std::string("PK\x03\x04", 4) + std::string(26, '\0') + packed;
    ZipEntry entry;
    entry.method = 8;
    entry.packed = packed.size();
    entry.size = size;
    const std::string text(size, ' ');
    entry.checksum =
        static_cast<unsigned>(crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(size)));
    const auto content = unzip(bytes, entry);
    return content ? std::to_string(content->size()) : in_words(content.error());
  };
  EXPECT_EQ(claims(12000), "12000");
  EXPECT_EQ(claims(12001), "the ZIP archive claims to hold far more than its size: unpack it by hand");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string gyro =
    "\"Time (s)\",\"Gyroscope x (rad/s)\"\n0.0E0,1.5E0\n1.0E-1,-2.5E0\n2.0E-1,NaN\n3.0E-1,1.0E0\n";
const std::string acceleration = "\"Time (s)\";\"Acceleration x (m/s^2)\"\n0,0E0;1,5E0\n1,0E-1;2,5E0\n";
const ArchivedFile meta{"meta/device.csv", "\"property\",\"value\"\n\"version\",\"1.1\"\n"};

std::string refusal(const std::string& bytes) {
  const auto recording = read_recording(bytes, "export.zip", {});
  return recording ? "read" : in_words(recording.error());
}

TEST(Archive, OneDataSetIsOneRecording) {
  for (const bool pack : {true, false}) {
    const auto r = read_recording(archive_of({{"Raw Data.csv", gyro}, meta}, pack), "export.zip", {});
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
  const auto r = read_recording(archive_of({{"a/Accelerometer.csv", acceleration},
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
  const std::string good = archive_of({{"Raw Data.csv", gyro}});
  EXPECT_THAT(refusal(good.substr(0, good.size() - 30)), HasSubstr("damaged"));
  std::string flipped = good;
  flipped[60] = static_cast<char>(flipped[60] ^ 0x40);
  EXPECT_THAT(refusal(flipped), HasSubstr("damaged"));
  EXPECT_THAT(refusal(archive_of({{"Raw Data.csv", gyro}}, true, 1)), HasSubstr("password"));
  EXPECT_THAT(refusal(archive_of({{"[Content_Types].xml", "<x/>"}})),
              HasSubstr("spreadsheet: export the sheet as CSV"));
  EXPECT_THAT(refusal(archive_of({meta})), HasSubstr("holds no CSV file"));
  EXPECT_THAT(refusal(archive_of({{"Raw Data.csv", std::string(2'000'000, ' ')}})),
              HasSubstr("far more than its size"));
  EXPECT_THAT(refusal(archive_of({{"Raw Data.csv", "t,x\n0,1\n1,abc\n2,3\n"}})),
              HasSubstr("export.zip: \"Raw Data\":3: column \"x\": \"abc\" is not a number"));
}

const std::string table = "t (s),x (m)\n0,1\n1,2\n2,4\n";

std::vector<std::string> warnings_of(const std::vector<ArchivedFile>& files) {
  const auto recording = read_recording(archive_of(files), "export.zip", {});
  EXPECT_TRUE(recording.ok()) << in_words(recording.error());
  return recording ? in_words(recording->notices) : std::vector<std::string>{};
}

std::string dialect_of(const std::vector<ArchivedFile>& files) {
  return read_recording(archive_of(files), "export.zip", {})->dialect.name;
}

TEST(Archive, OnlyFilesThatEndAsTextAreLookedAt) {
  for (const char* name : {"a.csv", "a.TXT", "a.tsv", "b/a.dat", "csv.csv.txt", ".csv"})
    EXPECT_EQ(dialect_of({{name, table}, {"b.png", "\x89PNG"}, {"csv", "?"}}), "plain in ZIP") << name;
  for (const char* name : {"a.png", "csv", "acsv", ""})
    EXPECT_EQ(refusal(archive_of({{name, table}})), "export.zip: the ZIP archive holds no CSV file") << name;
  EXPECT_EQ(refusal(archive_of({{"content.xml", "<x/>"}})),
            "export.zip: this is a spreadsheet: export the sheet as CSV");
}

TEST(ProgramFile, IsAnsweredWithItsExportMenu) {
  const std::string zip = archive_of({{"main.xml", "<x/>"}}),
                    xml = "<?xml version=\"1.0\"?>\n<Document>\n1\n2\n</Document>";
  const auto refused = [](const std::string& bytes, const char* name) {
    return in_words(read_recording(bytes, name, {}).error());
  };
  EXPECT_EQ(refused(zip, "swing.CAP"),
            "swing.CAP: this is a file of PASCO Capstone's own: there, choose File > Export Data...");
  EXPECT_THAT(refused(xml, "a/swing.cmbl"),
              HasSubstr("Vernier Logger Pro's own: there, choose File > Export As > CSV"));
  EXPECT_THAT(refused(archive_of({{"[Content_Types].xml", "<x/>"}}), "swing.xlsx"),
              HasSubstr("File > Save As"));
  EXPECT_THAT(refused(zip, "swing.zip"), HasSubstr("holds no CSV file"));
  // A table is a table, whatever its name, and says what is wrong with it.
  EXPECT_THAT(refused("t (s),x (m)\n0,1\n1,oops\n2,4\n", "swing.xlsx"),
              HasSubstr("\"oops\" is not a number"));
  EXPECT_TRUE(read_recording("t (s),x (m)\n0,1\n1,2\n2,4\n", "swing.ds", {}).ok());
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
  EXPECT_THAT(refusal(archive_of({{"a.csv", ""}, {"b.csv", "abc"}})), HasSubstr("\"a\": the file is empty"));
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
      read_recording(archive_of({{"a.csv", "x (m)\n5\n6\n"}, {"b.csv", "x (m)\n7\n6\n"}}), "e.zip", {});
  ASSERT_TRUE(r.ok()) << in_words(r.error());
  EXPECT_THAT(runs(*r), ElementsAre(1, 2));
  EXPECT_TRUE(r->named);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
