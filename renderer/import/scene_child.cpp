// SPDX-License-Identifier: Apache-2.0

#include "scene_child.h"

#include "../texture.h"
#include "scene_pipe.h"

#include <exception>
#include <new>

namespace wellstrat::render {

Scene makeInChild(const std::function<Scene()>& make, const ChildLimits& limits) {
    Scene scene;
    const auto send = [&](int pipe) {
        readTexturesInOneThread();
        try {
            sendScene(make(), pipe);
        } catch (const std::bad_alloc&) {
            sendFailure("there is not enough memory", pipe);
        } catch (const std::exception& error) {
            sendFailure(error.what(), pipe);
        }
    };
    runInChild(
        send, [&](int pipe) { scene = receiveScene(pipe); }, limits);
    return scene;
}

} // namespace wellstrat::render
