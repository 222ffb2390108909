// SPDX-License-Identifier: MIT
#include <base/ErrorText.h>
#include <base/Words.h>

#include <algorithm>
#include <ostream>
#include <utility>

namespace boxreel
{
namespace
{

const SettingName* Find(SettingNames names, const ErrorSetting& setting)
{
    const auto row = std::find_if(names.begin(), names.end(), [&setting](const SettingName& name) {
        const bool isOfAll = name.value.empty();
        const bool isOfThis = setting.values.size() == 1 && setting.values.front() == name.value;
        return name.member == setting.member && (isOfAll || isOfThis);
    });
    return row == names.end() ? nullptr : &*row;
}

/// Returns "codec = h264", the member without its struct.
std::string TextInCpp(const ErrorSetting& setting)
{
    const std::size_t colons = setting.member.rfind("::");
    std::string text(colons == std::string_view::npos ? setting.member
                                                      : setting.member.substr(colons + 2));
    return setting.values.empty() ? text : text + " = " + JoinedBy("x", setting.values);
}

std::string TextOf(const ErrorSetting& setting, SettingNames names)
{
    const SettingName* const row = Find(names, setting);
    if (row == nullptr)
    {
        return TextInCpp(setting);
    }
    std::string text(row->name);
    if (row->value.empty() && !setting.values.empty())
    {
        text.append(row->before).append(JoinedBy(row->between, setting.values)).append(row->after);
    }
    return text;
}

/// Returns "a, b or c".
std::string Choice(const std::vector<std::string>& texts)
{
    std::string text;
    for (std::size_t i = 0; i < texts.size(); ++i)
    {
        const bool isLast = i + 1 == texts.size();
        text += (i == 0 ? "" : isLast ? " or " : ", ") + texts[i];
    }
    return text;
}

} // namespace

ErrorText::ErrorText(std::string text)
{
    m_pieces.push_back({.text = std::move(text)});
}

ErrorText::ErrorText(const char* text) : ErrorText(std::string(text)) {}

ErrorText::ErrorText(ErrorSetting setting)
{
    m_pieces.push_back({.setting = std::move(setting)});
}

ErrorText ErrorText::AnyOf(std::vector<ErrorText> alternatives)
{
    ErrorText text;
    text.m_pieces.push_back({.alternatives = std::move(alternatives)});
    return text;
}

bool ErrorText::IsKnown(SettingNames names) const
{
    return names.empty() || std::all_of(m_pieces.begin(), m_pieces.end(), [names](const Piece& p) {
               return !p.setting || Find(names, *p.setting) != nullptr;
           });
}

std::string ErrorText::Text(SettingNames names) const
{
    std::string text;
    for (const Piece& piece : m_pieces)
    {
        text += piece.setting ? TextOf(*piece.setting, names) : piece.text;
        std::vector<std::string> alternatives;
        for (const ErrorText& alternative : piece.alternatives)
        {
            if (alternative.IsKnown(names))
            {
                alternatives.push_back(alternative.Text(names));
            }
        }
        text += Choice(alternatives);
    }
    return text;
}

ErrorText& ErrorText::operator+=(const ErrorText& more)
{
    // A copy, because a text may be appended to itself.
    const std::vector<Piece> pieces = more.m_pieces;
    m_pieces.insert(m_pieces.end(), pieces.begin(), pieces.end());
    return *this;
}

ErrorText operator+(ErrorText first, const ErrorText& second)
{
    return first += second;
}

std::ostream& operator<<(std::ostream& stream, const ErrorText& text)
{
    return stream << text.Text();
}

} // namespace boxreel
