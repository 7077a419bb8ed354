// SPDX-License-Identifier: Apache-2.0
#include <wellstrat/c.h>

#include <stdio.h>
#include <stdlib.h>

static void require(int status) { // so that no failure passes unseen
    if (status == WELLSTRAT_OK) return;
    fprintf(stderr, "%s\n", wellstrat_last_error());
    exit(1);
}

int main(void) {
    wellstrat_domain pixel, light;
    wellstrat_context contexts[4], lightContexts[4];
    float xi[4][2], onLight[4][2];

    require(wellstrat_camera_domain(WELLSTRAT_PMJ, &pixel));
    for (uint32_t i = 0; i < 4; ++i) // four samples of pixel (320, 200) in frame 1
        contexts[i] = wellstrat_camera_context(320, 200, 1, i, 0);
    require(wellstrat_new_domains(pixel, 0x5d1c9a37, 4, contexts, &light, lightContexts));

    require(wellstrat_draw_samples_2d(pixel, 4, contexts, &xi[0][0]));
    require(wellstrat_draw_samples_2d(light, 4, lightContexts, &onLight[0][0]));
    for (int i = 0; i < 4; ++i)
        printf("sample %d: pixel (%.3f, %.3f)  light (%.3f, %.3f)\n", i, xi[i][0], xi[i][1],
               onLight[i][0], onLight[i][1]);
    return 0;
}
