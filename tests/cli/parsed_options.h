// Reads command lines that a test expects to be right, or wrong.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <variant>
#include <vector>

#include "cli/options.h"

namespace lray::cli {

inline std::variant<Options, Failure> parse(std::vector<const char*> arguments) {
    return parse_options(arguments);
}

inline Options parsed(std::vector<const char*> arguments) {
    auto result = parse(std::move(arguments));
    if (const auto* failure = std::get_if<Failure>(&result)) {
        ADD_FAILURE() << failure->message;
        return {};
    }
    return std::get<Options>(result);
}

inline Failure failed(std::vector<const char*> arguments) {
    auto result = parse(std::move(arguments));
    if (std::holds_alternative<Options>(result)) {
        ADD_FAILURE() << "no error";
        return {ExitCode::done, {}, {}};
    }
    const Failure failure = std::get<Failure>(result);
    EXPECT_EQ(failure.exit_code, ExitCode::usage);
    return failure;
}

}  // namespace lray::cli
