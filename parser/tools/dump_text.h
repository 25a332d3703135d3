// The text of a dump: numbers in their shortest exact form, and blocks in the formatter's style.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/transform.h"
#include "base/vec.h"
#include "scene/camera.h"

namespace lray::parser {

void append_exact(std::string& text, double number);

/// Appends the shortest number that is rounded to this float when it is read; of what overflowed to
/// infinity one that does so again.
void append_exact(std::string& text, float number);

std::string exact(double number);
std::string exact(float number);
std::string exact(DVec3 v);
std::string exact(scene::Resolution size);
std::string exact_color(Color color);

/// Returns degrees, in a short form, that are read as these radians.
std::string exact_angle(double radians);

std::string quoted(std::string_view text);

/// Returns the name of an option of a property, with quotes.
template <class Enum, std::size_t count>
std::string option(const std::array<std::string_view, count>& names, Enum value) {
    return quoted(names[static_cast<std::size_t>(value)]);
}

/// The items of a block, and how they are laid out.
class DumpBlock {
 public:
    void add(std::string_view name, std::string value) {
        items_.push_back(std::string(name) + ": " + std::move(value));
    }
    void add(std::string_view name, DVec3 v) { add(name, exact(v)); }
    void add(std::string_view name, double number) { add(name, exact(number)); }
    void add(std::string_view name, const char* value) { add(name, std::string(value)); }
    void add(std::string_view name, bool value) {
        add(name, std::string(value ? "true" : "false"));
    }

    /// Adds the steps that make a transform, to the bit.
    void add_steps(const Transform& transform);

    bool is_empty() const { return items_.empty(); }

    /// Returns `head { items }`, on one line if it fits behind `before` columns; the lines of
    /// several are indented by `indent`.
    std::string text(std::string_view head, std::size_t before, std::size_t indent) const;
    std::string text(std::string_view head, std::size_t indent) const {
        return text(head, indent, indent);
    }
    /// Likewise, behind `let name = `.
    std::string definition_text(std::string_view head, std::size_t before) const {
        return text(head, before, 0);
    }

    /// Appends the items as lines of their own.
    void append_lines(std::string& text, std::size_t indent) const;

 private:
    std::vector<std::string> items_;
};

}  // namespace lray::parser
