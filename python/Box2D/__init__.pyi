# Made by python/stubs.py.
from typing import Any, Generic, Iterator, Sequence, TypeVar

_T = TypeVar("_T")

class _Settable(Generic[_T]):
    def __get__(self, one: Any, owner: Any = ...) -> _T: ...
    def __set__(self, one: Any, value: Any) -> None: ...

__version__: str

class b2BroadPhase:
    """Numbers of the broad phase of a world."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, world: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def proxyCount(self) -> Any:
        """Number of boxes."""
        ...
    @property
    def treeHeight(self) -> Any:
        """Height of the highest tree."""
        ...
    @property
    def treeBalance(self) -> Any:
        """Maximum balance of the trees."""
        ...
    @property
    def treeQuality(self) -> Any:
        """Ratio of the areas of the trees."""
        ...
    def GetProxyCount(self) -> Any:
        """Number of boxes."""
        ...
    def GetTreeHeight(self) -> Any:
        """Height of the highest tree."""
        ...
    def GetTreeBalance(self) -> Any:
        """Maximum balance of the trees."""
        ...
    def GetTreeQuality(self) -> Any:
        """Ratio of the areas of the trees."""
        ...

class b2ContactManager:
    """A summary of the contacts of a world."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, world: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def contactList(self) -> Any:
        """The contacts."""
        ...
    @property
    def contactCount(self) -> Any:
        """Number of contacts."""
        ...
    @property
    def broadPhase(self) -> Any:
        """Numbers of the broad phase."""
        ...
    @property
    def contactListener(self) -> Any:
        """The contact listener."""
        ...
    @property
    def contactFilter(self) -> Any:
        """The contact filter."""
        ...

class b2DistanceProxy:
    """A child of a shape, for distances and times of impact."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, shape: Any = ..., index: Any = ...) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def Set(self, shape: Any, index: Any = ...) -> Any:
        """Sets the shape and its child."""
        ...
    @property
    def vertices(self) -> Any:
        """The vertices of the child [m]."""
        ...
    @property
    def radius(self) -> Any:
        """Radius of a circle, or of the skin of another shape [m]."""
        ...
    def GetVertexCount(self) -> Any:
        """Returns the number of vertices."""
        ...
    def GetVertex(self, index: Any) -> Any:
        """Returns a vertex [m]."""
        ...
    def GetSupport(self, d: Any) -> Any:
        """Returns the index of the vertex that is farthest in a direction."""
        ...
    def GetSupportVertex(self, d: Any) -> Any:
        """Returns the vertex that is farthest in a direction [m]."""
        ...

class Camera:
    """The visible part of the world, in a picture of width x height pixels."""
    def __init__(self, width: Any = ..., height: Any = ..., center: Any = ..., pixelsPerMeter: Any = ...) -> None: ...
    @property
    def width(self) -> int:
        """Width of the picture [px]."""
        ...
    @property
    def height(self) -> int:
        """Height of the picture [px]."""
        ...
    @property
    def center(self) -> tuple:
        """World point in the centre of the picture [m]."""
        ...
    @property
    def pixelsPerMeter(self) -> float:
        """Scale [px/m]."""
        ...
    def to_pixel(self, point: Any) -> tuple:
        """Converts a point of the world [m] to the picture [px, y down]."""
        ...
    def to_world(self, pixel: Any) -> tuple:
        """Converts a point of the picture [px, y down] to the world [m]."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def copy(self) -> Camera:
        """Returns a copy."""
        ...

class b2AABB:
    """An axis-aligned box: lowerBound=, upperBound=."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    lowerBound: _Settable[b2Vec2]
    """Lower left corner [m]."""
    upperBound: _Settable[b2Vec2]
    """Upper right corner [m]."""
    @property
    def valid(self) -> bool:
        """True if the bounds are sorted and finite."""
        ...
    @property
    def center(self) -> b2Vec2:
        """Centre [m]."""
        ...
    @property
    def extents(self) -> b2Vec2:
        """Half the width and half the height [m]."""
        ...
    @property
    def perimeter(self) -> float:
        """Perimeter [m]."""
        ...
    def Contains(self, aabb: b2AABB) -> bool:
        """True if the other box is inside."""
        ...
    def __contains__(self, arg0: Any, /) -> bool: ...
    def overlaps(self, aabb: b2AABB) -> bool:
        """True if the boxes overlap."""
        ...
    def Combine(self, *args: Any, **kwargs: Any) -> Any: ...
    def RayCast(self, *args: Any, **kwargs: Any) -> Any: ...
    def __eq__(self, other: object) -> bool: ...
    def copy(self) -> b2AABB:
        """Returns a copy."""
        ...
    def GetLowerBound(self) -> Any:
        """Lower left corner [m]."""
        ...
    def SetLowerBound(self, value: Any) -> Any:
        """Lower left corner [m]."""
        ...
    def GetUpperBound(self) -> Any:
        """Upper right corner [m]."""
        ...
    def SetUpperBound(self, value: Any) -> Any:
        """Upper right corner [m]."""
        ...
    def GetValid(self) -> Any:
        """True if the bounds are sorted and finite."""
        ...
    def IsValid(self) -> Any:
        """True if the bounds are sorted and finite."""
        ...
    def GetCenter(self) -> Any:
        """Centre [m]."""
        ...
    def GetExtents(self) -> Any:
        """Half the width and half the height [m]."""
        ...
    def GetPerimeter(self) -> Any:
        """Perimeter [m]."""
        ...

class b2Body:
    """A rigid body, made by b2World.CreateBody. It keeps attributes of the program."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def __ne__(self, other: object) -> bool: ...
    @property
    def userData(self) -> Any:
        """Any object of the program."""
        ...
    @userData.setter
    def userData(self, value: Any) -> None: ...
    position: _Settable[b2Vec2]
    """Position of the origin [m]."""
    @property
    def angle(self) -> float:
        """Angle, counter-clockwise [rad]. It grows with every turn."""
        ...
    @angle.setter
    def angle(self, value: float) -> None: ...
    transform: _Settable[b2Transform]
    """Transform from the body to the world. May be set to (position, angle) [m, rad]."""
    def SetTransform(self, position: Any, angle: Any) -> None:
        """Sets position [m] and angle [rad]."""
        ...
    @property
    def worldCenter(self) -> b2Vec2:
        """Centre of mass in the world [m]."""
        ...
    linearVelocity: _Settable[b2BoundVec2]
    """Velocity of the centre of mass [m/s]."""
    @property
    def angularVelocity(self) -> float:
        """Angular velocity, counter-clockwise [rad/s]."""
        ...
    @angularVelocity.setter
    def angularVelocity(self, value: float) -> None: ...
    @property
    def linearDamping(self) -> float:
        """Decay rate of the linear velocity [1/s]."""
        ...
    @linearDamping.setter
    def linearDamping(self, value: float) -> None: ...
    @property
    def angularDamping(self) -> float:
        """Decay rate of the angular velocity [1/s]."""
        ...
    @angularDamping.setter
    def angularDamping(self, value: float) -> None: ...
    @property
    def gravityScale(self) -> float:
        """Factor of the world's gravity."""
        ...
    @gravityScale.setter
    def gravityScale(self, value: float) -> None: ...
    @property
    def type(self) -> int:
        """b2_staticBody, b2_kinematicBody or b2_dynamicBody."""
        ...
    @type.setter
    def type(self, value: int) -> None: ...
    @property
    def bullet(self) -> bool:
        """True for continuous collision against dynamic bodies too."""
        ...
    @bullet.setter
    def bullet(self, value: bool) -> None: ...
    @property
    def sleepingAllowed(self) -> bool:
        """True if it may fall asleep."""
        ...
    @sleepingAllowed.setter
    def sleepingAllowed(self, value: bool) -> None: ...
    @property
    def awake(self) -> bool:
        """True if awake."""
        ...
    @awake.setter
    def awake(self, value: bool) -> None: ...
    @property
    def active(self) -> bool:
        """True if it takes part in collision and dynamics."""
        ...
    @active.setter
    def active(self, value: bool) -> None: ...
    @property
    def fixedRotation(self) -> bool:
        """True if it never rotates."""
        ...
    @fixedRotation.setter
    def fixedRotation(self, value: bool) -> None: ...
    @property
    def mass(self) -> float:
        """Mass [kg]; 0 for static and kinematic bodies."""
        ...
    @mass.setter
    def mass(self, value: float) -> None: ...
    @property
    def inertia(self) -> float:
        """Rotational inertia about the origin [kg m^2]."""
        ...
    @inertia.setter
    def inertia(self, value: float) -> None: ...
    localCenter: _Settable[b2BoundVec2]
    """Centre of mass in the body's frame [m]."""
    massData: _Settable[b2MassData]
    """Mass, centre and rotational inertia."""
    def ResetMassData(self) -> None:
        """Computes the mass data from the fixtures."""
        ...
    def ApplyForce(self, force: Any, point: Any, wake: Any = ...) -> None:
        """Applies a force [N] at a world point [m] in the next step."""
        ...
    def ApplyLinearImpulse(self, impulse: Any, point: Any, wake: Any = ...) -> None:
        """Applies an impulse [N s] at a world point [m]; changes the velocity at once."""
        ...
    def ApplyForceToCenter(self, force: Any, wake: Any = ...) -> None:
        """Applies a force [N] at the centre of mass in the next step."""
        ...
    def ApplyLinearImpulseToCenter(self, impulse: Any, wake: Any = ...) -> None:
        """Applies an impulse [N s] at the centre of mass; changes the velocity at once."""
        ...
    def ApplyTorque(self, torque: Any, wake: Any = ...) -> None:
        """Applies a torque [N m] in the next step."""
        ...
    def ApplyAngularImpulse(self, impulse: Any, wake: Any = ...) -> None:
        """Applies an angular impulse [N m s]; changes the angular velocity at once."""
        ...
    def GetWorldPoint(self, localPoint: Any) -> b2Vec2:
        """Converts a point to the world [m]."""
        ...
    def GetWorldVector(self, localVector: Any) -> b2Vec2:
        """Rotates a vector to the world."""
        ...
    def GetLocalPoint(self, worldPoint: Any) -> b2Vec2:
        """Converts a point to the body's frame [m]."""
        ...
    def GetLocalVector(self, worldVector: Any) -> b2Vec2:
        """Rotates a vector to the body's frame."""
        ...
    def GetLinearVelocityFromWorldPoint(self, worldPoint: Any) -> b2Vec2:
        """Returns the velocity [m/s] of the body at a world point [m]."""
        ...
    def GetLinearVelocityFromLocalPoint(self, localPoint: Any) -> b2Vec2:
        """Returns the velocity [m/s] of a point of the body [m]."""
        ...
    @property
    def fixtures(self) -> list[b2Fixture]:
        """The fixtures, in the order of creation."""
        ...
    @property
    def next(self) -> Any:
        """The body created before this one, or None."""
        ...
    @property
    def number(self) -> int:
        """Number in the order of creation, from 0."""
        ...
    @property
    def world(self) -> Any:
        """The world that the body is in."""
        ...
    def DestroyFixture(self, fixture: b2Fixture) -> None:
        """Destroys a fixture. It cannot be used afterwards."""
        ...
    def Dump(self) -> None:
        """Writes the body as code of C++ to standard output."""
        ...
    def __iter__(self) -> Any: ...
    def __contains__(self, arg0: Any, /) -> bool: ...
    def CreateFixture(self, defn: Any = ..., density: Any = ..., **keywords: Any) -> b2Fixture:
        """Attaches a fixture, by a b2FixtureDef, by a shape and a density [kg/m^2], or by keywords. Returns it."""
        ...
    def CreatePolygonFixture(self, **keywords: Any) -> b2Fixture:
        """Attaches a b2PolygonShape: box, vertices, radius, and the fields of b2FixtureDef."""
        ...
    def CreateCircleFixture(self, **keywords: Any) -> b2Fixture:
        """Attaches a b2CircleShape: pos, radius, and the fields of b2FixtureDef."""
        ...
    def CreateEdgeFixture(self, **keywords: Any) -> b2Fixture:
        """Attaches a b2EdgeShape: vertices, all_vertices, vertex0, vertex1, vertex2, vertex3, radius, and the fields of b2FixtureDef."""
        ...
    def CreateLoopFixture(self, **keywords: Any) -> b2Fixture:
        """Attaches a b2ChainShape: vertices, vertices_loop, vertices_chain, radius, and the fields of b2FixtureDef."""
        ...
    def CreateChainFixture(self, **keywords: Any) -> b2Fixture:
        """Attaches an open chain: vertices, and the fields of b2FixtureDef."""
        ...
    def CreateEdgeChain(self, edge_list: Any) -> Any:
        """Attaches an edge between each point and the next [m]. Returns the fixtures."""
        ...
    def CreateFixturesFromShapes(self, shapes: Any = ..., shapeFixture: Any = ...) -> Any:
        """Attaches one or several shapes with the material of `shapeFixture`. Returns the fixture, or a list."""
        ...
    @property
    def joints(self) -> list[b2JointEdge]:
        """The joints, as a list of b2JointEdge."""
        ...
    @property
    def contacts(self) -> list[b2ContactEdge]:
        """The contacts, as a list of b2ContactEdge."""
        ...
    @property
    def joints_gen(self) -> Any:
        """A generator of joints."""
        ...
    @property
    def contacts_gen(self) -> Any:
        """A generator of contacts."""
        ...
    @property
    def fixtures_gen(self) -> Any:
        """A generator of fixtures."""
        ...
    def ClearUserData(self) -> Any:
        """Sets userData to None."""
        ...
    def GetUserData(self) -> Any:
        """Any object of the program."""
        ...
    def SetUserData(self, value: Any) -> Any:
        """Any object of the program."""
        ...
    def GetPosition(self) -> Any:
        """Position of the origin [m]."""
        ...
    def SetPosition(self, value: Any) -> Any:
        """Position of the origin [m]."""
        ...
    def GetAngle(self) -> Any:
        """Angle, counter-clockwise [rad]. It grows with every turn."""
        ...
    def SetAngle(self, value: Any) -> Any:
        """Angle, counter-clockwise [rad]. It grows with every turn."""
        ...
    def GetTransform(self) -> Any:
        """Transform from the body to the world. May be set to (position, angle) [m, rad]."""
        ...
    def GetWorldCenter(self) -> Any:
        """Centre of mass in the world [m]."""
        ...
    def GetLinearVelocity(self) -> Any:
        """Velocity of the centre of mass [m/s]."""
        ...
    def SetLinearVelocity(self, value: Any) -> Any:
        """Velocity of the centre of mass [m/s]."""
        ...
    def GetAngularVelocity(self) -> Any:
        """Angular velocity, counter-clockwise [rad/s]."""
        ...
    def SetAngularVelocity(self, value: Any) -> Any:
        """Angular velocity, counter-clockwise [rad/s]."""
        ...
    def GetLinearDamping(self) -> Any:
        """Decay rate of the linear velocity [1/s]."""
        ...
    def SetLinearDamping(self, value: Any) -> Any:
        """Decay rate of the linear velocity [1/s]."""
        ...
    def GetAngularDamping(self) -> Any:
        """Decay rate of the angular velocity [1/s]."""
        ...
    def SetAngularDamping(self, value: Any) -> Any:
        """Decay rate of the angular velocity [1/s]."""
        ...
    def GetGravityScale(self) -> Any:
        """Factor of the world's gravity."""
        ...
    def SetGravityScale(self, value: Any) -> Any:
        """Factor of the world's gravity."""
        ...
    def GetType(self) -> Any:
        """b2_staticBody, b2_kinematicBody or b2_dynamicBody."""
        ...
    def SetType(self, value: Any) -> Any:
        """b2_staticBody, b2_kinematicBody or b2_dynamicBody."""
        ...
    def GetBullet(self) -> Any:
        """True for continuous collision against dynamic bodies too."""
        ...
    def IsBullet(self) -> Any:
        """True for continuous collision against dynamic bodies too."""
        ...
    def SetBullet(self, value: Any) -> Any:
        """True for continuous collision against dynamic bodies too."""
        ...
    def GetSleepingAllowed(self) -> Any:
        """True if it may fall asleep."""
        ...
    def IsSleepingAllowed(self) -> Any:
        """True if it may fall asleep."""
        ...
    def SetSleepingAllowed(self, value: Any) -> Any:
        """True if it may fall asleep."""
        ...
    def GetAwake(self) -> Any:
        """True if awake."""
        ...
    def IsAwake(self) -> Any:
        """True if awake."""
        ...
    def SetAwake(self, value: Any) -> Any:
        """True if awake."""
        ...
    def GetActive(self) -> Any:
        """True if it takes part in collision and dynamics."""
        ...
    def IsActive(self) -> Any:
        """True if it takes part in collision and dynamics."""
        ...
    def SetActive(self, value: Any) -> Any:
        """True if it takes part in collision and dynamics."""
        ...
    def GetFixedRotation(self) -> Any:
        """True if it never rotates."""
        ...
    def IsFixedRotation(self) -> Any:
        """True if it never rotates."""
        ...
    def SetFixedRotation(self, value: Any) -> Any:
        """True if it never rotates."""
        ...
    def GetMass(self) -> Any:
        """Mass [kg]; 0 for static and kinematic bodies."""
        ...
    def SetMass(self, value: Any) -> Any:
        """Mass [kg]; 0 for static and kinematic bodies."""
        ...
    def GetInertia(self) -> Any:
        """Rotational inertia about the origin [kg m^2]."""
        ...
    def SetInertia(self, value: Any) -> Any:
        """Rotational inertia about the origin [kg m^2]."""
        ...
    def GetLocalCenter(self) -> Any:
        """Centre of mass in the body's frame [m]."""
        ...
    def SetLocalCenter(self, value: Any) -> Any:
        """Centre of mass in the body's frame [m]."""
        ...
    def GetMassData(self) -> Any:
        """Mass, centre and rotational inertia."""
        ...
    def SetMassData(self, value: Any) -> Any:
        """Mass, centre and rotational inertia."""
        ...
    def GetFixtures(self) -> Any:
        """The fixtures, in the order of creation."""
        ...
    def GetNext(self) -> Any:
        """The body created before this one, or None."""
        ...
    def GetNumber(self) -> Any:
        """Number in the order of creation, from 0."""
        ...
    def GetWorld(self) -> Any:
        """The world that the body is in."""
        ...
    def GetJoints(self) -> Any:
        """The joints, as a list of b2JointEdge."""
        ...
    def GetContacts(self) -> Any:
        """The contacts, as a list of b2ContactEdge."""
        ...
    def GetJoints_gen(self) -> Any:
        """A generator of joints."""
        ...
    def GetContacts_gen(self) -> Any:
        """A generator of contacts."""
        ...
    def GetFixtures_gen(self) -> Any:
        """A generator of fixtures."""
        ...

