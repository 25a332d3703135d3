// parse_decimal against the C library, and the edges of its grammar.
#include "base/parse_number.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lray {
namespace {

struct Outcome {
    double value = 0.0;
    std::size_t length = 0;  // 0: no number
};

Outcome parse(std::string_view text) {
    const Text padded(text);
    const ParsedNumber number = parse_decimal(padded.data());
    if (!number.is_found()) return {};
    return {number.value, static_cast<std::size_t>(number.end - padded.data())};
}

TEST(ReadDigitRun, EveryLengthAndNeighbourCharacter) {
    for (std::size_t length = 0; length <= 10; ++length) {
        const std::string digits = std::string("9876543210").substr(0, length);
        for (int c = 0; c < 256; ++c) {
            if (c >= '0' && c <= '9') continue;
            const Text text(digits + static_cast<char>(c) + "99999999");
            const DigitRun run = read_digit_run(text.data());
            const std::size_t count = std::min<std::size_t>(length, 8);
            ASSERT_EQ(run.count, count) << "before byte " << c;
            const std::uint32_t value =
                count == 0 ? 0 : static_cast<std::uint32_t>(std::stoul(digits.substr(0, count)));
            ASSERT_EQ(run.value, value) << "before byte " << c;
        }
    }
}

TEST(ParseDecimal, ReadsTheFormsOfTheGrammar) {
    const struct {
        const char* text;
        double value;
        std::size_t length;
    } cases[] = {
        {"0", 0.0, 1},
        {"12", 12.0, 2},
        {"1.", 1.0, 2},
        {".5", 0.5, 2},
        {"0.25", 0.25, 4},
        {"1e5", 1e5, 3},
        {"1E+5", 1e5, 4},
        {"1.e-2", 0.01, 5},
        {".5e1", 5.0, 4},
        {"007", 7.0, 3},
        {"1e0000000000002", 100.0, 15},
        {"0e999999999999", 0.0, 14},
    };
    for (const auto& c : cases) {
        const Outcome outcome = parse(c.text);
        EXPECT_EQ(outcome.value, c.value) << c.text;
        EXPECT_EQ(outcome.length, c.length) << c.text;
    }
}

TEST(ParseDecimal, LeavesWhatIsNotOfTheNumber) {
    const struct {
        const char* text;
        double value;
        std::size_t length;
    } cases[] = {
        {"1e", 1.0, 1},    {"1e+", 1.0, 1},   {"1e-x", 1.0, 1},  {"1.5.2", 1.5, 3},
        {"1_000", 1.0, 1}, {"30deg", 30., 2}, {"2em", 2.0, 1},   {"1,5", 1.0, 1},
        {"0x10", 0.0, 1},  {"1..2", 1.0, 2},  {"1e5e5", 1e5, 3}, {"1 2", 1.0, 1},
    };
    for (const auto& c : cases) {
        const Outcome outcome = parse(c.text);
        EXPECT_EQ(outcome.value, c.value) << c.text;
        EXPECT_EQ(outcome.length, c.length) << c.text;
    }
}

TEST(ParseDecimal, FindsNoNumberWithoutADigit) {
    for (const char* text :
         {"", ".", ".e5", "e5", "-1", "+1", "nan", "inf", "infinity", "x", " 1"}) {
        EXPECT_EQ(parse(text).length, 0u) << text;
    }
}

TEST(ParseDecimal, TooLargeIsInfinityAndSaysSo) {
    for (const std::string& text :
         {std::string("1e309"), std::string("1.7976931348623159e308"), std::string("1e99999999999"),
          std::string(400, '9'), "0." + std::string(400, '0') + "1e1000"}) {
        const Text padded(text);
        const ParsedNumber number = parse_decimal(padded.data());
        EXPECT_TRUE(number.is_too_large()) << text;
        EXPECT_EQ(number.end, padded.data() + text.size()) << text;
    }
    const Text largest("1.7976931348623157e308");
    EXPECT_FALSE(parse_decimal(largest.data()).is_too_large());
}

TEST(ParseDecimal, TooSmallIsZero) {
    for (const std::string& text :
         {std::string("1e-400"), std::string("2e-324"), std::string("123456789e-99999999999"),
          "0." + std::string(400, '0') + "1", std::string(300, '7') + "e-1000"}) {
        const Outcome outcome = parse(text);
        EXPECT_EQ(outcome.value, 0.0) << text;
        EXPECT_EQ(outcome.length, text.size()) << text;
    }
    EXPECT_EQ(parse("3e-324").value, std::numeric_limits<double>::denorm_min());
}

TEST(ParseDecimal, RoundsHalfwayToEvenBeyondTheFastPath) {
    EXPECT_EQ(parse("9007199254740993").value, 9007199254740992.0);  // 2^53 + 1
    EXPECT_EQ(parse("9007199254740995").value, 9007199254740996.0);  // 2^53 + 3
    EXPECT_EQ(parse("9007199254740993.0000000000000000000000001").value, 9007199254740994.0);
    EXPECT_EQ(parse("18446744073709551616").value, 18446744073709551616.0);  // 20 digits
    EXPECT_EQ(parse("1e22").value, 1e22);
    EXPECT_EQ(parse("1e23").value, 1e23);
}

/// Numbers as people, programs and enemies write them.
class NumberWriter {
 public:
    explicit NumberWriter(std::uint64_t seed) : random_(seed) {}

    std::string write() {
        switch (below(8)) {
            case 0:
                return fmt::format("{}.{}", digits(1 + below(8)), digits(below(9)));
            case 1:
                return fmt::format(".{}", digits(1 + below(25)));
            case 2:
                return digits(1 + below(25));
            case 3:
                return fmt::format("{}.{}{}", digits(1 + below(20)), digits(below(20)),
                                   exponent(400));
            case 4:
                return fmt::format("{:.{}e}", any_double(), below(20));
            case 5:  // subnormal
                return fmt::format("{:.17g}",
                                   std::bit_cast<double>((random_() >> 12) >> below(52)));
            case 6:
                return fmt::format("{}", any_double());
            default:
                return fmt::format("{}.{}{}", digits(below(60)), digits(1 + below(900)),
                                   exponent(1000));
        }
    }

 private:
    std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

    /// Many zeros: they are what goes wrong.
    std::string digits(std::size_t count) {
        std::string text;
        while (text.size() < count)
            text += static_cast<char>(below(4) == 0 ? '0' : '0' + below(10));
        return text;
    }

    std::string exponent(std::size_t bound) {
        const char* signs[] = {"-", "+", ""};
        return fmt::format("{}{}{}", below(2) == 0 ? 'e' : 'E', signs[below(3)], below(bound));
    }

    double any_double() {
        for (;;) {
            const double value = std::bit_cast<double>(random_() >> 1);
            if (std::isfinite(value)) return value;
        }
    }

    std::mt19937_64 random_;
};

TEST(ParseDecimal, AgreesWithStrtodToTheBitOnAMillionNumbers) {
    constexpr std::uint64_t kSeed = 20240601;
    NumberWriter writer(kSeed);
    for (int i = 0; i < 1'000'000; ++i) {
        const std::string written = writer.write();
        char* end = nullptr;
        const double expected = std::strtod(written.c_str(), &end);
        const Outcome outcome = parse(written);
        ASSERT_EQ(outcome.length, static_cast<std::size_t>(end - written.c_str()))
            << written << " (seed " << kSeed << ")";
        ASSERT_EQ(std::bit_cast<std::uint64_t>(outcome.value),
                  std::bit_cast<std::uint64_t>(expected))
            << written << " (seed " << kSeed << ")";
    }
}

}  // namespace
}  // namespace lray
