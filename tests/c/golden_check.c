// SPDX-License-Identifier: Apache-2.0
//
// c_golden_check FILE...: recomputes through the interface in C every record of files of golden
// values (tests/golden/golden.h explains them), but for the contents of tables, which C does not
// read. Exit code 0 if all agree, 1 if one does not, 2 if a file cannot be read or is none.

#include "wellstrat/c.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// One word more than any record has on a side.
enum { kMaxWords = 6, kBatch = 2 * 16 + 5, kMaxLine = 256 };

// Prints what the library says is wrong, if anything, and ends the program.
static void require(int status) {
    if (status == WELLSTRAT_OK) return;
    fprintf(stderr, "c_golden_check: %s\n", wellstrat_last_error());
    exit(1);
}

// Ends the program unless two ways to one answer agree.
static void agree(int same, const char* what) {
    if (same) return;
    fprintf(stderr, "c_golden_check: %s\n", what);
    exit(1);
}

// The 24 bits of a sample.
static uint32_t bits_of(float xi) {
    const float scaled = xi * 16777216.0f;
    agree(scaled >= 0 && scaled < 16777216.0f && (float)(uint32_t)scaled == scaled,
          "a sample is no multiple of 2^-24 in [0, 1)");
    return (uint32_t)scaled;
}

// A batch that starts with the context a[0], a[1].
static void fill_batch(const uint32_t* a, wellstrat_context* contexts) {
    for (uint32_t i = 0; i < kBatch; ++i) {
        contexts[i].patternid = a[0] + i;
        contexts[i].sampleid = a[1] + i;
    }
}

// x, y and z of n contexts, drawn in all the ways there are, into bits[0, 3 n).
static void draw(wellstrat_domain domain, const wellstrat_context* contexts, size_t n,
                 uint32_t* bits) {
    float* const xis = malloc(6 * n * sizeof(float));
    agree(xis != NULL, "out of memory");
    float* const z = xis;
    float* const xy = xis + n;
    float* const xyz = xis + 3 * n;
    require(wellstrat_draw_samples_1d(domain, n, contexts, z));
    require(wellstrat_draw_samples_2d(domain, n, contexts, xy));
    require(wellstrat_draw_samples_3d(domain, n, contexts, xyz));
    for (size_t i = 0; i < n; ++i) {
        float one[1], two[2], three[3];
        require(wellstrat_draw_sample_1d(domain, contexts[i], one));
        require(wellstrat_draw_sample_2d(domain, contexts[i], two));
        require(wellstrat_draw_sample_3d(domain, contexts[i], three));
        agree(one[0] == z[i] && two[0] == xy[2 * i] && two[1] == xy[2 * i + 1] &&
                  three[0] == two[0] && three[1] == two[1] && three[2] == one[0] &&
                  memcmp(three, xyz + 3 * i, sizeof three) == 0,
              "draws of one context differ");
        for (int d = 0; d < 3; ++d) bits[3 * i + (size_t)d] = bits_of(three[d]);
    }
    free(xis);
}

static size_t first_sample(const uint32_t* a, uint32_t generator, int has_slot, uint32_t* results) {
    wellstrat_domain domain;
    wellstrat_context contexts[kBatch];
    uint32_t bits[3 * kBatch];
    require(wellstrat_camera_domain(generator, &domain));
    if (has_slot) {
        require(wellstrat_new_domains_split(domain, wellstrat_joint_scramble(a[2]), a[3], 0, NULL,
                                            &domain, NULL));
    }
    fill_batch(a, contexts);
    draw(domain, contexts, kBatch, bits);
    memcpy(results, bits, 3 * sizeof *bits);
    return 3;
}

static size_t sample(const uint32_t* a, uint32_t generator, uint32_t* r) {
    return first_sample(a, generator, 0, r);
}
static size_t slot_sample(const uint32_t* a, uint32_t generator, uint32_t* r) {
    return first_sample(a, generator, 1, r);
}

static size_t sequence(const uint32_t* a, uint32_t generator, uint32_t* r) {
    wellstrat_domain domain;
    const wellstrat_context context = {a[0], a[1]};
    require(wellstrat_camera_domain(generator, &domain));
    require(wellstrat_draw_words(domain, 1, &context, r));
    return 3;
}

