// SPDX-License-Identifier: Apache-2.0
//
// The sub-commands of wellstrat-render, which `wellstrat` passes on to it.

#pragma once

namespace wellstrat::cli {

constexpr auto kRenderProgram = "wellstrat-render";

struct RenderCommand {
    const char *name, *description;
};

constexpr RenderCommand kRender{"render", "Draw a scene"};
constexpr RenderCommand kMerge{"merge", "Put images of different samples together"};
constexpr RenderCommand kCompare{"compare",
                                 "Compare generators by the error of their images, as a page"};
constexpr RenderCommand kDomains{"domains",
                                 "Say which sample domains the error of an image comes from"};
constexpr RenderCommand kRenderCommands[]{kRender, kMerge, kCompare, kDomains};

} // namespace wellstrat::cli
