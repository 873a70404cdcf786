// SPDX-License-Identifier: MIT
#include "renderer/estimate/student.hpp"

#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::renderer {

double student_probability(double t, std::uint32_t degrees) {
    const double n = degrees;
    const double hypotenuse = std::sqrt(n + t * t);
    const double sine = t / hypotenuse;
    const double cosine_squared = n / (n + t * t);
    // 1 + 1/2 c^2 + (1 3)/(2 4) c^4 ... for even degrees; 1 + 2/3 c^2 + (2 4)/(3 5) c^4 ... for
    // odd.
    const bool odd = degrees % 2 == 1;
    double sum = 0;
    double term = 1;
    for (std::uint32_t k = odd ? 1 : 0; k + 2 <= degrees; k += 2) {
        sum += term;
        term *= cosine_squared * (k + 1.0) / (k + 2.0);
    }
    if (!odd) return sine * sum;
    const double angle = math::atan2(t, std::sqrt(n));
    return 2 / math::kPi * (angle + sine * std::sqrt(cosine_squared) * sum);
}

double student_quantile(double tails, std::uint32_t degrees) {
    double low = 0;
    double high = 1;
    while (1 - student_probability(high, degrees) > tails && high < 1e12) high *= 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = low + (high - low) / 2;
        if (1 - student_probability(middle, degrees) > tails) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low + (high - low) / 2;
}

}  // namespace cobble::renderer
