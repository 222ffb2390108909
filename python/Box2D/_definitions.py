# SPDX-License-Identifier: MIT
"""Definitions of bodies, fixtures and joints. Names and defaults are those of the engine's tables."""

import copy

from _boxreel import _defaults, _hint, _kind, _refuse, b2Body, b2Error, b2Filter, b2Joint, b2Vec2


class _Definition:
    """Has the fields of the engine's definition as attributes; every keyword sets one."""

    _fields = {}
    _extra = ()
    _places = ()  # fields that are also taken without their name

    def __init__(self, *values, **keywords):
        for name, value in self._fields.items():
            self.__dict__[name] = copy.copy(value)
        self._set_all(self._named(values, keywords))

    def _named(self, values, keywords):
        """Returns all arguments by name."""
        places = dict(zip(self._places, values))
        if len(values) > len(self._places) or places.keys() & keywords.keys():
            _refuse(type(self).__name__, list(self._places or self._fields), *values, **keywords)
        return {**places, **keywords}

    @classmethod
    def _names(cls):
        names = set(cls._fields) | set(cls._extra)
        return names | {name for name in dir(cls) if isinstance(getattr(cls, name), property)}

    def _set_all(self, keywords):
        names = self._names()
        for name, value in keywords.items():
            if name not in names:
                raise TypeError(f"{type(self).__name__} has no field '{name}'{_hint(name, sorted(names))}")
            setattr(self, name, value)

    def __setattr__(self, name, value):
        if isinstance(self._fields.get(name), b2Vec2):
            value = b2Vec2(value)
        elif isinstance(value, b2Filter) and type(value) is not b2Filter:
            value = value.copy()  # of a fixture, which may change
        object.__setattr__(self, name, value)

    def _values(self):
        """Returns the fields by name."""
        return {name: self.__dict__[name] for name in self._fields}

    def to_kwargs(self):
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        return {name: copy.copy(value) if isinstance(value, (b2Vec2, b2Filter)) else value
                for name, value in self._values().items()}

    def __repr__(self):
        text = ", ".join(f"{name}={value!r}" for name, value in sorted(self._values().items()))
        return f"{type(self).__name__}({text})"


class b2BodyDef(_Definition):
    """Definition of a body. `fixtures` is a b2FixtureDef or a list, `shapes` a shape or a list; `shapeFixture`
    has the material of the shapes."""

    _fields = {**_defaults["b2BodyDef"], "userData": None, "fixtures": None, "shapes": None, "shapeFixture": None}


def _filter_part(name):
    def get(self):
        return getattr(self.filter, name)

    def put(self, value):
        setattr(self.filter, name, value)

    return property(get, put, doc=f"`{name}` of the filter.")


class b2FixtureDef(_Definition):
    """Definition of a fixture: a shape with friction, restitution, density [kg/m^2] and a collision filter."""

    _fields = {**_defaults["b2FixtureDef"], "filter": b2Filter(), "userData": None}
    _places = ("shape",)

    categoryBits = _filter_part("categoryBits")
    maskBits = _filter_part("maskBits")
    groupIndex = _filter_part("groupIndex")

    @property
    def sensor(self):
        """True if the fixture reports contacts without a collision response."""
        return self.isSensor

    @sensor.setter
    def sensor(self, value):
        self.isSensor = value


def _require_bodies(definition):
    if definition.bodyA is None or definition.bodyB is None:
        raise ValueError(f"{type(definition).__name__}: set bodyA and bodyB before an anchor")


def _world_anchor(letter):
    """Returns a property for the anchor on body A or B in the world."""
    body, local = "body" + letter, "localAnchor" + letter

    def get(self):
        if getattr(self, body) is None:
            raise ValueError(f"{type(self).__name__}: {body} is not set")
        return getattr(self, body).GetWorldPoint(getattr(self, local))

    def put(self, value):
        if getattr(self, body) is None:
            raise ValueError(f"{type(self).__name__}: set {body} before anchor{letter}")
        setattr(self, local, getattr(self, body).GetLocalPoint(value))
        self._given.add(local)

    return property(get, put, doc=f"Anchor on body {letter}, in the world [m].")


class b2JointDef(_Definition):
    """The base of the definitions of joints. The bodies are set before the other keywords."""

    _fields = {"bodyA": None, "bodyB": None, "collideConnected": False, "userData": None}
    _places = ("bodyA", "bodyB")
    type = 0

    def __init__(self, *values, **keywords):
        keywords = self._named(values, keywords)
        self.__dict__["_given"] = set(keywords)
        bodies = {name: keywords.pop(name) for name in ("bodyA", "bodyB") if name in keywords}
        super().__init__(**bodies)
        self._set_all(keywords)
        if self.bodyA is not None and self.bodyB is not None:
            self._complete(self._given)

    def __setattr__(self, name, value):
        if name in ("bodyA", "bodyB") and value is not None and not isinstance(value, b2Body):
            raise TypeError(f"{type(self).__name__}: {name}: expected a b2Body, not {_kind(value)}")
        super().__setattr__(name, value)

    def _complete(self, given):
        """Sets what follows from the bodies and was not given."""

    def _set_bodies(self, bodyA, bodyB):
        for name, body in (("bodyA", bodyA), ("bodyB", bodyB)):
            if body is None:
                raise TypeError(f"{type(self).__name__}.Initialize: {name}: expected a b2Body, not None")
            setattr(self, name, body)


