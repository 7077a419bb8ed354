// SPDX-License-Identifier: Apache-2.0
//
// The vector types of RenderMan plug-ins, as far as sampling code uses them.

#pragma once

#include "prmanapi.h"
#include "wellstrat/vector.h"

using RtFloat2 = wellstrat::Float2;
using RtFloat3 = wellstrat::Float3;
using RtPoint3 = wellstrat::Float3;
using RtVector3 = wellstrat::Float3;
using RtNormal3 = wellstrat::Float3;
