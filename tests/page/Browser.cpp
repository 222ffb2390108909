// SPDX-License-Identifier: MIT
#include "Browser.h"

#include <gtest/gtest.h>

#include <fstream>

namespace boxreel
{

std::string Chromium()
{
    const TemporaryFolder folder;
    for (const char* const name : {"chromium", "chromium-browser", "google-chrome"})
    {
        if (RunTool({name, "--version"}, folder.Path()).code == 0)
        {
            return name;
        }
    }
    return "";
}

Outcome LoadInChromium(const std::string& browser, const std::string& page,
                       const std::string& script, const TemporaryFolder& folder)
{
    const std::string end = "</body>";
    const std::size_t at = page.rfind(end);
    EXPECT_NE(at, std::string::npos);
    std::ofstream(folder / "page.html") << page.substr(0, at) << "<script>\n"
                                        << script << "</script>\n"
                                        << page.substr(at);
    return RunTool({browser, "--headless", "--no-sandbox", "--disable-gpu",
                    "--disable-dev-shm-usage", "--no-first-run", "--enable-logging=stderr",
                    "--window-size=1300,900", "--user-data-dir=" + (folder / "profile").string(),
                    "--virtual-time-budget=20000", "--dump-dom",
                    "file://" + (folder / "page.html").string()},
                   folder.Path());
}

std::string ResultsOf(const Outcome& outcome)
{
    const std::size_t begin = outcome.output.find("\nBEGIN\n");
    const std::size_t end = outcome.output.find("\nEND\n");
    return begin == std::string::npos || end == std::string::npos
               ? "no results; " + outcome.errors
               : outcome.output.substr(begin + 7, end - begin - 7) + "\n";
}

} // namespace boxreel
