// The ids of what a scene is made of.
#pragma once

#include "base/ids.h"

namespace lray::scene {

using NodeId = Id<struct NodeTag>;
using MaterialId = Id<struct MaterialTag>;
using TransformId = Id<struct TransformTag>;
using LabelId = Id<struct LabelTag>;
using MeshId = Id<struct MeshTag>;
using TextureId = Id<struct TextureTag>;
using PictureId = Id<struct PictureTag>;
using ObjectId = Id<struct ObjectTag>;

}  // namespace lray::scene
