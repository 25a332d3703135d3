#include "tests/parser/syntax_tree.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "parser/syntax/parser.h"
#include "parser/values/value.h"
#include "tests/parser/loaded.h"

namespace lray::test {

using namespace parser;

namespace {

class TreePrinter {
 public:
    TreePrinter(const Sources& sources, const Symbols& symbols)
        : sources_(sources), symbols_(symbols) {}

    std::string item(const Item& item) const;

    std::string items(std::span<Item* const> list, std::string_view separator) const {
        std::string text;
        for (const Item* one : list) {
            text += fmt::format("{}{}", text.empty() ? "" : separator, item(*one));
        }
        return text;
    }

 private:
    std::string expression(const Expr& expr) const;
    std::string packed(const PackedListExpr& expr) const;
    std::string let(const LetItem& item) const;
    std::string function(const Function& function) const;
    std::string conditional(const ConditionalItem& item) const;

    std::string name(Symbol symbol) const { return std::string(symbols_.text(symbol)); }
    std::string body(const Body& body) const {
        return fmt::format("{{{}}}", items(body.items, "; "));
    }

    /// "i x" or "x"
    std::string loop_names(Symbol index, Symbol element) const {
        return index == kNoSymbol ? name(element)
                                  : fmt::format("{} {}", name(index), name(element));
    }

    static std::string type(TypeName name) {
        if (name == TypeName::any) return {};
        return fmt::format(":{}", kTypeNames[static_cast<std::size_t>(name)]);
    }

    static std::string doc(std::string_view text) {
        std::string shown;
        for (const char c : text) shown += c == '\n' ? std::string("|") : std::string(1, c);
        return text.empty() ? std::string{} : fmt::format(" /{}/", shown);
    }

