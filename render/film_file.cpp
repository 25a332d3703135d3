// The head is lines of `name value`, up to an empty one; text in them has no line ends, `\n` and
// `\\` stand for those. Numbers of the pixels have the least byte first.
#include "render/film_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "base/content_hash.h"

namespace lray::render {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view kMagic = "lray film 1\n";
constexpr std::size_t kSumsSize = 3 * sizeof(std::int64_t) + sizeof(std::uint32_t);
constexpr std::size_t kSquaresSize = 3 * sizeof(Film::Wide);
constexpr std::size_t kHashSize = sizeof(std::uint64_t);
constexpr std::size_t kMaxHeadLines = 100'000;
constexpr std::size_t kChunk = std::size_t{1} << 20;

std::size_t pixel_size(Film::Keeps keeps) {
    return kSumsSize + (keeps == Film::Keeps::squares ? kSquaresSize : 0);
}

std::string on_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        if (c == '\n') {
            line += "\\n";
        } else {
            if (c == '\\') line += '\\';
            line += c;
        }
    }
    return line;
}

std::string from_one_line(std::string_view line) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool is_escape = line[i] == '\\' && i + 1 < line.size();
        if (is_escape) ++i;
        text += is_escape && line[i] == 'n' ? '\n' : line[i];
    }
    return text;
}

std::string head_of(const FilmDescription& description, const Film& film) {
    std::string head(kMagic);
    const auto add = [&](std::string_view name, std::string_view value) {
        head += fmt::format("{} {}\n", name, value);
    };
    add("size", fmt::format("{} {}", film.width(), film.height()));
    add("keeps", film.keeps() == Film::Keeps::squares ? "squares" : "sums");
    add("complete", description.is_complete ? "yes" : "no");
    for (const SampleRange range : description.samples) {
        add("samples", fmt::format("{} {}", range.begin, range.end));
    }
    if (description.total) add("total", fmt::to_string(*description.total));
    add("counts", fmt::format("{} {}", film.counts().clamped, film.counts().nan));
    const image::DisplaySettings& display = description.display;
    add("exposure", fmt::format("{}", display.exposure));
    add("tonemap", fmt::to_string(static_cast<int>(display.tonemap)));
    add("gamma", fmt::to_string(static_cast<int>(display.gamma)));
    for (const auto& [name, value] : description.identity) {
        add("picture", fmt::format("{}: {}", on_one_line(name), on_one_line(value)));
    }
    for (const auto& [name, value] : description.info) {
        add("info", fmt::format("{}: {}", on_one_line(name), on_one_line(value)));
    }
    return head + "\n";
}

template <class T>
void append(std::string& bytes, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T take(std::span<const std::byte>& bytes) {
    T value{};
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes = bytes.subspan(sizeof value);
    return value;
}

/// Whole numbers with a blank between them; empty if the text is anything else.
template <std::size_t count>
std::optional<std::array<std::uint64_t, count>> whole_numbers(std::string_view text) {
    std::array<std::uint64_t, count> numbers{};
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) {
            if (!text.starts_with(' ')) return std::nullopt;
            text.remove_prefix(1);
        }
        const auto [end, code] =
            std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
        if (code != std::errc{}) return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    if (!text.empty()) return std::nullopt;
    return numbers;
}

struct Head {
    FilmDescription description{};
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    Film::Keeps keeps = Film::Keeps::sums;
    FilmCounts counts{};
};

bool read_samples(std::string_view value, std::vector<SampleRange>& samples) {
    const auto range = whole_numbers<2>(value);
    const std::uint64_t after = samples.empty() ? 0 : samples.back().end + std::uint64_t{1};
    if (!range || (*range)[0] < after || (*range)[0] >= (*range)[1]) return false;
    if ((*range)[1] - (*range)[0] > Film::kMaxSamples || (*range)[1] > 0xffffffffu) return false;
    samples.push_back(
        {static_cast<std::uint32_t>((*range)[0]), static_cast<std::uint32_t>((*range)[1])});
    return true;
}

