// Formats texts for the tests, and compares what must not change.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parser/load.h"
#include "parser/tools/format_layout.h"
#include "tests/parser/loaded.h"

namespace lray::test {

inline constexpr std::size_t kWidth = parser::Layout::kMaxWidth;

/// A text, formatted; without a text when that was refused.
struct Formatted {
    explicit Formatted(std::string_view original, const parser::LoadLimits& limits = {});

    std::optional<std::string> text{};
    std::string codes{};  // of what was reported
};

/// Expects this text, and that it is stable.
void expect_format(std::string_view original, std::string_view wanted);

/// Expects of a text that can be formatted: formatted again it is the same; its tokens are the old
/// ones but for separators and spelling; its comments are the old ones; there are no tabs, blanks
/// at line ends or blank lines in a row.
void expect_stable(std::string_view original);

/// The codes of all that was said, each as often as it was.
std::string sorted_codes(const Loaded& loaded);

}  // namespace lray::test
