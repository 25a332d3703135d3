// Memory of values that are made and dropped while the program runs: what a function call or a
// time round a loop leaves behind is given back when it ends, except for what is still in use.
#pragma once

#include <cstddef>
#include <unordered_map>

#include "parser/arena.h"
#include "parser/values/operators.h"
#include "parser/values/value.h"

namespace lray::parser {

/// The arena and the budget as they were when a call or a time round began.
struct Region {
    Arena::Mark mark{};
    std::uint64_t value_bytes = 0;
    std::uint64_t kept_bytes = 0;
};

/// Copies values out of a part of an arena: what lies elsewhere is left where it is. What is shared
/// stays shared, as long as one copier lives.
class ValueCopier {
 public:
    /// Copies what `from` holds behind `mark` to `to`.
    ValueCopier(const Arena& from, const Arena::Mark& mark, Arena& to)
        : from_(from), mark_(mark), to_(to) {}

    Value copy(const Value& value);

    /// Bytes that were copied.
    std::size_t size() const { return size_; }

 private:
    /// What is smaller is copied wherever it is used: to find it again would cost more.
    static constexpr std::size_t kShared = 24;

    template <class T>
    const T* copied(const T* begin, std::size_t count) {
        if (!from_.holds(begin, mark_)) return begin;
        const std::size_t size = count * sizeof(T);
        if (size > kShared) {
            const auto known = blobs_.find(begin);
            if (known != blobs_.end() && known->second.size >= size) {
                return static_cast<const T*>(known->second.at);
            }
        }
        size_ += size;
        const T* const copy = to_.copy(std::span<const T>(begin, count)).data();
        if (size > kShared) blobs_.insert_or_assign(begin, Blob{copy, size});
        return copy;
    }

    /// Numbers or text, where it was copied to.
    struct Blob {
        const void* at = nullptr;
        std::size_t size = 0;
    };

    const Arena& from_;
    Arena::Mark mark_;
    Arena& to_;
    std::size_t size_ = 0;
    std::unordered_map<const void*, Value> shared_;
    std::unordered_map<const void*, Blob> blobs_;
};

/// The memory of values.
class ValueMemory {
 public:
    explicit ValueMemory(Budget& budget) : budget_(budget) {}

    /// Where values are made.
    Arena& arena() { return arena_; }

    /// Where what lives to the end of the run is made.
    Arena& kept() { return kept_; }

    Region begin() const { return {arena_.mark(), budget_.value_bytes, budget_.kept_bytes}; }

    /// Gives back all that was made since.
    void end(const Region& region);

    /// Gives back what was made since, except for `result`, which may move.
    Value end_with(const Region& region, const Value& result);

    bool is_untouched(const Region& region) const { return arena_.mark() == region.mark; }

    /// True if the value, or a part of it, was made since.
    bool is_made_since(const Region& region, const Value& value) const;

    /// True if enough was made since, compared with what was `in_use` the last time, to be worth
    /// copying what is still in use.
    bool is_worth_copying(const Region& region, std::size_t in_use) const {
        return arena_.size_since(region.mark) > kLeastGarbage + 2 * in_use;
    }

    /// Gives back what was made since, except for the values, which may move. Returns how many
    /// bytes they take.
    template <class ForEach>
    std::size_t end_with_values(const Region& region, ForEach for_each_value);

    /// Copies values to where they stay to the end of the run.
    ValueCopier keeper() { return ValueCopier(arena_, {}, kept_); }

 private:
    static constexpr std::size_t kLeastGarbage = std::size_t{64} << 10;
    static constexpr std::size_t kBytesPerStep = 64;  // of copying

    Budget& budget_;
    Arena arena_;
    Arena kept_;
    Arena scratch_;
    // The result that was copied last, with all it refers to.
    const void* last_result_ = nullptr;
    std::size_t last_result_size_ = 0;
};

template <class ForEach>
std::size_t ValueMemory::end_with_values(const Region& region, ForEach for_each_value) {
    ValueCopier out(arena_, region.mark, scratch_);
    for_each_value([&](Value& value) { value = out.copy(value); });
    end(region);
    ValueCopier back(scratch_, {}, arena_);
    for_each_value([&](Value& value) { value = back.copy(value); });
    scratch_.reset({});
    budget_.value_bytes -= std::min<std::uint64_t>(budget_.value_bytes, back.size());
    budget_.steps -= std::min<std::uint64_t>(budget_.steps, back.size() / kBytesPerStep);
    return back.size();
}

}  // namespace lray::parser
