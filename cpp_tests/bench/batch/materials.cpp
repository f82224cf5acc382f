#include "materials.hpp"

namespace material {

const float reflectance[3] = {0.8f, 0.5f, 0.3f};
const float sigma = 0.5f; // radians
const float disney_roughness = 0.7f;

const float phong_diffuse[3] = {0.5f, 0.4f, 0.3f};
const float phong_specular[3] = {0.25f, 0.3f, 0.35f};
const float phong_exponent = 50;

const float layer_eta[3] = {1.4f, 1.45f, 1.6f};
const float exponent_reflection = 90, exponent_transmission = 170;
const float layer_nm = 70;
const float deviation[3] = {0.173648178f, 0, 0.984807753f}; // 10 degrees

const float alpha = 0.3f;
const float f0[3] = {0.9f, 0.6f, 0.3f};
const float glass_eta[3] = {1.5f, 1.52f, 1.54f};
const float metal_eta[3] = {0.2f, 0.92f, 1.1f};
const float metal_k[3] = {3.9f, 2.45f, 2.14f};

const float film_eta = 1.33f;
const float film_base_eta = 1.5f, film_base_k = 3;
const float greatest_nm = 1000, fixed_nm = 350;

const float base_color[3] = {0.8f, 0.5f, 0.3f};
const float metallic = 0.3f;
const float roughness = 0.5f;
const float dielectric_f0 = 0.04f; // of index 1.5

// Ranges of what a texture gives.
const float varying_layer_nm[2] = {60, 80};
const float varying_alpha[2] = {0.05f, 1};

} // namespace material
