// The objects of a scene, intersected by Embree.
#pragma once

#include "material.hpp"
#include "mesh.hpp"
#include "ray.hpp"

#include <embree3/rtcore.h>

#include <memory>
#include <optional>
#include <vector>

namespace render {

struct Sphere {
    V3f centre;
    float radius;
};

struct Hit {
    SurfacePoint point;
    const Material *material;
    float distance;
};

class World {
public:
    World();
    ~World();
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    void add(const Sphere &sphere, std::shared_ptr<const Material> material);
    void add(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Material> material);

    /// Call once, after the last add(). Throws std::runtime_error if Embree fails.
    void commit();

    std::optional<Hit> intersect(const Ray &ray) const;
    bool occluded(const Ray &ray) const;

private:
    struct Object {
        std::shared_ptr<const Material> material;
        std::shared_ptr<const Mesh> mesh; ///< null: `sphere`
        Sphere sphere;
    };

    void attach(RTCGeometry geometry, Object object);

    RTCDevice device_;
    RTCScene scene_;
    std::vector<Object> objects_; ///< by Embree's geometry number
};

} // namespace render
