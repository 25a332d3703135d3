#include "parser/builtins/format_text.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "parser/builtins/results.h"

namespace lray::parser {

namespace {

/// A place for a value: `{}` or `{:.2}`.
struct Place {
    std::size_t size = 0;  // bytes, braces included; 0: not a place
    std::optional<unsigned> decimals{};
};

Place place_at(std::string_view text) {
    if (text.starts_with("{}")) return {2, std::nullopt};
    if (!text.starts_with("{:.")) return {};
    unsigned decimals = 0;
    std::size_t at = 3;
    while (at < text.size() && text[at] >= '0' && text[at] <= '9' && decimals <= kMaxDecimals) {
        decimals = 10 * decimals + static_cast<unsigned>(text[at++] - '0');
    }
    const bool is_place = at > 3 && at < text.size() && text[at] == '}' && decimals <= kMaxDecimals;
    return is_place ? Place{at + 1, decimals} : Place{};
}

class FormatParser {
 public:
    explicit FormatParser(Call& call) : call_(call), text_(call[0].string()) {}

    std::optional<FormatText> parse() {
        if (!take_text_steps(call_.budget, text_.size(), call_.span, call_.diagnostics)) {
            return std::nullopt;
        }
        while (!text_.empty()) {
            const std::size_t plain = std::min(text_.find_first_of("{}"), text_.size());
            if (plain > 0 && !add_text(plain, plain)) return std::nullopt;
            if (text_.empty()) break;
            const bool is_brace = text_.starts_with("{{") || text_.starts_with("}}");
            if (!(is_brace ? add_text(1, 2) : add_place())) return std::nullopt;
        }
        if (used_ == call_.rest.size()) return std::move(format_);
        call_.diagnostics.error(Code::E0306, call_.rest_spans[used_],
                                fmt::format("this text has {} place{} `{{}}`, but {} values follow",
                                            used_, used_ == 1 ? "" : "s", call_.rest.size()));
        return std::nullopt;
    }

 private:
    bool add(const Value& piece) {
        constexpr std::uint64_t kSize = sizeof(Value);
        if (!take_bytes(call_.budget, kSize, call_.span, call_.diagnostics)) return false;
        if (!take_steps(call_, 1)) return false;
        format_.pieces.push_back(piece);
        return true;
    }

    bool add_text(std::size_t size, std::size_t consumed) {
        const std::string_view piece = text_.substr(0, size);
        text_.remove_prefix(consumed);
        return add(Value::of_string(piece, call_[0].source));
    }

    bool add_place() {
        const Place place = place_at(text_);
        if (place.size == 0) {
            call_.diagnostics
                .error(Code::E0312, call_.spans[0],
                       fmt::format("`{}` in this text is no place for a value", beginning()))
                .with_help("write `{}` or `{:.2}` for a value, `{{` and `}}` for braces");
            return false;
        }
        text_.remove_prefix(place.size);
        if (used_ == call_.rest.size()) {
            call_.diagnostics.error(
                Code::E0305, call_.span,
                fmt::format("this text has more places `{{}}` than the {} value{} that follow{}",
                            used_, used_ == 1 ? "" : "s", used_ == 1 ? "s" : ""));
            return false;
        }
        const Value& value = call_.rest[used_];
        const Span span = call_.rest_spans[used_];
        ++used_;
        if (!place.decimals) return add(value);
        if (!value.is(ValueKind::number)) {
            call_.diagnostics.error(Code::E0301, span,
                                    fmt::format("`{{:.{}}}` is for a number, this is {}",
                                                *place.decimals, describe(value)));
            return false;
        }
        const std::string digits = fmt::format("{:.{}f}", value.number, *place.decimals);
        if (!take_bytes(call_.budget, digits.size(), call_.span, call_.diagnostics)) return false;
        return add(Value::of_string(call_.arena.copy(std::string_view(digits)), call_[0].source));
    }

    /// What a message shows of the wrong place: to its `}`, or a few characters.
    std::string_view beginning() const {
        constexpr std::size_t kMost = 12;
        std::size_t end = 1;
        while (end < text_.size() && end < kMost && text_[end] != '}' && text_[end] != '{') ++end;
        if (end < text_.size() && text_[end] == '}' && text_[0] == '{') ++end;
        while (end < text_.size() && (text_[end] & 0xc0) == 0x80) ++end;  // UTF-8
        return text_.substr(0, end);
    }

    Call& call_;
    std::string_view text_;
    std::size_t used_ = 0;  // of the values
    FormatText format_;
};

}  // namespace

std::optional<FormatText> parse_format(Call& call) {
    return FormatParser(call).parse();
}

}  // namespace lray::parser
