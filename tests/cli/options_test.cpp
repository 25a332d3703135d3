#include "cli/options.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "cli/option_table.h"
#include "tests/cli/parsed_options.h"

namespace lray::cli {
namespace {

TEST(Options, BriefCommandLine) {
    const Options options = parsed({"-n", "1", "-i", "scene.lrs", "-o", "image.ppm"});
    EXPECT_EQ(options.mode, Mode::render);
    EXPECT_EQ(options.level, 1u);
    EXPECT_EQ(options.scene_path, "scene.lrs");
    EXPECT_EQ(options.output_path, "image.ppm");
    EXPECT_EQ(options.format, image::Format::ppm);
    EXPECT_EQ(options.thread_count, 0u);
    EXPECT_EQ(options.max_errors, 20u);
    EXPECT_EQ(options.max_output_pixels, 268'435'456u);
    EXPECT_TRUE(options.warnings.empty());
}

TEST(Options, SceneWithoutItsOptionAnywhere) {
    EXPECT_EQ(parsed({"scene.lrs", "-o", "a.png"}).scene_path, "scene.lrs");
    EXPECT_EQ(parsed({"-o", "a.png", "scene.lrs"}).scene_path, "scene.lrs");
    EXPECT_EQ(parsed({"-o", "a.png", "-n", "1", "--", "-odd.lrs"}).scene_path, "-odd.lrs");
    EXPECT_EQ(parsed({"-", "-o", "a.png"}).scene_path, "-");
    EXPECT_EQ(parsed({"scene.lrs", "-o", "a.png"}).level, std::nullopt);
}

TEST(Options, OneOrTwoDashesAndEqualsSign) {
    for (const char* spelling : {"-threads", "--threads"}) {
        EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm", spelling, "3"}).thread_count, 3u);
    }
    EXPECT_EQ(parsed({"a.lrs", "-o=a.ppm", "--threads=3"}).thread_count, 3u);
    EXPECT_EQ(parsed({"a.lrs", "--o", "a.ppm", "--n", "1", "--ps", "1"}).level, 1u);
}

TEST(Options, LastOneGivenCounts) {
    const Options options = parsed({"-i", "a.lrs", "-o", "a.png", "--threads", "1", "-i", "b.lrs",
                                    "--threads", "2", "-o", "b.ppm"});
    EXPECT_EQ(options.scene_path, "b.lrs");
    EXPECT_EQ(options.output_path, "b.ppm");
    EXPECT_EQ(options.thread_count, 2u);
    EXPECT_EQ(options.format, image::Format::ppm);
}

TEST(Options, EveryValueReachesItsPlace) {
    const Options options = parsed({"a.lrs",    "-o",
                                    "a.ppm",    "--size",
                                    "640x480",  "--crop",
                                    "1,2,3,4",  "--camera",
                                    "top view", "--accel",
                                    "spheres",  "--quality",
                                    "high",     "--shading",
                                    "normals",  "--samples",
                                    "2:9",      "--seed",
                                    "123",      "--sampler",
                                    "random",   "--stats",
                                    "--quiet",  "--color",
                                    "never",    "--max-errors",
                                    "0",        "--format",
                                    "PNG",      "-I",
                                    "x",        "-I",
                                    "y",        "--allow",
                                    "z",        "--max-nesting",
                                    "1",        "--max-include-depth",
                                    "2",        "--max-files",
                                    "3",        "--max-scene-bytes",
                                    "4",        "--max-mesh-bytes",
                                    "5",        "--max-primitives",
                                    "6",        "--max-output-pixels",
                                    "7"});
    EXPECT_EQ(options.size, (scene::Resolution{640, 480}));
    ASSERT_TRUE(options.crop);
    EXPECT_EQ(options.crop->x0, 1u);
    EXPECT_EQ(options.crop->y0, 2u);
    EXPECT_EQ(options.crop->x1, 3u);
    EXPECT_EQ(options.crop->y1, 4u);
    EXPECT_EQ(options.camera_name, "top view");
    EXPECT_EQ(options.accel, bvh::AccelKind::spheres);
    EXPECT_EQ(options.quality, bvh::BuildQuality::high);
    EXPECT_EQ(options.shader, shade::Shader::normals);
    EXPECT_EQ(options.sample_range, (render::SampleRange{2, 9}));
    EXPECT_EQ(options.seed, 123u);
    EXPECT_EQ(options.sampler, SamplerKind::random);
    EXPECT_EQ(options.stats, StatsFormat::text);
    EXPECT_TRUE(options.quiet);
    EXPECT_EQ(options.color, ColorMode::never);
    EXPECT_EQ(options.max_errors, 0u);
    EXPECT_EQ(options.format, image::Format::png);
    EXPECT_EQ(options.include_directories, (std::vector<std::string>{"x", "y"}));
    EXPECT_EQ(options.allowed_directories, std::vector<std::string>{"z"});
    EXPECT_EQ(options.load_limits.nesting, 1u);
    EXPECT_EQ(options.load_limits.include_depth, 2u);
    EXPECT_EQ(options.load_limits.files, 3u);
    EXPECT_EQ(options.load_limits.scene_bytes, 4u);
    EXPECT_EQ(options.load_limits.mesh_bytes, 5u);
    EXPECT_EQ(options.flatten_limits.primitives, 6u);
    EXPECT_EQ(options.max_output_pixels, 7u);
}

TEST(Options, ModesNeedNoPicture) {
    EXPECT_EQ(parsed({"--help"}).mode, Mode::help);
    EXPECT_EQ(parsed({"--version"}).mode, Mode::version);
    EXPECT_EQ(parsed({"--check", "a.lrs"}).mode, Mode::check);
    EXPECT_EQ(parsed({"-n", "1", "a.lrs", "--check"}).mode, Mode::check);
    const Options explain = parsed({"--explain", "E0401"});
    EXPECT_EQ(explain.mode, Mode::explain);
    EXPECT_EQ(explain.explained, "E0401");
}

TEST(Options, LanguageOptionsReachTheirPlace) {
    const Options options = parsed({"a.lrs",     "-o",
                                    "a-##.ppm",  "-D",
                                    "n=2",       "-D",
                                    "lib.s=a=b", "-D",
                                    "e=",        "--frames",
                                    "0:7",       "--max-call-depth",
                                    "1",         "--max-list-size",
                                    "2",         "--max-nodes",
                                    "3",         "--max-printed-bytes",
                                    "4",         "--max-steps",
                                    "5",         "--max-value-bytes",
                                    "6"});
    ASSERT_EQ(options.definitions.size(), 3u);
    EXPECT_EQ(options.definitions[0].name, "n");
    EXPECT_EQ(options.definitions[0].value, "2");
    EXPECT_EQ(options.definitions[1].name, "lib.s");
    EXPECT_EQ(options.definitions[1].value, "a=b");
    EXPECT_EQ(options.definitions[2].value, "");
    EXPECT_EQ(options.frames, (FrameRange{0, 7}));
    EXPECT_EQ(options.load_limits.call_depth, 1u);
    EXPECT_EQ(options.load_limits.list_size, 2u);
    EXPECT_EQ(options.load_limits.nodes, 3u);
    EXPECT_EQ(options.load_limits.printed_bytes, 4u);
    EXPECT_EQ(options.load_limits.steps, 5u);
    EXPECT_EQ(options.load_limits.value_bytes, 6u);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm", "--frames", "1:2", "--frame", "5"}).frames,
              (FrameRange{5, 5}))
        << "the last one counts";
    EXPECT_EQ(parsed({"a.lrs", "--deps"}).mode, Mode::deps);
}

TEST(Options, WarningLevelsAreThoseGivenLast) {
    const auto levels =
        parsed({"a.lrs", "--check", "--deny", "warnings", "-A", "W1501", "-W", "no-area"})
            .warning_levels;
    EXPECT_EQ(levels[Code::W1301], WarningLevel::deny);
    EXPECT_EQ(levels[Code::W1501], WarningLevel::allow);
    EXPECT_EQ(levels[Code::W1201], WarningLevel::warn);
}

TEST(Options, SeveralFramesNeedANumberedNameAndASceneThatStays) {
    const Failure plain = failed({"a.lrs", "-o", "a.ppm", "--frames", "1:3"});
    EXPECT_EQ(plain.message, "`-o a.ppm` is one picture, for 3 frames");
    EXPECT_EQ(plain.help, "put #### where the number of the frame belongs, like `-o out-####.png`");
    EXPECT_EQ(failed({"a.lrs", "-o", "-", "--frames", "1:3"}).message,
              "`-o -` is one picture, for 3 frames");
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm", "--frames", "3:3"}).output_path, "a.ppm");
    EXPECT_EQ(failed({"-", "-o", "a#.ppm", "--frames", "1:3"}).message,
              "several frames need a scene that can be read again, not stdin");
    EXPECT_EQ(failed({"a.lrs", "--check", "--frames", "1:3", "--diagnostics", "sarif"}).message,
              "a SARIF log is about one frame");
}

TEST(Options, MachinesGetAllErrorsByDefault) {
    EXPECT_EQ(parsed({"a.lrs", "--check"}).max_errors, 20u);
    EXPECT_EQ(parsed({"a.lrs", "--check", "--diagnostics", "json"}).max_errors, 0u);
    EXPECT_EQ(parsed({"a.lrs", "--check", "--diagnostics=sarif", "--max-errors", "3"}).max_errors,
              3u);
}

TEST(Options, FormatByOptionThenExtensionThenStdout) {
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.PNG"}).format, image::Format::png);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.jpg"}).format, image::Format::jpg);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.jpeg"}).format, image::Format::jpg);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.pfm"}).format, image::Format::pfm);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.png", "--format", "ppm"}).format, image::Format::ppm);
    EXPECT_EQ(parsed({"a.lrs", "-o", "-"}).format, image::Format::ppm);
    EXPECT_EQ(parsed({"a.lrs", "-o", "-", "--format", "png"}).format, image::Format::png);
    EXPECT_EQ(failed({"a.lrs", "-o", "a.gif"}).message, "no picture format is called `gif`");
    EXPECT_EQ(failed({"a.lrs", "-o", "a"}).message, "`a` has no extension that names a format");
    EXPECT_NE(failed({"a.lrs", "-o", "a"}).help.find(".ppm, .png, .jpg, .pfm or .exr"),
              std::string::npos);
    EXPECT_EQ(failed({"a.lrs", "-o", "a", "--format", "gif"}).message,
              "`--format` takes ppm, png, jpg, pfm, exr or film, not `gif`");
}

