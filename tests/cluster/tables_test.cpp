// cromer simulate and cromer spectrum into HDF5 files, read back by HDF5.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/cluster/started.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

/// An HDF5 file open for reading.
class File {
 public:
  explicit File(const std::string& path) : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {}
  ~File() {
    if (file_ >= 0) H5Fclose(file_);
  }
  bool good() const { return file_ >= 0; }
  bool has(const char* name) const { return H5Lexists(file_, name, H5P_DEFAULT) > 0; }

  std::vector<double> numbers(const char* name, std::vector<hsize_t>* shape = nullptr) const {
    const hid_t set = H5Dopen2(file_, name, H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
    if (shape) {
      shape->resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
      H5Sget_simple_extent_dims(space, shape->data(), nullptr);
    }
    H5Sclose(space);
    H5Dclose(set);
    return values;
  }

  std::string text(const char* where, const char* name) const {
    const hid_t attribute = H5Aopen_by_name(file_, where, name, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute < 0) return "(none)";
    const hid_t type = H5Aget_type(attribute);
    std::string found(H5Tget_size(type), '\0');
    H5Aread(attribute, type, found.data());
    H5Tclose(type);
    H5Aclose(attribute);
    return found.c_str();
  }

 private:
  hid_t file_;
};

class Tables : public testing::Test {
 protected:
  test::Ended run(Arguments arguments) {
    arguments.insert(arguments.begin(), CROMER_PROGRAM);
    return test::run(arguments, folder);
  }
  /// Files in the folder, hidden ones too, but for what the started programs said.
  std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
      const std::string name = entry.path().filename().string();
      if (name.find("h5") != std::string::npos || name.starts_with(".cromer")) names.push_back(name);
    }
    return names;
  }
  test::Folder folder{};
  const std::string file = folder / "made.h5";
  const std::string ground = CROMER_DATA "/ground/shaking.csv";
};

TEST_F(Tables, SimulateHasAGroupForEachRunThatMeetsTheClosedForm) {
  const auto ended = run({"simulate", "--stiffness", "9", "--damping", "0.2", "--position", "1", "--method",
                          "exact", "--method", "euler-cromer", "--step", "0.01", "--until", "5", "-o", file});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const File made(file);
  ASSERT_TRUE(made.good());
  EXPECT_THAT(made.text("/", "program"), HasSubstr("cromer "));
  EXPECT_THAT(made.text("/", "command"), HasSubstr("--stiffness 9"));
  EXPECT_THAT(made.text("/", "description"), HasSubstr("\"stiffness\""));
  EXPECT_EQ(made.text("run_1", "method"), "exact");
  EXPECT_EQ(made.text("run_2", "method"), "euler-cromer");
  EXPECT_FALSE(made.has("run_3"));
  EXPECT_EQ(made.text("run_1/x", "unit"), "m");
  EXPECT_EQ(made.text("run_1/x", "axes"), "t");
  EXPECT_EQ(made.text("run_2/energy", "unit"), "J");
  const auto t = made.numbers("run_1/t"), x = made.numbers("run_1/x"), v = made.numbers("run_1/v"),
             e = made.numbers("run_1/energy");
  ASSERT_EQ(t.size(), 501u);
  const double b = 0.1, w = std::sqrt(9 - b * b);
  for (std::size_t i = 0; i < t.size(); ++i) {
    EXPECT_NEAR(x[i], std::exp(-b * t[i]) * (std::cos(w * t[i]) + b / w * std::sin(w * t[i])), 1e-12);
    EXPECT_NEAR(e[i], 0.5 * v[i] * v[i] + 4.5 * x[i] * x[i], 1e-12);
  }
  EXPECT_EQ(left().size(), 1u);
}

TEST_F(Tables, SpectrumHasWhatTheJsonAndTheCsvHave) {
  const std::string csv = folder / "made.csv";
  for (const std::string& to : {file, csv}) {
    const auto ended = run({"spectrum", ground, "--column", "east", "--column", "north", "--damping-ratio",
                            "2%,5%", "--periods", "0.1:5:7:log", "--in-g", "--quiet", "-o", to});
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  const File made(file);
  ASSERT_TRUE(made.good());
  std::vector<hsize_t> shape;
  const auto psa = made.numbers("PSA_RotD50", &shape);
  EXPECT_EQ(shape, (std::vector<hsize_t>{2, 7}));
  EXPECT_EQ(made.text("PSA_RotD50", "unit"), "g");
  EXPECT_EQ(made.text("PSA_RotD50", "axes"), "damping_ratio period");
  EXPECT_EQ(made.text("period", "unit"), "s");
  EXPECT_THAT(made.text("/", "command"), HasSubstr("shaking.csv"));
  EXPECT_THAT(made.text("/", "description"), HasSubstr("arias_intensity"));
  for (const char* name : {"SD_1", "SD_2", "PSV_geometric_mean", "PSA_RotD100"})
    EXPECT_TRUE(made.has(name)) << name;
  EXPECT_EQ(made.numbers("damping_ratio"), (std::vector<double>{0.02, 0.05}));
  // The CSV, row by row.
  std::ifstream in(csv);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) continue;
    auto& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  ASSERT_EQ(rows.size(), 15u);
  std::size_t column = 0;
  while (column < rows[0].size() && rows[0][column].find("PSA RotD50") == std::string::npos) ++column;
  ASSERT_LT(column, rows[0].size());
  for (std::size_t i = 0; i < psa.size(); ++i)
    EXPECT_DOUBLE_EQ(psa[i], std::strtod(rows[i + 1][column].c_str(), nullptr));
}

