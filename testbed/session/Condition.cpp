// SPDX-License-Identifier: MIT
#include "Condition.h"

#include <base/Nearest.h>
#include <base/Quoting.h>
#include <base/Words.h>
#include <options/Values.h>

#include <array>
#include <cctype>
#include <vector>

namespace boxreel
{

struct Condition::Word
{
    const char* text;
    Quantity quantity;
    bool isOfBody;
    bool isOfWorld;
};

namespace
{

std::string_view Trimmed(std::string_view text)
{
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0)
    {
        text.remove_prefix(1);
    }
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
    {
        text.remove_suffix(1);
    }
    return text;
}

constexpr const char* kRemedy =
    "write a condition such as \"17.y < -10\", \"all.speed < 0.01\" or \"awake == 0\"";

Error Malformed(std::string_view option, std::string_view text, const std::string& why)
{
    return BadValue(option, text, why, kRemedy);
}

bool IsNumber(std::string_view text)
{
    return !text.empty() && text.size() <= 9 &&
           text.find_first_not_of("0123456789") == std::string_view::npos;
}

} // namespace

Result<Condition::Quantity> Condition::QuantityOf(std::string_view word, bool isOfWorld)
{
    static constexpr std::array<Word, 11> words = {{
        {"x", Quantity::X, true, false},
        {"y", Quantity::Y, true, false},
        {"angle", Quantity::Angle, true, false},
        {"vx", Quantity::Vx, true, false},
        {"vy", Quantity::Vy, true, false},
        {"speed", Quantity::Speed, true, false},
        {"spin", Quantity::Spin, true, false},
        {"time", Quantity::Time, false, true},
        {"awake", Quantity::Awake, true, true},
        {"bodies", Quantity::Bodies, false, true},
        {"contacts", Quantity::Contacts, false, true},
    }};
    std::vector<std::string> candidates;
    for (const Word& known : words)
    {
        if (!(isOfWorld ? known.isOfWorld : known.isOfBody))
        {
            continue;
        }
        if (word == known.text)
        {
            return known.quantity;
        }
        candidates.emplace_back(known.text);
    }
    return Error{ErrorKind::Unusable, Quoted(word), "must be one of " + JoinedBy(", ", candidates),
                 DidYouMean(word, candidates, kRemedy)};
}

Result<Condition> Condition::Parse(std::string_view option, std::string_view text)
{
    const std::size_t at = text.find_first_of("<>=!");
    if (at == std::string_view::npos)
    {
        return Malformed(option, text, "has no comparison");
    }
    const bool isTwo = at + 1 < text.size() && text[at + 1] == '=';
    const std::string_view sign = text.substr(at, isTwo ? 2 : 1);
    Condition condition;
    condition.m_option = option;
    condition.m_text = Trimmed(text);
    if (sign == "=" || sign == "!")
    {
        return Malformed(option, text, Quoted(sign) + " is not one of < <= > >= == !=");
    }
    condition.m_relation = sign == "<"    ? Relation::Less
                           : sign == "<=" ? Relation::LessEqual
                           : sign == ">"  ? Relation::Greater
                           : sign == ">=" ? Relation::GreaterEqual
                           : sign == "==" ? Relation::Equal
                                          : Relation::NotEqual;
    const std::string_view right = Trimmed(text.substr(at + sign.size()));
    const Result<double> value = ParseNumber(option, right);
    if (!value)
    {
        return Malformed(option, text, Quoted(right) + " is not a number");
    }
    condition.m_value = *value;
    const std::string_view left = Trimmed(text.substr(0, at));
    const std::size_t dot = left.rfind('.');
    const bool isOfWorld = dot == std::string_view::npos;
    const std::string_view word = Trimmed(isOfWorld ? left : left.substr(dot + 1));
    const Result<Quantity> quantity = QuantityOf(word, isOfWorld);
    if (!quantity)
    {
        return BadValue(option, text,
                        quantity.GetError().culprit + " " + quantity.GetError().problem,
                        quantity.GetError().remedy);
    }
    condition.m_quantity = *quantity;
    if (isOfWorld)
    {
        return condition;
    }
    std::string_view subject = Trimmed(left.substr(0, dot));
    if (subject.starts_with("body "))
    {
        subject = Trimmed(subject.substr(5));
    }
    if (subject.empty())
    {
        return Malformed(option, text, "names no body");
    }
    condition.m_of = subject == "any"    ? Of::Any
                     : subject == "all"  ? Of::All
                     : IsNumber(subject) ? Of::Number
                                         : Of::Name;
    if (condition.m_of == Of::Number)
    {
        condition.m_number = static_cast<std::uint32_t>(std::stoul(std::string(subject)));
    }
    condition.m_name = subject;
    return condition;
}

