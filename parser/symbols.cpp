#include "parser/symbols.h"

#include "parser/blocks/schema.h"
#include "parser/syntax/token.h"

namespace lray::parser {

namespace {

// FNV-1a, folded: identifiers are short.
std::size_t hash(std::string_view name) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const char c : name) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return static_cast<std::size_t>(h ^ (h >> 29));
}

}  // namespace

Symbols::Symbols() {
    table_.assign(1024, kNoSymbol);
    for (const std::string_view keyword : kKeywords) intern(keyword);
    for (const BlockSchema& schema : block_schemas()) intern(schema.name);
}

Symbol Symbols::intern(std::string_view name) {
    const std::size_t mask = table_.size() - 1;
    std::size_t place = hash(name) & mask;
    while (table_[place] != kNoSymbol) {
        if (names_[table_[place]] == name) return table_[place];
        place = (place + 1) & mask;
    }
    const Symbol symbol = static_cast<Symbol>(names_.size());
    names_.push_back(arena_.copy(name));
    table_[place] = symbol;
    if (names_.size() * 2 > table_.size()) grow();
    return symbol;
}

void Symbols::grow() {
    table_.assign(table_.size() * 2, kNoSymbol);
    const std::size_t mask = table_.size() - 1;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        std::size_t place = hash(names_[i]) & mask;
        while (table_[place] != kNoSymbol) place = (place + 1) & mask;
        table_[place] = static_cast<Symbol>(i);
    }
}

}  // namespace lray::parser
