// SPDX-License-Identifier: MIT
#include "RubeJson.h"

#include <base/Counting.h>
#include <base/Unusable.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace boxreel
{

using nlohmann::json;

// NOLINTNEXTLINE(bugprone-exception-escape): json's destructor might throw where memory ends.
struct JsonDocument::Content
{
    json root;
    std::string source;
    std::optional<Error> complaint;
};

namespace
{

constexpr const char* kSplit = "split the scene into smaller files";
constexpr const char* kCorrect = "correct it or export the scene again";
constexpr const char* kExport = "export it again";
constexpr const char* kCopy = "copy or export it again";

// Walks a text without storing it and stops at the first thing that would make storing it costly.
class Guard : public nlohmann::json_sax<json>
{
public:
    /// Without a culprit; no problem: none.
    const Error& Refusal() const { return m_refusal; }
    std::size_t ErrorPosition() const { return m_errorPosition; }
    bool IsNumberTooLarge() const { return m_isNumberTooLarge; }

    bool null() override { return CountValue(); }
    bool boolean(bool) override { return CountValue(); }
    bool number_integer(number_integer_t) override { return CountValue(); }
    bool number_unsigned(number_unsigned_t) override { return CountValue(); }
    bool number_float(number_float_t, const string_t&) override { return CountValue(); }
    bool string(string_t&) override { return CountValue(); }
    bool binary(binary_t&) override { return CountValue(); }
    bool key(string_t&) override { return true; }
    bool start_object(std::size_t) override { return CountObject() && Enter(); }
    bool start_array(std::size_t) override { return Enter(); }
    bool end_object() override { return Leave(); }
    bool end_array() override { return Leave(); }

    bool parse_error(std::size_t position, const std::string&,
                     const json::exception& error) override
    {
        constexpr int kNumberOverflow = 406; // of the library's documentation
        m_errorPosition = position;
        m_isNumberTooLarge = error.id == kNumberOverflow;
        return false;
    }

private:
    bool CountValue() { return Within(++m_values, kMaxValues, "values"); }

    bool CountObject() { return Within(++m_objects, kMaxObjects, "objects"); }

    bool Within(std::size_t count, std::size_t maximum, const char* what)
    {
        if (count > maximum)
        {
            m_refusal.problem = "has more than " + std::to_string(maximum) + " " + what;
            m_refusal.remedy = kSplit;
        }
        return m_refusal.problem.empty();
    }

    bool Enter()
    {
        if (++m_depth > kDeepest)
        {
            m_refusal.problem =
                "nests lists and objects more than " + std::to_string(kDeepest) + " deep";
            m_refusal.remedy = kExport;
        }
        return CountValue();
    }

    bool Leave()
    {
        --m_depth;
        return true;
    }

    Error m_refusal{ErrorKind::Unusable, ""};
    std::size_t m_values = 0;
    std::size_t m_objects = 0;
    std::size_t m_depth = 0;
    std::size_t m_errorPosition = 0;
    bool m_isNumberTooLarge = false;
};

// "3:5", line and column of the last byte that was read; `position` counts them.
std::string Place(std::string_view text, std::size_t position)
{
    const std::size_t at = std::min(position > 0 ? position - 1 : 0, text.size());
    const std::string_view before = text.substr(0, at);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lastBreak = before.rfind('\n');
    const std::size_t column = lastBreak == std::string_view::npos ? at + 1 : at - lastBreak;
    return std::to_string(line) + ":" + std::to_string(column);
}

// Returns the error at the position where the parser stopped.
Error SyntaxError(std::string_view text, std::size_t position, const std::string& source)
{
    if (text.empty())
    {
        return Unusable(source, "is empty", kCopy);
    }
    if (position > text.size())
    {
        return Unusable(source, "ends inside its JSON text", kCopy);
    }
    return Unusable(source + ":" + Place(text, position), "is not JSON", kExport);
}

// Limits length and removes control characters.
std::string Shortened(std::string_view text)
{
    constexpr std::size_t kMaxLength = 40;
    std::string result(text.substr(0, kMaxLength));
    for (char& c : result)
    {
        const unsigned char byte = static_cast<unsigned char>(c);
        c = byte < 0x20 || byte >= 0x7F ? '?' : c;
    }
    return text.size() > kMaxLength ? result + "..." : result;
}

// Appends the path from `from` to `target`, such as ".body[3].angle", and returns true if there is
// one. Called only for messages, so that reading need not record paths.
bool AppendPath(const json& from, const json* target, std::string& path)
{
    if (&from == target)
    {
        return true;
    }
    const std::size_t length = path.size();
    if (from.is_array())
    {
        for (std::size_t i = 0; i < from.size(); ++i)
        {
            path.append("[").append(std::to_string(i)).append("]");
            if (AppendPath(from[i], target, path))
            {
                return true;
            }
            path.resize(length);
        }
    }
    else if (from.is_object())
    {
        for (auto member = from.begin(); member != from.end(); ++member)
        {
            path.append(path.empty() ? "" : ".").append(Shortened(member.key()));
            if (AppendPath(*member, target, path))
            {
                return true;
            }
            path.resize(length);
        }
    }
    return false;
}

const json& Node(const void* node)
{
    return *static_cast<const json*>(node);
}

// "3F000000" is 0.5: the bits of an IEEE-754 single, most significant digit first.
std::optional<float> FromHex(const std::string& digits)
{
    std::uint32_t bits = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, bits, 16);
    if (digits.size() != 8 || error != std::errc() || stop != end)
    {
        return std::nullopt;
    }
    return std::bit_cast<float>(bits);
}

std::string Written(auto number)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return std::string(text.data(), end);
}

} // namespace

