// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

class b2Body;
class b2Contact;
class b2Joint;

/// Wakes bodies and puts them to sleep. A step uses only the lists of awake bodies, awake contacts
/// and coloured constraints. These functions keep those lists up to date.
namespace box2d
{

struct BodyData;
struct ContactData;
class World;

/// True for a kinematic body that moves.
bool IsMovingPlatform(const BodyData& body);
/// Wakes the body and its island.
void Wake(World& world, b2Body& body);
/// This one only.
void PutToSleep(World& world, b2Body& body);
void PutToSleep(World& world, int32 island);
/// Puts it into the lists of what a step looks at, or takes it out, as follows from the state of
/// its body or bodies. To be called after any change of that.
void UpdateActivity(World& world, b2Body& body);
void UpdateActivity(World& world, b2Contact& contact);
void UpdateActivity(World& world, b2Joint& joint);
/// Takes the contact out of the list of awake ones.
void RemoveFromAwake(World& world, ContactData& c);
/// Notes for all contacts of that list what stands beside it, after the list was read.
void NoteAwakeContacts(World& world);
/// The next update looks at the contact itself, because its state may have been changed.
void LookAgain(World& world, const ContactData& c);
/// Same as above, and it computes the manifold again.
void ForgetManifold(World& world, ContactData& c);
/// Undoes the first part of an update, where a callback has left no place for the second.
void ForgetUpdate(World& world, ContactData& c);
/// Wakes bodies in contact with, or joined to, a moving body.
void WakeNeighbours(World& world, b2Body& bodyA, b2Body& bodyB);
/// False when WakeNeighbours would do nothing.
bool WakesNeighbours(const BodyData& a, const BodyData& b);
/// After a user change: wakes the body with everything it has contacts or joints with, for contacts
/// between sleeping bodies are not looked at. One that has none sleeps on.
void WakeAttached(World& world, b2Body& body);

} // namespace box2d
