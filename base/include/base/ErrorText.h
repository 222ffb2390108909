// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Texts of errors that name settings. A library names the member of its settings struct. A program
/// with other words for it (options of a command, keywords of a script) has a table of them.
namespace boxreel
{

/// A member of a settings struct, for the text of an Error.
struct ErrorSetting
{
    std::string_view member; ///< "VideoSettings::codec", of static storage (BOXREEL_MEMBER)
    std::vector<std::string> values{}; ///< "h264"; two for a size; none: the value does not matter
};

/// A row of SettingNames: how readers write a setting.
struct SettingName
{
    std::string_view member;    ///< as ErrorSetting::member
    std::string_view value;     ///< the only value that the row applies to; empty: all values
    std::string_view name;      ///< "--codec"; with its value if the row has one
    std::string_view before{};  ///< between the name and the values: " "
    std::string_view between{}; ///< between two values: "x"
    std::string_view after{};   ///< after the values
};

/// How readers write settings; the first row that applies counts. Without rows they are written as
/// in C++: "codec = h264".
using SettingNames = std::span<const SettingName>;

/// A text that may name settings. It is written for its readers by Text. A text without settings
/// converts from and to a std::string.
class ErrorText
{
public:
    ErrorText() = default;
    /// A text without settings.
    ErrorText(std::string text);
    /// Same as above.
    ErrorText(const char* text);
    /// The name of a setting, with its values if it has some.
    ErrorText(ErrorSetting setting);

    /// Returns "a, b or c": what a reader can choose from. Alternatives with a setting that the
    /// reader's names lack are left out.
    static ErrorText AnyOf(std::vector<ErrorText> alternatives);

    /// Returns the text, with the settings in these names. A setting that they lack is written as
    /// in C++.
    std::string Text(SettingNames names = {}) const;
    /// Returns the text with the settings as in C++.
    operator std::string() const { return Text(); }
    /// True if Text returns nothing.
    bool empty() const { return Text().empty(); }

    /// Appends.
    ErrorText& operator+=(const ErrorText& more);
    /// True if the texts are equal.
    friend bool operator==(const ErrorText& a, const ErrorText& b) { return a.Text() == b.Text(); }

private:
    // One of a text, a setting and alternatives.
    struct Piece
    {
        std::string text{};
        std::optional<ErrorSetting> setting{};
        std::vector<ErrorText> alternatives{};
    };
    bool IsKnown(SettingNames names) const;

    std::vector<Piece> m_pieces;
};

/// Returns the first, followed by the second.
ErrorText operator+(ErrorText first, const ErrorText& second);
/// Writes the text with the settings as in C++.
std::ostream& operator<<(std::ostream& stream, const ErrorText& text);

} // namespace boxreel
