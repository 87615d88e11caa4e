#include "lab/maths/least_squares.h"

#include "lab/maths/statistics.h"

#include <cmath>
#include <utility>

namespace lab {

namespace {

using Matrix = std::array<Row, kMostUnknowns>;

/// The inverse of n rows by Gauss and Jordan; empty if it has none that can be trusted.
std::optional<Matrix> inverted(Matrix matrix, std::size_t n)
{
    constexpr double kSingular = 1e-12; // of the largest entry of a column, once scaled
    Matrix inverse{};
    for (std::size_t i = 0; i < n; ++i)
        inverse[i][i] = 1.0;
    for (std::size_t pivot = 0; pivot < n; ++pivot) {
        std::size_t largest = pivot;
        for (std::size_t i = pivot + 1; i < n; ++i)
            if (std::abs(matrix[i][pivot]) > std::abs(matrix[largest][pivot]))
                largest = i;
        std::swap(matrix[pivot], matrix[largest]);
        std::swap(inverse[pivot], inverse[largest]);
        if (!(std::abs(matrix[pivot][pivot]) > kSingular))
            return std::nullopt;
        const double scale = 1.0 / matrix[pivot][pivot];
        for (std::size_t k = 0; k < n; ++k) {
            matrix[pivot][k] *= scale;
            inverse[pivot][k] *= scale;
        }
        for (std::size_t i = 0; i < n; ++i) {
            const double factor = i == pivot ? 0.0 : matrix[i][pivot];
            for (std::size_t k = 0; k < n; ++k) {
                matrix[i][k] -= factor * matrix[pivot][k];
                inverse[i][k] -= factor * inverse[pivot][k];
            }
        }
    }
    return inverse;
}

/// So that unknowns of different units weigh the same.
Row scaleOf(const std::vector<Row> &rows, std::span<const std::size_t> columns)
{
    Row scale{};
    for (const std::size_t column : columns) {
        for (const Row &row : rows)
            scale[column] += row[column] * row[column];
        scale[column] = std::sqrt(scale[column]);
    }
    return scale;
}

struct Solver {
    const Rows &rows;
    std::span<const std::size_t> columns;
    const std::vector<Row> &instruments;
    Row scale{}, instrumentScale{}; ///< of each column

    double residual(std::size_t row, const Row &values) const
    {
        double left = rows.wanted[row];
        for (const std::size_t column : columns)
            left -= rows.known[row][column] * values[column];
        return left;
    }
    double scaled(std::size_t row, std::size_t unknown) const
    {
        return rows.known[row][columns[unknown]] / scale[columns[unknown]];
    }
    double instrument(std::size_t row, std::size_t unknown) const
    {
        return instruments[row][columns[unknown]] / instrumentScale[columns[unknown]];
    }

    std::optional<Fit> solve(const std::vector<bool> &counts) const
    {
        const std::size_t n = columns.size();
        Matrix normal{};
        Row right{};
        Fit fit;
        for (std::size_t row = 0; row < counts.size(); ++row) {
            if (!counts[row])
                continue;
            fit.rows += 1.0;
            for (std::size_t i = 0; i < n; ++i) {
                right[i] += instrument(row, i) * rows.wanted[row];
                for (std::size_t k = 0; k < n; ++k)
                    normal[i][k] += instrument(row, i) * scaled(row, k);
            }
        }
        const auto inverse = inverted(normal, n);
        if (!inverse || !(fit.rows > static_cast<double>(n)))
            return std::nullopt;
        fit.unknowns = n;
        fit.counts = counts;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < n; ++k)
                fit.values[columns[i]] += (*inverse)[i][k] * right[k] / scale[columns[i]];
        return addErrors(fit, *inverse, counts) ? std::optional(fit) : std::nullopt;
    }

    bool addErrors(Fit &fit, const Matrix &inverse, const std::vector<bool> &counts) const
    {
        const std::size_t n = columns.size();
        Matrix middle{};
        double squares = 0.0;
        for (std::size_t row = 0; row < counts.size();) {
            Row sum{};
            bool any = false;
            const std::size_t cluster = rows.cluster[row];
            for (; row < counts.size() && rows.cluster[row] == cluster; ++row) {
                if (!counts[row])
                    continue;
                any = true;
                const double left = residual(row, fit.values);
                squares += left * left;
                for (std::size_t i = 0; i < n; ++i)
                    sum[i] += instrument(row, i) * left;
            }
            fit.clusters += any ? 1 : 0;
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t k = 0; k < n; ++k)
                    middle[i][k] += sum[i] * sum[k];
        }
        constexpr std::size_t kLeast = 3;
        if (fit.clusters < kLeast)
            return false;
        fit.residual = std::sqrt(squares / fit.rows);
        const auto clusters = static_cast<double>(fit.clusters);
        for (std::size_t i = 0; i < n; ++i) {
            double variance = 0.0;
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b)
                    variance += inverse[i][a] * middle[a][b] * inverse[i][b];
            fit.errors[columns[i]] =
                std::sqrt(variance * clusters / (clusters - 1.0)) / scale[columns[i]];
        }
        return true;
    }
};

} // namespace

Estimate Fit::estimate(std::size_t unknown) const
{
    const double half = studentOf(clusters - 1) * errors[unknown];
    return {values[unknown], values[unknown] - half, values[unknown] + half};
}

std::optional<Fit> leastSquares(const Rows &rows, std::span<const std::size_t> columns)
{
    const std::vector<Row> &instruments = rows.instruments.empty() ? rows.known : rows.instruments;
    const Solver solver{
        rows, columns, instruments, scaleOf(rows.known, columns), scaleOf(instruments, columns)};
    for (const std::size_t column : columns)
        if (!(solver.scale[column] > 0.0) || !(solver.instrumentScale[column] > 0.0))
            return std::nullopt;
    constexpr int kTurns = 3;
    constexpr double kFar = 4.0;
    std::vector<bool> counts(rows.known.size(), true);
    auto fit = solver.solve(counts);
    for (int turn = 0; turn < kTurns && fit; ++turn) {
        const double limit = kFar * fit->residual;
        for (std::size_t row = 0; row < counts.size(); ++row)
            counts[row] = std::abs(solver.residual(row, fit->values)) <= limit;
        fit = solver.solve(counts);
    }
    return fit;
}

bool explainsBetter(const Rows &rows, const Fit &one, const Fit &other)
{
    const auto both = [&](std::size_t row) { return one.counts[row] && other.counts[row]; };
    const auto criterion = [&](const Fit &fit) {
        double many = 0.0, squares = 0.0;
        for (std::size_t row = 0; row < rows.known.size(); ++row) {
            if (!both(row))
                continue;
            double left = rows.wanted[row];
            for (std::size_t column = 0; column < kMostUnknowns; ++column)
                left -= rows.known[row][column] * fit.values[column];
            squares += left * left;
            many += 1.0;
        }
        return many * std::log(squares / many) + static_cast<double>(fit.unknowns) * std::log(many);
    };
    return criterion(one) < criterion(other);
}

} // namespace lab