TEST(Options, BitsAndQualityAreOfTheirFormats) {
    const Options deep = parsed({"a.lrs", "-o", "a.png", "--png-bits", "16"});
    EXPECT_EQ(deep.png_bits, image::PngBits::sixteen);
    EXPECT_TRUE(deep.warnings.empty());
    const Options small = parsed({"a.lrs", "-o", "a.jpg", "--jpeg-quality", "1"});
    EXPECT_EQ(small.jpeg_quality, 1);
    EXPECT_TRUE(small.warnings.empty());
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.jpg", "--png-bits=16"}).warnings,
              std::vector<std::string>{"`--png-bits` is ignored: the picture is jpg, not png"});
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.png", "--jpeg-quality=5"}).warnings,
              std::vector<std::string>{"`--jpeg-quality` is ignored: the picture is png, not jpg"});
    EXPECT_EQ(failed({"a.lrs", "-o", "a.png", "--png-bits", "12"}).message,
              "`--png-bits` takes 8 or 16, not `12`");
    EXPECT_NE(failed({"a.lrs", "-o", "a.jpg", "--jpeg-quality", "101"}).message, "");
    EXPECT_NE(failed({"a.lrs", "-o", "a.jpg", "--jpeg-quality", "0"}).message, "");
}

TEST(Options, OpenExrIsWrittenOrRefusedBeforeAnything) {
    if (image::is_built(image::Format::exr)) {
        EXPECT_EQ(parsed({"a.lrs", "-o", "a.EXR"}).format, image::Format::exr);
        return;
    }
    for (const std::vector<const char*>& arguments :
         {std::vector<const char*>{"a.lrs", "-o", "a.exr"}, {"a.lrs", "--format", "exr"}}) {
        const auto result = parse_options(arguments);
        const Failure& failure = std::get<Failure>(result);
        EXPECT_EQ(failure.exit_code, ExitCode::unbuilt);
        EXPECT_EQ(failure.message, "this lray was built without OpenEXR");
    }
}

