// Texts read as files, and what tests ask of them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"

namespace cromer::core {

/// What is read, or an empty recording and a failure.
inline Recording read(std::string_view text, std::string_view file = "lab.txt",
                      const ReadOptions& options = {}) {
  auto recording = read_recording(text, file, options);
  EXPECT_TRUE(recording.ok()) << in_words(recording.error());
  return recording ? *recording : Recording{};
}

/// Why it is refused; "read" where it is not.
inline std::string refusal(std::string_view text, std::string_view file = "lab.txt",
                           const ReadOptions& options = {}) {
  const auto recording = read_recording(text, file, options);
  return recording ? "read" : in_words(recording.error());
}

inline Recording read(std::string_view text, const ReadOptions& options) {
  return read(text, "lab.txt", options);
}
inline std::string refusal(std::string_view text, const ReadOptions& options) {
  return refusal(text, "lab.txt", options);
}

/// "1 x (m)": run and title of each column.
inline std::vector<std::string> titles(const Recording& recording) {
  std::vector<std::string> all;
  for (const Column& column : recording.table.columns)
    all.push_back(concat({std::to_string(column.run), " ", column_title(column)}));
  return all;
}

inline const std::vector<double>& values(const Recording& recording, std::size_t j) {
  return recording.table.columns.at(j).values;
}

}  // namespace cromer::core
