#include "scene/formats/mtl_reader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/did_you_mean.h"
#include "base/parse_number.h"
#include "scene/formats/obj_mistakes.h"
#include "scene/formats/obj_names.h"
#include "scene/formats/obj_scanner.h"
#include "scene/formats/token_words.h"

namespace lray::scene {

namespace {

using namespace obj;

std::string_view between(const char* begin, const char* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

/// In any letter case: tools differ.
bool is_same_word(std::string_view a, std::string_view b) {
    return a.size() == b.size() && edit_distance(a, b, 0) == 0;
}

/// An option of a map, and how many words follow it.
struct MapOption {
    std::string_view name{};
    std::size_t word_count = 1;
};
constexpr std::array<MapOption, 8> kSkippedOptions = {{{"-blendu"},
                                                       {"-blendv"},
                                                       {"-boost"},
                                                       {"-cc"},
                                                       {"-imfchan"},
                                                       {"-mm", 2},
                                                       {"-texres"},
                                                       {"-type"}}};

/// Ambient light is that of the render block, and takes the diffuse colour.
constexpr std::array<std::string_view, 5> kSilentKeywords = {"Ka", "map_Ka", "map_aat", "sharpness",
                                                             "Km"};

class MtlReader {
 public:
    MtlReader(const Text& text, const std::unordered_set<std::string>& wanted, Mistakes& mistakes)
        : end_(text.data() + text.size()), at_(text.data()), wanted_(wanted), mistakes_(mistakes) {
        if (text.view().starts_with("\xEF\xBB\xBF")) at_ += 3;
    }

    std::vector<MtlMaterial> read_all(const Text& text, SourceId file);

    /// The keywords of statements that are not read, the first few, and where the first one is.
    const std::vector<std::string_view>& skipped() const { return skipped_; }

 private:
    static constexpr std::size_t kMaxSkipped = 6;

    void read_statement();
    void begin_material();
    void read_color(std::optional<Color>& color);
    void read_number_of(std::optional<float>& number, double least, double most);
    void read_map(std::optional<MtlMap>& map);
    bool read_option(MtlMap& map);
    void read_pair(DVec2& pair);
    void skip(std::string_view keyword);
    std::optional<double> read_number(std::string_view needed);
    bool is_number_here() const;
    bool is_at_end() const { return is_line_end(*at_) || *at_ == '#'; }
    Span span_of(const char* begin, const char* end) const {
        return Span::make(file_, static_cast<std::size_t>(begin - begin_),
                          static_cast<std::size_t>(end - begin_));
    }

    const char* begin_ = nullptr;
    const char* const end_;
    const char* at_;
    SourceId file_ = kNoSource;
    const char* statement_ = nullptr;
    std::size_t number_count_ = 0;
    const std::unordered_set<std::string>& wanted_;
    Mistakes& mistakes_;
    std::vector<MtlMaterial> materials_{};
    std::unordered_set<std::string> known_{};
    std::vector<std::string_view> skipped_{};
    MtlMaterial unwanted_{};           // what is read but not kept
    MtlMaterial* material_ = nullptr;  // null: before the first
};

std::vector<MtlMaterial> MtlReader::read_all(const Text& text, SourceId file) {
    begin_ = text.data();
    file_ = file;
    for (;;) {
        while (is_blank(*at_) || *at_ == '\n' || *at_ == '\r') ++at_;
        if (at_ >= end_ || mistakes_.is_enough()) return std::move(materials_);
        statement_ = at_;
        number_count_ = 0;
        read_statement();
        at_ = find_statement_end(statement_, at_, end_);
    }
}

void MtlReader::read_statement() {
    if (*at_ == '#') {
        at_ = find_line_end(at_, end_);
        statement_ = at_;
        return;
    }
    const std::string_view keyword = between(at_, skip_token(at_));
    const auto is = [&](std::string_view word) { return is_same_word(keyword, word); };
    at_ += keyword.size();
    if (is("newmtl")) return begin_material();
    if (material_ == nullptr) {
        mistakes_.wrong(statement_, at_,
                        fmt::format("{} comes before the first `newmtl`", quoted_token(keyword)));
        return;
    }
    MtlMaterial& material = *material_;
    constexpr double kMost = std::numeric_limits<float>::max();
    if (is("Kd")) return read_color(material.diffuse);
    if (is("Ks")) return read_color(material.specular);
    if (is("Ke")) return read_color(material.emission);
    if (is("Tf")) return read_color(material.filter);
    if (is("Ns")) return read_number_of(material.exponent, 0.0, kMost);
    if (is("Ni")) return read_number_of(material.ior, 0.0, kMost);
    if (is("d")) return read_number_of(material.dissolve, 0.0, 1.0);
    if (is("Tr")) return read_number_of(material.transparency, 0.0, 1.0);
    if (is("illum")) {
        std::optional<float> model;
        read_number_of(model, 0.0, 10.0);
        if (model) material.model = static_cast<std::uint32_t>(*model);
        return;
    }
    if (is("map_Kd")) return read_map(material.diffuse_map);
    if (is("map_Ks")) return read_map(material.specular_map);
    if (is("map_Ke")) return read_map(material.emission_map);
    if (is("map_d")) return read_map(material.opacity_map);
    if (is("map_bump") || is("bump")) return read_map(material.bump_map);
    if (is("norm")) return read_map(material.normal_map);
    const bool is_silent = std::any_of(kSilentKeywords.begin(), kSilentKeywords.end(), is);
    if (!is_silent) skip(keyword);
}

/// newmtl name...
void MtlReader::begin_material() {
    std::string name = name_at(statement_);
    at_ = skip_blanks(at_);
    if (name.empty()) {
        mistakes_.wrong(statement_, statement_ + std::string_view("newmtl").size(),
                        "`newmtl` needs a name");
    }
    unwanted_ = {};
    material_ = &unwanted_;
    if (!wanted_.contains(name) || !known_.insert(name).second) return;
    materials_.push_back({});
    material_ = &materials_.back();
    material_->name = std::move(name);
}

/// Kd r [g b]   Kd xyz x y z   Kd spectral file [factor]
void MtlReader::read_color(std::optional<Color>& color) {
    const std::string_view keyword = between(statement_, at_);
    at_ = skip_blanks(at_);
    const std::string_view word = between(at_, skip_token(at_));
    if (word == "xyz" || word == "spectral") return skip(keyword);
    std::array<double, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const char* const begin = skip_blanks(at_);
        if (i == 1 && (is_line_end(*begin) || *begin == '#')) {
            rgb = {rgb[0], rgb[0], rgb[0]};
            break;
        }
        const auto number = read_number("1 or 3");
        if (!number) return;
        if (*number < 0.0) {
            mistakes_.wrong(
                begin, at_,
                fmt::format("`{}` must be 0 or more, this is {}", keyword, between(begin, at_)));
            return;
        }
        rgb[i] = *number;
    }
    color = Color{DVec3{rgb[0], rgb[1], rgb[2]}};
}

/// Ns n   d [-halo] n
/// Numbers that are out of range become the nearest that is not: tools write such.
void MtlReader::read_number_of(std::optional<float>& number, double least, double most) {
    at_ = skip_blanks(at_);
    if (between(at_, skip_token(at_)) == "-halo") at_ = skip_token(at_);
    if (const auto value = read_number("1")) {
        number = static_cast<float>(std::clamp(*value, least, most));
    }
}

/// map_Kd [option...] file
void MtlReader::read_map(std::optional<MtlMap>& map) {
    MtlMap read;
    const std::size_t mistake_count = mistakes_.count();
    while (at_ = skip_blanks(at_), *at_ == '-' && read_option(read)) {
        if (mistakes_.count() > mistake_count) return;
    }
    const char* const begin = at_;
    while (!is_line_end(*at_) && !is_continuation(at_)) ++at_;
    const char* end = at_;
    while (end > begin && is_blank(end[-1])) --end;
    if (begin == end) {
        const char* const keyword_end = skip_token(statement_);
        mistakes_.wrong(
            statement_, keyword_end,
            fmt::format("`{}` needs the name of a picture", between(statement_, keyword_end)));
        return;
    }
    read.file = between(begin, end);
    read.span = span_of(begin, end);
    map = std::move(read);
}

/// False: what is here is no option but a name.
bool MtlReader::read_option(MtlMap& map) {
    const char* const begin = at_;
    const std::string_view option = between(begin, skip_token(begin));
    DVec2 ignored{0.0};
    at_ = skip_blanks(begin + option.size());
    if (option == "-clamp") {
        map.is_clamped = between(at_, skip_token(at_)) == "on";
        at_ = skip_token(at_);
        return true;
    }
    if (option == "-o" || option == "-t") {
        read_pair(option == "-o" ? map.offset : ignored);
        return true;
    }
    if (option == "-s") {
        read_pair(map.scale);
        // A picture cannot be looked up where a scale has no inverse in range.
        constexpr double kLeast = 1e-9;
        constexpr double kMost = 1e9;
        for (const double scale : {map.scale.x, map.scale.y}) {
            const double size = scale < 0.0 ? -scale : scale;
            if (size >= kLeast && size <= kMost) continue;
            mistakes_.wrong(begin, at_, "the scale of a picture must be from 1e-9 to 1e9");
            map.scale = DVec2{1.0};
            break;
        }
        return true;
    }
    if (option == "-bm") {
        if (const auto multiplier = read_number("1")) map.bump_multiplier = *multiplier;
        return true;
    }
    for (const MapOption& skipped : kSkippedOptions) {
        if (option != skipped.name) continue;
        for (std::size_t i = 0; i < skipped.word_count; ++i) at_ = skip_token(skip_blanks(at_));
        return true;
    }
    at_ = begin;
    return false;
}

/// u [v [w]]
void MtlReader::read_pair(DVec2& pair) {
    const auto u = read_number("1 to 3");
    if (!u) return;
    pair.x = *u;
    if (!is_number_here()) return;
    if (const auto v = read_number("1 to 3")) pair.y = *v;
    if (is_number_here()) read_number("1 to 3");
}

bool MtlReader::is_number_here() const {
    const char* at = skip_blanks(at_);
    if (*at == '-' || *at == '+') ++at;
    const ParsedNumber number = parse_decimal(at);
    return number.is_found() && is_token_end(number.end);
}

std::optional<double> MtlReader::read_number(std::string_view needed) {
    const std::optional<double> number = take_number(at_);
    if (number) {
        ++number_count_;
    } else {
        mistakes_.wrong_number(statement_, at_, number_count_, needed);
    }
    return number;
}

void MtlReader::skip(std::string_view keyword) {
    if (skipped_.size() >= kMaxSkipped) return;
    if (std::find(skipped_.begin(), skipped_.end(), keyword) == skipped_.end()) {
        skipped_.push_back(keyword);
    }
}

void tell_skipped(const std::vector<std::string_view>& keywords, const Text& text, SourceId file,
                  Span loaded_at, Diagnostics& diagnostics) {
    if (keywords.empty()) return;
    std::string names;
    for (const std::string_view keyword : keywords) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", quoted_token(keyword));
    }
    const std::string_view first = keywords.front();
    const auto begin = static_cast<std::size_t>(first.data() - text.data());
    Diagnostic& warning =
        diagnostics.warning(Code::W1704, Span::make(file, begin, begin + first.size()),
                            fmt::format("not read of this file: {}", names));
    if (!loaded_at.is_nowhere()) warning.with_label(loaded_at, "loaded here");
}

}  // namespace

std::optional<std::vector<MtlMaterial>> read_mtl(const Sources& sources, SourceId file,
                                                 Span loaded_at,
                                                 const std::unordered_set<std::string>& wanted,
                                                 Diagnostics& diagnostics) {
    const Text& text = sources[file].text;
    Mistakes mistakes(text, file, loaded_at, diagnostics);
    if (mistakes.find_binary("MTL")) return std::nullopt;
    MtlReader reader(text, wanted, mistakes);
    std::vector<MtlMaterial> materials = reader.read_all(text, file);
    if (mistakes.count() > 0) return std::nullopt;
    tell_skipped(reader.skipped(), text, file, loaded_at, diagnostics);
    return materials;
}

}  // namespace lray::scene
