// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

/// Forms: what items are, without their place. A form is stored once for the whole page, however
/// many bodies have it and however often they come and go.
namespace boxreel
{

/// A point in double precision [m].
struct PagePoint
{
    double x = 0.0;
    double y = 0.0;
};

/// Items next to each other in a list, of one layer, body and paint. They move together.
struct ItemRun
{
    std::size_t first = 0; ///< index into DrawList::items
    std::size_t count = 0;
};

/// The points that place these items [m]: those of the list, but the end of a circle's radius and
/// of an axis instead of their directions.
void ReadPoints(const DrawList& list, const ItemRun& run, std::vector<PagePoint>& points);

/// Points that keep their distances. Their frame is that of the body, about their own centre.
struct RigidForm
{
    std::vector<PagePoint> points; ///< as the page has them [m]
    double angleUnit = 1.0;        ///< turning by it moves the farthest point by a quantum [rad]
    std::optional<PagePoint> origin{}; ///< of the body, as the page has it [m]
};

/// All forms of a page. The numbers of forms are in the order of their addition.
class FormTable
{
public:
    explicit FormTable(double quantum) : m_quantum(quantum) {}

    /// The same for runs of the same kinds of items, sizes and texts.
    std::string Signature(const DrawList& list, const ItemRun& run);

    /// The form of items whose points move on their own.
    std::uint32_t AddLoose(const std::string& signature);

    /// The form of points that move as one. `angle`: of the body; `origin`: its origin [m].
    std::uint32_t AddRigid(const std::string& signature, std::span<const PagePoint> points,
                           double angle, const std::optional<PagePoint>& origin);

    /// The form of a body's state: its velocity, and its place if no rigid form has it.
    std::uint32_t AddBody(bool hasPlace);

    const RigidForm& Rigid(std::uint32_t form) const { return m_rigid.at(form); }

    // What decode.js reads.
    const std::string& Bytes() const { return m_bytes; }
    std::uint32_t Count() const { return m_count; }
    const std::vector<std::string>& Texts() const { return m_texts; }

private:
    std::uint32_t Add(const std::string& bytes);
    PagePoint PutPoint(PagePoint point, std::string& bytes) const;

    double m_quantum; // [m]
    std::string m_bytes;
    std::uint32_t m_count = 0;
    std::vector<std::string> m_texts;
    // For lookups only.
    std::unordered_map<std::string, std::uint32_t> m_known;
    std::unordered_map<std::string, std::uint32_t> m_textNumbers;
    std::unordered_map<std::uint32_t, RigidForm> m_rigid;
};

} // namespace boxreel
