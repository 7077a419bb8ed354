# SPDX-License-Identifier: Apache-2.0
"""``python3 -m wellstrat`` says which version this is and what it runs on."""

from . import __version__, _core, stream_version

print(f"wellstrat {__version__}")
print(f"stream version {stream_version}")
print(f"instruction set {_core.batch_target()}")
