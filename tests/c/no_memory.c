// SPDX-License-Identifier: Apache-2.0
//
// Without memory for the tables, they and all draws from them fail and say so; what is computed is
// drawn all the same. With memory, the same calls succeed.

#include "wellstrat/c.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

static void require(int condition, const char* what) {
    if (condition) return;
    fprintf(stderr, "c_no_memory: %s; the last error is '%s'\n", what, wellstrat_last_error());
    exit(1);
}

static int draw(uint32_t generator, size_t n, float* xis) {
    wellstrat_domain domain;
    wellstrat_context contexts[40];
    memset(contexts, 0, sizeof contexts);
    require(wellstrat_camera_domain(generator, &domain) == WELLSTRAT_OK, "there is no generator");
    return wellstrat_draw_samples_2d(domain, n, contexts, xis);
}

int main(void) {
    const struct rlimit none = {0, RLIM_INFINITY}, all = {RLIM_INFINITY, RLIM_INFINITY};
    float xis[80];
    for (int i = 0; i < 80; ++i) xis[i] = 7.0f;

    require(setrlimit(RLIMIT_AS, &none) == 0, "cannot limit the memory");
    require(wellstrat_build_tables() == WELLSTRAT_NO_MEMORY, "the tables should fail");
    require(strcmp(wellstrat_last_error(), "wellstrat_build_tables: there is not enough memory") ==
                0,
            "the text should say why");
    for (uint32_t generator = WELLSTRAT_PMJ; generator <= WELLSTRAT_JOINT; ++generator) {
        for (size_t n = 1; n <= 40; n += 13) {
            require(draw(generator, n, xis) == WELLSTRAT_NO_MEMORY, "draws should fail");
        }
    }
    for (int i = 0; i < 80; ++i) require(xis[i] == 7.0f, "nothing should be written");
    for (uint32_t generator = WELLSTRAT_LONG; generator <= WELLSTRAT_RANDOM; ++generator) {
        require(draw(generator, 40, xis) == WELLSTRAT_OK, "computed samples need no memory");
    }

    require(setrlimit(RLIMIT_AS, &all) == 0, "cannot lift the limit");
    require(wellstrat_build_tables() == WELLSTRAT_OK, "the tables should be built");
    require(draw(WELLSTRAT_PMJ, 40, xis) == WELLSTRAT_OK, "samples should be drawn");
    return 0;
}
