#include "scene/scene.h"

#include "base/assert.h"

namespace lray::scene {

std::string_view name_of(NodeKind kind) {
    switch (kind) {
        case NodeKind::group:
            return "group";
        case NodeKind::sphere:
            return "sphere";
        case NodeKind::rectangle:
            return "rectangle";
        case NodeKind::triangle:
            return "triangle";
        case NodeKind::cylinder:
            return "cylinder";
        case NodeKind::disk:
            return "disk";
        case NodeKind::box:
            return "box";
        case NodeKind::plane:
            return "plane";
        case NodeKind::torus:
            return "torus";
        case NodeKind::mesh:
            return "mesh";
        case NodeKind::instance:
            return "instance";
        case NodeKind::light:
            return "light";
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::scene
