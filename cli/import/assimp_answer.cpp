#include "cli/import/assimp_answer.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include "scene/formats/import_wire.h"

namespace lray::import {

namespace {

namespace wire = scene::wire;

/// Collects what is written until it is worth a call.
class Writer {
 public:
    explicit Writer(int descriptor) : descriptor_(descriptor) {}

    template <class T>
    void add(const T& value) {
        add_bytes(&value, sizeof value);
    }
    void add_bytes(const void* bytes, std::size_t size) {
        const char* const begin = static_cast<const char*>(bytes);
        buffer_.insert(buffer_.end(), begin, begin + size);
        if (buffer_.size() >= kFull) flush();
    }

    /// Returns false if something could not be written.
    bool flush() {
        const char* at = buffer_.data();
        std::size_t left = buffer_.size();
        while (is_good_ && left > 0) {
            const ssize_t size = write(descriptor_, at, left);
            if (size < 0 && errno == EINTR) continue;
            is_good_ = size > 0;
            if (!is_good_) break;
            at += size;
            left -= static_cast<std::size_t>(size);
        }
        buffer_.clear();
        return is_good_;
    }
    bool is_good() const { return is_good_; }

 private:
    static constexpr std::size_t kFull = std::size_t{1} << 18;

    int descriptor_;
    bool is_good_ = true;
    std::vector<char> buffer_{};
};

/// There are no other files.
class NoFiles : public Assimp::IOSystem {
 public:
    bool Exists(const char*) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
    void Close(Assimp::IOStream*) override {}
};

void write_failure(Writer& out, wire::Failure kind, std::string_view reason) {
    const auto size =
        static_cast<std::uint32_t>(std::min<std::size_t>(reason.size(), wire::kMaxTextSize));
    out.add(wire::kMagic);
    out.add(wire::kFailure);
    out.add(static_cast<std::uint32_t>(kind));
    out.add(size);
    out.add_bytes(reason.data(), size);
}

/// Normals are moved by the cofactors: the inverse transpose, but for a length that does not
/// matter, and the sign.
aiMatrix3x3 cofactors(const aiMatrix3x3& m, bool is_mirrored) {
    const float s = is_mirrored ? -1.0f : 1.0f;
    return {s * (m.b2 * m.c3 - m.b3 * m.c2), s * (m.b3 * m.c1 - m.b1 * m.c3),
            s * (m.b1 * m.c2 - m.b2 * m.c1), s * (m.a3 * m.c2 - m.a2 * m.c3),
            s * (m.a1 * m.c3 - m.a3 * m.c1), s * (m.a2 * m.c1 - m.a1 * m.c2),
            s * (m.a2 * m.b3 - m.a3 * m.b2), s * (m.a3 * m.b1 - m.a1 * m.b3),
            s * (m.a1 * m.b2 - m.a2 * m.b1)};
}

void write_vector(Writer& out, const aiVector3D& v) {
    out.add(std::array<float, 3>{v.x, v.y, v.z});
}

void write_mesh(Writer& out, const aiMesh& mesh, const aiString& name,
                const aiMatrix4x4& world_from_mesh) {
    const aiMatrix3x3 linear(world_from_mesh);
    const bool is_mirrored = linear.Determinant() < 0.0f;
    const bool has_uvs = mesh.HasTextureCoords(0);
    const bool has_colors = mesh.HasVertexColors(0);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(mesh.mNumFaces);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) continue;
        const unsigned* const v = face.mIndices;
        triangles.push_back({v[0], is_mirrored ? v[2] : v[1], is_mirrored ? v[1] : v[2]});
    }
    const auto name_size = std::min<std::uint32_t>(name.length, wire::kMaxTextSize);
    out.add(wire::kPart);
    out.add(name_size);
    out.add(std::uint32_t{mesh.mNumVertices});
    out.add(static_cast<std::uint32_t>(triangles.size()));
    out.add((mesh.HasNormals() ? wire::kHasNormals : 0u) | (has_uvs ? wire::kHasUvs : 0u) |
            (has_colors ? wire::kHasColors : 0u));
    out.add_bytes(name.data, name_size);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        write_vector(out, world_from_mesh * mesh.mVertices[i]);
    }
    if (mesh.HasNormals()) {
        const aiMatrix3x3 map = cofactors(linear, is_mirrored);
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) write_vector(out, map * mesh.mNormals[i]);
    }
    if (has_uvs) {
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D& uv = mesh.mTextureCoords[0][i];
            out.add(std::array<float, 2>{uv.x, uv.y});
        }
    }
    if (has_colors) {
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiColor4D& color = mesh.mColors[0][i];
            out.add(std::array<float, 3>{color.r, color.g, color.b});
        }
    }
    out.add_bytes(triangles.data(), triangles.size() * sizeof triangles[0]);
}

/// The nodes in the order of the file, each mesh in each place.
void write_scene(Writer& out, const aiScene& scene) {
    out.add(wire::kMagic);
    struct Step {
        const aiNode* node = nullptr;
        aiMatrix4x4 world_from_node{};
    };
    std::vector<Step> steps = {{scene.mRootNode, scene.mRootNode->mTransformation}};
    while (!steps.empty() && out.is_good()) {
        const auto [node, world_from_node] = steps.back();
        steps.pop_back();
        for (unsigned i = 0; i < node->mNumMeshes; ++i) {
            const aiMesh& mesh = *scene.mMeshes[node->mMeshes[i]];
            const bool is_named = node->mName.length > 0;
            write_mesh(out, mesh, is_named ? node->mName : mesh.mName, world_from_node);
        }
        for (unsigned i = node->mNumChildren; i > 0; --i) {
            const aiNode* const child = node->mChildren[i - 1];
            steps.push_back({child, world_from_node * child->mTransformation});
        }
    }
    out.add(wire::kEnd);
}

void import(std::span<const char> bytes, std::string_view ending, Writer& out) {
    Assimp::Importer importer;
    importer.SetIOHandler(new NoFiles);  // which the importer owns
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    unsigned steps =
        aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices;
    if (ending == "stl") {
        // The normals of its facets say what their corners do, if they are right at all.
        importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS);
        steps |= aiProcess_RemoveComponent;
    }
    const std::string hint(ending);
    const aiScene* const scene =
        importer.ReadFileFromMemory(bytes.data(), bytes.size(), steps, hint.c_str());
    if (scene != nullptr && scene->mRootNode != nullptr) {
        write_scene(out, *scene);
        return;
    }
    const std::string_view reason = importer.GetErrorString();
    const bool is_memory = reason.find("bad_alloc") != reason.npos;
    write_failure(out, is_memory ? wire::Failure::out_of_memory : wire::Failure::not_understood,
                  reason);
}

}  // namespace

bool answer(std::span<const char> bytes, std::string_view ending, int descriptor) {
    // What was written before something is thrown makes the answer one that is not believed.
    Writer out(descriptor);
    try {
        import(bytes, ending, out);
    } catch (const std::bad_alloc&) {
        write_failure(out, wire::Failure::out_of_memory, {});
    } catch (const std::exception& error) {
        write_failure(out, wire::Failure::not_understood, error.what());
    }
    return out.flush();
}

}  // namespace lray::import
