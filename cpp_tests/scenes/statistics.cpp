#include "statistics.hpp"

Estimate estimate(const std::vector<double> &repetitions) {
    const double count = static_cast<double>(repetitions.size());
    double sum = 0, squares = 0;
    for (const double x : repetitions) sum += x;
    for (const double x : repetitions) squares += (x - sum / count) * (x - sum / count);
    return {sum / count, std::sqrt(squares / (count * (count - 1)))};
}

bool agree(const Estimate &a, const Estimate &b) {
    return std::fabs(a.mean - b.mean) <= 4 * std::hypot(a.standardError, b.standardError);
}

RgbEstimate pictureMean(int repetitions,
                        const std::function<render::Picture(std::uint32_t seed)> &renderOnce) {
    std::array<std::vector<double>, 3> means;
    for (int seed = 1; seed <= repetitions; ++seed) {
        const render::Picture picture = renderOnce(static_cast<std::uint32_t>(seed));
        for (int channel = 0; channel < 3; ++channel) {
            double sum = 0;
            for (const render::Pixel &pixel : picture.pixels) sum += pixel.radiance[channel];
            means[channel].push_back(sum / static_cast<double>(picture.pixels.size()));
        }
    }
    return {estimate(means[0]), estimate(means[1]), estimate(means[2])};
}