TEST(Options, CommandsTakeTheirFilesAndTheirOptions) {
    const Options diff = parsed({"diff", "a.png", "b.exr", "--threshold", "0.25"});
    EXPECT_EQ(diff.mode, Mode::diff);
    EXPECT_EQ(diff.paths, (std::vector<std::string>{"a.png", "b.exr"}));
    EXPECT_EQ(diff.threshold, 0.25f);
    EXPECT_EQ(parsed({"diff", "a", "b"}).threshold, 1.5f);
    EXPECT_EQ(parsed({"diff", "a", "b", "-o", "c.png"}).format, image::Format::png);
    EXPECT_EQ(parsed({"diff", "--", "-a", "-b"}).paths, (std::vector<std::string>{"-a", "-b"}));
    EXPECT_EQ(parsed({"diff", "--help"}).mode, Mode::help);
    EXPECT_EQ(failed({"diff", "a"}).message, "`lray diff` takes two pictures, not 1");
    EXPECT_EQ(failed({"diff", "a", "b", "c"}).message, "`lray diff` takes two pictures, not 3");
    EXPECT_EQ(failed({"diff", "a", ""}).message, "a file name is empty");
    EXPECT_EQ(failed({"diff", "a", "b", "--size", "1x1"}).message,
              "`lray diff` has no option `--size`");
    EXPECT_EQ(failed({"diff", "a", "-i", "b"}).message, "`lray diff` has no option `-i`");
    for (const char* threshold : {"-1", "256", "nan", "x"}) {
        EXPECT_NE(failed({"diff", "a", "b", "--threshold", threshold}).message, "");
    }
    EXPECT_EQ(failed({"a.lrs", "--threshold", "1"}).message,
              "`--threshold` is an option of `lray diff`");
    // A scene may be called like a command.
    EXPECT_EQ(parsed({"-i", "diff", "-o", "a.png"}).scene_path, "diff");
    EXPECT_EQ(parsed({"./diff", "-o", "a.png"}).scene_path, "./diff");
    EXPECT_NE(help_text().find("diff A B"), std::string::npos);
}

