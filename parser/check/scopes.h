// The names that can be used at one place of a file, the functions around it, and what these
// capture of the code around them.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/arena.h"
#include "parser/blocks/schema.h"
#include "parser/check/checker.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"

namespace lray::parser {

/// The most names of the code around it that a function uses: what it captures is copied each time
/// it is called.
inline constexpr std::size_t kMaxCaptures = 256;

/// A function while it is checked, or the outermost code of a file. Its values live in one frame.
struct Context {
    /// A value of another context, and where it is copied to when the function is called.
    struct Captured {
        const Context* owner = nullptr;
        std::uint32_t slot = 0;  // in the owner's frame
        std::uint32_t own_slot = 0;
    };

    /// A loop around the place that is checked, inside the same function.
    struct Loop {
        std::size_t first_scope = 0;
        std::vector<SlotRef> assigned{};
        std::vector<std::uint32_t> declared{};
        bool sets_properties = false;
        bool has_functions = false;
        bool has_exit = false;  // `break` or `return`
    };

    Function* function = nullptr;  // null: the outermost code of a file
    const Context* outer = nullptr;
    std::uint32_t frame_size = 0;
    std::vector<Captured> captured{};
    std::vector<Loop> loops{};
    bool has_effects = false;
    bool captures_too_much = false;
};

/// What is known of a name before the program runs.
struct Variable {
    Symbol name = kNoSymbol;
    Span span{};
    Meaning meaning = Meaning::local;  // global, local, function, component or module
    LetKind let_kind = LetKind::let;
    bool is_used = false;
    bool warns_if_unused = false;
    bool may_be_function = true;
    bool is_material = false;  // for sure
    std::uint32_t slot = 0;
    Context* owner = nullptr;
    std::size_t scope = 0;
    Function* function = nullptr;
    const Module* module = nullptr;  // null: it could not be loaded
    std::int64_t outer = -1;         // the variable of this name that it hides
};

/// The scopes of one file, from its outermost code to the braces at hand.
class Scopes {
 public:
    /// The names between one pair of braces.
    struct Scope {
        std::size_t first_variable = 0;
        std::span<Item* const> items{};
        Context* context = nullptr;
        std::optional<std::unordered_map<Symbol, LetItem*>> lets{};  // made when asked for
    };

    void open(std::span<Item* const> items, Context& context) {
        scopes_.push_back({variables_.size(), items, &context, std::nullopt});
    }
    void close();

    Variable& declare(Variable variable);

    /// Returns the innermost variable of that name; null if there is none yet.
    Variable* find(Symbol symbol);

    /// Returns the `let` that will define a name further down, in these braces or around them, and
    /// the scope it stands in; null if there is none.
    struct Later {
        LetItem* item = nullptr;
        const Scope* scope = nullptr;
    };
    Later find_later(Symbol symbol);

    /// The variables of the innermost braces.
    std::span<Variable> innermost() {
        return std::span(variables_).subspan(scopes_.back().first_variable);
    }

    bool is_outermost() const { return scopes_.size() == 1; }
    bool is_outermost(const Scope& scope) const { return &scope == scopes_.data(); }
    std::size_t depth() const { return scopes_.size(); }

    /// All names there are, sorted; empty when there are too many to search.
    std::vector<std::string_view> names(const Symbols& symbols) const;

 private:
    std::vector<Variable> variables_;  // those in scope, outermost first
    std::unordered_map<Symbol, std::size_t> innermost_;
    std::vector<Scope> scopes_;
};

/// Returns where a value of `owner` is found in the frame of `context`, and captures it if need be.
std::uint32_t slot_in(Context& context, const Context* owner, std::uint32_t slot);

/// The functions of a whole program and the places that name them. What a function captures, and
/// whether it prints, follows from what it names; functions may name each other in circles.
class FunctionUses {
 public:
    Context& add(Function* function, const Context* outer);

    /// Returns the index of a new use of `function` inside `from`.
    std::uint32_t use(Function& function, Context& from);

    /// Works out captures and effects, and writes them into the functions and uses.
    /// Errors: E0306 at a function that captures too much.
    void resolve(Arena& arena, std::vector<FunctionUse>& uses, Diagnostics& diagnostics);

    const Function& function_of(std::uint32_t use) const { return *uses_[use].function; }
    Context& context(const Function& function) { return *functions_[function.id]; }
    std::uint32_t function_count() const { return static_cast<std::uint32_t>(functions_.size()); }

 private:
    struct Use {
        Function* function = nullptr;
        Context* from = nullptr;
    };

    std::deque<Context> contexts_;
    std::vector<Context*> functions_;  // by Function::id
    std::vector<Use> uses_;
};

}  // namespace lray::parser
