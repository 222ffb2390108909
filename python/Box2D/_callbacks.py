# SPDX-License-Identifier: MIT
"""Classes that programs derive from. What they do not override is not called."""

import _boxreel


class _Callback:
    def __init__(self, **keywords):
        for name, value in keywords.items():
            setattr(self, name, value)


class b2ContactListener(_Callback):
    """Hears of contacts. The world is locked inside these functions and cannot be changed."""

    def BeginContact(self, contact):
        """Two fixtures begin to touch."""

    def EndContact(self, contact):
        """Two fixtures cease to touch."""

    def PreSolve(self, contact, oldManifold):
        """Called before a contact is solved; set contact.enabled to False to disable it for this step."""

    def PostSolve(self, contact, impulse):
        """Called after a contact was solved, with its impulses [N s]."""


class b2ContactFilter(_Callback):
    """Decides which fixtures collide."""

    def ShouldCollide(self, fixtureA, fixtureB):
        """Returns True if the fixtures may collide. The default compares groups, then categories and masks."""
        for name, fixture in (("fixtureA", fixtureA), ("fixtureB", fixtureB)):
            if not isinstance(fixture, _boxreel.b2Fixture):
                raise TypeError(f"{name}: expected a b2Fixture, not {_boxreel._kind(fixture)}")
        return _boxreel._should_collide(fixtureA, fixtureB)


class b2DestructionListener(_Callback):
    """Hears of joints and fixtures that are destroyed with their body."""

    def SayGoodbye(self, object):
        """Called before a joint or a fixture is destroyed."""


class b2QueryCallback(_Callback):
    """Receives what b2World.QueryAABB finds."""

    def ReportFixture(self, fixture):
        """Returns True to go on, False to end."""
        raise NotImplementedError("derive from b2QueryCallback and define ReportFixture")


class b2RayCastCallback(_Callback):
    """Receives what b2World.RayCast hits."""

    def ReportFixture(self, fixture, point, normal, fraction):
        """Returns -1 to ignore the fixture, 0 to end, fraction to clip the ray, 1 to go on."""
        raise NotImplementedError("derive from b2RayCastCallback and define ReportFixture")


_FLAGS = {"drawShapes": 0x01, "drawJoints": 0x02, "drawAABBs": 0x04, "drawPairs": 0x08, "drawCOMs": 0x10}


def _bits_of(flags):
    if not isinstance(flags, int):
        raise TypeError(f"flags: expected bits, not {_boxreel._kind(flags)}")
    return flags


class b2Draw(_Callback):
    """Draws what b2World.DrawDebugData passes to it. Points are in the world [m]."""

    e_shapeBit = 0x01
    e_jointBit = 0x02
    e_aabbBit = 0x04
    e_pairBit = 0x08
    e_centerOfMassBit = 0x10

    _bits = e_shapeBit | e_jointBit
    _converts = False

    @property
    def flags(self):
        """What is drawn: drawShapes, drawJoints, drawAABBs, drawPairs, drawCOMs; and convertVertices."""
        flags = {name: bool(self._bits & bit) for name, bit in _FLAGS.items()}
        return {**flags, "convertVertices": self._converts}

    @flags.setter
    def flags(self, value):
        if isinstance(value, int):
            self._bits = value
            return
        if not isinstance(value, dict):
            raise TypeError(f"flags: expected bits or a dictionary of names, not {_boxreel._kind(value)}")
        for name in value:
            if name not in _FLAGS and name != "convertVertices":
                raise TypeError(f"flags: there is no flag '{name}'{_boxreel._hint(name, list(_FLAGS))}")
        self._bits = sum(bit for name, bit in _FLAGS.items() if value.get(name, False))
        if "convertVertices" in value:
            self._converts = bool(value["convertVertices"])

    def SetFlags(self, flags):
        """Replaces the bits of what is drawn, or the flags by name."""
        self.flags = flags

    def GetFlags(self):
        """Returns the bits of what is drawn."""
        return self._bits

    def AppendFlags(self, flags):
        """Sets bits."""
        self._bits |= _bits_of(flags)

    def ClearFlags(self, flags):
        """Clears bits."""
        self._bits &= ~_bits_of(flags)

    def StartDraw(self):
        """For programs that begin a picture here; nothing calls it."""

    def EndDraw(self):
        """For programs that end a picture here; nothing calls it."""

    def DrawPolygon(self, vertices, color):
        """Draws a closed outline."""

    def DrawSolidPolygon(self, vertices, color):
        """Draws a filled polygon."""

    def DrawCircle(self, center, radius, color):
        """Draws an outline; radius [m]."""

    def DrawSolidCircle(self, center, radius, axis, color):
        """Draws a filled circle; radius [m]."""

    def DrawSegment(self, p1, p2, color):
        """Draws a line."""

    def DrawTransform(self, xf):
        """Draws a frame."""


class b2DrawExtended(b2Draw):
    """A b2Draw whose points are pixels: zoom [px/m], offset [px], and screenSize [px] for axes that are flipped."""

    _converts = True

    def __init__(self, **keywords):
        self.zoom = 1.0
        self.center = _boxreel.b2Vec2(0, 0)
        self.offset = _boxreel.b2Vec2(0, 0)
        self.screenSize = _boxreel.b2Vec2(0, 0)
        self.flipX = False
        self.flipY = True
        super().__init__(**keywords)

    @property
    def convertVertices(self):
        """True if points are converted to pixels."""
        return self._converts

    @convertVertices.setter
    def convertVertices(self, value):
        self._converts = bool(value)

    def to_screen(self, point):
        """Converts a point of the world [m] to pixels."""
        if not isinstance(point, (tuple, list, _boxreel.b2Vec2)) or len(point) != 2:
            raise TypeError(f"point: expected a b2Vec2 or two numbers, not {_boxreel._kind(point)}")
        x = point[0] * self.zoom - self.offset[0]
        y = point[1] * self.zoom - self.offset[1]
        if self.flipX:
            x = self.screenSize[0] - x
        if self.flipY:
            y = self.screenSize[1] - y
        return int(x), int(y)


__all__ = ["b2ContactListener", "b2ContactFilter", "b2DestructionListener", "b2QueryCallback",
           "b2RayCastCallback", "b2Draw", "b2DrawExtended"]
