// SPDX-License-Identifier: MIT
#include "JointCalls.h"

namespace fuzz
{
namespace
{

template <class Definition>
void Create(b2World& world, Definition& def, Choices& choices)
{
    def.collideConnected = choices.Flag();
    world.CreateJoint(&def);
}

void CreateRevolute(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2RevoluteJointDef def;
    def.Initialize(a, b, 0.5f * (a->GetPosition() + b->GetPosition()));
    def.enableMotor = choices.Flag();
    def.motorSpeed = choices.Real(-9.0f, 9.0f);
    def.maxMotorTorque = choices.Real(0.0f, 50.0f);
    def.enableLimit = choices.Flag();
    def.lowerAngle = choices.Real(-2.0f, 0.0f);
    def.upperAngle = choices.Real(0.0f, 2.0f);
    Create(world, def, choices);
}

void CreatePrismatic(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2PrismaticJointDef def;
    def.Initialize(a, b, b->GetPosition(),
                   choices.Flag() ? b2Vec2(1.0f, 0.0f) : b2Vec2(0.6f, 0.8f));
    def.enableMotor = choices.Flag();
    def.motorSpeed = choices.Real(-9.0f, 9.0f);
    def.maxMotorForce = choices.Real(0.0f, 50.0f);
    def.enableLimit = choices.Flag();
    def.lowerTranslation = choices.Real(-2.0f, 0.0f);
    def.upperTranslation = choices.Real(0.0f, 2.0f);
    Create(world, def, choices);
}

void CreateDistance(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2DistanceJointDef def;
    def.Initialize(a, b, a->GetPosition(), b->GetPosition());
    def.length = b2Max(def.length, 0.1f);
    def.frequencyHz = choices.Flag() ? choices.Real(0.0f, 20.0f) : 0.0f;
    def.dampingRatio = choices.Real(0.0f, 1.0f);
    Create(world, def, choices);
}

void CreatePulley(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2PulleyJointDef def;
    const b2Vec2 up(0.0f, 3.0f);
    def.Initialize(a, b, a->GetPosition() + up, b->GetPosition() + up, a->GetPosition(),
                   b->GetPosition(), choices.Real(0.5f, 3.0f));
    Create(world, def, choices);
}

void CreateMouse(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2MouseJointDef def;
    def.bodyA = a;
    def.bodyB = b;
    def.target = b->GetPosition();
    def.maxForce = choices.Real(0.0f, 500.0f);
    Create(world, def, choices);
}

void CreateWheel(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2WheelJointDef def;
    def.Initialize(a, b, b->GetPosition(), b2Vec2(0.0f, 1.0f));
    def.enableMotor = choices.Flag();
    def.motorSpeed = choices.Real(-20.0f, 20.0f);
    def.maxMotorTorque = choices.Real(0.0f, 50.0f);
    def.frequencyHz = choices.Real(0.0f, 10.0f);
    Create(world, def, choices);
}

void CreateWeld(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2WeldJointDef def;
    def.Initialize(a, b, a->GetPosition());
    def.frequencyHz = choices.Flag() ? choices.Real(0.0f, 20.0f) : 0.0f;
    Create(world, def, choices);
}

void CreateFriction(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2FrictionJointDef def;
    def.Initialize(a, b, b->GetPosition());
    def.maxForce = choices.Real(0.0f, 50.0f);
    def.maxTorque = choices.Real(0.0f, 50.0f);
    Create(world, def, choices);
}

void CreateRope(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2RopeJointDef def;
    def.bodyA = a;
    def.bodyB = b;
    def.maxLength = choices.Real(0.1f, 5.0f);
    Create(world, def, choices);
}

void CreateMotor(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    b2MotorJointDef def;
    def.Initialize(a, b);
    def.maxForce = choices.Real(0.0f, 500.0f);
    def.maxTorque = choices.Real(0.0f, 500.0f);
    Create(world, def, choices);
}

bool CanBeGeared(b2Joint* joint)
{
    const bool fits = joint->GetType() == e_revoluteJoint || joint->GetType() == e_prismaticJoint;
    return fits && joint->GetBodyA()->GetType() == b2_staticBody;
}

/// Creates a gear of the newest two suitable joints to a static body.
void CreateGear(b2World& world, Choices& choices)
{
    b2Joint* first = nullptr;
    for (b2Joint* joint = world.GetJointList(); joint; joint = joint->GetNext())
    {
        if (!CanBeGeared(joint))
        {
            continue;
        }
        if (first && first->GetBodyB() != joint->GetBodyB())
        {
            b2GearJointDef def;
            def.bodyA = first->GetBodyB();
            def.bodyB = joint->GetBodyB();
            def.joint1 = first;
            def.joint2 = joint;
            const float32 ratio = choices.Real(0.2f, 3.0f);
            def.ratio = choices.Flag() ? ratio : -ratio;
            Create(world, def, choices);
            return;
        }
        first = first ? first : joint;
    }
}

void ChangeMotorized(b2RevoluteJoint* joint, Choices& choices)
{
    joint->EnableMotor(choices.Flag());
    joint->SetMotorSpeed(choices.Real(-9.0f, 9.0f));
    joint->SetMaxMotorTorque(choices.Real(0.0f, 50.0f));
    joint->EnableLimit(choices.Flag());
    const float32 lower = choices.Real(-3.0f, 0.0f);
    joint->SetLimits(lower, choices.Real(0.0f, 3.0f));
}

void ChangeMotorized(b2PrismaticJoint* joint, Choices& choices)
{
    joint->EnableMotor(choices.Flag());
    joint->SetMotorSpeed(choices.Real(-9.0f, 9.0f));
    joint->SetMaxMotorForce(choices.Real(0.0f, 50.0f));
    joint->EnableLimit(choices.Flag());
    const float32 lower = choices.Real(-3.0f, 0.0f);
    joint->SetLimits(lower, choices.Real(0.0f, 3.0f));
}

void ChangeWheel(b2WheelJoint* joint, Choices& choices)
{
    joint->EnableMotor(choices.Flag());
    joint->SetMotorSpeed(choices.Real(-20.0f, 20.0f));
    joint->SetMaxMotorTorque(choices.Real(0.0f, 50.0f));
    joint->SetSpringFrequencyHz(choices.Real(0.0f, 20.0f));
    joint->SetSpringDampingRatio(choices.Real(0.0f, 1.0f));
}

void ChangeMotorJoint(b2MotorJoint* joint, Choices& choices)
{
    joint->SetLinearOffset(choices.Vector(3.0f));
    joint->SetAngularOffset(choices.Real(-3.0f, 3.0f));
    joint->SetMaxForce(choices.Real(0.0f, 500.0f));
    joint->SetMaxTorque(choices.Real(0.0f, 500.0f));
}

} // namespace

const char* CreateJoint(b2World& world, b2Body* a, b2Body* b, Choices& choices)
{
    using Creator = void (*)(b2World&, b2Body*, b2Body*, Choices&);
    static constexpr Creator creators[] = {
        CreateRevolute, CreatePrismatic, CreateDistance, CreatePulley, CreateMouse,
        CreateWheel,    CreateWeld,      CreateFriction, CreateRope,   CreateMotor,
    };
    const int kind = choices.Number(0, 10);
    if (kind == 10)
    {
        CreateGear(world, choices);
        return "CreateJoint (gear)";
    }
    creators[kind](world, a, b, choices);
    return "CreateJoint";
}

const char* ChangeJoint(b2Joint* joint, Choices& choices)
{
    (void)joint->GetReactionForce(60.0f);
    (void)joint->GetReactionTorque(60.0f);
    switch (joint->GetType())
    {
    case e_revoluteJoint:
        ChangeMotorized(static_cast<b2RevoluteJoint*>(joint), choices);
        break;
    case e_prismaticJoint:
        ChangeMotorized(static_cast<b2PrismaticJoint*>(joint), choices);
        break;
    case e_distanceJoint:
        static_cast<b2DistanceJoint*>(joint)->SetLength(choices.Real(0.1f, 5.0f));
        static_cast<b2DistanceJoint*>(joint)->SetFrequency(choices.Real(0.0f, 20.0f));
        break;
    case e_mouseJoint:
        static_cast<b2MouseJoint*>(joint)->SetTarget(choices.Place());
        break;
    case e_gearJoint:
        static_cast<b2GearJoint*>(joint)->SetRatio(choices.Real(-3.0f, 3.0f));
        break;
    case e_wheelJoint:
        ChangeWheel(static_cast<b2WheelJoint*>(joint), choices);
        break;
    case e_weldJoint:
        static_cast<b2WeldJoint*>(joint)->SetFrequency(choices.Real(0.0f, 20.0f));
        break;
    case e_frictionJoint:
        static_cast<b2FrictionJoint*>(joint)->SetMaxForce(choices.Real(0.0f, 50.0f));
        break;
    case e_ropeJoint:
        static_cast<b2RopeJoint*>(joint)->SetMaxLength(choices.Real(0.1f, 5.0f));
        break;
    case e_motorJoint:
        ChangeMotorJoint(static_cast<b2MotorJoint*>(joint), choices);
        break;
    default:
        break;
    }
    return "ChangeJoint";
}

} // namespace fuzz
