// Complex amplitudes and spectra of a film: values, batches that are the single call many times, what is refused.
#include "strided.hpp"

#include <cmath>
#include <complex>

namespace {

using support::Layout;
using support::layouts;
using support::quiet_nan;
using support::Strided;

using Complex = std::complex<double>;

Complex number(const float (&parts)[2]) {
    return {parts[0], parts[1]};
}

void check_close(const float (&found)[2], Complex expected) {
    CAPTURE(found[0]);
    CAPTURE(found[1]);
    CHECK_LT(std::abs(number(found) - expected), 1e-6);
}

constexpr std::size_t lambda_count = 6;
const float wavelengths[lambda_count] = {400.0f, 450.0f, 500.0f, 550.0f, 650.0f, 679.0f};

} // namespace

TEST_CASE("film amplitudes: numbers, signs and time convention are those of Python's tmm") {
    // "titania on titanium" and "dense ambient" of tests/data/tmm_vectors.csv, 500 nm, cosine 0.7.
    const float nm = 500.0f;
    PellicleAmplitudes found;
    pellicle::FilmBuilder(pellicle::Medium::constant(2.9f, 3.1f))
        .layer(pellicle::Medium::constant(2.4f), 60)
        .create()
        .amplitudes(0.7f, 0.0f, PELLICLE_SIDE_AMBIENT, &nm, 1, &found);
    check_close(found.r_s, {-0.47862909, 0.407533769});
    check_close(found.r_p, {0.180268531, -0.46355857});
    check_close(found.t_s, {0.0415630406, 0.382549928});
    check_close(found.t_p, {0.0982346863, 0.411259343});
    pellicle::FilmBuilder(pellicle::Medium::constant(1.5f))
        .ambient(pellicle::Medium::constant(1.5f))
        .layer(pellicle::Medium::constant(1.0f), 250)
        .create()
        .amplitudes(0.7f, 0.0f, PELLICLE_SIDE_BASE, &nm, 1, &found);
    check_close(found.r_s, {0.647531262, -0.654413686});
    check_close(found.r_p, {0.135866621, -0.829291552});
    check_close(found.t_s, {0.277540705, 0.274621829});
    check_close(found.t_p, {0.534916259, 0.0876377729});
}

TEST_CASE("film amplitudes: the spectra are their squares") {
    const pellicle::Film film = pellicle::FilmBuilder(pellicle::Medium::constant(1.5f)).layer("TiO2", 0, 400).extrapolate().create();
    PellicleAmplitudes found[lambda_count];
    float reflectance[lambda_count], transmittance[lambda_count], front[lambda_count];
    for (const std::uint32_t side : {PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE})
        for (const float c : {1.0f, 0.8f, 0.3f, 0.01f}) {
            film.amplitudes(c, 150.0f, side, wavelengths, lambda_count, found);
            film.spectrum_eval(c, 150.0f, side, wavelengths, lambda_count, reflectance, transmittance);
            const Complex near = side == PELLICLE_SIDE_AMBIENT ? 1.0 : 1.5, far = 2.5 - near;
            const Complex cosine = std::sqrt(1.0 - (1.0 - Complex(c) * double(c)) * near * near / (far * far));
            const double flux[2] = {(far * cosine).real() / (near.real() * c),
                                    (far * std::conj(cosine)).real() / (near.real() * c)};
            for (std::size_t i = 0; i < lambda_count; ++i) {
                const double r = 0.5 * (std::norm(number(found[i].r_s)) + std::norm(number(found[i].r_p)));
                const double t =
                    0.5 * (flux[0] * std::norm(number(found[i].t_s)) + flux[1] * std::norm(number(found[i].t_p)));
                CHECK_EQ(double(reflectance[i]), doctest::Approx(r).epsilon(1e-5));
                CHECK_EQ(double(transmittance[i]), doctest::Approx(t).epsilon(1e-5));
            }
            if (side != PELLICLE_SIDE_AMBIENT) continue;
            film.spectrum(c, 150.0f, wavelengths, lambda_count, front);
            for (std::size_t i = 0; i < lambda_count; ++i)
                CHECK_EQ(front[i], doctest::Approx(reflectance[i]).epsilon(1e-6));
        }
}

