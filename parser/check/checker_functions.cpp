// Checks functions and components, and what imports bring.
#include <array>
#include <utility>

#include "base/did_you_mean.h"
#include "parser/check/check_arguments.h"
#include "parser/check/checker_state.h"

namespace lray::parser {

// Functions and components are known in their whole braces, before and after their line.
void FileChecker::declare_functions(std::span<Item* const> list) {
    for (Item* item : list) {
        if (item->kind == ItemKind::function) {
            declare_function(static_cast<FunctionItem&>(*item));
        } else if (item->kind == ItemKind::let) {
            const LetItem& let = static_cast<const LetItem&>(*item);
            const bool is_broken = let.value->kind == ExprKind::error;
            if (is_broken) program_.broken_names.push_back(symbols_.text(let.name));
        } else if (item->kind == ItemKind::include) {
            declare_functions(static_cast<const IncludeItem&>(*item).items);
        }
    }
}

void FileChecker::declare_function(FunctionItem& item) {
    Function& function = *item.function;
    program_.functions.add(&function, context_);
    for (Context::Loop& loop : context_->loops) loop.has_functions = true;
    new_name(function.name, function.name_span);
    const Meaning meaning = function.is_component ? Meaning::component : Meaning::function;
    Variable& variable = declare(function.name, function.name_span, meaning);
    variable.function = &function;
    variable.warns_if_unused = !scopes_.is_outermost();
    if (function.is_component) {
        function.schema = component_schema(function);
        know_schema(function.name_span, function.schema);
    }
}

// The parameters of a component are its properties.
const BlockSchema* FileChecker::component_schema(const Function& function) {
    Arena& arena = program_.arena;
    std::vector<PropertySchema> properties;
    for (const ParameterDecl& parameter : function.parameters) {
        if (properties.size() == kMaxProperties) {
            error(Code::E0306, parameter.name_span,
                  fmt::format("a component has at most {} parameters", kMaxProperties))
                .with_help("put some of them together in a `record`");
            break;
        }
        PropertySchema property;
        property.name = symbols_.text(parameter.name);
        property.type = PropertyType::any;
        property.is_required = parameter.default_value == nullptr;
        if (parameter.default_value != nullptr) {
            property.default_text = text(*parameter.default_value);
        }
        properties.push_back(property);
    }
    BlockSchema schema;
    schema.kind = BlockKind::component;
    schema.name = symbols_.text(function.name);
    schema.doc = function.doc;
    schema.properties = arena.copy(properties);
    schema.is_placeable = true;
    schema.has_children = true;
    return arena.make<BlockSchema>(schema);
}

void FileChecker::parameter_names(const Function& function) {
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const ParameterDecl& parameter = function.parameters[i];
        const std::string_view name = symbols_.text(parameter.name);
        const bool is_common = function.is_component && find_property(common_properties(), name) <
                                                            common_properties().size();
        if (is_common || (function.is_component && name == "children")) {
            error(Code::E0203, parameter.name_span,
                  fmt::format("every component has `{}` already; choose another name", name));
        }
        // A default may use the parameters in front of it.
        if (parameter.default_value != nullptr) expression(*parameter.default_value);
        new_name(parameter.name, parameter.name_span);
        Variable& variable = declare(parameter.name, parameter.name_span, Meaning::local);
        variable.slot = static_cast<std::uint32_t>(i);
    }
    if (!function.is_component) {
        if (function.parameters.size() > kMaxFunctionParameters) {
            error(Code::E0306, function.parameters[kMaxFunctionParameters].name_span,
                  fmt::format("a function has at most {} parameters", kMaxFunctionParameters))
                .with_help("put some of them together in a `record`");
        }
        bool has_default = false;
        for (const ParameterDecl& parameter : function.parameters) {
            has_default = has_default || parameter.default_value != nullptr;
            if (!has_default || parameter.default_value != nullptr) continue;
            error(Code::E0305, parameter.name_span,
                  fmt::format("`{}` needs a default, as a parameter before it has one",
                              symbols_.text(parameter.name)));
        }
    }
}

