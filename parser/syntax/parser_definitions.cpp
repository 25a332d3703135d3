// The parser's items that bring names: let, var, param, include, import.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/did_you_mean.h"
#include "parser/blocks/schema.h"
#include "parser/syntax/characters.h"
#include "parser/syntax/parser_state.h"

namespace lray::parser {

namespace {

/// The file's name without its directories and its last extension; empty if that is no name.
std::string_view stem_of(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\:");
    if (slash != path.npos) path.remove_prefix(slash + 1);
    path = path.substr(0, path.rfind('.'));
    const bool is_name =
        !path.empty() && is_a(path.front(), kLetter) &&
        std::all_of(path.begin(), path.end(), [](char c) { return is_a(c, kLetter | kDigit); });
    const bool is_keyword = std::find(kKeywords.begin(), kKeywords.end(), path) != kKeywords.end();
    return is_name && !is_keyword ? path : std::string_view{};
}

}  // namespace

// A name that is given here; what it stands after is for the message.
std::optional<Token> Parser::new_name(std::string_view after) {
    if (is_keyword(token_.kind) && continues_line()) {
        error(Code::E0114, span_of(token_),
              fmt::format("`{}` is a keyword; choose another name", text_of(token_)));
        return std::nullopt;
    }
    if (token_.kind != TokenKind::identifier || !continues_line()) {
        error(Code::E0102, continues_line() ? span_of(token_) : here(),
              fmt::format("expected a name after `{}`", after));
        return std::nullopt;
    }
    const Token name = token_;
    advance();
    return name;
}

// Stands for a definition that was not understood: uses of its name are silent.
Item* Parser::poisoned(const Token& name) {
    LetItem* result = make_item<LetItem>(ItemKind::let, span_of(name));
    result->name = name.symbol;
    result->name_span = span_of(name);
    result->value = error_expr(span_of(name));
    return result;
}

// let   = "let" IDENT [ ":" type ] "=" expr
// var   = "var" IDENT [ ":" type ] "=" expr
// param = "param" IDENT [ ":" type ] "=" expr [ "in" expr ]
Item* Parser::let(LetKind kind) {
    const Token keyword = token_;
    const std::string_view doc = doc_comment();
    advance();
    const std::optional<Token> name = new_name(text_of(keyword));
    if (!name) return nullptr;
    LetItem* result = static_cast<LetItem*>(poisoned(*name));
    result->let_kind = kind;
    result->doc = doc;
    if (kind == LetKind::param && !around_.is_file_level) {
        error(Code::E0118, span_of(keyword), "`param` stands at the top level of a file")
            .with_help(fmt::format("a value is written `let {} = ...`", text_of(*name)));
        is_panicking_ = false;
    }
    if (token_.kind == TokenKind::colon) annotation(*result);
    if (is_panicking_) return result;
    if (token_.kind == TokenKind::foreign && continues_line()) {
        foreign_operator(nullptr);
    } else if (token_.kind != TokenKind::equal) {
        Diagnostic& diagnostic =
            error(Code::E0107, here(), fmt::format("expected `=` after `{}`", text_of(*name)));
        if (kind != LetKind::let) {
            diagnostic.with_help(fmt::format("write `{} {} = ...`: it has a value from the begin",
                                             text_of(keyword), text_of(*name)));
        }
    } else {
        advance();
        result->value = value();
        if (kind == LetKind::param) choices(*result);
    }
    result->span = span_from(keyword.offset);
    return result;
}

// After a name: `: type`.
void Parser::annotation(LetItem& item) {
    advance();
    const bool is_value = is_one_of(token_.kind, TokenKind::number, TokenKind::string,
                                    TokenKind::color, TokenKind::left_bracket, TokenKind::minus,
                                    TokenKind::kw_true, TokenKind::kw_false);
    if (is_value) {
        error(Code::E0107, span_of(token_),
              fmt::format("expected `=` after `{}`", context_.symbols.text(item.name)))
            .with_help("`:` is for properties, and for types like `number`");
        is_panicking_ = false;
        value();
        is_panicking_ = true;
        return;
    }
    item.type = type();
}

// After the default of a param: `in` with its bounds or choices.
void Parser::choices(LetItem& param) {
    if (is_panicking_) return;
    if (token_.kind == TokenKind::kw_in) {
        advance();
        param.choices = value();
    } else if (token_.kind == TokenKind::left_bracket && continues_line()) {
        error(Code::E0107, span_of(token_), "expected `in` before `[`");
    }
}

// type = "any" | "number" | "int" | "bool" | "string" | "vec2" | "vec3" | "vec4" | "color"
//      | "list" | "transform" | "texture" | "material" | "node" | "record" | "function"
TypeName Parser::type() {
    const Token word = token_;
    const std::string_view text = text_of(word);
    const bool is_word = word.kind == TokenKind::identifier || is_keyword(word.kind);
    if (!is_word || !continues_line()) {
        error(Code::E0102, continues_line() ? span_of(word) : here(),
              "expected a type after `:`, like `number`");
        return TypeName::any;
    }
    advance();
    const auto found = std::find(kTypeNames.begin(), kTypeNames.end(), text);
    if (found != kTypeNames.end()) return static_cast<TypeName>(found - kTypeNames.begin());
    std::string hint = did_you_mean(text, kTypeNames);
    const std::string_view usual = usual_type(text);
    if (!usual.empty()) hint = fmt::format("here it is called `{}`", usual);
    Diagnostic& diagnostic =
        error(Code::E0201, span_of(word), fmt::format("unknown type `{}`", text)).with_hint(hint);
    if (hint.empty()) {
        std::string all;
        for (const std::string_view name : kTypeNames) {
            all += fmt::format("{}{}", all.empty() ? "" : " ", name);
        }
        diagnostic.with_help(fmt::format("the types are {}", all));
    }
    is_panicking_ = false;
    return TypeName::any;
}

// The `///` lines before the item that begins here, without their slashes.
std::string_view Parser::doc_comment() {
    std::string_view lines = lexer_.doc_lines_before(token_.offset);
    if (lines.empty()) return {};
    std::string text;
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find_first_of("\n\r"), lines.size());
        std::string_view line = lines.substr(0, end);
        lines.remove_prefix(end);
        const std::size_t next = lines.find('/');
        lines.remove_prefix(std::min(next, lines.size()));
        line.remove_prefix(3);
        if (line.starts_with(' ')) line.remove_prefix(1);
        while (!line.empty() && is_a(line.back(), kBlank)) line.remove_suffix(1);
        if (!text.empty()) text += '\n';
        text += line;
    }
    return context_.arena.copy(std::string_view(text));
}

