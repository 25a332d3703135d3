// Embree's side: the same triangles in shared buffers, spheres as a geometry of the user's.
#include <embree3/rtcore.h>
#include <sys/types.h>

#include <atomic>
#include <cstdlib>

#include <fmt/format.h>

#include "base/numerics.h"
#include "bench/embree_spheres.h"
#include "bench/trace_side.h"

namespace lray::bench {

namespace {

constexpr unsigned kPacketRays = 16;

void stop_at_error(void*, RTCError, const char* message) {
    fmt::print(stderr, "Embree: {}\n", message);
    std::exit(1);
}

/// Adds up what Embree asks memory for.
bool count_memory(void* bytes, ssize_t change, bool) {
    *static_cast<std::atomic<std::int64_t>*>(bytes) += change;
    return true;
}

RTCBuildQuality embree_quality(bvh::BuildQuality quality) {
    switch (quality) {
        case bvh::BuildQuality::low:
            return RTC_BUILD_QUALITY_LOW;
        case bvh::BuildQuality::medium:
            return RTC_BUILD_QUALITY_MEDIUM;
        case bvh::BuildQuality::high:
            return RTC_BUILD_QUALITY_HIGH;
    }
    std::abort();
}

RTCRay single_ray(const Ray& ray, Interval interval) {
    RTCRay result{};
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.tnear = interval.lo;
    result.dir_x = ray.dir.x;
    result.dir_y = ray.dir.y;
    result.dir_z = ray.dir.z;
    result.tfar = interval.hi;
    result.mask = ~0u;
    return result;
}

void put_ray(RTCRay16& packet, unsigned k, const RTCRay& ray) {
    packet.org_x[k] = ray.org_x;
    packet.org_y[k] = ray.org_y;
    packet.org_z[k] = ray.org_z;
    packet.tnear[k] = ray.tnear;
    packet.dir_x[k] = ray.dir_x;
    packet.dir_y[k] = ray.dir_y;
    packet.dir_z[k] = ray.dir_z;
    packet.time[k] = ray.time;
    packet.tfar[k] = ray.tfar;
    packet.mask[k] = ray.mask;
    packet.id[k] = ray.id;
    packet.flags[k] = ray.flags;
}

class EmbreeSide : public TraceSide {
 public:
    EmbreeSide(const scene::World& world, bvh::BuildQuality quality, bool is_robust,
               bool is_batched)
        : world_(world), quality_(quality), is_robust_(is_robust), is_batched_(is_batched) {
        device_ = rtcNewDevice("threads=1");
        rtcSetDeviceErrorFunction(device_, stop_at_error, nullptr);
        rtcSetDeviceMemoryMonitorFunction(device_, count_memory, &bytes_);
    }
    ~EmbreeSide() override {
        clear();
        rtcReleaseDevice(device_);
    }
    EmbreeSide(const EmbreeSide&) = delete;
    EmbreeSide& operator=(const EmbreeSide&) = delete;

    std::string name() const override { return is_robust_ ? "Embree robust" : "Embree"; }

    void build() override {
        bytes_before_ = bytes_;
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, is_robust_ ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
        rtcSetSceneBuildQuality(scene_, embree_quality(quality_));
        if (!world_.triangles.empty()) add_triangles();
        if (!world_.spheres.empty()) add_spheres(device_, scene_, world_.spheres);
        rtcCommitScene(scene_);
    }

    void clear() override {
        if (scene_) rtcReleaseScene(scene_);
        scene_ = nullptr;
    }

    std::size_t bytes() const override { return static_cast<std::size_t>(bytes_ - bytes_before_); }

    void load(const RaySet& rays) override;
    void trace() override;
    std::vector<float> distances() const override;

 private:
    void add_triangles() {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   world_.vertices.data(), 0, sizeof(Vec3), world_.vertices.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   world_.triangles.data(), 0, sizeof(scene::Triangle),
                                   world_.triangles.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }

