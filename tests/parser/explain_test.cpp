// What `--explain` shows is true: every wrong example raises its code and nothing else, every right
// one raises no error, and not its code.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic_codes.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

constexpr std::string_view kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr std::string_view kBall = "sphere { }\n";

/// What an example needs around it.
struct Setting {
    parser::LoadLimits limits{};  // of the wrong example; what takes gigabytes is made small
    scene::FlattenLimits flatten{};
    scene::LintSettings lint{};
    std::vector<Companion> wrong_files{};
    std::vector<Companion> right_files{};
    std::string name = "main.lrs";
};

Setting setting_of(Code code) {
    Setting setting;
    const auto with_files = [&](std::vector<Companion> files) {
        setting.wrong_files = files;
        setting.right_files = std::move(files);
    };
    if (code == Code::E0003) {
        with_files({{"floor.png", std::string_view("\x89PNG\0", 5)}, {"floor.lrs", kBall}});
    } else if (code == Code::E0115) {
        setting.limits.nesting = 4;
    } else if (code == Code::E0118 || code == Code::E0604) {
        with_files({{"parts.lrs", kBall}});
    } else if (code == Code::E0512) {
        setting.limits.steps = 5;
    } else if (code == Code::E0513) {
        setting.flatten.primitives = 0;
        with_files({{"cloud.obj", kObj}});
    } else if (code == Code::E0514) {
        setting.limits.list_size = 100;
    } else if (code == Code::E0517) {
        setting.limits.printed_bytes = 200;
    } else if (code == Code::E0515) {
        setting.limits.include_depth = 1;
        setting.wrong_files = {{"level2.lrs", "include \"level3.lrs\"\n"}, {"level3.lrs", kBall}};
        setting.right_files = {{"level2.lrs", kBall}, {"level3.lrs", kBall}};
    } else if (code == Code::E0516) {
        setting.limits.mesh_bytes = kObj.size();
        with_files({{"whole-city.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n"},
                    {"one-street.obj", kObj}});
    } else if (code == Code::E0602) {
        setting.name = "a.lrs";
        with_files({{"b.lrs", kBall}});
    } else if (code == Code::E0703) {
        setting.wrong_files = {{"notes.png", "the hills behind the house"}};
        setting.right_files = {
            {"hills.png", std::string_view("P6 2 2 255\n\0\0\0___\xff\xff\xff___", 23)}};
    } else if (code == Code::E0705) {
        with_files({{"chair.blend", "BLENDER"}, {"chair.obj", kObj}});
    } else if (code == Code::W1502) {
        setting.lint.expects_light = true;
    } else if (code == Code::W1603) {
        with_files({{"meshes/bunny.obj", kObj}});
    } else if (code == Code::W1703) {
        // What is in a file tells its format: here one grey pixel, infinite and 1.
        setting.wrong_files = {{"sky.exr", std::string_view("Pf\n1 1\n-1\n\0\0\x80\x7f", 14)}};
        setting.right_files = {{"sky.exr", std::string_view("Pf\n1 1\n-1\n\0\0\x80\x3f", 14)}};
    } else {
        with_files({{"bunny.obj", kObj}});
    }
    return setting;
}

Loaded load_example(std::string_view example, const Setting& setting, bool is_wrong) {
    const TempDirectory directory;
    for (const Companion& file : is_wrong ? setting.wrong_files : setting.right_files) {
        directory.write(file.name, file.content);
    }
    std::string text(example);
    if (text.starts_with("v ")) {  // an OBJ file
        directory.write("model.obj", text);
        text = "mesh { file: \"model.obj\" }\n";
    }
    const bool is_nff = text.starts_with("b ");
    constexpr std::string_view kHome = "/home/me/scene";  // of the machine that the example is on
    if (const std::size_t home = text.find(kHome); home != text.npos) {
        text.replace(home, kHome.size(), directory.path());
    }
    const parser::LoadLimits limits = is_wrong ? setting.limits : parser::LoadLimits{};
    Loaded loaded = load_file(directory.write(is_nff ? "main.nff" : setting.name, text),
                              with_limits(limits), all_warnings());
    static_cast<void>(flatten_and_lint(loaded, is_wrong ? setting.flatten : scene::FlattenLimits{},
                                       setting.lint));
    return loaded;
}

TEST(Explain, WrongExamplesRaiseTheirCodeAlone) {
    for (const CodeInfo& info : code_infos()) {
        const Loaded loaded = load_example(info.wrong, setting_of(info.code), true);
        bool is_raised = false;
        for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
            const Code code = diagnostic->code;
            is_raised = is_raised || code == info.code;
            // An example has no camera, and may place nothing, when it is about something else.
            const bool is_beside_the_point = code == Code::W1501 || code == Code::W1503;
            EXPECT_TRUE(code == info.code || is_beside_the_point) << info.id << ":\n"
                                                                  << loaded.text();
        }
        EXPECT_TRUE(is_raised) << info.id << ":\n" << loaded.text();
    }
}

TEST(Explain, RightExamplesRaiseNeitherTheirCodeNorAnError) {
    for (const CodeInfo& info : code_infos()) {
        const Loaded loaded = load_example(info.right, setting_of(info.code), false);
        EXPECT_FALSE(loaded.has_errors()) << info.id << ":\n" << loaded.text();
        for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
            EXPECT_NE(diagnostic->code, info.code) << info.id << ":\n" << loaded.text();
        }
    }
}

}  // namespace
}  // namespace lray::test
