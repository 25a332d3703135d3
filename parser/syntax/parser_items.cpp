// The parser's items: what stands between separators in a file or in braces.
#include <fmt/format.h>

#include <utility>

#include "parser/blocks/schema.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

/// Tokens that go on with what stands before them.
constexpr bool is_operator(TokenKind kind) {
    return (kind >= TokenKind::colon && kind <= TokenKind::greater_equal) ||
           is_one_of(kind, TokenKind::kw_and, TokenKind::kw_or);
}

}  // namespace

ParsedFile parse(SourceId source, ParseContext& context, Diagnostics& diagnostics) {
    Diagnostics by_braces;
    ParsedFile file = Parser(source, context, Structure::braces, by_braces).file();
    if (file.is_structure_known) {
        diagnostics.append(by_braces);
        return file;
    }
    Diagnostics by_indentation;
    ParsedFile second = Parser(source, context, Structure::indentation, by_indentation).file();
    const bool is_better =
        by_indentation.error_count() > 0 && by_indentation.error_count() <= by_braces.error_count();
    diagnostics.append(is_better ? by_indentation : by_braces);
    return file;
}

Parser::Parser(SourceId source, ParseContext& context, Structure structure,
               Diagnostics& diagnostics)
    : context_(context),
      diagnostics_(diagnostics),
      lexer_(context.sources, source, context.symbols, diagnostics),
      source_(source),
      structure_(structure) {
    advance();
    previous_end_ = 0;
}

// file = { SEP } [ "lrs" VERSION ( SEP | EOF ) ] items EOF
ParsedFile Parser::file() {
    version();
    ParsedFile result;
    result.items = items(true);
    result.includes = std::move(includes_);
    result.imports = std::move(imports_);
    result.is_structure_known = is_structure_known_;
    return result;
}

void Parser::version() {
    const bool is_version = token_.kind == TokenKind::identifier && text_of(token_) == "lrs" &&
                            ahead().kind == TokenKind::number && !ahead().newline_before;
    if (!is_version) return;
    advance();
    const Token number = token_;
    const std::string_view text = text_of(number);
    advance();
    const std::string_view major = text.substr(0, text.find('.'));
    if (major == "1") return;
    if (number.number > 1.0) {
        error(Code::E0603, span_of(number),
              fmt::format("this scene is written in lrs {}; this program reads lrs 1", text));
    } else {
        error(Code::E0603, span_of(number), fmt::format("there is no lrs {}", text))
            .with_help("the first version is `lrs 1.0`");
    }
}

// items = { SEP } [ item { sep item } ] { SEP }
// sep   = SEP { SEP } | (* empty, if the previous item ended in "}" *)
std::span<Item* const> Parser::items(bool is_file) {
    const std::size_t outer_first = std::exchange(first_item_, open_items_.size());
    const std::size_t first = first_item_;
    bool is_first = true;
    while (!is_ended_) {
        bool is_separated = std::exchange(is_separated_, false) || is_first;
        while (token_.kind == TokenKind::comma || token_.kind == TokenKind::semicolon) {
            advance();
            is_separated = true;
        }
        if (token_.kind == TokenKind::end) break;
        if (token_.kind == TokenKind::right_brace) {
            if (!is_file) break;
            error(Code::E0104, span_of(token_), "`}` closes nothing");
            is_structure_known_ = false;
            is_panicking_ = false;
            advance();
            is_separated_ = true;
            continue;
        }
        if (!is_file && is_dedented(token_)) break;
        // An `else` in the body of an `if` belongs behind its `}`, which is missing.
        if (token_.kind == TokenKind::kw_else && around_.is_if_branch) break;
        const bool follows_brace = previous_end_ > 0 && lexer_.begin()[previous_end_ - 1] == '}';
        if (!is_separated && !token_.newline_before && !follows_brace) {
            error(Code::E0105, span_of(token_),
                  fmt::format("expected `,` or a new line before {}", describe(token_)));
            is_panicking_ = false;  // what follows is read as an item of its own
        }
        const std::uint32_t begin = token_.offset;
        Item* const read = item();
        if (read != nullptr) open_items_.push_back(read);
        if (is_panicking_) synchronize();
        if (token_.offset == begin && token_.kind != TokenKind::end && !is_ended_) advance();
        is_first = false;
    }
    const std::span<Item* const> read(open_items_.begin() + static_cast<std::ptrdiff_t>(first),
                                      open_items_.end());
    const std::span<Item* const> result = context_.arena.copy(read);
    open_items_.resize(first);
    first_item_ = outer_first;
    return result;
}

