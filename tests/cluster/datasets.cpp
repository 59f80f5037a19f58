#include "tests/cluster/datasets.h"

#include <hdf5.h>

#include <cstring>

namespace cromer::core::test {

std::map<std::string, std::vector<double>> datasets(const std::string& path) {
  std::map<std::string, std::vector<double>> all;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file < 0) return all;
  const auto read = [](hid_t where, const char* name, const H5L_info_t*, void* to) -> herr_t {
    const hid_t set = H5Dopen2(where, name, H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    const herr_t good = H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    (*static_cast<std::map<std::string, std::vector<double>>*>(to))[name] = numbers;
    H5Sclose(space);
    H5Dclose(set);
    return good < 0 ? -1 : 0;
  };
  if (H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, read, &all) < 0) all.clear();
  H5Fclose(file);
  return all;
}

bool same_bits(const std::map<std::string, std::vector<double>>& a,
               const std::map<std::string, std::vector<double>>& b) {
  if (a.empty() || a.size() != b.size()) return false;
  for (const auto& [name, numbers] : a) {
    const auto other = b.find(name);
    if (other == b.end() || other->second.size() != numbers.size() ||
        std::memcmp(numbers.data(), other->second.data(), numbers.size() * sizeof(double)) != 0)
      return false;
  }
  return true;
}

}  // namespace cromer::core::test
