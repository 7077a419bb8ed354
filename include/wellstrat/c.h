// SPDX-License-Identifier: Apache-2.0
//
// The interface in C99: samples, contexts and domains for engines in C, and for languages that call
// C. It is part of the library, makes the same bits as RixRNG.h, and can be included from C++ too.
// docs/c.md has examples in C, Python and Fortran, and the layouts for foreign callers.
//
// Functions that can fail return a status, an int: WELLSTRAT_OK or what was wrong, which
// wellstrat_last_error() says in a sentence. Then they have written nothing. No exception leaves
// them, and no input ends the program; but that arrays are as long as they are said to be, nobody
// can check.
//
// Arrays belong to the caller and need no alignment beyond that of their type. With 0 points, their
// pointers may be null. Input and output must not overlap unless they are the same array of the
// same type. All functions may be called from any thread, for arrays that no other thread writes.

#ifndef WELLSTRAT_C_H
#define WELLSTRAT_C_H

// NOLINTBEGIN(modernize-*, readability-identifier-naming): C, and names by its customs

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define WELLSTRAT_C_API __attribute__((visibility("default")))
#else
#define WELLSTRAT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// The statuses of functions. Their numbers never change.
enum {
    WELLSTRAT_OK = 0,
    WELLSTRAT_INVALID = 1,  ///< an argument is out of range, null or unknown
    WELLSTRAT_NO_MEMORY = 2 ///< there is not enough memory; the call may be tried again
};

/// What went wrong in the last call of this thread that failed: one sentence, which names the
/// function, the argument and what is accepted. Empty if none failed. Valid until the next call of
/// this thread that fails; owned by the library.
WELLSTRAT_C_API const char* wellstrat_last_error(void);

/// The version of the library, such as "0.1.0". Owned by the library.
WELLSTRAT_C_API const char* wellstrat_version(void);

/// The version of the sample values: as long as it is the same, so is every bit of every sample.
/// The header's and the library's; they differ where a program runs with another library than it
/// was compiled for.
#define WELLSTRAT_C_STREAM_VERSION 1
WELLSTRAT_C_API uint32_t wellstrat_stream_version(void);

/// Builds the tables that pmj and joint draw from, 12 MiB, if that has not been done: some
/// milliseconds that the first draw would take otherwise. Fails without memory.
WELLSTRAT_C_API int wellstrat_build_tables(void);

/// Names one sample: `patternid` the randomised sequence, `sampleid` the position in it. Any two
/// numbers are valid. For the next sample of the same sequence add 1 to `sampleid`, modulo 2^32.
/// 8 bytes, in this order.
typedef struct wellstrat_context {
    uint32_t patternid;
    uint32_t sampleid;
} wellstrat_context;

/// The context of sample `sampleid` of pixel (x, y) in `frame`. x and y count modulo 2^16; images
/// of different frames or seeds are independent. For all generators but blue.
WELLSTRAT_C_API wellstrat_context wellstrat_camera_context(int32_t x, int32_t y, uint32_t frame,
                                                           uint32_t sampleid, uint32_t seed);

/// The same for the generator blue: the pixels of one seed know of each other.
WELLSTRAT_C_API wellstrat_context wellstrat_blue_context(int32_t x, int32_t y, uint32_t seed,
                                                         uint32_t sampleid);

/// Whose samples a domain draws. The numbers never change.
enum {
    WELLSTRAT_PMJ = 0,   ///< from the tables, stratified to 4096 samples
    WELLSTRAT_JOINT = 1, ///< the same; slots are stratified together (wellstrat/joint.h)
    WELLSTRAT_LONG = 2,  ///< computed, stratified to 2^32, with slots (wellstrat/long.h)
    WELLSTRAT_BLUE = 3,  ///< the same, and over neighboring pixels (wellstrat/blue.h)
    WELLSTRAT_RANDOM = 4 ///< not stratified, to compare with
};

/// How many slots there are, and the `slot` of a domain that has none.
#define WELLSTRAT_SLOTS 16
#define WELLSTRAT_NO_SLOT WELLSTRAT_SLOTS
/// The most branches in all that a domain with a slot may have.
#define WELLSTRAT_MAX_SPLITS 256

/// What all points of a domain have in common: whose samples it draws, and how it was derived.
/// A value; it is made by wellstrat_camera_domain, and derived by wellstrat_new_domain and its kin.
/// Contexts may be copied, left out and put in another order as long as they keep their domain.
/// Where it is not known of contexts in which domain they are, set `slot` to WELLSTRAT_NO_SLOT:
/// that is sound whatever they are.
/// 8 bytes, in this order.
typedef struct wellstrat_domain {
    uint32_t generator; ///< one of the five above
    uint16_t slot;      ///< in [0, WELLSTRAT_SLOTS), or WELLSTRAT_NO_SLOT. Not inherited
    uint16_t splits; ///< the product of all splits since the camera, in [1, WELLSTRAT_MAX_SPLITS];
                     ///< 0, without a slot: more than that, or a distribution
} wellstrat_domain;

/// The domain of a camera's contexts, into *domain. Fails for an unknown generator.
WELLSTRAT_C_API int wellstrat_camera_domain(uint32_t generator, wellstrat_domain* domain);

/// Scrambles of the domains that every camera has.
#define WELLSTRAT_PIXEL_FILTER_SCRAMBLE UINT32_C(0x243f6a88)
#define WELLSTRAT_LENS_SCRAMBLE UINT32_C(0x85a308d3)
#define WELLSTRAT_TIME_SCRAMBLE UINT32_C(0x13198a2e)

/// The scramble that derives the domain of `slot`, in [0, WELLSTRAT_SLOTS). With a larger number it
/// is a scramble like any other.
WELLSTRAT_C_API uint32_t wellstrat_joint_scramble(uint32_t slot);

