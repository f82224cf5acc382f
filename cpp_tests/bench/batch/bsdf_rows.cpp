// Values of BSDFs.

#include "bsdfs.hpp"
#include "channels.hpp"
#include "materials.hpp"
#include "plain_microfacet.hpp"
#include "row.hpp"
#include "ways.hpp"

#include <memory>

namespace {

// Differences by rounding, which grows where a lobe is steep.
constexpr double rounding = 1e-4;
// The rational masking of the plain code is off by so much.
constexpr double rational = 1e-2;
// Between the entries of plain tables.
constexpr double looked_up = 1e-2;

// Adds rows with a plain formula.
struct Builder {
    std::vector<Row> &rows;
    const Elements &elements;
    Outputs &outputs;

    // `plain(wo, wi, varying, value)`; `varying` NULL: nothing varies.
    template <class Plain, class Loop256, class Loop512>
    Row &add(const char *name, const pellicle::Bsdf &bsdf, double allowed, const float *varying, Plain plain,
             Loop256 bits256, Loop512 bits512) {
        Row row;
        row.name = name;
        row.allowed = row.allowed_rms = allowed;
        const Elements &elements = this->elements;
        Outputs &outputs = this->outputs;
        row.work[plain_way] = [&elements, &outputs, varying, plain](std::size_t first, std::size_t count) {
            for (std::size_t i = first; i < first + count; ++i)
                plain(ways::direction<plain::Direction>(elements.wo.packed[i]),
                      ways::direction<plain::Direction>(elements.wi.packed[i]), varying ? varying[i] : 0.0f,
                      outputs.values[i].data());
        };
        row.work[bits256_way] = [&elements, &outputs, varying, bits256](std::size_t first, std::size_t count) {
            bits256(ways::in(elements, varying, first), ways::out(outputs, first), count);
        };
        row.work[bits512_way] = [&elements, &outputs, varying, bits512](std::size_t first, std::size_t count) {
            bits512(ways::in(elements, varying, first), ways::out(outputs, first), count);
        };
        ways::add_values(row, bsdf, elements, outputs, varying);
        rows.push_back(row);
        return rows.back();
    }
};

using plain::Direction;

plain::Layered<float> plain_layered(float thickness_nm) {
    const float *eta = material::layer_eta, *normal = material::deviation;
    return {{eta[0], eta[1], eta[2]},
            1,
            material::exponent_reflection,
            material::exponent_transmission,
            thickness_nm,
            {normal[0], normal[1], normal[2]}};
}

void add_diffuse(Builder &builder) {
    namespace narrow = vectorised::bits256;
    namespace wide = vectorised::bits512;
    const auto reflecting = [](const char *model) {
        return bsdfs::of(model).set("reflectance", material::reflectance, 3);
    };
    builder.add("lambert", reflecting("lambert").create(), rounding, nullptr,
                [](Direction wo, Direction wi, float, float *value) { plain::lambert(wo, wi, value); },
                narrow::lambert, wide::lambert);
    builder.add("oren_nayar, full", reflecting("oren_nayar").set("sigma_radians", material::sigma).create(), rounding,
                nullptr, [](Direction wo, Direction wi, float, float *value) { plain::oren_nayar(wo, wi, value); },
                narrow::oren_nayar, wide::oren_nayar);
    builder.add("disney_diffuse", reflecting("disney_diffuse").set("roughness", material::disney_roughness).create(),
                rounding, nullptr,
                [](Direction wo, Direction wi, float, float *value) { plain::disney_diffuse(wo, wi, value); },
                narrow::disney_diffuse, wide::disney_diffuse);
}

void add_lobes(Builder &builder) {
    namespace narrow = vectorised::bits256;
    namespace wide = vectorised::bits512;
    builder.add("phong",
                bsdfs::of("phong")
                    .set("diffuse", material::phong_diffuse, 3)
                    .set("specular", material::phong_specular, 3)
                    .set("exponent", material::phong_exponent)
                    .create(),
                rounding, nullptr,
                [](Direction wo, Direction wi, float, float *value) { plain::phong(wo, wi, value); },
                narrow::phong, wide::phong);
    builder.add("layered, paper", bsdfs::layered().create(), rounding, nullptr,
                [](Direction wo, Direction wi, float, float *value) {
                    plain::eval(plain_layered(material::layer_nm), wo, wi, value);
                },
                narrow::layered, wide::layered);
    const float *range = material::varying_layer_nm;
    builder.add("layered, thickness varying", bsdfs::layered().vary("thickness_nm", range[0], range[1]).create(),
                rounding, builder.elements.layer_nm.data(),
                [](Direction wo, Direction wi, float thickness_nm, float *value) {
                    plain::eval(plain_layered(thickness_nm), wo, wi, value);
                },
                narrow::layered_varying, wide::layered_varying);
}

void add_microfacets(Builder &builder) {
    namespace narrow = vectorised::bits256;
    namespace wide = vectorised::bits512;
    using namespace material;
    const plain::Schlick schlick{{f0[0], f0[1], f0[2]}};
    const plain::Dielectric dielectric{{glass_eta[0], glass_eta[1], glass_eta[2]}};
    const plain::Conductor conductor{{metal_eta[0], metal_eta[1], metal_eta[2]}, {metal_k[0], metal_k[1], metal_k[2]}};
    const auto facets = [](auto normals, auto fresnel) {
        return [normals, fresnel](Direction wo, Direction wi, float, float *value) {
            plain::microfacet(normals, fresnel, wo, wi, value);
        };
    };
    const plain::Ggx ggx{alpha};
    builder.add("ggx, schlick", bsdfs::ggx("schlick").set("f0", f0, 3).create(), rounding, nullptr,
                facets(ggx, schlick), narrow::ggx_schlick, wide::ggx_schlick);
    builder.add("ggx, dielectric", bsdfs::ggx("dielectric").set("eta", glass_eta, 3).create(), rounding, nullptr,
                facets(ggx, dielectric), narrow::ggx_dielectric, wide::ggx_dielectric);
    builder.add("ggx, conductor", bsdfs::conductor(), rounding, nullptr, facets(ggx, conductor),
                narrow::ggx_conductor, wide::ggx_conductor);
    builder.add("ggx, schlick, alpha varying",
                bsdfs::ggx("schlick").set("f0", f0, 3).vary("alpha", varying_alpha[0], varying_alpha[1]).create(),
                rounding, builder.elements.alpha.data(),
                [schlick](Direction wo, Direction wi, float varying, float *value) {
                    plain::microfacet(plain::Ggx{varying}, schlick, wo, wi, value);
                },
                narrow::ggx_schlick_varying, wide::ggx_schlick_varying);
    builder.add("beckmann, conductor",
                bsdfs::ggx("conductor")
                    .choose("distribution", "beckmann")
                    .set("eta", metal_eta, 3)
                    .set("k", metal_k, 3)
                    .create(),
                rational, nullptr, facets(plain::Beckmann{alpha}, conductor), narrow::beckmann_conductor,
                wide::beckmann_conductor);
}

void add_coated(Builder &builder) {
    const pellicle::Film film = bsdfs::coating();
    const auto table = std::make_shared<plain::Bilinear>(material::greatest_nm, [&film](float c, float nm) {
        return film.reflectance(c, nm);
    });
    const auto channels = std::make_shared<Channels>(table->rgb);
    const auto loop = [channels](auto function) {
        return [channels, function](const vectorised::In &in, const vectorised::Out &out, std::size_t count) {
            function(channels->planes(), in, out, count);
        };
    };
    Row &row = builder.add("ggx, film, thickness varying",
                           bsdfs::ggx("film").film(film).vary("thickness_nm", 0.0f, material::greatest_nm).create(),
                           looked_up, builder.elements.film_nm.data(),
                           [table](Direction wo, Direction wi, float thickness_nm, float *value) {
                               plain::coated(plain::Ggx{material::alpha}, *table, thickness_nm, wo, wi, value);
                           },
                           loop(vectorised::bits256::ggx_film), loop(vectorised::bits512::ggx_film));
    row.error_bound = ways::error_bound(film);
}

// 1 - E of the dielectric's highlight, whose albedo is asked of the library.
plain::MetallicRoughness plain_metallic_roughness() {
    const float alpha = material::roughness * material::roughness;
    const pellicle::Bsdf highlight =
        bsdfs::ggx("schlick", alpha).set("f0", material::dielectric_f0).create();
    plain::MetallicRoughness model{};
    for (int c = 0; c < 3; ++c)
        model.fresnel.f0[c] =
            (1 - material::metallic) * material::dielectric_f0 + material::metallic * material::base_color[c];
    for (int i = 0; i < plain::Curve::width; ++i) {
        const float cosine = std::max(i / (plain::Curve::width - 1.0f), 1e-4f);
        const Vec3 wo = {std::sqrt(1 - cosine * cosine), 0, cosine};
        model.remainder.values[i] = 1 - highlight.albedo(wo)[0];
    }
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) {
        const float cosine = (i + 0.5f) / steps;
        model.mean += 2 * cosine * model.remainder.at(cosine) / steps;
    }
    return model;
}

void add_metallic_roughness(Builder &builder) {
    const plain::MetallicRoughness model = plain_metallic_roughness();
    const auto loop = [model](auto function) {
        return [model, function](const vectorised::In &in, const vectorised::Out &out, std::size_t count) {
            function(vectorised::Remainder{model.remainder.values, model.mean}, in, out, count);
        };
    };
    builder.add("metallic_roughness",
                bsdfs::of("metallic_roughness")
                    .set("base_color", material::base_color, 3)
                    .set("metallic", material::metallic)
                    .set("roughness", material::roughness)
                    .create(),
                looked_up, nullptr,
                [model](Direction wo, Direction wi, float, float *value) { model.eval(wo, wi, value); },
                loop(vectorised::bits256::metallic_roughness), loop(vectorised::bits512::metallic_roughness));
}

} // namespace

void add_bsdf_rows(std::vector<Row> &rows, const Elements &elements, Outputs &outputs) {
    Builder builder{rows, elements, outputs};
    add_diffuse(builder);
    add_lobes(builder);
    add_microfacets(builder);
    add_coated(builder);
    add_metallic_roughness(builder);
}
