// Sampling: direction, density and weight.

#include "bsdfs.hpp"
#include "materials.hpp"
#include "plain_microfacet.hpp"
#include "row.hpp"
#include "ways.hpp"

namespace {

// Differences by rounding, which grows where a lobe is steep.
constexpr double rounding = 1e-3;

Row &add(std::vector<Row> &rows, const char *name, const pellicle::Bsdf &bsdf, const Elements &elements,
         Outputs &outputs) {
    Row row;
    row.name = name;
    row.allowed = row.allowed_rms = rounding;
    ways::add_samples(row, bsdf, elements, outputs);
    rows.push_back(row);
    return rows.back();
}

} // namespace

void add_sample_rows(std::vector<Row> &rows, const Elements &elements, Outputs &outputs) {
    add(rows, "sample: lambert", bsdfs::of("lambert").create(), elements, outputs);
    add(rows, "sample: layered, paper", bsdfs::layered().create(), elements, outputs);
    Row &row = add(rows, "sample: ggx, conductor", bsdfs::conductor(), elements, outputs);
    row.work[plain_way] = [&elements, &outputs](std::size_t first, std::size_t count) {
        using material::metal_eta, material::metal_k;
        const plain::Conductor metal{{metal_eta[0], metal_eta[1], metal_eta[2]}, {metal_k[0], metal_k[1], metal_k[2]}};
        const plain::Ggx ggx{material::alpha};
        for (std::size_t i = first; i < first + count; ++i) {
            const Vec3 &u = elements.u.packed[i]; // the library chooses a lobe by the first
            Sampled &out = outputs.samples[i];
            plain::Direction wi;
            plain::sample(ggx, metal, ways::direction<plain::Direction>(elements.wo.packed[i]), u[1], u[2], wi,
                          out.pdf, out.weight.data());
            out.wi = {wi.x, wi.y, wi.z};
        }
    };
}
