# SPDX-License-Identifier: MIT
"""Values that reach their object when a program changes them: `body.linearVelocity.x = 4` and
`fixture.filterData.maskBits = 0`. A velocity is a copy otherwise, and stays as it is when the body accelerates. A filter
shows what the fixture has."""

import weakref

from _boxreel import b2Body, b2Error, b2Filter, b2Fixture, b2Vec2

__all__ = ["b2BodyVelocity", "b2FixtureFilter"]

_velocity = b2Body.linearVelocity
_filter = b2Fixture.filterData


class b2BodyVelocity(b2Vec2):
    """The velocity of a body. What is written reaches the body [m/s]."""

    __slots__ = ("_owner",)

    def __setitem__(self, index, value):
        b2Vec2.__setitem__(self, index, value)
        owner = _body_of(self)
        if owner is not None:
            velocity = _velocity.fget(owner)  # the other component may have changed meanwhile
            velocity[index] = value
            _velocity.fset(owner, velocity)

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


def _body_of(value):
    """The body behind a velocity, or None if it is destroyed or a program made the vector itself."""
    owner = getattr(value, "_owner", None)
    owner = owner() if owner is not None else None
    return owner if owner is not None and owner._exists else None


def _writing(change):
    """Returns the function of b2Vec2 with a write to the body after it."""

    def changed(self, *arguments):
        result = change(self, *arguments)
        owner = _body_of(self)
        if owner is not None:
            _velocity.fset(owner, self)
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
    setattr(b2BodyVelocity, _name, _writing(getattr(b2Vec2, _name)))
for _name in ("tuple", "length"):
    _whole = getattr(b2Vec2, _name)
    setattr(b2BodyVelocity, _name, property(_whole.fget, _writing(_whole.fset), doc=_whole.__doc__))
for _name in _FILTER:
    setattr(b2FixtureFilter, _name, _filter_part(_name))


def _copy(self, memo=None):
    """Returns a copy that does not reach the object."""
    function, values = self.__reduce_ex__(2)
    return function(*values)


for _class in (b2BodyVelocity, b2FixtureFilter):
    _class.copy = _class.__copy__ = _class.__deepcopy__ = _copy


def _get_velocity(self) -> b2BodyVelocity:
    velocity = b2BodyVelocity(_velocity.fget(self))
    velocity._owner = weakref.ref(self)
    return velocity


def _get_filter(self) -> b2FixtureFilter:
    values = _filter.fget(self)
    result = b2FixtureFilter(**{name: getattr(values, name) for name in _FILTER})
    result._owner = weakref.ref(self)
    return result


def _set_filter(self, value):
    _filter.fset(self, value.copy() if isinstance(value, b2FixtureFilter) else value)


b2Body.linearVelocity = property(_get_velocity, _velocity.fset, doc=_velocity.__doc__)
b2Fixture.filterData = property(_get_filter, _set_filter, doc=_filter.__doc__)
