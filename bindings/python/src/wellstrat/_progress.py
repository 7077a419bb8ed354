# SPDX-License-Identifier: Apache-2.0
"""How far a long call has come, told to whoever wants to know."""

from __future__ import annotations

from typing import Any, Callable, Iterator, Union

#: None, True for a bar of tqdm's, or a function of (done, total).
Progress = Union[None, bool, Callable[[int, int], Any]]


def steps(total: int, size: int, progress: Progress) -> Iterator[tuple[int, int]]:
    """Consecutive parts (begin, end) of range(total), of `size` or less; each is done when the next
    one is asked for."""
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError as error:
            raise ImportError("progress=True needs tqdm: install python3-tqdm of Debian, or tqdm by "
                              "pip, or give a function of (done, total)") from error
        with tqdm(total=total) as bar:
            for begin in range(0, total, size):
                yield begin, min(begin + size, total)
                bar.update(min(size, total - begin))
        return
    if progress and not callable(progress):
        raise TypeError(f"progress must be None, True or a function of (done, total), not "
                        f"{progress!r}")
    for begin in range(0, total, size):
        end = min(begin + size, total)
        yield begin, end
        if progress:
            progress(end, total)
