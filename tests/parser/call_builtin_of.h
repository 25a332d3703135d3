// Calls built-in functions and builders directly, with a runtime that the test provides.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "parser/builtins/builtins.h"
#include "parser/symbols.h"
#include "scene/scene.h"

namespace lray::test {

/// A runtime whose only function is a C++ one.
class FakeRuntime : public parser::Runtime {
 public:
    std::function<parser::Value(std::span<const parser::Value>)> function{};
    int calls = 0;

    parser::Value call_function(const parser::Value&, std::span<const parser::Value> arguments,
                                Span) override {
        ++calls;
        return function(arguments);
    }
    void print(std::string_view, Span) override {}
    const scene::Scene& scene() const override { return scene_; }
    const parser::Symbols& symbols() const override { return symbols_; }
    parser::Symbol intern(std::string_view) override { return parser::kNoSymbol; }

 private:
    scene::Scene scene_;
    parser::Symbols symbols_;
};

inline parser::Budget budget_of(std::uint64_t steps, std::uint64_t bytes) {
    return {steps, bytes, steps, bytes, 100'000'000, false};
}

/// A call of a built-in function with these arguments, and what came of it. Argument i stands at
/// offset 10 * i.
class BuiltinCall {
 public:
    BuiltinCall(std::string_view name, const std::vector<parser::Value>& arguments) {
        const auto index = parser::find_builtin(name);
        LRAY_ASSERT(index.has_value());
        const parser::Builtin& builtin = parser::builtins()[*index];
        parser::Call call{{},       {}, {}, Span{1, 0, 1}, arena_, budget_, diagnostics,
                          runtime_, {}, {}};
        std::vector<parser::Value> rest;
        std::vector<Span> rest_spans;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const Span span{static_cast<std::uint32_t>(10 * i), 0, 1};
            if (i < builtin.parameter_count()) {
                call.arguments[i] = arguments[i];
                call.spans[i] = span;
            } else {
                rest.push_back(arguments[i]);
                rest_spans.push_back(span);
            }
        }
        LRAY_ASSERT(rest.empty() || builtin.is_variadic);
        call.rest = rest;
        call.rest_spans = rest_spans;
        value = parser::call_builtin(builtin, call);
    }

    /// "E0301 20 message": of the only diagnostic; empty if there is none.
    std::string told() const {
        std::string text;
        for (const Diagnostic* diagnostic : diagnostics.sorted()) {
            text += std::string(code_info(diagnostic->code).id) + " " +
                    std::to_string(diagnostic->span.offset) + " " + diagnostic->message;
        }
        return text;
    }

    parser::Value value{};
    Diagnostics diagnostics{};

 private:
    parser::Arena arena_;
    parser::Budget budget_ = budget_of(1'000'000, 1 << 26);
    FakeRuntime runtime_;
};

}  // namespace lray::test
