#include "scene/formats/obj_names.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "base/did_you_mean.h"
#include "base/parse_number.h"
#include "scene/formats/obj_scanner.h"

namespace lray::scene::obj {

namespace {

bool ends_a_file_name(std::string_view word) {
    constexpr std::string_view kEnding = ".mtl";
    return word.size() >= kEnding.size() &&
           edit_distance(word.substr(word.size() - kEnding.size()), kEnding, 0) == 0;
}

}  // namespace

std::string name_at(const char* statement) {
    std::string name;
    for (const char* at = skip_blanks(skip_token(statement)); !is_line_end(*at);
         at = skip_blanks(at)) {
        const char* const begin = at;
        at = skip_token(at);
        if (!name.empty()) name += ' ';
        name.append(begin, at);
    }
    return name;
}

std::vector<std::string> files_at(const char* statement) {
    std::vector<std::string> files;
    std::string file;
    const auto skip_word = [](const char* at) {
        while (!is_blank(*at) && !is_line_end(*at)) ++at;
        return at;
    };
    const char* at = skip_word(statement);
    while (true) {
        const char* word = at;
        while (is_blank(*word)) ++word;
        if (is_line_end(*word)) break;
        if (!file.empty()) file.append(at, word);
        at = skip_word(word);
        file.append(word, at);
        if (ends_a_file_name({word, static_cast<std::size_t>(at - word)})) {
            files.push_back(std::move(file));
            file.clear();
        }
    }
    if (!file.empty()) files.push_back(std::move(file));
    return files;
}

std::uint32_t smoothing_group_at(const char* statement) {
    const char* at = skip_blanks(skip_token(statement));
    if (is_line_end(*at)) return 0;
    const std::string_view word(at, static_cast<std::size_t>(skip_token(at) - at));
    if (word == "off") return 0;
    std::uint64_t group = 0;
    DigitRun run;
    do {
        run = read_digit_run(at);
        at += run.count;
        group = std::min<std::uint64_t>(group * kRunPowersOfTen[run.count] + run.value,
                                        std::numeric_limits<std::uint32_t>::max());
    } while (run.count == kMaxDigitRun);
    return is_token_end(at) ? static_cast<std::uint32_t>(group) : 1;  // `on`
}

}  // namespace lray::scene::obj
