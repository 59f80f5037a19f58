// The directory of a ZIP archive and its files: what is damaged, and where the limits are.
#include "cromer/read/formats/zip.h"
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/read/archives.h"

namespace cromer::core::dialects {
namespace {

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

const std::string abc = zipped({{"a.csv", "0,1\n1,2\n"}, {"b.csv", "0,3\n"}, {"c.csv", "5\n"}}, false);
const std::string damaged = "the ZIP archive is damaged or not complete: export it again";

TEST(Zip, BeginsWithAFileOrIsEmpty) {
  EXPECT_TRUE(is_zip(abc));
  EXPECT_TRUE(is_zip(zipped({})));
  EXPECT_FALSE(is_zip(abc.substr(1)));
  EXPECT_EQ(names_of(zipped({})), "");
}

TEST(Zip, AThousandFilesAreRead) {
  std::vector<File> files(1000, {"a", ""});
  EXPECT_EQ(zip_directory(zipped(files))->size(), 1000u);
  files.push_back({"a", ""});
  EXPECT_EQ(names_of(zipped(files)), "the ZIP archive holds more than 1000 files: unpack it");
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
  const std::string bytes = zipped({{"folder/a.csv", std::string(300, 'a')}, {"b", "0,3\n"}}, true, 1);
  const auto entries = *zip_directory(bytes);
  EXPECT_EQ(entries[0].name, "folder/a.csv");
  EXPECT_EQ(entries[0].method, 8u);
  EXPECT_EQ(entries[0].size, 300u);
  EXPECT_EQ(entries[0].packed, deflated(std::string(300, 'a')).size());
  EXPECT_EQ(entries[0].offset, 0u);
  EXPECT_EQ(entries[1].offset, 30 + 12 + entries[0].packed);
  EXPECT_TRUE(entries[1].encrypted);
  EXPECT_FALSE((*zip_directory(zipped({{"b", "1"}}, true, 2)))[0].encrypted);
  EXPECT_EQ(entries[1].checksum, crc32(0, reinterpret_cast<const Bytef*>("0,3\n"), 4));
}

TEST(Zip, FilesAreStoredOrDeflated) {
  const std::string text = "0,1\n1,2\n";
  for (const bool pack : {true, false}) EXPECT_EQ(content_of(zipped({{"a", text}}, pack)), text);
  const std::string one = zipped({{"a", text}}, false);
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
  const std::string packed = zipped({{"a", text}});
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

}  // namespace
}  // namespace cromer::core::dialects
