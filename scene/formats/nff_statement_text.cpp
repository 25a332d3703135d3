#include "scene/formats/nff_statement_text.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/parse_number.h"
#include "scene/formats/token_words.h"

namespace lray::scene::nff {

namespace {

constexpr double kMaxResolution = 1048576.0;  // as `resolution` of a scene

}  // namespace

void StatementText::begin_statement(Statement kind) {
    kind_ = kind;
    is_wrong_ = false;
    statement_ = at_;
    at_ += keyword_of(kind).size();
    token_end_ = at_;
    number_count_ = 0;
    corner_count_ = 0;
}

void StatementText::begin_view_word(ViewWord word) {
    view_word_ = word;
    number_ = at_;
    at_ = token_end_ = skip_token(at_);
    number_count_ = 0;
}

void StatementText::begin_corners(std::size_t count) {
    corner_count_ = count;
    number_count_ = 0;
}

double StatementText::number() {
    if (is_wrong_) return 0.0;
    skip_space();
    number_ = at_;
    const bool is_negative = *at_ == '-';
    const ParsedNumber parsed = parse_decimal(is_negative || *at_ == '+' ? at_ + 1 : at_);
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (!parsed.is_found() || !is_token_end(*parsed.end) || parsed.value > kLargest) {
        wrong_number();
        return 0.0;
    }
    at_ = token_end_ = parsed.end;
    ++number_count_;
    return is_negative ? -parsed.value : parsed.value;
}

DVec3 StatementText::point() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
}

double StatementText::radius() {
    const double value = number();
    if (value >= 0.0 || is_wrong_) return value;
    wrong_value(Code::E0304, number_span(),
                fmt::format("a radius is not negative, this is {}", quoted_token(number_text())),
                fmt::format("a shape that is seen from inside alone is not read; write `{}` to see "
                            "both sides",
                            number_text().substr(1)));
    return value;
}

double StatementText::not_negative(std::string_view name) {
    const double value = number();
    if (value < 0.0 && !is_wrong_) {
        wrong_value(
            Code::E0304, number_span(),
            fmt::format("{} is not negative, this is {}", name, quoted_token(number_text())));
    }
    return value;
}

DVec3 StatementText::color(std::string_view part) {
    const double red = not_negative(part);
    const double green = not_negative(part);
    return {red, green, not_negative(part)};
}

Resolution StatementText::resolution() {
    const auto side = [&] {
        const double value = number();
        const bool is_right = value == std::floor(value) && value >= 1.0 && value <= kMaxResolution;
        if (!is_wrong_ && !is_right) {
            wrong_value(Code::E0304, number_span(),
                        fmt::format("a side of the picture has 1 to {} pixels, this is {}",
                                    kMaxResolution, quoted_token(number_text())));
        }
        return is_wrong_ ? 1u : static_cast<std::uint32_t>(value);
    };
    const std::uint32_t width = side();
    return {width, side()};
}

void StatementText::wrong_number() {
    is_wrong_ = true;
    if (is_at_end_of_statement()) {
        mistakes_.too_few_numbers(statement_span(), needs(), number_count_);
    } else if (*at_ == '\0') {
        mistakes_.binary(at_);
        is_binary_ = true;
    } else {
        mistakes_.wrong_number(at_);
    }
}

void StatementText::wrong_value(Code code, Span span, std::string message, std::string help) {
    is_wrong_ = true;
    mistakes_.value(code, span, std::move(message), std::move(help));
}

std::string StatementText::needs() const {
    switch (kind_) {
        case Statement::view: {
            const int count = view_word_ <= ViewWord::up           ? 3
                              : view_word_ == ViewWord::resolution ? 2
                                                                   : 1;
            return fmt::format("`{}` needs {} number{}",
                               kViewWords[static_cast<std::size_t>(view_word_)], count,
                               count == 1 ? "" : "s");
        }
        case Statement::background:
            return "`b` needs 3 numbers";
        case Statement::light:
            return "`l` needs 3 numbers, or 6 with a colour";
        case Statement::fill:
            return "`f` needs 8 numbers";
        case Statement::sphere:
            return "`s` needs 4 numbers";
        case Statement::cone:
            return "`c` needs 8 numbers";
        case Statement::polygon:
        case Statement::patch: {
            if (corner_count_ == 0) {
                return fmt::format("`{}` needs the count of its corners", keyword_of(kind_));
            }
            return fmt::format("`{} {}` needs {} numbers", keyword_of(kind_), corner_count_,
                               corner_count_ * (kind_ == Statement::patch ? 6 : 3));
        }
        case Statement::none:
            break;
    }
    return {};
}

void StatementText::go_on_at_next_statement() {
    skip_space();
    while (!is_at_end_of_statement() && *at_ != '\0') {
        at_ = nff::skip_space(skip_line(at_));
    }
}

}  // namespace lray::scene::nff
