# SPDX-License-Identifier: MIT
"""Functions of worlds, bodies and fixtures that are written in Python, and the names of the C++ interface."""

import copy
import copyreg

import _boxreel
from _boxreel import (b2Body, b2ChainShape, b2CircleShape, b2Contact, b2EdgeShape, b2Fixture, b2Joint,
                      b2PolygonShape, b2RayCastInput, b2Shape, b2World)

from ._definitions import JOINT_DEFINITIONS, b2BodyDef, b2FixtureDef, b2JointDef


class _Edge:
    """A joint or contact in the list of a body, and the other body. Other attributes are those of the former."""

    def __init__(self, other, item):
        self.other = other
        self._item = item

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._item, name)

    def __eq__(self, other):
        return self._item == (other._item if isinstance(other, _Edge) else other)

    def __hash__(self):
        return hash(self._item)

    def __repr__(self):
        return f"{type(self).__name__}(other={self.other!r}, {self._item!r})"


class b2JointEdge(_Edge):
    """A joint of a body, and the other body."""

    @property
    def joint(self):
        """The joint."""
        return self._item


class b2ContactEdge(_Edge):
    """A contact of a body, and the other body."""

    @property
    def contact(self):
        """The contact."""
        return self._item


def _as_list(value):
    return list(value) if isinstance(value, (list, tuple)) else [value]


# ---- Bodies

def _create_fixture(self, defn=None, density=None, **keywords) -> b2Fixture:
    """Attaches a fixture, by a b2FixtureDef, by a shape and a density [kg/m^2], or by keywords. Returns it."""
    if isinstance(defn, b2Shape):
        keywords["shape"] = defn
    elif defn is not None and not isinstance(defn, b2FixtureDef):
        raise TypeError(f"expected a b2FixtureDef or a shape, not {_boxreel._kind(defn)}")
    if density is not None:
        keywords["density"] = density
    if isinstance(defn, b2FixtureDef) and not keywords:
        values = defn._values()
    else:
        values = b2FixtureDef(**keywords)._values()
        if isinstance(defn, b2FixtureDef):
            values = {**defn._values(), **{name: values[name] for name in keywords if name in values}}
    if values["shape"] is None:
        raise _boxreel.b2Error("a fixture needs a shape: set `shape`")
    return self._create_fixture(values)


def _shape_fixture(shape_class, *names):
    known = {*names, *b2FixtureDef._names()}

    def create(self, **keywords):
        shape = keywords.pop("shape", None)
        for name in keywords:
            if name not in known:
                raise TypeError(f"fixture of a {shape_class.__name__}: there is no keyword '{name}'"
                                f"{_boxreel._hint(name, list(known))}")
        if shape is None or any(name in keywords for name in names):
            shape = shape_class(**{name: keywords.pop(name) for name in names if name in keywords})
        return _create_fixture(self, shape=shape, **keywords)

    create.__annotations__ = {"return": b2Fixture}
    create.__doc__ = f"Attaches a {shape_class.__name__}: {', '.join(names)}, and the fields of b2FixtureDef."
    return create


def _create_chain_fixture(self, **keywords) -> b2Fixture:
    """Attaches an open chain: vertices, and the fields of b2FixtureDef."""
    if "vertices" in keywords:
        keywords["vertices_chain"] = keywords.pop("vertices")
    return _shape_fixture(b2ChainShape, "vertices_chain", "vertices_loop", "radius")(self, **keywords)


def _create_edge_chain(self, edge_list):
    """Attaches an edge between each point and the next [m]. Returns the fixtures."""
    if not hasattr(edge_list, "__iter__"):
        raise TypeError(f"edge_list: expected a list of points, not {_boxreel._kind(edge_list)}")
    points = [tuple(point) for point in edge_list]
    if len(points) < 2:
        raise ValueError(f"edge_list: expected at least 2 points, got {len(points)}")
    return [_create_fixture(self, shape=b2EdgeShape(vertices=[a, b])) for a, b in zip(points, points[1:])]


