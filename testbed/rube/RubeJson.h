// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// JSON for the scene-file reader. Every access states the expected type, and the first value of
/// another type is stored with its place as an error. Nothing is thrown. Only RubeJson.cpp, and
/// RubeWriter.cpp for output, depend on the JSON library. Accepts text from any source: kMaxBytes,
/// kMaxValues and kMaxObjects bound the memory.
namespace boxreel
{

/// Larger files are refused unread; a scene of ten thousand bodies has about 10 MB.
constexpr std::uintmax_t kMaxBytes = 64u << 20;
/// Maximum number of numbers, strings, lists and objects. A parsed value takes about 100 bytes.
constexpr std::size_t kMaxValues = 2'000'000;
/// Maximum number of objects. One in a list may become a body of 600 bytes. A fully written body
/// has seven.
constexpr std::size_t kMaxObjects = 500'000;
/// Maximum nesting of lists and objects. Scene files need about ten levels.
constexpr std::size_t kDeepest = 64;

class JsonValue;

/// A parsed text, including its errors. Values must not outlive it.
class JsonDocument
{
public:
    /// `source` names the text in messages, usually the path of the file.
    static Result<JsonDocument> Parse(std::string_view text, std::string source);

    JsonDocument(JsonDocument&&) noexcept;
    ~JsonDocument();

    JsonValue Root() const;

    /// The first complaint of any value, if there was one.
    const std::optional<Error>& Complaint() const;

private:
    friend class JsonValue;
    struct Content;

    explicit JsonDocument(std::unique_ptr<Content> content);

    std::unique_ptr<Content> m_content;
};

/// One place in a document, which may be missing. A missing value reads as the fallback; a value of
/// the wrong kind or out of range is complained about and reads as the fallback, too.
class JsonValue
{
public:
    bool Exists() const { return m_node != nullptr; }

    /// Returns the member of an object; a missing value if there is no such member.
    JsonValue Member(const char* name) const;
    /// Same as Member, but reports an absent member as an error.
    JsonValue Required(const char* name) const;

    /// Elements of a list; 0 when missing.
    std::size_t Count() const;
    /// `index` is below Count().
    JsonValue Item(std::size_t index) const;

    bool Bool(bool fallback) const;
    /// A whole number in [minimum, maximum].
    std::int64_t Integer(std::int64_t fallback, std::int64_t minimum, std::int64_t maximum) const;
    /// A number, or a string with the eight hex digits of a float's bits; in [minimum, maximum].
    float Number(float fallback, float minimum, float maximum) const;
    std::string Text() const;

    /// All of it, as JSON text; empty when missing.
    std::string Raw() const;

    bool IsZero() const; ///< the literal 0, which stands for a vector, too

    /// Remembers the problem of this value, such as "must be a list".
    void Complain(const std::string& problem) const;

    /// True if an error in the document has been reported, so reading can stop.
    bool IsHopeless() const;

private:
    friend class JsonDocument;

    /// Reports an error of the member of that name; empty: of this value.
    void ComplainAt(const std::string& member, const std::string& problem) const;

    JsonValue(const void* node, JsonDocument::Content* content) : m_node(node), m_content(content)
    {}

    const void* m_node; ///< the library's value, or null when missing
    JsonDocument::Content* m_content;
};

} // namespace boxreel
