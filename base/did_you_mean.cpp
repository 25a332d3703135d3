#include "base/did_you_mean.h"

#include <algorithm>
#include <utility>

namespace lray {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    if (a.size() > b.size()) std::swap(a, b);
    if (b.size() - a.size() > limit) return limit + 1;
    // Three rows of the table are alive: the one being filled and the two above it.
    std::vector<std::size_t> above2(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(above2, above);
        std::swap(above, row);
        row[0] = i;
        std::size_t least = row[0];
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool is_same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (is_same ? 0u : 1u)});
            const bool is_swap = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                                 lower(a[i - 2]) == lower(b[j - 1]);
            if (is_swap) row[j] = std::min(row[j], above2[j - 2] + 1);
            least = std::min(least, row[j]);
        }
        // No later row is cheaper: a swap reaches back two rows, but costs no less than this row's
        // substitution on the same diagonal.
        if (least > limit) return limit + 1;
    }
    return std::min(row[b.size()], limit + 1);
}

std::vector<std::string_view> nearest_names(std::string_view name,
                                            std::span<const std::string_view> candidates) {
    constexpr std::size_t kMaxNames = 3;
    constexpr std::size_t kMaxLength = 100;  // the table is quadratic, and nobody types such names
    if (name.size() > kMaxLength) return {};
    struct Near {
        std::size_t distance = 0;
        std::string_view name{};
    };
    const std::size_t limit = std::max<std::size_t>(1, name.size() / 3);
    std::vector<Near> found;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(name, candidate, limit);
        // Replacing all of a short name is no resemblance: `x` is not near `y`.
        if (distance > limit || distance >= std::max(name.size(), candidate.size())) continue;
        found.push_back({distance, candidate});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Near& a, const Near& b) { return a.distance < b.distance; });
    std::vector<std::string_view> names;
    for (const Near& near : found) {
        if (names.size() == kMaxNames) break;
        const bool is_known = std::find(names.begin(), names.end(), near.name) != names.end();
        if (!is_known) names.push_back(near.name);
    }
    return names;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
    const std::vector<std::string_view> names = nearest_names(name, candidates);
    if (names.empty()) return {};
    std::string text = "did you mean ";
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += '`';
        text += names[i];
        text += '`';
    }
    return text += '?';
}

}  // namespace lray
