// SPDX-License-Identifier: MIT
#include "Trial.h"

/// A minute in space, where nothing is lost: alone, and held together by joints.
namespace
{

using namespace stability;

STABILITY_SUITE(FreeMotion);

/// Energy and the two momenta of all parts, and what a minute has made of them.
class Books
{
public:
    explicit Books(const Trial& trial)
        : m_trial(trial), m_energy(trial.Kinetic()), m_momentum(trial.Momentum()),
          m_spin(double(trial.Spin()))
    {
        for (const b2Body* b : trial.parts)
        {
            m_mass += double(b->GetMass());
        }
    }

    /// Targets I: 0.1 % of the angular momentum and 0.2 % of the energy; the momentum as a share
    /// of what would be seen, a millimetre a minute.
    void JudgeMinute(const std::string& name, int32 n, bool held) const
    {
        const double energy = 100.0 * std::abs(m_trial.Kinetic() / m_energy - 1.0);
        const double spin = 100.0 * std::abs(double(m_trial.Spin()) / m_spin - 1.0);
        const double speed = double(b2Distance(m_trial.Momentum(), m_momentum)) / m_mass;
        const double gain = 100.0 * (m_trial.Kinetic() / m_energy - 1.0);
        Judge(name + ", energy lost", n, energy, "%", held ? Bound(n, 0.2) : 0.2);
        Judge(name + ", energy won", n, gain, "%", 0.2);
        Judge(name + ", angular momentum lost", n, spin, "%", held ? Bound(n, 0.1) : 0.1);
        Judge(name + ", momentum lost", n, 1000.0 * speed, "mm/s", 0.02);
    }

private:
    const Trial& m_trial;
    double m_energy;
    b2Vec2 m_momentum;
    double m_spin;
    double m_mass = 0.0;
};

TEST_P(FreeMotion, ConservesEnergyAndMomentaOfASpinningBody)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    b2Body* body = trial.Part(0.0f, 0.0f, 1.0f, 0.1f);
    body->SetLinearVelocity(b2Vec2(0.5f, -0.25f));
    body->SetAngularVelocity(7.0f);
    const Books books(trial);
    trial.Run(60.0);
    books.JudgeMinute("free spin, 60 s", GetParam(), false);
    Judge("free spin, 60 s, angle off", GetParam(), std::abs(double(body->GetAngle()) - 7.0 * 60.0),
          "rad", 0.01);
    Judge("free spin, 60 s, place off", GetParam(),
          1000.0 * double(b2Distance(body->GetPosition(), b2Vec2(30.0f, -15.0f))), "mm", 1.0);
}

struct Bond
{
    const char* name;
    void (*make)(Trial& trial, b2Body* a, b2Body* b);
};

void MakeHinge(Trial& t, b2Body* a, b2Body* b)
{
    t.Hinge(a, b, 0.0f, 0.0f);
}
void MakeRod(Trial& t, b2Body* a, b2Body* b)
{
    t.Rod(a, b, b2Vec2(-0.5f, 0.1f), b2Vec2(0.5f, 0.0f));
}
void MakeWeld(Trial& t, b2Body* a, b2Body* b)
{
    t.Weld(a, b, 0.0f, 0.0f);
}
void MakeSlider(Trial& t, b2Body* a, b2Body* b)
{
    b2PrismaticJoint* joint = t.Slider(a, b, 0.0f, 0.0f, b2Vec2(1.0f, 0.0f));
    // A stop is an impact, and takes energy: it is held there from the start.
    joint->EnableLimit(true);
    joint->SetLimits(0.0f, 0.0f);
}
void MakeGear(Trial& t, b2Body* a, b2Body* b)
{
    b2Body* frame = t.Part(0.0f, -0.3f, 1.0f, 0.1f);
    b2GearJointDef def;
    def.joint1 = t.Hinge(frame, a, -0.5f, -0.1f);
    def.joint2 = t.Hinge(frame, b, 0.5f, -0.1f);
    def.bodyA = a;
    def.bodyB = b;
    def.ratio = 2.0f;
    t.world.CreateJoint(&def);
}

TEST_P(FreeMotion, ConservesEnergyAndMomentaOfAJointedPair)
{
    for (const Bond& bond : {Bond{"hinge", MakeHinge}, Bond{"rod", MakeRod}, Bond{"weld", MakeWeld},
                             Bond{"slider at its stop", MakeSlider}, Bond{"gear", MakeGear}})
    {
        Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
        b2Body* a = trial.Part(-0.5f, 0.0f, 0.5f, 0.05f);
        b2Body* b = trial.Part(0.5f, 0.0f, 0.5f, 0.05f);
        bond.make(trial, a, b);
        a->SetAngularVelocity(4.5f);
        a->SetLinearVelocity(b2Vec2(0.0f, -1.125f));
        b->SetLinearVelocity(b2Vec2(0.0f, 1.125f));
        trial.Step(); // what the joint does not allow is gone
        const Books books(trial);
        trial.Run(60.0);
        books.JudgeMinute(std::string("pair, ") + bond.name + ", 60 s", GetParam(), true);
    }
}

/// Twelve rods in a ring that is open, of which the first spins.
TEST_P(FreeMotion, ConservesEnergyAndMomentaOfAChain)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    for (int i = 0; i < 12; ++i)
    {
        trial.Part(float32(i), 0.0f, 0.5f, 0.05f);
        if (i > 0)
        {
            trial.Hinge(trial.parts[std::size_t(i) - 1], trial.parts[std::size_t(i)],
                        float32(i) - 0.5f, 0.0f);
        }
    }
    trial.parts[0]->SetAngularVelocity(3.0f);
    trial.parts[11]->SetLinearVelocity(b2Vec2(0.0f, 2.0f));
    trial.Step();
    const Books books(trial);
    trial.Run(60.0);
    books.JudgeMinute("chain of 12 in space, 60 s", GetParam(), true);
}

} // namespace
