#include "tests/support/json.h"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace lray::test {

namespace {

class Reader {
 public:
    explicit Reader(std::string_view text) : text_(text) {}

    Json document() {
        Json value = read_value();
        skip_space();
        if (at_ != text_.size()) fail("something follows the value");
        return value;
    }

 private:
    [[noreturn]] void fail(const std::string& why) const {
        throw std::runtime_error("JSON, byte " + std::to_string(at_) + ": " + why);
    }

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    char next() {
        if (at_ == text_.size()) fail("it ends too early");
        return text_[at_++];
    }

    void expect(std::string_view word) {
        if (text_.substr(at_, word.size()) != word) fail("expected " + std::string(word));
        at_ += word.size();
    }

    void skip_space() {
        while (peek() == ' ' || peek() == '\n' || peek() == '\r' || peek() == '\t') ++at_;
    }

    Json read_value() {
        skip_space();
        Json value;
        switch (peek()) {
            case '{':
                return object();
            case '[':
                return array();
            case '"':
                value.kind = JsonKind::string;
                value.string = read_string();
                return value;
            case 't':
                expect("true");
                value.kind = JsonKind::boolean;
                value.number = 1.0;
                return value;
            case 'f':
                expect("false");
                value.kind = JsonKind::boolean;
                return value;
            case 'n':
                expect("null");
                return value;
            default:
                return number();
        }
    }

    Json object() {
        Json value;
        value.kind = JsonKind::object;
        expect("{");
        skip_space();
        for (bool is_first = true; peek() != '}'; is_first = false) {
            if (!is_first) expect(",");
            skip_space();
            std::string name = read_string();
            skip_space();
            expect(":");
            if (!value.members.emplace(name, read_value()).second) fail(name + " stands twice");
            skip_space();
        }
        expect("}");
        return value;
    }

    Json array() {
        Json value;
        value.kind = JsonKind::array;
        expect("[");
        skip_space();
        for (bool is_first = true; peek() != ']'; is_first = false) {
            if (!is_first) expect(",");
            value.elements.push_back(read_value());
            skip_space();
        }
        expect("]");
        return value;
    }

    void digits() {
        if (peek() < '0' || peek() > '9') fail("expected a digit");
        while (peek() >= '0' && peek() <= '9') ++at_;
    }

    Json number() {
        const std::size_t begin = at_;
        if (peek() == '-') ++at_;
        if (peek() == '0') {
            ++at_;
        } else {
            digits();
        }
        if (peek() == '.') {
            ++at_;
            digits();
        }
        if (peek() == 'e' || peek() == 'E') {
            ++at_;
            if (peek() == '+' || peek() == '-') ++at_;
            digits();
        }
        Json value;
        value.kind = JsonKind::number;
        value.number = std::strtod(std::string(text_.substr(begin, at_ - begin)).c_str(), nullptr);
        return value;
    }

    std::uint32_t code_unit() {
        std::uint32_t unit = 0;
        for (int i = 0; i < 4; ++i) {
            const char c = next();
            if (std::string_view("0123456789abcdefABCDEF").find(c) == std::string_view::npos) {
                fail("expected a hexadecimal digit");
            }
            unit =
                unit * 16 + static_cast<std::uint32_t>(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
        }
        return unit;
    }

    /// Only units of the basic plane, which is all that is ever escaped here.
    static void append_utf8(std::string& text, std::uint32_t c) {
        if (c < 0x80) {
            text += static_cast<char>(c);
        } else if (c < 0x800) {
            text += static_cast<char>(0xc0 | c >> 6);
            text += static_cast<char>(0x80 | (c & 0x3f));
        } else {
            text += static_cast<char>(0xe0 | c >> 12);
            text += static_cast<char>(0x80 | (c >> 6 & 0x3f));
            text += static_cast<char>(0x80 | (c & 0x3f));
        }
    }

    void escape(std::string& text) {
        const char c = next();
        constexpr std::string_view kNames = "\"\\/bfnrt";
        constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
        if (c == 'u') {
            const std::uint32_t unit = code_unit();
            if (unit >= 0xd800 && unit < 0xe000) fail("a surrogate");
            append_utf8(text, unit);
        } else if (const std::size_t i = kNames.find(c); i != kNames.npos) {
            text += kMeanings[i];
        } else {
            fail("an unknown escape");
        }
    }

    /// Copies a character of several bytes, as far as lead and continuation bytes agree.
    void copy_multibyte(std::string& text, unsigned char lead) {
        const int size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
        if (lead < 0xc2 || lead > 0xf4) fail("a byte that is not UTF-8");
        text += static_cast<char>(lead);
        for (int i = 1; i < size; ++i) {
            const auto byte = static_cast<unsigned char>(next());
            if ((byte & 0xc0) != 0x80) fail("a byte that is not UTF-8");
            text += static_cast<char>(byte);
        }
    }

    std::string read_string() {
        expect("\"");
        std::string text;
        while (true) {
            const char c = next();
            const auto byte = static_cast<unsigned char>(c);
            if (c == '"') return text;
            if (c == '\\') {
                escape(text);
            } else if (byte < 0x20) {
                fail("a control character in a string");
            } else if (byte >= 0x80) {
                copy_multibyte(text, byte);
            } else {
                text += c;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

Json read_json(std::string_view text) {
    return Reader(text).document();
}

}  // namespace lray::test