// FNV-1a of the bytes of all samples, drawn in batches of 1, 2, 3, ...
static size_t run(const uint32_t* a, uint32_t generator, uint32_t* r) {
    wellstrat_domain domain;
    require(wellstrat_camera_domain(generator, &domain));
    uint32_t hash = 2166136261u;
    for (uint32_t first = 0, n = 1; first < a[2]; first += n, ++n) {
        if (n > a[2] - first) n = a[2] - first;
        wellstrat_context* const contexts = malloc(n * sizeof *contexts);
        uint32_t* const bits = malloc(3 * n * sizeof *bits);
        agree(contexts != NULL && bits != NULL, "out of memory");
        for (uint32_t i = 0; i < n; ++i) {
            contexts[i].patternid = a[0];
            contexts[i].sampleid = a[1] + first + i;
        }
        draw(domain, contexts, n, bits);
        for (uint32_t i = 0; i < 3 * n; ++i) {
            for (int shift = 0; shift < 32; shift += 8) {
                hash = (hash ^ (bits[i] >> shift & 0xffu)) * 16777619u;
            }
        }
        free(contexts);
        free(bits);
    }
    r[0] = hash;
    return 1;
}

static size_t hash(const uint32_t* a, uint32_t generator, uint32_t* r) {
    (void)generator;
    r[0] = wellstrat_hash_to_unsigned(a[0], a[1]);
    agree(bits_of(wellstrat_hash_to_random(a[0], a[1])) == r[0] >> 8, "the hashes differ");
    return 1;
}

static size_t context_words(wellstrat_context context, uint32_t* r) {
    r[0] = context.patternid;
    r[1] = context.sampleid;
    return 2;
}

enum kind { kPlain, kSplit, kDistrib };

static size_t derived(const uint32_t* a, uint32_t generator, enum kind kind, uint32_t* r) {
    wellstrat_domain camera, child, child_of_one;
    wellstrat_context parents[kBatch], children[kBatch], one;
    fill_batch(a, parents);
    require(wellstrat_camera_domain(generator, &camera));
    for (int i = 0; i < kBatch; ++i) {
        switch (kind) {
        case kPlain:
            require(wellstrat_new_domain(camera, a[2], parents[i], &child_of_one, &one));
            require(wellstrat_new_domains(camera, a[2], kBatch, parents, &child, children));
            break;
        case kSplit:
            require(
                wellstrat_new_domain_split(camera, a[2], a[3], parents[i], &child_of_one, &one));
            require(
                wellstrat_new_domains_split(camera, a[2], a[3], kBatch, parents, &child, children));
            break;
        case kDistrib:
            require(
                wellstrat_new_domain_distrib(camera, a[2], a[3], parents[i], &child_of_one, &one));
            require(wellstrat_new_domains_distrib(camera, a[2], a[3], kBatch, parents, &child,
                                                  children));
            break;
        }
        agree(memcmp(&one, &children[i], sizeof one) == 0 &&
                  memcmp(&child_of_one, &child, sizeof child) == 0,
              "domains of one context differ");
    }
    return context_words(children[0], r);
}

static size_t domain(const uint32_t* a, uint32_t generator, uint32_t* r) {
    return derived(a, generator, kPlain, r);
}
static size_t split(const uint32_t* a, uint32_t generator, uint32_t* r) {
    return derived(a, generator, kSplit, r);
}
static size_t distrib(const uint32_t* a, uint32_t generator, uint32_t* r) {
    return derived(a, generator, kDistrib, r);
}

// a[4] is 0 where a record has no seed.
static size_t camera(const uint32_t* a, uint32_t generator, uint32_t* r) {
    const int32_t x = (int32_t)a[0], y = (int32_t)a[1];
    return context_words(generator == WELLSTRAT_BLUE
                             ? wellstrat_blue_context(x, y, a[2], a[3])
                             : wellstrat_camera_context(x, y, a[2], a[3], a[4]),
                         r);
}

static size_t stream(const uint32_t* a, uint32_t generator, uint32_t* r) {
    (void)a;
    (void)generator;
    r[0] = wellstrat_stream_version();
    agree(r[0] == WELLSTRAT_C_STREAM_VERSION, "header and library are of two streams");
    return 1;
}

