# SPDX-License-Identifier: MIT
"""The names of the package, for programs that import the inner module of the 2.3 generation."""

import Box2D as _package
from Box2D import *  # noqa: F401,F403

__version__ = _package.__version__
__version_info__ = _package.__version_info__
__all__ = _package.__all__
