// The corpus tests/errors: scenes with mistakes, and below the line of each mistake a comment that
// says what is reported there, word for word:
//
//   sphere { radios: 1 }
//   // error[E0401] :10 sphere has no property `radios`
//   //   hint: did you mean `radius`?
//
// `:10` is the column in the line above; a place in another file is `name:line:column`, and no
// place is `-`. Where no comment can stand, a file NAME.expected holds the same lines, without
// `//` and with `line:column`. A first line `// limits: nesting=4` sets limits, and `// light:
// expected` is as if the picture were to show light. What the scenes name
// is in tests/errors/files. Warnings that are silent by default are told too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic_codes.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

const std::filesystem::path kCorpus = LRAY_SOURCE_DIR "/tests/errors";

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

bool is_expectation(std::string_view line) {
    for (const std::string_view start : {"// error[", "// warning[", "//   hint: ", "//   note: ",
                                         "//   help: ", "//   label: "}) {
        if (line.starts_with(start)) return true;
    }
    return false;
}

/// The expectations of a case, one line each, places as `line:column`.
std::string expected(const std::filesystem::path& scene) {
    std::filesystem::path beside = scene;
    beside.replace_extension(".expected");
    if (std::filesystem::exists(beside)) return read_bytes(beside.string());
    std::string result;
    std::size_t number = 0;
    std::size_t line_above = 0;
    for (const std::string& line : lines_of(read_bytes(scene.string()))) {
        ++number;
        if (!is_expectation(line)) {
            line_above = number;
            continue;
        }
        std::string_view text = std::string_view(line).substr(3);
        const std::size_t place = text.find("] :");
        if (!text.starts_with(' ') && place != text.npos) {
            result += fmt::format("{} {}{}\n", text.substr(0, place + 1), line_above,
                                  text.substr(place + 2));
        } else {
            result += fmt::format("{}\n", text);
        }
    }
    return result;
}

std::string actual(const Loaded& loaded) {
    std::string result;
    for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
        result += fmt::format("{}[{}] {} {}\n",
                              diagnostic->severity == Severity::error ? "error" : "warning",
                              code_info(diagnostic->code).id,
                              place_of(loaded.sources, diagnostic->span), diagnostic->message);
        if (!diagnostic->hint.empty()) result += fmt::format("  hint: {}\n", diagnostic->hint);
        for (const Label& label : diagnostic->labels) {
            result += fmt::format("  label: {} {}\n", place_of(loaded.sources, label.span),
                                  label.message);
        }
        for (const std::string& note : diagnostic->notes) {
            result += fmt::format("  note: {}\n", note);
        }
        for (const std::string& help : diagnostic->helps) {
            result += fmt::format("  help: {}\n", help);
        }
    }
    return result;
}

struct Limits {
    parser::LoadLimits load{};
    scene::FlattenLimits flatten{};
    bool expects_light = false;
};

/// Reads `// limits: nesting=4 files=2`, or `// light: expected`.
Limits limits_of(std::string_view text) {
    Limits limits;
    constexpr std::string_view kStart = "// limits: ";
    limits.expects_light = text.starts_with("// light: expected\n");
    if (!text.starts_with(kStart)) return limits;
    text = text.substr(kStart.size(), text.find('\n') - kStart.size());
    while (!text.empty()) {
        const std::size_t equal = text.find('=');
        const std::string_view name = text.substr(0, equal);
        std::uint64_t value = 0;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data() + equal + 1, end, value);
        EXPECT_EQ(error, std::errc{}) << "limit " << name;
        if (name == "scene_bytes") {
            limits.load.scene_bytes = value;
        } else if (name == "mesh_bytes") {
            limits.load.mesh_bytes = value;
        } else if (name == "texture_bytes") {
            limits.load.texture_bytes = value;
        } else if (name == "texture_pixels") {
            limits.load.texture_pixels = value;
        } else if (name == "nesting") {
            limits.load.nesting = static_cast<std::uint32_t>(value);
        } else if (name == "include_depth") {
            limits.load.include_depth = static_cast<std::uint32_t>(value);
        } else if (name == "files") {
            limits.load.files = static_cast<std::uint32_t>(value);
        } else if (name == "steps") {
            limits.load.steps = value;
        } else if (name == "value_bytes") {
            limits.load.value_bytes = value;
        } else if (name == "list_size") {
            limits.load.list_size = value;
        } else if (name == "printed_bytes") {
            limits.load.printed_bytes = value;
        } else if (name == "primitives") {
            limits.flatten.primitives = value;
        } else if (name == "lights") {
            limits.flatten.lights = value;
        } else {
            ADD_FAILURE() << "there is no limit " << name;
        }
        text = {rest, static_cast<std::size_t>(end - rest)};
        if (text.starts_with(' ')) text.remove_prefix(1);
    }
    return limits;
}

std::vector<std::string> case_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
        if (entry.path().extension() == ".lrs") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

class ErrorCorpus : public ::testing::TestWithParam<std::string> {
 protected:
    // Paths are reported as they were given: cases are named from inside their directory.
    void SetUp() override {
        before_ = std::filesystem::current_path();
        std::filesystem::current_path(kCorpus);
    }
    void TearDown() override { std::filesystem::current_path(before_); }

 private:
    std::filesystem::path before_;
};

TEST_P(ErrorCorpus, SaysExactlyWhatIsExpected) {
    const std::filesystem::path path = kCorpus / (GetParam() + ".lrs");
    const Limits limits = limits_of(read_bytes(path.string()));
    Loaded loaded = load_file(GetParam() + ".lrs", with_limits(limits.load), all_warnings());
    EXPECT_EQ(loaded.scene.has_value(), !loaded.has_errors());
    if (loaded.scene) {
        const auto world =
            flatten_and_lint(loaded, limits.flatten, {.expects_light = limits.expects_light});
        EXPECT_EQ(world.has_value(), !loaded.has_errors());
    }
    EXPECT_EQ(expected(path), actual(loaded));
}

INSTANTIATE_TEST_SUITE_P(Cases, ErrorCorpus, ::testing::ValuesIn(case_names()),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(ErrorCorpus, HoldsACaseOfEveryCode) {
    // An absolute path differs from machine to machine: its case is Files.AnAbsolutePathWarns.
    std::set<std::string> seen = {"W1605"};
    for (const std::string& name : case_names()) {
        for (const std::string& line : lines_of(expected(kCorpus / (name + ".lrs")))) {
            const std::size_t open = line.find('[');
            if (!line.starts_with(' ') && open != line.npos) seen.insert(line.substr(open + 1, 5));
        }
    }
    for (const CodeInfo& info : code_infos()) {
        EXPECT_TRUE(seen.contains(std::string(info.id))) << info.id << " has no case";
    }
}

}  // namespace
}  // namespace lray::test
