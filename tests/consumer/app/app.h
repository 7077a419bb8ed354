// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "RixRNG.h"

// The second translation unit's view of a sample.
RtFloat3 drawInSecondUnit(unsigned patternid, unsigned sampleid);
