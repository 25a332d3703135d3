// The words for what is wrong with an NFF file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"

namespace lray::scene::nff {

/// Tells the first kMaxTold mistakes of a file.
/// Shape: all places are in the text.
class Mistakes {
 public:
    static constexpr std::size_t kMaxTold = 20;

    Mistakes(const Text& text, SourceId id, Diagnostics& diagnostics)
        : text_(text), id_(id), diagnostics_(diagnostics) {}

    std::size_t count() const { return count_; }
    bool is_enough() const { return count_ >= kMaxTold; }

    Span span(const char* begin, const char* end) const {
        return Span::make(id_, static_cast<std::size_t>(begin - text_.data()),
                          static_cast<std::size_t>(end - text_.data()));
    }

    /// The token at `begin` is not a finite number that a float holds.
    void wrong_number(const char* begin);

    /// The statement has `found` numbers; `needs` says how many it needs.
    void too_few_numbers(Span statement, std::string_view needs, std::size_t found);

    /// The number at `begin` belongs to no statement; `needs` is that of the one before it, or
    /// empty.
    void stray_number(const char* begin, std::string_view needs);

    /// The word at `begin` is none of NFF.
    void unknown_word(const char* begin, bool is_in_view);

    void value(Code code, Span span, std::string message, std::string help = {});
    void second(Span span, std::string_view keyword, std::string_view of_what, Span first);
    void binary(const char* at);
    void other_format(const char* begin);
    void too_many_nodes(Span span, std::uint64_t limit);
    void too_many_bytes(Span span, std::uint64_t limit);

 private:
    Diagnostic& tell(Code code, Span span, std::string message);

    const Text& text_;
    SourceId id_ = kNoSource;
    Diagnostics& diagnostics_;
    std::size_t count_ = 0;
};

}  // namespace lray::scene::nff
