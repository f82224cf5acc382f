#include "world.hpp"

#include "footprint.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace render {
namespace {

/// Embree reads 16 bytes at the last vertex, so its buffers are allocated by Embree itself.
template <typename T>
T *newBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
    void *buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), count);
    if (!buffer) throw std::runtime_error("Embree: no memory for a geometry buffer");
    return static_cast<T *>(buffer);
}

#if RTC_VERSION_MAJOR >= 4
void intersectWith(RTCScene scene, RTCRayHit &query) { rtcIntersect1(scene, &query); }
void occludedBy(RTCScene scene, RTCRay &query) { rtcOccluded1(scene, &query); }
#else
void intersectWith(RTCScene scene, RTCRayHit &query) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
}

void occludedBy(RTCScene scene, RTCRay &query) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &query);
}
#endif

RTCRay toEmbree(const Ray &ray) {
    RTCRay r{};
    r.org_x = ray.origin.x, r.org_y = ray.origin.y, r.org_z = ray.origin.z;
    r.dir_x = ray.direction.x, r.dir_y = ray.direction.y, r.dir_z = ray.direction.z;
    r.tfar = std::numeric_limits<float>::infinity();
    r.mask = ~0u;
    return r;
}

template <typename T>
T interpolate(const std::array<T, 3> &corners, float u, float v) {
    return corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v;
}

/// `near` is rounded at the scale of the ray; its projection onto the sphere is exact at the scale
/// of the sphere.
SurfacePoint pointOnSphere(const Sphere &sphere, const V3f &near) {
    const V3f normal = (near - sphere.centre).normalized();
    SurfacePoint point;
    point.position = sphere.centre + normal * sphere.radius;
    point.geometricNormal = normal;
    point.shading = frameAround(normal);
    // The picture's middle faces the camera's side, +z, and its seam is behind.
    point.uv = {0.5f + std::atan2(normal.x, normal.z) / (2 * pi),
                1 - std::acos(std::clamp(normal.y, -1.0f, 1.0f)) / pi};
    const V3f around = cross(V3f(0, 1, 0), normal);
    point.alongU = around * (2 * pi * sphere.radius);
    point.alongV = cross(normal, around).normalized() * (pi * sphere.radius); // 0 at the poles
    point.objectPosition = normal;
    return point;
}

SurfacePoint pointOnMesh(const Mesh &mesh, unsigned triangle, float u, float v) {
    const Mesh::Triangle &index = mesh.triangles[triangle];
    const V3f &a = mesh.positions[index[0]], &b = mesh.positions[index[1]], &c = mesh.positions[index[2]];
    SurfacePoint point;
    point.position = a + (b - a) * u + (c - a) * v;
    point.geometricNormal = cross(b - a, c - a).normalized();
    V3f normal = interpolate(mesh.normals[triangle], u, v).normalized();
    // Opposite vertex normals cancel: fall back. A normal on the other side is a mesh whose faces
    // turn clockwise: the normals say where the outside is.
    if (normal.length2() == 0) normal = point.geometricNormal;
    if (dot(normal, point.geometricNormal) < 0) point.geometricNormal = -point.geometricNormal;
    point.shading = frameAround(normal);
    point.uv = interpolate(mesh.uvs[triangle], u, v);
    const TextureTangents tangents = textureTangents({a, b, c}, mesh.uvs[triangle]);
    point.alongU = tangents.alongU;
    point.alongV = tangents.alongV;
    point.objectPosition = point.position;
    return point;
}

} // namespace

// One thread builds the hierarchy: it is then the same in every run, and so is every picture.
World::World() : device_(rtcNewDevice("threads=1")) {
    if (!device_) throw std::runtime_error("Embree: cannot create a device");
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
}

World::~World() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

void World::add(const Sphere &sphere, std::shared_ptr<const Material> material) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto *vertex = newBuffer<std::array<float, 4>>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 1);
    *vertex = {sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius};
    attach(geometry, {std::move(material), nullptr, sphere});
}

void World::add(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Material> material) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto *vertices =
        newBuffer<V3f>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh->positions.size());
    std::copy(mesh->positions.begin(), mesh->positions.end(), vertices);
    auto *triangles =
        newBuffer<Mesh::Triangle>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh->triangles.size());
    std::copy(mesh->triangles.begin(), mesh->triangles.end(), triangles);
    attach(geometry, {std::move(material), std::move(mesh), {}});
}

void World::attach(RTCGeometry geometry, Object object) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(objects_.size()));
    rtcReleaseGeometry(geometry);
    objects_.push_back(std::move(object));
}

void World::commit() {
    rtcCommitScene(scene_);
    if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE)
        throw std::runtime_error("Embree: error " + std::to_string(error));
}

std::optional<Hit> World::intersect(const Ray &ray) const {
    RTCRayHit query{};
    query.ray = toEmbree(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersectWith(scene_, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Object &object = objects_[query.hit.geomID];
    const float distance = query.ray.tfar;
    Hit hit{object.mesh ? pointOnMesh(*object.mesh, query.hit.primID, query.hit.u, query.hit.v)
                        : pointOnSphere(object.sphere, ray.origin + ray.direction * distance),
            object.material.get(), distance};
    hit.point.footprint = footprintOf(hit.point, ray, distance);
    return hit;
}

bool World::occluded(const Ray &ray) const {
    RTCRay query = toEmbree(ray);
    occludedBy(scene_, query);
    return query.tfar < 0; // what Embree sets when something is hit
}

} // namespace render