TEST(Options, AbbreviationsAreRefusedWithTheWholeName) {
    EXPECT_EQ(failed({"--thr", "4"}).message, "unknown option `--thr`");
    EXPECT_EQ(failed({"--thr", "4"}).help, "did you mean `--threshold` or `--threads`?");
    EXPECT_EQ(failed({"-thr=4"}).message, "unknown option `-thr`");
    EXPECT_EQ(failed({"--max"}).help,
              "did you mean `--max-errors`, `--max-nesting` or `--max-include-depth`?");
    EXPECT_EQ(failed({"--p", "4"}).help, "did you mean `-ps` or `--png-bits`?");
}

TEST(Options, SlipsAreUnderstood) {
    EXPECT_EQ(failed({"--thraeds", "4"}).help, "did you mean `--threads`?");
    EXPECT_EQ(failed({"--colour=never"}).message, "unknown option `--colour`");
    EXPECT_EQ(failed({"--colour=never"}).help, "did you mean `--color`?");
    EXPECT_EQ(failed({"-sp", "4"}).help, "did you mean `--spp`?");
    EXPECT_EQ(failed({"--zzzzzz"}).help, "`lray --help` shows all options");
}

TEST(Options, MissingAndSuperfluousValues) {
    EXPECT_EQ(failed({"a.lrs", "-o"}).message, "`-o` needs a value: `-o FILE`");
    EXPECT_EQ(failed({"--size"}).message, "`--size` needs a value: `--size WxH`");
    EXPECT_EQ(failed({"--quiet=3"}).message, "`--quiet` takes no value");
    EXPECT_EQ(failed({"-o", ""}).message, "`-o` needs a file name, not an empty text");
    EXPECT_EQ(failed({""}).message, "the scene's file name is empty");
}

