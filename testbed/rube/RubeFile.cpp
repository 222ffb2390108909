// SPDX-License-Identifier: MIT
#include "RubeFile.h"

#include "RubeBuilder.h"
#include "RubeJson.h"
#include "RubeText.h"

#include <fstream>
#include <system_error>

namespace boxreel
{

namespace
{

class RubeFileScene : public Scene
{
public:
    RubeFileScene(const RubeScene& content, std::vector<std::string>& leftOut)
        : Scene(SceneSettings{})
    {
        m_steps.timeStep = 1.0f / content.stepsPerSecond;
        m_steps.velocityIterations = content.velocityIterations;
        m_steps.positionIterations = content.positionIterations;
        NameJoints(content, BuildRubeScene(content, m_world, leftOut));
        NameBodies(content);
    }

    StepSettings PreferredSteps() const override { return m_steps; }

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

    StepSettings m_steps;
};

// The size is asked for before anything is read, so that a huge file costs nothing; a device or a
// pipe has no size to ask for.
Result<std::string> ReadBounded(const std::filesystem::path& file)
{
    const std::string name = file.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
    {
        return Error{ErrorKind::Unusable, name + " does not exist; check the path."};
    }
    if (!std::filesystem::is_regular_file(status))
    {
        return Error{ErrorKind::Unusable, name + " is no regular file; name a scene file."};
    }
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size > kMostBytes)
    {
        return Error{ErrorKind::Unusable, name + " is larger than " +
                                              std::to_string(kMostBytes >> 20) +
                                              " MB; split the scene into smaller files."};
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
    {
        return Error{ErrorKind::Unusable, name + " cannot be opened; check its permissions."};
    }
    std::string text(static_cast<std::size_t>(size), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (stream.gcount() != static_cast<std::streamsize>(size))
    {
        return Error{ErrorKind::Failed, name + " could not be read to its end; check the disk."};
    }
    return text;
}

} // namespace

Result<std::unique_ptr<Scene>> LoadRubeScene(const std::filesystem::path& file,
                                             std::vector<std::string>& leftOut)
{
    const Result<std::string> text = ReadBounded(file);
    if (!text)
    {
        return text.GetError();
    }
    const Result<RubeScene> content = ParseRubeScene(*text, file.string());
    if (!content)
    {
        return content.GetError();
    }
    return std::unique_ptr<Scene>(std::make_unique<RubeFileScene>(*content, leftOut));
}

} // namespace boxreel
