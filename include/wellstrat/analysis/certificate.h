// SPDX-License-Identifier: Apache-2.0
//
// The certificate: an exact check of every promise about stratification, on the tables and on the
// samples that users draw.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// One promise and what its check found.
struct CertificateLine {
    std::string promise;        ///< for example "(x, y): (0,m,2)-net in base 2"
    std::string subject;        ///< what was checked, for example "384 tables, m = 0..12"
    uint64_t intervals;         ///< elementary intervals counted, or whatever `subject` counts
    uint64_t violations;        ///< of these, how many break the promise
    std::string firstViolation; ///< names the table or pattern, block and interval; or empty
};

/// Called now and then from the checking thread with the share of the work done, which grows from
/// above 0 to 1. What it throws ends the check and passes through.
using CertificateProgress = std::function<void(double)>;

/// Checks tables first to last, both in [0, kTableCount), first <= last. Throws
/// std::invalid_argument otherwise. All tables take a second or two.
///
/// For each table, each m from 0 to 12 and each aligned block of 2^m points: x, y and z in 2^m
/// strata, (x, y) as a (0,m,2)-net, (x, y, z) as a (1,m,3)-net, and for even m one point in each
/// base-4 box. And that no two of the tables are the same but for a shuffle and a digital shift.
WELLSTRAT_API std::vector<CertificateLine> certifyTables(unsigned first, unsigned last,
                                                         const CertificateProgress& progress = {});

/// Checks what users draw for `count` pseudo-random patterns (the same ones for the same `seed`)
/// and for a few special ones; 0 leaves only these. 1000 patterns take some 10 seconds.
///
/// For each pattern: the promises that certifyTables checks, for samples 0 to 4095, for the last
/// block of 4096, and for one between (the second of special patterns, else a pseudo-random one);
/// that draws in one, two and three dimensions, single and in batches, agree bit for bit, in any
/// order; that values are multiples of 2^-24 in [0, 1); that the 48 blocks use 48 different tables;
/// and that samples from kStratifiedSamples to 2^32 - 1 are hashes, one for each coordinate.
WELLSTRAT_API std::vector<CertificateLine>
certifyPatterns(unsigned count, uint32_t seed = 1, const CertificateProgress& progress = {});

/// Checks what users draw from LongProgressive: of `count` pseudo-random patterns and some special
/// ones the first or the last 4096 samples, and 4096 others, in the padded domain and in all slots
/// by turns. The same promises about nets, draws and values. 1000 patterns take some 6 seconds.
WELLSTRAT_API std::vector<CertificateLine> certifyLong(unsigned count, uint32_t seed = 1,
                                                       const CertificateProgress& progress = {});

/// Checks what users draw from BlueProgressive, in `count` pseudo-random tiles of 64 x 64 pixels
/// and some more, in the padded domain and in all slots by turns: the same of one pixel; and of a
/// block of 2^a x 2^a pixels, a = 1..6 by turns, that 2^k samples of all of its pixels are a
/// (0,k+2a,2)-net in (x, y) and stratified in z. 1000 tiles take some 6 seconds.
WELLSTRAT_API std::vector<CertificateLine> certifyBlue(unsigned count, uint32_t seed = 1,
                                                       const CertificateProgress& progress = {});

} // namespace stream1
} // namespace wellstrat
