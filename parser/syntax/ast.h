// The syntax tree. Nodes live in an Arena and are plain data; the checker fills in what names
// mean, and refuses trees deeper than the nesting limit, so passes over them may recurse.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/source.h"
#include "parser/blocks/schema.h"
#include "parser/symbols.h"
#include "parser/syntax/token.h"
#include "scene/formats/nff_scene.h"

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
    comprehension,
    function,
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

/// What a name stands for; `index` of the NameExpr says which one.
enum class Meaning : std::uint8_t {
    unknown,    // reported; silent from here on
    global,     // a value of the outermost scope of a file: slot among all globals
    local,      // any other value: slot in the frame of the function, component or file around it
    constant,   // of the prelude: index into its constants
    builtin,    // index into the built-in functions
    block,      // index: BlockKind
    colors,     // the namespace of colour names
    function,   // a `fn`: index into Checked::uses
    component,  // likewise
    module,     // the alias of an import; stands only in front of a dot
    time,       // seconds
    frame,
};

struct Function;

struct NameExpr : Expr {
    Symbol symbol = kNoSymbol;
    Meaning meaning = Meaning::unknown;
    std::uint32_t index = 0;
    Span definition{};  // of a value
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

/// Arguments with names stand behind those without.
struct CallExpr : Expr {
    Expr* callee = nullptr;
    std::span<const Argument> arguments{};
    std::span<const std::uint8_t> places{};  // of the arguments among the parameters, when known
};

struct IndexExpr : Expr {
    Expr* object = nullptr;
    Expr* index = nullptr;
};

struct MemberExpr : Expr {
    Expr* object = nullptr;
    Symbol name = kNoSymbol;
    Span name_span{};
    NameExpr* imported = nullptr;  // `lib.name`: what the name means there
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

    /// Rows of so many numbers are not one value: a list of lists is made of them.
    bool has_wide_rows() const { return is_nested && width > 4; }
};

struct BlockExpr : Expr {
    Expr* head = nullptr;
    const StringExpr* label = nullptr;
    Body body{};

    bool has_statements = false;              // properties may be set or not: seen when it runs
    const BlockSchema* checked_as = nullptr;  // its body was found right for this schema
};

/// `[for i, x in sequence if condition: value]`
struct ComprehensionExpr : Expr {
    Symbol index_name = kNoSymbol;  // none: only the element has a name
    Span index_span{};
    Symbol element_name = kNoSymbol;
    Span element_span{};
    Expr* sequence = nullptr;
    Expr* condition = nullptr;  // may be null
    Expr* value = nullptr;
    std::uint32_t index_slot = 0;
    std::uint32_t element_slot = 0;
};

/// A type annotation.
enum class TypeName : std::uint8_t {
    any,
    number,
    integer,
    boolean,
    string,
    vec2,
    vec3,
    vec4,
    color,
    list,
    transform,
    texture,
    material,
    node,
    record,
    function,
};

/// As they are written, in the order of TypeName.
inline constexpr std::array<std::string_view, 16> kTypeNames = {
    "any",   "number", "int",       "bool",    "string",   "vec2", "vec3",   "vec4",
    "color", "list",   "transform", "texture", "material", "node", "record", "function"};

/// One parameter of a function or component. Its slot in the frame is its position.
struct ParameterDecl {
    Symbol name = kNoSymbol;
    Span name_span{};
    TypeName type = TypeName::any;
    Expr* default_value = nullptr;  // null: required
};

/// A `fn`, a function value or a component. Its frame holds the parameters, then whatever its body
/// names and captures: what belongs to the code around it is copied in when it is called.
struct Function {
    Symbol name = kNoSymbol;  // none: a function value
    Span name_span{};         // of a function value: `fn`
    std::string_view doc{};   // its `///` comment
    std::span<ParameterDecl> parameters{};
    Expr* value = nullptr;  // `= value`; null: it has a body
    Body body{};
    bool is_component = false;