TEST_F(Tables, OfAShockAndOfOneComponent) {
  ASSERT_EQ(run({"spectrum", CROMER_DATA "/ground/drop.csv", "--shock", "--quiet", "-o", file}).status, 0);
  {
    const File made(file);
    for (const char* name : {"primary", "residual", "maximax", "positive", "negative", "frequency"})
      EXPECT_TRUE(made.has(name)) << name;
    EXPECT_EQ(made.text("maximax", "unit"), "m/s²");
  }
  // Over the file that is there.
  ASSERT_EQ(run({"spectrum", ground, "--column", "east", "--periods", "1", "--quiet", "-o", file}).status, 0);
  const File made(file);
  EXPECT_TRUE(made.has("SD"));
  EXPECT_FALSE(made.has("primary"));
}

TEST_F(Tables, AreTheSameBytesEachTime) {
  const std::string other = folder / "sub";
  std::filesystem::create_directory(other);
  const Arguments command{"simulate", "--until", "1", "--step", "0.1", "-o", file};
  ASSERT_EQ(run(command).status, 0);
  const std::string first = bytes_of(file);
  ASSERT_EQ(run(command).status, 0);
  EXPECT_EQ(bytes_of(file), first);
}

TEST_F(Tables, WhereTheDiskIsFullOneSentenceSaysSoAndNothingIsLeft) {
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  for (const rlim_t bytes : {8192u, 65536u})
    for (const Arguments& command :
         {Arguments{"simulate", "--until", "300", "--quiet", "-o", file},
          Arguments{"spectrum", ground, "--column", "east", "--periods", "0.1:5:9000", "--quiet", "-o", file},
          Arguments{"sweep", "--drive-amplitude", "1", "--damping", "1", "--drive-frequency", "1:2:9000",
                    "--quiet", "-o", file}}) {
      const rlimit small{bytes, limit.rlim_max};
      ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
      const auto ended = run(command);
      ::setrlimit(RLIMIT_FSIZE, &limit);
      EXPECT_EQ(ended.status, 2) << command[0] << bytes;
      EXPECT_EQ(ended.err, "cromer: cannot write " + file +
                               ": File too large; make room, or name a file on another disk\n")
          << command[0] << bytes;
      EXPECT_TRUE(left().empty()) << command[0] << bytes;
    }
}

TEST_F(Tables, APipeOrADeviceInTheirPlaceStays) {
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  for (const Arguments& command : {Arguments{"simulate", "--until", "1", "-o", file},
                                   Arguments{"sweep", "--damping", "0.1,0.2", "--until", "1", "-o", file}}) {
    const auto ended = run(command);
    EXPECT_EQ(ended.status, 2);
    EXPECT_THAT(ended.err, HasSubstr("it is a device or a pipe, and HDF5 is written into files"));
    EXPECT_TRUE(std::filesystem::is_fifo(file));
  }
}

TEST_F(Tables, WhereTheyCannotBeWrittenNothingIsLeft) {
  const auto nowhere = run({"simulate", "-o", folder / "nowhere/a.h5"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("there is no folder"));
  if (geteuid() != 0) {
    const std::string locked = folder / "locked";
    std::filesystem::create_directory(locked);
    ::chmod(locked.c_str(), 0555);
    const auto refused = run({"simulate", "-o", locked + "/a.h5"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("Permission denied"));
    ::chmod(locked.c_str(), 0755);
  }
  for (const Arguments& command : {Arguments{"simulate", "--until", "1", "--step", "0.1", "-o", file},
                                   Arguments{"spectrum", ground, "--column", "east", "-o", file}}) {
    ::setenv("CROMER_MODULES", (folder / "").c_str(), 1);
    const auto without = run(command);
    ::unsetenv("CROMER_MODULES");
    EXPECT_EQ(without.status, 2);
    EXPECT_EQ(without.out, "");
    EXPECT_THAT(without.err, HasSubstr("libcromer_hdf5.so"));
    EXPECT_THAT(without.err, HasSubstr("-o FILE.csv"));
  }
  EXPECT_TRUE(left().empty());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
