// HDF5 files of rows: what is in them, read by HDF5 itself; going on with them; what is refused.
#include "cromer/cluster/rows_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "cromer/documents/words/words.h"
#include "tests/cluster/started.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

using test::exists;
using testing::HasSubstr;

/// 6 x 35 points, in chunks of 8 rows: swept values and two measures.
struct Sample {
  test::Folder folder{};
  ChunkedRows work{};
  RowsFileOptions options{};

  Sample() {
    work.columns = {"damping (kg/s)", "drive_frequency (rad/s)", "amplitude (m)", "gain"};
    work.rows = 210;
    work.rows_per_chunk = 8;
    work.description = R"({"stiffness": 9, "drive": {"amplitude": 1}})";
    options.path = folder / "sweep.h5";
    options.axes = {{"damping (kg/s)", Grid(0.1, 0.6, 6, false)},
                    {"drive_frequency (rad/s)", Grid(1, 10, 35, true)}};
    options.program = "cromer test";
    options.command = "cromer sweep";
  }
  std::vector<double> rows(std::uint64_t chunk) const {
    std::vector<double> made;
    for (std::uint64_t r = chunk * 8; r < chunk * 8 + work.rows_of(chunk); ++r)
      for (const double number : {options.axes[0].values[r / 35], options.axes[1].values[r % 35],
                                  std::sqrt(static_cast<double>(r)), 1.0 / static_cast<double>(r + 1)})
        made.push_back(number);
    return made;
  }
  /// Writes those chunks; whether it could.
  bool write(const std::vector<std::uint64_t>& chunks) {
    auto file = RowsFile::open(work, options, {});
    EXPECT_TRUE(file) << in_words(file.error());
    if (!file) return false;
    for (const std::uint64_t chunk : chunks) EXPECT_TRUE(file->write(chunk, rows(chunk).data()));
    EXPECT_TRUE(file->close());
    return true;
  }
  std::string refusal() const {
    auto file = RowsFile::open(work, options, {});
    return file ? "" : in_words(file.error());
  }
};

std::vector<std::uint64_t> from_to(std::uint64_t begin, std::uint64_t end) {
  std::vector<std::uint64_t> chunks;
  for (; begin < end; ++begin) chunks.push_back(begin);
  return chunks;
}

/// A dataset as HDF5 reads it, with its shape.
struct Dataset {
  std::vector<hsize_t> shape{};
  std::vector<double> numbers{};
};

Dataset dataset(const std::string& path, const char* name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
  Dataset read;
  read.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, read.shape.data(), nullptr);
  read.numbers.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, read.numbers.data()), 0);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(file);
  return read;
}

std::string text_of(const std::string& path, const char* object, const char* name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  std::string text(H5Tget_size(type), '\0');
  H5Aread(attribute, type, text.data());
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(file);
  return text.c_str();
}

TEST(RowsFile, holds_columns_axes_units_and_provenance) {
  Sample s;
  ASSERT_TRUE(s.write(from_to(0, 27)));
  EXPECT_FALSE(exists(s.options.path + ".journal")) << "all is finished";
  EXPECT_FALSE(exists(s.options.path + ".new"));
  const Dataset amplitude = dataset(s.options.path, "amplitude"), gain = dataset(s.options.path, "gain"),
                damping = dataset(s.options.path, "damping"),
                frequency = dataset(s.options.path, "drive_frequency");
  EXPECT_EQ(amplitude.shape, (std::vector<hsize_t>{6, 35}));
  EXPECT_EQ(damping.shape, (std::vector<hsize_t>{6}));
  EXPECT_EQ(frequency.shape, (std::vector<hsize_t>{35}));
  for (std::size_t r = 0; r < 210; ++r) {
    EXPECT_EQ(amplitude.numbers[r], std::sqrt(static_cast<double>(r)));
    EXPECT_EQ(gain.numbers[r], 1.0 / static_cast<double>(r + 1));
  }
  for (std::size_t i = 0; i < 35; ++i) EXPECT_EQ(frequency.numbers[i], s.options.axes[1].values[i]);
  EXPECT_EQ(damping.numbers[5], 0.6);
  EXPECT_EQ(text_of(s.options.path, "amplitude", "unit"), "m");
  EXPECT_EQ(text_of(s.options.path, "gain", "unit"), "1");
  EXPECT_EQ(text_of(s.options.path, "gain", "axes"), "damping drive_frequency");
  EXPECT_EQ(text_of(s.options.path, "/", "description"), s.work.description);
  EXPECT_EQ(text_of(s.options.path, "/", "program"), "cromer test");
  EXPECT_EQ(text_of(s.options.path, "/", "command"), "cromer sweep");
}

