// SPDX-License-Identifier: MIT
// Whose fault the noise is: Sobol' indices of the estimator over the seeds of its sources of random
// numbers. Seeds are independent of each other, so that the decomposition of the variance is exact
// whatever the points of one seed are (Sobol', Mathematics and Computers in Simulation 55, 2001;
// the estimators are those of Saltelli et al., Computer Physics Communications 181(2), 2010, and of
// Jansen, Computer Physics Communications 117(1-2), 1999).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "renderer/cost/report.hpp"

namespace cobble::renderer {

/// The estimator: its values (any number of them, the same each time) if source i has seed
/// `seeds[i]`. False if it was interrupted.
using Estimator =
    std::function<bool(const std::vector<std::uint16_t>& seeds, std::vector<double>& values)>;

/// Shares of the variance, averaged over all values, for each of `sources`. Asks `pairs` times (two
/// more than there are sources), `pairs` at least 3. Bands are Student's intervals with the
/// jackknife's error over the pairs. Nothing (no seeds) if interrupted, or without any variance.
NoiseBill measure_noise(const std::vector<std::string>& sources, std::uint32_t pairs,
                        const Estimator& estimator);

}  // namespace cobble::renderer
