#include "shade/shader.h"

#include "base/assert.h"
#include "shade/cost.h"
#include "shade/depth.h"
#include "shade/flat.h"
#include "shade/normals.h"
#include "shade/uv.h"

namespace lray::shade {

Color shade(const ShadeInput& input, const Ray& ray, const bvh::Hit& hit,
            const bvh::TraceCounts& counts) {
    switch (input.settings.shader) {
        case Shader::full:
            break;  // follow_light() is asked
        case Shader::flat:
            return flat(input.world, hit, input.settings.background);
        case Shader::normals:
            return normals(input.world, ray, hit);
        case Shader::uv:
            return uv(input.world, ray, hit);
        case Shader::depth:
            return depth(hit, input.settings.depth_unit);
        case Shader::cost:
            return cost(counts);
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::shade