    const Sources& sources_;
    const Symbols& symbols_;
};

std::string TreePrinter::packed(const PackedListExpr& expr) const {
    std::string text;
    for (std::uint32_t row = 0; row < expr.count; ++row) {
        std::string numbers;
        for (std::uint32_t i = 0; i < expr.width; ++i) {
            numbers += fmt::format("{}{}", i == 0 ? "" : " ",
                                   format_number(expr.values[row * expr.width + i]));
        }
        text += fmt::format("{}{}", row == 0 ? "" : " ",
                            expr.is_nested ? fmt::format("[{}]", numbers) : numbers);
    }
    return fmt::format("#[{}]", text);
}

std::string TreePrinter::function(const Function& made) const {
    std::string parameters;
    for (const ParameterDecl& declared : made.parameters) {
        parameters += fmt::format("{}{}{}", parameters.empty() ? "" : " ", name(declared.name),
                                  type(declared.type));
        if (declared.default_value != nullptr) {
            parameters += fmt::format("={}", expression(*declared.default_value));
        }
    }
    const std::string head = made.name == kNoSymbol ? "" : fmt::format("{} ", name(made.name));
    return fmt::format("({} {}({}) {}{})", made.is_component ? "component" : "fn", head, parameters,
                       made.value != nullptr ? expression(*made.value) : body(made.body),
                       doc(made.doc));
}

std::string TreePrinter::expression(const Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::error:
            return "?";
        case ExprKind::number:
            return format_number(static_cast<const NumberExpr&>(expr).value);
        case ExprKind::boolean:
            return static_cast<const BooleanExpr&>(expr).value ? "true" : "false";
        case ExprKind::string:
            return fmt::format("\"{}\"", static_cast<const StringExpr&>(expr).value);
        case ExprKind::color:
            return std::string(sources_.text(expr.span));
        case ExprKind::name:
            return name(static_cast<const NameExpr&>(expr).symbol);
        case ExprKind::unary: {
            const UnaryExpr& unary = static_cast<const UnaryExpr&>(expr);
            const char* const op = unary.op == TokenKind::minus  ? "-"
                                   : unary.op == TokenKind::plus ? "+"
                                                                 : "not";
            return fmt::format("({} {})", op, expression(*unary.operand));
        }
        case ExprKind::binary: {
            const BinaryExpr& binary = static_cast<const BinaryExpr&>(expr);
            return fmt::format("({} {} {})", sources_.text(binary.op_span),
                               expression(*binary.left), expression(*binary.right));
        }
        case ExprKind::conditional: {
            const ConditionalExpr& choice = static_cast<const ConditionalExpr&>(expr);
            return fmt::format("(if {} {} {})", expression(*choice.condition),
                               expression(*choice.then_value), expression(*choice.else_value));
        }
        case ExprKind::call: {
            const CallExpr& call = static_cast<const CallExpr&>(expr);
            std::string text = expression(*call.callee);
            for (const Argument& argument : call.arguments) {
                text += argument.name == kNoSymbol ? " " : fmt::format(" {}:", name(argument.name));
                text += expression(*argument.value);
            }
            return fmt::format("(call {})", text);
        }
        case ExprKind::index: {
            const IndexExpr& index = static_cast<const IndexExpr&>(expr);
            return fmt::format("(at {} {})", expression(*index.object), expression(*index.index));
        }
        case ExprKind::member: {
            const MemberExpr& member = static_cast<const MemberExpr&>(expr);
            return fmt::format("(. {} {})", expression(*member.object), name(member.name));
        }
        case ExprKind::list: {
            std::string text;
            for (const Expr* element : static_cast<const ListExpr&>(expr).elements) {
                text += fmt::format("{}{}", text.empty() ? "" : " ", expression(*element));
            }
            return fmt::format("[{}]", text);
        }
        case ExprKind::packed_list:
            return packed(static_cast<const PackedListExpr&>(expr));
        case ExprKind::block: {
            const BlockExpr& block = static_cast<const BlockExpr&>(expr);
            const std::string label =
                block.label == nullptr ? "" : fmt::format(" \"{}\"", block.label->value);
            return fmt::format("({}{} {})", expression(*block.head), label, body(block.body));
        }
        case ExprKind::comprehension: {
            const ComprehensionExpr& each = static_cast<const ComprehensionExpr&>(expr);
            const std::string condition =
                each.condition == nullptr ? "" : fmt::format(" if {}", expression(*each.condition));
            return fmt::format("[for {} in {}{}: {}]",
                               loop_names(each.index_name, each.element_name),
                               expression(*each.sequence), condition, expression(*each.value));
        }
        case ExprKind::function:
            return function(*static_cast<const FunctionExpr&>(expr).function);
    }
    LRAY_ASSERT(false);
}

std::string TreePrinter::let(const LetItem& item) const {
    const char* const keyword = item.let_kind == LetKind::let   ? "let"
                                : item.let_kind == LetKind::var ? "var"
                                                                : "param";
    const std::string choices =
        item.choices == nullptr ? "" : fmt::format(" in {}", expression(*item.choices));
    return fmt::format("({} {}{} {}{}{})", keyword, name(item.name), type(item.type),
                       expression(*item.value), choices, doc(item.doc));
}

std::string TreePrinter::conditional(const ConditionalItem& item) const {
    const std::string else_body = item.has_else ? fmt::format(" {}", body(item.else_body)) : "";
    return fmt::format("(if {} {}{})", expression(*item.condition), body(item.then_body),
                       else_body);
}

std::string TreePrinter::item(const Item& one) const {
    switch (one.kind) {
        case ItemKind::let:
            return let(static_cast<const LetItem&>(one));
        case ItemKind::property: {
            const PropertyItem& property = static_cast<const PropertyItem&>(one);
            return fmt::format("{}: {}", name(property.name), expression(*property.value));
        }
        case ItemKind::block:
            return expression(*static_cast<const BlockItem&>(one).block);
        case ItemKind::call:
            return expression(*static_cast<const CallItem&>(one).value);
        case ItemKind::assignment: {
            const AssignmentItem& assignment = static_cast<const AssignmentItem&>(one);
            return fmt::format("(= {} {})", expression(*assignment.target),
                               expression(*assignment.value));
        }
        case ItemKind::include:
            return fmt::format("(include \"{}\")",
                               static_cast<const IncludeItem&>(one).path->value);
        case ItemKind::import: {
            const ImportItem& import = static_cast<const ImportItem&>(one);
            return fmt::format("(import \"{}\" {})", import.path->value,
                               import.alias == kNoSymbol ? "?" : name(import.alias));
        }
        case ItemKind::file_view:
            return "(view)";
        case ItemKind::literals: {
            const LiteralsItem& literals = static_cast<const LiteralsItem&>(one);
            if (literals.material == nullptr) return fmt::format("#{}", literals.count);
            return fmt::format("#{}:{}", literals.count, name(literals.material->symbol));
        }
        case ItemKind::function:
            return function(*static_cast<const FunctionItem&>(one).function);
        case ItemKind::conditional:
            return conditional(static_cast<const ConditionalItem&>(one));
        case ItemKind::for_loop: {
            const ForItem& loop = static_cast<const ForItem&>(one);
            return fmt::format("(for {} in {} {})", loop_names(loop.index_name, loop.element_name),
                               expression(*loop.sequence), body(loop.body));
        }
        case ItemKind::while_loop: {
            const WhileItem& loop = static_cast<const WhileItem&>(one);
            return fmt::format("(while {} {})", expression(*loop.condition), body(loop.body));
        }
        case ItemKind::break_loop:
            return "break";
        case ItemKind::continue_loop:
            return "continue";
        case ItemKind::return_value:
            return fmt::format("(return {})",
                               expression(*static_cast<const ReturnItem&>(one).value));
    }
    LRAY_ASSERT(false);
}

}  // namespace

Parsed parse_text(std::string_view text, std::uint32_t max_nesting) {
    Sources sources;
    const SourceId source = sources.add("main.lrs", Text(text));
    Symbols symbols;
    Arena arena;
    scene::Scene scene;
    std::vector<OwnedNumbers> long_lists;
    ParseContext context{sources, symbols, arena, scene, long_lists, max_nesting, true};
    Diagnostics diagnostics;
    const ParsedFile file = parse(source, context, diagnostics);
    Parsed result;
    result.tree = TreePrinter(sources, symbols).items(file.items, "\n");
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        result.errors += fmt::format("{} {} {}\n", code_info(diagnostic->code).id,
                                     place_of(sources, diagnostic->span), diagnostic->message);
    }
    result.error_count = diagnostics.error_count();
    result.node_count = scene.nodes.size();
    result.import_count = file.imports.size();
    return result;
}

}  // namespace lray::test
