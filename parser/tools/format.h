// The formatter: a scene in, the same scene in the canonical style out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "parser/load.h"

namespace lray::parser {

/// Returns the text of a source in the canonical style, which is the same text when it is formatted
/// again. Tokens and comments stay what they are and in their order; only blanks, line ends,
/// separators and the spelling of numbers and colours change. Needs no tree: a text with errors of
/// syntax keeps them.
/// Errors: empty when the text has a lexical error (E00..) or its brackets do not match or are
/// nested deeper than the limit, reported as load() does; E0516 when the result would be larger
/// than a scene may be.
std::optional<std::string> format(SourceId source, Sources& sources, const LoadLimits& limits,
                                  Diagnostics& diagnostics);

struct FormattedFile {
    SourceId source = kNoSource;
    std::string text{};
};

/// Reads a file that the user named, and formats it.
/// Errors: empty, E06.., as format(), or E01.. of a scene that the parser does not understand: what
/// it means may hang on how it is laid out.
std::optional<FormattedFile> format_file(std::string_view path, const LoadLimits& limits,
                                         FileAccess& files, Sources& sources,
                                         Diagnostics& diagnostics);

}  // namespace lray::parser
