// Reads the statements of OBJ text: what each of them says, and which are wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/source.h"
#include "scene/formats/obj_chunk.h"
#include "scene/formats/obj_counts.h"
#include "scene/formats/obj_mistakes.h"

namespace lray::scene::obj {

/// Reads the statements of a chunk of a file into its builder. Forward indices make it impossible
/// to judge an index before the end: the fast run gives up at the first mistake, and a second one,
/// which knows the counts of the whole file, tells them all.
class StatementReader {
 public:
    /// Reads [begin, end) of a text, which is cut between statements. `total`: what indices may
    /// count; unlimited if all is not known yet.
    StatementReader(const char* begin, const char* end, const Counts& total, Mistakes& mistakes,
                    ChunkBuilder& builder);

    /// Reads to the end, or until there are enough mistakes.
    void read_all();

    /// True if reading stopped at a NUL in the text.
    bool has_nul() const { return at_ < end_ && *at_ == '\0'; }

    std::size_t face_count() const { return face_count_; }

 private:
    void read_statement();
    void read_position();
    void read_color();
    void read_uv();
    void read_normal();
    void read_face();
    bool read_corner();

    double read_number();
    std::uint32_t read_index(IndexKind kind, std::size_t so_far, std::size_t total);
    bool is_at_end() const;

    const char* const end_;
    const char* at_;
    const char* statement_ = nullptr;  // the begin of the one being read
    bool is_statement_wrong_ = false;  // one mistake is told of each
    std::size_t number_count_ = 0;     // read in this statement
    std::size_t face_count_ = 0;
    std::vector<Corner> corners_{};

    const Counts total_;
    Mistakes& mistakes_;
    ChunkBuilder& builder_;
};

}  // namespace lray::scene::obj
