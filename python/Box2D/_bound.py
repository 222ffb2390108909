# SPDX-License-Identifier: MIT
"""Values that reach their object when a program changes them: `body.linearVelocity.x = 4`, `world.gravity.y = -5` and
`fixture.filterData.maskBits = 0`. A vector is a copy otherwise: a velocity stays as it is when the body accelerates. A
filter shows what the fixture has."""

import weakref

import _boxreel
from _boxreel import b2Error, b2Filter, b2Fixture, b2Shape, b2Vec2

__all__ = ["b2BoundVec2", "b2FixtureFilter"]

_filter = b2Fixture.filterData

# Not body.position: programs compute with it in place, which moves no body in pybox2d either.
_VECTORS = {
    "b2Body": ("linearVelocity", "localCenter"),
    "b2World": ("gravity",),
    "b2MouseJoint": ("target",),
    "b2MotorJoint": ("linearOffset",),
    "b2CircleShape": ("pos",),
    "b2EdgeShape": ("vertex0", "vertex1", "vertex2", "vertex3"),
    "b2ChainShape": ("prevVertex", "nextVertex"),
}


class b2BoundVec2(b2Vec2):
    """A vector of an object, such as the velocity of a body. What is written reaches the object."""

    __slots__ = ("_owner", "_property")

    def __setitem__(self, index, value):
        b2Vec2.__setitem__(self, index, value)
        owner = _owner_of(self)
        if owner is not None:
            vector = self._property.fget(owner)  # the other component may have changed meanwhile
            vector[index] = value
            self._property.fset(owner, vector)

    def __reduce_ex__(self, protocol):
        return b2Vec2, tuple(self)

    x = property(b2Vec2.x.fget, lambda self, value: self.__setitem__(0, value), doc=b2Vec2.x.__doc__)
    y = property(b2Vec2.y.fget, lambda self, value: self.__setitem__(1, value), doc=b2Vec2.y.__doc__)


class b2FixtureFilter(b2Filter):
    """The filter of a fixture. What is written reaches the fixture."""

    __slots__ = ("_owner",)

    def __reduce_ex__(self, protocol):
        return _filter_of, tuple(getattr(self, name) for name in _FILTER)


_FILTER = ("categoryBits", "maskBits", "groupIndex")


def _filter_of(*values):
    return b2Filter(**dict(zip(_FILTER, values)))


def _owner_of(value):
    """The object behind a vector, or None if it is destroyed or a program made the vector itself."""
    owner = getattr(value, "_owner", None)
    owner = owner() if owner is not None else None
    return owner if getattr(owner, "_exists", owner is not None) else None


def _writing(change):
    """Returns the function of b2Vec2 with a write to the object after it."""

    def changed(self, *arguments):
        result = change(self, *arguments)
        owner = _owner_of(self)
        if owner is not None:
            self._property.fset(owner, self)
        return result

    changed.__doc__ = change.__doc__
    return changed


def _fixture_of(value):
    """The fixture behind a filter, or None for a filter that a program made itself."""
    owner = getattr(value, "_owner", None)
    fixture = owner() if owner is not None else None
    if owner is not None and fixture is None:
        raise b2Error("this fixture was destroyed, or its world was; it cannot be used")
    return fixture


def _filter_part(name):
    part = getattr(b2Filter, name)

    def read(self):
        fixture = _fixture_of(self)
        return part.fget(self) if fixture is None else getattr(fixture, name)

    def write(self, value):
        fixture = _fixture_of(self)
        part.fset(self, value)
        if fixture is not None:
            setattr(fixture, name, value)

    return property(read, write, doc=part.__doc__)


for _name in ("__iadd__", "__isub__", "__imul__", "__itruediv__", "Normalize", "Set", "SetZero"):
    setattr(b2BoundVec2, _name, _writing(getattr(b2Vec2, _name)))
for _name in ("tuple", "length"):
    _whole = getattr(b2Vec2, _name)
    setattr(b2BoundVec2, _name, property(_whole.fget, _writing(_whole.fset), doc=_whole.__doc__))
for _name in _FILTER:
    setattr(b2FixtureFilter, _name, _filter_part(_name))


def _copy(self, memo=None):
    """Returns a copy that does not reach the object."""
    function, values = self.__reduce_ex__(2)
    return function(*values)


for _class in (b2BoundVec2, b2FixtureFilter):
    _class.copy = _class.__copy__ = _class.__deepcopy__ = _copy


def _bound(whole, keeps_owner):
    """Returns the property with vectors that write to it. A shape is kept, because a program may hold only its vector."""
    read = whole.fget

    def get(self) -> b2BoundVec2:
        vector = b2BoundVec2(read(self))
        vector._owner = (lambda: self) if keeps_owner else weakref.ref(self)
        vector._property = whole
        return vector

    return property(get, whole.fset, doc=whole.__doc__)


for _name, _vectors in _VECTORS.items():
    _class = getattr(_boxreel, _name)
    for _vector in _vectors:
        setattr(_class, _vector, _bound(getattr(_class, _vector), issubclass(_class, b2Shape)))


def _get_filter(self) -> b2FixtureFilter:
    values = _filter.fget(self)
    result = b2FixtureFilter(**{name: getattr(values, name) for name in _FILTER})
    result._owner = weakref.ref(self)
    return result


def _set_filter(self, value):
    _filter.fset(self, value.copy() if isinstance(value, b2FixtureFilter) else value)


b2Fixture.filterData = property(_get_filter, _set_filter, doc=_filter.__doc__)
