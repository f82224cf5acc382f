#include "distribution.hpp"

#include <algorithm>

namespace render {

Distribution::Distribution(const std::vector<double> &weights) {
    double total = 0, below = 0;
    for (const double weight : weights) total += weight;
    cumulative_.push_back(0);
    for (const double weight : weights) {
        below += weight;
        cumulative_.push_back(total > 0 ? static_cast<float>(below / total) : 0);
    }
    const int count = static_cast<int>(weights.size());
    for (int k = 0, cell = 0; k < count; ++k) {
        while (cell < count - 1 && cumulative_[cell + 1] <= static_cast<float>(k) / static_cast<float>(count))
            ++cell;
        guide_.push_back(cell);
    }
}

/// The cutpoint method (H. Chen and Y. Asau, "On Generating Random Variates from an Empirical
/// Distribution", AIIE Transactions 6(2), 1974): a table leads to within a few cells.
Distribution::Point Distribution::invert(float u) const {
    const int count = static_cast<int>(guide_.size());
    int cell = guide_[std::min(static_cast<int>(u * static_cast<float>(count)), count - 1)];
    while (cell < count - 1 && cumulative_[cell + 1] <= u) ++cell;
    const float mass = probability(cell);
    return {cell, mass > 0 ? std::clamp((u - cumulative_[cell]) / mass, 0.0f, 0x1.fffffep-1f) : 0.5f};
}

} // namespace render
