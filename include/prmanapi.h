// SPDX-License-Identifier: Apache-2.0
//
// The scalar types and the marks that the code of RenderMan plug-ins uses.

#pragma once

#include "wellstrat/platform.h"

// Published plug-ins call assert() without including it.
#include <cassert>

#define PRMAN_INLINE inline

/// On the functions by which a renderer finds a plug-in, after `extern "C"`, which it does not say
/// itself: visible from outside, also where other symbols are hidden.
#if defined(_WIN32)
#define PRMANEXPORT __declspec(dllexport)
#else
#define PRMANEXPORT __attribute__((visibility("default")))
#endif

/// A statement that marks an argument as unused on purpose, so that compilers do not warn.
#define PIXAR_ARGUSED(argument) static_cast<void>(argument)

using RtFloat = float;
using RtInt = int;