// The value of a property or name.
Expr* Parser::value() {
    const bool is_next_item = token_.newline_before && token_.kind == TokenKind::identifier &&
                              bracket_depth_ == 0 &&
                              is_one_of(ahead().kind, TokenKind::equal, TokenKind::colon);
    if (is_next_item) {
        error(Code::E0109, here(), "expected a value");
        is_panicking_ = false;
        return error_expr(here());
    }
    Expr* read = expression();
    if (skip_list_without_opener(*read)) return error_expr(read->span);
    if (read->kind != ExprKind::name) return read;
    const bool is_block = find_block(static_cast<NameExpr*>(read)->symbol) != nullptr;
    const bool may_lack_brace =
        token_.newline_before ? is_block : line_closes_too_many_braces(token_);
    if (may_lack_brace && read_block_without_brace(read->span)) return error_expr(read->span);
    return read;
}

// include = "include" STRING
Item* Parser::include() {
    const std::uint32_t begin = token_.offset;
    advance();
    if (token_.kind != TokenKind::string || token_.newline_before) {
        error(Code::E0109, token_.newline_before ? here() : span_of(token_),
              "`include` needs a file name in quotes, like \"materials.lrs\"");
        return nullptr;
    }
    IncludeItem* result = make_item<IncludeItem>(ItemKind::include, span_of(token_));
    result->path = static_cast<StringExpr*>(string());
    result->span = span_from(begin);
    result->runs_any_times = around_.runs_any_times;
    includes_.push_back(result);
    if (token_.kind == TokenKind::kw_as && continues_line()) {
        error(Code::E0105, span_of(token_), "`include` gives no name to the file")
            .with_help("write `import` for `include`: the names in the file are `name.x`");
    }
    return result;
}

// import = "import" STRING [ "as" IDENT ]
Item* Parser::import() {
    const Token keyword = token_;
    advance();
    if (token_.kind != TokenKind::string || token_.newline_before) {
        const Token found = token_;
        error(Code::E0109, found.newline_before ? here() : span_of(found),
              "`import` needs a file name in quotes, like \"materials.lrs\"")
            .with_help("write `import \"materials.lrs\" as materials`");
        const bool is_name = found.kind == TokenKind::identifier && !found.newline_before;
        return is_name ? poisoned(found) : nullptr;
    }
    ImportItem* result = make_item<ImportItem>(ItemKind::import, span_of(token_));
    result->path = static_cast<StringExpr*>(string());
    const bool has_alias = alias(*result);
    result->span = span_from(keyword.offset);
    if (!around_.is_file_level) {
        if (has_alias) {
            error(Code::E0118, span_of(keyword), "`import` stands at the top level of a file");
            is_panicking_ = false;
        }
        LetItem* silent = make_item<LetItem>(ItemKind::let, result->alias_span);
        silent->name = result->alias;
        silent->name_span = result->alias_span;
        silent->value = error_expr(result->alias_span);
        return result->alias == kNoSymbol ? nullptr : silent;
    }
    imports_.push_back(result);
    return result;
}

// After the path of an import: the name it gets. Returns false when it gets none.
bool Parser::alias(ImportItem& item) {
    if (token_.kind == TokenKind::kw_as && continues_line()) {
        advance();
        const bool is_word = token_.kind == TokenKind::identifier || is_keyword(token_.kind);
        if (token_.newline_before && !(is_word && !starts_item(token_, ahead()))) {
            error(Code::E0102, here(), "expected a name after `as`");
            return false;
        }
        token_.newline_before = false;  // `as` goes on in the next line
        const std::optional<Token> name = new_name("as");
        if (!name) return false;
        item.alias = name->symbol;
        item.alias_span = span_of(*name);
        return true;
    }
    item.alias_span = item.path->span;
    if (item.path->kind != ExprKind::string) return false;
    const std::string_view stem = stem_of(item.path->value);
    if (!stem.empty()) {
        item.alias = context_.symbols.intern(stem);
        return true;
    }
    error(Code::E0102, item.path->span, "the name of this file is no name in a scene")
        .with_help("write `as name` behind it");
    is_panicking_ = false;
    return false;
}

}  // namespace lray::parser
