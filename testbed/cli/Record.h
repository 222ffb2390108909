// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <film/RecordOptions.h>

#include <filesystem>
#include <vector>

namespace boxreel
{

/// Declares `boxreel record` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, RecordOptions& options);

/// Checks that the files can be made; simulates and writes nothing.
Result<void> Prepare(const RecordOptions& options);

/// The files that are made; of a numbered film its pattern.
std::vector<std::filesystem::path> FilesOf(const RecordOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(RecordOptions& options);

/// Makes the film.
Result<int> Run(const RecordOptions& options);

} // namespace boxreel
