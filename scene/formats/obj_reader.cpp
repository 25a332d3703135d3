#include "scene/formats/obj_reader.h"

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "base/parse_number.h"
#include "scene/formats/obj_counts.h"
#include "scene/formats/obj_mesh_builder.h"
#include "scene/formats/obj_mistakes.h"
#include "scene/formats/obj_scanner.h"

namespace lray::scene {

namespace obj {

namespace {

constexpr std::size_t kMaxCorners = std::size_t{1} << 20;  // of one face

/// Reads the statements of a file into a mesh builder. Forward indices make it impossible to judge
/// an index before the end: the fast run gives up at the first mistake, and a second one, which
/// knows the counts of the whole file, tells them all.
class StatementReader {
 public:
    /// `total`: what indices may count; unlimited if all is not known yet.
    StatementReader(const Text& text, const Counts& total, Mistakes& mistakes, MeshBuilder& builder)
        : end_(text.data() + text.size()),
          at_(text.data()),
          total_(total),
          mistakes_(mistakes),
          builder_(builder) {
        if (text.view().starts_with("\xEF\xBB\xBF")) at_ += 3;
    }

    /// Reads to the end, or until there are enough mistakes.
    void read_all();

    /// True if reading stopped at a NUL in the text.
    bool has_nul() const { return *at_ == '\0' && at_ != end_; }

    std::size_t face_count() const { return face_count_; }

 private:
    void read_statement();
    void read_position();
    void read_uv();
    void read_normal();
    void read_face();
    bool read_corner();
    std::string read_part_name();

    double read_number();
    std::uint32_t read_index(IndexKind kind, std::size_t so_far, std::size_t total);
    bool is_at_end() const { return is_line_end(*at_) || *at_ == '#'; }

    const char* const end_;
    const char* at_;
    const char* statement_ = nullptr;  // the begin of the one being read
    bool is_statement_wrong_ = false;  // one mistake is told of each
    std::size_t number_count_ = 0;     // read in this statement
    std::size_t face_count_ = 0;
    std::vector<Corner> corners_{};

    const Counts total_;
    Mistakes& mistakes_;
    MeshBuilder& builder_;
};

void StatementReader::read_all() {
    for (;;) {
        while (is_blank(*at_) || *at_ == '\n' || *at_ == '\r') ++at_;
        if (*at_ == '\0') return;
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
            builder_.begin_group(read_part_name());
            break;
        case Statement::object:
            builder_.begin_object(read_part_name());
            break;
        case Statement::other:
            at_ = find_line_end(at_, end_);
            return;
    }
    // Whatever else it holds.
    if (*at_ != '\n') at_ = find_statement_end(statement_, at_, end_);
}

/// v x y z [w | r g b]
void StatementReader::read_position() {
    at_ += 1;
    const double x = read_number();
    const double y = read_number();
    const double z = read_number();
    // A wrong one counts, so that indices keep their meaning; likewise below.
    builder_.add_position(
        Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
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
    at_ = skip_blanks(at_);
    const char* const begin = at_;
    const bool is_negative = *at_ == '-';
    if (*at_ == '-' || *at_ == '+') ++at_;
    const ParsedNumber number = parse_decimal(at_);
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (!number.is_found() || !is_token_end(number.end) || number.value > kLargest) {
        is_statement_wrong_ = true;
        mistakes_.wrong_number(statement_, begin, number_count_);
        return 0.0;
    }
    at_ = number.end;
    ++number_count_;
    return is_negative ? -number.value : number.value;
}

/// g name...   o name...
/// Names are joined by one blank. A `#` is part of a name: tools write such.
std::string StatementReader::read_part_name() {
    std::string name;
    for (at_ = skip_blanks(at_ + 1); !is_line_end(*at_); at_ = skip_blanks(at_)) {
        const char* const begin = at_;
        at_ = skip_token(at_);
        if (!name.empty()) name += ' ';
        name.append(begin, at_);
    }
    return name.empty() ? "default" : name;  // as the format calls the group of a `g` alone
}

std::optional<Mesh> read_fast(const Text& text) {
    constexpr std::size_t kAny = Mesh::kNone;
    Mistakes mistakes(text);
    MeshBuilder builder;
    builder.reserve(estimate_counts(text));
    StatementReader reader(text, {kAny, kAny, kAny, kAny, kAny}, mistakes, builder);
    reader.read_all();
    if (mistakes.count() > 0 || reader.has_nul()) return {};
    return builder.finish();
}

void tell_mistakes(const Text& text, Mistakes& mistakes) {
    if (mistakes.find_binary()) return;
    MeshBuilder builder;
    StatementReader reader(text, count_statements(text), mistakes, builder);
    reader.read_all();
    if (reader.face_count() == 0 && mistakes.count() == 0) mistakes.no_faces();
    LRAY_ASSERT(mistakes.count() > 0);
}

}  // namespace

}  // namespace obj

std::optional<Mesh> read_obj(const Sources& sources, SourceId file, Span loaded_at,
                             Diagnostics& diagnostics) {
    const Text& text = sources[file].text;
    // Places in the text have 32 bits, so every count of its mesh has: a corner takes two bytes.
    if (std::optional<Mesh> mesh = obj::read_fast(text)) return mesh;
    obj::Mistakes mistakes(text, file, loaded_at, diagnostics);
    obj::tell_mistakes(text, mistakes);
    return {};
}

}  // namespace lray::scene
