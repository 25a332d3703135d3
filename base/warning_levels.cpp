#include "base/warning_levels.h"

#include <fmt/format.h>

#include <vector>

#include "base/did_you_mean.h"

namespace lray {
namespace {

/// Returns the warning of that code or name, or the error of that code.
std::optional<Code> find_by_code_or_name(std::string_view name) {
    if (const auto code = find_code(name)) return code;
    for (const CodeInfo& info : code_infos()) {
        if (is_warning(info) && slug(info) == name) return info.code;
    }
    return std::nullopt;
}

std::string unknown_warning(std::string_view name) {
    std::vector<std::string> names;
    for (const CodeInfo& info : code_infos()) {
        if (!is_warning(info)) continue;
        names.emplace_back(info.id);
        names.push_back(slug(info));
    }
    names.emplace_back("all");
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const std::string near = did_you_mean(name, candidates);
    return fmt::format("takes the code or the name of a warning, not `{}`; {}", name,
                       near.empty() ? "`lray --explain warnings` lists them" : near);
}

}  // namespace

WarningLevels::WarningLevels() {
    for (const CodeInfo& info : code_infos()) {
        levels_[static_cast<std::size_t>(info.code)] =
            info.is_on ? WarningLevel::warn : WarningLevel::allow;
    }
}

std::optional<std::string> WarningLevels::set(std::string_view name, WarningLevel level) {
    if (name == "all" || name == "warnings") {
        for (WarningLevel& one : levels_) {
            const bool stays_silent = level == WarningLevel::deny && one == WarningLevel::allow;
            if (!stays_silent) one = level;
        }
        return std::nullopt;
    }
    const auto code = find_by_code_or_name(name);
    if (!code) return unknown_warning(name);
    if (!is_warning(code_info(*code))) {
        return fmt::format("takes warnings; {} is an error", code_info(*code).id);
    }
    levels_[static_cast<std::size_t>(*code)] = level;
    return std::nullopt;
}

}  // namespace lray