TEST_CASE("film amplitudes: the batch equals the single call bit for bit in every layout") {
    const pellicle::Film &film = support::varying_film();
    for (const std::size_t count : {0, 1, 3, 17})
        for (const std::size_t lambdas : {1, 3, 4, 6})
            for (const Layout &in : layouts)
                for (const Layout &out : layouts) {
                    CAPTURE(count);
                    CAPTURE(lambdas);
                    CAPTURE(std::string(in.name));
                    CAPTURE(std::string(out.name));
                    Strided cosines(in, count, 1), thicknesses(in, count, 1), lambda_nm(in, count, lambdas);
                    std::mt19937 random(18);
                    for (std::size_t i = 0; i < count; ++i) {
                        const support::Vec3 u = support::random_uniforms(random);
                        cosines.set(i, 0, i == 2 ? quiet_nan : u[0]);
                        thicknesses.set(i, 0, u[1] * support::varying_film_max_nm);
                        for (std::size_t c = 0; c < lambdas; ++c) lambda_nm.set(i, c, wavelengths[c] + 100.0f * u[2]);
                    }
                    Strided r_s(out, count, 2 * lambdas), r_p(out, count, 2 * lambdas), t_s(out, count, 2 * lambdas),
                        t_p(out, count, 2 * lambdas);
                    PellicleAmplitudesBatchArgs args{};
                    args.count = count;
                    args.lambda_count = lambdas;
                    args.lambda_nm = lambda_nm.const_view();
                    args.cos_theta = cosines.const_view();
                    args.thickness_nm = thicknesses.const_view();
                    args.r_s = r_s.view();
                    args.r_p = r_p.view();
                    args.t_s = t_s.view();
                    args.t_p = t_p.view();
                    args.side = PELLICLE_SIDE_BASE;
                    film.amplitudes_batch(args);
                    bool equal = true;
                    for (std::size_t i = 0; i < count; ++i) {
                        std::vector<float> nm;
                        for (std::size_t c = 0; c < lambdas; ++c) nm.push_back(lambda_nm.get(i, c));
                        std::vector<PellicleAmplitudes> single(lambdas);
                        film.amplitudes(cosines.get(i, 0), thicknesses.get(i, 0), PELLICLE_SIDE_BASE, nm.data(), lambdas,
                                        single.data());
                        for (std::size_t c = 0; c < 2 * lambdas; ++c) {
                            const PellicleAmplitudes &a = single[c / 2];
                            const float found[] = {r_s.get(i, c), r_p.get(i, c), t_s.get(i, c), t_p.get(i, c)};
                            const float expected[] = {a.r_s[c % 2], a.r_p[c % 2], a.t_s[c % 2], a.t_p[c % 2]};
                            equal = equal && support::same_bits(found, expected, 4);
                        }
                    }
                    CHECK(equal);
                    for (const Strided *output : {&r_s, &r_p, &t_s, &t_p}) CHECK(output->rest_untouched());
                }
}

