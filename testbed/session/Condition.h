// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <base/Result.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

/// "17.y < -10", "ball.speed >= 3", "all.speed < 0.01", "awake == 0": what a film may wait for.
/// Used by record; looks at a world, never changes it.
namespace boxreel
{

class Condition
{
public:
    /// Parses SUBJECT.QUANTITY OPERATOR NUMBER, or QUANTITY OPERATOR NUMBER for the whole world. A
    /// subject is a body's number or name, or `any` or `all` of the bodies that can move. An Error
    /// (Unusable) names the part that is wrong. `option` is for the message.
    static Result<Condition> Parse(std::string_view option, std::string_view text);

    /// Returns true if the condition holds. `seconds`: simulated so far. A missing body meets no
    /// condition, nor does a value that is not a number.
    bool Holds(const b2World& world, const std::map<std::uint32_t, std::string>& names,
               double seconds) const;

    /// An Error (Unusable) when it is about a body that is not there, with the nearest name.
    std::optional<Error> MissingBody(const b2World& world,
                                     const std::map<std::uint32_t, std::string>& names) const;

    /// Returns the value that is compared with the number, of the world or of the named body. None
    /// for several bodies and for a body that does not exist.
    std::optional<double> ValueIn(const b2World& world,
                                  const std::map<std::uint32_t, std::string>& names,
                                  double seconds) const;

    const std::string& Text() const { return m_text; } ///< as it was given

private:
    enum class Of
    {
        World,
        Number,
        Name,
        Any,
        All,
    };
    enum class Quantity
    {
        X, ///< of the origin [m], likewise Y
        Y,
        Angle, ///< [rad]
        Vx,    ///< of the centre of mass [m/s], likewise Vy and Speed
        Vy,
        Speed,
        Spin,  ///< [rad/s]
        Awake, ///< 1 or 0; of the world: how many bodies
        Time,  ///< simulated [s]
        Bodies,
        Contacts, ///< that touch
    };
    enum class Relation
    {
        Less,
        LessEqual,
        Greater,
        GreaterEqual,
        Equal,
        NotEqual,
    };
    struct Word;

    /// Finds a quantity of the world or of a body. The Error contains only the second half of a
    /// sentence: the known quantities and the remedy.
    static Result<Quantity> QuantityOf(std::string_view word, bool isOfWorld);
    static double Value(const b2Body& body, Quantity quantity);
    static double Value(const b2World& world, Quantity quantity, double seconds);
    bool Compare(double value) const;
    bool IsSubject(const b2Body& body, const std::map<std::uint32_t, std::string>& names) const;

    std::string m_option; ///< for messages
    std::string m_text;
    Of m_of = Of::World;
    std::uint32_t m_number = 0;
    std::string m_name;
    Quantity m_quantity = Quantity::Time;
    Relation m_relation = Relation::Less;
    double m_value = 0.0;
};

} // namespace boxreel
