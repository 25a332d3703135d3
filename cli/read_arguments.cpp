// With getopt_long_only, which alone takes `-ps 16`; the abbreviations that it would accept are
// refused.
#include "cli/read_arguments.h"

#include <fmt/format.h>
#include <getopt.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/option_table.h"
#include "cli/option_values.h"

namespace lray::cli {

namespace {

constexpr std::size_t kMaxSuggestions = 3;

std::vector<const OptionSpec*> all_specs() {
    std::vector<const OptionSpec*> specs;
    for (const OptionGroup& group : option_groups()) {
        for (const OptionSpec& spec : group.options) specs.push_back(&spec);
    }
    return specs;
}

/// "--thread=4" -> "thread".
std::string_view name_of(std::string_view argument) {
    argument.remove_prefix(argument.starts_with("--") ? 2 : 1);
    return argument.substr(0, argument.find('='));
}

Failure unknown_option(std::string_view argument, std::span<const OptionSpec* const> specs) {
    const std::string_view name = name_of(argument);
    std::vector<std::string_view> names;
    for (const OptionSpec* spec : specs) names.emplace_back(spec->name);
    std::vector<std::string_view> meant = meant_names(name, names);
    if (meant.size() > kMaxSuggestions) meant.resize(kMaxSuggestions);
    std::string message =
        fmt::format("unknown option `{}`", argument.substr(0, argument.find('=')));
    if (meant.empty()) return usage_error(std::move(message));
    std::string help = "did you mean ";
    for (std::size_t i = 0; i < meant.size(); ++i) {
        const bool is_last = i + 1 == meant.size();
        const char* const joint = i == 0 ? "" : is_last ? " or " : ", ";
        help += fmt::format("{}`{}`", joint, spelled(meant[i]));
    }
    return usage_error(std::move(message), help + "?");
}

/// Walks over the arguments with getopt; fills in what each says by itself.
class ArgumentReader {
 public:
    /// The arguments of a command are those behind its name.
    ArgumentReader(std::span<const char* const> arguments, const Command* command)
        : specs_(all_specs()), command_(command) {
        arguments_.push_back(program_name_.data());
        // getopt's interface asks for char*, but it writes only when it permutes, which the "-" in
        // its option string turns off.
        for (const char* argument : arguments) arguments_.push_back(const_cast<char*>(argument));
        count_ = static_cast<int>(arguments_.size());
        arguments_.push_back(nullptr);
        for (std::size_t i = 0; i < specs_.size(); ++i) {
            const int has_value = specs_[i]->may_take_value() ? optional_argument
                                  : specs_[i]->takes_value()  ? required_argument
                                                              : no_argument;
            table_.push_back(
                {specs_[i]->name, has_value, nullptr, kFirstSpec + static_cast<int>(i)});
        }
        table_.push_back({nullptr, 0, nullptr, 0});
    }

    std::optional<Failure> read(Options& options) {
        opterr = 0;
        optind = 0;  // starts glibc's scanner anew
        for (int at = 1;; at = optind) {
            const int found =
                getopt_long_only(count_, arguments_.data(), "-:", table_.data(), nullptr);
            if (found == -1) break;
            const std::string_view argument = arguments_[static_cast<std::size_t>(at)];
            std::optional<Failure> failure = found == kPlainArgument
                                                 ? take_scene(options, argument)
                                                 : take_option(options, argument, found);
            if (failure) return failure;
        }
        for (; optind < count_; ++optind) {  // after `--`
            if (auto failure = take_scene(options, arguments_[static_cast<std::size_t>(optind)])) {
                return failure;
            }
        }
        // Only now it is known whether there may be several.
        return options.is_formatting || command_ != nullptr ? std::nullopt : too_many_scenes_;
    }

 private:
    static constexpr int kPlainArgument = 1;  // getopt's value for what is not an option
    static constexpr int kFirstSpec = 1000;   // beyond any character

    std::optional<Failure> take_scene(Options& options, std::string_view argument) {
        if (argument.empty()) {
            return usage_error(command_ == nullptr ? "the scene's file name is empty"
                                                   : "a file name is empty");
        }
        options.paths.emplace_back(argument);
        if (!options.scene_path.empty()) {
            if (!too_many_scenes_) too_many_scenes_ = two_scenes(options.scene_path, argument);
            return std::nullopt;
        }
        is_scene_plain_ = true;
        options.scene_path = argument;
        return std::nullopt;
    }

    static Failure two_scenes(std::string_view first, std::string_view second) {
        return usage_error(fmt::format("two scenes are given, `{}` and `{}`", first, second),
                           "one at a time; a name with spaces needs quotes");
    }

    std::optional<Failure> take_option(Options& options, std::string_view argument, int found) {
        // getopt takes any unambiguous beginning of a name; only whole names count here.
        const auto same_name = [&](const OptionSpec* spec) {
            return spec->name == name_of(argument);
        };
        const auto spec = std::find_if(specs_.begin(), specs_.end(), same_name);
        if (spec == specs_.end()) return unknown_option(argument, specs_);
        const std::string name = spelled((*spec)->name);
        if (command_ != nullptr && !takes_option(*command_, (*spec)->name)) {
            return usage_error(fmt::format("`lray {}` has no option `{}`", command_->name, name));
        }
        if (found == ':') {
            return usage_error(
                fmt::format("`{}` needs a value: `{} {}`", name, name, (*spec)->value));
        }
        if (found == '?') return usage_error(fmt::format("`{}` takes no value", name));
        const std::string scene_before = options.scene_path;
        std::string wrong = (*spec)->apply(options, optarg != nullptr ? optarg : "");
        if (!wrong.empty()) return usage_error(fmt::format("`{}` {}", name, wrong));
        // The last -i counts, but a scene without its option is never given up for another.
        if (is_scene_plain_ && options.scene_path != scene_before) {
            if (!too_many_scenes_) too_many_scenes_ = two_scenes(scene_before, options.scene_path);
        }
        if (options.scene_path != scene_before) {
            options.paths.push_back(options.scene_path);
        }
        return std::nullopt;
    }

    std::vector<const OptionSpec*> specs_;
    const Command* command_ = nullptr;
    std::string program_name_ = "lray";
    std::vector<char*> arguments_;
    std::vector<option> table_;
    bool is_scene_plain_ = false;
    std::optional<Failure> too_many_scenes_{};
    int count_ = 0;
};

}  // namespace

Failure usage_error(std::string message, std::string help) {
    return {ExitCode::usage, std::move(message), std::move(help)};
}

std::optional<Failure> read_arguments(std::span<const char* const> arguments,
                                      const Command* command, Options& options) {
    return ArgumentReader(arguments, command).read(options);
}

}  // namespace lray::cli