// item = let | var | param | fn | component | include | import | if | for | while | "break"
//      | "continue" | return | head_item
Item* Parser::item() {
    if (token_.kind == TokenKind::identifier) return head_item();
    if (is_item_keyword(token_.kind)) return keyword_item();
    bad_statement();
    return nullptr;
}

Item* Parser::keyword_item() {
    const TokenKind kind = token_.kind;
    if (kind == TokenKind::kw_let) return let(LetKind::let);
    if (kind == TokenKind::kw_var) return let(LetKind::var);
    if (kind == TokenKind::kw_param) return let(LetKind::param);
    if (kind == TokenKind::kw_fn) return function();
    if (kind == TokenKind::kw_component) return component();
    if (kind == TokenKind::kw_include) return include();
    if (kind == TokenKind::kw_import) return import();
    if (kind == TokenKind::kw_if) return if_statement();
    if (kind == TokenKind::kw_for) return for_statement();
    if (kind == TokenKind::kw_while) return while_statement();
    if (kind == TokenKind::kw_return) return return_statement();
    return jump();
}

void Parser::bad_statement() {
    const Token token = token_;
    using enum TokenKind;
    if (is_one_of(token.kind, right_bracket, right_paren)) {
        error(Code::E0104, span_of(token), fmt::format("`{}` closes nothing", text_of(token)));
    } else if (is_operator(token.kind) && token.newline_before) {
        error(Code::E0113, span_of(token),
              fmt::format("a line cannot start with `{}`; end the previous line with it",
                          text_of(token)));
    } else if (token.kind == kw_else) {
        error(Code::E0117, span_of(token), "`else` without `if`");
    } else if (token.kind == foreign) {
        foreign_operator(nullptr);
    } else if (is_reserved_word(token.kind)) {
        error(Code::E0114, span_of(token),
              fmt::format("`{}` is a keyword, kept for later", text_of(token)));
        skip_balanced();
        is_panicking_ = false;
        return;
    } else if (token.kind == left_brace) {
        error(Code::E0108, span_of(token), "this `{` has nothing in front of it")
            .with_help("write `group {` to put things together");
        skip_balanced();
        is_panicking_ = false;
        return;
    } else {
        error(Code::E0108, span_of(token),
              fmt::format("a statement cannot start with {}", describe(token)));
    }
    skip_line();
    is_panicking_ = false;
}

// head_item = IDENT ":" expr | IDENT "=" expr | head [ STRING ] body | head
Item* Parser::head_item() {
    // The short cut trusts braces; the second run over a file does not.
    const bool may_be_literal = context_.use_literal_fast_path && structure_ == Structure::braces &&
                                !around_.runs_any_times && around_.has_children;
    if (may_be_literal) {
        if (const std::optional<LiteralBlock> block = literal_block(token_)) {
            return literals(*block);
        }
    }
    const Token name = token_;
    const Token next = ahead();
    if (next.kind == TokenKind::colon) return property();
    const bool is_on_line = !next.newline_before;
    const bool starts_value = next.kind == TokenKind::identifier ||
                              next.kind == TokenKind::number || next.kind == TokenKind::color ||
                              next.kind == TokenKind::kw_true || next.kind == TokenKind::kw_false;
    if (is_on_line && next.kind == TokenKind::number && text_of(name) == "lrs") {
        misplaced_version();
        return nullptr;
    }
    if (is_on_line && starts_value) return misplaced_name(name);

    NameExpr* head = make<NameExpr>(ExprKind::name, span_of(name));
    head->symbol = name.symbol;
    advance();
    return statement_expression(postfix_of(head, false, true));
}

