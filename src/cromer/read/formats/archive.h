// A ZIP archive of text files, as phyphox exports an experiment: one CSV for each data set, and a folder
// meta/.
#pragma once

#include <string_view>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// Each data set with times is a run, called by its file; meta/ is passed over, sets without times are left
/// out where others have them, and said.
Result<Recording> read_archive(std::string_view bytes, const ReadOptions& options);

}  // namespace cromer::core::dialects