TEST(Options, WrongValuesSayWhatIsTaken) {
    EXPECT_EQ(failed({"-n", "4"}).message, "`-n` takes a level, 1, 2 or 3, not `4`");
    EXPECT_EQ(failed({"-ps", "0"}).message, "`-ps` takes a whole number from 1 to 32768, not `0`");
    EXPECT_EQ(failed({"-ps", "32769"}).message,
              "`-ps` takes a whole number from 1 to 32768, not `32769`");
    EXPECT_EQ(failed({"--threads", "-1"}).message,
              "`--threads` takes a whole number from 0 to 1024, not `-1`");
    EXPECT_EQ(failed({"--max-files", "2k"}).message,
              "`--max-files` takes a whole number from 1, not `2k`");
    EXPECT_EQ(failed({"--max-scene-bytes", "99999999999999999999"}).message,
              "`--max-scene-bytes` takes a whole number from 1 to 18446744073709551615, not "
              "`99999999999999999999`");
    EXPECT_EQ(failed({"--color", "blue"}).message,
              "`--color` takes auto, always or never, not `blue`");
    EXPECT_EQ(failed({"--deny", "no-camra"}).message,
              "`--deny` takes the code or the name of a warning, not `no-camra`; did you mean "
              "`no-camera`?");
    EXPECT_EQ(failed({"--diagnostics", "xml"}).message,
              "`--diagnostics` takes text, json or sarif, not `xml`");
    for (const char* definition : {"n", "=3", ""}) {
        EXPECT_EQ(
            failed({"-D", definition}).message,
            std::string("`-D` takes a name and a value like `n=200`, not `") + definition + "`");
    }
    EXPECT_EQ(failed({"--frame", "-1"}).message,
              "`--frame` takes a whole number from 0 to 1000000000, not `-1`");
    for (const char* frames : {"3", "3:", ":3", "a:b", "1:2:3", "-1:2"}) {
        EXPECT_EQ(failed({"--frames", frames}).message,
                  std::string("`--frames` takes the first and the last frame like `0:95`, not `") +
                      frames + "`");
    }
    EXPECT_EQ(failed({"--frames", "3:2"}).message, "`--frames` `3:2` ends before it begins");
    EXPECT_EQ(failed({"--accel", "kd"}).message,
              "`--accel` takes none, spheres or boxes, not `kd`");
    EXPECT_EQ(failed({"--quality", "best"}).message,
              "`--quality` takes low, medium or high, not `best`");
    EXPECT_EQ(failed({"--shading", "phong"}).message,
              "`--shading` takes full, flat, normals, uv, depth or cost, not `phong`");
    EXPECT_EQ(failed({"--stats=3"}).message, "`--stats` takes nothing or json, not `3`");
    EXPECT_EQ(failed({"--seed", "-3"}).message, "`--seed` takes a whole number from 0, not `-3`");
    EXPECT_EQ(failed({"--seed", "18446744073709551616"}).message,
              "`--seed` takes a whole number from 0 to 18446744073709551615, not "
              "`18446744073709551616`");
    for (const char* range : {"3", "3:", ":3", "a:b", "1:2:3", "-1:2", "0:32769"}) {
        EXPECT_EQ(failed({"--samples", range}).message,
                  std::string("`--samples` takes the first sample and the one behind the last like "
                              "`0:16`, up to 32768, not `") +
                      range + "`");
    }
    for (const char* range : {"3:3", "3:2"}) {
        EXPECT_EQ(
            failed({"--samples", range}).message,
            std::string("`--samples` `") + range + "` holds no sample: A must be less than B");
    }
    for (const char* size :
         {"800", "800x", "x600", "0x600", "800x600x3", "8 x 6", "2147483648x1"}) {
        EXPECT_EQ(failed({"--size", size}).message,
                  std::string("`--size` takes a width and a height in pixels like `800x600`, "
                              "not `") +
                      size + "`");
    }
    for (const char* crop : {"", "1,2,3", "1,2,3,4,5", "1,2,3,", "a,b,c,d", "-1,0,2,2"}) {
        EXPECT_EQ(failed({"--crop", crop}).message,
                  std::string("`--crop` takes four pixel positions X0,Y0,X1,Y1 like "
                              "`0,0,320,240`, not `") +
                      crop + "`");
    }
    EXPECT_EQ(failed({"--crop", "3,0,3,4"}).message,
              "`--crop` `3,0,3,4` holds no pixel: X0 must be less than X1 and Y0 less than Y1");
}

TEST(Options, TheWindowIsLevelThreeOrNoOutput) {
    EXPECT_EQ(parsed({"a.lrs"}).mode, Mode::window);
    EXPECT_EQ(parsed({"-n", "3", "-i", "a.lrs"}).mode, Mode::window);
    EXPECT_EQ(parsed({"-n", "3", "a.lrs", "-o", "a.jpg"}).mode, Mode::window);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm"}).mode, Mode::render);
    EXPECT_EQ(parsed({"-n", "2", "a.lrs", "-o", "a.ppm"}).mode, Mode::render);
    EXPECT_EQ(parsed({"--check", "a.lrs"}).mode, Mode::check);
}

