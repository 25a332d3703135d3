#include "scene/formats/nff_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/did_you_mean.h"
#include "base/parse_number.h"
#include "scene/camera_direction.h"
#include "scene/formats/nff_collector.h"
#include "scene/formats/nff_mistakes.h"
#include "scene/formats/nff_scanner.h"
#include "scene/formats/token_words.h"

namespace lray::scene {

namespace nff {

namespace {

constexpr std::size_t kMaxCorners = std::size_t{1} << 20;  // of one polygon
constexpr double kMaxAngle = 179.0;                        // as `fov` of a camera
constexpr double kMaxResolution = 1048576.0;               // likewise

/// Reads the statements of a file, one after the other. One mistake is told of each.
class StatementReader {
 public:
    StatementReader(const Text& text, const NffLimits& limits, Mistakes& mistakes)
        : end_(text.data() + text.size()),
          at_(text.data()),
          mistakes_(mistakes),
          collector_(limits, mistakes) {
        if (text.view().starts_with("\xEF\xBB\xBF")) at_ += 3;
    }

    NffScene read_all();

 private:
    void statement();
    void statement_of(Statement kind);
    void not_a_statement();
    void view();
    void view_part(ViewWord word, NffView& view);
    void background();
    void light();
    void fill();
    void sphere();
    void cone();
    void polygon();
    std::size_t corner_count(std::size_t numbers_of_corner);

    double number();
    DVec3 point();
    double radius();
    double not_negative(std::string_view name);
    DVec3 color(std::string_view part);
    Resolution resolution();

    bool has_fill();
    void wrong_number();
    void wrong_value(Code code, Span span, std::string message, std::string help = {});
    std::string needs() const;
    void go_on_at_next_statement();
    bool is_at_end_of_statement() const {
        return at_ == end_ || statement_at(at_) != Statement::none;
    }
    Span statement_span() const { return mistakes_.span(statement_, token_end_); }
    Span number_span() const { return mistakes_.span(number_, token_end_); }
    std::string_view number_text() const {
        return {number_, static_cast<std::size_t>(token_end_ - number_)};
    }

    const char* const end_;
    const char* at_;
    Mistakes& mistakes_;
    Collector collector_;

    Statement kind_ = Statement::none;  // of the statement being read, or the last one
    const char* statement_ = nullptr;   // its begin
    const char* number_ = nullptr;      // the begin of the last number
    const char* token_end_ = nullptr;   // the end of the last token
    std::size_t number_count_ = 0;      // read in this statement
    std::size_t corner_count_ = 0;      // that this polygon is to have
    ViewWord view_word_ = ViewWord::from;
    bool is_wrong_ = false;  // this statement: what is read of it is not used
    bool is_done_ = false;   // nothing more is read
    bool has_fill_ = false;
    Span background_span_{};

