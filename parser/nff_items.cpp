#include "parser/nff_items.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/did_you_mean.h"
#include "base/path.h"
#include "scene/formats/nff_nodes.h"
#include "scene/formats/nff_reader.h"

namespace lray::parser {

namespace {

constexpr std::string_view kEnding = ".nff";

std::string_view ending_of(std::string_view path) {
    return path.substr(path.size() - std::min(path.size(), kEnding.size()));
}

std::optional<scene::NffScene> read(SourceId source, const ParseContext& context,
                                    const LoadLimits& limits, Diagnostics& diagnostics) {
    const scene::NffLimits room{limits.nodes, context.scene.nodes.size(), limits.value_bytes};
    return scene::read_nff(context.sources, source, room, diagnostics);
}

/// Makes items. All stand at the begin of the file: messages are about its nodes.
class ItemMaker {
 public:
    ItemMaker(SourceId source, ParseContext& context)
        : begin_(Span::make(source, 0, 0)), context_(context) {}

    Item* view(const scene::NffScene& nff) {
        FileViewItem* const item = make<FileViewItem>(ItemKind::file_view);
        item->has_view = nff.view.has_value();
        if (nff.view) item->view = *nff.view;
        const std::string_view name = file_name_of(context_.sources[begin_.source].path);
        item->name = context_.arena.copy(name.substr(0, name.size() - kEnding.size()));
        item->has_background = nff.background.has_value();
        if (nff.background) item->background = Color{*nff.background};
        return item;
    }

    /// The shapes, the lights, or both.
    Item* placed(std::uint32_t first, std::uint32_t count) {
        LiteralsItem* const item = make<LiteralsItem>(ItemKind::literals);
        item->first_node = first;
        item->count = count;
        return item;
    }

    /// `let name = group { ... }`
    Item* group(std::string_view name, Item* content) {
        NameExpr* const head = context_.arena.make<NameExpr>();
        head->kind = ExprKind::name;
        head->span = begin_;
        head->symbol = context_.symbols.intern("group");
        BlockExpr* const block = context_.arena.make<BlockExpr>();
        block->kind = ExprKind::block;
        block->span = begin_;
        block->head = head;
        block->body = {context_.arena.copy(std::vector<Item*>{content}), begin_, begin_};
        LetItem* const let = make<LetItem>(ItemKind::let);
        let->name = context_.symbols.intern(name);
        let->name_span = begin_;
        let->value = block;
        return let;
    }

    std::span<Item* const> list(const std::vector<Item*>& items) {
        return context_.arena.copy(items);
    }

 private:
    template <class T>
    T* make(ItemKind kind) {
        T* const item = context_.arena.make<T>();
        item->kind = kind;
        item->span = begin_;
        return item;
    }

    Span begin_{};
    ParseContext& context_;
};

}  // namespace

bool is_nff(std::string_view path) {
    return edit_distance(ending_of(path), kEnding, 0) == 0;
}

std::span<Item* const> nff_items(SourceId source, ParseContext& context, const LoadLimits& limits,
                                 Diagnostics& diagnostics) {
    std::optional<scene::NffScene> nff = read(source, context, limits, diagnostics);
    if (!nff) return {};
    ItemMaker make(source, context);
    Item* const view = make.view(*nff);
    const scene::NffNodes nodes = scene::add_nff(std::move(*nff), context.scene);
    return make.list({view, make.placed(nodes.first, nodes.shape_count + nodes.light_count)});
}

std::span<Item* const> nff_names(SourceId source, ParseContext& context, const LoadLimits& limits,
                                 Diagnostics& diagnostics) {
    std::optional<scene::NffScene> nff = read(source, context, limits, diagnostics);
    const scene::NffNodes nodes =
        nff ? scene::add_nff(std::move(*nff), context.scene) : scene::NffNodes{};
    ItemMaker make(source, context);
    const std::uint32_t first_light = nodes.first + nodes.shape_count;
    return make.list(
        {make.group("shapes", make.placed(nodes.first, nodes.shape_count)),
         make.group("lights", make.placed(first_light, nodes.light_count)),
         make.group("scene", make.placed(nodes.first, nodes.shape_count + nodes.light_count))});
}

}  // namespace lray::parser
