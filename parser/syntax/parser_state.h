// The recursive-descent parser's state and its productions. Used by parser_*.cpp alone.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/syntax/parser.h"

namespace lray::parser {

/// Whom to believe when braces do not match: the braces first, and in a second run over the file
/// the indentation.
enum class Structure : std::uint8_t { braces, indentation };

/// What the items that are read stand in.
struct Surroundings {
    bool is_file_level = true;
    bool is_in_loop = false;
    bool is_in_function = false;
    bool is_in_component = false;
    bool is_if_branch = false;      // an `else` ends it
    bool runs_any_times = false;    // not once: nothing in it may become a node by being read
    bool has_children = true;       // for sure: a file or a group
    bool has_loop_outside = false;  // which cannot be left from in here
    bool has_function_outside = false;

    /// What is placed is whole: a loop around it is not left half way through.
    Surroundings placed_block() const {
        Surroundings inner = statement();
        inner.has_loop_outside = is_in_loop || has_loop_outside;
        inner.is_in_loop = false;
        return inner;
    }
    Surroundings branch() const {
        Surroundings inner = statement();
        inner.is_if_branch = true;
        inner.runs_any_times = true;
        return inner;
    }
    Surroundings loop() const {
        Surroundings inner = statement();
        inner.is_in_loop = true;
        inner.runs_any_times = true;
        return inner;
    }
    /// No loop and no function around a value can be left from inside it.
    Surroundings value_block() const {
        Surroundings inner;
        inner.is_file_level = false;
        inner.runs_any_times = runs_any_times;
        inner.has_loop_outside = is_in_loop || has_loop_outside;
        inner.has_function_outside = is_in_function || has_function_outside;
        return inner;
    }
    Surroundings function() const {
        Surroundings inner = value_block();
        inner.is_in_function = true;
        inner.runs_any_times = true;
        return inner;
    }
    Surroundings function_value() const {
        Surroundings inner = value_block();
        inner.runs_any_times = true;
        return inner;
    }
    Surroundings component() const {
        Surroundings inner = value_block();
        inner.is_in_component = true;
        inner.runs_any_times = true;
        return inner;
    }

 private:
    Surroundings statement() const {
        Surroundings inner = *this;
        inner.is_file_level = false;
        inner.is_if_branch = false;
        return inner;
    }
};

/// A block of literals that was read.
struct LiteralBlock {
    scene::NodeId node_id{};
    Symbol material = kNoSymbol;  // none: it names no material
    Span material_span{};
};

/// `i, x` of a loop over a list.
struct LoopNames {
    Symbol index_name = kNoSymbol;  // none: only the element has a name
    Span index_span{};
    Symbol element_name = kNoSymbol;
    Span element_span{};
};

/// Returns what a type of another language is called here; empty when it is not known.
std::string_view usual_type(std::string_view word);

class Parser {
 public:
    Parser(SourceId source, ParseContext& context, Structure structure, Diagnostics& diagnostics);

    ParsedFile file();

 private:
    // parser_items.cpp
    std::span<Item* const> items(bool is_file);
    Item* item();
    Item* keyword_item();
    Item* head_item();
    Item* literals(const LiteralBlock& block);
    Item* property();
    Item* statement_expression(Expr* head);
    Body body(std::string_view head, const Surroundings& around);
    void version();
    void bad_statement();

    // parser_definitions.cpp
    Item* let(LetKind kind);
    void annotation(LetItem& item);
    void choices(LetItem& param);
    std::optional<Token> new_name(std::string_view after);
    TypeName type();
    std::string_view doc_comment();
    Expr* value();
    Item* include();
    Item* import();
    bool alias(ImportItem& item);
    FunctionItem* function_item(const Token& name, std::string_view doc);
    Item* poisoned(const Token& name);

    // parser_functions.cpp
    Item* function();
    Item* component();
    Expr* function_value();
    bool parameters(Function& function, std::string_view head);
    bool parameter(std::vector<ParameterDecl>& list);
    bool function_result(Function& function, const Token& name);

    // parser_statements.cpp
    Item* if_statement();
    void else_branch(ConditionalItem& item, const Surroundings& around);
    Item* for_statement();
    Item* while_statement();
    Item* jump();
    Item* return_statement();
    Expr* condition(const Token& keyword, std::string_view missing);
    std::optional<LoopNames> loop_names(std::string_view example);
    Body statement_body(const Token& head, const Surroundings& around);
    void items_without_braces(const Token& head, const Surroundings& around);
    bool skip_to_body();

    // parser_expr.cpp
    Expr* expression();
    Expr* conditional();
    Expr* compared(Expr* left);
    Expr* binary(unsigned limit);
    Expr* unary();
    Expr* power();
    Expr* postfix();
    Expr* postfix_of(Expr* object, bool is_grouped = false, bool is_placed = false);
    Expr* call(Expr* callee);
    Expr* block(Expr* head, bool is_placed);
    void chained_comparison(const BinaryExpr& first);

    // parser_primary.cpp
    Expr* primary();
    Expr* list();
    Expr* comprehension(const Token& opener);
    Expr* string();
    Expr* color();
    void missing_value();

    // parser_habits.cpp
    void foreign_operator(const Expr* left, bool is_value = false);
    bool step_operator(const Expr& head);
    Item* misplaced_name(const Token& name);
    void misplaced_version();

