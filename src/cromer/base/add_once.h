// What holds for several parts of a result is said once.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "cromer/notice.h"

namespace cromer::core {

/// Adds the notice unless it is there already.
inline void add_once(std::vector<Notice>& notices, Notice notice) {
  if (std::find(notices.begin(), notices.end(), notice) == notices.end())
    notices.push_back(std::move(notice));
}

}  // namespace cromer::core