    const scene::World& world_;
    bvh::BuildQuality quality_{};
    bool is_robust_ = false;
    bool is_batched_ = false;
    std::atomic<std::int64_t> bytes_{0};
    std::int64_t bytes_before_ = 0;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;

    // Traced in place: of these one has rays.
    std::size_t ray_count_ = 0;
    bool is_any_hit_ = false;
    std::vector<RTCRayHit> single_{};
    std::vector<RTCRay> single_any_{};
    std::vector<RTCRayHit16> packets_{};
    std::vector<RTCRay16> packets_any_{};
};

void EmbreeSide::load(const RaySet& rays) {
    ray_count_ = rays.size();
    is_any_hit_ = rays.is_any_hit;
    const std::size_t packet_count = (ray_count_ + kPacketRays - 1) / kPacketRays;
    single_.resize(!is_batched_ && !is_any_hit_ ? ray_count_ : 0);
    single_any_.resize(!is_batched_ && is_any_hit_ ? ray_count_ : 0);
    packets_.resize(is_batched_ && !is_any_hit_ ? packet_count : 0);
    packets_any_.resize(is_batched_ && is_any_hit_ ? packet_count : 0);
    for (std::size_t i = 0; i < ray_count_; ++i) {
        const RTCRay ray = single_ray(rays.rays[i], rays.intervals[i]);
        const auto k = static_cast<unsigned>(i % kPacketRays);
        if (!is_batched_ && is_any_hit_) {
            single_any_[i] = ray;
        } else if (!is_batched_) {
            single_[i].ray = ray;
            single_[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
            single_[i].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        } else if (is_any_hit_) {
            put_ray(packets_any_[i / kPacketRays], k, ray);
        } else {
            RTCRayHit16& packet = packets_[i / kPacketRays];
            put_ray(packet.ray, k, ray);
            packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
    }
}

void EmbreeSide::trace() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (RTCRayHit& ray : single_) rtcIntersect1(scene_, &context, &ray);
    for (RTCRay& ray : single_any_) rtcOccluded1(scene_, &context, &ray);
    if (!is_batched_) return;
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[kPacketRays];
    for (std::size_t i = 0; i < ray_count_; i += kPacketRays) {
        for (unsigned k = 0; k < kPacketRays; ++k) valid[k] = i + k < ray_count_ ? -1 : 0;
        if (is_any_hit_) {
            rtcOccluded16(valid, scene_, &context, &packets_any_[i / kPacketRays]);
        } else {
            rtcIntersect16(valid, scene_, &context, &packets_[i / kPacketRays]);
        }
    }
}

std::vector<float> EmbreeSide::distances() const {
    std::vector<float> result(ray_count_);
    for (std::size_t i = 0; i < ray_count_; ++i) {
        const std::size_t packet = i / kPacketRays;
        const std::size_t k = i % kPacketRays;
        if (is_any_hit_) {
            // Embree makes tfar -infinity where something is hit.
            const float far = is_batched_ ? packets_any_[packet].tfar[k] : single_any_[i].tfar;
            result[i] = far < 0.0f ? 0.0f : kInfinity;
        } else {
            const bool is_hit = (is_batched_ ? packets_[packet].hit.geomID[k]
                                             : single_[i].hit.geomID) != RTC_INVALID_GEOMETRY_ID;
            const float far = is_batched_ ? packets_[packet].ray.tfar[k] : single_[i].ray.tfar;
            result[i] = is_hit ? far : kInfinity;
        }
    }
    return result;
}

}  // namespace

std::vector<std::unique_ptr<TraceSide>> make_embree_sides(const scene::World& world,
                                                          bvh::BuildQuality quality,
                                                          bool is_batched) {
    std::vector<std::unique_ptr<TraceSide>> result;
    result.push_back(std::make_unique<EmbreeSide>(world, quality, false, is_batched));
    result.push_back(std::make_unique<EmbreeSide>(world, quality, true, is_batched));
    return result;
}

}  // namespace lray::bench