TEST(RowsFile, is_the_same_bytes_in_any_order_and_in_any_number_of_goes) {
  Sample once, later;
  ASSERT_TRUE(once.write(from_to(0, 27)));
  auto backward = from_to(10, 27);
  std::reverse(backward.begin(), backward.end());
  ASSERT_TRUE(later.write(backward));
  EXPECT_TRUE(exists(later.options.path + ".journal"));
  later.options.resume = true;
  ASSERT_TRUE(later.write({3, 1}));
  {
    auto file = RowsFile::open(later.work, later.options, {});
    ASSERT_TRUE(file);
    EXPECT_EQ(file->unfinished(), (std::vector<std::uint64_t>{0, 2, 4, 5, 6, 7, 8, 9}));
  }
  ASSERT_TRUE(later.write({0, 2, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(bytes_of(once.options.path), bytes_of(later.options.path));
  auto complete = RowsFile::open(later.work, later.options, {});
  ASSERT_TRUE(complete);
  EXPECT_TRUE(complete->complete());
}

TEST(RowsFile, holds_nan_where_nothing_is_finished) {
  Sample s;
  ASSERT_TRUE(s.write({1}));
  const Dataset amplitude = dataset(s.options.path, "amplitude");
  EXPECT_TRUE(std::isnan(amplitude.numbers[7]));
  EXPECT_EQ(amplitude.numbers[8], std::sqrt(8.0));
  EXPECT_TRUE(std::isnan(amplitude.numbers[16]));
  EXPECT_EQ(dataset(s.options.path, "damping").numbers[0], 0.1) << "axes are there from the beginning";
}

TEST(RowsFile, gives_back_the_rows_it_took) {
  Sample s;
  s.options.resume = true;
  ASSERT_TRUE(s.write({1, 26}));
  auto file = RowsFile::open(s.work, s.options, {});
  ASSERT_TRUE(file);
  for (const std::uint64_t chunk : {1, 26}) {
    std::vector<double> rows(s.work.rows_of(chunk) * 4);
    file->read(chunk, rows.data());
    EXPECT_EQ(rows, s.rows(chunk));
  }
  std::vector<double> rows(8 * 4);
  file->read(2, rows.data());
  EXPECT_EQ(rows[1], s.options.axes[1].values[16]);
  EXPECT_TRUE(std::isnan(rows[2]));
}

TEST(RowsFile, may_be_just_rows_with_a_long_description) {
  Sample s;
  s.options.axes.clear();
  s.work.description = "{\"values\": \"" + std::string(100000, '7') + "\"}";
  ASSERT_TRUE(s.write({0, 5}));
  EXPECT_EQ(dataset(s.options.path, "damping").shape, (std::vector<hsize_t>{210}));
  s.options.resume = true;
  EXPECT_EQ(s.refusal(), "");
}

TEST(RowsFile, does_not_begin_again_where_something_is_unfinished) {
  Sample s;
  ASSERT_TRUE(s.write({1}));
  const std::string before = bytes_of(s.options.path);
  EXPECT_THAT(s.refusal(), HasSubstr("is unfinished; go on with --resume"));
  EXPECT_EQ(bytes_of(s.options.path), before);
}

TEST(RowsFile, goes_on_only_with_the_same_work) {
  Sample s;
  ASSERT_TRUE(s.write({1}));
  const std::string before = bytes_of(s.options.path);
  s.options.resume = true;
  s.work.description = R"({"stiffness": 10, "drive": {"amplitude": 1}, "step": 0.1})";
  EXPECT_THAT(s.refusal(), HasSubstr("stiffness is 9 there and 10 here; step is missing there"));
  EXPECT_EQ(bytes_of(s.options.path), before);
}

TEST(RowsFile, goes_on_only_with_its_own_journal) {
  Sample s;
  ASSERT_TRUE(s.write({1}));
  s.options.resume = true;
  s.work.rows_per_chunk = 16;
  EXPECT_THAT(s.refusal(), HasSubstr("is not the journal of this work"));
  s.work.rows_per_chunk = 8;
  std::ofstream(s.options.path + ".journal") << "cromer";
  EXPECT_THAT(s.refusal(), HasSubstr("is not the journal of this work"));
}

TEST(RowsFile, refuses_what_is_no_file_of_ours) {
  Sample s;
  s.options.resume = true;
  std::ofstream(s.options.path) << "drive_frequency,amplitude\n1,2\n";
  EXPECT_THAT(s.refusal(), HasSubstr("sweep.h5 cannot be opened as an HDF5 file"));
  H5Fclose(H5Fcreate(s.options.path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_THAT(s.refusal(), HasSubstr("was not made by cromer"));
}

TEST(RowsFile, begins_where_resume_finds_nothing) {
  Sample s;
  s.options.resume = true;
  ASSERT_TRUE(s.write(from_to(0, 27)));
  EXPECT_EQ(dataset(s.options.path, "amplitude").numbers[209], std::sqrt(209.0));
}

TEST(RowsFile, says_how_much_a_file_needs_that_does_not_fit) {
  Sample s;
  s.work.rows = 1'000'000'000'000'000;
  s.options.axes.clear();
  EXPECT_THAT(s.refusal(), HasSubstr("sweep.h5 needs 3"));  // 32 PB and the journal
  EXPECT_THAT(s.refusal(), HasSubstr("PB, but only"));
  EXPECT_FALSE(exists(s.options.path));
}

TEST(RowsFile, leaves_nothing_where_it_was_interrupted_before_the_first_chunk) {
  Sample s;
  std::atomic<bool> stop{true};
  auto file = RowsFile::open(s.work, s.options, {&stop});
  ASSERT_FALSE(file);
  EXPECT_THAT(in_words(file.error()), HasSubstr("nothing was begun"));
  EXPECT_FALSE(exists(s.options.path) || exists(s.options.path + ".new") ||
               exists(s.options.path + ".journal"));
}

TEST(RowsFile, is_for_one_program_at_a_time) {
  Sample s;
  s.options.resume = true;
  auto first = RowsFile::open(s.work, s.options, {});
  ASSERT_TRUE(first);
  EXPECT_THAT(s.refusal(), HasSubstr("another cromer is writing this file now"));
}

TEST(RowsFile, says_what_is_missing_where_hdf5_is) {
  Sample s;
  const std::string modules = std::getenv("CROMER_MODULES");
  setenv("CROMER_MODULES", "/nowhere", 1);
  EXPECT_THAT(s.refusal(),
              HasSubstr("HDF5 files need libcromer_hdf5.so, which is not there (looked in /nowhere)"));
  EXPECT_THAT(s.refusal(), HasSubstr("use -o FILE.csv"));
  setenv("CROMER_MODULES", modules.c_str(), 1);
}

TEST(RowsFile, of_ten_million_rows_takes_little_memory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  test::Folder folder;
  const std::string file = folder / "long.h5";
  const auto ended = test::run({CROMER_ROWS_PROGRAM, file, "10000000", "100000", "0", "2"}, folder);
  ASSERT_EQ(ended.status, 0) << ended.err;
  const long kibibytes = std::atol(ended.out.c_str() + ended.out.find("memory ") + 7);
  EXPECT_GT(kibibytes, 1000);
  EXPECT_LT(kibibytes, 50'000) << "the file is of 160 MB";
  EXPECT_EQ(dataset(file, "phase").numbers.back(), 1e-7);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
