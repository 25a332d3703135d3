// Writes JSON (RFC 8259) without line breaks, piece by piece. Knows nothing of what it writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lray {

/// Commas and quotes are the writer's business; that objects and arrays are closed in order, and
/// that each value in an object has a key, is asserted.
class JsonWriter {
 public:
    JsonWriter& begin_object();
    JsonWriter& end_object();
    JsonWriter& begin_array();
    JsonWriter& end_array();
    JsonWriter& key(std::string_view name);

    /// Control characters are escaped; what is not UTF-8 becomes U+FFFD, byte by byte. Characters
    /// that command a terminal are escaped as well.
    JsonWriter& string(std::string_view text);
    JsonWriter& number(std::uint64_t number);
    /// The shortest text that reads back as the same double; JSON has none for NaN and infinity,
    /// which become null.
    JsonWriter& decimal(double number);
    JsonWriter& null();

    JsonWriter& member(std::string_view name, std::string_view text) {
        return key(name).string(text);
    }
    JsonWriter& member(std::string_view name, std::uint64_t value) {
        return key(name).number(value);
    }

    /// Returns the text; everything is closed.
    std::string take();

 private:
    struct Level {
        char closer = '\0';
        bool has_elements = false;
        bool has_key = false;
    };

    void begin_value();
    void open(char opener, char closer);
    void close(char closer);
    void write_string(std::string_view text);

    std::string text_;
    std::vector<Level> levels_;
};

}  // namespace lray
