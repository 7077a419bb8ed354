// SPDX-License-Identifier: Apache-2.0
//
// The renderer under the linter of domains.

#include "rendering.h"

#include "renderer/builtin_scenes.h"
#include "wellstrat/blue.h"
#include "wellstrat/domain_linter.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"

namespace wellstrat::render {
namespace {

constexpr unsigned kSide = 12; // the linter remembers every sample
constexpr unsigned kSamples = 7;

class Linted : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Scenes, Linted, ::testing::Values("cornell", "lens", "spherelight"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Linted, HasNoFaults) {
    const Scene scene = builtinScene(GetParam());
    const JointProgressive joint;
    const LongProgressive longer;
    const BlueProgressive blue;
    const Generator* const inners[] = {nullptr, &joint, &longer, &blue};
    for (const Generator* inner : inners) {
        for (const unsigned split : {1u, 3u}) {
            for (const bool distrib : {false, true}) {
                DomainLinter linter(inner);
                SamplingOptions options;
                options.generator = &linter;
                options.split = split;
                options.distrib = distrib;
                renderFilm(scene, kSide, kSamples, options);
                EXPECT_EQ(linter.report().rfind("no faults in ", 0), 0u)
                    << linter.report() << "split " << split << ", distribution " << distrib;
                EXPECT_EQ(linter.report().rfind("no faults in 0 ", 0), std::string::npos);
            }
        }
    }
}

} // namespace
} // namespace wellstrat::render
