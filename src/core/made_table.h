// SPDX-License-Identifier: Apache-2.0
//
// How tables that follow from less are made: by the compiler. In WebAssembly, which is downloaded,
// when the module starts, in less than a millisecond: most of them do not compress.

#pragma once

/// On these tables, which are const as well, and on the functions that make them.
#if defined(__wasm__)
#define WELLSTRAT_MADE
#else
#define WELLSTRAT_MADE constexpr
#endif