bool read_pair(std::string_view value, std::vector<std::pair<std::string, std::string>>& pairs) {
    const std::size_t colon = value.find(": ");
    if (colon == value.npos) return false;
    pairs.emplace_back(from_one_line(value.substr(0, colon)),
                       from_one_line(value.substr(colon + 2)));
    return true;
}

/// Reads a line of the head; false if it is none.
bool read_line(std::string_view name, std::string_view value, Head& head) {
    FilmDescription& description = head.description;
    image::DisplaySettings& display = description.display;
    if (name == "size") {
        const auto size = whole_numbers<2>(value);
        if (!size) return false;
        head.width = (*size)[0];
        head.height = (*size)[1];
        return true;
    }
    if (name == "keeps") {
        head.keeps = value == "squares" ? Film::Keeps::squares : Film::Keeps::sums;
        return value == "squares" || value == "sums";
    }
    if (name == "complete") {
        description.is_complete = value == "yes";
        return value == "yes" || value == "no";
    }
    if (name == "samples") return read_samples(value, description.samples);
    if (name == "picture") return read_pair(value, description.identity);
    if (name == "info") return read_pair(value, description.info);
    if (name == "exposure") {
        const auto [end, code] =
            std::from_chars(value.data(), value.data() + value.size(), display.exposure);
        const bool is_all = code == std::errc{} && end == value.data() + value.size();
        return is_all && std::abs(display.exposure) <= 1000.0;
    }
    if (name == "counts") {
        const auto counts = whole_numbers<2>(value);
        if (!counts) return false;
        head.counts = {(*counts)[0], (*counts)[1]};
        return true;
    }
    const auto number = whole_numbers<1>(value);
    if (!number) return false;
    const std::uint64_t n = (*number)[0];
    if (name == "total") {
        description.total = static_cast<std::uint32_t>(n);
        return n <= 0xffffffffu;
    }
    if (name == "tonemap") {
        display.tonemap = static_cast<image::ToneMap>(n);
        return n <= static_cast<std::uint64_t>(image::ToneMap::aces);
    }
    if (name == "gamma") {
        display.gamma = static_cast<image::Gamma>(n);
        return n <= static_cast<std::uint64_t>(image::Gamma::linear);
    }
    return false;
}

/// Takes the head from the front of `text`.
std::optional<Head> read_head(std::string_view& text, std::string& error) {
    Head head;
    text.remove_prefix(kMagic.size());
    for (std::size_t number = 2; number < kMaxHeadLines; ++number) {
        const std::size_t end = text.find('\n');
        if (end == text.npos) break;
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end + 1);
        if (line.empty()) return head;
        const std::size_t blank = std::min(line.find(' '), line.size());
        const std::string_view value = line.substr(std::min(blank + 1, line.size()));
        if (!read_line(line.substr(0, blank), value, head)) {
            error = fmt::format("line {} of this film is damaged", number);
            return std::nullopt;
        }
    }
    error = "this film ends early";
    return std::nullopt;
}

/// True if no sum is beyond what its samples may be: they can be added to without overflow.
bool is_possible(const Film::Pixel& pixel, std::uint32_t sample_limit) {
    if (pixel.sample_count > sample_limit) return false;
    const double most = static_cast<double>(Film::kMaxValue) * Film::kStepsOfOne;
    const auto bound = static_cast<std::int64_t>(most) * pixel.sample_count;
    return std::all_of(std::begin(pixel.sum), std::end(pixel.sum),
                       [&](std::int64_t sum) { return -bound <= sum && sum <= bound; });
}

bool is_possible(const Film::Squares& squares, std::uint32_t sample_count) {
    const Film::Wide bound = (Film::Wide{1} << 96) * sample_count;
    return std::all_of(std::begin(squares.sum), std::end(squares.sum),
                       [&](Film::Wide sum) { return sum <= bound; });
}

