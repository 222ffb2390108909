// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include "CompareChoice.h"

#include <golden/ContactSheet.h>
#include <render/Backend.h>
#include <session/GoldenScenes.h>

#include <filesystem>
#include <string>
#include <vector>

namespace boxreel
{

struct GoldenOptions
{
    bool accept = false; ///< else verify
    GoldenAcceptance acceptance;
    std::filesystem::path against;  ///< verify with the states of this program; empty: references
    std::vector<std::string> names; ///< "pyramid" or "pyramid/2s"; empty: all; a film's name
    std::filesystem::path film;     ///< instead of scenes
    ContactSheetSettings sheet;     ///< of the film
    std::filesystem::path
        references; ///< empty: golden/references of the checkout around the current folder
    std::filesystem::path output; ///< folder of failures; empty: beside the references' checkout
    std::filesystem::path report; ///< a page of what was verified; empty: none
    CompareChoice compare;        ///< of the pixels
    Backend backend = Backend::Auto;
};

/// Declares `boxreel golden verify` and `golden accept` and its options to the parser, which writes
/// to `options`.
Command& Declare(Command& program, GoldenOptions& options);

/// Compares scenes with their references, or makes these.
Result<int> Run(const GoldenOptions& options);

} // namespace boxreel