class b2BodyDef:
    """Definition of a body. `fixtures` is a b2FixtureDef or a list, `shapes` a shape or a list; `shapeFixture` has the material of the shapes."""
    type: int
    position: Any
    angle: float
    linearVelocity: Any
    angularVelocity: float
    linearDamping: float
    angularDamping: float
    allowSleep: bool
    awake: bool
    fixedRotation: bool
    bullet: bool
    active: bool
    gravityScale: float
    userData: Any
    fixtures: Any
    shapes: Any
    shapeFixture: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...

class b2ClipVertex:
    """A vertex of a clipped edge [m], and the features that made it."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...

class b2Color:
    """A colour. Channels run from 0 to 1."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    @property
    def r(self) -> float:
        """Red, 0 to 1."""
        ...
    @r.setter
    def r(self, value: float) -> None: ...
    @property
    def g(self) -> float:
        """Green, 0 to 1."""
        ...
    @g.setter
    def g(self, value: float) -> None: ...
    @property
    def b(self) -> float:
        """Blue, 0 to 1."""
        ...
    @b.setter
    def b(self, value: float) -> None: ...
    @property
    def a(self) -> float:
        """Opacity, 0 to 1."""
        ...
    @a.setter
    def a(self, value: float) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> float: ...
    def __setitem__(self, index: int, value: Any) -> None: ...
    def __iter__(self) -> Any: ...
    def __eq__(self, other: object) -> bool: ...
    def __neg__(self) -> b2Color: ...
    def __pos__(self) -> b2Color: ...
    def __add__(self, arg0: Any, /) -> Any: ...
    def __radd__(self, arg0: Any, /) -> Any: ...
    def __sub__(self, arg0: Any, /) -> Any: ...
    def __rsub__(self, arg0: Any, /) -> Any: ...
    def __mul__(self, arg0: Any, /) -> Any: ...
    def __rmul__(self, arg0: Any, /) -> Any: ...
    def __truediv__(self, arg0: Any, /) -> Any: ...
    def __iadd__(self, arg0: Any, /) -> Any: ...
    def __isub__(self, arg0: Any, /) -> Any: ...
    def __imul__(self, arg0: Any, /) -> Any: ...
    def __itruediv__(self, arg0: Any, /) -> Any: ...
    def copy(self) -> b2Color:
        """Returns a copy."""
        ...
    @property
    def list(self) -> Any:
        """Red, green and blue as a list."""
        ...
    @list.setter
    def list(self, value: Any) -> None: ...
    @property
    def bytes(self) -> Any:
        """Red, green and blue from 0 to 255, as a list."""
        ...
    def Set(self, r: Any, g: Any, b: Any, a: Any = ...) -> None:
        """Sets the channels, 0 to 1."""
        ...

class b2Contact:
    """Two fixtures whose boxes overlap."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def enabled(self) -> bool:
        """False if disabled for this step. Set it in PreSolve."""
        ...
    @enabled.setter
    def enabled(self, value: bool) -> None: ...
    @property
    def friction(self) -> float:
        """Friction, 0 or more."""
        ...
    @friction.setter
    def friction(self, value: float) -> None: ...
    @property
    def restitution(self) -> float:
        """Restitution, 0 or more."""
        ...
    @restitution.setter
    def restitution(self, value: float) -> None: ...
    @property
    def tangentSpeed(self) -> float:
        """Surface speed of a conveyor belt [m/s]."""
        ...
    @tangentSpeed.setter
    def tangentSpeed(self, value: float) -> None: ...
    @property
    def touching(self) -> bool:
        """True if the shapes overlap."""
        ...
    @property
    def childIndexA(self) -> int:
        """Child of the first shape, from 0."""
        ...
    @property
    def childIndexB(self) -> int:
        """Child of the second shape, from 0."""
        ...
    @property
    def worldManifold(self) -> b2WorldManifold:
        """The manifold in the world."""
        ...
    @property
    def fixtureA(self) -> Any:
        """The first fixture."""
        ...
    @property
    def fixtureB(self) -> Any:
        """The second fixture."""
        ...
    @property
    def manifold(self) -> b2Manifold:
        """The manifold in the frames of the bodies."""
        ...
    @property
    def next(self) -> Any:
        """The contact created before this one, or None."""
        ...
    def ResetFriction(self) -> None:
        """Restores the mixed friction."""
        ...
    def ResetRestitution(self) -> None:
        """Restores the mixed restitution."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def GetEnabled(self) -> Any:
        """False if disabled for this step. Set it in PreSolve."""
        ...
    def IsEnabled(self) -> Any:
        """False if disabled for this step. Set it in PreSolve."""
        ...
    def SetEnabled(self, value: Any) -> Any:
        """False if disabled for this step. Set it in PreSolve."""
        ...
    def GetFriction(self) -> Any:
        """Friction, 0 or more."""
        ...
    def SetFriction(self, value: Any) -> Any:
        """Friction, 0 or more."""
        ...
    def GetRestitution(self) -> Any:
        """Restitution, 0 or more."""
        ...
    def SetRestitution(self, value: Any) -> Any:
        """Restitution, 0 or more."""
        ...
    def GetTangentSpeed(self) -> Any:
        """Surface speed of a conveyor belt [m/s]."""
        ...
    def SetTangentSpeed(self, value: Any) -> Any:
        """Surface speed of a conveyor belt [m/s]."""
        ...
    def GetTouching(self) -> Any:
        """True if the shapes overlap."""
        ...
    def IsTouching(self) -> Any:
        """True if the shapes overlap."""
        ...
    def GetChildIndexA(self) -> Any:
        """Child of the first shape, from 0."""
        ...
    def GetChildIndexB(self) -> Any:
        """Child of the second shape, from 0."""
        ...
    def GetWorldManifold(self) -> Any:
        """The manifold in the world."""
        ...
    def GetFixtureA(self) -> Any:
        """The first fixture."""
        ...
    def GetFixtureB(self) -> Any:
        """The second fixture."""
        ...
    def GetManifold(self) -> Any:
        """The manifold in the frames of the bodies."""
        ...
    def GetNext(self) -> Any:
        """The contact created before this one, or None."""
        ...