void FileChecker::function_body(Function& function) {
    Context* const outer = context_;
    context_ = &program_.functions.context(function);
    context_->frame_size = static_cast<std::uint32_t>(function.parameters.size());
    scopes_.open(function.body.items, *context_);
    parameter_names(function);
    ++program_.nesting;
    if (function.value != nullptr) {
        expression(*function.value);
    } else if (fits_nesting(function.name_span)) {
        Place place{Place::Kind::function, nullptr, scopes_.depth()};
        if (function.is_component) {
            place.kind = Place::Kind::block;
            place.schema = &block_schema(BlockKind::group);
            const Symbol children = symbols_.intern("children");
            function.children_slot = declare_value(children, function.body.open).slot;
            know_schema(function.body.open, place.schema);
        }
        declare_functions(function.body.items);
        items(function.body.items, place);
    }
    --program_.nesting;
    close_scope();
    context_ = outer;
}

void FileChecker::import(ImportItem& item) {
    Module* const module = item.module;
    if (module != nullptr && !module->is_checked) {
        module->is_checked = true;
        const std::string prefix =
            prefix_ + std::string(item.alias == kNoSymbol ? "" : symbols_.text(item.alias)) + '.';
        module->id = program_.checked.module_count++;
        module->frame_size = FileChecker(program_, prefix).check(module->items, module);
    }
    if (item.alias == kNoSymbol) return;
    new_name(item.alias, item.alias_span);
    Variable& variable = declare(item.alias, item.alias_span, Meaning::module);
    variable.module = module;
    variable.warns_if_unused = module != nullptr;
}

void FileChecker::member(MemberExpr& expr) {
    if (expr.object->kind == ExprKind::name) {
        NameExpr& object = static_cast<NameExpr&>(*expr.object);
        Variable* const variable = scopes_.find(object.symbol);
        if (variable != nullptr && variable->meaning == Meaning::module) {
            variable->is_used = true;
            object.meaning = Meaning::module;
            imported(expr, *variable);
            return;
        }
    }
    expression(*expr.object);
}

void FileChecker::imported(MemberExpr& expr, const Variable& alias) {
    NameExpr* const name = program_.arena.make<NameExpr>();
    name->kind = ExprKind::name;
    name->span = expr.span;
    name->symbol = expr.name;
    expr.imported = name;
    if (alias.module == nullptr) return;  // reported when it was loaded
    const auto& exports = program_.exports[alias.module];
    const auto found = exports.find(expr.name);
    const std::string_view text = symbols_.text(expr.name);
    const std::string& path = sources_[alias.module->source].path;
    const bool is_private = text.starts_with('_');
    if (found != exports.end() && !is_private) {
        Variable variable = found->second;
        const bool is_value = variable.meaning != Meaning::module;
        if (is_value && variable.let_kind != LetKind::var) {
            resolve(*name, variable);
            return;
        }
    }
    if (found != exports.end() && is_private) {
        error(Code::E0206, expr.name_span, fmt::format("`{}` is private to {}", text, path))
            .with_label(found->second.span, "defined here")
            .with_help("names that begin with `_` are used in their own file alone");
        return;
    }
    std::vector<std::string_view> names;
    if (diagnostics_.takes_hints()) {
        for (const auto& [symbol, variable] : exports) {
            const std::string_view known = symbols_.text(symbol);
            const bool is_given = variable.meaning != Meaning::module &&
                                  variable.let_kind != LetKind::var && !known.starts_with('_');
            if (is_given) names.push_back(known);
        }
    }
    error(Code::E0207, expr.name_span, fmt::format("{} has no `{}`", path, text))
        .with_hint(did_you_mean(text, names));
}

}  // namespace lray::parser
