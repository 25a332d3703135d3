// The topics of `--explain` that are no code, block or function: one text each.
#pragma once

#include <span>
#include <string_view>

namespace lray::cli {

struct Topic {
    std::string_view name{};
    std::string_view title{};  // in the list of topics
    std::string_view text{};
};

/// Shape: sorted by name.
std::span<const Topic> topics();

}  // namespace lray::cli