class b2ContactEdge:
    """A contact of a body, and the other body."""
    def __init__(self, other: Any, item: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def contact(self) -> Any:
        """The contact."""
        ...

class b2ContactFeature:
    """The features that make a contact point."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    e_vertex: int
    e_face: int
    @property
    def indexA(self) -> int:
        """Vertex or face of shape A."""
        ...
    @property
    def indexB(self) -> int:
        """Vertex or face of shape B."""
        ...
    @property
    def typeA(self) -> int:
        """e_vertex or e_face."""
        ...
    @property
    def typeB(self) -> int:
        """e_vertex or e_face."""
        ...
    def copy(self) -> b2ContactFeature:
        """Returns a copy."""
        ...

class b2ContactFilter:
    """Decides which fixtures collide."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def ShouldCollide(self, fixtureA: Any, fixtureB: Any) -> Any:
        """Returns True if the fixtures may collide. The default compares groups, then categories and masks."""
        ...

class b2ContactID:
    """Identifies a contact point from step to step."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def key(self) -> int:
        """The features as one number."""
        ...
    @property
    def cf(self) -> b2ContactFeature:
        """The features."""
        ...
    def copy(self) -> b2ContactID:
        """Returns a copy."""
        ...

class b2ContactImpulse:
    """Impulses of a contact in a step [N s]."""
    def __init__(self) -> None: ...
    @property
    def count(self) -> int:
        """Number of points, 0 to 2."""
        ...
    @property
    def normalImpulses(self) -> tuple:
        """Normal impulses [N s]."""
        ...
    @property
    def tangentImpulses(self) -> tuple:
        """Friction impulses [N s]."""
        ...
    def copy(self) -> b2ContactImpulse:
        """Returns a copy."""
        ...

class b2ContactListener:
    """Hears of contacts. The world is locked inside these functions and cannot be changed."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def BeginContact(self, contact: Any) -> Any:
        """Two fixtures begin to touch."""
        ...
    def EndContact(self, contact: Any) -> Any:
        """Two fixtures cease to touch."""
        ...
    def PreSolve(self, contact: Any, oldManifold: Any) -> Any:
        """Called before a contact is solved; set contact.enabled to False to disable it for this step."""
        ...
    def PostSolve(self, contact: Any, impulse: Any) -> Any:
        """Called after a contact was solved, with its impulses [N s]."""
        ...

class b2ContactPoint:
    """A contact point, as programs keep it from a callback."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...

class b2DebugDraw:
    """Draws what b2World.DrawDebugData passes to it. Points are in the world [m]."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    e_shapeBit: int
    e_jointBit: int
    e_aabbBit: int
    e_pairBit: int
    e_centerOfMassBit: int
    @property
    def flags(self) -> Any:
        """What is drawn: drawShapes, drawJoints, drawAABBs, drawPairs, drawCOMs; and convertVertices."""
        ...
    @flags.setter
    def flags(self, value: Any) -> None: ...
    def SetFlags(self, flags: Any) -> Any:
        """Replaces the bits of what is drawn, or the flags by name."""
        ...
    def GetFlags(self) -> Any:
        """Returns the bits of what is drawn."""
        ...
    def AppendFlags(self, flags: Any) -> Any:
        """Sets bits."""
        ...
    def ClearFlags(self, flags: Any) -> Any:
        """Clears bits."""
        ...
    def StartDraw(self) -> Any:
        """For programs that begin a picture here; nothing calls it."""
        ...
    def EndDraw(self) -> Any:
        """For programs that end a picture here; nothing calls it."""
        ...
    def DrawPolygon(self, vertices: Any, color: Any) -> Any:
        """Draws a closed outline."""
        ...
    def DrawSolidPolygon(self, vertices: Any, color: Any) -> Any:
        """Draws a filled polygon."""
        ...
    def DrawCircle(self, center: Any, radius: Any, color: Any) -> Any:
        """Draws an outline; radius [m]."""
        ...
    def DrawSolidCircle(self, center: Any, radius: Any, axis: Any, color: Any) -> Any:
        """Draws a filled circle; radius [m]."""
        ...
    def DrawSegment(self, p1: Any, p2: Any, color: Any) -> Any:
        """Draws a line."""
        ...
    def DrawTransform(self, xf: Any) -> Any:
        """Draws a frame."""
        ...

class b2DestructionListener:
    """Hears of joints and fixtures that are destroyed with their body."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def SayGoodbye(self, object: Any) -> Any:
        """Called before a joint or a fixture is destroyed."""
        ...

class b2DistanceInput:
    """Two children of shapes with their transforms, for b2Distance."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...

class b2DistanceOutput:
    """The closest points of two shapes [m]."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...

class b2DistanceResult:
    """b2DistanceResult(pointA, pointB, distance, iterations)"""
    pointA: Any
    pointB: Any
    distance: Any
    iterations: Any

b2Draw = b2DebugDraw

class b2Filter:
    """Decides which fixtures collide."""
    def __init__(self, **kwargs: Any) -> None: ...
    @property
    def categoryBits(self) -> int:
        """Categories of the fixture, 0 to 65535."""
        ...
    @categoryBits.setter
    def categoryBits(self, value: int) -> None: ...
    @property
    def maskBits(self) -> int:
        """Categories that it collides with, 0 to 65535."""
        ...
    @maskBits.setter
    def maskBits(self, value: int) -> None: ...
    @property
    def groupIndex(self) -> int:
        """Group that always or never collides; 0: none."""
        ...
    @groupIndex.setter
    def groupIndex(self, value: int) -> None: ...
    def copy(self) -> b2Filter:
        """Returns a copy."""
        ...

class b2Fixture:
    """A shape on a body with its material. It keeps attributes of the program."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def __ne__(self, other: object) -> bool: ...
    @property
    def userData(self) -> Any:
        """Any object of the program."""
        ...
    @userData.setter
    def userData(self, value: Any) -> None: ...
    @property
    def density(self) -> float:
        """Mass per area [kg/m^2]. Call ResetMassData of the body after a change."""
        ...
    @density.setter
    def density(self, value: float) -> None: ...
    @property
    def friction(self) -> float:
        """Friction, 0 or more."""
        ...
    @friction.setter
    def friction(self, value: float) -> None: ...
    @property
    def restitution(self) -> float:
        """Restitution, 0 or more."""
        ...
    @restitution.setter
    def restitution(self, value: float) -> None: ...
    @property
    def sensor(self) -> bool:
        """True if it reports contacts without a collision response."""
        ...
    @sensor.setter
    def sensor(self, value: bool) -> None: ...
    filterData: _Settable[b2FixtureFilter]
    """The collision filter. What is written to it reaches the fixture."""
    @property
    def categoryBits(self) -> int:
        """Categories of the fixture, 0 to 65535."""
        ...
    @categoryBits.setter
    def categoryBits(self, value: int) -> None: ...
    @property
    def maskBits(self) -> int:
        """Categories that it collides with, 0 to 65535."""
        ...
    @maskBits.setter
    def maskBits(self, value: int) -> None: ...
    @property
    def groupIndex(self) -> int:
        """Group that always or never collides; 0: none."""
        ...
    @groupIndex.setter
    def groupIndex(self, value: int) -> None: ...
    @property
    def type(self) -> int:
        """Type of the shape."""
        ...
    @property
    def shape(self) -> Any:
        """The shape, in the frame of the body. What is written to it reaches the fixture; call ResetMassData of the body for its mass."""
        ...
    @property
    def body(self) -> Any:
        """The body that the fixture is on."""
        ...
    @property
    def next(self) -> Any:
        """The fixture created before this one, or None."""
        ...
    @property
    def massData(self) -> b2MassData:
        """Mass, centre and rotational inertia of the shape."""
        ...
    def Refilter(self) -> None:
        """Filters the contacts again in the next step."""
        ...
    def TestPoint(self, p: Any) -> bool:
        """True if the world point [m] is inside."""
        ...
    def GetAABB(self, childIndex: Any = ...) -> b2AABB:
        """Returns the box in the broad phase [m]."""
        ...
    def Dump(self, bodyIndex: Any = ...) -> None:
        """Writes the fixture as code of C++ to standard output."""
        ...
    def RayCast(self, *arguments: Any, **keywords: Any) -> Any:
        """Casts a ray at the fixture: RayCast(input, childIndex=0) or RayCast(output, input, childIndex). Returns (hit, b2RayCastOutput)."""
        ...
    def ClearUserData(self) -> Any:
        """Sets userData to None."""
        ...
    def GetUserData(self) -> Any:
        """Any object of the program."""
        ...
    def SetUserData(self, value: Any) -> Any:
        """Any object of the program."""
        ...
    def GetDensity(self) -> Any:
        """Mass per area [kg/m^2]. Call ResetMassData of the body after a change."""
        ...
    def SetDensity(self, value: Any) -> Any:
        """Mass per area [kg/m^2]. Call ResetMassData of the body after a change."""
        ...
    def GetFriction(self) -> Any:
        """Friction, 0 or more."""
        ...
    def SetFriction(self, value: Any) -> Any:
        """Friction, 0 or more."""
        ...
    def GetRestitution(self) -> Any:
        """Restitution, 0 or more."""
        ...
    def SetRestitution(self, value: Any) -> Any:
        """Restitution, 0 or more."""
        ...
    def GetSensor(self) -> Any:
        """True if it reports contacts without a collision response."""
        ...
    def IsSensor(self) -> Any:
        """True if it reports contacts without a collision response."""
        ...
    def SetSensor(self, value: Any) -> Any:
        """True if it reports contacts without a collision response."""
        ...
    def GetFilterData(self) -> Any:
        """The collision filter. What is written to it reaches the fixture."""
        ...
    def SetFilterData(self, value: Any) -> Any:
        """The collision filter. What is written to it reaches the fixture."""
        ...
    def GetCategoryBits(self) -> Any:
        """Categories of the fixture, 0 to 65535."""
        ...
    def SetCategoryBits(self, value: Any) -> Any:
        """Categories of the fixture, 0 to 65535."""
        ...
    def GetMaskBits(self) -> Any:
        """Categories that it collides with, 0 to 65535."""
        ...
    def SetMaskBits(self, value: Any) -> Any:
        """Categories that it collides with, 0 to 65535."""
        ...
    def GetGroupIndex(self) -> Any:
        """Group that always or never collides; 0: none."""
        ...
    def SetGroupIndex(self, value: Any) -> Any:
        """Group that always or never collides; 0: none."""
        ...
    def GetType(self) -> Any:
        """Type of the shape."""
        ...
    def GetShape(self) -> Any:
        """The shape, in the frame of the body. What is written to it reaches the fixture; call ResetMassData of the body for its mass."""
        ...
    def GetBody(self) -> Any:
        """The body that the fixture is on."""
        ...
    def GetNext(self) -> Any:
        """The fixture created before this one, or None."""
        ...
    def GetMassData(self) -> Any:
        """Mass, centre and rotational inertia of the shape."""
        ...

class b2FixtureDef:
    """Definition of a fixture: a shape with friction, restitution, density [kg/m^2] and a collision filter."""
    shape: Any
    friction: float
    restitution: float
    density: float
    isSensor: bool
    filter: Any
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def categoryBits(self) -> Any:
        """`categoryBits` of the filter."""
        ...
    @categoryBits.setter
    def categoryBits(self, value: Any) -> None: ...
    @property
    def maskBits(self) -> Any:
        """`maskBits` of the filter."""
        ...
    @maskBits.setter
    def maskBits(self, value: Any) -> None: ...
    @property
    def groupIndex(self) -> Any:
        """`groupIndex` of the filter."""
        ...
    @groupIndex.setter
    def groupIndex(self, value: Any) -> None: ...
    @property
    def sensor(self) -> Any:
        """True if the fixture reports contacts without a collision response."""
        ...
    @sensor.setter
    def sensor(self, value: Any) -> None: ...

class b2Joint:
    """A joint, made by b2World.CreateJoint. It keeps attributes of the program."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def __ne__(self, other: object) -> bool: ...
    @property
    def userData(self) -> Any:
        """Any object of the program."""
        ...
    @userData.setter
    def userData(self, value: Any) -> None: ...
    @property
    def type(self) -> int:
        """The kind of the joint, such as e_revoluteJoint."""
        ...
    @property
    def anchorA(self) -> b2Vec2:
        """Anchor on body A, in the world [m]."""
        ...
    @property
    def anchorB(self) -> b2Vec2:
        """Anchor on body B, in the world [m]."""
        ...
    @property
    def active(self) -> bool:
        """True if both bodies are active."""
        ...
    @property
    def collideConnected(self) -> bool:
        """True if the two bodies collide."""
        ...
    @property
    def bodyA(self) -> Any:
        """The first body."""
        ...
    @property
    def bodyB(self) -> Any:
        """The second body."""
        ...
    @property
    def next(self) -> Any:
        """The joint created before this one, or None."""
        ...
    @property
    def world(self) -> Any:
        """The world that the joint is in."""
        ...
    def getAsType(self) -> Any:
        """Returns the joint, which has its own class already."""
        ...
    def Dump(self) -> None:
        """Writes the joint as code of C++ to standard output."""
        ...
    def GetReactionForce(self, inv_dt: Any) -> b2Vec2:
        """Returns the force on body B [N] in a step of 1 / inv_dt seconds."""
        ...
    def GetReactionTorque(self, inv_dt: Any) -> float:
        """Returns the torque on body B [N m] in a step of 1 / inv_dt seconds."""
        ...
    def ClearUserData(self) -> Any:
        """Sets userData to None."""
        ...
    def GetUserData(self) -> Any:
        """Any object of the program."""
        ...
    def SetUserData(self, value: Any) -> Any:
        """Any object of the program."""
        ...
    def GetType(self) -> Any:
        """The kind of the joint, such as e_revoluteJoint."""
        ...
    def GetAnchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    def GetAnchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    def GetActive(self) -> Any:
        """True if both bodies are active."""
        ...
    def IsActive(self) -> Any:
        """True if both bodies are active."""
        ...
    def GetCollideConnected(self) -> Any:
        """True if the two bodies collide."""
        ...
    def IsCollideConnected(self) -> Any:
        """True if the two bodies collide."""
        ...
    def GetBodyA(self) -> Any:
        """The first body."""
        ...
    def GetBodyB(self) -> Any:
        """The second body."""
        ...
    def GetNext(self) -> Any:
        """The joint created before this one, or None."""
        ...
    def GetWorld(self) -> Any:
        """The world that the joint is in."""
        ...

class b2JointDef:
    """The base of the definitions of joints. The bodies are set before the other keywords."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    type: int

class b2JointEdge:
    """A joint of a body, and the other body."""
    def __init__(self, other: Any, item: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def joint(self) -> Any:
        """The joint."""
        ...

class b2Manifold:
    """The contact of two shapes: a normal and up to two points."""
    def __init__(self) -> None: ...
    e_circles: int
    e_faceA: int
    e_faceB: int
    @property
    def points(self) -> list:
        """The contact points, a list of b2ManifoldPoint."""
        ...
    @property
    def localNormal(self) -> b2Vec2:
        """Unit normal, in the frame of a body."""
        ...
    @property
    def localPoint(self) -> b2Vec2:
        """Reference point [m]."""
        ...
    @property
    def type_(self) -> int:
        """e_circles, e_faceA or e_faceB."""
        ...
    @property
    def type(self) -> int:
        """e_circles, e_faceA or e_faceB."""
        ...
    @property
    def pointCount(self) -> int:
        """Number of points, 0 to 2."""
        ...
    def copy(self) -> b2Manifold:
        """Returns a copy."""
        ...

class b2ManifoldPoint:
    """A contact point."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localPoint(self) -> b2Vec2:
        """Position; its frame depends on the manifold [m]."""
        ...
    @property
    def normalImpulse(self) -> float:
        """Normal impulse [N s]."""
        ...
    @property
    def tangentImpulse(self) -> float:
        """Friction impulse [N s]."""
        ...
    @property
    def id(self) -> b2ContactID:
        """Features that made it."""
        ...
    @property
    def isNew(self) -> bool:
        """True if it has no impulse yet."""
        ...
    def copy(self) -> b2ManifoldPoint:
        """Returns a copy."""
        ...

class b2MassData:
    """Mass [kg], centre [m] and rotational inertia [kg m^2]."""
    def __init__(self, **kwargs: Any) -> None: ...
    @property
    def mass(self) -> float:
        """Mass [kg]."""
        ...
    @mass.setter
    def mass(self, value: float) -> None: ...
    center: _Settable[b2Vec2]
    """Centre of mass [m]."""
    @property
    def I(self) -> float:
        """Rotational inertia about the origin [kg m^2]."""
        ...
    @I.setter
    def I(self, value: float) -> None: ...
    def copy(self) -> b2MassData:
        """Returns a copy."""
        ...

class b2Mat22:
    """A 2-by-2 matrix of the columns ex and ey."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    ex: _Settable[b2Vec2]
    """First column."""
    ey: _Settable[b2Vec2]
    """Second column."""
    col1: _Settable[b2Vec2]
    """First column, as ex."""
    col2: _Settable[b2Vec2]
    """Second column, as ey."""
    @property
    def inverse(self) -> b2Mat22:
        """The inverse; zero if singular."""
        ...
    @property
    def angle(self) -> float:
        """Angle of a rotation matrix [rad]."""
        ...
    @angle.setter
    def angle(self, value: float) -> None: ...
    def __mul__(self, arg0: Any, /) -> Any: ...
    def __abs__(self) -> b2Mat22: ...
    def __eq__(self, other: object) -> bool: ...
    def GetInverse(self) -> b2Mat22:
        """Returns the inverse; zero if singular."""
        ...
    def Solve(self, b: Any) -> b2Vec2:
        """Returns x with A x = b."""
        ...
    def Set(self, ex: Any, ey: Any) -> None:
        """Sets both columns."""
        ...
    def SetIdentity(self) -> None:
        """Sets the identity."""
        ...
    def SetZero(self) -> None:
        """Sets all numbers to 0."""
        ...
    def __add__(self, arg0: b2Mat22, /) -> b2Mat22: ...
    def __iadd__(self, arg0: b2Mat22, /) -> Any: ...
    def __sub__(self, arg0: b2Mat22, /) -> b2Mat22: ...
    def __isub__(self, arg0: b2Mat22, /) -> Any: ...
    def copy(self) -> b2Mat22:
        """Returns a copy."""
        ...

class b2Mat33:
    """A 3-by-3 matrix of the columns ex, ey and ez."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    ex: _Settable[b2Vec3]
    """First column."""
    ey: _Settable[b2Vec3]
    """Second column."""
    ez: _Settable[b2Vec3]
    """Third column."""
    col1: _Settable[b2Vec3]
    """First column, as ex."""
    col2: _Settable[b2Vec3]
    """Second column, as ey."""
    col3: _Settable[b2Vec3]
    """Third column, as ez."""
    def __mul__(self, arg0: Any, /) -> b2Vec3: ...
    def GetInverse22(self) -> b2Mat33:
        """Returns the inverse of the upper left 2x2 part; zero if singular."""
        ...
    def GetSymInverse33(self) -> b2Mat33:
        """Returns the inverse of a symmetric matrix; zero if singular."""
        ...
    def Solve33(self, b: Any) -> b2Vec3:
        """Returns x with A x = b."""
        ...
    def Solve22(self, b: Any) -> b2Vec2:
        """Returns x with A x = b for the upper left block."""
        ...
    def SetZero(self) -> None:
        """Sets all numbers to 0."""
        ...
    def __add__(self, arg0: b2Mat33, /) -> b2Mat33: ...
    def __iadd__(self, arg0: b2Mat33, /) -> Any: ...
    def __sub__(self, arg0: b2Mat33, /) -> b2Mat33: ...
    def __isub__(self, arg0: b2Mat33, /) -> Any: ...
    def copy(self) -> b2Mat33:
        """Returns a copy."""
        ...

class b2Profile:
    """Timing of the last step [ms]."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def step(self) -> float:
        """Total [ms]."""
        ...
    @property
    def collide(self) -> float:
        """Updating contacts [ms]."""
        ...
    @property
    def solve(self) -> float:
        """Velocities and positions [ms]."""
        ...
    @property
    def solveInit(self) -> float:
        """Preparing constraints [ms]."""
        ...
    @property
    def solveVelocity(self) -> float:
        """Velocities [ms]."""
        ...
    @property
    def solvePosition(self) -> float:
        """Positions [ms]."""
        ...
    @property
    def broadphase(self) -> float:
        """Finding pairs [ms]."""
        ...
    @property
    def solveTOI(self) -> float:
        """Continuous collision [ms]."""
        ...

class b2QueryCallback:
    """Receives what b2World.QueryAABB finds."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def ReportFixture(self, fixture: Any) -> Any:
        """Returns True to go on, False to end."""
        ...

class b2RayCastCallback:
    """Receives what b2World.RayCast hits."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def ReportFixture(self, fixture: Any, point: Any, normal: Any, fraction: Any) -> Any:
        """Returns -1 to ignore the fixture, 0 to end, fraction to clip the ray, 1 to go on."""
        ...

class b2RayCastInput:
    """A ray from p1 to p1 + maxFraction * (p2 - p1)."""
    def __init__(self, **kwargs: Any) -> None: ...
    p1: _Settable[b2Vec2]
    """Start [m]."""
    p2: _Settable[b2Vec2]
    """End at fraction 1 [m]."""
    @property
    def maxFraction(self) -> float:
        """Length as a multiple of p2 - p1."""
        ...
    @maxFraction.setter
    def maxFraction(self, value: float) -> None: ...
    def copy(self) -> b2RayCastInput:
        """Returns a copy."""
        ...

class b2RayCastOutput:
    """Where a ray hits."""
    def __init__(self, **kwargs: Any) -> None: ...
    normal: _Settable[b2Vec2]
    """Unit normal of the surface."""
    @property
    def fraction(self) -> float:
        """Fraction of the ray."""
        ...
    @fraction.setter
    def fraction(self, value: float) -> None: ...
    def copy(self) -> b2RayCastOutput:
        """Returns a copy."""
        ...

class b2Rot:
    """A rotation, as the sine and cosine of its angle."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    @property
    def s(self) -> float:
        """Sine of the angle."""
        ...
    @s.setter
    def s(self, value: float) -> None: ...
    @property
    def c(self) -> float:
        """Cosine of the angle."""
        ...
    @c.setter
    def c(self, value: float) -> None: ...
    @property
    def angle(self) -> float:
        """Angle [rad]."""
        ...
    @angle.setter
    def angle(self, value: float) -> None: ...
    @property
    def x_axis(self) -> b2Vec2:
        """The rotated x axis."""
        ...
    @property
    def y_axis(self) -> b2Vec2:
        """The rotated y axis."""
        ...
    def GetAngle(self) -> float:
        """Returns the angle [rad]."""
        ...
    def GetXAxis(self) -> b2Vec2:
        """Returns the rotated x axis."""
        ...
    def GetYAxis(self) -> b2Vec2:
        """Returns the rotated y axis."""
        ...
    def Set(self, angle: Any) -> None:
        """Sets the angle [rad]."""
        ...
    def SetIdentity(self) -> None:
        """Sets the angle to 0."""
        ...
    def __mul__(self, arg0: Any, /) -> Any: ...
    def copy(self) -> b2Rot:
        """Returns a copy."""
        ...

class b2Shape:
    """The base class of shapes."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    e_circle: int
    e_edge: int
    e_polygon: int
    e_chain: int
    @property
    def type(self) -> int:
        """One of e_circle, e_edge, e_polygon and e_chain."""
        ...
    @property
    def childCount(self) -> int:
        """Number of edges of a chain; 1 for other shapes."""
        ...
    @property
    def radius(self) -> float:
        """Radius of a circle, or of the skin of another shape [m]."""
        ...
    @radius.setter
    def radius(self, value: float) -> None: ...
    def TestPoint(self, xf: Any, p: Any) -> bool:
        """True if the world point [m] is inside."""
        ...
    def RayCast(self, *args: Any, **kwargs: Any) -> Any: ...
    def getAABB(self, transform: Any, childIndex: Any = ...) -> b2AABB:
        """Returns the bounding box of a child [m]."""
        ...
    def getMass(self, density: Any) -> b2MassData:
        """Returns the mass data for a density [kg/m^2]."""
        ...
    def ComputeAABB(self, transform: Any, childIndex: Any = ...) -> b2AABB:
        """Returns the bounding box of a child [m]."""
        ...
    def ComputeMass(self, density: Any) -> b2MassData:
        """Returns the mass data for a density [kg/m^2]."""
        ...
    def GetType(self) -> Any:
        """One of e_circle, e_edge, e_polygon and e_chain."""
        ...
    def GetChildCount(self) -> Any:
        """Number of edges of a chain; 1 for other shapes."""
        ...
    def GetRadius(self) -> Any:
        """Radius of a circle, or of the skin of another shape [m]."""
        ...
    def SetRadius(self, value: Any) -> Any:
        """Radius of a circle, or of the skin of another shape [m]."""
        ...

class b2Sweep:
    """The motion of a body during a step."""
    def __init__(self, **kwargs: Any) -> None: ...
    localCenter: _Settable[b2Vec2]
    """Centre of mass in the body's frame [m]."""
    c0: _Settable[b2Vec2]
    """Centre of mass at alpha0 [m]."""
    c: _Settable[b2Vec2]
    """Centre of mass at the end [m]."""
    @property
    def a0(self) -> float:
        """Angle at alpha0 [rad]."""
        ...
    @a0.setter
    def a0(self, value: float) -> None: ...
    @property
    def a(self) -> float:
        """Angle at the end [rad]."""
        ...
    @a.setter
    def a(self, value: float) -> None: ...
    @property
    def alpha0(self) -> float:
        """Fraction of the step before the start, 0 to 1."""
        ...
    @alpha0.setter
    def alpha0(self, value: float) -> None: ...
    def GetTransform(self, *args: Any, **kwargs: Any) -> Any: ...
    def Advance(self, alpha: Any) -> None:
        """Advances the start to a fraction of the step."""
        ...
    def Normalize(self) -> None:
        """Removes whole turns from both angles."""
        ...
    def copy(self) -> b2Sweep:
        """Returns a copy."""
        ...

class b2TOIInput:
    """Two children of shapes with their motions, for b2TimeOfImpact."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...

class b2TOIOutput:
    """The state and time of a search for a time of impact."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    e_unknown: int
    e_failed: int
    e_overlapped: int
    e_touching: int
    e_separated: int

class b2Transform:
    """A rotation, then a translation: the pose of a frame."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    position: _Settable[b2Vec2]
    """Origin of the frame [m]."""
    p: _Settable[b2Vec2]
    """Origin of the frame [m]."""
    R: _Settable[b2Rot]
    """The rotation."""
    q: _Settable[b2Rot]
    """The rotation."""
    @property
    def angle(self) -> float:
        """Angle of the rotation [rad]."""
        ...
    @angle.setter
    def angle(self, value: float) -> None: ...
    def Set(self, position: Any, angle: Any) -> None:
        """Sets the position [m] and the angle [rad]."""
        ...
    def SetIdentity(self) -> None:
        """Sets the identity."""
        ...
    def __mul__(self, arg0: Any, /) -> Any: ...
    def copy(self) -> b2Transform:
        """Returns a copy."""
        ...

class b2Vec2:
    """A vector or point with the components x and y."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    @property
    def x(self) -> float:
        """First component."""
        ...
    @x.setter
    def x(self, value: float) -> None: ...
    @property
    def y(self) -> float:
        """Second component."""
        ...
    @y.setter
    def y(self, value: float) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> float: ...
    def __setitem__(self, index: int, value: Any) -> None: ...
    def __iter__(self) -> Any: ...
    def __eq__(self, other: object) -> bool: ...
    def __neg__(self) -> b2Vec2: ...
    def __pos__(self) -> b2Vec2: ...
    def __add__(self, arg0: Any, /) -> Any: ...
    def __radd__(self, arg0: Any, /) -> Any: ...
    def __sub__(self, arg0: Any, /) -> Any: ...
    def __rsub__(self, arg0: Any, /) -> Any: ...
    def __mul__(self, arg0: Any, /) -> Any: ...
    def __rmul__(self, arg0: Any, /) -> Any: ...
    def __truediv__(self, arg0: Any, /) -> Any: ...
    def __iadd__(self, arg0: Any, /) -> Any: ...
    def __isub__(self, arg0: Any, /) -> Any: ...
    def __imul__(self, arg0: Any, /) -> Any: ...
    def __itruediv__(self, arg0: Any, /) -> Any: ...
    def copy(self) -> b2Vec2:
        """Returns a copy."""
        ...
    def __abs__(self) -> b2Vec2: ...
    tuple: _Settable[tuple]
    """The components as a tuple."""
    @property
    def length(self) -> float:
        """Length, in the unit of the components."""
        ...
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def lengthSquared(self) -> float:
        """Squared length."""
        ...
    @property
    def valid(self) -> bool:
        """True if both components are finite."""
        ...
    @property
    def skew(self) -> b2Vec2:
        """Rotated by 90 degrees counter-clockwise."""
        ...
    def dot(self, other: Any) -> float:
        """Returns the dot product."""
        ...
    def cross(self, other: Any) -> Any:
        """Returns the cross product with a vector (a number) or a number (a vector)."""
        ...
    def Normalize(self) -> float:
        """Makes this a unit vector and returns the former length."""
        ...
    def Length(self) -> float:
        """Returns the length."""
        ...
    def LengthSquared(self) -> float:
        """Returns the squared length."""
        ...
    def IsValid(self) -> bool:
        """True if both components are finite."""
        ...
    def Skew(self) -> b2Vec2:
        """Returns the vector rotated by 90 degrees counter-clockwise."""
        ...
    def Set(self, x: Any, y: Any) -> None:
        """Sets both components."""
        ...
    def SetZero(self) -> None:
        """Sets both components to 0."""
        ...

class b2Vec2Array:
    """A list of points."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, points: Any = ...) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...

class b2Vec3:
    """A vector with the components x, y and z."""
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    @property
    def x(self) -> float:
        """First component."""
        ...
    @x.setter
    def x(self, value: float) -> None: ...
    @property
    def y(self) -> float:
        """Second component."""
        ...
    @y.setter
    def y(self, value: float) -> None: ...
    @property
    def z(self) -> float:
        """Third component."""
        ...
    @z.setter
    def z(self, value: float) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> float: ...
    def __setitem__(self, index: int, value: Any) -> None: ...
    def __iter__(self) -> Any: ...
    def __eq__(self, other: object) -> bool: ...
    def __neg__(self) -> b2Vec3: ...
    def __pos__(self) -> b2Vec3: ...
    def __add__(self, arg0: Any, /) -> Any: ...
    def __radd__(self, arg0: Any, /) -> Any: ...
    def __sub__(self, arg0: Any, /) -> Any: ...
    def __rsub__(self, arg0: Any, /) -> Any: ...
    def __mul__(self, arg0: Any, /) -> Any: ...
    def __rmul__(self, arg0: Any, /) -> Any: ...
    def __truediv__(self, arg0: Any, /) -> Any: ...
    def __iadd__(self, arg0: Any, /) -> Any: ...
    def __isub__(self, arg0: Any, /) -> Any: ...
    def __imul__(self, arg0: Any, /) -> Any: ...
    def __itruediv__(self, arg0: Any, /) -> Any: ...
    def copy(self) -> b2Vec3:
        """Returns a copy."""
        ...
    tuple: _Settable[tuple]
    """The components as a tuple."""
    @property
    def length(self) -> float:
        """Length."""
        ...
    @property
    def lengthSquared(self) -> float:
        """Squared length."""
        ...
    @property
    def valid(self) -> bool:
        """True if all components are finite."""
        ...
    def dot(self, other: Any) -> float:
        """Returns the dot product."""
        ...
    def cross(self, other: Any) -> b2Vec3:
        """Returns the cross product."""
        ...
    def Normalize(self) -> float:
        """Makes this a unit vector and returns the former length."""
        ...
    def Set(self, x: Any, y: Any, z: Any) -> None:
        """Sets all components."""
        ...
    def SetZero(self) -> None:
        """Sets all components to 0."""
        ...

class b2Version:
    """A version of the interface."""
    major: Any
    minor: Any
    revision: Any

class b2World:
    """A world: it owns bodies and joints, steps them and answers queries."""
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __init__(self, gravity: Any = ..., doSleep: Any = ..., **keywords: Any) -> None:
        """Creates an empty world. Gravity [m/s^2]; every other keyword is a property."""
        ...
    gravity: _Settable[b2BoundVec2]
    """Acceleration of all dynamic bodies [m/s^2]."""
    @property
    def allowSleeping(self) -> bool:
        """True if bodies may fall asleep."""
        ...
    @allowSleeping.setter
    def allowSleeping(self, value: bool) -> None: ...
    @property
    def warmStarting(self) -> bool:
        """True if the impulses of a step initialize the next."""
        ...
    @warmStarting.setter
    def warmStarting(self, value: bool) -> None: ...
    @property
    def continuousPhysics(self) -> bool:
        """True if continuous collision is enabled."""
        ...
    @continuousPhysics.setter
    def continuousPhysics(self, value: bool) -> None: ...
    @property
    def subStepping(self) -> bool:
        """True if a step ends at its first time of impact."""
        ...
    @subStepping.setter
    def subStepping(self, value: bool) -> None: ...
    @property
    def autoClearForces(self) -> bool:
        """True if forces last for one step only."""
        ...
    @autoClearForces.setter
    def autoClearForces(self, value: bool) -> None: ...
    @property
    def subStepCount(self) -> int:
        """Sub-steps per step, 1 to 64."""
        ...
    @subStepCount.setter
    def subStepCount(self, value: int) -> None: ...
    @property
    def threadCount(self) -> int:
        """Threads of a step, 1 to 64. Results are the same for every number."""
        ...
    @threadCount.setter
    def threadCount(self, value: int) -> None: ...
    @property
    def restitutionThreshold(self) -> float:
        """Slower impacts do not bounce [m/s]."""
        ...
    @restitutionThreshold.setter
    def restitutionThreshold(self, value: float) -> None: ...
    @property
    def locked(self) -> bool:
        """True inside a callback. Nothing can be created or destroyed then."""
        ...
    @property
    def bodyCount(self) -> int:
        """Number of bodies."""
        ...
    @property
    def jointCount(self) -> int:
        """Number of joints."""
        ...
    @property
    def contactCount(self) -> int:
        """Number of contacts, touching or not."""
        ...
    @property
    def proxyCount(self) -> int:
        """Number of boxes in the broad phase."""
        ...
    @property
    def treeHeight(self) -> int:
        """Height of the broad phase's highest tree."""
        ...
    @property
    def treeBalance(self) -> int:
        """Maximum balance of the trees."""
        ...
    @property
    def treeQuality(self) -> float:
        """Ratio of the areas of the trees."""
        ...
    @property
    def contactListener(self) -> Any:
        """The b2ContactListener, or None."""
        ...
    @contactListener.setter
    def contactListener(self, value: Any) -> None: ...
    @property
    def contactFilter(self) -> Any:
        """The b2ContactFilter, or None for the default."""
        ...
    @contactFilter.setter
    def contactFilter(self, value: Any) -> None: ...
    @property
    def destructionListener(self) -> Any:
        """The b2DestructionListener, or None."""
        ...
    @destructionListener.setter
    def destructionListener(self, value: Any) -> None: ...
    @property
    def renderer(self) -> Any:
        """The b2Draw that DrawDebugData calls, or None."""
        ...
    @renderer.setter
    def renderer(self, value: Any) -> None: ...
    def Step(self, timeStep: Any, velocityIterations: Any, positionIterations: Any) -> None:
        """Advances the simulation by timeStep [s]; 8 and 3 iterations are typical."""
        ...
    def ClearForces(self) -> None:
        """Clears all forces and torques."""
        ...
    def DrawDebugData(self) -> None:
        """Draws the world with the renderer."""
        ...
    def DestroyBody(self, body: b2Body) -> None:
        """Destroys a body with its fixtures, joints and contacts. They cannot be used afterwards."""
        ...
    def DestroyJoint(self, joint: b2Joint) -> None:
        """Destroys a joint. It cannot be used afterwards."""
        ...
    def QueryAABB(self, callback: Any, aabb: Any) -> None:
        """Reports each fixture whose box overlaps: callback.ReportFixture(fixture) returns False to end."""
        ...
    def RayCast(self, callback: Any, point1: Any, point2: Any) -> None:
        """Reports each fixture that a ray hits: callback.ReportFixture(fixture, point, normal, fraction) returns -1 to ignore it, 0 to end, fraction to clip the ray, 1 to go on."""
        ...
    def ShiftOrigin(self, newOrigin: Any) -> None:
        """Makes this point [m] the origin of the world."""
        ...
    def poses(self, out: Any = ...) -> Any:
        """Returns x, y [m] and angle [rad] of each body, in the order of world.bodies, as an array (n, 3) of float32. `out` is an array to write into."""
        ...
    def Dump(self) -> None:
        """Writes the world as code of C++ to standard output."""
        ...
    def DebugDraw(self) -> None:
        """Draws the world with the renderer."""
        ...
    @property
    def bodies(self) -> list[b2Body]:
        """The bodies, in the order of creation."""
        ...
    @property
    def joints(self) -> list[b2Joint]:
        """The joints, in the order of creation."""
        ...
    @property
    def contacts(self) -> list[b2Contact]:
        """The contacts, touching or not."""
        ...
    @property
    def profile(self) -> b2Profile:
        """Timing of the last step. The first use enables it."""
        ...
    def __iter__(self) -> Any: ...
    def __contains__(self, arg0: Any, /) -> bool: ...
    @property
    def bodies_gen(self) -> Any:
        """A generator of bodies."""
        ...
    @property
    def joints_gen(self) -> Any:
        """A generator of joints."""
        ...
    @property
    def contacts_gen(self) -> Any:
        """A generator of contacts."""
        ...
    def CreateBody(self, defn: Any = ..., **keywords: Any) -> b2Body:
        """Creates a body from a b2BodyDef or from keywords: its fields, fixtures, shapes, shapeFixture, and mass data."""
        ...
    def CreateStaticBody(self, defn: Any = ..., **keywords: Any) -> b2Body:
        """Creates a static body from a b2BodyDef or from keywords; see CreateBody."""
        ...
    def CreateKinematicBody(self, defn: Any = ..., **keywords: Any) -> b2Body:
        """Creates a kinematic body from a b2BodyDef or from keywords; see CreateBody."""
        ...
    def CreateDynamicBody(self, defn: Any = ..., **keywords: Any) -> b2Body:
        """Creates a dynamic body from a b2BodyDef or from keywords; see CreateBody."""
        ...
    def CreateJoint(self, defn: Any = ..., type: Any = ..., **keywords: Any) -> b2Joint:
        """Creates a joint from a definition, or from its class `type` and keywords."""
        ...
    def CreateRevoluteJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2RevoluteJoint:
        """Creates a joint from the keywords of b2RevoluteJointDef."""
        ...
    def CreatePrismaticJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2PrismaticJoint:
        """Creates a joint from the keywords of b2PrismaticJointDef."""
        ...
    def CreateDistanceJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2DistanceJoint:
        """Creates a joint from the keywords of b2DistanceJointDef."""
        ...
    def CreatePulleyJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2PulleyJoint:
        """Creates a joint from the keywords of b2PulleyJointDef."""
        ...
    def CreateMouseJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2MouseJoint:
        """Creates a joint from the keywords of b2MouseJointDef."""
        ...
    def CreateGearJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2GearJoint:
        """Creates a joint from the keywords of b2GearJointDef."""
        ...
    def CreateWheelJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2WheelJoint:
        """Creates a joint from the keywords of b2WheelJointDef."""
        ...
    def CreateWeldJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2WeldJoint:
        """Creates a joint from the keywords of b2WeldJointDef."""
        ...
    def CreateFrictionJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2FrictionJoint:
        """Creates a joint from the keywords of b2FrictionJointDef."""
        ...
    def CreateRopeJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2RopeJoint:
        """Creates a joint from the keywords of b2RopeJointDef."""
        ...
    def CreateMotorJoint(self, bodyA: Any = ..., bodyB: Any = ..., **keywords: Any) -> b2MotorJoint:
        """Creates a joint from the keywords of b2MotorJointDef."""
        ...
    @property
    def contactManager(self) -> Any:
        """A summary of the contacts."""
        ...
    def GetGravity(self) -> Any:
        """Acceleration of all dynamic bodies [m/s^2]."""
        ...
    def SetGravity(self, value: Any) -> Any:
        """Acceleration of all dynamic bodies [m/s^2]."""
        ...
    def GetAllowSleeping(self) -> Any:
        """True if bodies may fall asleep."""
        ...
    def IsAllowSleeping(self) -> Any:
        """True if bodies may fall asleep."""
        ...
    def SetAllowSleeping(self, value: Any) -> Any:
        """True if bodies may fall asleep."""
        ...
    def GetWarmStarting(self) -> Any:
        """True if the impulses of a step initialize the next."""
        ...
    def IsWarmStarting(self) -> Any:
        """True if the impulses of a step initialize the next."""
        ...
    def SetWarmStarting(self, value: Any) -> Any:
        """True if the impulses of a step initialize the next."""
        ...
    def GetContinuousPhysics(self) -> Any:
        """True if continuous collision is enabled."""
        ...
    def IsContinuousPhysics(self) -> Any:
        """True if continuous collision is enabled."""
        ...
    def SetContinuousPhysics(self, value: Any) -> Any:
        """True if continuous collision is enabled."""
        ...
    def GetSubStepping(self) -> Any:
        """True if a step ends at its first time of impact."""
        ...
    def IsSubStepping(self) -> Any:
        """True if a step ends at its first time of impact."""
        ...
    def SetSubStepping(self, value: Any) -> Any:
        """True if a step ends at its first time of impact."""
        ...
    def GetAutoClearForces(self) -> Any:
        """True if forces last for one step only."""
        ...
    def IsAutoClearForces(self) -> Any:
        """True if forces last for one step only."""
        ...
    def SetAutoClearForces(self, value: Any) -> Any:
        """True if forces last for one step only."""
        ...
    def GetSubStepCount(self) -> Any:
        """Sub-steps per step, 1 to 64."""
        ...
    def SetSubStepCount(self, value: Any) -> Any:
        """Sub-steps per step, 1 to 64."""
        ...
    def GetThreadCount(self) -> Any:
        """Threads of a step, 1 to 64. Results are the same for every number."""
        ...
    def SetThreadCount(self, value: Any) -> Any:
        """Threads of a step, 1 to 64. Results are the same for every number."""
        ...
    def GetRestitutionThreshold(self) -> Any:
        """Slower impacts do not bounce [m/s]."""
        ...
    def SetRestitutionThreshold(self, value: Any) -> Any:
        """Slower impacts do not bounce [m/s]."""
        ...
    def GetLocked(self) -> Any:
        """True inside a callback. Nothing can be created or destroyed then."""
        ...
    def IsLocked(self) -> Any:
        """True inside a callback. Nothing can be created or destroyed then."""
        ...
    def GetBodyCount(self) -> Any:
        """Number of bodies."""
        ...
    def GetJointCount(self) -> Any:
        """Number of joints."""
        ...
    def GetContactCount(self) -> Any:
        """Number of contacts, touching or not."""
        ...
    def GetProxyCount(self) -> Any:
        """Number of boxes in the broad phase."""
        ...
    def GetTreeHeight(self) -> Any:
        """Height of the broad phase's highest tree."""
        ...
    def GetTreeBalance(self) -> Any:
        """Maximum balance of the trees."""
        ...
    def GetTreeQuality(self) -> Any:
        """Ratio of the areas of the trees."""
        ...
    def GetContactListener(self) -> Any:
        """The b2ContactListener, or None."""
        ...
    def SetContactListener(self, value: Any) -> Any:
        """The b2ContactListener, or None."""
        ...
    def GetContactFilter(self) -> Any:
        """The b2ContactFilter, or None for the default."""
        ...
    def SetContactFilter(self, value: Any) -> Any:
        """The b2ContactFilter, or None for the default."""
        ...
    def GetDestructionListener(self) -> Any:
        """The b2DestructionListener, or None."""
        ...
    def SetDestructionListener(self, value: Any) -> Any:
        """The b2DestructionListener, or None."""
        ...
    def GetRenderer(self) -> Any:
        """The b2Draw that DrawDebugData calls, or None."""
        ...
    def SetRenderer(self, value: Any) -> Any:
        """The b2Draw that DrawDebugData calls, or None."""
        ...
    def GetBodies(self) -> Any:
        """The bodies, in the order of creation."""
        ...
    def GetJoints(self) -> Any:
        """The joints, in the order of creation."""
        ...
    def GetContacts(self) -> Any:
        """The contacts, touching or not."""
        ...
    def GetProfile(self) -> Any:
        """Timing of the last step. The first use enables it."""
        ...
    def GetBodies_gen(self) -> Any:
        """A generator of bodies."""
        ...
    def GetJoints_gen(self) -> Any:
        """A generator of joints."""
        ...
    def GetContacts_gen(self) -> Any:
        """A generator of contacts."""
        ...
    def GetContactManager(self) -> Any:
        """A summary of the contacts."""
        ...

class b2WorldManifold:
    """A manifold in the world."""
    def __init__(self) -> None: ...
    @property
    def normal(self) -> b2Vec2:
        """Unit normal from A to B."""
        ...
    @property
    def points(self) -> list:
        """Both points [m]; those beyond the manifold's pointCount are (0, 0)."""
        ...
    @property
    def separations(self) -> tuple:
        """Separations of the points [m]; negative: overlap."""
        ...
    def Initialize(self, manifold: b2Manifold, xfA: Any, radiusA: Any, xfB: Any, radiusB: Any) -> None:
        """Computes the manifold in the world."""
        ...
    def copy(self) -> b2WorldManifold:
        """Returns a copy."""
        ...

class b2BoundVec2(b2Vec2):
    """A vector of an object, such as the velocity of a body. What is written reaches the object."""
    def __setitem__(self, index: int, value: Any) -> None: ...
    @property
    def x(self) -> float:
        """First component."""
        ...
    @x.setter
    def x(self, value: float) -> None: ...
    @property
    def y(self) -> float:
        """Second component."""
        ...
    @y.setter
    def y(self, value: float) -> None: ...
    def __iadd__(self, arg0: Any, /) -> Any: ...
    def __isub__(self, arg0: Any, /) -> Any: ...
    def __imul__(self, arg0: Any, /) -> Any: ...
    def __itruediv__(self, arg0: Any, /) -> Any: ...
    def Normalize(self) -> float:
        """Makes this a unit vector and returns the former length."""
        ...
    def Set(self, x: Any, y: Any) -> None:
        """Sets both components."""
        ...
    def SetZero(self) -> None:
        """Sets both components to 0."""
        ...
    tuple: _Settable[tuple]
    """The components as a tuple."""
    @property
    def length(self) -> float:
        """Length, in the unit of the components."""
        ...
    @length.setter
    def length(self, value: float) -> None: ...
    def copy(self, memo: Any = ...) -> Any:
        """Returns a copy that does not reach the object."""
        ...

class b2ChainShape(b2Shape):
    """Connected edges: vertices_chain=[…] is open; vertices=[…] or vertices_loop=[…] closed."""
    def __init__(self, **kwargs: Any) -> None: ...
    vertices: _Settable[list]
    """The vertices [m]. Setting them makes a closed loop."""
    vertices_loop: _Settable[list]
    """The vertices [m]. Setting them makes a closed loop."""
    vertices_chain: _Settable[list]
    """The vertices [m]. Setting them makes an open chain."""
    @property
    def vertexCount(self) -> int:
        """Number of vertices; a loop stores its first one twice."""
        ...
    @property
    def edges(self) -> list:
        """The edges, as a list of b2EdgeShape."""
        ...
    prevVertex: _Settable[b2BoundVec2]
    """The vertex before the first [m]."""
    nextVertex: _Settable[b2BoundVec2]
    """The vertex after the last [m]."""
    def getChildEdge(self, index: Any) -> Any:
        """Returns an edge with the vertices of its neighbours."""
        ...
    def __iter__(self) -> Any: ...
    def __len__(self) -> int: ...
    def __bool__(self) -> bool: ...
    def GetChildEdge(self, index: Any) -> Any:
        """Returns an edge with the vertices of its neighbours."""
        ...
    def copy(self) -> b2ChainShape:
        """Returns a copy."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def GetVertices(self) -> Any:
        """The vertices [m]. Setting them makes a closed loop."""
        ...
    def SetVertices(self, value: Any) -> Any:
        """The vertices [m]. Setting them makes a closed loop."""
        ...
    def GetVertices_loop(self) -> Any:
        """The vertices [m]. Setting them makes a closed loop."""
        ...
    def SetVertices_loop(self, value: Any) -> Any:
        """The vertices [m]. Setting them makes a closed loop."""
        ...
    def GetVertices_chain(self) -> Any:
        """The vertices [m]. Setting them makes an open chain."""
        ...
    def SetVertices_chain(self, value: Any) -> Any:
        """The vertices [m]. Setting them makes an open chain."""
        ...
    def GetVertexCount(self) -> Any:
        """Number of vertices; a loop stores its first one twice."""
        ...
    def GetEdges(self) -> Any:
        """The edges, as a list of b2EdgeShape."""
        ...
    def GetPrevVertex(self) -> Any:
        """The vertex before the first [m]."""
        ...
    def SetPrevVertex(self, value: Any) -> Any:
        """The vertex before the first [m]."""
        ...
    def GetNextVertex(self) -> Any:
        """The vertex after the last [m]."""
        ...
    def SetNextVertex(self, value: Any) -> Any:
        """The vertex after the last [m]."""
        ...
    def CreateChain(self, vertices: Any) -> Any:
        """Sets the points of an open chain [m]."""
        ...
    def CreateLoop(self, vertices: Any) -> Any:
        """Sets the points of a closed chain [m]."""
        ...

class b2CircleShape(b2Shape):
    """A solid circle: radius=, pos=."""
    def __init__(self, **kwargs: Any) -> None: ...
    pos: _Settable[b2BoundVec2]
    """Centre [m]."""
    @property
    def vertices(self) -> list:
        """The centre, in a list [m]."""
        ...
    @property
    def vertexCount(self) -> int:
        """Always 1."""
        ...
    def copy(self) -> b2CircleShape:
        """Returns a copy."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def GetPos(self) -> Any:
        """Centre [m]."""
        ...
    def SetPos(self, value: Any) -> Any:
        """Centre [m]."""
        ...
    def GetVertices(self) -> Any:
        """The centre, in a list [m]."""
        ...
    def GetVertexCount(self) -> Any:
        """Always 1."""
        ...

class b2DistanceJoint(b2Joint):
    """Keeps two anchors at a distance."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def frequency(self) -> float:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    @frequency.setter
    def frequency(self, value: float) -> None: ...
    @property
    def dampingRatio(self) -> float:
        """Damping ratio of the spring; 1 is critical."""
        ...
    @dampingRatio.setter
    def dampingRatio(self, value: float) -> None: ...
    @property
    def length(self) -> float:
        """Rest length [m]."""
        ...
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def minLength(self) -> float:
        """Minimum length [m]; 0: none."""
        ...
    @minLength.setter
    def minLength(self, value: float) -> None: ...
    @property
    def maxLength(self) -> float:
        """Maximum length [m]."""
        ...
    @maxLength.setter
    def maxLength(self, value: float) -> None: ...
    @property
    def currentLength(self) -> float:
        """Distance of the anchors [m]."""
        ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetFrequency(self) -> Any:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    def SetFrequency(self, value: Any) -> Any:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    def GetDampingRatio(self) -> Any:
        """Damping ratio of the spring; 1 is critical."""
        ...
    def SetDampingRatio(self, value: Any) -> Any:
        """Damping ratio of the spring; 1 is critical."""
        ...
    def GetLength(self) -> Any:
        """Rest length [m]."""
        ...
    def SetLength(self, value: Any) -> Any:
        """Rest length [m]."""
        ...
    def GetMinLength(self) -> Any:
        """Minimum length [m]; 0: none."""
        ...
    def SetMinLength(self, value: Any) -> Any:
        """Minimum length [m]; 0: none."""
        ...
    def GetMaxLength(self) -> Any:
        """Maximum length [m]."""
        ...
    def SetMaxLength(self, value: Any) -> Any:
        """Maximum length [m]."""
        ...
    def GetCurrentLength(self) -> Any:
        """Distance of the anchors [m]."""
        ...

class b2DrawExtended(b2DebugDraw):
    """A b2Draw whose points are pixels: zoom [px/m], offset [px], and screenSize [px] for axes that are flipped."""
    def __init__(self, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def convertVertices(self) -> Any:
        """True if points are converted to pixels."""
        ...
    @convertVertices.setter
    def convertVertices(self, value: Any) -> None: ...
    def to_screen(self, point: Any) -> Any:
        """Converts a point of the world [m] to pixels."""
        ...

class b2EdgeShape(b2Shape):
    """A line segment: vertices=[a, b]."""
    def __init__(self, **kwargs: Any) -> None: ...
    vertex0: _Settable[b2BoundVec2]
    """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
    vertex1: _Settable[b2BoundVec2]
    """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
    vertex2: _Settable[b2BoundVec2]
    """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
    vertex3: _Settable[b2BoundVec2]
    """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
    @property
    def hasVertex0(self) -> bool:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    @hasVertex0.setter
    def hasVertex0(self, value: bool) -> None: ...
    @property
    def hasVertex3(self) -> bool:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    @hasVertex3.setter
    def hasVertex3(self, value: bool) -> None: ...
    vertices: _Settable[list]
    """The two ends [m]. May be set with those of the neighbours: 3 or 4 points."""
    all_vertices: _Settable[list]
    """The vertex before, the two ends, and the vertex after [m]."""
    @property
    def vertexCount(self) -> int:
        """Always 2."""
        ...
    def __iter__(self) -> Any: ...
    def copy(self) -> b2EdgeShape:
        """Returns a copy."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def GetVertex0(self) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def SetVertex0(self, value: Any) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def GetVertex1(self) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def SetVertex1(self, value: Any) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def GetVertex2(self) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def SetVertex2(self, value: Any) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def GetVertex3(self) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def SetVertex3(self, value: Any) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def GetHasVertex0(self) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def SetHasVertex0(self, value: Any) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def GetHasVertex3(self) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def SetHasVertex3(self, value: Any) -> Any:
        """A vertex [m]; vertex0 and vertex3 are those of the neighbours."""
        ...
    def GetVertices(self) -> Any:
        """The two ends [m]. May be set with those of the neighbours: 3 or 4 points."""
        ...
    def SetVertices(self, value: Any) -> Any:
        """The two ends [m]. May be set with those of the neighbours: 3 or 4 points."""
        ...
    def GetAll_vertices(self) -> Any:
        """The vertex before, the two ends, and the vertex after [m]."""
        ...
    def SetAll_vertices(self, value: Any) -> Any:
        """The vertex before, the two ends, and the vertex after [m]."""
        ...
    def GetVertexCount(self) -> Any:
        """Always 2."""
        ...
    def Set(self, v1: Any, v2: Any) -> Any:
        """Sets both ends [m]."""
        ...

class b2FixtureFilter(b2Filter):
    """The filter of a fixture. What is written reaches the fixture."""
    @property
    def categoryBits(self) -> Any:
        """Categories of the fixture, 0 to 65535."""
        ...
    @categoryBits.setter
    def categoryBits(self, value: Any) -> None: ...
    @property
    def maskBits(self) -> Any:
        """Categories that it collides with, 0 to 65535."""
        ...
    @maskBits.setter
    def maskBits(self, value: Any) -> None: ...
    @property
    def groupIndex(self) -> Any:
        """Group that always or never collides; 0: none."""
        ...
    @groupIndex.setter
    def groupIndex(self, value: Any) -> None: ...
    def copy(self, memo: Any = ...) -> Any:
        """Returns a copy that does not reach the object."""
        ...

class b2FrictionJoint(b2Joint):
    """Top-down friction between two bodies."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def maxForce(self) -> float:
        """Maximum force [N]."""
        ...
    @maxForce.setter
    def maxForce(self, value: float) -> None: ...
    @property
    def maxTorque(self) -> float:
        """Maximum torque [N m]."""
        ...
    @maxTorque.setter
    def maxTorque(self, value: float) -> None: ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetMaxForce(self) -> Any:
        """Maximum force [N]."""
        ...
    def SetMaxForce(self, value: Any) -> Any:
        """Maximum force [N]."""
        ...
    def GetMaxTorque(self) -> Any:
        """Maximum torque [N m]."""
        ...
    def SetMaxTorque(self, value: Any) -> Any:
        """Maximum torque [N m]."""
        ...

class b2GearJoint(b2Joint):
    """Couples two revolute or prismatic joints."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def ratio(self) -> float:
        """Factor of the second joint's coordinate."""
        ...
    @ratio.setter
    def ratio(self, value: float) -> None: ...
    @property
    def joint1(self) -> Any:
        """The first joint."""
        ...
    @property
    def joint2(self) -> Any:
        """The second joint."""
        ...
    def GetRatio(self) -> Any:
        """Factor of the second joint's coordinate."""
        ...
    def SetRatio(self, value: Any) -> Any:
        """Factor of the second joint's coordinate."""
        ...
    def GetJoint1(self) -> Any:
        """The first joint."""
        ...
    def GetJoint2(self) -> Any:
        """The second joint."""
        ...

b2LoopShape = b2ChainShape

class b2MotorJoint(b2Joint):
    """Drives body B to a pose relative to body A."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def maxForce(self) -> float:
        """Maximum force [N]."""
        ...
    @maxForce.setter
    def maxForce(self, value: float) -> None: ...
    @property
    def maxTorque(self) -> float:
        """Maximum torque [N m]."""
        ...
    @maxTorque.setter
    def maxTorque(self, value: float) -> None: ...
    linearOffset: _Settable[b2BoundVec2]
    """Target of body B's origin in body A's frame [m]."""
    @property
    def angularOffset(self) -> float:
        """Target of body B's angle minus body A's [rad]."""
        ...
    @angularOffset.setter
    def angularOffset(self, value: float) -> None: ...
    @property
    def correctionFactor(self) -> float:
        """Fraction of the error that a step corrects, 0 to 1."""
        ...
    @correctionFactor.setter
    def correctionFactor(self, value: float) -> None: ...
    def GetMaxForce(self) -> Any:
        """Maximum force [N]."""
        ...
    def SetMaxForce(self, value: Any) -> Any:
        """Maximum force [N]."""
        ...
    def GetMaxTorque(self) -> Any:
        """Maximum torque [N m]."""
        ...
    def SetMaxTorque(self, value: Any) -> Any:
        """Maximum torque [N m]."""
        ...
    def GetLinearOffset(self) -> Any:
        """Target of body B's origin in body A's frame [m]."""
        ...
    def SetLinearOffset(self, value: Any) -> Any:
        """Target of body B's origin in body A's frame [m]."""
        ...
    def GetAngularOffset(self) -> Any:
        """Target of body B's angle minus body A's [rad]."""
        ...
    def SetAngularOffset(self, value: Any) -> Any:
        """Target of body B's angle minus body A's [rad]."""
        ...
    def GetCorrectionFactor(self) -> Any:
        """Fraction of the error that a step corrects, 0 to 1."""
        ...
    def SetCorrectionFactor(self, value: Any) -> Any:
        """Fraction of the error that a step corrects, 0 to 1."""
        ...

class b2MouseJoint(b2Joint):
    """Pulls a point of body B to a point of the world."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def frequency(self) -> float:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    @frequency.setter
    def frequency(self, value: float) -> None: ...
    @property
    def dampingRatio(self) -> float:
        """Damping ratio of the spring; 1 is critical."""
        ...
    @dampingRatio.setter
    def dampingRatio(self, value: float) -> None: ...
    target: _Settable[b2BoundVec2]
    """The point of the world [m]."""
    @property
    def maxForce(self) -> float:
        """Maximum force [N]."""
        ...
    @maxForce.setter
    def maxForce(self, value: float) -> None: ...
    def GetFrequency(self) -> Any:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    def SetFrequency(self, value: Any) -> Any:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    def GetDampingRatio(self) -> Any:
        """Damping ratio of the spring; 1 is critical."""
        ...
    def SetDampingRatio(self, value: Any) -> Any:
        """Damping ratio of the spring; 1 is critical."""
        ...
    def GetTarget(self) -> Any:
        """The point of the world [m]."""
        ...
    def SetTarget(self, value: Any) -> Any:
        """The point of the world [m]."""
        ...
    def GetMaxForce(self) -> Any:
        """Maximum force [N]."""
        ...
    def SetMaxForce(self, value: Any) -> Any:
        """Maximum force [N]."""
        ...

class b2MouseJointDef(b2JointDef):
    """Definition of a mouse joint."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    target: Any
    maxForce: float
    frequencyHz: float
    dampingRatio: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    type: int

class b2PolygonShape(b2Shape):
    """A convex polygon: vertices=[…], or box=(hx, hy[, center, angle])."""
    def __init__(self, **kwargs: Any) -> None: ...
    vertices: _Settable[list]
    """The vertices, counter-clockwise [m]. Setting them takes their convex hull."""
    @property
    def box(self) -> Any:
        """Half-width and half-height [m], and optionally a centre [m] and an angle [rad]."""
        ...
    @box.setter
    def box(self, value: Any) -> None: ...
    @property
    def normals(self) -> list:
        """Outward unit normals of the edges."""
        ...
    @property
    def centroid(self) -> b2Vec2:
        """Centroid of the area [m]."""
        ...
    @property
    def vertexCount(self) -> int:
        """Number of vertices."""
        ...
    @property
    def valid(self) -> bool:
        """True if the polygon is convex and has a size."""
        ...
    def SetAsBox(self, hx: Any, hy: Any, center: Any = ..., angle: Any = ...) -> None:
        """Sets a box of half-width hx and half-height hy [m]."""
        ...
    def __iter__(self) -> Any: ...
    def __len__(self) -> int: ...
    def __bool__(self) -> bool: ...
    def copy(self) -> b2PolygonShape:
        """Returns a copy."""
        ...
    def Set(self, vertices: Any) -> Any:
        """Sets the vertices [m]."""
        ...
    def __eq__(self, other: object) -> bool: ...
    def GetVertices(self) -> Any:
        """The vertices, counter-clockwise [m]. Setting them takes their convex hull."""
        ...
    def SetVertices(self, value: Any) -> Any:
        """The vertices, counter-clockwise [m]. Setting them takes their convex hull."""
        ...
    def GetBox(self) -> Any:
        """Half-width and half-height [m], and optionally a centre [m] and an angle [rad]."""
        ...
    def SetBox(self, value: Any) -> Any:
        """Half-width and half-height [m], and optionally a centre [m] and an angle [rad]."""
        ...
    def GetNormals(self) -> Any:
        """Outward unit normals of the edges."""
        ...
    def GetCentroid(self) -> Any:
        """Centroid of the area [m]."""
        ...
    def GetVertexCount(self) -> Any:
        """Number of vertices."""
        ...
    def GetValid(self) -> Any:
        """True if the polygon is convex and has a size."""
        ...
    def IsValid(self) -> Any:
        """True if the polygon is convex and has a size."""
        ...
    def GetVertex(self, index: Any) -> Any:
        """Returns a vertex [m]."""
        ...
    def Validate(self) -> Any:
        """True if the polygon is convex and has an area."""
        ...

class b2PrismaticJoint(b2Joint):
    """A slider: body B moves along an axis of body A."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def limitEnabled(self) -> bool:
        """True if the limits are enabled."""
        ...
    @limitEnabled.setter
    def limitEnabled(self, value: bool) -> None: ...
    @property
    def lowerLimit(self) -> float:
        """Lower limit of the translation [m]."""
        ...
    @lowerLimit.setter
    def lowerLimit(self, value: float) -> None: ...
    @property
    def upperLimit(self) -> float:
        """Upper limit of the translation [m]."""
        ...
    @upperLimit.setter
    def upperLimit(self, value: float) -> None: ...
    limits: _Settable[tuple]
    """Both limits, as (lower, upper)."""
    def SetLimits(self, lower: Any, upper: Any) -> None:
        """Sets both limits."""
        ...
    @property
    def motorEnabled(self) -> bool:
        """True if the motor is enabled."""
        ...
    @motorEnabled.setter
    def motorEnabled(self, value: bool) -> None: ...
    @property
    def motorSpeed(self) -> float:
        """Target speed of the motor [m/s]."""
        ...
    @motorSpeed.setter
    def motorSpeed(self, value: float) -> None: ...
    @property
    def maxMotorForce(self) -> float:
        """Maximum force of the motor [N]."""
        ...
    @maxMotorForce.setter
    def maxMotorForce(self, value: float) -> None: ...
    def GetMotorForce(self, inv_dt: Any) -> float:
        """Returns the force of the motor [N] in a step of 1 / inv_dt seconds."""
        ...
    @property
    def translation(self) -> float:
        """Position along the axis [m]."""
        ...
    @property
    def speed(self) -> float:
        """Speed along the axis [m/s]."""
        ...
    @property
    def localAxisA(self) -> b2Vec2:
        """Axis in body A's frame."""
        ...
    @property
    def referenceAngle(self) -> float:
        """Angle between the bodies [rad]."""
        ...
    @property
    def axis(self) -> b2Vec2:
        """Axis in the world."""
        ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetLimitEnabled(self) -> Any:
        """True if the limits are enabled."""
        ...
    def IsLimitEnabled(self) -> Any:
        """True if the limits are enabled."""
        ...
    def SetLimitEnabled(self, value: Any) -> Any:
        """True if the limits are enabled."""
        ...
    def EnableLimit(self, value: Any) -> Any:
        """True if the limits are enabled."""
        ...
    def GetLowerLimit(self) -> Any:
        """Lower limit of the translation [m]."""
        ...
    def SetLowerLimit(self, value: Any) -> Any:
        """Lower limit of the translation [m]."""
        ...
    def GetUpperLimit(self) -> Any:
        """Upper limit of the translation [m]."""
        ...
    def SetUpperLimit(self, value: Any) -> Any:
        """Upper limit of the translation [m]."""
        ...
    def GetLimits(self) -> Any:
        """Both limits, as (lower, upper)."""
        ...
    def GetMotorEnabled(self) -> Any:
        """True if the motor is enabled."""
        ...
    def IsMotorEnabled(self) -> Any:
        """True if the motor is enabled."""
        ...
    def SetMotorEnabled(self, value: Any) -> Any:
        """True if the motor is enabled."""
        ...
    def EnableMotor(self, value: Any) -> Any:
        """True if the motor is enabled."""
        ...
    def GetMotorSpeed(self) -> Any:
        """Target speed of the motor [m/s]."""
        ...
    def SetMotorSpeed(self, value: Any) -> Any:
        """Target speed of the motor [m/s]."""
        ...
    def GetMaxMotorForce(self) -> Any:
        """Maximum force of the motor [N]."""
        ...
    def SetMaxMotorForce(self, value: Any) -> Any:
        """Maximum force of the motor [N]."""
        ...
    def GetJointTranslation(self) -> Any:
        """Position along the axis [m]."""
        ...
    def GetJointSpeed(self) -> Any:
        """Speed along the axis [m/s]."""
        ...
    def GetLocalAxisA(self) -> Any:
        """Axis in body A's frame."""
        ...
    def GetReferenceAngle(self) -> Any:
        """Angle between the bodies [rad]."""
        ...
    def GetAxis(self) -> Any:
        """Axis in the world."""
        ...

class b2PulleyJoint(b2Joint):
    """Two bodies on a rope over two fixed points."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def groundAnchorA(self) -> b2Vec2:
        """Fixed point of the rope to A [m]."""
        ...
    @property
    def groundAnchorB(self) -> b2Vec2:
        """Fixed point of the rope to B [m]."""
        ...
    @property
    def lengthA(self) -> float:
        """Length of the rope to A [m]."""
        ...
    @property
    def lengthB(self) -> float:
        """Length of the rope to B [m]."""
        ...
    @property
    def length1(self) -> float:
        """As lengthA [m]."""
        ...
    @property
    def length2(self) -> float:
        """As lengthB [m]."""
        ...
    @property
    def currentLengthA(self) -> float:
        """As lengthA [m]."""
        ...
    @property
    def currentLengthB(self) -> float:
        """As lengthB [m]."""
        ...
    @property
    def ratio(self) -> float:
        """Factor of the length to B."""
        ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetGroundAnchorA(self) -> Any:
        """Fixed point of the rope to A [m]."""
        ...
    def GetGroundAnchorB(self) -> Any:
        """Fixed point of the rope to B [m]."""
        ...
    def GetLengthA(self) -> Any:
        """Length of the rope to A [m]."""
        ...
    def GetLengthB(self) -> Any:
        """Length of the rope to B [m]."""
        ...
    def GetLength1(self) -> Any:
        """As lengthA [m]."""
        ...
    def GetLength2(self) -> Any:
        """As lengthB [m]."""
        ...
    def GetCurrentLengthA(self) -> Any:
        """As lengthA [m]."""
        ...
    def GetCurrentLengthB(self) -> Any:
        """As lengthB [m]."""
        ...
    def GetRatio(self) -> Any:
        """Factor of the length to B."""
        ...

class b2RevoluteJoint(b2Joint):
    """A hinge: the bodies share a point."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def limitEnabled(self) -> bool:
        """True if the limits are enabled."""
        ...
    @limitEnabled.setter
    def limitEnabled(self, value: bool) -> None: ...
    @property
    def lowerLimit(self) -> float:
        """Lower limit of the angle [rad]."""
        ...
    @lowerLimit.setter
    def lowerLimit(self, value: float) -> None: ...
    @property
    def upperLimit(self) -> float:
        """Upper limit of the angle [rad]."""
        ...
    @upperLimit.setter
    def upperLimit(self, value: float) -> None: ...
    limits: _Settable[tuple]
    """Both limits, as (lower, upper)."""
    def SetLimits(self, lower: Any, upper: Any) -> None:
        """Sets both limits."""
        ...
    @property
    def motorEnabled(self) -> bool:
        """True if the motor is enabled."""
        ...
    @motorEnabled.setter
    def motorEnabled(self, value: bool) -> None: ...
    @property
    def motorSpeed(self) -> float:
        """Target speed of the motor [rad/s]."""
        ...
    @motorSpeed.setter
    def motorSpeed(self, value: float) -> None: ...
    @property
    def maxMotorTorque(self) -> float:
        """Maximum torque of the motor [N m]."""
        ...
    @maxMotorTorque.setter
    def maxMotorTorque(self, value: float) -> None: ...
    def GetMotorTorque(self, inv_dt: Any) -> float:
        """Returns the torque of the motor [N m] in a step of 1 / inv_dt seconds."""
        ...
    @property
    def speed(self) -> float:
        """Relative angular velocity [rad/s]."""
        ...
    @property
    def angle(self) -> float:
        """Angle of body B relative to body A [rad]."""
        ...
    @property
    def referenceAngle(self) -> float:
        """Angle between the bodies at angle 0 [rad]."""
        ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetLimitEnabled(self) -> Any:
        """True if the limits are enabled."""
        ...
    def IsLimitEnabled(self) -> Any:
        """True if the limits are enabled."""
        ...
    def SetLimitEnabled(self, value: Any) -> Any:
        """True if the limits are enabled."""
        ...
    def EnableLimit(self, value: Any) -> Any:
        """True if the limits are enabled."""
        ...
    def GetLowerLimit(self) -> Any:
        """Lower limit of the angle [rad]."""
        ...
    def SetLowerLimit(self, value: Any) -> Any:
        """Lower limit of the angle [rad]."""
        ...
    def GetUpperLimit(self) -> Any:
        """Upper limit of the angle [rad]."""
        ...
    def SetUpperLimit(self, value: Any) -> Any:
        """Upper limit of the angle [rad]."""
        ...
    def GetLimits(self) -> Any:
        """Both limits, as (lower, upper)."""
        ...
    def GetMotorEnabled(self) -> Any:
        """True if the motor is enabled."""
        ...
    def IsMotorEnabled(self) -> Any:
        """True if the motor is enabled."""
        ...
    def SetMotorEnabled(self, value: Any) -> Any:
        """True if the motor is enabled."""
        ...
    def EnableMotor(self, value: Any) -> Any:
        """True if the motor is enabled."""
        ...
    def GetMotorSpeed(self) -> Any:
        """Target speed of the motor [rad/s]."""
        ...
    def SetMotorSpeed(self, value: Any) -> Any:
        """Target speed of the motor [rad/s]."""
        ...
    def GetMaxMotorTorque(self) -> Any:
        """Maximum torque of the motor [N m]."""
        ...
    def SetMaxMotorTorque(self, value: Any) -> Any:
        """Maximum torque of the motor [N m]."""
        ...
    def GetJointSpeed(self) -> Any:
        """Relative angular velocity [rad/s]."""
        ...
    def GetJointAngle(self) -> Any:
        """Angle of body B relative to body A [rad]."""
        ...
    def GetReferenceAngle(self) -> Any:
        """Angle between the bodies at angle 0 [rad]."""
        ...

class b2RopeJoint(b2Joint):
    """Limits the distance of two anchors."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def maxLength(self) -> float:
        """Maximum length [m]."""
        ...
    @maxLength.setter
    def maxLength(self, value: float) -> None: ...
    @property
    def limitState(self) -> int:
        """e_atUpperLimit while the rope is taut."""
        ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetMaxLength(self) -> Any:
        """Maximum length [m]."""
        ...
    def SetMaxLength(self, value: Any) -> Any:
        """Maximum length [m]."""
        ...
    def GetLimitState(self) -> Any:
        """e_atUpperLimit while the rope is taut."""
        ...

class b2WeldJoint(b2Joint):
    """Fixes two bodies to each other."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def frequency(self) -> float:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    @frequency.setter
    def frequency(self, value: float) -> None: ...
    @property
    def dampingRatio(self) -> float:
        """Damping ratio of the spring; 1 is critical."""
        ...
    @dampingRatio.setter
    def dampingRatio(self, value: float) -> None: ...
    @property
    def referenceAngle(self) -> float:
        """Angle between the bodies [rad]."""
        ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetFrequency(self) -> Any:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    def SetFrequency(self, value: Any) -> Any:
        """Frequency of the spring [Hz]; 0: rigid."""
        ...
    def GetDampingRatio(self) -> Any:
        """Damping ratio of the spring; 1 is critical."""
        ...
    def SetDampingRatio(self, value: Any) -> Any:
        """Damping ratio of the spring; 1 is critical."""
        ...
    def GetReferenceAngle(self) -> Any:
        """Angle between the bodies [rad]."""
        ...

class b2WheelJoint(b2Joint):
    """A wheel with a suspension."""
    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    @property
    def localAnchorA(self) -> b2Vec2:
        """Anchor in body A's frame [m]."""
        ...
    @property
    def localAnchorB(self) -> b2Vec2:
        """Anchor in body B's frame [m]."""
        ...
    @property
    def motorEnabled(self) -> bool:
        """True if the motor is enabled."""
        ...
    @motorEnabled.setter
    def motorEnabled(self, value: bool) -> None: ...
    @property
    def motorSpeed(self) -> float:
        """Target speed of the motor [rad/s]."""
        ...
    @motorSpeed.setter
    def motorSpeed(self, value: float) -> None: ...
    @property
    def maxMotorTorque(self) -> float:
        """Maximum torque of the motor [N m]."""
        ...
    @maxMotorTorque.setter
    def maxMotorTorque(self, value: float) -> None: ...
    def GetMotorTorque(self, inv_dt: Any) -> float:
        """Returns the torque of the motor [N m] in a step of 1 / inv_dt seconds."""
        ...
    @property
    def speed(self) -> float:
        """Relative angular velocity [rad/s]."""
        ...
    @property
    def translation(self) -> float:
        """Position along the axis [m]."""
        ...
    @property
    def localAxisA(self) -> b2Vec2:
        """Axis in body A's frame."""
        ...
    @property
    def springFrequencyHz(self) -> float:
        """Frequency of the suspension [Hz]; 0: none."""
        ...
    @springFrequencyHz.setter
    def springFrequencyHz(self, value: float) -> None: ...
    @property
    def springDampingRatio(self) -> float:
        """Damping ratio of the suspension; 1 is critical."""
        ...
    @springDampingRatio.setter
    def springDampingRatio(self, value: float) -> None: ...
    def GetLocalAnchorA(self) -> Any:
        """Anchor in body A's frame [m]."""
        ...
    def GetLocalAnchorB(self) -> Any:
        """Anchor in body B's frame [m]."""
        ...
    def GetMotorEnabled(self) -> Any:
        """True if the motor is enabled."""
        ...
    def IsMotorEnabled(self) -> Any:
        """True if the motor is enabled."""
        ...
    def SetMotorEnabled(self, value: Any) -> Any:
        """True if the motor is enabled."""
        ...
    def EnableMotor(self, value: Any) -> Any:
        """True if the motor is enabled."""
        ...
    def GetMotorSpeed(self) -> Any:
        """Target speed of the motor [rad/s]."""
        ...
    def SetMotorSpeed(self, value: Any) -> Any:
        """Target speed of the motor [rad/s]."""
        ...
    def GetMaxMotorTorque(self) -> Any:
        """Maximum torque of the motor [N m]."""
        ...
    def SetMaxMotorTorque(self, value: Any) -> Any:
        """Maximum torque of the motor [N m]."""
        ...
    def GetJointSpeed(self) -> Any:
        """Relative angular velocity [rad/s]."""
        ...
    def GetJointTranslation(self) -> Any:
        """Position along the axis [m]."""
        ...
    def GetLocalAxisA(self) -> Any:
        """Axis in body A's frame."""
        ...
    def GetSpringFrequencyHz(self) -> Any:
        """Frequency of the suspension [Hz]; 0: none."""
        ...
    def SetSpringFrequencyHz(self, value: Any) -> Any:
        """Frequency of the suspension [Hz]; 0: none."""
        ...
    def GetSpringDampingRatio(self) -> Any:
        """Damping ratio of the suspension; 1 is critical."""
        ...
    def SetSpringDampingRatio(self, value: Any) -> Any:
        """Damping ratio of the suspension; 1 is critical."""
        ...

class Error(Exception):
    """A file, codec or driver that cannot be used. The text names it and the remedy. `kind` is unusable (wrong name or settings), different, absent (a library) or failed (reading or writing). `culprit` is the argument or file at fault. `problem` and `remedy` may be empty."""
    kind: str
    culprit: str
    problem: str
    remedy: str

class b2GearJointDef(b2JointDef):
    """Definition of a gear; without bodies it takes those that its joints move."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    joint1: Any
    joint2: Any
    ratio: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    type: int

class b2MotorJointDef(b2JointDef):
    """Definition of a motor joint; without offsets it keeps the current ones."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    linearOffset: Any
    angularOffset: float
    maxForce: float
    maxTorque: float
    correctionFactor: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    def Initialize(self, bodyA: Any, bodyB: Any) -> Any:
        """Sets the bodies; their offsets now are the target."""
        ...
    type: int

class b2RopeJointDef(b2JointDef):
    """Definition of a rope."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    maxLength: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    type: int

class b2DistanceJointDef(b2JointDef):
    """Definition of a distance joint; without a length it keeps that of the anchors."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    length: float
    frequencyHz: float
    dampingRatio: float
    minLength: float
    maxLength: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    def Initialize(self, bodyA: Any, bodyB: Any, anchorA: Any, anchorB: Any) -> Any:
        """Sets the bodies and an anchor on each in the world [m]; their distance now is the length."""
        ...
    type: int

class b2FrictionJointDef(b2JointDef):
    """Definition of a friction joint."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    maxForce: float
    maxTorque: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    @property
    def anchor(self) -> Any:
        """The point that both anchors are at, in the world [m]."""
        ...
    @anchor.setter
    def anchor(self, value: Any) -> None: ...
    def Initialize(self, bodyA: Any, bodyB: Any, anchor: Any) -> Any:
        """Sets the bodies and a common anchor in the world [m]; their angle now is the reference."""
        ...
    type: int

class b2PulleyJointDef(b2JointDef):
    """Definition of a pulley; without lengths it keeps those of the anchors."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    groundAnchorA: Any
    groundAnchorB: Any
    lengthA: float
    lengthB: float
    ratio: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    def Initialize(self, bodyA: Any, bodyB: Any, groundAnchorA: Any, groundAnchorB: Any, anchorA: Any, anchorB: Any, ratio: Any) -> Any:
        """Sets the bodies, the fixed points, an anchor on each body in the world [m], and the ratio."""
        ...
    type: int

class b2RevoluteJointDef(b2JointDef):
    """Definition of a hinge."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    referenceAngle: float
    enableLimit: bool
    lowerAngle: float
    upperAngle: float
    enableMotor: bool
    motorSpeed: float
    maxMotorTorque: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    @property
    def anchor(self) -> Any:
        """The point that both anchors are at, in the world [m]."""
        ...
    @anchor.setter
    def anchor(self, value: Any) -> None: ...
    def Initialize(self, bodyA: Any, bodyB: Any, anchor: Any) -> Any:
        """Sets the bodies and a common anchor in the world [m]; their angle now is the reference."""
        ...
    type: int

class b2TypeError(Exception):
    """An argument of a wrong type."""

class b2WeldJointDef(b2JointDef):
    """Definition of a weld."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    referenceAngle: float
    frequencyHz: float
    dampingRatio: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    @property
    def anchor(self) -> Any:
        """The point that both anchors are at, in the world [m]."""
        ...
    @anchor.setter
    def anchor(self, value: Any) -> None: ...
    def Initialize(self, bodyA: Any, bodyB: Any, anchor: Any) -> Any:
        """Sets the bodies and a common anchor in the world [m]; their angle now is the reference."""
        ...
    type: int

class b2Error(Exception):
    """What the engine refuses: a number out of range, an object that was destroyed, a change of a locked world. Derived from the exceptions that programs catch for these."""

class b2PrismaticJointDef(b2JointDef):
    """Definition of a slider."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    localAxisA: Any
    referenceAngle: float
    enableLimit: bool
    lowerTranslation: float
    upperTranslation: float
    enableMotor: bool
    maxMotorForce: float
    motorSpeed: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    @property
    def anchor(self) -> Any:
        """The point that both anchors are at, in the world [m]."""
        ...
    @anchor.setter
    def anchor(self, value: Any) -> None: ...
    def Initialize(self, bodyA: Any, bodyB: Any, anchor: Any, axis: Any) -> Any:
        """Sets the bodies, a common anchor [m] and the axis, both in the world; their angle now is the reference."""
        ...
    @property
    def axis(self) -> Any:
        """The axis in the world."""
        ...
    @axis.setter
    def axis(self, value: Any) -> None: ...
    type: int

class b2WheelJointDef(b2JointDef):
    """Definition of a wheel with a suspension."""
    bodyA: Any
    bodyB: Any
    collideConnected: bool
    localAnchorA: Any
    localAnchorB: Any
    localAxisA: Any
    enableMotor: bool
    maxMotorTorque: float
    motorSpeed: float
    frequencyHz: float
    dampingRatio: float
    userData: Any
    def __init__(self, *values: Any, **keywords: Any) -> None:
        """Initialize self.  See help(type(self)) for accurate signature."""
        ...
    def to_kwargs(self) -> Any:
        """Returns the fields by name: type(definition)(**definition.to_kwargs()) is an equal definition."""
        ...
    @property
    def anchorA(self) -> Any:
        """Anchor on body A, in the world [m]."""
        ...
    @anchorA.setter
    def anchorA(self, value: Any) -> None: ...
    @property
    def anchorB(self) -> Any:
        """Anchor on body B, in the world [m]."""
        ...
    @anchorB.setter
    def anchorB(self, value: Any) -> None: ...
    @property
    def anchor(self) -> Any:
        """The point that both anchors are at, in the world [m]."""
        ...
    @anchor.setter
    def anchor(self, value: Any) -> None: ...
    def Initialize(self, bodyA: Any, bodyB: Any, anchor: Any, axis: Any) -> Any:
        """Sets the bodies, a common anchor [m] and the axis, both in the world; their angle now is the reference."""
        ...
    @property
    def axis(self) -> Any:
        """The axis in the world."""
        ...
    @axis.setter
    def axis(self, value: Any) -> None: ...
    type: int
RAND_LIMIT: int
def b2Abs(a: Any) -> Any:
    """Returns the absolute value of a number, or of each component."""
    ...
def b2Atan2(y: Any, x: Any) -> float:
    """Returns the angle of the vector (x, y) [rad]."""
    ...
def b2BodyCompare(a: Any, b: Any) -> Any:
    """True if both are the same b2Body."""
    ...
def b2CheckPolygon(shape: Any, additional_checks: Any = ...) -> Any:
    """Returns True for a convex polygon with an area, else raises an error that says what it lacks."""
    ...
def b2Clamp(a: Any, low: Any, high: Any) -> Any:
    """Returns `a` limited to [low, high], of each component for vectors."""
    ...
def b2ClipSegmentToLine(vIn: Any, normal: Any, offset: Any, vertexIndexA: Any = ...) -> Any:
    """Clips a segment, two b2ClipVertex or points, to dot(normal, p) <= offset [m]. Returns its ends as b2ClipVertex: two, or none if it is outside."""
    ...
def b2CollideCircles(*args: Any, **kwargs: Any) -> Any: ...
def b2CollideEdgeAndCircle(*args: Any, **kwargs: Any) -> Any: ...
def b2CollideEdgeAndPolygon(*args: Any, **kwargs: Any) -> Any: ...
def b2CollidePolygonAndCircle(*args: Any, **kwargs: Any) -> Any: ...
def b2CollidePolygons(*args: Any, **kwargs: Any) -> Any: ...
def b2Cross(a: Any, b: Any) -> Any:
    """Returns the cross product of vectors and numbers."""
    ...
def b2Distance(*arguments: Any, **keywords: Any) -> Any:
    """Returns the closest points of two shapes: b2Distance(b2DistanceInput), or b2Distance(shapeA=, idxA=0, shapeB=, idxB=0, transformA=, transformB=, useRadii=True). Given two points, returns their distance [m]."""
    ...
def b2DistanceSquared(a: Any, b: Any) -> float:
    """Returns the squared distance of two points [m^2]."""
    ...
def b2Dot(a: Any, b: Any) -> float:
    """Returns the dot product."""
    ...
def b2FixtureCompare(a: Any, b: Any) -> Any:
    """True if both are the same b2Fixture."""
    ...
def b2GetPointStates(manifold1: Any, manifold2: Any) -> tuple:
    """Returns the states of both manifolds' points: (state1, state2)."""
    ...
b2Globals: Any
def b2InvSqrt(x: Any) -> float:
    """Returns one over the square root."""
    ...
def b2IsPowerOfTwo(x: Any) -> bool:
    """True if x is a power of two."""
    ...
def b2IsValid(x: Any) -> bool:
    """True if the number is finite."""
    ...
def b2JointCompare(a: Any, b: Any) -> Any:
    """True if both are the same b2Joint."""
    ...
def b2Max(a: Any, b: Any) -> Any:
    """Returns the maximum, of each component for vectors."""
    ...
def b2Min(a: Any, b: Any) -> Any:
    """Returns the minimum, of each component for vectors."""
    ...
def b2MixFriction(friction1: Any, friction2: Any) -> float:
    """Returns the friction of a contact of two fixtures."""
    ...
def b2MixRestitution(restitution1: Any, restitution2: Any) -> float:
    """Returns the restitution of a contact of two fixtures."""
    ...
def b2Mul(a: Any, b: Any) -> Any:
    """Returns a b, for transforms, rotations and matrices."""
    ...
def b2Mul22(A: b2Mat33, v: Any) -> b2Vec2:
    """Returns the upper left block of A times v."""
    ...
def b2MulT(a: Any, b: Any) -> Any:
    """Returns the inverse of a times b."""
    ...
def b2NextPowerOfTwo(x: Any) -> int:
    """Returns the smallest power of two above x."""
    ...
def b2Random(lo: Any = ..., hi: Any = ...) -> Any:
    """Returns a random number from `lo` to `hi`, by Python's module random: random.seed makes it repeat."""
    ...
def b2ShapeCompare(a: Any, b: Any) -> Any:
    """True if both are the same b2Shape."""
    ...
def b2Sqrt(x: Any) -> float:
    """Returns the square root."""
    ...
def b2TestOverlap(*args: Any, **kwargs: Any) -> Any: ...
def b2TimeOfImpact(shapeA: Any = ..., idxA: Any = ..., shapeB: Any = ..., idxB: Any = ..., sweepA: Any = ..., sweepB: Any = ..., tMax: Any = ...) -> Any:
    """Returns (state, t) of two moving shapes, or of a b2TOIInput. The states are those of b2TOIOutput."""
    ...
b2_aabbExtension: float
b2_aabbMultiplier: float
b2_addState: int
b2_angularSleepTolerance: float
b2_angularSlop: float
b2_baumgarte: float
b2_blockSizes: int
b2_chunkArrayIncrement: int
b2_chunkSize: int
b2_dynamicBody: int
b2_epsilon: float
b2_kinematicBody: int
b2_linearSleepTolerance: float
b2_linearSlop: float
b2_maxAngularCorrection: float
b2_maxBlockSize: int
b2_maxFloat: float
b2_maxLinearCorrection: float
b2_maxManifoldPoints: int
b2_maxPolygonVertices: int
b2_maxRotation: float
b2_maxRotationSquared: float
b2_maxStackEntries: int
b2_maxSubSteps: int
b2_maxTOIContacts: int
b2_maxTranslation: float
b2_maxTranslationSquared: float
b2_minPulleyLength: float
b2_nullFeature: int
b2_nullState: int
b2_persistState: int
b2_pi: float
b2_polygonRadius: float
b2_removeState: int
b2_stackSize: int
b2_staticBody: int
b2_timeToSleep: float
b2_toiBaugarte: float
b2_velocityThreshold: float
b2_version: Any
e_atLowerLimit: int
e_atUpperLimit: int
e_distanceJoint: int
e_equalLimits: int
e_frictionJoint: int
e_gearJoint: int
e_inactiveLimit: int
e_motorJoint: int
e_mouseJoint: int
e_prismaticJoint: int
e_pulleyJoint: int
e_revoluteJoint: int
e_ropeJoint: int
e_unknownJoint: int
e_weldJoint: int
e_wheelJoint: int
