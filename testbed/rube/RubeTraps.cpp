// SPDX-License-Identifier: MIT
#include "RubeTraps.h"

#include "RubeJson.h"
#include "RubeNames.h"

#include <base/ErrorMacros.h>

namespace boxreel
{

namespace
{

/// In the order in which the reader looks for them.
constexpr const char* kShapeKinds[] = {"circle", "edge", "chain", "loop", "polygon"};

std::string Part(const char* kind, std::size_t index, const JsonValue& value)
{
    return WithName(kind, index, value.Member("name").Text());
}

class Finder
{
public:
    void LookAtBody(std::size_t index, const JsonValue& body)
    {
        m_who = Part("body", index, body);
        const bool isDynamic = body.Member("type").Integer(0, 0, 2) == 2;
        if (isDynamic && !body.Member("awake").Exists())
        {
            Note("has no awake member, so it sleeps until something touches it");
        }
        const bool hasMass = body.Member("massData-mass").Exists();
        if (!hasMass &&
            (body.Member("massData-center").Exists() || body.Member("massData-I").Exists()))
        {
            Note("has a centre of mass or an inertia without a mass; those of its fixtures are "
                 "used");
        }
        const JsonValue fixtures = body.Member("fixture");
        bool weighs = hasMass;
        for (std::size_t i = 0; i < fixtures.Count(); ++i)
        {
            const JsonValue fixture = fixtures.Item(i);
            weighs = weighs || fixture.Member("density").Number(0.0f, 0.0f, 1e12f) > 0.0f;
            m_who = Part("fixture", i, fixture) + " of " + Part("body", index, body);
            LookAtFixture(fixture);
        }
        m_who = Part("body", index, body);
        if (isDynamic && fixtures.Count() > 0 && !weighs)
        {
            Note("none of its fixtures has a density, so it weighs 1 kg and does not turn");
        }
    }

    void LookAtJoint(std::size_t index, const JsonValue& joint)
    {
        m_who = Part("joint", index, joint);
        if (joint.Member("localAxis1").Exists() && !joint.Member("localAxisA").Exists())
        {
            Note("its axis is called localAxis1, as in old files; it is used");
        }
        if (joint.Member("type").Text() == "motor" && !joint.Member("linearOffset").Exists() &&
            joint.Member("anchorA").Exists())
        {
            Note("its offset is called anchorA, as in files before 1.7; it is used");
        }
        if (joint.Member("jointSpeed").Exists())
        {
            Note("jointSpeed repeats the speeds of the bodies; it is ignored");
        }
    }

    RubeNotes Finish() { return std::move(m_notes); }

private:
    void LookAtFixture(const JsonValue& fixture)
    {
        if (!fixture.Member("friction").Exists() && !fixture.Member("sensor").Bool(false))
        {
            Note(
                "has no friction member, so its friction is 0 instead of the engine's default 0.2");
        }
        const std::string taken = ShapeOf(fixture);
        if (taken == "loop")
        {
            Note("is called loop, as in old files; a closed chain is built");
        }
        if (taken == "polygon" &&
            fixture.Member("polygon").Member("vertices").Member("x").Count() == 2)
        {
            Note("is a polygon of two vertices; an edge is built");
        }
    }

    /// The kind of the shape that is taken; notes others beside it.
    std::string ShapeOf(const JsonValue& fixture)
    {
        std::string taken;
        for (const char* kind : kShapeKinds)
        {
            if (!fixture.Member(kind).Exists())
            {
                continue;
            }
            if (!taken.empty())
            {
                Note("has more than one shape; its " + taken + " is used");
                break;
            }
            taken = kind;
        }
        return taken;
    }

    void Note(std::string reason) { AddNote(m_notes, m_count, {m_who, std::move(reason)}); }

    std::string m_who;
    std::size_t m_count = 0;
    RubeNotes m_notes;
};

} // namespace

Result<RubeNotes> RubeTraps(std::string_view text, const std::string& source)
{
    ASSIGN_OR_RETURN(const JsonDocument document, JsonDocument::Parse(text, source));
    Finder finder;
    const JsonValue bodies = document.Root().Member("body");
    for (std::size_t i = 0; i < bodies.Count(); ++i)
    {
        finder.LookAtBody(i, bodies.Item(i));
    }
    const JsonValue joints = document.Root().Member("joint");
    for (std::size_t i = 0; i < joints.Count(); ++i)
    {
        finder.LookAtJoint(i, joints.Item(i));
    }
    if (document.Complaint())
    {
        return *document.Complaint();
    }
    return finder.Finish();
}

} // namespace boxreel
