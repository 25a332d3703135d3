// Suggestions for misspelt names.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lray {

/// Returns the edit distance that counts insertions, deletions, substitutions and swaps of
/// neighbours as one each (optimal string alignment), ASCII case ignored; gives up and returns
/// `limit` + 1 when it is larger than `limit`.
/// Source: Damerau 1964, "A technique for computer detection and correction of spelling errors".
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// Returns at most three of the candidates within max(1, length / 3) edits, nearest first; names
/// with no letter in common are not near. None for names of more than 100 bytes.
std::vector<std::string_view> nearest_names(std::string_view name,
                                            std::span<const std::string_view> candidates);

/// Returns "did you mean `a`?" or "did you mean `a`, `b` or `c`?"; empty when nothing is near.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace lray
