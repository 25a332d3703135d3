#include "parser/evaluate/open_record.h"

#include <algorithm>

namespace lray::parser {

std::size_t OpenRecord::unindexed_count() const {
    if (fields_.size() <= kFew) return 0;
    return fields_.size() - (index_ != nullptr ? index_->size() : 0);
}

void OpenRecord::set(Symbol name, const Value& value) {
    auto field = fields_.end();
    if (fields_.size() <= kFew) {
        field = std::ranges::find(fields_, name, &RecordField::name);
    } else {
        if (index_ == nullptr) {
            index_ = std::make_unique<std::unordered_map<Symbol, std::size_t>>();
        }
        for (std::size_t i = index_->size(); i < fields_.size(); ++i) {
            index_->emplace(fields_[i].name, i);
        }
        const auto known = index_->find(name);
        if (known != index_->end()) {
            field = fields_.begin() + static_cast<std::ptrdiff_t>(known->second);
        }
    }
    if (field != fields_.end()) {
        field->value = value;
    } else {
        fields_.push_back({name, value});
    }
}

}  // namespace lray::parser