class _Anchors(b2JointDef):
    anchorA = _world_anchor("A")
    anchorB = _world_anchor("B")


class _Anchor(_Anchors):
    @property
    def anchor(self):
        """The point that both anchors are at, in the world [m]."""
        return self.anchorA if self.bodyA is not None else self.anchorB

    @anchor.setter
    def anchor(self, value):
        _require_bodies(self)
        self.anchorA = value
        self.anchorB = value

    def _complete(self, given):
        # As the 2.3 module does, also for anchors in the frames of the bodies.
        if "referenceAngle" in self._fields and "referenceAngle" not in given:
            self.referenceAngle = self.bodyB.angle - self.bodyA.angle

    def Initialize(self, bodyA, bodyB, anchor):
        """Sets the bodies and a common anchor in the world [m]; their angle now is the reference."""
        self._set_bodies(bodyA, bodyB)
        self.anchor = anchor
        self._complete(())


class _Axis(_Anchor):
    @property
    def axis(self):
        """The axis in the world."""
        if self.bodyA is None:
            raise ValueError(f"{type(self).__name__}: bodyA is not set")
        return self.bodyA.GetWorldVector(self.localAxisA)

    @axis.setter
    def axis(self, value):
        if self.bodyA is None:
            raise ValueError(f"{type(self).__name__}: set bodyA before axis")
        self.localAxisA = self.bodyA.GetLocalVector(value)

    def Initialize(self, bodyA, bodyB, anchor, axis):
        """Sets the bodies, a common anchor [m] and the axis, both in the world; their angle now is the reference."""
        super().Initialize(bodyA, bodyB, anchor)
        self.axis = axis


class _Distance(_Anchors):
    def _complete(self, given):
        if {"localAnchorA", "localAnchorB"} <= given and "length" not in given:
            self.length = (self.anchorB - self.anchorA).length

    def Initialize(self, bodyA, bodyB, anchorA, anchorB):
        """Sets the bodies and an anchor on each in the world [m]; their distance now is the length."""
        self._set_bodies(bodyA, bodyB)
        self.anchorA, self.anchorB = anchorA, anchorB
        self._complete({"localAnchorA", "localAnchorB"})


class _Pulley(_Anchors):
    def _complete(self, given):
        for letter in "AB":
            if "length" + letter not in given:
                rope = getattr(self, "anchor" + letter) - getattr(self, "groundAnchor" + letter)
                setattr(self, "length" + letter, rope.length)

    def Initialize(self, bodyA, bodyB, groundAnchorA, groundAnchorB, anchorA, anchorB, ratio):
        """Sets the bodies, the fixed points, an anchor on each body in the world [m], and the ratio."""
        self._set_bodies(bodyA, bodyB)
        self.groundAnchorA, self.groundAnchorB = groundAnchorA, groundAnchorB
        self.anchorA, self.anchorB, self.ratio = anchorA, anchorB, ratio
        self._complete(())


class _Gear(b2JointDef):
    def __init__(self, *values, **keywords):
        keywords = self._named(values, keywords)
        for joint, body in (("joint1", "bodyA"), ("joint2", "bodyB")):
            if keywords.get(joint) is not None and not isinstance(keywords[joint], b2Joint):
                raise TypeError(f"b2GearJointDef: {joint}: expected a b2Joint, not {_kind(keywords[joint])}")
            if keywords.get(joint) is not None and keywords.get(body) is None:
                keywords[body] = keywords[joint].bodyB
        super().__init__(**keywords)


class _Motor(b2JointDef):
    def _complete(self, given):
        if "linearOffset" not in given:
            self.linearOffset = self.bodyA.GetLocalPoint(self.bodyB.position)
        if "angularOffset" not in given:
            self.angularOffset = self.bodyB.angle - self.bodyA.angle

    def Initialize(self, bodyA, bodyB):
        """Sets the bodies; their offsets now are the target."""
        self._set_bodies(bodyA, bodyB)
        self._complete(())


_BASES = {
    "Revolute": (_Anchor, 1, "a hinge"),
    "Prismatic": (_Axis, 2, "a slider"),
    "Distance": (_Distance, 3, "a distance joint; without a length it keeps that of the anchors"),
    "Pulley": (_Pulley, 4, "a pulley; without lengths it keeps those of the anchors"),
    "Mouse": (b2JointDef, 5, "a mouse joint"),
    "Gear": (_Gear, 6, "a gear; without bodies it takes those that its joints move"),
    "Wheel": (_Axis, 7, "a wheel with a suspension"),
    "Weld": (_Anchor, 8, "a weld"),
    "Friction": (_Anchor, 9, "a friction joint"),
    "Rope": (_Anchors, 10, "a rope"),
    "Motor": (_Motor, 11, "a motor joint; without offsets it keeps the current ones"),
}


def _make(kind):
    base, number, doc = _BASES[kind]
    name = f"b2{kind}JointDef"
    return type(name, (base,), {"__doc__": f"Definition of {doc}.", "__module__": "Box2D", "type": number,
                                "_fields": {**_defaults[name], "userData": None}})


JOINT_DEFINITIONS = {f"b2{kind}JointDef": _make(kind) for kind in _BASES}
globals().update(JOINT_DEFINITIONS)

__all__ = ["b2BodyDef", "b2FixtureDef", "b2JointDef", "b2Error", *JOINT_DEFINITIONS]
