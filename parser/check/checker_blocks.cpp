// Checks blocks: what their head is, what stands in them, and where they may stand.
#include "parser/check/checker_state.h"
#include "parser/syntax/literal_block.h"

namespace lray::parser {

namespace {

/// The name at the front of an expression, in its file or in an import; null if there is none.
const NameExpr* name_in(const Expr& expr) {
    if (expr.kind == ExprKind::name) return static_cast<const NameExpr*>(&expr);
    if (expr.kind == ExprKind::member) return static_cast<const MemberExpr&>(expr).imported;
    return nullptr;
}

std::uint64_t key(Span place) {
    return std::uint64_t{place.source} << 32 | place.offset;
}

bool has_statements(std::span<Item* const> items) {
    for (const Item* item : items) {
        const ItemKind kind = item->kind;
        const bool is_statement = kind == ItemKind::conditional || kind == ItemKind::for_loop ||
                                  kind == ItemKind::while_loop;
        if (is_statement) return true;
    }
    return false;
}

}  // namespace

void FileChecker::placed_block(const BlockItem& item, const Place& parent) {
    BlockExpr& placed = *item.block;
    block(placed, true);
    if (parent.kind == Place::Kind::function) {
        error(Code::E0404, placed.head->span, "a function cannot place anything; it gives a value")
            .with_help(fmt::format("make it a `component`, or write `return {} {{ ... }}`",
                                   text(*placed.head)));
        return;
    }
    const BlockSchema* const schema = schema_of(*placed.head);
    const NameExpr* const head = name_in(*placed.head);
    const bool is_built_in = head != nullptr && head->meaning == Meaning::block;
    if (schema == nullptr) return;
    const bool is_value =
        is_texture(schema->kind) || schema->kind == BlockKind::record ||
        (schema->kind == BlockKind::material && (!is_built_in || parent.kind == Place::Kind::file));
    if (is_value) {
        report_placed_value(schema->kind, text(*placed.head), placed.head->span, diagnostics_);
        return;
    }
    if (parent.kind == Place::Kind::file) top_level_block(placed, *schema);
}

void FileChecker::top_level_block(const BlockExpr& placed, const BlockSchema& schema) {
    const bool is_unique = schema.kind == BlockKind::render || schema.kind == BlockKind::info;
    if (!is_unique) return;
    Span& first = schema.kind == BlockKind::render ? first_render_ : first_info_;
    if (first.is_nowhere()) {
        first = placed.head->span;
        return;
    }
    error(Code::E0405, placed.head->span, fmt::format("a second `{}` block", schema.name))
        .with_label(first, "the first one is here");
}

// The schema of the block that an expression makes or names, when that is plain to see.
const BlockSchema* FileChecker::schema_of(const Expr& expr) const {
    const Expr* at = &expr;
    while (at->kind == ExprKind::block) at = static_cast<const BlockExpr*>(at)->head;
    const NameExpr* const head = name_in(*at);
    if (head == nullptr) return nullptr;
    if (head->meaning == Meaning::block) return &block_schema(static_cast<BlockKind>(head->index));
    const auto schema = program_.schemas.find(key(head->definition));
    return schema == program_.schemas.end() ? nullptr : schema->second;
}

void FileChecker::know_schema(Span definition, const BlockSchema* schema) {
    if (schema != nullptr) program_.schemas[key(definition)] = schema;
}

// The parser has decoded and checked all of them but the name of their material.
void FileChecker::literals(LiteralsItem& item) {
    if (item.material == nullptr) return;
    const NameExpr written = *item.material;
    const std::size_t errors_before = diagnostics_.error_count();
    material_of_literals(*item.material);
    if (diagnostics_.error_count() == errors_before) return;
    for (std::uint32_t i = 1; i < item.count; ++i) {  // what is wrong is told of each
        NameExpr name = written;
        name.span = material_name(program_.nodes[item.first_node + i].span, sources_);
        material_of_literals(name);
    }
}

void FileChecker::material_of_literals(NameExpr& name) {
    ++program_.nesting;
    if (fits_nesting(name.span)) {
        expression(name);
        value_of(common_schema(CommonProperty::material), name);
    }
    --program_.nesting;
}

void FileChecker::block(BlockExpr& expr, bool is_placed) {
    ++program_.nesting;
    if (fits_nesting(expr.head->span)) head_and_body(expr, is_placed);
    --program_.nesting;
}

void FileChecker::head_and_body(BlockExpr& expr, bool is_placed) {
    Expr& head = *expr.head;
    if (head.kind == ExprKind::name) {
        name(static_cast<NameExpr&>(head), true);
    } else {
        expression(head);
    }
    const BlockSchema* const schema = schema_of(head);
    const NameExpr* const named = name_in(head);
    const bool is_made = named != nullptr &&
                         (named->meaning == Meaning::block || named->meaning == Meaning::component);
    // A placed node value is an instance; everything else with a value in front is a copy.
    const bool is_instance = is_placed && schema != nullptr && schema->is_placeable;
    const BlockUse use = is_made       ? BlockUse::make
                         : is_instance ? BlockUse::instance
                                       : BlockUse::copy;
    expr.has_statements = has_statements(expr.body.items);
    scopes_.open(expr.body.items, *context_);
    declare_functions(expr.body.items);
    // Without a schema it is known when it runs; until then anything may stand there.
    static constexpr BlockSchema kUnknown{BlockKind::group, "block", "", {}, false, true};
    const Place place{Place::Kind::block, schema != nullptr ? schema : &kUnknown, scopes_.depth()};
    items(expr.body.items, place);
    if (schema != nullptr) {
        const bool is_right = check_block(*schema, expr, use, symbols_, sources_, diagnostics_);
        if (is_right) expr.checked_as = schema;
    }
    close_scope();
}

}  // namespace lray::parser