JsonDocument::JsonDocument(std::unique_ptr<Content> content) : m_content(std::move(content)) {}
JsonDocument::JsonDocument(JsonDocument&&) noexcept = default;
JsonDocument::~JsonDocument() = default;

Result<JsonDocument> JsonDocument::Parse(std::string_view text, std::string source)
{
    if (text.size() > kMaxBytes)
    {
        return Unusable(source, "is larger than " + SizeText(kMaxBytes), kSplit);
    }
    // The library takes a zero byte for the end of the text and would ignore what follows.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    {
        return SyntaxError(text, zero + 1, source);
    }
    Guard guard;
    if (!json::sax_parse(text.begin(), text.end(), &guard))
    {
        if (guard.IsNumberTooLarge())
        {
            return Unusable(source + ":" + Place(text, guard.ErrorPosition()),
                            "the number is too large", kCorrect);
        }
        const Error& refusal = guard.Refusal();
        return refusal.problem.empty() ? SyntaxError(text, guard.ErrorPosition(), source)
                                       : Unusable(source, refusal.problem, refusal.remedy);
    }
    auto content = std::make_unique<Content>();
    content->root = json::parse(text.begin(), text.end(), nullptr, false);
    content->source = std::move(source);
    if (!content->root.is_object())
    {
        return Unusable(content->source,
                        "is not a scene file: its outermost value is not an object",
                        "name a R.U.B.E. export");
    }
    return JsonDocument(std::move(content));
}

JsonValue JsonDocument::Root() const
{
    return JsonValue(&m_content->root, m_content.get());
}

const std::optional<Error>& JsonDocument::Complaint() const
{
    return m_content->complaint;
}

JsonValue JsonValue::Member(const char* name) const
{
    if (!Exists())
    {
        return *this;
    }
    if (!Node(m_node).is_object())
    {
        Complain("must be an object");
        return JsonValue(nullptr, m_content);
    }
    const auto found = Node(m_node).find(name);
    return JsonValue(found == Node(m_node).end() ? nullptr : &*found, m_content);
}

JsonValue JsonValue::Required(const char* name) const
{
    const JsonValue member = Member(name);
    if (Exists() && !member.Exists())
    {
        ComplainAt(name, "is missing");
    }
    return member;
}

std::size_t JsonValue::Count() const
{
    if (Exists() && !Node(m_node).is_array())
    {
        Complain("must be a list");
        return 0;
    }
    return Exists() ? Node(m_node).size() : 0;
}

JsonValue JsonValue::Item(std::size_t index) const
{
    return JsonValue(&Node(m_node)[index], m_content);
}

bool JsonValue::Bool(bool fallback) const
{
    if (!Exists())
    {
        return fallback;
    }
    const json& node = Node(m_node);
    if (node.is_boolean())
    {
        return node.get<bool>();
    }
    const std::int64_t number = node.is_number_integer() ? node.get<std::int64_t>() : -1;
    if (number == 0 || number == 1)
    {
        return number == 1;
    }
    Complain("must be true or false");
    return fallback;
}

std::int64_t JsonValue::Integer(std::int64_t fallback, std::int64_t minimum,
                                std::int64_t maximum) const
{
    if (!Exists())
    {
        return fallback;
    }
    // Through double, so that 3.0 and numbers beyond 64 bits are judged alike; the limits are small
    // enough to be exact in it.
    const double value = Node(m_node).is_number() ? Node(m_node).get<double>()
                                                  : std::numeric_limits<double>::quiet_NaN();
    if (value >= static_cast<double>(minimum) && value <= static_cast<double>(maximum) &&
        value == std::floor(value))
    {
        return static_cast<std::int64_t>(value);
    }
    Complain(minimum == maximum ? "must be " + std::to_string(minimum)
                                : "must be a whole number from " + std::to_string(minimum) +
                                      " to " + std::to_string(maximum));
    return fallback;
}

float JsonValue::Number(float fallback, float minimum, float maximum) const
{
    if (!Exists())
    {
        return fallback;
    }
    const json& node = Node(m_node);
    double value = 0.0;
    if (node.is_number())
    {
        value = node.get<double>();
    }
    else if (const auto bits = node.is_string() ? FromHex(node.get_ref<const std::string&>())
                                                : std::optional<float>())
    {
        value = static_cast<double>(*bits);
    }
    else
    {
        Complain("must be a number or the eight hex digits of one");
        return fallback;
    }
    // Written so that NaN, which a hex string can spell, fails as well.
    if (value >= static_cast<double>(minimum) && value <= static_cast<double>(maximum))
    {
        return static_cast<float>(value);
    }
    Complain("is " + Written(value) + " but must be from " + Written(minimum) + " to " +
             Written(maximum));
    return fallback;
}

std::string JsonValue::Text() const
{
    if (Exists() && !Node(m_node).is_string())
    {
        Complain("must be a string");
        return "";
    }
    return Exists() ? Node(m_node).get<std::string>() : "";
}

std::string JsonValue::Raw() const
{
    return Exists() ? Node(m_node).dump(-1, ' ', false, json::error_handler_t::replace) : "";
}

bool JsonValue::IsZero() const
{
    return Exists() && Node(m_node).is_number() && Node(m_node) == 0;
}

void JsonValue::Complain(const std::string& problem) const
{
    ComplainAt("", problem);
}

void JsonValue::ComplainAt(const std::string& member, const std::string& problem) const
{
    if (IsHopeless() || !Exists())
    {
        return;
    }
    std::string path;
    AppendPath(m_content->root, &Node(m_node), path);
    path += (path.empty() || member.empty() ? "" : ".") + member;
    m_content->complaint =
        Unusable(m_content->source + (path.empty() ? "" : ": " + path), problem, kCorrect);
}

bool JsonValue::IsHopeless() const
{
    return m_content->complaint.has_value();
}

} // namespace boxreel