def _create_fixtures_from_shapes(self, shapes=None, shapeFixture=None):
    """Attaches one or several shapes with the material of `shapeFixture`. Returns the fixture, or a list."""
    if shapes is None:
        raise TypeError("shapes: expected a shape or a list of shapes, not None")
    if shapeFixture is not None and not isinstance(shapeFixture, b2FixtureDef):
        raise TypeError(f"shapeFixture: expected a b2FixtureDef, not {_boxreel._kind(shapeFixture)}")
    keep = shapeFixture._values() if shapeFixture is not None else b2FixtureDef()._values()
    fixtures = [self._create_fixture({**keep, "shape": shape}) for shape in _as_list(shapes)]
    return fixtures if isinstance(shapes, (list, tuple)) else fixtures[0]


b2Body.CreateFixture = _create_fixture
b2Body.CreatePolygonFixture = _shape_fixture(b2PolygonShape, "box", "vertices", "radius")
b2Body.CreateCircleFixture = _shape_fixture(b2CircleShape, "pos", "radius")
b2Body.CreateEdgeFixture = _shape_fixture(b2EdgeShape, "vertices", "all_vertices", "vertex0", "vertex1", "vertex2",
                                          "vertex3", "radius")
b2Body.CreateLoopFixture = _shape_fixture(b2ChainShape, "vertices", "vertices_loop", "vertices_chain", "radius")
b2Body.CreateChainFixture = _create_chain_fixture
b2Body.CreateEdgeChain = _create_edge_chain
b2Body.CreateFixturesFromShapes = _create_fixtures_from_shapes
b2Body.joints = property(lambda self: [b2JointEdge(*edge) for edge in self._joint_edges],
                         doc="The joints, as a list of b2JointEdge.")
b2Body.contacts = property(lambda self: [b2ContactEdge(*edge) for edge in self._contact_edges],
                           doc="The contacts, as a list of b2ContactEdge.")


def _ray_cast(self, *arguments, **keywords):
    """Casts a ray at the fixture: RayCast(input, childIndex=0) or RayCast(output, input, childIndex). Returns
    (hit, b2RayCastOutput)."""
    arguments = list(arguments)
    output = keywords.pop("output", None)
    if arguments and isinstance(arguments[0], _boxreel.b2RayCastOutput):
        output = arguments.pop(0)
    ray = arguments.pop(0) if arguments else keywords.pop("input", None)
    if ray is None:
        missing = [name for name in ("p1", "p2") if name not in keywords]
        if missing:
            raise TypeError(f"b2Fixture.RayCast: expected an input, or p1 and p2; {missing[0]} is missing")
        ray = b2RayCastInput(p1=keywords.pop("p1"), p2=keywords.pop("p2"), maxFraction=keywords.pop("maxFraction", 1.0))
    child = arguments.pop(0) if arguments else keywords.pop("childIndex", 0)
    if not isinstance(ray, b2RayCastInput):
        raise TypeError(f"b2Fixture.RayCast: input: expected a b2RayCastInput, not {_boxreel._kind(ray)}")
    hit, found = self._ray_cast(ray, child)
    if output is not None:
        if hit:
            output.normal, output.fraction = found.normal, found.fraction
        return hit
    return hit, found


b2Fixture.RayCast = _ray_cast


def _generator_of(name):
    return property(lambda self: (item for item in getattr(self, name)), doc=f"A generator of {name}.")


for _name in ("joints", "contacts", "fixtures"):
    setattr(b2Body, _name + "_gen", _generator_of(_name))
for _name in ("bodies", "joints", "contacts"):
    setattr(b2World, _name + "_gen", _generator_of(_name))

# ---- Worlds

_init_world = b2World.__init__


def _world_init(self, gravity=(0, -10), doSleep=True, **keywords):
    """Creates an empty world. Gravity [m/s^2]; every other keyword is a property."""
    _init_world(self, gravity, bool(doSleep))
    for name, value in keywords.items():
        if not hasattr(type(self), name):
            raise TypeError(f"b2World has no property '{name}'{_boxreel._hint(name, dir(type(self)))}")
        setattr(self, name, value)