/// A new domain of one context: the domain into *child, the context into *newcontext. `scramble`
/// is any number, but a different one for each domain of the same parent.
///
///     new_domain            one sample for each visit: the same sampleid
///     new_domain_split      `newnumsamples` samples for each visit, always as many: they begin at
///                           sampleid * newnumsamples, modulo 2^32
///     new_domain_distrib    any number of samples: an independent sequence for each visit, which
///                           begins at `newsampleid`, usually 0
///
/// Fails for null pointers and for a parent that nobody derives.
WELLSTRAT_C_API int wellstrat_new_domain(wellstrat_domain parent, uint32_t scramble,
                                         wellstrat_context context, wellstrat_domain* child,
                                         wellstrat_context* newcontext);
WELLSTRAT_C_API int wellstrat_new_domain_split(wellstrat_domain parent, uint32_t scramble,
                                               uint32_t newnumsamples, wellstrat_context context,
                                               wellstrat_domain* child,
                                               wellstrat_context* newcontext);
WELLSTRAT_C_API int wellstrat_new_domain_distrib(wellstrat_domain parent, uint32_t scramble,
                                                 uint32_t newsampleid, wellstrat_context context,
                                                 wellstrat_domain* child,
                                                 wellstrat_context* newcontext);

/// The same for parents[0, n), into children[0, n), which may be where `parents` are. With n = 0
/// only *child is written. n is below 2^32.
WELLSTRAT_C_API int wellstrat_new_domains(wellstrat_domain parent, uint32_t scramble, size_t n,
                                          const wellstrat_context* parents, wellstrat_domain* child,
                                          wellstrat_context* children);
WELLSTRAT_C_API int wellstrat_new_domains_split(wellstrat_domain parent, uint32_t scramble,
                                                uint32_t newnumsamples, size_t n,
                                                const wellstrat_context* parents,
                                                wellstrat_domain* child,
                                                wellstrat_context* children);
WELLSTRAT_C_API int wellstrat_new_domains_distrib(wellstrat_domain parent, uint32_t scramble,
                                                  uint32_t newsampleid, size_t n,
                                                  const wellstrat_context* parents,
                                                  wellstrat_domain* child,
                                                  wellstrat_context* children);

/// The sample of a context in a domain: z, (x, y) or (x, y, z), each a multiple of 2^-24 in [0, 1),
/// into xi[0, 1), xi[0, 2) or xi[0, 3). A 1D and a 2D draw of one context are together its 3D
/// sample. Fails for a null pointer, for a domain that nobody derives, and without memory for the
/// tables that pmj and joint need.
WELLSTRAT_C_API int wellstrat_draw_sample_1d(wellstrat_domain domain, wellstrat_context context,
                                             float* xi);
WELLSTRAT_C_API int wellstrat_draw_sample_2d(wellstrat_domain domain, wellstrat_context context,
                                             float* xi);
WELLSTRAT_C_API int wellstrat_draw_sample_3d(wellstrat_domain domain, wellstrat_context context,
                                             float* xi);

/// The same for contexts[0, n), point after point: into xis[0, n), xis[0, 2 n), xis[0, 3 n). n is
/// below 2^32. Uses the vector instructions of the processor, with the same bits.
WELLSTRAT_C_API int wellstrat_draw_samples_1d(wellstrat_domain domain, size_t n,
                                              const wellstrat_context* contexts, float* xis);
WELLSTRAT_C_API int wellstrat_draw_samples_2d(wellstrat_domain domain, size_t n,
                                              const wellstrat_context* contexts, float* xis);
WELLSTRAT_C_API int wellstrat_draw_samples_3d(wellstrat_domain domain, size_t n,
                                              const wellstrat_context* contexts, float* xis);

/// All 32 bits of x, y and z of contexts[0, n), as fractions of 2^32, into words[0, 3 n). Samples
/// are the upper 24 of them. Of long and blue, which compute so many; fails for other generators.
WELLSTRAT_C_API int wellstrat_draw_words(wellstrat_domain domain, size_t n,
                                         const wellstrat_context* contexts, uint32_t* words);

/// A uniformly distributed number that depends on a and b only, as an integer and as a float in
/// [0, 1) of its upper 24 bits. Of many pairs, draw_samples_1d of the generator random makes the
/// floats of (patternid, sampleid).
WELLSTRAT_C_API uint32_t wellstrat_hash_to_unsigned(uint32_t a, uint32_t b);
WELLSTRAT_C_API float wellstrat_hash_to_random(uint32_t a, uint32_t b);

/// Chooses 0 with probability prob0 and 1 otherwise, into *chosen, and stretches the part of [0, 1)
/// that was chosen back over [0, 1): *xi, in [0, 1) before and after, can be used again. prob0
/// below 0, or NaN, counts as 0; above 1 as 1.
WELLSTRAT_C_API int wellstrat_choose_of_two_and_remap(float prob0, float* xi, uint32_t* chosen);

/// Chooses i in [0, n) with probability weights[i] / (sum of weights), into *chosen, and stretches
/// *xi as above. *prob is that probability, unless `prob` is null. Weights are finite; one that is
/// 0, negative or NaN is never chosen. If no weight is above 0, *chosen is n, *prob is 0, and *xi
/// stays. n is below 2^32.
WELLSTRAT_C_API int wellstrat_choose_and_remap(const float* weights, size_t n, float* xi,
                                               uint32_t* chosen, float* prob);

#ifdef __cplusplus
} // extern "C"
#endif

// NOLINTEND(modernize-*, readability-identifier-naming)

#endif // WELLSTRAT_C_H
