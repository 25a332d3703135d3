#include "scene/formats/obj_statements.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "base/parse_number.h"
#include "image/srgb.h"
#include "scene/formats/obj_scanner.h"

namespace lray::scene::obj {

namespace {

constexpr std::size_t kMaxCorners = std::size_t{1} << 20;  // of one face

}  // namespace

StatementReader::StatementReader(const char* begin, const char* end, const Counts& total,
                                 Mistakes& mistakes, ChunkBuilder& builder)
    : end_(end), at_(begin), total_(total), mistakes_(mistakes), builder_(builder) {}

bool StatementReader::is_at_end() const {
    return is_line_end(*at_) || *at_ == '#';
}

void StatementReader::read_all() {
    for (;;) {
        while (is_blank(*at_) || *at_ == '\n' || *at_ == '\r') ++at_;
        if (at_ >= end_ || *at_ == '\0') return;
        read_statement();
        if (is_statement_wrong_) {
            if (mistakes_.is_enough()) return;
            is_statement_wrong_ = false;
        }
    }
}

void StatementReader::read_statement() {
    statement_ = at_;
    number_count_ = 0;
    switch (statement_at(at_)) {
        case Statement::position:
            read_position();
            break;
        case Statement::uv:
            read_uv();
            break;
        case Statement::normal:
            read_normal();
            break;
        case Statement::face:
            read_face();
            break;
        case Statement::group:
            builder_.begin(StateKind::group, statement_);
            break;
        case Statement::object:
            builder_.begin(StateKind::object, statement_);
            break;
        case Statement::material:
            builder_.begin(StateKind::material, statement_);
            break;
        case Statement::smoothing:
            builder_.begin(StateKind::smoothing, statement_);
            break;
        case Statement::library:
            builder_.add_library(statement_);
            at_ = find_line_end(at_, end_);
            return;
        case Statement::free_form:
            builder_.skip_free_form(statement_);
            break;
        case Statement::other:
            at_ = find_line_end(at_, end_);
            return;
    }
    // Whatever else it holds.
    if (*at_ != '\n') at_ = find_statement_end(statement_, at_, end_);
}

/// v x y z [w | r g b [a]]
void StatementReader::read_position() {
    at_ += 1;
    const double x = read_number();
    const double y = read_number();
    const double z = read_number();
    // A wrong one counts, so that indices keep their meaning; likewise below.
    builder_.add_position(
        Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
    at_ = skip_blanks(at_);
    if (!is_at_end() && !is_statement_wrong_) read_color();
}

/// A weight, or a colour as sRGB codes from 0 to 1; whatever else there may be is skipped.
void StatementReader::read_color() {
    std::array<double, 3> codes{};
    const char* at = at_;
    for (double& code : codes) {
        const bool is_negative = *at == '-';
        const ParsedNumber number = parse_decimal(is_negative || *at == '+' ? at + 1 : at);
        if (!number.is_found() || !is_token_end(number.end)) return;
        code = is_negative ? 0.0 : std::min(number.value, 1.0);
        at = skip_blanks(number.end);
    }
    const auto linear = [](double code) { return static_cast<float>(image::srgb_decode(code)); };
    builder_.set_color(Color{linear(codes[0]), linear(codes[1]), linear(codes[2])});
}

/// vt u [v [w]]
void StatementReader::read_uv() {
    at_ += 2;
    const double u = read_number();
    at_ = skip_blanks(at_);
    const double v = is_at_end() ? 0.0 : read_number();
    builder_.add_uv(Vec2(static_cast<float>(u), static_cast<float>(v)));
}

/// vn x y z
void StatementReader::read_normal() {
    at_ += 2;
    const double x = read_number();
    const double y = read_number();
    const double z = read_number();
    builder_.add_normal(DVec3(x, y, z));
}

/// f corner corner corner...
void StatementReader::read_face() {
    ++face_count_;
    at_ += 1;
    corners_.clear();
    for (;;) {
        at_ = skip_blanks(at_);
        if (is_at_end()) break;
        if (!read_corner()) {
            is_statement_wrong_ = true;
            return;
        }
    }
    if (corners_.size() < 3) {
        is_statement_wrong_ = true;
        mistakes_.too_few_corners(statement_, at_, corners_.size());
    } else if (!mistakes_.are_told()) {
        builder_.add_face(corners_);
    }
}

/// v   v/vt   v//vn   v/vt/vn
/// An index may be left out after its slash, as some tools do.
bool StatementReader::read_corner() {
    const char* const begin = at_;
    Corner corner;
    corner.position = read_index(kPositionIndex, builder_.position_count(), total_.positions);
    if (corner.position == Mesh::kNone) return false;
    if (*at_ == '/') {
        ++at_;
        if (*at_ != '/' && !is_token_end(at_)) {
            corner.uv = read_index(kUvIndex, builder_.uv_count(), total_.uvs);
            if (corner.uv == Mesh::kNone) return false;
        }
        if (*at_ == '/') {
            ++at_;
            if (!is_token_end(at_)) {
                corner.normal = read_index(kNormalIndex, builder_.normal_count(), total_.normals);
                if (corner.normal == Mesh::kNone) return false;
            }
        }
    }
    if (!is_token_end(at_)) {
        mistakes_.wrong_corner(statement_, begin);
        return false;
    }
    if (corners_.size() == kMaxCorners) {
        mistakes_.too_many_corners(begin, at_, kMaxCorners);
        return false;
    }
    corners_.push_back(corner);
    return true;
}

/// Returns the index from 0; kNone if it is wrong. One that counts backwards is relative to what
/// came `so_far`.
std::uint32_t StatementReader::read_index(IndexKind kind, std::size_t so_far, std::size_t total) {
    const char* const begin = at_;
    const bool is_negative = *at_ == '-';
    if (is_negative) ++at_;
    DigitRun run = read_digit_run(at_);
    at_ += run.count;
    if (run.count == 0) {
        mistakes_.wrong_corner(statement_, begin);
        return Mesh::kNone;
    }
    std::uint64_t value = run.value;
    while (run.count == kMaxDigitRun) {
        run = read_digit_run(at_);
        at_ += run.count;
        // Once above all counts it stays so.
        if (value <= Mesh::kNone) value = value * kRunPowersOfTen[run.count] + run.value;
    }
    if (value == 0 || value > (is_negative ? so_far : total)) {
        mistakes_.wrong_index(begin, at_, kind, so_far, total);
        return Mesh::kNone;
    }
    return static_cast<std::uint32_t>(is_negative ? so_far - value : value - 1);
}

/// Returns the next number of the statement; 0 if it is wrong or one was wrong before.
double StatementReader::read_number() {
    if (is_statement_wrong_) return 0.0;
    const std::optional<double> number = take_number(at_);
    if (!number) {
        is_statement_wrong_ = true;
        mistakes_.wrong_number(statement_, at_, number_count_,
                               statement_[1] == 't' ? "1 to 3" : "3");
        return 0.0;
    }
    ++number_count_;
    return *number;
}

}  // namespace lray::scene::obj