def _create_body(self, defn=None, **keywords) -> b2Body:
    """Creates a body from a b2BodyDef or from keywords: its fields, fixtures, shapes, shapeFixture, and mass data."""
    mass = {name: keywords.pop(name) for name in ("massData", "localCenter", "inertia", "mass") if name in keywords}
    if defn is None:
        defn = b2BodyDef(**keywords)
    elif not isinstance(defn, b2BodyDef):
        raise TypeError(f"expected a b2BodyDef, not {_boxreel._kind(defn)}")
    elif keywords:
        raise TypeError("expected a b2BodyDef or keywords, not both")
    body = self._create_body(defn._values())
    try:
        for fixture in [] if defn.fixtures is None else _as_list(defn.fixtures):
            _create_fixture(body, fixture)
        if defn.shapes is not None:
            _create_fixtures_from_shapes(body, defn.shapes, defn.shapeFixture)
        for name, value in mass.items():
            setattr(body, name, value)
    except Exception:
        self.DestroyBody(body)  # all or nothing
        raise
    return body


def _create_typed_body(number, word):
    def create(self, defn=None, **keywords) -> b2Body:
        if not isinstance(defn, b2BodyDef):
            return _create_body(self, defn, type=number, **keywords)
        defn = copy.copy(defn)
        defn.type = number
        return _create_body(self, defn, **keywords)

    create.__doc__ = f"Creates a {word} body from a b2BodyDef or from keywords; see CreateBody."
    return create


def _create_joint(self, defn=None, type=None, **keywords) -> b2Joint:
    """Creates a joint from a definition, or from its class `type` and keywords."""
    if defn is None:
        if type is None:
            raise TypeError("expected a definition of a joint, or type=b2RevoluteJointDef and keywords")
        if not hasattr(type, "__name__"):
            raise TypeError(f"type: expected a class of joint definitions, not {type!r}")
        named = JOINT_DEFINITIONS.get(type.__name__ if type.__name__.endswith("Def") else type.__name__ + "Def")
        if named is None:
            raise TypeError(f"type: expected a class of joint definitions, not {type.__name__}")
        defn = named(**keywords)
    elif not isinstance(defn, b2JointDef):
        raise TypeError(f"expected a definition of a joint, not {_boxreel._kind(defn)}")
    name = next((c.__name__ for c in defn.__class__.__mro__ if c.__name__ in JOINT_DEFINITIONS), None)
    if name is None:
        raise TypeError("b2JointDef is only the base of definitions; use one such as b2RevoluteJointDef")
    for body in (defn.bodyA, defn.bodyB):
        if body is not None and body.world is not self:
            raise _boxreel.b2Error(f"{name}: a body belongs to another world")
    return self._create_joint(name, defn._values())


def _create_named_joint(name, definition):
    def create(self, bodyA=None, bodyB=None, **keywords):
        if isinstance(bodyA, definition) and bodyB is None and not keywords:
            return _create_joint(self, bodyA)
        for key, body in (("bodyA", bodyA), ("bodyB", bodyB)):
            if body is not None:
                keywords[key] = body
        return _create_joint(self, definition(**keywords))

    create.__annotations__ = {"return": getattr(_boxreel, name[:-3])}
    create.__doc__ = f"Creates a joint from the keywords of {name}."
    return create


b2World.__init__ = _world_init
b2World.CreateBody = _create_body
b2World.CreateStaticBody = _create_typed_body(_boxreel.b2_staticBody, "static")
b2World.CreateKinematicBody = _create_typed_body(_boxreel.b2_kinematicBody, "kinematic")
b2World.CreateDynamicBody = _create_typed_body(_boxreel.b2_dynamicBody, "dynamic")
b2World.CreateJoint = _create_joint
for _name, _class in JOINT_DEFINITIONS.items():
    setattr(b2World, "Create" + _name[2:-3], _create_named_joint(_name, _class))


class b2BroadPhase:
    """Numbers of the broad phase of a world."""

    def __init__(self, world):
        self._world = world

    @property
    def proxyCount(self):
        """Number of boxes."""
        return self._world.proxyCount

    @property
    def treeHeight(self):
        """Height of the highest tree."""
        return self._world.treeHeight

    @property
    def treeBalance(self):
        """Maximum balance of the trees."""
        return self._world.treeBalance

    @property
    def treeQuality(self):
        """Ratio of the areas of the trees."""
        return self._world.treeQuality


