#include "elements.hpp"
#include "materials.hpp"

#include <cmath>

Elements::Elements(std::size_t count) : wo(count), wi(count), u(count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.0f, 0.999f);
    const auto direction = [&] {
        const float z = 1.0f - uniform(random), phi = 2 * material::pi * uniform(random);
        const float radius = std::sqrt(1.0f - z * z);
        return Vec3{radius * std::cos(phi), radius * std::sin(phi), z};
    };
    const auto within = [&](const float (&range)[2]) { return range[0] + (range[1] - range[0]) * uniform(random); };
    for (std::size_t i = 0; i < count; ++i) {
        wo.set(i, direction());
        wi.set(i, direction());
        const float first = uniform(random), second = uniform(random), third = uniform(random);
        u.set(i, {first, second, third});
        layer_nm.push_back(within(material::varying_layer_nm));
        alpha.push_back(within(material::varying_alpha));
        film_nm.push_back(material::greatest_nm * uniform(random));
        angles.push_back({wi.packed[i][2], film_nm[i]});
    }
}