std::optional<Film> read_pixels(std::span<const std::byte> bytes, const Head& head) {
    std::uint32_t sample_limit = 0;
    for (const SampleRange range : head.description.samples) {
        sample_limit += std::min(range.count(), Film::kMaxSamples - sample_limit);
    }
    Film film(static_cast<std::uint32_t>(head.width), static_cast<std::uint32_t>(head.height),
              head.keeps);
    for (std::size_t i = 0; i < film.pixels().size(); ++i) {
        Film::Pixel& pixel = film.pixels()[i];
        for (std::int64_t& sum : pixel.sum) sum = take<std::int64_t>(bytes);
        pixel.sample_count = take<std::uint32_t>(bytes);
        if (!is_possible(pixel, sample_limit)) return std::nullopt;
        if (film.squares().empty()) continue;
        for (Film::Wide& sum : film.squares()[i].sum) sum = take<Film::Wide>(bytes);
        if (!is_possible(film.squares()[i], pixel.sample_count)) return std::nullopt;
    }
    film.add_counts(head.counts);
    return film;
}

}  // namespace

bool write_film(OutputFile& out, const FilmDescription& description, const Film& film) {
    ContentHash hash;
    std::string chunk = head_of(description, film);
    const auto flush = [&] {
        hash.add(chunk);
        const bool is_written = out.write(chunk);
        chunk.clear();
        return is_written;
    };
    for (std::size_t i = 0; i < film.pixels().size(); ++i) {
        const Film::Pixel& pixel = film.pixels()[i];
        for (const std::int64_t sum : pixel.sum) append(chunk, sum);
        append(chunk, pixel.sample_count);
        if (!film.squares().empty()) {
            for (const Film::Wide sum : film.squares()[i].sum) append(chunk, sum);
        }
        if (chunk.size() >= kChunk && !flush()) return false;
    }
    if (!flush()) return false;
    append(chunk, hash.value());
    return out.write(chunk);
}

std::optional<StoredFilm> read_film(std::span<const std::byte> file, std::uint64_t max_pixels,
                                    std::string& error) {
    std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    if (!text.starts_with(kMagic)) {
        error = "this is not a film of this version of lray";
        return std::nullopt;
    }
    const std::optional<Head> head = read_head(text, error);
    if (!head) return std::nullopt;
    constexpr std::uint64_t kMaxSide = 0xffffffffu;
    if (head->width > kMaxSide || head->height > kMaxSide ||
        head->width > max_pixels / std::max<std::uint64_t>(head->height, 1)) {
        error = fmt::format("{} x {} pixels are more than the limit of {}", head->width,
                            head->height, max_pixels);
        return std::nullopt;
    }
    if ((head->width == 0) != (head->height == 0)) {
        error = fmt::format("{} x {} pixels are no picture", head->width, head->height);
        return std::nullopt;
    }
    if (head->description.samples.empty()) {
        error = "this film says nothing of its samples";
        return std::nullopt;
    }
    const std::uint64_t pixel_count = head->width * head->height;
    const std::uint64_t rest = text.size();
    if (rest < kHashSize || (rest - kHashSize) / pixel_size(head->keeps) != pixel_count ||
        (rest - kHashSize) % pixel_size(head->keeps) != 0) {
        error = "this film ends early, or late";
        return std::nullopt;
    }
    ContentHash hash;
    hash.add(file.first(file.size() - kHashSize));
    std::span<const std::byte> stored = file.last(kHashSize);
    std::optional<Film> film;
    if (hash.value() == take<std::uint64_t>(stored)) film = read_pixels(file.last(rest), *head);
    if (!film) {
        error = "this film is damaged";
        return std::nullopt;
    }
    return StoredFilm{head->description, std::move(*film)};
}

std::string first_difference(const PictureIdentity& a, const PictureIdentity& b) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        if (i >= a.size() || i >= b.size() || a[i].first != b[i].first) {
            return "they are of different versions of lray";
        }
        if (a[i].second == b[i].second) continue;
        // Fingerprints and whole blocks would say nothing to a reader.
        constexpr std::size_t kReadable = 24;
        if (std::max(a[i].second.size(), b[i].second.size()) > kReadable) {
            return fmt::format("they differ in {}", a[i].first);
        }
        return fmt::format("they differ in {}: {} and {}", a[i].first, a[i].second, b[i].second);
    }
    return {};
}

}  // namespace lray::render
