#include "scene/formats/obj_reader.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/assert.h"
#include "scene/formats/obj_assemble.h"
#include "scene/formats/obj_chunk.h"
#include "scene/formats/obj_counts.h"
#include "scene/formats/obj_cut.h"
#include "scene/formats/obj_mistakes.h"
#include "scene/formats/obj_scanner.h"
#include "scene/formats/obj_statements.h"

namespace lray::scene {

namespace obj {

namespace {

/// What the fast run found; what mistakes there are, and where, is for the other one.
struct Chunks {
    std::vector<Chunk> all{};
    bool are_right = true;
};

/// Reads a stretch of a text after `before`; false if there is a mistake in it.
bool read_chunk(const Text& text, TextRange range, const Counts& before, const Counts& expected,
                Chunk& chunk) {
    constexpr std::size_t kAny = Mesh::kNone;
    Mistakes mistakes(text);
    ChunkBuilder builder(before);
    builder.reserve(expected);
    StatementReader reader(range.begin, range.end, {kAny, kAny, kAny, kAny, kAny}, mistakes,
                           builder);
    reader.read_all();
    chunk = builder.finish();
    return mistakes.count() == 0 && !reader.has_nul();
}

Chunks read_at_once(const Text& text, TextRange range) {
    Chunks chunks;
    chunks.all.resize(1);
    chunks.are_right = read_chunk(text, range, {}, estimate_counts(text), chunks.all[0]);
    return chunks;
}

/// Counts first: an index may be relative to all that comes before its chunk.
Chunks read_in_parallel(const Text& text, const std::vector<TextRange>& ranges) {
    std::vector<Counts> counts(ranges.size());
    tbb::parallel_for(std::size_t{0}, ranges.size(), [&](std::size_t i) {
        counts[i] = count_statements(ranges[i].begin, ranges[i].end);
    });
    std::vector<Counts> before(ranges.size());
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        before[i] = before[i - 1];
        before[i] += counts[i - 1];
    }
    Chunks chunks;
    chunks.all.resize(ranges.size());
    std::vector<char> are_right(ranges.size());
    tbb::parallel_for(std::size_t{0}, ranges.size(), [&](std::size_t i) {
        are_right[i] = read_chunk(text, ranges[i], before[i], counts[i], chunks.all[i]) ? 1 : 0;
    });
    chunks.are_right = std::find(are_right.begin(), are_right.end(), 0) == are_right.end();
    return chunks;
}

/// What of the file is not in the mesh, found in its chunks.
struct Skipped {
    const char* first_free_form = nullptr;
    std::size_t free_form_count = 0;
};

Skipped skipped_in(const Chunks& chunks) {
    Skipped skipped;
    for (const Chunk& chunk : chunks.all) {
        if (skipped.free_form_count == 0) skipped.first_free_form = chunk.first_free_form;
        skipped.free_form_count += chunk.free_form_count;
    }
    return skipped;
}

void tell_skipped(const Skipped& skipped, const Text& text, SourceId file, Span loaded_at,
                  Diagnostics& diagnostics) {
    if (skipped.free_form_count == 0) return;
    const char* const begin = skipped.first_free_form;
    const Span span = Span::make(file, static_cast<std::size_t>(begin - text.data()),
                                 static_cast<std::size_t>(skip_token(begin) - text.data()));
    const std::size_t count = skipped.free_form_count;
    Diagnostic& warning = diagnostics.warning(
        Code::W1704, span,
        fmt::format("{} free-form curve{} or surface{} of this file {} not read", count,
                    count == 1 ? "" : "s", count == 1 ? "" : "s", count == 1 ? "is" : "are"));
    if (!loaded_at.is_nowhere()) warning.with_label(loaded_at, "loaded here");
}

void tell_mistakes(const Text& text, Mistakes& mistakes) {
    if (mistakes.find_binary()) return;
    ChunkBuilder builder;
    const TextRange range = whole(text);
    const Counts total = count_statements(range.begin, range.end);
    StatementReader reader(range.begin, range.end, total, mistakes, builder);
    reader.read_all();
    if (reader.face_count() == 0 && mistakes.count() == 0) mistakes.no_faces();
    LRAY_ASSERT(mistakes.count() > 0);
}

}  // namespace

}  // namespace obj

std::optional<Mesh> read_obj(const Sources& sources, SourceId file, Span loaded_at,
                             Diagnostics& diagnostics, std::size_t chunk_size) {
    const Text& text = sources[file].text;
    // Places in the text have 32 bits, so every count of its mesh has: a corner takes two bytes.
    const std::vector<obj::TextRange> ranges = obj::cut(text, chunk_size);
    const bool is_alone = ranges.size() == 1 || tbb::this_task_arena::max_concurrency() == 1;
    obj::Chunks chunks =
        is_alone ? obj::read_at_once(text, obj::whole(text)) : obj::read_in_parallel(text, ranges);
    if (chunks.are_right) {
        const obj::Skipped skipped = obj::skipped_in(chunks);
        if (std::optional<Mesh> mesh = obj::assemble(std::move(chunks.all))) {
            obj::tell_skipped(skipped, text, file, loaded_at, diagnostics);
            return mesh;
        }
    }
    obj::Mistakes mistakes(text, file, loaded_at, diagnostics);
    obj::tell_mistakes(text, mistakes);
    return {};
}

}  // namespace lray::scene
