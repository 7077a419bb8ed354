# SPDX-License-Identifier: Apache-2.0
"""Well-stratified samples for renderers and integration, the same bits as in C++.

`samples` draws from one pattern, `draw` from any contexts; `camera_contexts` and `blue_contexts` are
where contexts of pictures begin. `wellstrat.warp` maps samples to shapes and directions,
`wellstrat.qmc` has engines for SciPy. Submodules load at first use.

All functions are safe in several threads at once, and let other threads run while they compute.
"""

from __future__ import annotations

from ._core import stream_version, version as __version__
from ._arguments import context_dtype
from ._contexts import (blue_contexts, camera_contexts, contexts, joint_scramble, new_domain,
                        new_domain_distrib, new_domain_split)
from ._samples import draw, samples

__all__ = [
    "__version__", "blue_contexts", "camera_contexts", "context_dtype", "contexts", "draw",
    "joint_scramble", "new_domain", "new_domain_distrib", "new_domain_split", "samples",
    "stream_version",
]