TEST_CASE("film amplitudes: wavelengths that are not finite and above 0 are refused by their number") {
    const pellicle::Film &film = support::fixed_film();
    for (const float bad : {0.0f, -0.0f, -550.0f, quiet_nan, support::infinity, -support::infinity}) {
        CAPTURE(bad);
        const float lambda_nm[6] = {400.0f, 500.0f, bad, 600.0f, 700.0f, 750.0f};
        support::Untouched<PellicleAmplitudes[6]> amplitudes;
        CHECK_REFUSED(pellicle_film_amplitudes(film.raw(), 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, lambda_nm, 6,
                                               amplitudes.output),
                      PELLICLE_OUT_OF_RANGE, "lambda_nm[2]");
        support::Untouched<float[6]> reflectance, transmittance;
        CHECK_REFUSED(pellicle_film_spectrum_eval(film.raw(), 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, lambda_nm, 6,
                                                  reflectance.output, transmittance.output),
                      PELLICLE_OUT_OF_RANGE, "lambda_nm[2]");
        const float cosine = 1.0f;
        PellicleAmplitudesBatchArgs args{};
        args.count = 3;
        args.lambda_count = 2;
        args.lambda_nm = {lambda_nm, 8, 4};
        args.cos_theta = {&cosine, 0, 4};
        args.t_p = {reflectance.output, 0, 4};
        CHECK_REFUSED(pellicle_film_amplitudes_batch(film.raw(), &args, sizeof args), PELLICLE_OUT_OF_RANGE,
                      "lambda_nm[0] of element 1");
    }
}

TEST_CASE("film amplitudes: sides that do not exist and outputs over the wavelengths are refused") {
    const PellicleFilm *film = support::fixed_film().raw();
    support::Untouched<PellicleAmplitudes[4]> amplitudes;
    for (const std::uint32_t side : {2u, 0xffffffffu}) {
        CHECK_REFUSED(pellicle_film_amplitudes(film, 1.0f, 0.0f, side, wavelengths, 4, amplitudes.output),
                      PELLICLE_OUT_OF_RANGE, "side");
        support::Untouched<float[4]> numbers;
        CHECK_REFUSED(pellicle_film_spectrum_eval(film, 1.0f, 0.0f, side, wavelengths, 4, numbers.output, nullptr),
                      PELLICLE_OUT_OF_RANGE, "side");
        PellicleAmplitudesBatchArgs args{};
        args.side = side;
        CHECK_REFUSED(pellicle_film_amplitudes_batch(film, &args, sizeof args), PELLICLE_OUT_OF_RANGE, "side");
    }
    for (const std::size_t at : {0, 1, 31, 35}) {
        std::vector<float> numbers(64, 500.0f);
        const float *lambda_nm = numbers.data() + at;
        auto *output = reinterpret_cast<PellicleAmplitudes *>(numbers.data() + 4);
        const PellicleStatus status = pellicle_film_amplitudes(film, 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, lambda_nm, 4, output);
        CHECK_EQ(status, at == 0 ? PELLICLE_OK : PELLICLE_INVALID_ARGUMENT);
    }
    std::vector<float> numbers(8, 500.0f);
    for (const int shift : {0, 1, 3}) {
        CHECK_REFUSED(pellicle_film_spectrum_eval(film, 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, numbers.data(), 4,
                                                  numbers.data() + shift, nullptr),
                      PELLICLE_INVALID_ARGUMENT, "reflectance overlaps");
        CHECK_REFUSED(pellicle_film_spectrum_eval(film, 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, numbers.data(), 4, nullptr,
                                                  numbers.data() + shift),
                      PELLICLE_INVALID_ARGUMENT, "transmittance overlaps");
    }
}

TEST_CASE("film amplitudes: nothing comes from the side of a base that absorbs, and a film needs no transmittance") {
    const pellicle::Film film = pellicle::FilmBuilder("Ag").layer("SiO2", 0, 400).extrapolate().create();
    PellicleAmplitudes found[lambda_count];
    film.amplitudes(0.7f, 200.0f, PELLICLE_SIDE_BASE, wavelengths, lambda_count, found);
    for (const PellicleAmplitudes &at : found)
        for (const auto &part : {at.r_s, at.r_p, at.t_s, at.t_p}) CHECK_EQ(Complex(part[0], part[1]), Complex(0.0));
    film.amplitudes(0.7f, 200.0f, PELLICLE_SIDE_AMBIENT, wavelengths, lambda_count, found);
    CHECK_GT(std::norm(number(found[0].t_s)), 1e-3); // the field just inside
}
