// SPDX-License-Identifier: MIT
#include "RubeFile.h"

#include "RubeBuilder.h"
#include "RubeCrowd.h"
#include "RubeJson.h"
#include "RubeText.h"
#include "RubeTraps.h"

#include <base/ErrorMacros.h>
#include <base/ReadWhole.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

namespace boxreel
{

namespace
{

class RubeFileScene : public Scene
{
public:
    RubeFileScene(RubeScene said, RubeNotes& leftOut)
        : Scene(SceneSettings{}), m_content(std::move(said))
    {
        const RubeScene& content = m_content;
        m_steps.timeStep = 1.0f / content.stepsPerSecond;
        m_steps.velocityIterations = content.velocityIterations;
        m_steps.positionIterations = content.positionIterations;
        m_joints = BuildRubeScene(content, m_world, leftOut);
        NameJoints(content, m_joints);
        for (b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            m_bodies.push_back(body);
        }
        std::reverse(m_bodies.begin(), m_bodies.end());
        NameBodies(content);
    }

    StepSettings PreferredSteps() const override { return m_steps; }

    /// The images' outlines, where their bodies are.
    void Draw(b2Draw& draw) const override
    {
        for (const RubeImage& image : m_content.images)
        {
            if (image.corners)
            {
                DrawOutline(image, draw);
            }
        }
    }

    /// The images, so that a background is not cut.
    std::vector<b2AABB> Framed() const override
    {
        std::vector<b2AABB> boxes;
        for (const RubeImage& image : m_content.images)
        {
            if (image.corners)
            {
                const std::array<b2Vec2, 4> corners = CornersOf(image);
                b2AABB& box = boxes.emplace_back();
                box.lowerBound = box.upperBound = corners[0];
                for (const b2Vec2& corner : corners)
                {
                    box.lowerBound = b2Min(box.lowerBound, corner);
                    box.upperBound = b2Max(box.upperBound, corner);
                }
            }
        }
        return boxes;
    }

    const RubeScene& Content() const { return m_content; }
    const std::vector<const b2Joint*>& Joints() const { return m_joints; }

private:
    // The builder makes one body of each, in this order.
    void NameBodies(const RubeScene& content)
    {
        for (std::size_t i = 0; i < content.bodies.size(); ++i)
        {
            if (!content.bodies[i].name.empty())
            {
                m_names.emplace(static_cast<std::uint32_t>(i), content.bodies[i].name);
            }
        }
    }

    void NameJoints(const RubeScene& content, const std::vector<const b2Joint*>& joints)
    {
        for (std::size_t i = 0; i < joints.size(); ++i)
        {
            if (joints[i] != nullptr && !content.joints[i].name.empty())
            {
                m_jointNames.emplace(joints[i], content.joints[i].name);
            }
        }
    }

    /// In the world [m].
    std::array<b2Vec2, 4> CornersOf(const RubeImage& image) const
    {
        std::array<b2Vec2, 4> corners = *image.corners;
        if (image.body)
        {
            for (b2Vec2& corner : corners)
            {
                corner = m_bodies[*image.body]->GetWorldPoint(corner);
            }
        }
        return corners;
    }

    void DrawOutline(const RubeImage& image, b2Draw& draw) const
    {
        draw.DrawPolygon(CornersOf(image).data(), 4, b2Color(0.6f, 0.6f, 0.8f));
    }

    RubeScene m_content;
    StepSettings m_steps;
    std::vector<b2Body*> m_bodies;        ///< in the order of the file; none of them goes
    std::vector<const b2Joint*> m_joints; ///< in the order of the file
};

} // namespace

Result<std::unique_ptr<Scene>> LoadRubeScene(const std::filesystem::path& file, RubeNotes& leftOut)
{
    const Result<std::string> text = ReadWhole(file, kMaxBytes);
    return text ? SceneOfText(*text, file.string(), leftOut)
                : Result<std::unique_ptr<Scene>>(text.GetError());
}

Result<std::unique_ptr<Scene>> SceneOfText(std::string_view text, const std::string& source,
                                           RubeNotes& leftOut)
{
    ASSIGN_OR_RETURN(RubeScene content, ParseRubeScene(text, source));
    auto scene = std::make_unique<RubeFileScene>(std::move(content), leftOut);
    if (IsTooCrowded(scene->World()))
    {
        return Error{ErrorKind::Unusable, source,
                     "has more than " + std::to_string(kMaxPairs) + " pairs of overlapping shapes",
                     "move its bodies apart"};
    }
    return std::unique_ptr<Scene>(std::move(scene));
}

Result<RubeNotes> TrapsOfFile(const std::filesystem::path& file)
{
    const Result<std::string> text = ReadWhole(file, kMaxBytes);
    return text ? RubeTraps(*text, file.string()) : Result<RubeNotes>(text.GetError());
}

const RubeScene* ContentOfFile(const Scene& scene)
{
    const auto* const file = dynamic_cast<const RubeFileScene*>(&scene);
    return file != nullptr ? &file->Content() : nullptr;
}

std::vector<const b2Joint*> JointsOfFile(const Scene& scene)
{
    const auto* const file = dynamic_cast<const RubeFileScene*>(&scene);
    return file != nullptr ? file->Joints() : std::vector<const b2Joint*>();
}

} // namespace boxreel