    // packed_list.cpp
    Expr* packed_list();

    // literal_block.cpp
    std::optional<LiteralBlock> literal_block(const Token& name);

    // parser_recovery.cpp
    void synchronize();
    void skip_line();
    void skip_to_last_unopened_closer();
    void skip_to_closing_line(const Token& opener);
    bool list_is_closed_below() const;
    void skip_balanced();
    void skip_with_lines_below(const Token& head);
    bool starts_item(const Token& token, const Token& after) const;
    bool starts_item_on_new_line();
    bool is_dedented(const Token& token);
    bool closes_outer_block(const Token& token);
    bool close(TokenKind closer, const Token& opener);
    bool line_has_unopened_closer(const Token& from) const;
    bool line_closes_too_many_braces(const Token& from);
    bool skip_list_without_opener(const Expr& value);
    bool read_block_without_brace(Span head);
    std::uint32_t line_begin(std::uint32_t offset);
    std::uint32_t line_indent(std::uint32_t offset);
    std::string position(const Token& token) const;
    std::string describe(const Token& token) const;

    void advance();
    const Token& ahead();
    void seek(std::uint32_t offset);
    bool continues_line() const { return bracket_depth_ > 0 || !token_.newline_before; }
    bool fits_nesting(std::uint32_t depth, Span span);
    void too_deep(Span span);

    Span span_of(const Token& token) const { return lexer_.span(token.offset, token.end()); }
    Span span_from(std::uint32_t begin) const { return lexer_.span(begin, previous_end_); }
    Span here() const { return lexer_.span(previous_end_, previous_end_); }
    std::string_view text_of(const Token& token) const {
        return {lexer_.begin() + token.offset, token.length};
    }
    Diagnostic& error(Code code, Span span, std::string message);
    Expr* error_expr(Span span);

    template <class T>
    T* make(ExprKind kind, Span span, std::initializer_list<const Expr*> below = {});
    template <class T>
    T* make_item(ItemKind kind, Span span);

    struct Opener {
        std::uint32_t offset = 0;
        std::uint32_t indent = 0;  // of its line
    };

    class Nested;
    class InBrackets;

    ParseContext& context_;
    Diagnostics& diagnostics_;
    Lexer lexer_;
    SourceId source_;
    Structure structure_;
    Diagnostics literal_problems_;  // what the short cut for literals stumbled over; thrown away

    Token token_;
    Token ahead_;
    bool has_ahead_ = false;
    std::uint32_t previous_end_ = 0;

    std::uint32_t last_line_begin_ = 0;  // of the line that holds the byte at last_line_seen_
    std::uint32_t last_line_seen_ = 0;

    std::vector<Opener> openers_;
    std::vector<Item*> open_items_;  // of the blocks that are being read, innermost last
    std::size_t first_item_ = 0;     // of the innermost block
    std::vector<IncludeItem*> includes_;
    std::vector<ImportItem*> imports_;
    Surroundings around_;
    bool is_condition_ = false;        // a `{` opens the body behind it, not a block
    std::uint32_t bracket_depth_ = 0;  // of ( and [ inside the innermost {
    std::uint32_t nesting_ = 0;
    bool is_panicking_ = false;         // an error was reported in this item: skip to the next
    bool has_broken_brackets_ = false;  // it was one of ( ) [ ]: lines and commas mean nothing
    bool is_separated_ = false;  // recovery has already passed the separator of the next item
    bool is_structure_known_ = true;
    bool has_unclosed_ = false;
    bool is_ended_ = false;  // nesting limit: nothing more is read
};

/// One level deeper, as long as it lives.
class Parser::Nested {
 public:
    Nested(Parser& parser, Span span) : parser_(parser) {
        fits_ = parser_.fits_nesting(++parser_.nesting_, span);
    }
    ~Nested() { --parser_.nesting_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

    bool fits() const { return fits_; }

 private:
    Parser& parser_;
    bool fits_ = false;
};

/// Inside ( ) or [ ], as long as it lives: lines do not end anything, and `{` opens a block.
class Parser::InBrackets {
 public:
    explicit InBrackets(Parser& parser) : parser_(parser), is_condition_(parser.is_condition_) {
        ++parser_.bracket_depth_;
        parser_.is_condition_ = false;
    }
    ~InBrackets() {
        --parser_.bracket_depth_;
        parser_.is_condition_ = is_condition_;
    }
    InBrackets(const InBrackets&) = delete;
    InBrackets& operator=(const InBrackets&) = delete;

 private:
    Parser& parser_;
    bool is_condition_ = false;
};

template <class T>
T* Parser::make(ExprKind kind, Span span, std::initializer_list<const Expr*> below) {
    T* expr = context_.arena.make<T>();
    expr->kind = kind;
    expr->span = span;
    std::uint32_t depth = 0;
    for (const Expr* child : below) depth = child->depth > depth ? child->depth : depth;
    expr->depth = static_cast<std::uint16_t>(depth + 1);
    if (depth + 1 > context_.max_nesting) too_deep(span);
    return expr;
}

template <class T>
T* Parser::make_item(ItemKind kind, Span span) {
    T* made = context_.arena.make<T>();
    made->kind = kind;
    made->span = span;
    return made;
}

}  // namespace lray::parser
