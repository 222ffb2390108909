# SPDX-License-Identifier: MIT
"""The engine of boxreel, by the names of the Python module of the Box2D 2.3 generation.

    from Box2D import b2World
    world = b2World(gravity=(0, -10))
    world.CreateStaticBody().CreateEdgeFixture(vertices=[(-20, 0), (20, 0)])
    ball = world.CreateDynamicBody(position=(0, 4))
    ball.CreateCircleFixture(radius=0.5, density=1, restitution=0.5)
    for _ in range(60):
        world.Step(1 / 60, 8, 3)

Units are metres, kilograms, seconds and radians. Box2D.b2 has the same names without their prefix.
"""

import _boxreel
from _boxreel import *  # noqa: F401,F403
from ._definitions import *  # noqa: F401,F403
from ._callbacks import *  # noqa: F401,F403
from ._additions import *  # noqa: F401,F403
from ._collision import *  # noqa: F401,F403
from ._bound import *  # noqa: F401,F403
from ._calls import check_calls as _check_calls

__version__ = "2.3.0"
__version_info__ = (2, 3, 0)
__author__ = "The boxreel authors"
__license__ = "MIT"
__date__ = "2026-11-26"
b2_version = b2Version(*__version_info__)  # noqa: F405

b2LoopShape = b2ChainShape  # noqa: F405
b2DebugDraw = b2Draw  # noqa: F405


class _Globals:
    """The constants of the engine, which cannot be changed, and its counters, which can: b2_gjkCalls and so on."""

    def __init__(self):
        for name, value in vars(_boxreel).items():
            if name.startswith("b2_"):
                self.__dict__[name] = value

        self.__dict__["b2_version"] = b2_version

    def __getattr__(self, name):
        if name not in _boxreel._counters:
            raise AttributeError(f"b2Globals has no attribute '{name}'")
        return _boxreel._counters[name][0]()

    def __setattr__(self, name, value):
        if name in _boxreel._counters:
            _boxreel._counters[name][1](value)
            return
        raise AttributeError(f"{name}: the constants of the engine cannot be changed")


b2Globals = _Globals()


class b2Vec2Array(list):
    """A list of points."""

    def __init__(self, points=()):
        if not hasattr(points, "__iter__"):
            raise TypeError(f"b2Vec2Array: points: expected a list of points, not {_boxreel._kind(points)}")
        super().__init__(points)


def _require_like(function, *values):
    """All are numbers, or all vectors."""
    if not (all(isinstance(one, (int, float)) for one in values)
            or all(isinstance(one, (tuple, list, _boxreel.b2Vec2)) and len(one) == 2 for one in values)):
        kinds = ", ".join(_boxreel._kind(one) for one in values)
        raise TypeError(f"{function}: expected numbers or vectors, not ({kinds})")


def b2Min(a, b):
    """Returns the minimum, of each component for vectors."""
    _require_like("b2Min", a, b)
    return a if isinstance(a, (int, float)) and a < b else b if isinstance(a, (int, float)) else \
        _boxreel.b2Vec2(min(a[0], b[0]), min(a[1], b[1]))


def b2Max(a, b):
    """Returns the maximum, of each component for vectors."""
    _require_like("b2Max", a, b)
    return a if isinstance(a, (int, float)) and a > b else b if isinstance(a, (int, float)) else \
        _boxreel.b2Vec2(max(a[0], b[0]), max(a[1], b[1]))


def b2Clamp(a, low, high):
    """Returns `a` limited to [low, high], of each component for vectors."""
    _require_like("b2Clamp", a, low, high)
    return b2Max(low, b2Min(a, high))


__all__ = [name for name in globals() if name.startswith(("b2", "e_", "RAND_"))]
for _item in [globals()[name] for name in __all__]:
    if getattr(_item, "__module__", None) in ("_boxreel", "Box2D._definitions", "Box2D._callbacks", "Box2D._additions",
                                               "Box2D._collision", "Box2D._bound"):
        try:
            _item.__module__ = "Box2D"
        except (AttributeError, TypeError):
            pass
del _item
_check_calls(globals())

from . import b2, Box2D  # noqa: E402,F401  programs use Box2D.b2 after `import Box2D`