class b2ContactManager:
    """A summary of the contacts of a world."""

    def __init__(self, world):
        self._world = world

    @property
    def contactList(self):
        """The contacts."""
        return self._world.contacts

    @property
    def contactCount(self):
        """Number of contacts."""
        return self._world.contactCount

    @property
    def broadPhase(self):
        """Numbers of the broad phase."""
        return b2BroadPhase(self._world)

    @property
    def contactListener(self):
        """The contact listener."""
        return self._world.contactListener

    @property
    def contactFilter(self):
        """The contact filter."""
        return self._world.contactFilter


b2World.contactManager = property(b2ContactManager, doc="A summary of the contacts.")

# ---- Copies and pickles. A world is its snapshot and the attributes of the program.


def _objects(world):
    """Returns all bodies, fixtures and joints of a world, in an order that a snapshot keeps."""
    bodies = world.bodies
    return [*bodies, *(fixture for body in bodies for fixture in body.fixtures), *world.joints]


def _attributes(world):
    callbacks = {name: getattr(world, name) for name in ("contactListener", "contactFilter", "destructionListener")}
    own = [(item.userData, item.__dict__) for item in _objects(world)]
    return {"callbacks": callbacks, "world": world.__dict__, "objects": own, "threadCount": world.threadCount}


def _set_attributes(world, state):
    world.threadCount = state["threadCount"]
    world.__dict__.update(state["world"])
    for item, (user_data, attributes) in zip(_objects(world), state["objects"]):
        item.userData = user_data
        item.__dict__.update(attributes)
    for name, value in state["callbacks"].items():
        setattr(world, name, value)


def _from_snapshot(cls, snapshot):
    world = cls.__new__(cls)
    _init_world(world, (0, 0), True)
    world._restore(snapshot)
    return world


def _deepcopy_world(self, memo):
    result = _from_snapshot(type(self), self._save())
    memo[id(self)] = result
    for item, twin in zip(_objects(self), _objects(result)):
        memo[id(item)] = twin
    _set_attributes(result, copy.deepcopy(_attributes(self), memo))
    result.renderer = self.renderer
    return result


def _copy_world(self):
    return copy.deepcopy(self)


def _with_world(item, world):
    """The item of a world that lives as long as it: a program may copy a body alone."""
    item.__dict__["_copied_world"] = world
    return item


def _deepcopy_item(self, memo):
    world = copy.deepcopy(self.world if not isinstance(self, b2Fixture) else self.body.world, memo)
    return _with_world(memo[id(self)], world)


def _item_of(world, index):
    return _with_world(_objects(world)[index], world)


def _reduce_item(self):
    world = self.world if not isinstance(self, b2Fixture) else self.body.world
    return _item_of, (world, [id(item) for item in _objects(world)].index(id(self)))


b2World.__deepcopy__ = _deepcopy_world
b2World.__copy__ = _copy_world
b2World.__reduce_ex__ = lambda self, protocol: (_from_snapshot, (type(self), self._save()), _attributes(self))
b2World.__setstate__ = _set_attributes
for _class in (b2Body, b2Fixture, b2Joint):
    _class.__deepcopy__ = _deepcopy_item
    _class.__reduce_ex__ = lambda self, protocol: _reduce_item(self)


def _set_polygon(self, vertices):
    """Sets the vertices [m]."""
    self.vertices = vertices


b2PolygonShape.Set = _set_polygon


def _clear_user_data(self):
    """Sets userData to None."""
    self.userData = None


def _equal_shapes(self, other):
    """Equal if of the same class, with the same numbers: a fixture's shape is a copy."""
    if type(other) is not type(self):
        return NotImplemented
    return self.__getstate__() == other.__getstate__()


for _class in (b2Body, b2Fixture, b2Joint):
    _class.ClearUserData = _clear_user_data
for _class in (b2CircleShape, b2EdgeShape, b2PolygonShape, b2ChainShape):
    _class.__eq__ = _equal_shapes
    _class.__hash__ = lambda self: hash((type(self), self.childCount, self.radius))


