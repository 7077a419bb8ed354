# SPDX-License-Identifier: Apache-2.0
"""Well-stratified samples for renderers and integration, the same bits as in C++.

`samples` draws from one pattern, `draw` from any contexts; those of pictures begin at
`camera_contexts` and `blue_contexts`. `wellstrat.warp` maps samples to shapes and directions,
`wellstrat.qmc` has engines for SciPy, `wellstrat.analysis` measures points and generators, and
`wellstrat.plot` shows them. Submodules load at first use.

All functions are safe in several threads at once, and let other threads run while they compute.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from ._interpreter import refuse_subinterpreters

refuse_subinterpreters()

from ._arguments import context_dtype
from ._contexts import (blue_contexts, camera_contexts, contexts, joint_scramble, new_domain,
                        new_domain_distrib, new_domain_split)
from ._core import stream_version, version as __version__
from ._random import Choice, choose_and_remap, hash_to_random
from ._samples import draw, samples

if TYPE_CHECKING:
    from . import analysis, plot, qmc, warp

_SUBMODULES = ("analysis", "plot", "qmc", "warp")

__all__ = [
    "Choice", "__version__", "blue_contexts", "camera_contexts", "choose_and_remap",
    "context_dtype", "contexts", "draw", "hash_to_random", "joint_scramble", "new_domain",
    "new_domain_distrib", "new_domain_split", "samples", "stream_version",
]


def __getattr__(name: str) -> Any:
    """Loads a submodule at its first use, and with it what it needs, such as SciPy."""
    if name in _SUBMODULES:
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_SUBMODULES})
