// Telling what is wrong with a PLY file: the first mistake of each file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"

namespace lray::scene::ply {

/// Returns a word of the file in quotes, not too long.
std::string quoted(std::string_view word);

/// Tells one mistake of a file: where it stands if that is text, else where the file is named.
class Mistakes {
 public:
    Mistakes(const Text& text, SourceId id, Span loaded_at, Diagnostics& diagnostics)
        : text_(text), id_(id), loaded_at_(loaded_at), diagnostics_(diagnostics) {}

    /// At a stretch of the file that is text; if its line holds bytes that are none, at the name of
    /// the file.
    void in_text(Code code, std::string_view place, std::string message);

    /// At the name of the file, whose bytes are no text.
    void in_bytes(Code code, std::string message);

    /// The number of a byte of the file, from 0.
    std::size_t byte_at(const char* at) const {
        return static_cast<std::size_t>(at - text_.data());
    }

    bool are_any() const { return are_any_; }

 private:
    bool is_text(std::string_view place) const;

    const Text& text_;
    SourceId id_ = kNoSource;
    Span loaded_at_{};
    Diagnostics& diagnostics_;
    bool are_any_ = false;
};

}  // namespace lray::scene::ply
