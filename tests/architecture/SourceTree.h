// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Reads the source tree as text and reports violations of the rules of ARCHITECTURE.md: allowed
/// includes, the files that may name a foreign library, and the first lines of every file. Called
/// by the tests only. Never compiles or preprocesses anything, so an include under #if counts too.
namespace architecture
{

/// Every check returns one sentence per finding, "path:line: what and why", sorted by path.
using Findings = std::vector<std::string>;

/// Includes that go up the picture, tests included from outside tests, files outside every layer.
Findings CheckLayers(const std::filesystem::path& root);

/// Foreign headers outside the one file (or family of files) that wraps the library.
Findings CheckForeignLibraries(const std::filesystem::path& root);

/// The licence line on top, at most 700 lines, no absolute path of one machine.
Findings CheckFiles(const std::filesystem::path& root);

/// Names of tests of more than 60 characters: `Suite.Name` of C++, without program and parameter,
/// and `Class.test_name` of Python.
Findings CheckTestNames(const std::filesystem::path& root);

/// Commands in `compileCommands` (compile_commands.json) for sources below `root` that would let
/// the compiler change floating-point results.
Findings CheckExactArithmetic(const std::filesystem::path& root,
                              const std::filesystem::path& compileCommands);

/// Folders the top CMakeLists.txt builds that the boxreel script does not watch for changes.
Findings CheckWatchedFolders(const std::filesystem::path& root);

/// Files and folders that ARCHITECTURE.md, CONTRIBUTING.md and docs/notes name and that do not
/// exist.
Findings CheckDocumentPaths(const std::filesystem::path& root);

} // namespace architecture