def _reduce_value(self, protocol):
    # Of every protocol, because what Python does for 0 and 1 aborts in pybind11.
    return copyreg.__newobj__, (type(self),), self.__getstate__()


def _refuse_copies(self, protocol):
    raise TypeError(f"a {type(self).__name__} cannot be copied or pickled; copy the numbers that you need")


for _class in vars(_boxreel).values():
    if isinstance(_class, type) and not issubclass(_class, Exception):
        if "__reduce_ex__" not in vars(_class) and not issubclass(_class, b2Joint):
            _class.__reduce_ex__ = _reduce_value if hasattr(_class, "__setstate__") else _refuse_copies
        _class.__reduce__ = lambda self: self.__reduce_ex__(2)

# ---- Texts


def _describe(*names):
    def describe(self):
        try:
            parts = ", ".join(f"{name}={getattr(self, name)!r}" for name in names)
        except _boxreel.b2Error:
            parts = "destroyed"
        return f"{type(self).__name__}({parts})"

    return describe


b2World.__repr__ = _describe("gravity", "bodyCount", "jointCount", "contactCount")
b2Body.__repr__ = _describe("type", "position", "angle", "linearVelocity", "angularVelocity", "mass", "awake", "active")
b2Fixture.__repr__ = _describe("shape", "density", "friction", "restitution", "sensor")
b2Joint.__repr__ = _describe("anchorA", "anchorB", "collideConnected")
b2Contact.__repr__ = _describe("touching", "enabled", "friction", "restitution")

# ---- The names of the C++ interface, beside the properties

_CPP_NAMES = {
    "angle": "JointAngle", "speed": "JointSpeed", "translation": "JointTranslation",
}


def _add_accessors(cls):
    for name, member in list(vars(cls).items()):
        if not isinstance(member, property) or name.startswith("_"):
            continue
        word = name[0].upper() + name[1:]
        if issubclass(cls, b2Joint):
            word = _CPP_NAMES.get(name, word)
        accessors = {"Get" + word: _getter(member.fget, member.__doc__)}
        if (member.__doc__ or "").startswith("True if") or name in ("enabled", "locked", "awake", "active", "bullet", "valid"):
            accessors["Is" + word] = _getter(member.fget, member.__doc__)
        if member.fset is not None:
            accessors["Set" + word] = _setter(member.fset, member.__doc__)
            if name.endswith("Enabled"):
                accessors["Enable" + word[:-7]] = _setter(member.fset, member.__doc__)
        for accessor, function in accessors.items():
            if not hasattr(cls, accessor):
                setattr(cls, accessor, function)


def _getter(function, doc):
    def get(self):
        return function(self)

    get.__doc__ = doc
    return get


def _setter(function, doc):
    def put(self, value):
        function(self, value)

    put.__doc__ = doc
    return put


for _class in (b2BroadPhase, b2World, b2Body, b2Fixture, b2Contact, b2Joint, *b2Joint.__subclasses__(), _boxreel.b2AABB,
               b2Shape, b2CircleShape, b2EdgeShape, b2PolygonShape, b2ChainShape):
    _add_accessors(_class)


def _vertex(self, index):
    """Returns a vertex [m]."""
    vertices = self.vertices
    if not isinstance(index, int) or not 0 <= index < len(vertices):
        raise IndexError(f"index: the shape has {len(vertices)} vertices, not one of {index!r}")
    return _boxreel.b2Vec2(vertices[index])


def _create_chain(self, vertices):
    """Sets the points of an open chain [m]."""
    self.vertices_chain = vertices


def _create_loop(self, vertices):
    """Sets the points of a closed chain [m]."""
    self.vertices_loop = vertices


def _set_edge(self, v1, v2):
    """Sets both ends [m]."""
    self.vertices = [v1, v2]


def _validate(self):
    """True if the polygon is convex and has an area."""
    return self.valid


b2PolygonShape.GetVertex = _vertex
b2PolygonShape.Validate = _validate
b2ChainShape.CreateChain = _create_chain
b2ChainShape.CreateLoop = _create_loop
b2EdgeShape.Set = _set_edge

__all__ = ["b2BroadPhase", "b2JointEdge", "b2ContactEdge", "b2ContactManager"]
