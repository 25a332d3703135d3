// What keeps the folders apart: the table of docs/architecture.md, and the rules a source file must
// keep whatever it is about. Reads text alone, so that the rules can be tested on snippets.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lray::layering {

/// Which folders each folder may include, its own not counted; in the order of the rows.
struct FolderTable {
    std::vector<std::string> folders{};
    std::map<std::string, std::set<std::string>, std::less<>> may_include{};
};

/// Reads the table whose rows begin "| `folder/` |" and end with what that folder may include:
/// "–" for nothing, "all", or names of folders.
/// Errors: empty when there is no such row, a folder has two rows, or a cell names an unknown one.
std::optional<FolderTable> read_folder_table(std::string_view markdown);

/// Returns a sentence "path:line: what is wrong" for each broken rule in a file, `path` being
/// relative to the top of the tree ("bvh/build.cpp").
std::vector<std::string> broken_rules(std::string_view path, std::string_view text,
                                      const FolderTable& table);

}  // namespace lray::layering
