#include "tools/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/bench.h"

namespace enfilade::tools {

namespace {

using Matrix = std::vector<std::vector<double>>;

/// Gauss-Jordan with row pivots; zero rows where the matrix has no inverse.
Matrix inverse(Matrix a) {
    const std::size_t n = a.size();
    Matrix result(n, std::vector<double>(n, 0));
    for (std::size_t i = 0; i < n; ++i) result[i][i] = 1;
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column; row < n; ++row)
            if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
        if (a[pivot][column] == 0) return Matrix(n, std::vector<double>(n, 0));
        std::swap(a[pivot], a[column]);
        std::swap(result[pivot], result[column]);
        const double scale = 1 / a[column][column];
        for (std::size_t k = 0; k < n; ++k) a[column][k] *= scale, result[column][k] *= scale;
        for (std::size_t row = 0; row < n; ++row) {
            if (row == column) continue;
            const double factor = a[row][column];
            for (std::size_t k = 0; k < n; ++k) {
                a[row][k] -= factor * a[column][k];
                result[row][k] -= factor * result[column][k];
            }
        }
    }
    return result;
}

double predicted(const Measurement& m, const std::vector<double>& constants) {
    return std::inner_product(m.x.begin(), m.x.end(), constants.begin(), 0.0);
}

/// With the constants not in `free` held at 0.
Fit fit_free(std::span<const Measurement> measurements, const std::vector<std::size_t>& free) {
    const std::size_t n = free.size(), all = measurements.front().x.size();
    Matrix normal(n, std::vector<double>(n, 0));
    std::vector<double> right(n, 0);
    for (const Measurement& m : measurements) {
        const double weight = 1 / (m.deviation * m.deviation);
        for (std::size_t i = 0; i < n; ++i) {
            right[i] += weight * m.x[free[i]] * m.y;
            for (std::size_t k = 0; k < n; ++k) normal[i][k] += weight * m.x[free[i]] * m.x[free[k]];
        }
    }
    const Matrix inverted = inverse(std::move(normal));
    Fit fit{std::vector<double>(all, 0), std::vector<double>(all, 0), 0};
    for (std::size_t i = 0; i < n; ++i)
        fit.constants[free[i]] = std::inner_product(right.begin(), right.end(), inverted[i].begin(), 0.0);
    double squares = 0;
    std::vector<double> residuals;
    for (const Measurement& m : measurements) {
        const double residual = m.y - predicted(m, fit.constants);
        squares += residual * residual / (m.deviation * m.deviation);
        residuals.push_back(std::abs(residual) / m.y);
    }
    const double variance = squares / double(measurements.size() - n);
    for (std::size_t i = 0; i < n; ++i) fit.standard_errors[free[i]] = std::sqrt(variance * inverted[i][i]);
    fit.median_residual = median(std::move(residuals));
    return fit;
}

}  // namespace

Fit fit_constants(std::span<const Measurement> measurements) {
    std::vector<std::size_t> free(measurements.front().x.size());
    std::iota(free.begin(), free.end(), 0);
    for (;;) {
        Fit fit = fit_free(measurements, free);
        const auto lowest = std::min_element(free.begin(), free.end(), [&](std::size_t a, std::size_t b) {
            return fit.constants[a] < fit.constants[b];
        });
        if (lowest == free.end() || fit.constants[*lowest] >= 0) return fit;
        free.erase(lowest);
    }
}

double correlation(std::span<const double> a, std::span<const double> b) {
    const double n = double(a.size());
    const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
    const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
        ab += (a[i] - mean_a) * (b[i] - mean_b);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

}  // namespace enfilade::tools
