#include "scene/formats/obj_mistakes.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/formats/obj_scanner.h"
#include "scene/formats/token_words.h"

namespace lray::scene::obj {

namespace {

std::string_view text_between(const char* begin, const char* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

void Mistakes::wrong_number(const char* statement, const char* begin, std::size_t found_count,
                            std::string_view needed) {
    ++count_;
    if (!are_told()) return;
    if (is_line_end(*begin) || *begin == '#') {
        const std::string_view keyword = text_between(statement, skip_token(statement));
        too_few(statement, begin,
                needed == "1" ? fmt::format("`{}` needs a number", keyword)
                              : fmt::format("`{}` needs {} numbers", keyword, needed),
                found_count);
        return;
    }
    tell(Code::E0701, begin, skip_token(begin), wrong_number_text(token_at(begin)));
}

void Mistakes::wrong_corner(const char* statement, const char* at) {
    ++count_;
    if (!are_told()) return;
    while (at > statement && !is_blank(at[-1]) && !is_line_end(at[-1])) --at;
    tell(Code::E0701, at, skip_token(at),
         fmt::format("expected a corner like `1`, `1/2`, `1//3` or `1/2/3`, found {}",
                     quoted_token(token_at(at))));
}

void Mistakes::wrong_index(const char* begin, const char* end, IndexKind kind, std::size_t so_far,
                           std::size_t total) {
    ++count_;
    if (!are_told()) return;
    const std::string_view index = text_between(begin, end);
    std::string message;
    if (index.find_first_not_of("-0") == index.npos) {
        message = fmt::format("{} {}: indices start at 1", kind.name, index);
    } else if (total == 0) {
        message = fmt::format("{} {}, but this file has no {}", kind.name, index, kind.plural);
    } else if (index.front() == '-') {
        message = fmt::format("{} {}, but {} {} before this statement", kind.name, index,
                              so_far == 0 ? "none" : fmt::format("only {}", so_far),
                              so_far <= 1 ? "comes" : "come");
    } else {
        message = fmt::format("{} {} of {}", kind.name, index, total);
    }
    tell(Code::E0702, begin, end, std::move(message));
}

void Mistakes::too_few_corners(const char* statement, const char* end, std::size_t found_count) {
    ++count_;
    if (!are_told()) return;
    too_few(statement, end, "a face needs at least 3 corners", found_count);
}

void Mistakes::too_many_corners(const char* begin, const char* end, std::size_t max_count) {
    ++count_;
    if (!are_told()) return;
    tell(Code::E0705, begin, end,
         fmt::format("a face can have {} corners; this is one more", max_count));
}

void Mistakes::no_faces() {
    ++count_;
    if (!are_told()) return;
    tell(Code::E0704, text_.data(), text_.data(), "this file has no faces (`f` statements)");
}

void Mistakes::wrong(const char* begin, const char* end, std::string message) {
    ++count_;
    if (are_told()) tell(Code::E0701, begin, end, std::move(message));
}

bool Mistakes::find_binary(std::string_view format) {
    const std::string_view text = text_.view();
    const std::size_t nul = text.find('\0');
    if (nul == text.npos) return false;
    ++count_;
    if (!are_told()) return true;
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        tell(Code::E0003, text.data(), text.data() + 2, "this file is UTF-16; save it as UTF-8");
    } else {
        tell(Code::E0003, text.data() + nul, text.data() + nul + 1,
             fmt::format("this is not {} text but a binary file: here is a NUL byte", format));
    }
    return true;
}

/// At the statement as a whole, up to its last word.
void Mistakes::too_few(const char* statement, const char* end, std::string_view needs,
                       std::size_t found_count) {
    while (end > statement && (is_blank(end[-1]) || is_line_end(end[-1]) || end[-1] == '\\')) {
        --end;
    }
    tell(Code::E0701, statement, end, fmt::format("{}, this has {}", needs, found_count));
}

void Mistakes::tell(Code code, const char* begin, const char* end, std::string message) {
    const Span span = Span::make(id_, static_cast<std::size_t>(begin - text_.data()),
                                 static_cast<std::size_t>(end - text_.data()));
    Diagnostic& diagnostic = diagnostics_->error(code, span, std::move(message));
    if (!loaded_at_.is_nowhere()) diagnostic.with_label(loaded_at_, "loaded here");
    if (count_ == kMaxTold) {
        diagnostic.with_note(
            fmt::format("after {} errors the rest of this file is not read", kMaxTold));
    }
}

}  // namespace lray::scene::obj
