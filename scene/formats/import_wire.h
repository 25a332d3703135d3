// What the importing program writes, as both sides know it: words of 32 bits in the order of the
// machine, floats and bytes.
//
//     answer  = kMagic part* kEnd | kMagic kFailure failure size byte*
//     part    = kPart name_size vertex_count triangle_count has byte*(name)
//               position* normal* uv* color* triangle*
//
// A position, a normal and a colour are three floats, a uv two, a triangle three numbers of
// vertices of its part. Normals, uvs and colours are there if `has` says so, one for each vertex.
#pragma once

#include <cstdint>

namespace lray::scene::wire {

inline constexpr std::uint32_t kMagic = 0x314d524cu;  // LRM1
inline constexpr std::uint32_t kPart = 1;
inline constexpr std::uint32_t kEnd = 2;
inline constexpr std::uint32_t kFailure = 3;

inline constexpr std::uint32_t kHasNormals = 1;
inline constexpr std::uint32_t kHasUvs = 2;
inline constexpr std::uint32_t kHasColors = 4;
inline constexpr std::uint32_t kHasAll = 7;

enum class Failure : std::uint32_t { not_understood = 1, out_of_memory = 2 };

inline constexpr std::uint32_t kMaxTextSize = 1000;  // of a name or a reason

}  // namespace lray::scene::wire