    // By the checker
    std::uint32_t id = 0;
    std::uint32_t frame_size = 0;
    std::span<const std::uint32_t> capture_slots{};  // where in its frame what it captures goes
    std::uint32_t children_slot = 0;                 // of a component
    bool has_effects = false;             // prints, here or in what it calls: not memoised
    const BlockSchema* schema = nullptr;  // of a component: its parameters as properties
};

/// `fn(x) = x * x`
struct FunctionExpr : Expr {
    Function* function = nullptr;
    std::uint32_t use = 0;  // by the checker: index into Checked::uses
};

enum class ItemKind : std::uint8_t {
    let,  // also `var` and `param`
    property,
    block,
    call,
    assignment,
    include,
    import,
    file_view,
    literals,
    function,  // also `component`
    conditional,
    for_loop,
    while_loop,
    break_loop,
    continue_loop,
    return_value,
};

struct Item {
    ItemKind kind{};
    Span span{};
};

/// Of a name that has no place yet.
inline constexpr std::uint32_t kNoSlot = 0xffffffffu;

enum class LetKind : std::uint8_t { let, var, param };

struct LetItem : Item {
    LetKind let_kind = LetKind::let;
    Symbol name = kNoSymbol;
    Span name_span{};
    TypeName type = TypeName::any;
    Expr* value = nullptr;
    Expr* choices = nullptr;  // of a param: what follows `in`
    std::string_view doc{};   // its `///` comment

    // By the checker
    bool is_global = false;
    std::uint32_t slot = kNoSlot;
};

struct PropertyItem : Item {
    Symbol name = kNoSymbol;
    Span name_span{};
    Expr* value = nullptr;

    // Where it belongs in blocks of this schema; found once, kept for the next time.
    const BlockSchema* known_schema = nullptr;
    const PropertySchema* property = nullptr;
    std::uint32_t slot = 0;
    bool is_common = false;
};

struct BlockItem : Item {
    BlockExpr* block = nullptr;
};

/// An expression in the place of an item.
struct CallItem : Item {
    Expr* value = nullptr;
};

/// `name = value`
struct AssignmentItem : Item {
    Expr* target = nullptr;
    Expr* value = nullptr;
};

struct IncludeItem : Item {
    const StringExpr* path = nullptr;
    bool runs_any_times = false;     // not once: reading its file makes no nodes, running it does
    bool is_loaded = false;          // false: reported, the names it would bring are silent
    std::span<Item* const> items{};  // of the file, when it is loaded
};

/// A file that is imported: checked and evaluated once, however many imports name it.
struct Module {
    SourceId source = kNoSource;
    std::span<Item* const> items{};

    // By the checker
    bool is_checked = false;
    std::uint32_t id = 0;
    std::uint32_t frame_size = 0;
};

struct ImportItem : Item {
    const StringExpr* path = nullptr;
    Symbol alias = kNoSymbol;  // none: it has to be the stem of the file, which is no name
    Span alias_span{};         // of the alias or the path
    Module* module = nullptr;  // null: reported
};

/// The view that a file in another format brings, and its background. Both are those of the scene
/// where the file stands at the top level, and nothing in a group.
struct FileViewItem : Item {
    bool has_view = false;
    scene::NffView view{};
    std::string_view name{};  // of the camera
    bool has_background = false;
    Color background{0.0f};

    // By the checker
    bool is_top_level = false;
};

/// Neighbouring blocks of literals, which left no tree: nodes [first_node, first_node + count).
/// What they have besides literals is a material, all the same one: it is known when it runs.
struct LiteralsItem : Item {
    std::uint32_t first_node = 0;
    std::uint32_t count = 0;
    NameExpr* material = nullptr;  // as the first one names it; null: none of them has one
};

struct FunctionItem : Item {
    Function* function = nullptr;
};

/// `if condition { } else { }`; `else if` is an else body of one conditional without braces.
struct ConditionalItem : Item {
    Expr* condition = nullptr;
    Body then_body{};
    Body else_body{};
    bool has_else = false;
};

/// A variable, as a place.
struct SlotRef {
    std::uint32_t slot = 0;
    bool is_global = false;
};

/// What the checker knows of a loop's body: what outlives one time round.
struct LoopInfo {
    std::span<const SlotRef> assigned{};       // variables from outside of the body
    std::span<const std::uint32_t> renewed{};  // names to forget before the next time round
    bool sets_properties = false;              // of the block that holds the loop
};

struct ForItem : Item {
    Symbol index_name = kNoSymbol;  // none: only the element has a name
    Span index_span{};
    Symbol element_name = kNoSymbol;
    Span element_span{};
    Expr* sequence = nullptr;
    Body body{};
    std::uint32_t index_slot = 0;
    std::uint32_t element_slot = 0;
    LoopInfo loop{};
};

struct WhileItem : Item {
    Expr* condition = nullptr;
    Body body{};
    LoopInfo loop{};
};

struct ReturnItem : Item {
    Expr* value = nullptr;
};

}  // namespace lray::parser
