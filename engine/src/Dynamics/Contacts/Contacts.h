// SPDX-License-Identifier: MIT
#pragma once

struct b2FixtureProxy;
class b2Contact;

/// Contacts of a world: found, updated and destroyed.
namespace box2d
{

class World;

/// Between the proxies that have moved and all others.
void FindNewContacts(World& world);
/// Updates all awake contacts.
void UpdateContacts(World& world);
void UpdateContact(World& world, b2Contact& contact);
/// The newest of the world and its bodies, between children of fixtures.
b2Contact& AddContact(World& world, const b2FixtureProxy& a, const b2FixtureProxy& b);
void DestroyContact(World& world, b2Contact& contact);

} // namespace box2d
