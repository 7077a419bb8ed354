// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "RixRNG.h"

/// Sample `i` of a pattern.
RtFloat2 sampleOf(unsigned patternid, unsigned i);
