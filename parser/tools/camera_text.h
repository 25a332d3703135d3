// A camera as its block in a scene, and the reverse question: is a text nothing but such blocks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "scene/camera.h"

namespace lray::parser {

/// `changes`: where it stands, what it looks at, and what differs from the defaults. `all`: also
/// what is as it would be without.
enum class CameraDetail : std::uint8_t { changes, all };

/// Returns the block of a camera, with its name, in the canonical style and without a line end. It
/// is read back to the same bits.
/// Space: an angle of view that no degrees are read as (one in ten, if it was not written in
/// degrees) comes back with another last bit.
std::string camera_text(const scene::Camera& camera, CameraDetail detail = CameraDetail::changes);

/// True if a text holds cameras with names and nothing else, each property a literal: what would
/// be lost if it was read and written again are blanks and ways to spell numbers. False for any
/// comment, any other item, whatever is computed, and a text with mistakes.
bool is_cameras_alone(std::string_view text);

}  // namespace lray::parser
