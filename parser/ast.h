// The syntax tree. Nodes live in an Arena and are plain data; the checker fills in what names
// mean, and refuses trees deeper than the nesting limit, so passes over them may recurse.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/source.h"
#include "parser/schema.h"
#include "parser/symbols.h"
#include "parser/token.h"

namespace lray::parser {

struct Expr;
struct Item;

/// What stands between braces.
struct Body {
    std::span<Item* const> items{};
    Span open{};   // the `{`
    Span close{};  // the `}`
};

enum class ExprKind : std::uint8_t {
    error,  // reported; uses of it are silent
    number,
    boolean,
    string,
    color,
    name,
    unary,
    binary,
    conditional,
    call,
    index,
    member,
    list,
    packed_list,
    block,
};

struct Expr {
    ExprKind kind = ExprKind::error;
    std::uint16_t depth = 1;  // of the tree below, itself included
    Span span{};
};

struct NumberExpr : Expr {
    double value = 0.0;
    bool has_unit = false;
};

struct BooleanExpr : Expr {
    bool value = false;
};

struct StringExpr : Expr {
    std::string_view value{};  // escapes resolved
};

/// Linear RGBA.
struct ColorExpr : Expr {
    double rgba[4] = {};
};

enum class Meaning : std::uint8_t {
    unknown,  // reported; silent from here on
    variable,
    constant,  // of the prelude: index into its constants
    function,  // index into the built-in functions
    block,     // index: BlockKind
    colors     // the namespace of colour names
};

struct NameExpr : Expr {
    Symbol symbol = kNoSymbol;
    Meaning meaning = Meaning::unknown;
    std::uint32_t index = 0;
};

struct UnaryExpr : Expr {
    TokenKind op{};  // minus, plus, kw_not
    Expr* operand = nullptr;
};

struct BinaryExpr : Expr {
    TokenKind op{};  // arithmetic, comparison, kw_and, kw_or
    Span op_span{};
    Expr* left = nullptr;
    Expr* right = nullptr;
};

struct ConditionalExpr : Expr {
    Expr* condition = nullptr;
    Expr* then_value = nullptr;
    Expr* else_value = nullptr;
};

struct Argument {
    Symbol name = kNoSymbol;  // none: positional
    Span name_span{};
    Expr* value = nullptr;
};

struct CallExpr : Expr {
    Expr* callee = nullptr;
    std::span<const Argument> arguments{};
};

struct IndexExpr : Expr {
    Expr* object = nullptr;
    Expr* index = nullptr;
};

struct MemberExpr : Expr {
    Expr* object = nullptr;
    Symbol name = kNoSymbol;
    Span name_span{};
};

struct ListExpr : Expr {
    std::span<Expr* const> elements{};
};

/// A list of number literals (width 1), or of rows of `width` number literals.
struct PackedListExpr : Expr {
    bool is_nested = false;  // rows are lists: [[1], [2]] is not [1, 2]
    std::uint32_t width = 1;
    std::uint32_t count = 0;         // of rows
    const double* values = nullptr;  // width * count
};

struct BlockExpr : Expr {
    Expr* head = nullptr;
    const StringExpr* label = nullptr;
    Body body{};
};

enum class ItemKind : std::uint8_t { let, property, block, call, assignment, include, literals };

struct Item {
    ItemKind kind{};
    Span span{};
};

struct LetItem : Item {
    Symbol name = kNoSymbol;
    Span name_span{};
    Expr* value = nullptr;
    std::uint32_t slot = 0;  // by the checker
};

struct PropertyItem : Item {
    Symbol name = kNoSymbol;
    Span name_span{};
    Expr* value = nullptr;
};

struct BlockItem : Item {
    BlockExpr* block = nullptr;
};

/// An expression in the place of an item.
struct CallItem : Item {
    Expr* value = nullptr;
};

/// `name = value`: nothing can be assigned to in this version; kept for its message.
struct AssignmentItem : Item {
    Expr* target = nullptr;
    Expr* value = nullptr;
};

struct IncludeItem : Item {
    const StringExpr* path = nullptr;
    bool is_loaded = false;          // false: reported, the names it would bring are silent
    std::span<Item* const> items{};  // of the file, when it is loaded
};

/// Neighbouring blocks of literals, which left no tree: nodes [first_node, first_node + count).
struct LiteralsItem : Item {
    std::uint32_t first_node = 0;
    std::uint32_t count = 0;
};

}  // namespace lray::parser
