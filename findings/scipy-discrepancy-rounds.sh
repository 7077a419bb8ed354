#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# scipy.stats.qmc.discrepancy adds up all n^2 pairs of points in one double, and then subtracts almost
# all of the sum. Of well-stratified points, whose discrepancy is small, few digits are left: of 16384
# Sobol' points in three dimensions four of the centered discrepancy. `workers`, which splits the sum,
# changes them. Workaround: few points, or a package that sums otherwise.
#
# The exact value is a fraction: all coordinates are multiples of 2^-14, so sums of integers have it.
# Needs what python3-scipy depends on; some seconds.
#
# Expected: a relative error of about 1e-15 n, 2e-11, or a word in the documentation on rounding.
# Found: more than a thousand times that, and no word.
# Versions: python3-scipy 1.10.1-2. Source: Debian 12. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch python3-scipy=1.10.1-2
export PYTHONPATH=$folder/usr/lib/python3/dist-packages
/usr/bin/python3 -c 'import scipy.stats' &> log || untried "$(tail -n 1 log)"
/usr/bin/python3 - << 'END' || changed "as printed above"
from fractions import Fraction

import numpy as np
import scipy
from scipy.stats import qmc

n, dims = 2**14, 3
points = qmc.Sobol(dims, scramble=False).random(n)
a = (points * n).astype(np.int64)  # a / n is the coordinate
assert np.array_equal(a / n, points)
z = abs(a - n // 2)  # z / n is its distance from 1/2

# Hickernell 1998: mean over i of prod (1 + z/2 - z^2/2), mean over i, j of
# prod (1 + z_i/2 + z_j/2 - |x_i - x_j|/2)
single = sum(int(p) * int(q) * int(r) for p, q, r in 2 * n * n + n * z - z * z)
double = sum(int((2 * n + z[i] + z - abs(a[i] - a)).prod(axis=1).sum()) for i in range(n))
exact = (Fraction(13, 12)**dims - Fraction(2 * single, n * (2 * n * n)**dims)
         + Fraction(double, n * n * (2 * n)**dims))

print("SciPy", scipy.__version__)
print(f"exact                      {float(exact):.12e}")
worst = 0
for workers in (1, 2):
    found = qmc.discrepancy(points, workers=workers)
    error = float(Fraction(found) / exact - 1)
    worst = max(worst, abs(error))
    print(f"SciPy with workers={workers}       {found:.12e}, relative error {error:+.1e}")
raise SystemExit(worst <= 1e-6)
END
echo "as found"
