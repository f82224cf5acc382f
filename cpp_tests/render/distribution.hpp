// A piecewise constant distribution over [0, 1).
#pragma once

#include <cstdint>
#include <vector>

namespace render {

class Distribution {
public:
    /// Cells of equal width with these weights; all 0 is allowed.
    explicit Distribution(const std::vector<double> &weights);

    /// Where the cumulative distribution reaches `u`: a cell and the place in it, both in [0, 1).
    /// Increasing in `u`, which keeps stratified numbers stratified.
    struct Point {
        int cell;
        float offset;
    };
    Point invert(float u) const;

    /// Probability of a cell; of every cell 0 if all weights are.
    float probability(int cell) const { return cumulative_[cell + 1] - cumulative_[cell]; }

private:
    std::vector<float> cumulative_;   ///< at the cells' edges
    std::vector<std::int32_t> guide_; ///< the cell in which each k / count falls
};

} // namespace render