static const struct {
    const char* name;
    size_t arguments;
    size_t (*answer)(const uint32_t* arguments, uint32_t generator, uint32_t* results);
    uint32_t generator;
} kKinds[] = {
    {"stream", 0, stream, WELLSTRAT_PMJ},
    {"sample", 2, sample, WELLSTRAT_PMJ},
    {"random", 2, sample, WELLSTRAT_RANDOM},
    {"joint", 4, slot_sample, WELLSTRAT_JOINT},
    {"long", 2, sample, WELLSTRAT_LONG},
    {"longslot", 4, slot_sample, WELLSTRAT_LONG},
    {"blue", 2, sample, WELLSTRAT_BLUE},
    {"blueslot", 4, slot_sample, WELLSTRAT_BLUE},
    {"sequence", 2, sequence, WELLSTRAT_LONG},
    {"run", 3, run, WELLSTRAT_PMJ},
    {"hash", 2, hash, WELLSTRAT_PMJ},
    {"domain", 3, domain, WELLSTRAT_PMJ},
    {"distrib", 4, distrib, WELLSTRAT_PMJ},
    {"split", 4, split, WELLSTRAT_PMJ},
    {"bluedistrib", 4, distrib, WELLSTRAT_BLUE},
    {"bluesplit", 4, split, WELLSTRAT_BLUE},
    {"camera", 4, camera, WELLSTRAT_PMJ},
    {"seeded", 5, camera, WELLSTRAT_PMJ},
    {"bluecamera", 4, camera, WELLSTRAT_BLUE},
};

// Reads words, hexadecimal, up to `end` or the end of the line. Returns how many.
static size_t read_words(char** text, char end, uint32_t* words) {
    size_t n = 0;
    while (n < kMaxWords) {
        while (**text == ' ') ++*text;
        if (**text == end || **text == '\n' || **text == '\0') break;
        char* after = *text;
        words[n] = (uint32_t)strtoul(*text, &after, 16);
        if (after == *text) break;
        *text = after;
        ++n;
    }
    return n;
}

enum result { kAgrees, kDiffers, kLeftOut, kNoRecord };

static enum result check(char* line) {
    char* text = strchr(line, ' ');
    if (text == NULL) return kNoRecord;
    const size_t length = (size_t)(text - line);
    if (strncmp(line, "table ", 6) == 0) return kLeftOut;
    uint32_t arguments[kMaxWords] = {0}, expected[kMaxWords], got[kMaxWords];
    const size_t n = read_words(&text, '=', arguments);
    if (*text++ != '=') return kNoRecord;
    const size_t results = read_words(&text, '\n', expected);
    for (size_t k = 0; k < sizeof kKinds / sizeof kKinds[0]; ++k) {
        if (strlen(kKinds[k].name) != length || strncmp(line, kKinds[k].name, length) != 0) {
            continue;
        }
        if (n != kKinds[k].arguments) return kNoRecord;
        const size_t count = kKinds[k].answer(arguments, kKinds[k].generator, got);
        const int same = count == results && memcmp(got, expected, count * sizeof *got) == 0;
        return same ? kAgrees : kDiffers;
    }
    return kNoRecord;
}

int main(int argc, char** argv) {
    unsigned counts[4] = {0, 0, 0, 0};
    for (int i = 1; i < argc; ++i) {
        FILE* const file = fopen(argv[i], "r");
        if (file == NULL) {
            fprintf(stderr, "c_golden_check: cannot read %s\n", argv[i]);
            return 2;
        }
        char line[kMaxLine];
        for (unsigned number = 1; fgets(line, sizeof line, file) != NULL; ++number) {
            if (line[0] == '#' || line[0] == '\n') continue;
            const enum result result = check(line);
            ++counts[result];
            if (result == kDiffers || result == kNoRecord) {
                fprintf(stderr, "%s:%u: %s: %s", argv[i], number,
                        result == kDiffers ? "differs" : "no record", line);
            }
        }
        fclose(file);
    }
    const unsigned compared = counts[kAgrees] + counts[kDiffers];
    printf("%u of %u golden records agree; %u of tables are left out\n", counts[kAgrees], compared,
           counts[kLeftOut]);
    if (compared == 0 || counts[kNoRecord] > 0) return 2;
    return counts[kDiffers] > 0 ? 1 : 0;
}