TEST(Options, TheWindowUsesBoxesAndRandomPositionsAndSavesPng) {
    const Options window = parsed({"-n", "3", "a.lrs"});
    EXPECT_EQ(window.accel, bvh::AccelKind::boxes);
    EXPECT_EQ(window.position, render::PixelPosition::random);
    EXPECT_EQ(window.format, image::Format::png);
    EXPECT_EQ(parsed({"a.lrs", "--accel", "spheres"}).accel, bvh::AccelKind::spheres);
    EXPECT_EQ(parsed({"-n", "3", "a.lrs", "-o", "a.jpg"}).format, image::Format::jpg);
}

TEST(Options, TheWindowShowsOneFrameAndSavesToFiles) {
    EXPECT_EQ(failed({"a.lrs", "--frames", "1:3"}).message, "a window shows one frame");
    EXPECT_EQ(parsed({"a.lrs", "--frame", "2"}).mode, Mode::window);
    EXPECT_EQ(failed({"-n", "3", "a.lrs", "-o", "-"}).message, "a window cannot save to stdout");
    EXPECT_NE(failed({"-n", "3", "a.lrs", "-o", "a.gif"}).message.find("gif"), std::string::npos);
}

TEST(Options, LevelTwoWithoutOutputShowsTheFix) {
    const Failure failure = failed({"-n", "2", "-ps", "4", "-i", "a.lrs"});
    EXPECT_EQ(failure.message, "level 2 writes a picture; say where with `-o`");
    EXPECT_EQ(failure.help, "lray -n 2 -i a.lrs -o a.ppm");
}

TEST(Options, ALevelIsASetOfDefaults) {
    const Options first = parsed({"-n", "1", "a.lrs", "-o", "a.ppm"});
    EXPECT_EQ(first.accel, bvh::AccelKind::none);
    EXPECT_EQ(first.position, render::PixelPosition::center);
    const Options second = parsed({"-n", "2", "-ps", "16", "a.lrs", "-o", "a.ppm"});
    EXPECT_EQ(second.accel, bvh::AccelKind::spheres);
    EXPECT_EQ(second.position, render::PixelPosition::random);
    EXPECT_EQ(second.samples, 16u);
    EXPECT_TRUE(second.warnings.empty());
    const Options none_given = parsed({"a.lrs", "-o", "a.ppm"});
    EXPECT_EQ(none_given.accel, bvh::AccelKind::boxes);
    EXPECT_EQ(none_given.position, render::PixelPosition::random);
    EXPECT_FALSE(none_given.shader) << "the scene decides";
    EXPECT_FALSE(second.shader);
    EXPECT_EQ(first.shader, shade::Shader::flat);
}

TEST(Options, WhatIsGivenByHandOverridesTheLevel) {
    EXPECT_EQ(parsed({"-n", "1", "a.lrs", "-o", "a.ppm", "--accel", "boxes"}).accel,
              bvh::AccelKind::boxes);
    EXPECT_EQ(parsed({"--accel", "none", "-n", "2", "a.lrs", "-o", "a.ppm"}).accel,
              bvh::AccelKind::none);
    EXPECT_EQ(parsed({"--accel", "none", "a.lrs", "-o", "a.ppm"}).accel, bvh::AccelKind::none);
    EXPECT_EQ(parsed({"-n", "1", "a.lrs", "-o", "a.ppm", "--shading", "cost"}).shader,
              shade::Shader::cost);
    EXPECT_EQ(parsed({"-n", "1", "a.lrs", "-o", "a.ppm", "--shading", "full"}).shader,
              shade::Shader::full);
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm", "--shading", "uv"}).shader, shade::Shader::uv);
}

TEST(Options, WordsThatAreMisspeltOrShortenedAreSuggested) {
    EXPECT_EQ(failed({"--accel", "sphere"}).message,
              "`--accel` takes none, spheres or boxes, not `sphere`; did you mean `spheres`?");
    EXPECT_EQ(failed({"--accel", "box"}).message,
              "`--accel` takes none, spheres or boxes, not `box`; did you mean `boxes`?");
    EXPECT_EQ(failed({"--quality", "hihg"}).message,
              "`--quality` takes low, medium or high, not `hihg`; did you mean `high`?");
    EXPECT_EQ(failed({"--shading", "normal"}).message,
              "`--shading` takes full, flat, normals, uv, depth or cost, not `normal`; did you "
              "mean `normals`?");
    EXPECT_EQ(failed({"--accel", ""}).message, "`--accel` takes none, spheres or boxes, not ``");
}

