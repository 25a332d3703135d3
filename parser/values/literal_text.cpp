#include "parser/values/literal_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "base/assert.h"
#include "image/srgb.h"
#include "parser/tools/dump_text.h"
#include "parser/values/operators.h"

namespace lray::parser {

namespace {

/// Returns the code of a channel, 0 to 255, that means exactly this; empty if none does.
std::optional<int> code_of(double channel, double (*decode)(double)) {
    // The codes rise with what they mean.
    int below = 0;
    int above = 255;
    while (below < above) {
        const int middle = (below + above) / 2;
        if (decode(middle / 255.0) < channel) {
            below = middle + 1;
        } else {
            above = middle;
        }
    }
    const bool is_exact = decode(below / 255.0) == channel && !std::signbit(channel);
    return is_exact ? std::optional<int>(below) : std::nullopt;
}

std::optional<std::string> color_literal(const double* rgba) {
    std::string hex = "#";
    const bool is_opaque = rgba[3] == 1.0;
    for (int i = 0; i < (is_opaque ? 3 : 4); ++i) {
        const std::optional<int> code = i < 3
                                            ? code_of(rgba[i], image::srgb_decode)
                                            : code_of(rgba[i], [](double alpha) { return alpha; });
        if (!code) {
            if (!is_opaque) return std::nullopt;
            return fmt::format("rgb({}, {}, {})", rgba[0], rgba[1], rgba[2]);
        }
        hex += fmt::format("{:02x}", *code);
    }
    return hex;
}

/// Appends literals to a text that may have `limit` bytes.
class LiteralWriter {
 public:
    LiteralWriter(std::string& text, std::size_t limit) : text_(text), limit_(limit) {}

    /// Returns false for what has no literal, or one that is too long.
    // NOLINTNEXTLINE(misc-no-recursion): kMaxLiteralDepth deep at most
    bool add(const Value& value, std::uint8_t depth) {
        switch (value.kind) {
            case ValueKind::number:
                append_exact(text_, value.number);
                return fits();
            case ValueKind::boolean:
                text_ += value.boolean ? "true" : "false";
                return fits();
            case ValueKind::string:
                if (value.count > limit_) return false;
                text_ += quoted(value.string());
                return fits();
            case ValueKind::color: {
                const std::optional<std::string> color = color_literal(value.numbers);
                text_ += color.value_or("");
                return color && fits();
            }
            case ValueKind::numbers:
            case ValueKind::rows:
            case ValueKind::list:
                return add_list(value, depth);
            case ValueKind::none:
            case ValueKind::poison:
            case ValueKind::transform:
            case ValueKind::texture:
            case ValueKind::material:
            case ValueKind::node:
            case ValueKind::record:
            case ValueKind::function:
                return false;
        }
        LRAY_ASSERT(false);
    }

 private:
    bool fits() const { return text_.size() <= limit_; }

    // NOLINTNEXTLINE(misc-no-recursion): kMaxLiteralDepth deep at most
    bool add_list(const Value& list, std::uint8_t depth) {
        if (depth == kMaxLiteralDepth) return false;
        text_ += '[';
        for (std::uint32_t i = 0; i < list.count; ++i) {
            if (i > 0) text_ += ", ";
            if (!add(element(list, i), static_cast<std::uint8_t>(depth + 1))) return false;
        }
        text_ += ']';
        return fits();
    }

    std::string& text_;
    std::size_t limit_;
};

}  // namespace

std::optional<std::string> literal_text(const Value& value, std::size_t limit) {
    std::string text;
    if (!LiteralWriter(text, limit).add(value, 0)) return std::nullopt;
    return text;
}

}  // namespace lray::parser
