// What grammar.md lists, written as Markdown from the tables the parser works with.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lray::parser {

/// A generated stretch of grammar.md, between `<!-- begin NAME -->` and `<!-- end NAME -->`.
struct GeneratedText {
    std::string name{};
    std::string text{};  // whole lines
};

/// Words, units of the language, blocks in the order of their schema, functions, colours.
std::vector<GeneratedText> generated_texts();

/// Returns a generated text as it stands in a document; empty if its marks are not there, in this
/// order and once.
std::string text_between_marks(const std::string& document, const std::string& name);

/// Returns the document with a generated text put between its marks, which are there.
std::string with_text_between_marks(const std::string& document, const GeneratedText& generated);

/// The productions of an EBNF text, `name = body`, without comments and with single spaces.
/// Several stand on a line with ` ;  ` between them; a body goes on to the next name.
using Productions = std::vector<std::pair<std::string, std::string>>;
Productions productions_of(const std::string& ebnf);

/// Returns the comment lines that carry a production, of C++ source text, without their `//`.
std::string production_comments(const std::string& source);

}  // namespace lray::parser