// Null: the block has joined those before it.
Item* Parser::literals(const LiteralBlock& block) {
    if (open_items_.size() > first_item_ && open_items_.back()->kind == ItemKind::literals) {
        LiteralsItem& last = static_cast<LiteralsItem&>(*open_items_.back());
        const Symbol material = last.material == nullptr ? kNoSymbol : last.material->symbol;
        // What stands between them may have been dropped for its mistakes, not its nodes.
        const bool is_next = last.first_node + last.count == block.node_id.value;
        if (material == block.material && is_next) {
            ++last.count;
            return nullptr;
        }
    }
    LiteralsItem* result =
        make_item<LiteralsItem>(ItemKind::literals, context_.scene.node(block.node_id).span);
    result->first_node = block.node_id.value;
    result->count = 1;
    if (block.material != kNoSymbol) {
        result->material = make<NameExpr>(ExprKind::name, block.material_span);
        result->material->symbol = block.material;
    }
    return result;
}

// property = IDENT ":" expr
Item* Parser::property() {
    PropertyItem* result = make_item<PropertyItem>(ItemKind::property, span_of(token_));
    const Token name = token_;
    result->name = name.symbol;
    result->name_span = span_of(name);
    advance();
    advance();
    // A value may stand on the next line, but the next property or the end is no value.
    const bool has_value =
        token_.kind != TokenKind::right_brace && token_.kind != TokenKind::comma &&
        token_.kind != TokenKind::semicolon && token_.kind != TokenKind::end &&
        !(token_.newline_before && token_.kind != TokenKind::kw_if && starts_item(token_, ahead()));
    if (!has_value) {
        error(Code::E0109, span_of(name),
              fmt::format("`{}:` needs a value, like `1`", text_of(name)));
        is_panicking_ = false;
        result->value = error_expr(span_of(name));
        return result;
    }
    result->value = value();
    result->span = span_from(name.offset);
    return result;
}

// After a head that is not a property: assignment, block or call.
Item* Parser::statement_expression(Expr* head) {
    const Span span = head->span;
    if (is_panicking_) return nullptr;
    if (head->kind == ExprKind::block) {
        BlockItem* result = make_item<BlockItem>(ItemKind::block, span);
        result->block = static_cast<BlockExpr*>(head);
        return result;
    }
    if (token_.kind == TokenKind::equal && continues_line()) {
        AssignmentItem* result = make_item<AssignmentItem>(ItemKind::assignment, span);
        result->target = head;
        advance();
        result->value = value();
        result->span = span_from(span.offset);
        return result;
    }
    if (token_.kind == TokenKind::foreign && continues_line()) {
        foreign_operator(head);
        return nullptr;
    }
    if (step_operator(*head)) return nullptr;
    if (head->kind == ExprKind::call) {
        CallItem* result = make_item<CallItem>(ItemKind::call, span);
        result->value = head;
        return result;
    }
    const std::string_view text = context_.sources.text(span);
    const BlockSchema* block = head->kind == ExprKind::name ? find_block(text) : nullptr;
    if (token_.kind == TokenKind::string && continues_line()) advance();  // a label
    if (read_block_without_brace(span)) return nullptr;
    if (block != nullptr) {
        error(Code::E0107, here(), fmt::format("expected `{{` after `{}`", text));
        return nullptr;
    }
    error(Code::E0107, here(), fmt::format("expected `:` or `{{` after `{}`", text));
    return nullptr;
}

// body = "{" items "}"
Body Parser::body(std::string_view head, const Surroundings& around) {
    const Token open = token_;
    Body result;
    result.open = span_of(open);
    if (open.newline_before) {
        error(Code::E0116, span_of(open), fmt::format("put `{{` on the same line as `{}`", head));
        is_panicking_ = false;
    }
    const std::uint32_t outer_brackets = std::exchange(bracket_depth_, 0u);
    const bool was_condition = std::exchange(is_condition_, false);
    const Surroundings outer = std::exchange(around_, around);
    openers_.push_back({open.offset, line_indent(open.offset)});
    advance();
    result.items = items(false);
    const bool is_closed = token_.kind == TokenKind::right_brace && !closes_outer_block(token_);
    openers_.pop_back();
    around_ = outer;
    is_condition_ = was_condition;
    bracket_depth_ = outer_brackets;
    result.close = span_of(token_);
    if (is_closed) {
        advance();
    } else if (!is_ended_) {
        is_structure_known_ = false;
        const bool is_at_end = token_.kind == TokenKind::end;
        if (!is_at_end || !has_unclosed_) {
            error(Code::E0103, span_of(open), "this `{` is never closed");
            is_panicking_ = false;
        }
        has_unclosed_ = has_unclosed_ || is_at_end;
    }
    return result;
}

}  // namespace lray::parser
