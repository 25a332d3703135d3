#include "parser/blocks/read_animation.h"

#include <fmt/format.h>

#include "parser/blocks/property_type.h"
#include "parser/blocks/schemas.h"

namespace lray::parser {

namespace {

using namespace schemas;

class AnimationReader {
 public:
    AnimationReader(const Symbols& symbols, Diagnostics& diagnostics)
        : symbols_(symbols), diagnostics_(diagnostics) {}

    // Recurses as deep as files include one another.
    void items(std::span<Item* const> list) {
        for (const Item* item : list) {
            if (item->kind == ItemKind::include) {
                items(static_cast<const IncludeItem&>(*item).items);
            } else if (item->kind == ItemKind::block) {
                block(*static_cast<const BlockItem&>(*item).block);
            }
        }
    }

    const std::optional<scene::Animation>& animation() const { return animation_; }

 private:
    void block(const BlockExpr& block) {
        if (block.head->kind != ExprKind::name) return;
        const BlockSchema* schema = find_block(static_cast<const NameExpr&>(*block.head).symbol);
        if (schema == nullptr || schema->kind != BlockKind::animation) return;
        if (animation_) {
            diagnostics_.error(Code::E0405, block.head->span, "a second `animation` block")
                .with_label(first_, "the first one is here");
            return;
        }
        first_ = block.head->span;
        PropertyValues values(kAnimation);
        for (const Item* item : block.body.items) {
            if (item->kind == ItemKind::property) {
                property(static_cast<const PropertyItem&>(*item), values);
            } else {
                not_plain(item->span);
            }
        }
        animation_ = {values.integer(slot(kAnimation, "frames")),
                      values.number(slot(kAnimation, "fps")),
                      values.number(slot(kAnimation, "start"))};
    }

    void property(const PropertyItem& item, PropertyValues& values) {
        const std::size_t found = find_property(kAnimation, symbols_.text(item.name));
        if (found == kAnimation.size()) return;
        const std::optional<Value> value = plain_value(*item.value);
        if (!value) {
            not_plain(item.value->span);
            return;
        }
        Diagnostics again;  // check() has fitted plain values, and reported those that do not fit
        const Value fitted = fit(kAnimation[found], *value, item.value->span, again);
        if (!fitted.is(ValueKind::poison)) values.set(found, fitted);
    }

    /// A number, or one with a sign; empty for everything else.
    static std::optional<Value> plain_value(const Expr& expr) {
        if (expr.kind == ExprKind::number) {
            return Value::of(static_cast<const NumberExpr&>(expr).value);
        }
        if (expr.kind != ExprKind::unary) return std::nullopt;
        const UnaryExpr& sign = static_cast<const UnaryExpr&>(expr);
        if (sign.op == TokenKind::kw_not || sign.operand->kind != ExprKind::number) {
            return std::nullopt;
        }
        const double number = static_cast<const NumberExpr&>(*sign.operand).value;
        return Value::of(sign.op == TokenKind::minus ? -number : number);
    }

    void not_plain(Span span) {
        diagnostics_.error(Code::E0301, span, "an animation holds plain numbers, like `frames: 48`")
            .with_help("it is read before anything is computed, as `time` depends on it");
    }

    const Symbols& symbols_;
    Diagnostics& diagnostics_;
    std::optional<scene::Animation> animation_;
    Span first_{};
};

}  // namespace

std::optional<scene::Animation> read_animation(std::span<Item* const> top_level_items,
                                               const Symbols& symbols, Diagnostics& diagnostics) {
    AnimationReader reader(symbols, diagnostics);
    reader.items(top_level_items);
    return reader.animation();
}

}  // namespace lray::parser
