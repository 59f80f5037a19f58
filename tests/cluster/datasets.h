// What an HDF5 file holds, read by HDF5 itself.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cromer::core::test {

/// All datasets of numbers, by name; empty where the file does not open.
std::map<std::string, std::vector<double>> datasets(const std::string& path);

/// The same bytes in all of them, NaN included.
bool same_bits(const std::map<std::string, std::vector<double>>& a,
               const std::map<std::string, std::vector<double>>& b);

}  // namespace cromer::core::test
