// The numbers that all contenders of a row share. Defined elsewhere: a renderer's compiler does not know its
// materials.
#pragma once

namespace material {

constexpr float pi = 3.14159265358979f;

extern const float reflectance[3];
extern const float sigma; // radians
extern const float disney_roughness;

extern const float phong_diffuse[3];
extern const float phong_specular[3];
extern const float phong_exponent;

extern const float layer_eta[3];
extern const float exponent_reflection, exponent_transmission;
extern const float layer_nm;
extern const float deviation[3]; // 10 degrees

extern const float alpha;
extern const float f0[3];
extern const float glass_eta[3];
extern const float metal_eta[3];
extern const float metal_k[3];

extern const float film_eta;
extern const float film_base_eta, film_base_k;
extern const float greatest_nm, fixed_nm;

extern const float base_color[3];
extern const float metallic;
extern const float roughness;
extern const float dielectric_f0; // of index 1.5

// Ranges of what a texture gives.
extern const float varying_layer_nm[2];
extern const float varying_alpha[2];

} // namespace material