TEST(Options, StatsMayNameAForm) {
    EXPECT_EQ(parsed({"a.lrs", "-o", "a.ppm"}).stats, StatsFormat::none);
    EXPECT_EQ(parsed({"--stats", "a.lrs", "-o", "a.ppm"}).stats, StatsFormat::text);
    EXPECT_EQ(parsed({"--stats=json", "a.lrs", "-o", "a.ppm"}).stats, StatsFormat::json);
}

TEST(Options, LevelOneWithoutOutputShowsTheFix) {
    const Failure failure = failed({"-n", "1", "-i", "a b.lrs"});
    EXPECT_EQ(failure.message, "level 1 writes a picture; say where with `-o`");
    EXPECT_EQ(failure.help, "lray -n 1 -i 'a b.lrs' -o 'a b.ppm'");
    EXPECT_EQ(failed({"-n", "1", "-"}).help, "lray -n 1 -i - -o image.ppm");
}

TEST(Options, FormattingTakesSeveralScenes) {
    const Options options = parsed({"a.lrs", "--fmt", "-i", "b.lrs", "-", "--", "-c.lrs"});
    EXPECT_EQ(options.mode, Mode::format);
    EXPECT_FALSE(options.only_lists_unformatted);
    EXPECT_EQ(options.paths, (std::vector<std::string>{"a.lrs", "b.lrs", "-", "-c.lrs"}));
    EXPECT_TRUE(parsed({"--fmt", "--check", "a.lrs"}).only_lists_unformatted);
    EXPECT_TRUE(parsed({"--check", "a.lrs", "--fmt"}).only_lists_unformatted);
    EXPECT_EQ(parsed({"--fmt", "a.lrs", "--help"}).mode, Mode::help);
    EXPECT_EQ(failed({"--fmt"}).message, "no scene is given");
    EXPECT_EQ(failed({"--fmt", "a.lrs", "b.lrs", "-o", "c.lrs"}).message,
              "`-o` takes one scene, not 2");
    EXPECT_EQ(failed({"--fmt", "--check", "a.lrs", "-o", "c.lrs"}).message,
              "`--fmt --check` writes nothing; leave `-o` out");
}

TEST(Options, NoSceneOrTwoScenes) {
    EXPECT_EQ(failed({}).message, "no scene is given");
    EXPECT_EQ(failed({}).help, "lray -n 1 -i scene.lrs -o image.ppm");
    EXPECT_EQ(failed({"--check"}).message, "no scene is given");
    EXPECT_EQ(failed({"a.lrs", "b.lrs"}).message, "two scenes are given, `a.lrs` and `b.lrs`");
    EXPECT_EQ(failed({"-i", "a.lrs", "b.lrs"}).message,
              "two scenes are given, `a.lrs` and `b.lrs`");
    EXPECT_EQ(failed({"b.lrs", "-i", "a.lrs"}).message,
              "two scenes are given, `b.lrs` and `a.lrs`");
}

TEST(Options, QualityOfWhatIsNoBoxesWarns) {
    const std::vector<std::vector<const char*>> choices{
        {"-n", "1"}, {"-n", "2"}, {"--accel", "spheres"}};
    for (const auto& choice : choices) {
        const Options options =
            parsed({choice[0], choice[1], "--quality", "high", "a.lrs", "-o", "a.ppm"});
        ASSERT_EQ(options.warnings.size(), 1u);
        EXPECT_EQ(options.warnings[0],
                  "`--quality` is ignored: only boxes have a choice; `--accel boxes` builds them");
    }
    EXPECT_TRUE(parsed({"--quality", "high", "a.lrs", "-o", "a.ppm"}).warnings.empty());
    EXPECT_TRUE(parsed({"-n", "2", "--quality", "high", "--accel", "boxes", "a.lrs", "-o", "a.ppm"})
                    .warnings.empty());
}

TEST(Options, NamesAreUniqueAndAllAreInTheHelp) {
    const std::string help = help_text();
    std::set<std::string_view> names;
    for (const OptionGroup& group : option_groups()) {
        EXPECT_NE(help.find(group.title), std::string::npos);
        for (const OptionSpec& spec : group.options) {
            EXPECT_TRUE(names.insert(spec.name).second) << spec.name;
            EXPECT_NE(help.find(spelled(spec.name)), std::string::npos) << spec.name;
        }
    }
    EXPECT_EQ(spelled("ps"), "-ps");
    EXPECT_EQ(spelled("spp"), "--spp");
}

}  // namespace
}  // namespace lray::cli
