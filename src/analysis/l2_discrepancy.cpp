// SPDX-License-Identifier: Apache-2.0
//
// All L2 discrepancies have the form
//
//     D^2 = c^s - 2/N sum_i prod_d h(x_id) + 1/N^2 sum_ij prod_d k(x_id, x_jd)
//
// where k is the reproducing kernel of a space of functions, h(x) its integral over the second
// argument and c its integral over both (Hickernell 1998, Math. Comp. 67, section 3). A kind of
// discrepancy is its k, h and c, and all k are
//
//     k(x, y) = q(x) + q(y) - p x y + m min(1 - x, 1 - y)
//
// The first two terms are (q(x) + 1/2) (q(y) + 1/2) - (q(x) - 1/2) (q(y) - 1/2), a sum of products
// of a function of x and the same function of y. Multiplied out over the coordinates, the sum over
// pairs consists of sums of products of weights and minima, which minimum_sums.h has.

#include "wellstrat/analysis/discrepancy.h"

#include "minimum_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace wellstrat {
inline namespace stream1 {
namespace {

struct StarKernel { // 1 - max(x, y)
    static constexpr long double kMean = 1.0L / 3;
    static constexpr double kMinimum = 1, kProduct = 0;
    static constexpr bool kHasPart = false;
    static long double single(long double x) { return (1 - x * x) / 2; }
    static double part(double) { return 0; }
};

struct CenteredKernel { // 1 + |x - 1/2| / 2 + |y - 1/2| / 2 - |x - y| / 2
    static constexpr long double kMean = 13.0L / 12;
    static constexpr double kMinimum = 1, kProduct = 0;
    static constexpr bool kHasPart = true;
    static long double single(long double x) {
        const long double z = std::fabs(x - 0.5L);
        return 1 + z / 2 - z * z / 2;
    }
    static double part(double x) { return (std::fabs(x - 0.5) + x) / 2; }
};

struct WrapAroundKernel { // 3/2 - |x - y| + (x - y)^2
    static constexpr long double kMean = 4.0L / 3;
    static constexpr double kMinimum = 2, kProduct = 2;
    static constexpr bool kHasPart = true;
    static long double single(long double) { return kMean; }
    static double part(double x) { return x + x * x - 0.25; }
};

struct MixtureKernel { // 15/8 - |x - 1/2| / 4 - |y - 1/2| / 4 - 3/4 |x - y| + (x - y)^2 / 2
    static constexpr long double kMean = 19.0L / 12;
    static constexpr double kMinimum = 1.5, kProduct = 1;
    static constexpr bool kHasPart = true;
    static long double single(long double x) {
        const long double z = std::fabs(x - 0.5L);
        return 5.0L / 3 - z / 4 - z * z / 4;
    }
    static double part(double x) {
        return 3.0 / 16 - std::fabs(x - 0.5) / 4 + 3 * x / 4 + x * x / 2;
    }
};

struct ModifiedKernel { // 2 - max(x, y)
    static constexpr long double kMean = 4.0L / 3;
    static constexpr double kMinimum = 1, kProduct = 0;
    static constexpr bool kHasPart = true;
    static long double single(long double x) { return (3 - x * x) / 2; }
    static double part(double) { return 0.5; }
};

template <class Kernel>
long double singleSum(const UnitPoints& points) {
    long double sum = 0;
    for (std::size_t i = 0; i < points.count(); ++i) {
        long double product = 1;
        for (unsigned d = 0; d < points.dims(); ++d) {
            product *= Kernel::single(points.coordinate(d)[i]);
        }
        sum += product;
    }
    return sum;
}

/// The sum over all ordered pairs for few dimensions: multiplied out, coordinate by coordinate.
template <class Kernel>
class ExpandedPairs {
public:
    /// `minima` is the sum of the products of all minima, which all kernels share.
    ExpandedPairs(const UnitPoints& points, const MinimumSums& sums, long double minima)
        : points_(points), sums_(sums), minima_(minima) {}

    long double sum() const { return expand({std::vector<double>(points_.count(), 1.0), {}}, 0); }

private:
    /// What was chosen of the coordinates so far: the product of the functions of a point, and
    /// those of which the minimum was taken.
    struct Term {
        std::vector<double> weights;
        std::vector<unsigned> axes;
    };

    long double expand(const Term& term, unsigned dim) const {
        if (term.axes.size() == points_.dims()) return minima_;
        if (dim == points_.dims()) return sums_.sum(term.weights, term.axes);
        Term withMinimum = term;
        withMinimum.axes.push_back(dim);
        long double sum = Kernel::kMinimum * expand(withMinimum, dim + 1);
        if (!Kernel::kHasPart) return sum;
        sum += expandTimes(term, dim, [](double x) { return Kernel::part(x) + 0.5; });
        sum -= expandTimes(term, dim, [](double x) { return Kernel::part(x) - 0.5; });
        if (Kernel::kProduct == 0) return sum;
        return sum - Kernel::kProduct * expandTimes(term, dim, [](double x) { return x; });
    }

    /// The same with the weights times a function of a coordinate; nothing if that is 0.
    template <class Function>
    long double expandTimes(Term term, unsigned dim, const Function& function) const {
        const double* x = points_.coordinate(dim);
        for (std::size_t i = 0; i < points_.count(); ++i) term.weights[i] *= function(x[i]);
        const bool isZero = std::all_of(term.weights.begin(), term.weights.end(),
                                        [](double weight) { return weight == 0; });
        return isZero ? 0 : expand(term, dim + 1);
    }

    const UnitPoints& points_;
    const MinimumSums& sums_;
    const long double minima_;
};

/// Points are taken in blocks of this many, so that the sums of a block stay in the cache. Each
/// place of a block has a sum of its own: the loops over a block vectorize as they stand.
constexpr std::size_t kBlock = 256;
using Block = std::array<double, kBlock>;

/// The sum over all ordered pairs for any dimensions, pair by pair.
template <class Kernel>
class DirectPairs {
public:
    explicit DirectPairs(const UnitPoints& points) : points_(points), parts_(points.dims()) {
        for (unsigned d = 0; d < points.dims(); ++d) {
            const double* x = points.coordinate(d);
            parts_[d].resize(points.count());
            std::transform(x, x + points.count(), parts_[d].begin(), Kernel::part);
        }
    }

    /// Twice the pairs with j < i, and i itself.
    long double sum() const {
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
        return sum;
    }

private:
    static long double total(const Block& sums, std::size_t size) {
        long double sum = 0;
        for (std::size_t j = 0; j < size; ++j) sum += sums[j];
        return sum;
    }

    /// Adds to sums[j] the product of the kernels of points i and begin + j.
    void addProducts(std::size_t i, std::size_t begin, std::size_t size, Block& sums) const {
        Block products;
        std::fill_n(products.begin(), size, 1.0);
        for (unsigned d = 0; d < points_.dims(); ++d) {
            const Row row(*this, d, i, begin);
            for (std::size_t j = 0; j < size; ++j) products[j] *= row.kernel(j);
        }
        for (std::size_t j = 0; j < size; ++j) sums[j] += products[j];
    }

    /// One coordinate of point i against those of a block.
    struct Row {
        Row(const DirectPairs& set, unsigned d, std::size_t i, std::size_t begin)
            : x(set.points_.coordinate(d)[i]), part(set.parts_[d][i]),
              others(set.points_.coordinate(d) + begin), otherParts(set.parts_[d].data() + begin) {}

        double kernel(std::size_t j) const {
            return part + otherParts[j] + Kernel::kMinimum * (1 - std::max(x, others[j])) -
                   Kernel::kProduct * x * others[j];
        }

        double x, part;
        const double* others;
        const double* otherParts;
    };

    const UnitPoints& points_;
    std::vector<std::vector<double>> parts_;
};

template <class Kernel>
double discrepancyOf(const UnitPoints& points, long double pairs) {
    const auto count = static_cast<long double>(points.count());
    const long double square = std::pow(Kernel::kMean, static_cast<int>(points.dims())) -
                               2 * singleSum<Kernel>(points) / count + pairs / (count * count);
    return static_cast<double>(std::sqrt(std::max(square, 0.0L)));
}

/// Calls visit(kernel) with the kernel of a kind.
template <class Visitor>
double withKernel(L2Kind kind, const Visitor& visit) {
    switch (kind) {
    case L2Kind::star: return visit(StarKernel{});
    case L2Kind::centered: return visit(CenteredKernel{});
    case L2Kind::wrapAround: return visit(WrapAroundKernel{});
    case L2Kind::mixture: return visit(MixtureKernel{});
    case L2Kind::modified: return visit(ModifiedKernel{});
    }
    throw PointError("there is no such kind of L2 discrepancy");
}

std::vector<double> directDiscrepancies(const UnitPoints& points,
                                        const std::vector<L2Kind>& kinds) {
    std::vector<double> result;
    result.reserve(kinds.size());
    for (const L2Kind kind : kinds) {
        result.push_back(withKernel(kind, [&](auto kernel) {
            using Kernel = decltype(kernel);
            return discrepancyOf<Kernel>(points, DirectPairs<Kernel>(points).sum());
        }));
    }
    return result;
}

} // namespace

std::vector<double> l2Discrepancies(const UnitPoints& points, const std::vector<L2Kind>& kinds) {
    if (points.dims() > kMaxFastL2Dimensions) return directDiscrepancies(points, kinds);
    const MinimumSums sums(points);
    std::vector<unsigned> axes(points.dims());
    std::iota(axes.begin(), axes.end(), 0u);
    const long double minima = sums.sum(std::vector<double>(points.count(), 1.0), axes);
    std::vector<double> result;
    result.reserve(kinds.size());
    for (const L2Kind kind : kinds) {
        result.push_back(withKernel(kind, [&](auto kernel) {
            using Kernel = decltype(kernel);
            return discrepancyOf<Kernel>(points, ExpandedPairs<Kernel>(points, sums, minima).sum());
        }));
    }
    return result;
}

double l2Discrepancy(const UnitPoints& points, L2Kind kind) {
    return l2Discrepancies(points, {kind}).front();
}

} // namespace stream1
} // namespace wellstrat