double Condition::Value(const b2Body& body, Quantity quantity)
{
    switch (quantity)
    {
    case Quantity::X:
        return double(body.GetPosition().x);
    case Quantity::Y:
        return double(body.GetPosition().y);
    case Quantity::Angle:
        return double(body.GetAngle());
    case Quantity::Vx:
        return double(body.GetLinearVelocity().x);
    case Quantity::Vy:
        return double(body.GetLinearVelocity().y);
    case Quantity::Speed:
        return double(body.GetLinearVelocity().Length());
    case Quantity::Spin:
        return double(body.GetAngularVelocity());
    default:
        return body.IsAwake() ? 1.0 : 0.0;
    }
}

double Condition::Value(const b2World& world, Quantity quantity, double seconds)
{
    switch (quantity)
    {
    case Quantity::Bodies:
        return double(world.GetBodyCount());
    case Quantity::Time:
        return seconds;
    case Quantity::Contacts: {
        int touching = 0;
        for (const b2Contact* contact = world.GetContactList(); contact != nullptr;
             contact = contact->GetNext())
        {
            touching += contact->IsTouching() ? 1 : 0;
        }
        return double(touching);
    }
    default: {
        int awake = 0;
        for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            awake += body->GetType() != b2_staticBody && body->IsAwake() ? 1 : 0;
        }
        return double(awake);
    }
    }
}

bool Condition::Compare(double value) const
{
    switch (m_relation)
    {
    case Relation::Less:
        return value < m_value;
    case Relation::LessEqual:
        return value <= m_value;
    case Relation::Greater:
        return value > m_value;
    case Relation::GreaterEqual:
        return value >= m_value;
    case Relation::Equal:
        return value == m_value;
    default:
        return value < m_value || value > m_value; // false for NaN
    }
}

bool Condition::IsSubject(const b2Body& body,
                          const std::map<std::uint32_t, std::string>& names) const
{
    if (m_of == Of::Number)
    {
        return std::uint32_t(body.GetNumber()) == m_number;
    }
    if (m_of == Of::Name)
    {
        const auto name = names.find(std::uint32_t(body.GetNumber()));
        return name != names.end() && name->second == m_name;
    }
    return body.GetType() != b2_staticBody;
}

std::optional<Error> Condition::MissingBody(const b2World& world,
                                            const std::map<std::uint32_t, std::string>& names) const
{
    if (m_of != Of::Number && m_of != Of::Name)
    {
        return std::nullopt;
    }
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (IsSubject(*body, names))
        {
            return std::nullopt;
        }
    }
    Error missing{ErrorKind::Unusable, AsTyped(m_option, m_text)};
    if (m_of == Of::Number)
    {
        missing.problem = "no body has the number " + m_name + " yet; the scene begins with " +
                          std::to_string(world.GetBodyCount()) + ", counted from 0";
        return missing;
    }
    std::vector<std::string> candidates{"any", "all"};
    for (const auto& [number, name] : names)
    {
        candidates.push_back(name);
    }
    missing.problem = "no body has the name " + Quoted(m_name) + " yet";
    missing.remedy = DidYouMean(m_name, candidates);
    return missing;
}

std::optional<double> Condition::ValueIn(const b2World& world,
                                         const std::map<std::uint32_t, std::string>& names,
                                         double seconds) const
{
    if (m_of == Of::World)
    {
        return Value(world, m_quantity, seconds);
    }
    std::optional<double> value;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        const bool isNamed = m_of == Of::Number || m_of == Of::Name;
        if (isNamed && IsSubject(*body, names))
        {
            value = Value(*body, m_quantity);
        }
    }
    return value;
}

bool Condition::Holds(const b2World& world, const std::map<std::uint32_t, std::string>& names,
                      double seconds) const
{
    if (m_of == Of::World)
    {
        return Compare(Value(world, m_quantity, seconds));
    }
    bool isAny = false;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (!IsSubject(*body, names))
        {
            continue;
        }
        const bool holds = Compare(Value(*body, m_quantity));
        if (!holds && m_of == Of::All)
        {
            return false;
        }
        isAny = isAny || holds;
    }
    return isAny;
}

} // namespace boxreel
