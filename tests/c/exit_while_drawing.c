// SPDX-License-Identifier: Apache-2.0
//
// A thread that draws while the process ends does no harm, such as those of an interpreter: what it
// draws from is not destroyed.

#include "wellstrat/c.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static volatile unsigned long draws = 0;

static void* draw_forever(void* unused) {
    wellstrat_context contexts[40];
    float xis[80];
    memset(contexts, 0, sizeof contexts);
    for (;;) {
        for (uint32_t generator = WELLSTRAT_PMJ; generator <= WELLSTRAT_RANDOM; ++generator) {
            const wellstrat_domain domain = {generator, WELLSTRAT_NO_SLOT, 1};
            if (wellstrat_draw_samples_2d(domain, 40, contexts, xis) != WELLSTRAT_OK) abort();
        }
        ++draws;
    }
    return unused;
}

// After exit has called the destructors of static objects.
__attribute__((destructor)) static void end_late(void) {
    const unsigned long before = draws;
    usleep(100000);
    if (draws == before) abort();
}

int main(void) {
    pthread_t thread;
    if (pthread_create(&thread, NULL, draw_forever, NULL) != 0) return 2;
    while (draws == 0) usleep(1000);
    return 0;
}
