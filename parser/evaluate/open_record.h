// The fields of a record while it is made.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "parser/values/value.h"

namespace lray::parser {

/// Fields in the order in which they came, found by their names. A few are searched one by one, of
/// many an index is made: most blocks are no records, and pay nothing for it.
class OpenRecord {
 public:
    /// Begins as a copy of a record.
    void copy(const Value& record) {
        fields_.assign(record.fields, record.fields + record.count);
        index_.reset();
    }

    const std::vector<RecordField>& fields() const { return fields_; }

    /// How many fields the next set() puts into the index.
    std::size_t unindexed_count() const;

    /// Sets a field, or adds it as the last one.
    void set(Symbol name, const Value& value);

 private:
    static constexpr std::size_t kFew = 16;

    std::vector<RecordField> fields_{};
    std::unique_ptr<std::unordered_map<Symbol, std::size_t>> index_{};
};

}  // namespace lray::parser
