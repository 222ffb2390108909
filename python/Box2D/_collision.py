# SPDX-License-Identifier: MIT
"""Inputs and outputs of distances and times of impact, and small classes and functions beside the engine."""

import collections
import random

import _boxreel
from _boxreel import b2Body, b2Fixture, b2Joint, b2Shape, b2Sweep, b2Transform, b2Vec2

from ._calls import checked


class _Record:
    """Has fields with defaults as attributes; every keyword sets one."""

    _defaults = {}

    def __init__(self, **keywords):
        for name, default in self._defaults.items():
            setattr(self, name, default() if callable(default) else default)
        for name, value in keywords.items():
            if name not in self._defaults:
                raise TypeError(f"{type(self).__name__} has no field '{name}'{_boxreel._hint(name, list(self._defaults))}")
            setattr(self, name, value)

    def __repr__(self):
        text = ", ".join(f"{name}={getattr(self, name)!r}" for name in self._defaults)
        return f"{type(self).__name__}({text})"


class b2DistanceProxy:
    """A child of a shape, for distances and times of impact."""

    def __init__(self, shape=None, index=0):
        self.shape, self.index = None, 0
        if shape is not None:
            self.Set(shape, index)

    def Set(self, shape, index=0):
        """Sets the shape and its child."""
        if not isinstance(shape, b2Shape):
            raise TypeError(f"b2DistanceProxy: shape: expected a shape, not {_boxreel._kind(shape)}")
        self.shape, self.index = shape, index

    @property
    def vertices(self):
        """The vertices of the child [m]."""
        if self.shape is None:
            return []
        child = self.shape.getChildEdge(self.index) if isinstance(self.shape, _boxreel.b2ChainShape) else self.shape
        return child.vertices

    @property
    def radius(self):
        """Radius of a circle, or of the skin of another shape [m]."""
        return 0.0 if self.shape is None else self.shape.radius

    def GetVertexCount(self):
        """Returns the number of vertices."""
        return len(self.vertices)

    def GetVertex(self, index):
        """Returns a vertex [m]."""
        if not isinstance(index, int) or not 0 <= index < len(self.vertices):
            raise IndexError(f"index: the proxy has {len(self.vertices)} vertices, not one of {index!r}")
        return b2Vec2(self.vertices[index])

    def GetSupport(self, d):
        """Returns the index of the vertex that is farthest in a direction."""
        direction = b2Vec2(d)
        reach = [direction.dot(vertex) for vertex in self.vertices]
        return reach.index(max(reach))

    def GetSupportVertex(self, d):
        """Returns the vertex that is farthest in a direction [m]."""
        return self.GetVertex(self.GetSupport(d))


class b2DistanceInput(_Record):
    """Two children of shapes with their transforms, for b2Distance."""

    _defaults = {"proxyA": b2DistanceProxy, "proxyB": b2DistanceProxy, "transformA": b2Transform,
                 "transformB": b2Transform, "useRadii": True}


class b2DistanceOutput(_Record):
    """The closest points of two shapes [m]."""

    _defaults = {"pointA": b2Vec2, "pointB": b2Vec2, "distance": 0.0, "iterations": 0}


class b2TOIInput(_Record):
    """Two children of shapes with their motions, for b2TimeOfImpact."""

    _defaults = {"proxyA": b2DistanceProxy, "proxyB": b2DistanceProxy, "sweepA": b2Sweep, "sweepB": b2Sweep, "tMax": 1.0}


class b2TOIOutput(_Record):
    """The state and time of a search for a time of impact."""

    e_unknown, e_failed, e_overlapped, e_touching, e_separated = _boxreel._toi_states
    _defaults = {"state": _boxreel._toi_states[0], "t": 0.0}


class b2ContactPoint(_Record):
    """A contact point, as programs keep it from a callback."""

    _defaults = {"fixtureA": None, "fixtureB": None, "normal": b2Vec2, "position": b2Vec2, "state": 0}


class b2ClipVertex(_Record):
    """A vertex of a clipped edge [m], and the features that made it."""

    _defaults = {"v": b2Vec2, "id": None}


def b2ClipSegmentToLine(vIn, normal, offset, vertexIndexA=0):
    """Clips a segment, two b2ClipVertex or points, to dot(normal, p) <= offset [m]. Returns its ends as b2ClipVertex: two,
    or none if it is outside."""
    ends = tuple(vIn) if isinstance(vIn, (tuple, list)) else ()
    if len(ends) != 2:
        raise TypeError("b2ClipSegmentToLine: vIn: expected two b2ClipVertex or points")
    points = [getattr(end, "v", end) for end in ends]
    ids = [getattr(end, "id", None) for end in ends]
    return [b2ClipVertex(v=v, id=id) for v, id in _boxreel._clip(points, ids, normal, offset, vertexIndexA)]


