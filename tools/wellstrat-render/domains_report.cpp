// SPDX-License-Identifier: Apache-2.0

#include "domains_report.h"

#include "common/command_line/messages.h"
#include "common/command_line/versions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wellstrat::cli {
namespace {

/// A gain in the error that is worth a change, if it is beyond two standard errors.
constexpr double kWorthwhile = 0.95;

render::Measured squareRoot(const render::Measured& x) {
    const double root = std::sqrt(std::max(0.0, x.value));
    return {root, root > 0 ? x.standardError / (2 * root) : 0};
}

nlohmann::ordered_json partJson(const Part& part) {
    return {{"name", part.name},
            {"part", part.value.value},
            {"standard_error", part.value.standardError}};
}

bool isLess(const Part& a, const Part& b) { return a.value.value < b.value.value; }

/// Whether the error of a generator or of the floor is less than that of pmj by enough.
bool gains(const render::Measured& part) {
    const render::Measured root = squareRoot(part);
    return root.value < kWorthwhile && root.value + 2 * root.standardError < 1;
}

/// One or two sentences.
std::string adviceOf(const DomainErrors& errors) {
    if (!(errors.rmse > 0) || errors.domains.empty()) return "nothing, there is no error.";
    const render::Measured floor = squareRoot(errors.sum.value);
    const std::string largest =
        std::max_element(errors.domains.begin(), errors.domains.end(), isLess)->name;
    const auto best = std::min_element(errors.generators.begin(), errors.generators.end(), isLess);
    if (best != errors.generators.end() && gains(best->value)) {
        const double error = squareRoot(best->value).value;
        return fmt::format(
            "take {}, whose error is {:.2f} of that of pmj.{}", best->name, error,
            floor.value + 2 * floor.standardError < error
                ? fmt::format(" Other slots might come nearer to {:.2f}.", floor.value)
                : "");
    }
    if (gains(errors.sum.value)) {
        return fmt::format(
            "{:.0f} % of the error is made between domains, but none of the generators tried has "
            "less. Try others with --generators, or other slots of joint.",
            100 * (1 - floor.value));
    }
    return fmt::format(
        "most of the error is made within domains, so stratifying them together gains little. Take "
        "more samples, or sample better what '{}' draws, which makes the largest part.",
        largest);
}

} // namespace

std::string domainsText(const DomainsOptions& options, ImageSize size, const DomainErrors& errors) {
    std::string text = fmt::format(
        "{}\n{}, {}x{} pixels, depth {}, {} samples of each pixel, {} seeds: RMSE {:.4g} "
        "of pmj\n\n",
        versionLine(), oneLine(options.scene.scene), size.width, size.height, options.scene.depth,
        options.spp, options.seeds, errors.rmse);
    const auto out = std::back_inserter(text);
    const auto row = [&out](const std::string& name, const render::Measured& x) {
        fmt::format_to(out, "  {:<14} {:>6.3f} +- {:.3f}\n", name, x.value, x.standardError);
    };
    text += "Part of the mean squared error\n";
    for (const Part& part : errors.domains) row(part.name, part.value);
    row("sum", errors.sum.value);
    text += "\nOf the RMSE\n";
    row("floor", squareRoot(errors.sum.value));
    for (const Part& part : errors.generators) row(part.name, squareRoot(part.value));
    return text + "\nWhat to do: " + adviceOf(errors) + "\n";
}

std::string domainsJson(const DomainsOptions& options, ImageSize size, const DomainErrors& errors) {
    nlohmann::ordered_json json = versionedJson();
    json["scene"] = options.scene.scene;
    json["size"] = {size.width, size.height};
    json["depth"] = options.scene.depth;
    json["samples"] = options.spp;
    json["seeds"] = options.seeds;
    json["rmse"] = errors.rmse;
    for (const auto& [key, parts] :
         {std::pair("domains", &errors.domains), std::pair("generators", &errors.generators)}) {
        json[key] = nlohmann::ordered_json::array();
        for (const Part& part : *parts) json[key].push_back(partJson(part));
    }
    json["sum"] = partJson(errors.sum);
    return json.dump(2) + "\n";
}

} // namespace wellstrat::cli
