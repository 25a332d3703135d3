#include "tests/layering/layering.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

namespace lray::layering {
namespace {

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream stream{std::string(text)};
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string_view first_folder(std::string_view path) {
    const std::size_t slash = path.find('/');
    return slash == std::string_view::npos ? std::string_view{} : path.substr(0, slash);
}

std::string_view without_comment(std::string_view line) {
    return line.substr(0, line.find("//"));
}

/// Says what is wrong with one #include; empty if nothing is.
std::string broken_include_rule(std::string_view path, std::string_view included, bool is_quoted,
                                const FolderTable& table) {
    if (first_folder(included) == "glm") {
        return path == "base/vec.h" ? "" : "GLM is included by base/vec.h alone";
    }
    if (included.find("../") != std::string_view::npos) {
        return "includes are written from the top of the tree, without ../";
    }
    const std::string_view to = first_folder(included);
    const bool is_ours = table.may_include.contains(to);
    if (!is_quoted) return is_ours ? "what is lray's is included in quotes" : "";
    if (!is_ours) {
        return "quotes are for headers of lray, written from the top of the tree";
    }
    const std::string_view from = first_folder(path);
    const auto row = table.may_include.find(from);
    if (from == to || row == table.may_include.end()) return "";
    return row->second.contains(std::string(to))
               ? ""
               : fmt::format("{}/ may not include {}/ (docs/architecture.md)", from, to);
}

/// Fused or approximate operations, which would make pictures depend on the processor.
bool is_inexact_operation(std::string_view line) {
    static const std::regex kPattern(
        R"(\bfma[fl]?\s*\(|\bstd::fma\b|__builtin_fma|_mm\w*_f?n?m(add|sub)_|)"
        R"(\w*Mul(Add|Sub)\w*|Approximate(Reciprocal)\w*)");
    return std::regex_search(line.begin(), line.end(), kPattern);
}

}  // namespace

std::optional<FolderTable> read_folder_table(std::string_view markdown) {
    static const std::regex kRow(R"(^\|\s*`(\w+)/`\s*\|.*\|\s*([^|]*?)\s*\|\s*$)");
    FolderTable table;
    std::vector<std::string> cells;
    for (const std::string& line : split_lines(markdown)) {
        std::smatch match;
        if (!std::regex_match(line, match, kRow)) continue;
        if (std::ranges::find(table.folders, match.str(1)) != table.folders.end()) return {};
        table.folders.push_back(match.str(1));
        cells.push_back(match.str(2));
    }
    if (table.folders.empty()) return {};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::set<std::string>& may_include = table.may_include[table.folders[i]];
        if (cells[i] == "–") continue;
        if (cells[i] == "all") {
            may_include.insert(table.folders.begin(), table.folders.end());
            continue;
        }
        std::istringstream words(cells[i]);
        for (std::string word; words >> word;) {
            if (std::ranges::find(table.folders, word) == table.folders.end()) return {};
            may_include.insert(word);
        }
        if (may_include.empty()) return {};
    }
    return table;
}

std::vector<std::string> broken_rules(std::string_view path, std::string_view text,
                                      const FolderTable& table) {
    static const std::regex kInclude(R"(^\s*#\s*include\s*(["<])([^">]+)[">].*)");
    std::vector<std::string> broken;
    if (!table.may_include.contains(first_folder(path))) {
        broken.push_back(fmt::format("{}:1: its folder is not in docs/architecture.md", path));
    }
    const std::vector<std::string> lines = split_lines(text);
    bool has_pragma_once = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        const auto report = [&](std::string_view what) {
            broken.push_back(fmt::format("{}:{}: {}", path, i + 1, what));
        };
        has_pragma_once = has_pragma_once || line.starts_with("#pragma once");
        std::smatch match;
        if (std::regex_match(line, match, kInclude)) {
            const std::string what =
                broken_include_rule(path, match.str(2), match.str(1) == "\"", table);
            if (!what.empty()) report(what);
        } else if (first_folder(path) == "bvh" && is_inexact_operation(without_comment(line))) {
            report("bvh/ uses no fused or approximate operations (docs/style.md, 18)");
        }
    }
    // What ends in -inl.h is included once for each processor and guards itself.
    if (path.ends_with(".h") && !path.ends_with("-inl.h") && !has_pragma_once) {
        broken.push_back(fmt::format("{}:1: a header begins with #pragma once", path));
    }
    return broken;
}

}  // namespace lray::layering
