// The words for what is wrong with an OBJ or MTL file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"

namespace lray::scene::obj {

/// What an index counts, and how messages call it.
struct IndexKind {
    std::string_view name;
    std::string_view plural;
};
inline constexpr IndexKind kPositionIndex = {"vertex", "vertices"};
inline constexpr IndexKind kUvIndex = {"texture coordinate", "texture coordinates"};
inline constexpr IndexKind kNormalIndex = {"normal", "normals"};

/// Counts the mistakes of a file, and tells them if it was given diagnostics: the first kMaxTold.
/// Shape: all places are in the text.
class Mistakes {
 public:
    static constexpr std::size_t kMaxTold = 20;

    /// Counts silently.
    explicit Mistakes(const Text& text) : text_(text) {}

    Mistakes(const Text& text, SourceId id, Span loaded_at, Diagnostics& diagnostics)
        : text_(text), id_(id), loaded_at_(loaded_at), diagnostics_(&diagnostics) {}

    std::size_t count() const { return count_; }
    bool are_told() const { return diagnostics_ != nullptr; }
    bool is_enough() const { return !are_told() || count_ >= kMaxTold; }

    /// The token at `begin` is not a finite number that a float holds; or the statement ends
    /// there, after `found_count` numbers of those `needed`: "3".
    void wrong_number(const char* statement, const char* begin, std::size_t found_count,
                      std::string_view needed);

    /// The token that `at` is in is not a corner of a face.
    void wrong_corner(const char* statement, const char* at);

    /// The index [begin, end) is 0 or out of range.
    void wrong_index(const char* begin, const char* end, IndexKind kind, std::size_t so_far,
                     std::size_t total);

    /// The statement has ended at `end`.
    void too_few_corners(const char* statement, const char* end, std::size_t found_count);
    void too_many_corners(const char* begin, const char* end, std::size_t max_count);

    void no_faces();

    /// E0701 at [begin, end).
    void wrong(const char* begin, const char* end, std::string message);

    /// Tells of text that is none, at its first NUL; returns false if it has none.
    bool find_binary(std::string_view format = "OBJ");

 private:
    void too_few(const char* statement, const char* end, std::string_view needs,
                 std::size_t found_count);
    void tell(Code code, const char* begin, const char* end, std::string message);

    const Text& text_;
    SourceId id_ = kNoSource;
    Span loaded_at_{};
    Diagnostics* diagnostics_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace lray::scene::obj
