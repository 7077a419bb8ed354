// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/integrands.h"

#include "integrand_families.h"

#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

namespace wellstrat {
inline namespace stream1 {
namespace {

[[noreturn]] void reject(const std::string& name, const std::string& reason) {
    throw std::invalid_argument("no integrand is called '" + name + "': " + reason);
}

/// The number that `text` is, up to six digits and without leading zeros.
std::optional<unsigned> numberOf(const std::string& text) {
    if (text.empty() || text.size() > 6 || (text[0] == '0' && text.size() > 1)) return {};
    unsigned number = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return {};
        number = 10 * number + static_cast<unsigned>(c - '0');
    }
    return number;
}

std::string knownNames() {
    std::string names;
    for (const IntegrandRecipe& recipe : integrandRecipes()) {
        names += (names.empty() ? "" : ", ") + recipe.family.name;
    }
    return names;
}

Integrand makeFactor(const std::string& name) {
    for (const auto& [family, make] : integrandRecipes()) {
        if (!family.hasParameter) {
            if (name != family.name) continue;
            const IntegrandShape shape = make(0);
            return {name, family.domains, shape.integral, shape.value};
        }
        const std::string stem = family.name.substr(0, family.name.size() - 1);
        if (name.compare(0, stem.size(), stem) != 0) continue;
        const std::optional<unsigned> parameter = numberOf(name.substr(stem.size()));
        if (!parameter) continue;
        if (*parameter < family.first || *parameter > family.last) {
            reject(name, "the number must be from " + std::to_string(family.first) + " to " +
                             std::to_string(family.last));
        }
        const IntegrandShape shape = make(*parameter);
        return {name, family.domains, shape.integral, shape.value};
    }
    reject(name, "there are " + knownNames() + ", with a number for a capital letter at the end");
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

/// The factors of a product, a power written out.
std::vector<Integrand> makeFactors(const std::string& name) {
    std::vector<Integrand> factors;
    for (const std::string& power : split(name, '*')) {
        const std::vector<std::string> parts = split(power, '^');
        const std::optional<unsigned> exponent =
            parts.size() == 2 ? numberOf(parts[1]) : std::optional<unsigned>(1);
        if (parts.size() > 2 || !exponent || *exponent < 1 || *exponent > kMaxIntegrandDomains) {
            reject(name, "after '^' there must be a number from 1 to " +
                             std::to_string(kMaxIntegrandDomains));
        }
        factors.insert(factors.end(), *exponent, makeFactor(parts[0]));
    }
    return factors;
}

double productValue(const std::vector<Integrand>& factors, const double* point) {
    double product = 1;
    for (const Integrand& factor : factors) {
        product *= factor.value(point);
        point += totalDims(factor.domains);
    }
    return product;
}

} // namespace

unsigned totalDims(const DomainDims& domains) {
    return std::accumulate(domains.begin(), domains.end(), 0u);
}

std::vector<IntegrandFamily> integrandFamilies() {
    std::vector<IntegrandFamily> families;
    for (const IntegrandRecipe& recipe : integrandRecipes()) families.push_back(recipe.family);
    return families;
}

Integrand makeIntegrand(const std::string& name) {
    std::vector<Integrand> factors = makeFactors(name);
    Integrand product{name, {}, 1, {}};
    for (const Integrand& factor : factors) {
        product.domains.insert(product.domains.end(), factor.domains.begin(), factor.domains.end());
        product.integral *= factor.integral;
    }
    if (product.domains.size() > kMaxIntegrandDomains) {
        reject(name, "a product has at most " + std::to_string(kMaxIntegrandDomains) +
                         " domains, not " + std::to_string(product.domains.size()));
    }
    if (factors.size() == 1) {
        product.value = std::move(factors[0].value);
    } else {
        product.value = [factors = std::move(factors)](const double* point) {
            return productValue(factors, point);
        };
    }
    return product;
}

std::vector<IntegrandGroup> integrandGroups() {
    std::vector<IntegrandGroup> groups{
        {"classic", {"disk", "triangle", "step", "gaussian", "bilinear"}},
        {"1d", {"step-1d", "linear", "gaussian-1d", "smooth-1d", "sine-1d-2"}},
        {"3d", {"disk-3d", "triangle-3d", "edge-3d", "gaussian-3d", "trilinear", "smooth-3d"}},
        {"pixels",
         {"soft-shadow-line", "soft-shadow", "checkerboard-1", "checkerboard-8",
          "checkerboard-64"}},
        {"products",
         {"disk^2", "disk^3", "disk^4", "disk^5", "gaussian^2", "gaussian^3", "gaussian^4",
          "gaussian^5"}}};
    IntegrandGroup edges{"edges", {}}, sines{"sines", {}}, boxes{"boxes", {}};
    for (unsigned angle = 0; angle < 360; angle += 15) {
        edges.members.push_back("edge-" + std::to_string(angle));
    }
    for (unsigned frequency = 1; frequency <= 64; frequency *= 2) {
        sines.members.push_back("sine-" + std::to_string(frequency));
    }
    for (unsigned number = 0; number < 16; ++number) {
        boxes.members.push_back("box-" + std::to_string(number));
    }
    for (IntegrandGroup* group : {&edges, &sines, &boxes}) groups.push_back(std::move(*group));
    return groups;
}

} // namespace stream1
} // namespace wellstrat
