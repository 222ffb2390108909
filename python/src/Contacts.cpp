// SPDX-License-Identifier: MIT
#include "Module.h"
#include "WorldObject.h"

/// Contacts. A step may destroy any of them, so each use checks that the contact still exists.
namespace boxreel::python
{
namespace
{

struct ContactHandle
{
    std::shared_ptr<WorldLink> link;
    b2Contact* contact;
    const b2Fixture* fixtureA; ///< to recognize the contact, not used otherwise
    const b2Fixture* fixtureB;
    mutable std::uint64_t epoch; ///< of the world, when it was last known to exist

    WorldObject& World() const
    {
        if (link->world == nullptr)
        {
            ThrowMisuse("the world of this contact was destroyed");
        }
        link->world->RequireThread();
        return *link->world;
    }

    b2Contact& Get() const
    {
        WorldObject& world = World();
        if (epoch == world.epoch)
        {
            return *contact;
        }
        for (b2Contact* other = world.world.GetContactList(); other != nullptr;
             other = other->GetNext())
        {
            if (other == contact && other->GetFixtureA() == fixtureA &&
                other->GetFixtureB() == fixtureB)
            {
                epoch = world.epoch;
                return *contact;
            }
        }
        ThrowMisuse("this contact no longer exists");
    }

    using Object = b2Contact;
};

b2WorldManifold WorldManifoldOf(const b2Contact& contact)
{
    b2WorldManifold manifold;
    contact.GetWorldManifold(&manifold);
    return manifold;
}

template <class Class>
void ContactProperties(Class& type)
{
    Property(type, "enabled", &b2Contact::IsEnabled, &b2Contact::SetEnabled,
             "False if disabled for this step. Set it in PreSolve.");
    Property(type, "friction", &b2Contact::GetFriction, &b2Contact::SetFriction,
             "Friction, 0 or more.");
    Property(type, "restitution", &b2Contact::GetRestitution, &b2Contact::SetRestitution,
             "Restitution, 0 or more.");
    Property(type, "tangentSpeed", &b2Contact::GetTangentSpeed, &b2Contact::SetTangentSpeed,
             "Surface speed of a conveyor belt [m/s].");
    ReadOnly(type, "touching", &b2Contact::IsTouching, "True if the shapes overlap.");
    ReadOnly(type, "childIndexA", &b2Contact::GetChildIndexA, "Child of the first shape, from 0.");
    ReadOnly(type, "childIndexB", &b2Contact::GetChildIndexB, "Child of the second shape, from 0.");
    ReadOnly(type, "worldManifold", WorldManifoldOf, "The manifold in the world.");
}

} // namespace

py::object WrapContact(WorldObject& world, b2Contact* contact)
{
    if (contact == nullptr)
    {
        return py::none();
    }
    return py::cast(ContactHandle{world.link, contact, contact->GetFixtureA(),
                                  contact->GetFixtureB(), world.epoch});
}

void BindContacts(py::module_& module)
{
    py::class_<ContactHandle> type(module, "b2Contact", "Two fixtures whose boxes overlap.");
    ContactProperties(type);
    type.def_property_readonly(
            "fixtureA",
            [](const ContactHandle& h) { return Wrap(h.World(), h.Get().GetFixtureA()); },
            "The first fixture.")
        .def_property_readonly(
            "fixtureB",
            [](const ContactHandle& h) { return Wrap(h.World(), h.Get().GetFixtureB()); },
            "The second fixture.")
        .def_property_readonly(
            "manifold", [](const ContactHandle& h) { return b2Manifold(*h.Get().GetManifold()); },
            "The manifold in the frames of the bodies.")
        .def_property_readonly(
            "next",
            [](const ContactHandle& h) { return WrapContact(h.World(), h.Get().GetNext()); },
            "The contact created before this one, or None.")
        .def(
            "ResetFriction", [](const ContactHandle& h) { h.Get().ResetFriction(); },
            "Restores the mixed friction.")
        .def(
            "ResetRestitution", [](const ContactHandle& h) { h.Get().ResetRestitution(); },
            "Restores the mixed restitution.")
        .def("__eq__",
             [](const ContactHandle& a, py::handle b) {
                 return py::isinstance<ContactHandle>(b) &&
                        b.cast<ContactHandle&>().contact == a.contact;
             })
        .def("__hash__", [](const ContactHandle& h) { return std::hash<void*>()(h.contact); });
}

} // namespace boxreel::python
