// SPDX-License-Identifier: MIT
#include <base/Terminal.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sys/ioctl.h>
#include <unistd.h>

namespace boxreel
{
namespace
{

std::string Styled(std::string_view text, const char* code, std::FILE* stream)
{
    if (!UsesColor(stream))
    {
        return std::string(text);
    }
    return "\x1b[" + std::string(code) + "m" + std::string(text) + "\x1b[0m";
}

} // namespace

bool IsTerminal(std::FILE* stream)
{
    return isatty(fileno(stream)) == 1;
}

bool UsesColor(std::FILE* stream)
{
    const char* noColor = std::getenv("NO_COLOR");
    const char* terminal = std::getenv("TERM");
    const bool isRefused = noColor != nullptr && *noColor != '\0';
    const bool isDumb = terminal == nullptr || std::strcmp(terminal, "dumb") == 0;
    return IsTerminal(stream) && !isRefused && !isDumb;
}

int TerminalColumns(std::FILE* stream)
{
    winsize size{};
    const bool known = ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

std::string Bold(std::string_view text, std::FILE* stream)
{
    return Styled(text, "1", stream);
}

std::string Red(std::string_view text, std::FILE* stream)
{
    return Styled(text, "31", stream);
}

Result<void> WriteOutput(std::string_view text)
{
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0)
    {
        return Error{ErrorKind::Failed, "standard output",
                     std::string("cannot be written: ") + std::strerror(errno)};
    }
    return {};
}

void WriteMessage(std::string_view line)
{
    std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
}

} // namespace boxreel
