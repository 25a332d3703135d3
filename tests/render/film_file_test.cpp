#include "render/film_file.h"

#include <gtest/gtest.h>

#include <string>

#include "base/content_hash.h"
#include "render/merge_films.h"
#include "tests/support/random.h"
#include "tests/support/temp_directory.h"

namespace lray::render {
namespace {

constexpr std::uint64_t kSeed = 72;
constexpr std::uint64_t kMaxPixels = 1000;

Film random_film(test::Random& random, std::uint32_t sample_count, Film::Keeps keeps) {
    Film film(7, 5, keeps);
    for (std::uint32_t i = 0; i < sample_count; ++i) {
        for (std::uint32_t y = 0; y < 5; ++y) {
            for (std::uint32_t x = 0; x < 7; ++x) film.add(x, y, random.vec3(-1.0, 70'000.0));
        }
    }
    return film;
}

FilmDescription description_of(SampleRange samples) {
    FilmDescription description;
    description.identity = {{"size", "7x5"}, {"the seed", "3"}, {"odd", "a\nb\\n\\c: d"}};
    description.samples = {samples};
    description.total = 64;
    description.display = {0.1, image::ToneMap::aces, image::Gamma::linear};
    description.info = {{"title", "two\nlines \\ and more"}};
    return description;
}

std::string written(const FilmDescription& description, const Film& film) {
    const test::TempDirectory directory;
    std::string error;
    auto out = OutputFile::open(directory.path("a.film"), error);
    EXPECT_TRUE(out) << error;
    EXPECT_TRUE(write_film(*out, description, film) && out->commit()) << out->error();
    return directory.read("a.film");
}

std::optional<StoredFilm> read(std::string_view bytes, std::string& error) {
    return read_film(std::as_bytes(std::span(bytes)), kMaxPixels, error);
}

std::string error_of(std::string_view bytes) {
    std::string error;
    EXPECT_FALSE(read(bytes, error));
    return error;
}

void expect_same(const Film& a, const Film& b) {
    ASSERT_EQ(a.pixels().size(), b.pixels().size());
    ASSERT_EQ(a.keeps(), b.keeps());
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        ASSERT_EQ(a.pixels()[i].sample_count, b.pixels()[i].sample_count);
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_EQ(a.pixels()[i].sum[channel], b.pixels()[i].sum[channel]);
            if (a.squares().empty()) continue;
            ASSERT_TRUE(a.squares()[i].sum[channel] == b.squares()[i].sum[channel]);
        }
    }
    EXPECT_EQ(a.counts().clamped, b.counts().clamped);
    EXPECT_EQ(a.counts().nan, b.counts().nan);
}

/// With the fingerprint that the bytes before it have: damage that was meant.
std::string resealed(std::string bytes) {
    bytes.resize(bytes.size() - 8);
    ContentHash hash;
    hash.add(bytes);
    const std::uint64_t value = hash.value();
    bytes.append(reinterpret_cast<const char*>(&value), 8);
    return bytes;
}

TEST(FilmFile, ComesBackToTheBit) {
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (const Film::Keeps keeps : {Film::Keeps::sums, Film::Keeps::squares}) {
        const Film film = random_film(random, 5, keeps);
        ASSERT_GT(film.counts().clamped, 0u);
        FilmDescription description = description_of({3, 8});
        description.is_complete = false;
        std::string error;
        const auto stored = read(written(description, film), error);
        ASSERT_TRUE(stored) << error;
        expect_same(stored->film, film);
        EXPECT_EQ(stored->description.identity, description.identity);
        EXPECT_EQ(stored->description.samples, description.samples);
        EXPECT_EQ(stored->description.total, description.total);
        EXPECT_FALSE(stored->description.is_complete);
        EXPECT_EQ(stored->description.display, description.display);
        EXPECT_EQ(stored->description.info, description.info);
    }
}

TEST(FilmFile, EveryBeginningOfAFileIsRefused) {
    test::Random random(kSeed);
    const std::string bytes =
        written(description_of({0, 2}), random_film(random, 2, Film::Keeps::squares));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ASSERT_NE(error_of(std::string_view(bytes).substr(0, size)), "") << size;
    }
    EXPECT_EQ(error_of(bytes + "x"), "this film ends early, or late");
}

TEST(FilmFile, DamageIsNoticed) {
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    const std::string bytes =
        written(description_of({0, 2}), random_film(random, 2, Film::Keeps::sums));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ (1 << random.below(8)));
        ASSERT_NE(error_of(damaged), "") << i;
    }
}

TEST(FilmFile, DamageThatWasMeantIsHarmless) {
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    const std::string bytes =
        written(description_of({0, 2}), random_film(random, 2, Film::Keeps::squares));
    int read_count = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string damaged = bytes;
        for (std::uint64_t i = random.below(4); i < 4; ++i) {
            damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
        }
        std::string error;
        const auto stored = read(resealed(damaged), error);
        ASSERT_NE(stored.has_value(), !error.empty());
        if (!stored) continue;
        ++read_count;
        Film film = stored->film;
        film.add_film(stored->film);  // no overflow, whatever it holds
        film.picture();
    }
    EXPECT_GT(read_count, 100);
}

