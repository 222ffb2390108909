// SPDX-License-Identifier: MIT
#include "Definitions.h"
#include "Module.h"
#include "Shapes.h"
#include "WorldObject.h"

/// Bodies and fixtures.
namespace boxreel::python
{
namespace
{

b2Body& BodyOf(const BodyHandle& handle)
{
    return handle.Get();
}

b2MassData MassDataOf(const b2Body& body)
{
    b2MassData data;
    body.GetMassData(&data);
    return data;
}

/// Adds a property for a part of the mass data of a body. Conversions come before the use of the
/// body here and below, because they may run code that destroys it.
template <auto member>
void MassPart(py::class_<BodyHandle>& type, const char* name, const char* doc)
{
    using T = std::remove_cvref_t<decltype(b2MassData().*member)>;
    type.def_property(
        name, [](const BodyHandle& h) -> T { return MassDataOf(h.Get()).*member; },
        [name](BodyHandle& h, py::handle value) {
            const T part = From<T>(value, name);
            b2Body& body = h.Get();
            b2MassData data = MassDataOf(body);
            data.*member = part;
            body.SetMassData(&data);
            CheckMisuse();
        },
        doc);
}

py::list FixturesOf(const BodyHandle& handle)
{
    const WithoutCollector wholeList;
    py::list fixtures;
    for (b2Fixture* fixture = handle.Get().GetFixtureList(); fixture != nullptr;
         fixture = fixture->GetNext())
    {
        fixtures.append(Wrap(*handle.world, fixture));
    }
    fixtures.attr("reverse")(); // in the order of creation
    return fixtures;
}

/// Returns (other body, joint or contact) of each edge, in the order of creation.
template <class Edge, class WrapItem>
py::list EdgesOf(const BodyHandle& handle, Edge* first, WrapItem wrap)
{
    const WithoutCollector wholeList;
    py::list edges;
    for (Edge* edge = first; edge != nullptr; edge = edge->next)
    {
        edges.append(py::make_tuple(Wrap(*handle.world, edge->other), wrap(edge)));
    }
    edges.attr("reverse")();
    return edges;
}

void SetTransform(BodyHandle& handle, const b2Vec2& position, float32 angle)
{
    b2Body& body = handle.Get();
    handle.world->RequireUnlocked("setting the transform of a body");
    body.SetTransform(position, angle);
    CheckMisuse();
}

void BindMotion(py::class_<BodyHandle>& type)
{
    type.def_property(
            "position", [](const BodyHandle& h) { return BodyOf(h).GetPosition(); },
            [](BodyHandle& h, py::handle value) {
                SetTransform(h, From<b2Vec2>(value, "position"), BodyOf(h).GetAngle());
            },
            "Position of the origin [m].")
        .def_property(
            "angle", [](const BodyHandle& h) { return BodyOf(h).GetAngle(); },
            [](BodyHandle& h, py::handle value) {
                SetTransform(h, BodyOf(h).GetPosition(), From<float32>(value, "angle"));
            },
            "Angle, counter-clockwise [rad]. It grows with every turn.")
        .def_property(
            "transform", [](const BodyHandle& h) { return BodyOf(h).GetTransform(); },
            [](BodyHandle& h, py::handle value) {
                if (!py::isinstance<b2Transform>(value) && PySequence_Check(value.ptr()) &&
                    py::len(value) == 2)
                {
                    const py::sequence pair = py::reinterpret_borrow<py::sequence>(value);
                    SetTransform(h, From<b2Vec2>(py::object(pair[0]), "transform"),
                                 From<float32>(py::object(pair[1]), "transform"));
                    return;
                }
                const b2Transform xf = From<b2Transform>(value, "transform");
                SetTransform(h, xf.p, xf.q.GetAngle());
            },
            "Transform from the body to the world. May be set to (position, angle) [m, rad].")
        .def(
            "SetTransform",
            [](BodyHandle& h, py::handle position, py::handle angle) {
                SetTransform(h, From<b2Vec2>(position, "position"), From<float32>(angle, "angle"));
            },
            py::arg("position"), py::arg("angle"), "Sets position [m] and angle [rad].");
    ReadOnly(type, "worldCenter", &b2Body::GetWorldCenter, "Centre of mass in the world [m].");
    Property(type, "linearVelocity", &b2Body::GetLinearVelocity, &b2Body::SetLinearVelocity,
             "Velocity of the centre of mass [m/s].");
    Property(type, "angularVelocity", &b2Body::GetAngularVelocity, &b2Body::SetAngularVelocity,
             "Angular velocity, counter-clockwise [rad/s].");
    Property(type, "linearDamping", &b2Body::GetLinearDamping, &b2Body::SetLinearDamping,
             "Decay rate of the linear velocity [1/s].");
    Property(type, "angularDamping", &b2Body::GetAngularDamping, &b2Body::SetAngularDamping,
             "Decay rate of the angular velocity [1/s].");
    Property(type, "gravityScale", &b2Body::GetGravityScale, &b2Body::SetGravityScale,
             "Factor of the world's gravity.");
    Property(type, "type", &b2Body::GetType, &b2Body::SetType,
             "b2_staticBody, b2_kinematicBody or b2_dynamicBody.");
    Property(type, "bullet", &b2Body::IsBullet, &b2Body::SetBullet,
             "True for continuous collision against dynamic bodies too.");
    Property(type, "sleepingAllowed", &b2Body::IsSleepingAllowed, &b2Body::SetSleepingAllowed,
             "True if it may fall asleep.");
    Property(type, "awake", &b2Body::IsAwake, &b2Body::SetAwake, "True if awake.");
    Property(type, "active", &b2Body::IsActive, &b2Body::SetActive,
             "True if it takes part in collision and dynamics.");
    Property(type, "fixedRotation", &b2Body::IsFixedRotation, &b2Body::SetFixedRotation,
             "True if it never rotates.");
}

void BindMass(py::class_<BodyHandle>& type)
{
    MassPart<&b2MassData::mass>(type, "mass", "Mass [kg]; 0 for static and kinematic bodies.");
    MassPart<&b2MassData::I>(type, "inertia", "Rotational inertia about the origin [kg m^2].");
    MassPart<&b2MassData::center>(type, "localCenter", "Centre of mass in the body's frame [m].");
    type.def_property(
            "massData", [](const BodyHandle& h) { return MassDataOf(BodyOf(h)); },
            [](BodyHandle& h, py::handle value) {
                const b2MassData data = From<b2MassData>(value, "massData");
                BodyOf(h).SetMassData(&data);
                CheckMisuse();
            },
            "Mass, centre and rotational inertia.")
        .def(
            "ResetMassData",
            [](BodyHandle& h) {
                BodyOf(h).ResetMassData();
                CheckMisuse();
            },
            "Computes the mass data from the fixtures.");
}

void BindForces(py::class_<BodyHandle>& type)
{
    const auto atPoint = [&type](const char* name,
                                 void (b2Body::*apply)(const b2Vec2&, const b2Vec2&, bool),
                                 const char* amount, const char* doc) {
        type.def(
            name,
            [apply, amount](BodyHandle& h, py::handle vector, py::handle point, py::handle wake) {
                const b2Vec2 value = From<b2Vec2>(vector, amount);
                const b2Vec2 place = From<b2Vec2>(point, "point");
                const bool wakes = From<bool>(wake, "wake");
                (BodyOf(h).*apply)(value, place, wakes);
                CheckMisuse();
            },
            py::arg(amount), py::arg("point"), py::arg("wake") = true, doc);
    };
    atPoint("ApplyForce", &b2Body::ApplyForce, "force",
            "Applies a force [N] at a world point [m] in the next step.");
    atPoint("ApplyLinearImpulse", &b2Body::ApplyLinearImpulse, "impulse",
            "Applies an impulse [N s] at a world point [m]; changes the velocity at once.");
    const auto atCenter = [&type](const char* name, void (b2Body::*apply)(const b2Vec2&, bool),
                                  const char* amount, const char* doc) {
        type.def(
            name,
            [apply, amount](BodyHandle& h, py::handle vector, py::handle wake) {
                const b2Vec2 value = From<b2Vec2>(vector, amount);
                const bool wakes = From<bool>(wake, "wake");
                (BodyOf(h).*apply)(value, wakes);
                CheckMisuse();
            },
            py::arg(amount), py::arg("wake") = true, doc);
    };
    atCenter("ApplyForceToCenter", &b2Body::ApplyForceToCenter, "force",
             "Applies a force [N] at the centre of mass in the next step.");
    atCenter("ApplyLinearImpulseToCenter", &b2Body::ApplyLinearImpulseToCenter, "impulse",
             "Applies an impulse [N s] at the centre of mass; changes the velocity at once.");
    const auto turning = [&type](const char* name, void (b2Body::*apply)(float32, bool),
                                 const char* amount, const char* doc) {
        type.def(
            name,
            [apply, amount](BodyHandle& h, py::handle number, py::handle wake) {
                const float32 value = From<float32>(number, amount);
                const bool wakes = From<bool>(wake, "wake");
                (BodyOf(h).*apply)(value, wakes);
                CheckMisuse();
            },
            py::arg(amount), py::arg("wake") = true, doc);
    };
    turning("ApplyTorque", &b2Body::ApplyTorque, "torque",
            "Applies a torque [N m] in the next step.");
    turning("ApplyAngularImpulse", &b2Body::ApplyAngularImpulse, "impulse",
            "Applies an angular impulse [N m s]; changes the angular velocity at once.");
}

void BindFrames(py::class_<BodyHandle>& type)
{
    const auto convert = [&type](const char* name, b2Vec2 (b2Body::*function)(const b2Vec2&) const,
                                 const char* argument, const char* doc) {
        type.def(
            name,
            [function, argument](const BodyHandle& h, py::handle vector) {
                const b2Vec2 value = From<b2Vec2>(vector, argument);
                return (BodyOf(h).*function)(value);
            },
            py::arg(argument), doc);
    };
    convert("GetWorldPoint", &b2Body::GetWorldPoint, "localPoint",
            "Converts a point to the world [m].");
    convert("GetWorldVector", &b2Body::GetWorldVector, "localVector",
            "Rotates a vector to the world.");
    convert("GetLocalPoint", &b2Body::GetLocalPoint, "worldPoint",
            "Converts a point to the body's frame [m].");
    convert("GetLocalVector", &b2Body::GetLocalVector, "worldVector",
            "Rotates a vector to the body's frame.");
    convert("GetLinearVelocityFromWorldPoint", &b2Body::GetLinearVelocityFromWorldPoint,
            "worldPoint", "Returns the velocity [m/s] of the body at a world point [m].");
    convert("GetLinearVelocityFromLocalPoint", &b2Body::GetLinearVelocityFromLocalPoint,
            "localPoint", "Returns the velocity [m/s] of a point of the body [m].");
}

void BindBody(py::module_& module)
{
    py::class_<BodyHandle> type(
        module, "b2Body", py::dynamic_attr(), HandleTraversal(),
        "A rigid body, made by b2World.CreateBody. It keeps attributes of the program.");
    Identity(type);
    UserData(type);
    BindMotion(type);
    BindMass(type);
    BindForces(type);
    BindFrames(type);
    type.def_property_readonly("fixtures", FixturesOf, "The fixtures, in the order of creation.")
        .def_property_readonly("_joint_edges",
                               [](const BodyHandle& h) {
                                   return EdgesOf(h, BodyOf(h).GetJointList(), [&](b2JointEdge* e) {
                                       return Wrap(*h.world, e->joint);
                                   });
                               })
        .def_property_readonly(
            "_contact_edges",
            [](const BodyHandle& h) {
                return EdgesOf(h, BodyOf(h).GetContactList(),
                               [&](b2ContactEdge* e) { return WrapContact(*h.world, e->contact); });
            })
        .def_property_readonly(
            "next", [](const BodyHandle& h) { return Wrap(*h.world, BodyOf(h).GetNext()); },
            "The body created before this one, or None.")
        .def_property_readonly(
            "number", [](const BodyHandle& h) { return BodyOf(h).GetNumber(); },
            "Number in the order of creation, from 0.")
        .def_property_readonly(
            "world",
            [](const BodyHandle& h) {
                BodyOf(h);
                return py::cast(h.world, py::return_value_policy::reference);
            },
            "The world that the body is in.")
        .def("_create_fixture",
             [](BodyHandle& h, const py::dict& fields) {
                 const b2FixtureDef def = FixtureDefFrom(fields);
                 b2Body& body = h.Get();
                 h.world->RequireUnlocked("b2Body.CreateFixture");
                 ++h.world->epoch;
                 b2Fixture* fixture = body.CreateFixture(&def);
                 CheckMisuse();
                 const py::object result = Wrap(*h.world, fixture);
                 result.attr("userData") =
                     fields.contains("userData") ? py::object(fields["userData"]) : py::none();
                 return result;
             })
        .def(
            "DestroyFixture",
            [](BodyHandle& h, FixtureHandle& fixture) {
                b2Body& body = h.Get();
                h.world->DestroyFixture(body, fixture);
            },
            py::arg("fixture"), "Destroys a fixture. It cannot be used afterwards.")
        .def(
            "Dump", [](BodyHandle& h) { BodyOf(h).Dump(); },
            "Writes the body as code of C++ to standard output.")
        .def("__iter__", [](const BodyHandle& h) { return py::iter(FixturesOf(h)); })
        .def("__contains__",
             [](const BodyHandle& h, py::handle item) { return FixturesOf(h).contains(item); });
}

b2Fixture& FixtureOf(const FixtureHandle& handle)
{
    return handle.Get();
}

/// Adds a property for a part of the collision filter.
template <auto member>
void FilterPart(py::class_<FixtureHandle>& type, const char* name, const char* doc)
{
    using T = std::remove_cvref_t<decltype(b2Filter().*member)>;
    type.def_property(
        name, [](const FixtureHandle& h) { return FixtureOf(h).GetFilterData().*member; },
        [name](FixtureHandle& h, py::handle value) {
            const T part = From<T>(value, name);
            b2Filter filter = FixtureOf(h).GetFilterData();
            filter.*member = part;
            FixtureOf(h).SetFilterData(filter);
        },
        doc);
}

void BindFixture(py::module_& module)
{
    py::class_<FixtureHandle> type(
        module, "b2Fixture", py::dynamic_attr(), HandleTraversal(),
        "A shape on a body with its material. It keeps attributes of the program.");
    Identity(type);
    UserData(type);
    Property(type, "density", &b2Fixture::GetDensity, &b2Fixture::SetDensity,
             "Mass per area [kg/m^2]. Call ResetMassData of the body after a change.");
    Property(type, "friction", &b2Fixture::GetFriction, &b2Fixture::SetFriction,
             "Friction, 0 or more.");
    Property(type, "restitution", &b2Fixture::GetRestitution, &b2Fixture::SetRestitution,
             "Restitution, 0 or more.");
    Property(type, "sensor", &b2Fixture::IsSensor, &b2Fixture::SetSensor,
             "True if it reports contacts without a collision response.");
    type.def_property(
        "filterData", [](const FixtureHandle& h) { return FixtureOf(h).GetFilterData(); },
        [](FixtureHandle& h, py::handle value) {
            const b2Filter filter = From<b2Filter>(value, "filterData");
            FixtureOf(h).SetFilterData(filter);
        },
        "The collision filter. What is written to it reaches the fixture.");
    FilterPart<&b2Filter::categoryBits>(type, "categoryBits",
                                        "Categories of the fixture, 0 to 65535.");
    FilterPart<&b2Filter::maskBits>(type, "maskBits",
                                    "Categories that it collides with, 0 to 65535.");
    FilterPart<&b2Filter::groupIndex>(type, "groupIndex",
                                      "Group that always or never collides; 0: none.");
    ReadOnly(type, "type", &b2Fixture::GetType, "Type of the shape.");
    type.def_property_readonly(
            "shape",
            [](const py::object& self) {
                const b2Shape& shape = *FixtureOf(self.cast<FixtureHandle&>()).GetShape();
                return ShapeOfFixture(self, shape);
            },
            "The shape, in the frame of the body. What is written to it reaches the fixture; call "
            "ResetMassData of the body for its mass.")
        .def_property_readonly(
            "body", [](const FixtureHandle& h) { return Wrap(*h.world, FixtureOf(h).GetBody()); },
            "The body that the fixture is on.")
        .def_property_readonly(
            "next", [](const FixtureHandle& h) { return Wrap(*h.world, FixtureOf(h).GetNext()); },
            "The fixture created before this one, or None.")
        .def_property_readonly(
            "massData",
            [](const FixtureHandle& h) {
                b2MassData data;
                FixtureOf(h).GetMassData(&data);
                return Checked(data);
            },
            "Mass, centre and rotational inertia of the shape.")
        .def(
            "Refilter", [](FixtureHandle& h) { FixtureOf(h).Refilter(); },
            "Filters the contacts again in the next step.")
        .def(
            "TestPoint",
            [](const FixtureHandle& h, py::handle p) {
                const b2Vec2 point = From<b2Vec2>(p, "p");
                return FixtureOf(h).TestPoint(point);
            },
            py::arg("p"), "True if the world point [m] is inside.")
        .def(
            "GetAABB",
            [](const FixtureHandle& h, py::handle child) {
                const int32 index = From<int32>(child, "childIndex");
                const b2Fixture& fixture = FixtureOf(h);
                if (index < 0 || index >= fixture.GetShape()->GetChildCount() ||
                    !fixture.GetBody()->IsActive())
                {
                    ThrowMisuse("b2Fixture.GetAABB: there is no box for this child; its body must "
                                "be active");
                }
                return fixture.GetAABB(index);
            },
            py::arg("childIndex") = 0, "Returns the box in the broad phase [m].")
        .def("_ray_cast",
             [](const FixtureHandle& h, const b2RayCastInput& input, py::handle child) {
                 const int32 index = From<int32>(child, "childIndex");
                 const b2Fixture& fixture = FixtureOf(h);
                 if (index < 0 || index >= fixture.GetShape()->GetChildCount())
                 {
                     ThrowMisuse("b2Fixture.RayCast: childIndex is out of range");
                 }
                 b2RayCastOutput output;
                 const bool hit = fixture.RayCast(&output, input, index);
                 return py::make_tuple(hit, output);
             })
        .def(
            "Dump",
            [](FixtureHandle& h, py::handle index) {
                const int32 number = From<int32>(index, "bodyIndex");
                FixtureOf(h).Dump(number);
            },
            py::arg("bodyIndex") = 0, "Writes the fixture as code of C++ to standard output.");
}

/// Returns the fixture behind a weak reference, or null if it was destroyed.
FixtureHandle* FixtureBehind(const py::object& reference)
{
    const py::handle object = PyWeakref_GetObject(reference.ptr());
    if (object.is_none())
    {
        return nullptr;
    }
    auto& handle = object.cast<FixtureHandle&>();
    return handle.world != nullptr ? &handle : nullptr;
}

} // namespace

const b2Shape* LiveShape(const py::object& fixture)
{
    const FixtureHandle* handle = FixtureBehind(fixture);
    return handle != nullptr ? handle->object->GetShape() : nullptr;
}

void SetLiveShape(const py::object& fixture, const b2Shape& shape)
{
    FixtureHandle* handle = FixtureBehind(fixture);
    if (handle == nullptr)
    {
        ThrowMisuse("the fixture of this shape was destroyed, or its world was; it cannot be "
                    "changed");
    }
    handle->world->SetShape(*handle, shape);
}

template <>
b2Filter From<b2Filter>(py::handle value, const char* name)
{
    if (!py::isinstance<b2Filter>(value))
    {
        ThrowType(name, "a b2Filter", value);
    }
    return value.cast<b2Filter&>();
}

void BindBodies(py::module_& module)
{
    BindBody(module);
    BindFixture(module);
}

} // namespace boxreel::python
