#include "cli/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/diagnostic_codes.h"
#include "base/did_you_mean.h"
#include "cli/console.h"
#include "cli/explain_topics.h"
#include "cli/option_table.h"
#include "parser/blocks/schema.h"
#include "parser/builtins/builtins.h"
#include "parser/reference.h"

namespace lray::cli {

namespace {

std::string explain_code(const CodeInfo& info) {
    std::string text = fmt::format("{}: {}\n\n{}\n", info.id, info.title, info.explanation);
    const auto add_example = [&](std::string_view title, std::string_view example) {
        if (example.empty()) return;
        text += fmt::format("\n{}:\n\n", title);
        while (!example.empty()) {
            const std::string_view line = example.substr(0, example.find('\n'));
            text += fmt::format("{}{}\n", line.empty() ? "" : "    ", line);
            example.remove_prefix(std::min(line.size() + 1, example.size()));
        }
    };
    add_example("Wrong", info.wrong);
    add_example("Right", info.right);
    if (is_warning(info)) {
        text += fmt::format("\nSilence it with `-A {}`; make it an error with `--deny {}`.\n",
                            slug(info), slug(info));
    }
    return text;
}

std::string explain_limits() {
    std::string text =
        "What a scene may take is limited, so that one from a stranger neither hangs nor fills "
        "this\n"
        "machine. A message that meets a limit names the option that raises it.\n\n";
    const Options defaults;
    for (const OptionGroup& group : option_groups()) {
        for (const OptionSpec& spec : group.options) {
            if (spec.value_of == nullptr) continue;
            text += fmt::format("  {:<22} {:>13}  {}\n", spelled(spec.name),
                                spec.value_of(defaults), spec.help);
        }
    }
    return text;
}

std::string list_codes(bool warnings_only) {
    std::string text;
    for (const CodeInfo& info : code_infos()) {
        if (!is_warning(info)) {
            if (!warnings_only) text += fmt::format("  {}  {}\n", info.id, info.title);
            continue;
        }
        text += fmt::format("  {}  {}{}\n", info.id, slug(info), info.is_on ? "" : " (off)");
    }
    return text;
}

/// Words in lines of at most 78 columns.
std::string in_lines(const std::vector<std::string_view>& words) {
    constexpr std::size_t kWidth = 78;
    std::string text;
    std::size_t width = kWidth;  // of the last line
    for (const std::string_view word : words) {
        const bool is_full = width + 1 + word.size() > kWidth;
        if (is_full && !text.empty()) text += '\n';
        width = is_full ? 2 + word.size() : width + 1 + word.size();
        text += fmt::format("{}{}", is_full ? "  " : " ", word);
    }
    return text + "\n";
}

std::vector<std::string_view> block_names() {
    std::vector<std::string_view> names;
    for (const parser::BlockSchema& block : parser::block_schemas()) names.push_back(block.name);
    return names;
}

std::vector<std::string_view> function_names() {
    std::vector<std::string_view> names;
    for (const parser::Builtin& builtin : parser::builtins()) names.push_back(builtin.name);
    return names;
}

/// Topics whose text is made from tables.
struct MadeTopic {
    std::string_view name{};
    std::string_view title{};
    std::string (*text)() = nullptr;
};

std::string list_topics();

constexpr MadeTopic kMadeTopics[] = {
    {"codes", "all codes of errors and warnings", [] { return list_codes(false); }},
    {"limits", "what a scene may take, and the options that change it", explain_limits},
    {"topics", "this list", list_topics},
    {"warnings", "the names that -W, -A and --deny take", [] { return list_codes(true); }},
};

std::string list_topics() {
    std::string text = "`--explain` takes a code like E0401, or one of these words.\n\nTopics:\n\n";
    for (const Topic& topic : topics()) {
        text += fmt::format("  {:<12} {}\n", topic.name, topic.title);
    }
    for (const MadeTopic& topic : kMadeTopics) {
        text += fmt::format("  {:<12} {}\n", topic.name, topic.title);
    }
    return fmt::format("{}\nBlocks:\n\n{}\nFunctions:\n\n{}", text, in_lines(block_names()),
                       in_lines(function_names()));
}

/// "E4001"
bool looks_like_code(std::string_view word) {
    return word.size() > 1 && std::string_view("EWew").find(word[0]) != word.npos &&
           word.find_first_not_of("0123456789", 1) == word.npos;
}

std::optional<std::string> explain_topic(std::string_view word) {
    for (const Topic& topic : topics()) {
        if (topic.name == word) return std::string(topic.text);
    }
    for (const MadeTopic& topic : kMadeTopics) {
        if (topic.name == word) return topic.text();
    }
    return std::nullopt;
}

std::optional<std::string> find_explanation(std::string_view word) {
    if (const auto code = find_code(word)) return explain_code(code_info(*code));
    for (const CodeInfo& info : code_infos()) {
        if (is_warning(info) && slug(info) == word) return explain_code(info);
    }
    // A word may be more than one of these: `reflect` is a function, and a topic may come to be.
    std::string text;
    for (const auto& part :
         {explain_topic(word), parser::describe_block(word), parser::describe_function(word)}) {
        if (!part) continue;
        if (!text.empty()) text += '\n';
        text += *part;
    }
    return text.empty() ? std::nullopt : std::optional(std::move(text));
}

}  // namespace

std::vector<std::string_view> explained_words() {
    std::vector<std::string_view> words;
    for (const Topic& topic : topics()) words.push_back(topic.name);
    for (const MadeTopic& topic : kMadeTopics) words.push_back(topic.name);
    for (const std::string_view name : block_names()) words.push_back(name);
    for (const std::string_view name : function_names()) words.push_back(name);
    return words;
}

ExitCode explain(std::string_view word) {
    if (const auto text = find_explanation(word)) return print_requested(*text);
    std::vector<std::string_view> words;
    for (const CodeInfo& info : code_infos()) words.push_back(info.id);
    if (!looks_like_code(word)) words = explained_words();
    std::string help = did_you_mean(word, words);
    if (help.empty()) help = "`lray --explain topics` lists what there is";
    const std::string_view kind =
        looks_like_code(word) ? "there is no code" : "there is nothing to explain called";
    return report_failure({ExitCode::usage, fmt::format("{} `{}`", kind, word), std::move(help)});
}

}  // namespace lray::cli