TEST(FilmFile, SaysWhatIsWrong) {
    test::Random random(kSeed);
    const std::string bytes =
        written(description_of({0, 2}), random_film(random, 2, Film::Keeps::sums));
    const auto with = [&](std::string_view from, std::string_view to) {
        std::string changed = bytes;
        changed.replace(changed.find(from), from.size(), to);
        return resealed(changed);
    };
    EXPECT_EQ(error_of("P6 1 1"), "this is not a film of this version of lray");
    EXPECT_EQ(error_of(with("size 7 5", "size 100 11")),
              "100 x 11 pixels are more than the limit of 1000");
    EXPECT_EQ(error_of(with("size 7 5", "size 7 6")), "this film ends early, or late");
    EXPECT_EQ(error_of(with("size 7 5", "size 7 0")), "7 x 0 pixels are no picture");
    EXPECT_EQ(error_of(with("size 7 5", "size 0 5")), "0 x 5 pixels are no picture");
    EXPECT_EQ(error_of(with("size 7 5", "size 99999999999 99999999999")),
              "99999999999 x 99999999999 pixels are more than the limit of 1000");
    EXPECT_EQ(error_of(with("size 7 5", "size 7,5")), "line 2 of this film is damaged");
    EXPECT_EQ(error_of(with("samples 0 2\n", "")), "this film says nothing of its samples");
    EXPECT_EQ(error_of(with("samples 0 2", "samples 0 99999")), "line 5 of this film is damaged");
    EXPECT_EQ(error_of(with("samples 0 2", "samples 0 1")), "this film is damaged")
        << "more samples than there are";
    EXPECT_EQ(error_of(with("exposure 0.1", "exposure nan")), "line 8 of this film is damaged");
}

class MergeFilms : public testing::Test {
 protected:
    /// Films of stretches of one picture, and the film of all.
    std::vector<NamedFilm> films_of(const std::vector<SampleRange>& ranges) {
        std::vector<NamedFilm> films;
        for (const SampleRange range : ranges) {
            Film film(7, 5);
            for (std::uint32_t i = range.begin; i < range.end; ++i) {
                for (std::uint32_t y = 0; y < 5; ++y) {
                    for (std::uint32_t x = 0; x < 7; ++x) film.add(x, y, sample(i, x, y));
                }
            }
            films.push_back({std::string(1, static_cast<char>('a' + films.size())) + ".film",
                             {description_of(range), std::move(film)}});
        }
        return films;
    }

    static Color sample(std::uint32_t i, std::uint32_t x, std::uint32_t y) {
        test::Random random(kSeed + 10'000 * i + 100 * x + y);
        return random.vec3(0.0, 66'000.0);
    }

    static std::string error_of(const std::vector<NamedFilm>& films) {
        std::string error;
        EXPECT_FALSE(merge_films(films, error));
        return error;
    }
};

TEST_F(MergeFilms, PartsInAnyOrderAreTheWholeToTheBit) {
    const Film whole = films_of({{0, 64}}).front().stored.film;
    std::string error;
    const auto merged = merge_films(films_of({{40, 64}, {0, 7}, {7, 8}, {8, 40}}), error);
    ASSERT_TRUE(merged) << error;
    expect_same(merged->film, whole);
    EXPECT_EQ(merged->description.samples, (std::vector<SampleRange>{{0, 64}}));
    EXPECT_EQ(missing_samples(merged->description), "");
}

TEST_F(MergeFilms, WhatIsMissingIsNamed) {
    std::string error;
    const auto merged = merge_films(films_of({{8, 16}, {32, 48}}), error);
    ASSERT_TRUE(merged) << error;
    EXPECT_EQ(missing_samples(merged->description), "0:8, 16:32 and 48:64");
    auto unknown = films_of({{8, 16}});
    unknown.front().stored.description.total.reset();
    EXPECT_EQ(missing_samples(unknown.front().stored.description), "0:8");
}

TEST_F(MergeFilms, SharedSamplesAreRefused) {
    EXPECT_EQ(error_of(films_of({{0, 16}, {20, 30}, {12, 20}})),
              "`a.film` and `c.film` both have the samples 12:16");
    EXPECT_EQ(error_of(films_of({{0, 64}, {20, 30}})),
              "`a.film` and `b.film` both have the samples 20:30");
}

TEST_F(MergeFilms, OtherPicturesAreRefused) {
    auto films = films_of({{0, 8}, {8, 16}});
    films[1].stored.description.identity[1].second = "4";
    EXPECT_EQ(error_of(films),
              "`a.film` and `b.film` are not of one picture: they differ in the seed: 3 and 4");
    films[1].stored.description.identity[2].second = std::string(1000, 'x');
    films[1].stored.description.identity[1].second = "3";
    EXPECT_EQ(error_of(films), "`a.film` and `b.film` are not of one picture: they differ in odd");
    films[1].stored.description.identity.pop_back();
    EXPECT_EQ(error_of(films),
              "`a.film` and `b.film` are not of one picture: they are of different versions of "
              "lray");
}

TEST_F(MergeFilms, AnUnfinishedFilmIsRefused) {
    auto films = films_of({{0, 8}, {8, 16}});
    films[1].stored.description.is_complete = false;
    EXPECT_EQ(error_of(films), "`b.film` is not complete: its render was interrupted");
}

TEST_F(MergeFilms, AFilmWithoutPixelsIsRefused) {
    auto films = films_of({{0, 8}, {8, 16}});
    films[0].stored.film = Film(0, 0);
    EXPECT_EQ(error_of(films), "`a.film` holds no pixels, it notes that a frame is done");
    films[1].stored.film = Film(0, 0);
    EXPECT_EQ(error_of({films[1]}), "`b.film` holds no pixels, it notes that a frame is done");
}

TEST_F(MergeFilms, TooManySamplesAreRefused) {
    auto films = films_of({{0, 1}, {1, 2}});
    films[0].stored.description.samples = {{0, 20'000}};
    films[1].stored.description.samples = {{20'000, 40'000}};
    EXPECT_EQ(error_of(films), "together they have 40000 samples a pixel; the most is 32768");
}

}  // namespace
}  // namespace lray::render
