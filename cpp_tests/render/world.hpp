// The objects of a scene, intersected by Embree.
#pragma once

#include "material.hpp"
#include "mesh.hpp"
#include "ray.hpp"

// Debian 12 has Embree 3, Debian 13 Embree 4.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

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

    /// Radiance that reaches every point from everywhere, through everything: the ambient light of
    /// B. Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975. 0 if not set.
    void setAmbient(const Rgb &radiance) { ambient_ = radiance; }
    const Rgb &ambient() const { return ambient_; }

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
    Rgb ambient_{0};
};

} // namespace render
