#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# LowDiscrepancySequence.computeStarDiscrepancy of OpenTURNS 1.20 (Debian 12: 1.20-9) is a lower bound: it
# looks at boxes from the origin to one of the points, where the star discrepancy is that of all boxes from
# the origin. The worst ones have each coordinate from another point. Of the two points (0.25, 0.75) and
# (0.75, 0.25) the box [0, 0.75) x [0, 0.75) holds none, and its area is 0.5625.
#
# Needs what python3-openturns depends on. Its documentation says "the star discrepancy", without a bound.
#
# Expected: 0.5625.
# Found: less.
# Versions: python3-openturns 1.20-9. Source: Debian 12. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch python3-openturns=1.20-9 libopenturns0.21=1.20-9
export PYTHONPATH=$folder/usr/lib/python3/dist-packages
/usr/bin/python3 -c 'import openturns' &> log || untried "$(tail -n 1 log)"
/usr/bin/python3 - << 'END' || changed "as printed above"
import openturns

points = [[0.25, 0.75], [0.75, 0.25]]
found = openturns.LowDiscrepancySequence().computeStarDiscrepancy(openturns.Sample(points))
# The supremum is that of boxes, open or closed, whose sides are coordinates of points or 1.
sides = sorted({x for point in points for x in point} | {1.0})
exact = max(max(a * b - sum(x < a and y < b for x, y in points) / 2,
                sum(x <= a and y <= b for x, y in points) / 2 - a * b)
            for a in sides for b in sides)
print(f"OpenTURNS {openturns.__version__}: {found}, exact: {exact}")
raise SystemExit(not (exact == 0.5625 and found < exact))
END
echo "as found"
