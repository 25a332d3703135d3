// Calls built-in functions with values made by hand, where no scene can bring them there yet or
// none could.
#pragma once

#include <deque>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "parser/builtins/builtins.h"
#include "parser/symbols.h"
#include "parser/values/value_text.h"

namespace lray::test {

/// Values, and calls with them. The argument with the index i stands at column 10 * (i + 1), the
/// call at column 1; rest follows.
class BuiltinCaller : public parser::Runtime {
 public:
    using Value = parser::Value;
    using Function = std::function<Value(std::span<const Value>)>;

    BuiltinCaller();

    // Values that live as long as this.
    static Value number(double x) { return Value::of(x); }
    static Value boolean(bool x) { return Value::of(x); }
    Value string(std::string_view text, SourceId source = 0);
    Value list(std::initializer_list<Value> elements);
    Value numbers(std::initializer_list<double> numbers);
    Value color(double r, double g, double b);
    Value function(Function function);
    Value node(scene::NodeId id);
    Value nested(std::size_t depth);  // [[[true]]], so deep

    /// Calls a function by name; what a variadic one takes more goes to `rest`.
    Value call(std::string_view name, std::vector<Value> arguments);

    /// The result as text; a string in quotes. When something was reported, that instead:
    /// "E0504 20 a slice begins and ...", the column before the message.
    std::string says(std::string_view name, std::vector<Value> arguments);

    // Runtime
    Value call_function(const Value& function, std::span<const Value> arguments,
                        Span span) override;
    void print(std::string_view line, Span) override { printed.emplace_back(line); }
    const scene::Scene& scene() const override { return scene_of_nodes; }
    const parser::Symbols& symbols() const override { return symbols_; }
    parser::Symbol intern(std::string_view name) override { return symbols_.intern(name); }

    parser::Budget budget{};
    std::vector<std::string> printed{};
    scene::Scene scene_of_nodes{};
    Diagnostics diagnostics{};

 private:
    parser::Arena arena_;
    parser::Symbols symbols_;
    std::deque<Function> functions_;
    std::deque<parser::FunctionValue> function_values_;
    std::deque<parser::Made> made_;
};

}  // namespace lray::test
