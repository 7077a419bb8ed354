// SPDX-License-Identifier: Apache-2.0
//
// The scalar types and the inline mark that the code of RenderMan plug-ins uses.

#pragma once

#include "wellstrat/platform.h"

#define PRMAN_INLINE inline

using RtFloat = float;
using RtInt = int;
