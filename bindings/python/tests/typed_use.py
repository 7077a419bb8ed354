# SPDX-License-Identifier: Apache-2.0
"""Type checkers know the package from outside; scripts/python-package asks one."""

import numpy as np
import numpy.typing as npt

import wellstrat

xy: npt.NDArray[np.float32] = wellstrat.samples(1, np.int64(4))
drawn: npt.NDArray[np.float64] = wellstrat.draw(wellstrat.contexts(1, [0, 1]), dtype=np.float64)
scramble: int = wellstrat.joint_scramble(0)
version: str = wellstrat.__version__
engine = wellstrat.qmc.OwenSobol(2, seed=1)
quality: int = wellstrat.analysis.t_value(xy, sequence=True)
discrepancies: dict[str, float] = wellstrat.analysis.l2_discrepancies(xy, ["star"])
errors = wellstrat.analysis.study({"own": lambda pattern, count: xy, "pmj": "pmj"}, "disk", 4)
directions: npt.NDArray[np.float32] = wellstrat.warp.square_to_sphere(xy)

wellstrat.samples(1, 4.0)  # type: ignore[arg-type]
wellstrat.draw(xy, slot="0")  # type: ignore[arg-type]
wellstrat.joint_scramble()  # type: ignore[call-arg]
wellstrat.analysis.t_value()  # type: ignore[call-arg]
