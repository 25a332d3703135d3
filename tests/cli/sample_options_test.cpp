// Options about how many samples a picture gets, and which.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/parsed_options.h"

namespace lray::cli {
namespace {

TEST(SampleOptions, DurationsHaveUnits) {
    const auto seconds = [](const char* text) {
        return parsed({"a.lrs", "-o", "a.ppm", "--time", text}).sample_limits.seconds.value_or(-1);
    };
    EXPECT_EQ(seconds("30s"), 30.0);
    EXPECT_EQ(seconds("500ms"), 0.5);
    EXPECT_EQ(seconds("1.5m"), 90.0);
    EXPECT_EQ(seconds("2h"), 7200.0);
    EXPECT_EQ(failed({"a.lrs", "-o", "a.ppm", "--time", "30"}).message,
              "`--time` takes a duration like `500ms`, `30s`, `5m` or `2h`, not `30`; `30s`?");
    for (const char* wrong : {"", "s", "0s", "-1s", "1e3s", "1 s", "1d", "1.2.3s", "nan", "infs"}) {
        EXPECT_EQ(
            failed({"a.lrs", "-o", "a.ppm", "--time", wrong}).message,
            std::string("`--time` takes a duration like `500ms`, `30s`, `5m` or `2h`, not `") +
                wrong + "`");
    }
}

TEST(SampleOptions, NoiseIsAShareOfWhite) {
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm", "--noise", "0.01"}).sample_limits.noise, 0.01);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm", "--noise", "1"}).sample_limits.noise, 1.0);
    for (const char* wrong : {"", "0", "-0.1", "1.01", "nan", "inf", "1%", "5e-400"}) {
        EXPECT_EQ(failed({"a.lrs", "-o", "a.ppm", "--noise", wrong}).message,
                  std::string("`--noise` takes a share of white above 0, like `0.01`, up to 1, not "
                              "`") +
                      wrong + "`");
    }
}

TEST(SampleOptions, APartOfTheSamplesIsRenderedWhole) {
    const Failure time =
        failed({"a.lrs", "-o", "a.ppm", "--samples", "0:16", "--time", "1s", "--noise", "0.1"});
    EXPECT_EQ(time.message, "`--samples 0:16` and `--time` do not go together");
    EXPECT_EQ(time.help,
              "a part of the samples is always rendered whole; leave one of the two out");
    EXPECT_EQ(failed({"a.lrs", "-o", "a.ppm", "--samples", "0:16", "--noise", "0.1"}).message,
              "`--samples 0:16` and `--noise` do not go together");
}

TEST(SampleOptions, SamplesBehindTheLastAreAUsageError) {
    const Failure failure = failed({"a.lrs", "-o", "a.ppm", "-ps", "16", "--samples", "16:32"});
    EXPECT_EQ(failure.message, "`--samples 16:32` begins behind the last of `-ps 16`");
    EXPECT_EQ(failure.help, "they count from 0; without `-ps` the range alone says which");
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm", "-ps", "16", "--samples", "15:32"}).samples, 16u);
}

TEST(SampleOptions, SamplesAtLevelOneWarn) {
    for (const char* name : {"-ps", "--spp"}) {
        const Options options = parsed({"-n", "1", name, "16", "a.lrs", "-o", "a.ppm"});
        ASSERT_EQ(options.warnings.size(), 1u);
        EXPECT_EQ(options.warnings[0],
                  "`-ps 16` is ignored: level 1 sends one ray through the centre of each pixel");
    }
    EXPECT_TRUE(parsed({"-n", "1", "-ps", "1", "a.lrs", "-o", "a.ppm"}).warnings.empty());
    const Options others =
        parsed({"-n", "1", "--samples", "0:4", "--seed", "3", "a.lrs", "-o", "a.ppm"});
    ASSERT_EQ(others.warnings.size(), 2u);
    EXPECT_TRUE(others.warnings[0].starts_with("`--samples 0:4` is ignored: level 1"));
    EXPECT_TRUE(others.warnings[1].starts_with("`--seed 3` is ignored: level 1"));
    EXPECT_TRUE(parsed({"-n", "2", "--samples", "0:4", "--seed", "3", "a.lrs", "-o", "a.ppm"})
                    .warnings.empty());
    const Options limits = parsed({"-n", "1", "--time", "5s", "--noise", "0.1", "--sampler",
                                   "random", "a.lrs", "-o", "a.ppm"});
    ASSERT_EQ(limits.warnings.size(), 3u);
    EXPECT_TRUE(limits.warnings[0].starts_with("`--sampler` is ignored: level 1"));
    EXPECT_TRUE(limits.warnings[1].starts_with("`--time` is ignored: level 1"));
    EXPECT_TRUE(limits.warnings[2].starts_with("`--noise` is ignored: level 1"));
}

}  // namespace
}  // namespace lray::cli
