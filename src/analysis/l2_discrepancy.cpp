// SPDX-License-Identifier: Apache-2.0
//
// All L2 discrepancies have the form
//
//     D^2 = c^s - 2/N sum_i prod_d h(x_id) + 1/N^2 sum_ij prod_d k(x_id, x_jd)
//
// where k is the reproducing kernel of a space of functions, h(x) its integral over the second
// argument and c its integral over both (Hickernell 1998, Math. Comp. 67, section 3). A kind of
// discrepancy is its k, h and c. Part of k depends on one argument only: `part`.

#include "wellstrat/analysis/discrepancy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wellstrat {
inline namespace stream1 {
namespace {

struct StarKernel {
    static constexpr double kMean = 1.0 / 3;
    static double single(double x) { return (1 - x * x) / 2; }
    static double part(double) { return 0; }
    static double pair(double x, double y, double, double) { return 1 - (x > y ? x : y); }
};

struct CenteredKernel {
    static constexpr double kMean = 13.0 / 12;
    static double single(double x) {
        const double z = std::fabs(x - 0.5);
        return 1 + z / 2 - z * z / 2;
    }
    static double part(double x) { return 0.5 + std::fabs(x - 0.5) / 2; }
    static double pair(double x, double y, double px, double py) {
        return px + py - 0.5 * std::fabs(x - y);
    }
};

struct WrapAroundKernel {
    static constexpr double kMean = 4.0 / 3;
    static double single(double) { return kMean; }
    static double part(double) { return 0; }
    static double pair(double x, double y, double, double) {
        const double d = std::fabs(x - y);
        return 1.5 - d * (1 - d);
    }
};

struct MixtureKernel {
    static constexpr double kMean = 19.0 / 12;
    static double single(double x) {
        const double z = std::fabs(x - 0.5);
        return 5.0 / 3 - z / 4 - z * z / 4;
    }
    static double part(double x) { return 15.0 / 16 - std::fabs(x - 0.5) / 4; }
    static double pair(double x, double y, double px, double py) {
        const double d = std::fabs(x - y);
        return px + py + d * (0.5 * d - 0.75);
    }
};

struct ModifiedKernel {
    static constexpr double kMean = 4.0 / 3;
    static double single(double x) { return (3 - x * x) / 2; }
    static double part(double) { return 0; }
    static double pair(double x, double y, double, double) { return 2 - (x > y ? x : y); }
};

/// Points are taken in blocks of this many, so that the sums of a block stay in the cache. Each
/// place of a block has a sum of its own: the loops over a block vectorize as they stand.
constexpr std::size_t kBlock = 256;
using Block = std::array<double, kBlock>;

template <class Kernel>
class L2Sum {
public:
    explicit L2Sum(const UnitPoints& points) : points_(points), parts_(points.dims()) {
        for (unsigned d = 0; d < points.dims(); ++d) {
            const double* x = points.coordinate(d);
            parts_[d].resize(points.count());
            std::transform(x, x + points.count(), parts_[d].begin(), Kernel::part);
        }
    }

    double discrepancy() const {
        const double count = static_cast<double>(points_.count());
        const double square = std::pow(Kernel::kMean, points_.dims()) - 2 * singles() / count +
                              pairs() / (count * count);
        return std::sqrt(std::max(square, 0.0));
    }

private:
    double singles() const {
        long double sum = 0;
        for (std::size_t i = 0; i < points_.count(); ++i) {
            double product = 1;
            for (unsigned d = 0; d < points_.dims(); ++d) {
                product *= Kernel::single(points_.coordinate(d)[i]);
            }
            sum += product;
        }
        return static_cast<double>(sum);
    }

    /// Over all ordered pairs: twice those with j < i, and i itself.
    double pairs() const {
        long double sum = 0;
        for (std::size_t begin = 0; begin < points_.count(); begin += kBlock) {
            const std::size_t size = std::min(kBlock, points_.count() - begin);
            Block sums{};
            for (std::size_t i = begin + size; i < points_.count(); ++i) {
                addProducts(i, begin, size, sums);
            }
            sum += 2 * total(sums, size);
            for (std::size_t i = begin; i < begin + size; ++i) {
                Block own{};
                addProducts(i, begin, i - begin, own);
                sum += 2 * total(own, i - begin);
                Block diagonal{};
                addProducts(i, i, 1, diagonal);
                sum += diagonal[0];
            }
        }
        return static_cast<double>(sum);
    }

    static long double total(const Block& sums, std::size_t size) {
        long double sum = 0;
        for (std::size_t j = 0; j < size; ++j) sum += sums[j];
        return sum;
    }

    /// Adds to sums[j] the product of the kernels of points i and begin + j.
    void addProducts(std::size_t i, std::size_t begin, std::size_t size, Block& sums) const {
        switch (points_.dims()) {
        case 1: return addProductsOf<1>(i, begin, size, sums);
        case 2: return addProductsOf<2>(i, begin, size, sums);
        case 3: return addProductsOf<3>(i, begin, size, sums);
        default: break;
        }
        Block products;
        std::fill_n(products.begin(), size, 1.0);
        for (unsigned d = 0; d < points_.dims(); ++d) {
            const Row row(*this, d, i, begin);
            for (std::size_t j = 0; j < size; ++j) products[j] *= row.kernel(j);
        }
        for (std::size_t j = 0; j < size; ++j) sums[j] += products[j];
    }

    template <unsigned Dims>
    void addProductsOf(std::size_t i, std::size_t begin, std::size_t size, Block& sums) const {
        const Row a(*this, 0, i, begin);
        const Row b(*this, Dims > 1 ? 1 : 0, i, begin);
        const Row c(*this, Dims > 2 ? 2 : 0, i, begin);
        double* const sum = sums.data();
        for (std::size_t j = 0; j < size; ++j) {
            double product = a.kernel(j);
            if constexpr (Dims > 1) product *= b.kernel(j);
            if constexpr (Dims > 2) product *= c.kernel(j);
            sum[j] += product;
        }
    }

    /// One coordinate of point i against those of a block.
    struct Row {
        Row(const L2Sum& set, unsigned d, std::size_t i, std::size_t begin)
            : x(set.points_.coordinate(d)[i]), part(set.parts_[d][i]),
              others(set.points_.coordinate(d) + begin), otherParts(set.parts_[d].data() + begin) {}

        double kernel(std::size_t j) const {
            return Kernel::pair(x, others[j], part, otherParts[j]);
        }

        double x, part;
        const double* others;
        const double* otherParts;
    };

    const UnitPoints& points_;
    std::vector<std::vector<double>> parts_;
};

} // namespace

double l2Discrepancy(const UnitPoints& points, L2Kind kind) {
    switch (kind) {
    case L2Kind::star: return L2Sum<StarKernel>(points).discrepancy();
    case L2Kind::centered: return L2Sum<CenteredKernel>(points).discrepancy();
    case L2Kind::wrapAround: return L2Sum<WrapAroundKernel>(points).discrepancy();
    case L2Kind::mixture: return L2Sum<MixtureKernel>(points).discrepancy();
    case L2Kind::modified: return L2Sum<ModifiedKernel>(points).discrepancy();
    }
    throw PointError("there is no such kind of L2 discrepancy");
}

} // namespace stream1
} // namespace wellstrat
