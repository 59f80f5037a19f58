#include "cromer/base/nearest.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "cromer/base/ascii.h"

namespace cromer::core {
namespace {

constexpr std::size_t longest_name = 200;  // characters; no name is meant by more

/// Optimal string alignment distance; three rows of the usual table are enough for swaps.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (same ? 0u : 1u)});
      const bool swapped =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
    }
    before.swap(previous);
    previous.swap(current);
  }
  return previous[b.size()];
}

/// Of at least three letters: fewer stand in too many names to tell anything.
bool contains(std::string_view name, std::string_view typed) {
  return typed.size() >= 3 && std::search(name.begin(), name.end(), typed.begin(), typed.end(),
                                          [](char a, char b) { return lower(a) == lower(b); }) != name.end();
}

/// The first of those with the smallest distance; empty for none.
std::string_view first_nearest(std::string_view typed, std::span<const std::string_view> names) {
  std::string_view best;
  std::size_t best_distance = 0;
  for (const std::string_view name : names) {
    const std::size_t distance = edit_distance(typed, name);
    if (!best.empty() && distance >= best_distance) continue;
    best = name;
    best_distance = distance;
  }
  return best;
}

/// The names that may have been meant.
std::vector<std::string_view> candidates(std::string_view typed, std::span<const std::string_view> names) {
  if (typed.size() > longest_name) return {};
  const std::string_view best = first_nearest(typed, names);
  if (best.empty()) return {};
  const std::size_t distance = edit_distance(typed, best);
  if (distance <= 1) return {best};
  std::vector<std::string_view> containing;
  for (const std::string_view name : names)
    if (contains(name, typed)) containing.push_back(name);
  if (!containing.empty()) return containing;
  // The nearest name may be too far away for its length where a longer name is not.
  std::vector<std::string_view> within;
  for (const std::string_view name : names)
    if (edit_distance(typed, name) <= std::max(typed.size(), name.size()) / 3 + 1) within.push_back(name);
  if (within.empty()) return {};
  return {first_nearest(typed, within)};
}

}  // namespace

std::string nearest(std::string_view typed, std::span<const std::string_view> names) {
  return std::string(first_nearest(typed, candidates(typed, names)));
}

std::vector<std::string> nearest_names(std::string_view typed, std::span<const std::string_view> names) {
  const std::vector<std::string_view> near = candidates(typed, names);
  return {near.begin(), near.end()};
}

}  // namespace cromer::core
