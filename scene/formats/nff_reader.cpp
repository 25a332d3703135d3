#include "scene/formats/nff_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/did_you_mean.h"
#include "scene/camera_direction.h"
#include "scene/formats/nff_collector.h"
#include "scene/formats/nff_mistakes.h"
#include "scene/formats/nff_scanner.h"
#include "scene/formats/nff_statement_text.h"
#include "scene/formats/token_words.h"

namespace lray::scene {

namespace nff {

namespace {

constexpr std::size_t kMaxCorners = std::size_t{1} << 20;  // of one polygon
constexpr double kMaxAngle = 179.0;                        // as `fov` of a camera

/// Reads the statements of a file, one after the other.
class StatementReader {
 public:
    StatementReader(const Text& text, const NffLimits& limits, Mistakes& mistakes)
        : text_(text, mistakes), mistakes_(mistakes), collector_(limits, mistakes) {}

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
    bool has_fill();

    StatementText text_;
    Mistakes& mistakes_;
    Collector collector_;
    bool is_other_format_ = false;
    bool has_fill_ = false;
    Span background_span_{};

    std::vector<DVec3> corners_{};
    std::vector<DVec3> normals_{};  // of a patch
};

NffScene StatementReader::read_all() {
    if (is_utf16(text_.at())) {
        mistakes_.binary(text_.at());
        return {};
    }
    while (!text_.is_binary() && !is_other_format_ && !collector_.is_full() &&
           !mistakes_.is_enough()) {
        text_.skip_space();
        if (text_.is_at_end()) break;
        if (*text_.at() == '\0') {
            mistakes_.binary(text_.at());
            break;
        }
        statement();
    }
    return std::move(collector_.scene());
}

void StatementReader::statement() {
    const Statement kind = statement_at(text_.at());
    if (kind == Statement::none) {
        not_a_statement();
        text_.refuse_statement();
    } else {
        text_.begin_statement(kind);
        statement_of(kind);
    }
    if (text_.is_wrong()) text_.go_on_at_next_statement();
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
    const bool is_first = text_.kind() == Statement::none && mistakes_.count() == 0;
    if (is_number_begin(*text_.at())) {
        mistakes_.stray_number(text_.at(), text_.needs());
    } else if (is_first && edit_distance(token_at(text_.at()), "nff", 0) == 0) {
        mistakes_.other_format(text_.at());
        is_other_format_ = true;
    } else {
        mistakes_.unknown_word(text_.at(), text_.kind() == Statement::view);
    }
}

/// v   from x y z   at x y z   up x y z   angle a   [hither h]   [yon y]   [resolution w h]
void StatementReader::view() {
    const Span keyword = text_.statement_span();
    NffView view;
    std::array<bool, kViewWords.size()> is_set{};
    for (;;) {
        text_.skip_space();
        const ViewWord word = view_word_at(text_.at());
        if (word == ViewWord::none) break;
        text_.begin_view_word(word);
        if (std::exchange(is_set[static_cast<std::size_t>(word)], true)) {
            text_.wrong_value(Code::E0402, text_.number_span(),
                              fmt::format("`{}` is set twice", text_.number_text()));
            return;
        }
        view_part(word, view);
        if (text_.is_wrong()) return;
    }
    // A word that is misspelt is the one that is missing.
    const bool ends = text_.is_at_end_of_statement() || is_number_begin(*text_.at());
    if (!ends) return;
    view.span = text_.statement_span();
    constexpr std::size_t kRequired = 4;  // the first ones
    for (std::size_t i = 0; i < kRequired; ++i) {
        if (is_set[i]) continue;
        text_.wrong_value(
            Code::E0706, view.span, fmt::format("this view has no `{}`", kViewWords[i]),
            "a view is `v`, then `from`, `at` and `up` with 3 numbers each, and `angle` "
            "with one");
        return;
    }
    if (view.from == view.at) {
        text_.wrong_value(Code::E0311, view.span, "`from` and `at` are the same point");
    } else if (view.up == DVec3{0.0}) {
        text_.wrong_value(Code::E0311, view.span, "`up` is zero, and no direction");
    } else if (is_along_up(view.at - view.from, view.up)) {
        text_.wrong_value(Code::E0311, view.span, "the view goes along its `up` direction",
                          "choose another `up`");
    } else if (collector_.scene().view) {
        mistakes_.second(keyword, "v", "view", collector_.scene().view->span);
    } else {
        collector_.scene().view = view;
    }
}

void StatementReader::view_part(ViewWord word, NffView& view) {
    switch (word) {
        case ViewWord::from:
            view.from = text_.point();
            break;
        case ViewWord::at:
            view.at = text_.point();
            break;
        case ViewWord::up:
            view.up = text_.point();
            break;
        case ViewWord::angle:
            view.angle = text_.number();
            if (!text_.is_wrong() && !(view.angle > 0.0 && view.angle <= kMaxAngle)) {
                text_.wrong_value(
                    Code::E0304, text_.number_span(),
                    fmt::format("`angle` is greater than 0 and at most {} degrees, this is "
                                "{}",
                                kMaxAngle, quoted_token(text_.number_text())));
            }
            break;
        case ViewWord::hither:
        case ViewWord::yon:
            text_.number();
            break;
        case ViewWord::resolution:
            view.resolution = text_.resolution();
            break;
        case ViewWord::none:
            break;
    }
}

/// b red green blue
void StatementReader::background() {
    const DVec3 background = text_.color("a part of the background");
    if (text_.is_wrong()) return;
    if (collector_.scene().background) {
        mistakes_.second(text_.statement_span(), "b", "background", background_span_);
        return;
    }
    collector_.scene().background = background;
    background_span_ = text_.statement_span();
}

/// l x y z [red green blue]
void StatementReader::light() {
    NffLight light;
    light.position = text_.point();
    if (text_.is_wrong()) return;
    text_.skip_space();
    if (is_number_begin(*text_.at())) light.color = text_.color("a part of the light's colour");
    light.span = text_.statement_span();
    if (!text_.is_wrong()) collector_.add(light);
}

/// f red green blue Kd Ks Shine T index
void StatementReader::fill() {
    has_fill_ = true;  // a wrong one is told of once
    NffSurface surface;
    surface.color = text_.color("a part of the colour");
    surface.diffuse = text_.not_negative("Kd");
    surface.specular = text_.not_negative("Ks");
    surface.shine = text_.not_negative("Shine");
    surface.transmit = text_.not_negative("T");
    surface.index = text_.not_negative("the index of refraction");
    if (text_.is_wrong()) return;
    const DVec3 matt = surface.diffuse * surface.color;
    if (!(std::max({matt.x, matt.y, matt.z}) <= std::numeric_limits<float>::max())) {
        text_.wrong_value(Code::E0304, text_.statement_span(),
                          "Kd times the colour is larger than numbers go");
        return;
    }
    collector_.set_fill(surface);
}

/// s x y z radius
void StatementReader::sphere() {
    SphereShape shape;
    shape.center = text_.point();
    shape.radius = text_.radius();
    if (text_.is_wrong()) return;
    if (shape.radius == 0.0) {
        text_.wrong_value(Code::E0304, text_.number_span(),
                          "the radius of a sphere is greater than 0");
    } else if (has_fill()) {
        collector_.add(shape, text_.statement_span());
    }
}

/// c   x y z radius   x y z radius
void StatementReader::cone() {
    CylinderShape shape;
    shape.caps = false;
    shape.from = text_.point();
    shape.radius = text_.radius();
    shape.to = text_.point();
    shape.radius_to = text_.radius();
    if (text_.is_wrong()) return;
    if (shape.from == shape.to) {
        text_.wrong_value(Code::E0304, text_.statement_span(),
                          "both ends of this cone are the same point");
    } else if (shape.radius == 0.0 && shape.radius_to == 0.0) {
        text_.wrong_value(Code::E0304, text_.statement_span(), "both radii of this cone are 0",
                          "one of them may be 0: the tip");
    } else if (has_fill()) {
        collector_.add(shape, text_.statement_span());
    }
}

/// p n   x y z ...
/// pp n   x y z   nx ny nz ...
void StatementReader::polygon() {
    const bool has_normals = text_.kind() == Statement::patch;
    const std::size_t count = corner_count(has_normals ? 6 : 3);
    if (text_.is_wrong()) return;
    text_.begin_corners(count);
    corners_.clear();
    normals_.clear();
    for (std::size_t i = 0; i < count && !text_.is_wrong(); ++i) {
        corners_.push_back(text_.point());
        if (has_normals) normals_.push_back(text_.point());
    }
    if (!text_.is_wrong() && has_fill()) {
        collector_.add_polygon(corners_, normals_, text_.statement_span());
    }
}

std::size_t StatementReader::corner_count(std::size_t numbers_of_corner) {
    const double count = text_.number();
    if (text_.is_wrong()) return 0;
    if (count != std::floor(count) || count < 3.0) {
        text_.wrong_value(Code::E0706, text_.number_span(),
                          fmt::format("a polygon has 3 corners or more, this is {}",
                                      quoted_token(text_.number_text())));
        return 0;
    }
    if (count > static_cast<double>(kMaxCorners)) {
        text_.wrong_value(Code::E0705, text_.number_span(),
                          fmt::format("a polygon can have {} corners, this is {}", kMaxCorners,
                                      quoted_token(text_.number_text())));
        return 0;
    }
    // A number takes a digit and the blank before it.
    const double bytes = 2.0 * count * static_cast<double>(numbers_of_corner);
    if (bytes > static_cast<double>(text_.size_left())) {
        text_.wrong_value(
            Code::E0706, text_.number_span(),
            fmt::format("a polygon of {} corners needs {} numbers; the file ends before", count,
                        count * static_cast<double>(numbers_of_corner)));
        return 0;
    }
    return static_cast<std::size_t>(count);
}

// A shape without a surface is told of once; it gets one, so that the rest of the file is read.
bool StatementReader::has_fill() {
    if (!has_fill_) {
        has_fill_ = true;
        text_.wrong_value(
            Code::E0706, text_.keyword_span(),
            fmt::format("`{}` before the first `f`, which says what shapes are made of",
                        text_.keyword()),
            "write a line like `f 0.8 0.8 0.8 1 0 1 0 1` above it");
    }
    return !text_.is_wrong();
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
