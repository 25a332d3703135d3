#include "parser/tools/camera_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/blocks/schemas.h"
#include "parser/symbols.h"
#include "parser/syntax/lexer.h"
#include "parser/tools/dump_text.h"

namespace lray::parser {

namespace {

/// To the bit: -0 is not 0.
template <class Value>
bool is_same(const Value& a, const Value& b) {
    return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

/// Goes through the tokens of a text.
class CameraReader {
 public:
    explicit CameraReader(std::string_view text)
        : source_(sources_.add("cameras", Text(std::string(text)))),
          text_(sources_[source_].text.view()),
          lexer_(sources_, source_, symbols_, diagnostics_) {
        advance();
    }

    // { camera [";"] }
    bool reads_cameras() {
        while (is_right_ && !is(TokenKind::end)) {
            if (!accept_word("camera") || !accept(TokenKind::string)) return false;
            if (!reads_body()) return false;
            accept(TokenKind::semicolon);
        }
        return is_right_ && !diagnostics_.has_errors();
    }

 private:
    // "{" { IDENT ":" literal [ "," | ";" ] } "}"
    bool reads_body() {
        if (!accept(TokenKind::left_brace)) return false;
        while (!accept(TokenKind::right_brace)) {
            const bool is_property =
                accept(TokenKind::identifier) && accept(TokenKind::colon) && reads_literal();
            if (!is_property) return false;
            if (!accept(TokenKind::comma)) accept(TokenKind::semicolon);
        }
        return true;
    }

    // literal = [ "-" ] NUMBER | STRING | COLOR | numbers | "rgb" "(" numbers ")"
    bool reads_literal() {
        if (accept(TokenKind::string) || accept(TokenKind::color)) return true;
        if (accept(TokenKind::left_bracket)) return reads_numbers(TokenKind::right_bracket);
        if (accept_word("rgb")) {
            return accept(TokenKind::left_paren) && reads_numbers(TokenKind::right_paren);
        }
        return reads_number();
    }

    bool reads_numbers(TokenKind closing) {
        while (!accept(closing)) {
            if (!reads_number()) return false;
            accept(TokenKind::comma);
        }
        return true;
    }

    bool reads_number() {
        accept(TokenKind::minus);
        return accept(TokenKind::number);
    }

    bool is(TokenKind kind) const { return is_right_ && token_.kind == kind; }

    bool accept(TokenKind kind) {
        if (!is(kind)) return false;
        advance();
        return true;
    }

    bool accept_word(std::string_view word) {
        if (!is(TokenKind::identifier) || symbols_.text(token_.symbol) != word) return false;
        advance();
        return true;
    }

    // Comments are what stands between two tokens and is not blank.
    void advance() {
        if (is(TokenKind::end)) return;
        const std::uint32_t before = token_.end();
        token_ = lexer_.next();
        const std::string_view between = text_.substr(before, token_.offset - before);
        is_right_ = is_right_ && std::ranges::all_of(between, [](char c) {
                        return c == ' ' || c == '\t' || c == '\n' || c == '\r';
                    });
    }

    Sources sources_;
    SourceId source_;
    std::string_view text_;
    Symbols symbols_;
    Diagnostics diagnostics_;
    Lexer lexer_;
    Token token_{.kind = TokenKind::nothing};
    bool is_right_ = true;
};

}  // namespace

std::string camera_text(const scene::Camera& camera, CameraDetail detail) {
    const scene::Camera defaults;
    const auto is_told = [&](auto scene::Camera::*property) {
        return detail == CameraDetail::all || !is_same(camera.*property, defaults.*property);
    };
    DumpBlock block;
    block.add("position", camera.position);
    block.add("look_at", camera.look_at);
    if (is_told(&scene::Camera::up)) block.add("up", camera.up);
    if (is_told(&scene::Camera::fov)) block.add("fov", exact_angle(camera.fov));
    if (is_told(&scene::Camera::projection)) {
        block.add("projection", option(schemas::kProjections, camera.projection));
    }
    if (is_told(&scene::Camera::height)) block.add("height", camera.height);
    if (!is_same(camera.aperture, defaults.aperture)) block.add("aperture", camera.aperture);
    if (camera.focus) block.add("focus", *camera.focus);
    if (camera.resolution) block.add("resolution", exact(*camera.resolution));
    if (camera.samples) block.add("samples", fmt::to_string(*camera.samples));
    if (camera.background) block.add("background", exact_color(*camera.background));
    const std::string head =
        camera.name.empty() ? "camera" : fmt::format("camera {}", quoted(camera.name));
    return block.text(head, 0);
}

bool is_cameras_alone(std::string_view text) {
    return CameraReader(text).reads_cameras();
}

}  // namespace lray::parser
