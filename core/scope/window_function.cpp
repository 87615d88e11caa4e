// Windows as sums of cosines: w(n) = a0 - a1 cos x + a2 cos 2x - ..., x = 2 pi n / N, scaled to a0 + a1 + ... = 1.
// Their transform is then a sum of sinc functions, known without computing one.
// Source of the coefficients: F. J. Harris, Proc. IEEE 66 (1978), 51 (Hann, Blackman-Harris); G. D'Antona and
// A. Ferrero, Digital Signal Processing for Measurement Systems (2006), 72 (flat top, as MATLAB's flattopwin).
#include "scope/spectrum.h"

#include <array>
#include <cmath>
#include <numbers>

namespace scope {

namespace {

using Coefficients = std::array<double, 5>;

/// In the order of the enumeration: rectangular, Hann, Blackman-Harris, flat top.
const Coefficients &coefficients(Window window)
{
    static constexpr Coefficients kAll[] = {{1.0, 0.0, 0.0, 0.0, 0.0}, {0.5, 0.5, 0.0, 0.0, 0.0},
        {0.35875, 0.48829, 0.14128, 0.01168, 0.0},
        {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368}};
    return kAll[static_cast<std::size_t>(window)];
}

double sinc(double x)
{
    const double angle = std::numbers::pi * x;
    return std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle;
}

} // namespace

std::vector<double> windowValues(Window window, std::size_t n)
{
    const Coefficients &a = coefficients(window);
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double x = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        double value = 0.0;
        for (std::size_t k = a.size(); k-- > 0;)
            value = a[k] * (k % 2 == 0 ? 1.0 : -1.0) * std::cos(static_cast<double>(k) * x) + value;
        values[i] = value;
    }
    return values;
}

double windowResponse(Window window, double offset)
{
    const Coefficients &a = coefficients(window);
    double sum = a[0] * sinc(offset);
    for (std::size_t k = 1; k < a.size(); ++k) {
        const auto shift = static_cast<double>(k);
        sum += a[k] / 2 * (sinc(offset - shift) + sinc(offset + shift));
    }
    return sum / a[0];
}

double noiseBandwidth(Window window)
{
    const Coefficients &a = coefficients(window);
    double squares = a[0] * a[0];
    for (std::size_t k = 1; k < a.size(); ++k)
        squares += a[k] * a[k] / 2;
    return squares / (a[0] * a[0]);
}

} // namespace scope
