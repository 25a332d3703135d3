// Reads a program: a file with all it includes and imports, one inside the other.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "parser/file_loader.h"
#include "parser/load.h"
#include "parser/syntax/ast.h"
#include "parser/syntax/parser.h"

namespace lray::parser {

/// Parses files. An include is read again at each place that names it; an import once.
class ProgramLoader {
 public:
    ProgramLoader(ParseContext& context, FileLoader& files, const LoadLimits& limits,
                  Diagnostics& diagnostics)
        : context_(context), files_(files), limits_(limits), diagnostics_(diagnostics) {}

    /// Returns the items of a source, with those of its includes and imports below them. Recurses
    /// as deep as the include limit allows.
    /// Errors: E0515 too deep, E0601 and its like, E0602 a cycle, at the name of the file.
    std::span<Item* const> parse(SourceId source);

    /// False if the braces of a file do not match: what stands in which block is a guess.
    bool is_structure_known() const { return is_structure_known_; }

 private:
    void include(IncludeItem& item);
    void import(ImportItem& item);
    std::optional<SourceId> open(const StringExpr& path);
    bool is_open(SourceId source) const;
    void report_cycle(SourceId source, Span span);
    const std::string& path(SourceId source) const { return context_.sources[source].path; }

    ParseContext& context_;
    FileLoader& files_;
    const LoadLimits& limits_;
    Diagnostics& diagnostics_;
    std::vector<SourceId> open_;
    std::map<std::string, Module*> modules_;  // by the identity of their file
    bool is_structure_known_ = true;
};

}  // namespace lray::parser
