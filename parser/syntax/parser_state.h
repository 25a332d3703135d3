// The recursive-descent parser's state and its productions. Used by parser_*.cpp alone.
#pragma once

#include <initializer_list>
#include <vector>

#include "parser/syntax/parser.h"

namespace lray::parser {

/// Whom to believe when braces do not match: the braces first, and in a second run over the file
/// the indentation.
enum class Structure : std::uint8_t { braces, indentation };

class Parser {
 public:
    Parser(SourceId source, ParseContext& context, Structure structure, Diagnostics& diagnostics);

    ParsedFile file();

 private:
    // parser_items.cpp
    std::span<Item* const> items(bool is_file);
    Item* item();
    Item* let();
    Item* include();
    Item* head_item();
    Item* property();
    Item* statement_expression(Expr* head);
    bool step_operator(const Expr& head);
    Item* misplaced_name(const Token& name);
    Body body(std::string_view head);
    void version();
    void misplaced_version();
    Item* future_statement();
    void bad_statement();

    // parser_expr.cpp
    Expr* expression();
    Expr* value();
    Expr* binary(unsigned limit);
    Expr* unary();
    Expr* power();
    Expr* postfix();
    Expr* postfix_of(Expr* object, bool is_grouped = false);
    Expr* primary();
    Expr* conditional();
    Expr* list();
    Expr* call(Expr* callee);
    Expr* block(Expr* head);
    Expr* string();
    Expr* color();
    void foreign_operator(const Expr* left);
    void chained_comparison(const BinaryExpr& first);
    void missing_value();

    // packed_list.cpp
    Expr* packed_list();

    // literal_block.cpp
    bool literal_block(const Token& name, scene::NodeId& node);

    // parser_recovery.cpp
    void synchronize();
    void skip_line();
    void skip_balanced();
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
    std::vector<IncludeItem*> includes_;
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
