// Amounts of memory in words.
#pragma once

#include <string>

namespace cromer::core {

/// "1.6 GB", "240 TB": three digits, decimal prefixes; bytes >= 0.
std::string bytes_in_words(double bytes);

}  // namespace cromer::core
