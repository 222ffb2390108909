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

import collections as _collections

import _boxreel
from _boxreel import *  # noqa: F401,F403
from ._definitions import *  # noqa: F401,F403
from ._callbacks import *  # noqa: F401,F403
from ._additions import *  # noqa: F401,F403

__version__ = "2.3.0"
__version_info__ = (2, 3, 0)
b2_version = __version_info__

b2LoopShape = b2ChainShape  # noqa: F405
b2DebugDraw = b2Draw  # noqa: F405


class _Globals:
    """The constants of the engine, which cannot be changed."""

    def __init__(self):
        for name, value in vars(_boxreel).items():
            if name.startswith("b2_"):
                self.__dict__[name] = value

    def __setattr__(self, name, value):
        raise AttributeError(f"{name}: the constants of the engine cannot be changed")


b2Globals = _Globals()


class b2Vec2Array(list):
    """A list of points."""


class b2TOIOutput:
    """The states of a search for a time of impact."""

    e_unknown, e_failed, e_overlapped, e_touching, e_separated = _boxreel._toi_states


b2DistanceResult = _collections.namedtuple("b2DistanceResult", "pointA pointB distance iterations")


def b2Distance(*arguments, **keywords):
    """Returns the closest points of two shapes: b2Distance(shapeA=, idxA=0, shapeB=, idxB=0, transformA=,
    transformB=, useRadii=True). Given two points, returns their distance [m]."""
    if len(arguments) == 2 and not keywords:
        return _boxreel._point_distance(*arguments)
    return _shape_distance(*arguments, **keywords)


def _shape_distance(shapeA, idxA=0, shapeB=None, idxB=0, transformA=None, transformB=None, useRadii=True):
    identity = _boxreel.b2Transform()
    return b2DistanceResult(*_boxreel._distance(
        shapeA, idxA, shapeB, idxB, identity if transformA is None else transformA,
        identity if transformB is None else transformB, useRadii))


def b2TimeOfImpact(shapeA=None, idxA=0, shapeB=None, idxB=0, sweepA=None, sweepB=None, tMax=1.0):
    """Returns (state, t) of two moving shapes. The states are those of b2TOIOutput."""
    return _boxreel._time_of_impact(shapeA, idxA, shapeB, idxB, sweepA, sweepB, tMax)


def b2Min(a, b):
    """Returns the minimum, of each component for vectors."""
    return a if isinstance(a, (int, float)) and a < b else b if isinstance(a, (int, float)) else \
        _boxreel.b2Vec2(min(a[0], b[0]), min(a[1], b[1]))


def b2Max(a, b):
    """Returns the maximum, of each component for vectors."""
    return a if isinstance(a, (int, float)) and a > b else b if isinstance(a, (int, float)) else \
        _boxreel.b2Vec2(max(a[0], b[0]), max(a[1], b[1]))


def b2Clamp(a, low, high):
    """Returns `a` limited to [low, high], of each component for vectors."""
    return b2Max(low, b2Min(a, high))


__all__ = [name for name in globals() if name.startswith(("b2", "e_"))]
for _item in [globals()[name] for name in __all__]:
    if getattr(_item, "__module__", None) in ("_boxreel", "Box2D._definitions", "Box2D._callbacks", "Box2D._additions"):
        try:
            _item.__module__ = "Box2D"
        except (AttributeError, TypeError):
            pass
del _item
