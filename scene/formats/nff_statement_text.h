// The text of an NFF file, statement by statement: numbers and what is made of them, and where to
// go on after a mistake. What statements say is nff_reader's.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"
#include "scene/camera.h"
#include "scene/formats/nff_mistakes.h"
#include "scene/formats/nff_scanner.h"

namespace lray::scene::nff {

/// A place in the text. One mistake is told of each statement: after it is_wrong() holds until the
/// next one begins, and all that is read is 0.
class StatementText {
 public:
    StatementText(const Text& text, Mistakes& mistakes)
        : end_(text.data() + text.size()), at_(text.data()), mistakes_(mistakes) {
        if (text.view().starts_with("\xEF\xBB\xBF")) at_ += 3;
    }

    const char* at() const { return at_; }
    std::size_t size_left() const { return static_cast<std::size_t>(end_ - at_); }
    bool is_at_end() const { return at_ == end_; }
    bool is_at_end_of_statement() const {
        return at_ == end_ || statement_at(at_) != Statement::none;
    }
    void skip_space() { at_ = nff::skip_space(at_); }

    /// Goes behind the keyword at the place, of this kind.
    void begin_statement(Statement kind);

    /// What is at the place is no statement, which was told.
    void refuse_statement() { is_wrong_ = true; }

    /// Goes behind the word of a view at the place, whose numbers follow.
    void begin_view_word(ViewWord word);

    /// The numbers that follow are those of this many corners.
    void begin_corners(std::size_t count);

    double number();
    DVec3 point();
    double radius();
    double not_negative(std::string_view name);
    DVec3 color(std::string_view part);
    Resolution resolution();

    bool is_wrong() const { return is_wrong_; }
    void wrong_value(Code code, Span span, std::string message, std::string help = {});

    /// True if nothing more is to be read: the file is binary.
    bool is_binary() const { return is_binary_; }

    /// Goes to the next statement that begins a line, unless one begins here.
    void go_on_at_next_statement();

    /// The statement being read, or the last one; `none` before the first.
    Statement kind() const { return kind_; }

    /// Returns how many numbers it has, in words; empty if there is none.
    std::string needs() const;

    std::string_view keyword() const { return token_at(statement_); }
    Span keyword_span() const { return mistakes_.span(statement_, skip_token(statement_)); }

    /// Up to the last word that was read.
    Span statement_span() const { return mistakes_.span(statement_, token_end_); }

    /// Of the last number, or word of a view.
    Span number_span() const { return mistakes_.span(number_, token_end_); }
    std::string_view number_text() const {
        return {number_, static_cast<std::size_t>(token_end_ - number_)};
    }

 private:
    void wrong_number();

    const char* const end_;
    const char* at_;
    Mistakes& mistakes_;

    Statement kind_ = Statement::none;
    const char* statement_ = nullptr;  // its begin
    const char* number_ = nullptr;     // the begin of the last number
    const char* token_end_ = nullptr;  // the end of the last token
    std::size_t number_count_ = 0;     // read in this statement, or behind this word of a view
    std::size_t corner_count_ = 0;     // that this polygon is to have
    ViewWord view_word_ = ViewWord::from;
    bool is_wrong_ = false;
    bool is_binary_ = false;
};

}  // namespace lray::scene::nff