    std::vector<DVec3> corners_{};
    std::vector<DVec3> normals_{};  // of a patch
};

NffScene StatementReader::read_all() {
    if (is_utf16(at_)) {
        mistakes_.binary(at_);
        return {};
    }
    while (!is_done_ && !collector_.is_full() && !mistakes_.is_enough()) {
        at_ = skip_space(at_);
        if (at_ == end_) break;
        if (*at_ == '\0') {
            mistakes_.binary(at_);
            break;
        }
        statement();
    }
    return std::move(collector_.scene());
}

void StatementReader::statement() {
    const Statement kind = statement_at(at_);
    is_wrong_ = kind == Statement::none;
    if (is_wrong_) {
        not_a_statement();
    } else {
        kind_ = kind;
        statement_ = at_;
        at_ += keyword_of(kind).size();
        token_end_ = at_;
        number_count_ = 0;
        corner_count_ = 0;
        statement_of(kind);
    }
    if (is_wrong_) go_on_at_next_statement();
}

void StatementReader::statement_of(Statement kind) {
    switch (kind) {
        case Statement::view:
            return view();
        case Statement::background:
            return background();
        case Statement::light:
            return light();
        case Statement::fill:
            return fill();
        case Statement::sphere:
            return sphere();
        case Statement::cone:
            return cone();
        case Statement::polygon:
        case Statement::patch:
            return polygon();
        case Statement::none:
            return;
    }
}

void StatementReader::not_a_statement() {
    const bool is_first = kind_ == Statement::none && mistakes_.count() == 0;
    if (is_number_begin(*at_)) {
        mistakes_.stray_number(at_, needs());
    } else if (is_first && edit_distance(token_at(at_), "nff", 0) == 0) {
        mistakes_.other_format(at_);
        is_done_ = true;
    } else {
        mistakes_.unknown_word(at_, kind_ == Statement::view);
    }
}

/// v   from x y z   at x y z   up x y z   angle a   [hither h]   [yon y]   [resolution w h]
void StatementReader::view() {
    const Span keyword = statement_span();
    NffView view;
    std::array<bool, kViewWords.size()> is_set{};
    for (;;) {
        at_ = skip_space(at_);
        const ViewWord word = view_word_at(at_);
        if (word == ViewWord::none) break;
        view_word_ = word;
        number_ = at_;
        at_ = token_end_ = skip_token(at_);
        if (std::exchange(is_set[static_cast<std::size_t>(word)], true)) {
            wrong_value(Code::E0402, number_span(),
                        fmt::format("`{}` is set twice", number_text()));
            return;
        }
        view_part(word, view);
        if (is_wrong_) return;
    }
    // A word that is misspelt is the one that is missing.
    const bool ends = is_at_end_of_statement() || is_number_begin(*at_);
    if (!ends) return;
    view.span = statement_span();
    constexpr std::size_t kRequired = 4;  // the first ones
    for (std::size_t i = 0; i < kRequired; ++i) {
        if (is_set[i]) continue;
        wrong_value(Code::E0706, view.span, fmt::format("this view has no `{}`", kViewWords[i]),
                    "a view is `v`, then `from`, `at` and `up` with 3 numbers each, and `angle` "
                    "with one");
        return;
    }
    if (view.from == view.at) {
        wrong_value(Code::E0311, view.span, "`from` and `at` are the same point");
    } else if (view.up == DVec3{0.0}) {
        wrong_value(Code::E0311, view.span, "`up` is zero, and no direction");
    } else if (is_along_up(view.at - view.from, view.up)) {
        wrong_value(Code::E0311, view.span, "the view goes along its `up` direction",
                    "choose another `up`");
    } else if (collector_.scene().view) {
        mistakes_.second(keyword, "v", "view", collector_.scene().view->span);
    } else {
        collector_.scene().view = view;
    }
}

void StatementReader::view_part(ViewWord word, NffView& view) {
    number_count_ = 0;
    switch (word) {
        case ViewWord::from:
            view.from = point();
            break;
        case ViewWord::at:
            view.at = point();
            break;
        case ViewWord::up:
            view.up = point();
            break;
        case ViewWord::angle:
            view.angle = number();
            if (!is_wrong_ && !(view.angle > 0.0 && view.angle <= kMaxAngle)) {
                wrong_value(Code::E0304, number_span(),
                            fmt::format("`angle` is greater than 0 and at most {} degrees, this is "
                                        "{}",
                                        kMaxAngle, quoted_token(number_text())));
            }
            break;
        case ViewWord::hither:
        case ViewWord::yon:
            number();
            break;
        case ViewWord::resolution:
            view.resolution = resolution();
            break;
        case ViewWord::none:
            break;
    }
}

/// b red green blue
void StatementReader::background() {
    const DVec3 background = color("a part of the background");
    if (is_wrong_) return;
    if (collector_.scene().background) {
        mistakes_.second(statement_span(), "b", "background", background_span_);
        return;
    }
    collector_.scene().background = background;
    background_span_ = statement_span();
}

/// l x y z [red green blue]
void StatementReader::light() {
    NffLight light;
    light.position = point();
    if (is_wrong_) return;
    at_ = skip_space(at_);
    if (is_number_begin(*at_)) light.color = color("a part of the light's colour");
    light.span = statement_span();
    if (!is_wrong_) collector_.add(light);
}

/// f red green blue Kd Ks Shine T index
void StatementReader::fill() {
    has_fill_ = true;  // a wrong one is told of once
    NffSurface surface;
    surface.color = color("a part of the colour");
    surface.diffuse = not_negative("Kd");
    surface.specular = not_negative("Ks");
    surface.shine = not_negative("Shine");
    surface.transmit = not_negative("T");
    surface.index = not_negative("the index of refraction");
    if (is_wrong_) return;
    const DVec3 matt = surface.diffuse * surface.color;
    if (!(std::max({matt.x, matt.y, matt.z}) <= std::numeric_limits<float>::max())) {
        wrong_value(Code::E0304, statement_span(), "Kd times the colour is larger than numbers go");
        return;
    }
    collector_.set_fill(surface);
}

/// s x y z radius
void StatementReader::sphere() {
    SphereShape shape;
    shape.center = point();
    shape.radius = radius();
    if (is_wrong_) return;
    if (shape.radius == 0.0) {
        wrong_value(Code::E0304, number_span(), "the radius of a sphere is greater than 0");
    } else if (has_fill()) {
        collector_.add(shape, statement_span());
    }
}

/// c   x y z radius   x y z radius
void StatementReader::cone() {
    CylinderShape shape;
    shape.caps = false;
    shape.from = point();
    shape.radius = radius();
    shape.to = point();
    shape.radius_to = radius();
    if (is_wrong_) return;
    if (shape.from == shape.to) {
        wrong_value(Code::E0304, statement_span(), "both ends of this cone are the same point");
    } else if (shape.radius == 0.0 && shape.radius_to == 0.0) {
        wrong_value(Code::E0304, statement_span(), "both radii of this cone are 0",
                    "one of them may be 0: the tip");
    } else if (has_fill()) {
        collector_.add(shape, statement_span());
    }
}

/// p n   x y z ...
/// pp n   x y z   nx ny nz ...
void StatementReader::polygon() {
    const bool has_normals = kind_ == Statement::patch;
    const std::size_t count = corner_count(has_normals ? 6 : 3);
    if (is_wrong_) return;
    corner_count_ = count;
    number_count_ = 0;
    corners_.clear();
    normals_.clear();
    for (std::size_t i = 0; i < count && !is_wrong_; ++i) {
        corners_.push_back(point());
        if (has_normals) normals_.push_back(point());
    }
    if (!is_wrong_ && has_fill()) collector_.add_polygon(corners_, normals_, statement_span());
}

std::size_t StatementReader::corner_count(std::size_t numbers_of_corner) {
    const double count = number();
    if (is_wrong_) return 0;
    if (count != std::floor(count) || count < 3.0) {
        wrong_value(Code::E0706, number_span(),
                    fmt::format("a polygon has 3 corners or more, this is {}",
                                quoted_token(number_text())));
        return 0;
    }
    if (count > static_cast<double>(kMaxCorners)) {
        wrong_value(Code::E0705, number_span(),
                    fmt::format("a polygon can have {} corners, this is {}", kMaxCorners,
                                quoted_token(number_text())));
        return 0;
    }
    // A number takes a digit and the blank before it.
    const double bytes = 2.0 * count * static_cast<double>(numbers_of_corner);
    if (bytes > static_cast<double>(end_ - at_)) {
        wrong_value(Code::E0706, number_span(),
                    fmt::format("a polygon of {} corners needs {} numbers; the file ends before",
                                count, count * static_cast<double>(numbers_of_corner)));
        return 0;
    }
    return static_cast<std::size_t>(count);
}

double StatementReader::number() {
    if (is_wrong_) return 0.0;
    at_ = skip_space(at_);
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

DVec3 StatementReader::point() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
}

double StatementReader::radius() {
    const double value = number();
    if (value >= 0.0 || is_wrong_) return value;
    wrong_value(Code::E0304, number_span(),
                fmt::format("a radius is not negative, this is {}", quoted_token(number_text())),
                fmt::format("a shape that is seen from inside alone is not read; write `{}` to see "
                            "both sides",
                            number_text().substr(1)));
    return value;
}

double StatementReader::not_negative(std::string_view name) {
    const double value = number();
    if (value < 0.0 && !is_wrong_) {
        wrong_value(
            Code::E0304, number_span(),
            fmt::format("{} is not negative, this is {}", name, quoted_token(number_text())));
    }
    return value;
}

DVec3 StatementReader::color(std::string_view part) {
    const double red = not_negative(part);
    const double green = not_negative(part);
    return {red, green, not_negative(part)};
}

Resolution StatementReader::resolution() {
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

// A shape without a surface is told of once; it gets one, so that the rest of the file is read.
bool StatementReader::has_fill() {
    if (!has_fill_) {
        has_fill_ = true;
        wrong_value(Code::E0706, mistakes_.span(statement_, skip_token(statement_)),
                    fmt::format("`{}` before the first `f`, which says what shapes are made of",
                                token_at(statement_)),
                    "write a line like `f 0.8 0.8 0.8 1 0 1 0 1` above it");
    }
    return !is_wrong_;
}

void StatementReader::wrong_number() {
    is_wrong_ = true;
    if (is_at_end_of_statement()) {
        mistakes_.too_few_numbers(statement_span(), needs(), number_count_);
    } else if (*at_ == '\0') {
        mistakes_.binary(at_);
        is_done_ = true;
    } else {
        mistakes_.wrong_number(at_);
    }
}

void StatementReader::wrong_value(Code code, Span span, std::string message, std::string help) {
    is_wrong_ = true;
    mistakes_.value(code, span, std::move(message), std::move(help));
}

// How many numbers the statement at hand has; empty if there is none.
std::string StatementReader::needs() const {
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

/// The next one that begins a line, unless one begins here.
void StatementReader::go_on_at_next_statement() {
    at_ = skip_space(at_);
    while (!is_at_end_of_statement() && *at_ != '\0') at_ = skip_space(skip_line(at_));
}

}  // namespace

}  // namespace nff

std::optional<NffScene> read_nff(const Sources& sources, SourceId file, const NffLimits& limits,
                                 Diagnostics& diagnostics) {
    const Text& text = sources[file].text;
    nff::Mistakes mistakes(text, file, diagnostics);
    NffScene scene = nff::StatementReader(text, limits, mistakes).read_all();
    if (mistakes.count() > 0) return std::nullopt;
    return scene;
}

}  // namespace lray::scene
