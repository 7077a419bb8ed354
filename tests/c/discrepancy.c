// SPDX-License-Identifier: Apache-2.0
//
// The header of the analysis library in C: one point in the middle has an L2 star discrepancy of
// 1 / sqrt(12), by an integral that is easy to take.

#include "wellstrat/analysis/c.h"
#include "wellstrat/c.h"

#include <stdio.h>

int main(void) {
    const double middle = 0.5;
    double discrepancy = 0;
    if (wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, &middle, 1, 1, &discrepancy) != WELLSTRAT_OK) {
        fprintf(stderr, "%s\n", wellstrat_last_error());
        return 1;
    }
    const double error = discrepancy * discrepancy - 1.0 / 12;
    printf("%.17g\n", discrepancy);
    return error < 1e-15 && error > -1e-15 ? 0 : 1;
}
