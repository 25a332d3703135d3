// Evaluates components. A component is pure: what it places depends on its parameters, what it
// captures and what is put into it alone, so equal uses share one definition.
#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "parser/evaluate/evaluator_state.h"

namespace lray::parser {

using scene::NodeId;

namespace {

/// What a memo's key may be at most: a component with a longer one is evaluated at each use.
constexpr std::size_t kLongestKey = std::size_t{64} << 10;

/// Writes values as bytes that are equal only for equal values.
class KeyWriter {
 public:
    explicit KeyWriter(std::string& key) : key_(key) {}

    template <class T>
    void add(const T& value) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        key_.append(bytes, sizeof(T));
    }

    void add(const Value& value) {
        if (is_full()) return;
        add(value.kind);
        switch (value.kind) {
            case ValueKind::none:
            case ValueKind::poison:
                return;
            case ValueKind::number:
                return add(value.number);
            case ValueKind::boolean:
                return add(value.boolean);
            case ValueKind::string:
                add(value.source);
                return add_bytes(value.text, value.count, 1);
            case ValueKind::numbers:
            case ValueKind::color:
                return add_bytes(value.numbers, value.count, sizeof(double));
            case ValueKind::rows:
                add(value.width);
                return add_bytes(value.numbers, value.count, sizeof(double) * value.width);
            case ValueKind::transform:  // by its numbers: the memory it lies in is used again
                add(value.transform->linear());
                return add(value.transform->offset());
            case ValueKind::texture:
            case ValueKind::material:
            case ValueKind::node:
                return add(value.made->id);
            case ValueKind::list:
                add(value.count);
                for (std::uint32_t i = 0; i < value.count && !is_full(); ++i) {
                    add(value.elements[i]);
                }
                return;
            case ValueKind::record:
                add(value.count);
                for (std::uint32_t i = 0; i < value.count && !is_full(); ++i) {
                    add(value.fields[i].name);
                    add(value.fields[i].value);
                }
                return;
            case ValueKind::function: {
                const FunctionValue& function = *value.function;
                add(function.function);
                add(function.builtin);
                if (function.function == nullptr) return;
                for (std::size_t i = 0; i < function.function->capture_slots.size(); ++i) {
                    add(function.captures[i]);
                }
                return;
            }
        }
    }

 private:
    bool is_full() const { return key_.size() > kLongestKey; }

    void add_bytes(const void* begin, std::uint32_t count, std::size_t size) {
        add(count);
        if (count * size > kLongestKey) {
            key_.resize(kLongestKey + 1);
        } else {
            key_.append(static_cast<const char*>(begin), count * size);
        }
    }

    std::string& key_;
};

}  // namespace

// What a component captures, as it is now.
FunctionValue Evaluator::captured(const FunctionUse& use) {
    std::vector<Value> captures;
    for (const std::uint32_t slot : use.capture_slots) captures.push_back(frame_[slot]);
    return {use.function, 0, arena().copy(captures).data()};
}

// What was put between the braces of a component, as one node; none if there was nothing.
NodeId Evaluator::children_of(const OpenBlock& open) {
    return open.children.empty() ? NodeId{} : add_group(open.children, open.span);
}

NodeId Evaluator::add_group(const std::vector<NodeId>& children, Span span) {
    scene::Node node;
    node.kind = scene::NodeKind::group;
    node.index = static_cast<std::uint32_t>(scene_.groups.size());
    node.span = span;
    scene_.groups.push_back({children});
    return push_node(node);
}

Value Evaluator::node_value(NodeId id) {
    const bool is_nothing = id.is_none();
    if (is_nothing && nothing_.is(ValueKind::node)) return nothing_;
    if (is_nothing) id = add_group({}, Span{});
    take_kept_bytes(budget_, sizeof(Made), scene_.node(id).span, diagnostics_);
    Made made;
    made.schema = &block_schema(BlockKind::group);
    made.id = id.value;
    const Value value = Value::of_made(ValueKind::node, memory_.kept().make<Made>(made));
    if (is_nothing) nothing_ = value;
    return value;
}

std::optional<NodeId> Evaluator::place_component(const BlockExpr& expr, const FunctionUse& use) {
    OpenBlock open(*use.function->schema, expr.span);
    if (!body(expr, open)) return std::nullopt;
    return make_component(open, captured(use), children_of(open), expr.label);
}

// A use of a component: an instance of what it places, with the steps and material of this use.
std::optional<NodeId> Evaluator::make_component(const OpenBlock& open,
                                                const FunctionValue& component, NodeId children,
                                                const StringExpr* label) {
    const Region region = memory_.begin();
    const std::optional<NodeId> target =
        instantiate(component, open.values.all(), children, open.span);
    memory_.end(region);
    if (!target) return std::nullopt;
    const NodeId id = add_node(open, scene::NodeKind::instance, scene_.instances.size(), label);
    scene_.instances.push_back({*target});
    return id;
}

std::optional<NodeId> Evaluator::instantiate(const FunctionValue& component,
                                             std::span<const Value> parameters, NodeId children,
                                             Span span) {
    const Function& function = *component.function;
    if (!has_room(function, span)) return std::nullopt;
    const std::size_t base = push_frame(function);
    Value* const frame = slots_.data() + base;
    std::copy(parameters.begin(), parameters.end(), frame);
    for (std::size_t i = 0; i < function.capture_slots.size(); ++i) {
        frame[function.capture_slots[i]] = component.captures[i];
    }
    enter(function, base, span);
    const std::uint64_t failures = failures_;
    std::optional<NodeId> made;
    if (complete_parameters(function, span)) {
        std::string key;
        const bool is_memoised =
            environment_.settings.use_memo && !function.has_effects && children.is_none();
        if (is_memoised) {
            KeyWriter writer(key);
            writer.add(function.id);
            for (std::size_t i = 0; i < function.parameters.size(); ++i) writer.add(frame_[i]);
            for (const std::uint32_t slot : function.capture_slots) writer.add(frame_[slot]);
            take_share(key.size(), span);
        }
        const bool has_key = is_memoised && key.size() <= kLongestKey;
        const auto known = has_key ? components_.find(key) : components_.end();
        if (known != components_.end()) {
            if (!known->second.is_none()) made = known->second;
        } else {
            frame_[function.children_slot] = node_value(children);
            OpenBlock open(block_schema(BlockKind::group), function.name_span);
            items(function.body.items, open);
            if (!open.is_poisoned) made = make_node(open, nullptr);
            const std::uint64_t size = key.size() + sizeof(NodeId);
            const bool is_whole = made && failures_ == failures;
            const bool is_kept = has_key && take_kept_bytes(budget_, size, span, diagnostics_);
            // What could not be made is not tried again: a tree of uses may be as large as it
            // likes.
            if (is_kept) components_.emplace(std::move(key), is_whole ? *made : NodeId{});
        }
    }
    leave();
    return made;
}

}  // namespace lray::parser