b2Version = collections.namedtuple("b2Version", "major minor revision", defaults=(2, 3, 0))
b2Version.__str__ = lambda self: ".".join(map(str, self))
b2Version.__doc__ = "A version of the interface."
b2DistanceResult = collections.namedtuple("b2DistanceResult", "pointA pointB distance iterations")


def b2Distance(*arguments, **keywords):
    """Returns the closest points of two shapes: b2Distance(b2DistanceInput), or b2Distance(shapeA=, idxA=0, shapeB=,
    idxB=0, transformA=, transformB=, useRadii=True). Given two points, returns their distance [m]."""
    if len(arguments) == 1 and not keywords and isinstance(arguments[0], b2DistanceInput):
        of = arguments[0]
        return _shape_distance(of.proxyA.shape, of.proxyA.index, of.proxyB.shape, of.proxyB.index, of.transformA,
                               of.transformB, of.useRadii)
    if len(arguments) == 2 and not keywords:
        return _boxreel._point_distance(*arguments)
    return _shape_distance(*arguments, **keywords)


def _require_shapes(function, **shapes):
    for name, shape in shapes.items():
        if not isinstance(shape, b2Shape):
            raise TypeError(f"{function}: {name}: expected a shape, not {_boxreel._kind(shape)}")


def _shape_distance(shapeA=None, idxA=0, shapeB=None, idxB=0, transformA=None, transformB=None, useRadii=True):
    _require_shapes("b2Distance", shapeA=shapeA, shapeB=shapeB)
    identity = b2Transform()
    return b2DistanceResult(*_boxreel._distance(
        shapeA, idxA, shapeB, idxB, identity if transformA is None else transformA,
        identity if transformB is None else transformB, bool(useRadii)))


_shape_distance = checked(_shape_distance, "b2Distance", False)


def b2TimeOfImpact(shapeA=None, idxA=0, shapeB=None, idxB=0, sweepA=None, sweepB=None, tMax=1.0):
    """Returns (state, t) of two moving shapes, or of a b2TOIInput. The states are those of b2TOIOutput."""
    if isinstance(shapeA, b2TOIInput):
        of = shapeA
        return b2TimeOfImpact(of.proxyA.shape, of.proxyA.index, of.proxyB.shape, of.proxyB.index, of.sweepA, of.sweepB,
                              of.tMax)
    _require_shapes("b2TimeOfImpact", shapeA=shapeA, shapeB=shapeB)
    for name, sweep in (("sweepA", sweepA), ("sweepB", sweepB)):
        if not isinstance(sweep, b2Sweep):
            raise TypeError(f"b2TimeOfImpact: {name}: expected a b2Sweep, not {_boxreel._kind(sweep)}")
    return _boxreel._time_of_impact(shapeA, idxA, shapeB, idxB, sweepA, sweepB, tMax)


def b2CheckPolygon(shape, additional_checks=True):
    """Returns True for a convex polygon with an area, else raises an error that says what it lacks."""
    if not isinstance(shape, _boxreel.b2PolygonShape):
        raise TypeError(f"b2CheckPolygon: shape: expected a b2PolygonShape, not {_boxreel._kind(shape)}")
    if not shape.valid:
        raise _boxreel.b2Error("b2CheckPolygon: shape: the polygon is not convex or has no area")
    return True


def _comparison(kind):
    def compare(a, b):
        for item in (a, b):
            if not isinstance(item, kind):
                raise TypeError(f"expected two of {kind.__name__}, not {_boxreel._kind(item)}")
        return a is b

    compare.__name__ = compare.__qualname__ = f"{kind.__name__}Compare"
    compare.__doc__ = f"True if both are the same {kind.__name__}."
    return compare


b2BodyCompare, b2FixtureCompare, b2JointCompare, b2ShapeCompare = map(_comparison, (b2Body, b2Fixture, b2Joint, b2Shape))

RAND_LIMIT = 32767


def b2Random(lo=-1.0, hi=1.0):
    """Returns a random number from `lo` to `hi`, by Python's module random: random.seed makes it repeat."""
    for name, value in (("lo", lo), ("hi", hi)):
        if not isinstance(value, (int, float)):
            raise TypeError(f"b2Random: {name}: expected a number, not {_boxreel._kind(value)}")
    return random.uniform(lo, hi)


__all__ = ["b2DistanceProxy", "b2DistanceInput", "b2DistanceOutput", "b2DistanceResult", "b2TOIInput", "b2TOIOutput",
           "b2ContactPoint", "b2ClipVertex", "b2ClipSegmentToLine", "b2Version", "b2Distance", "b2TimeOfImpact", "b2CheckPolygon", "b2BodyCompare",
           "b2FixtureCompare", "b2JointCompare", "b2ShapeCompare", "b2Random", "RAND_LIMIT"]
