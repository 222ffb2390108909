// SPDX-License-Identifier: MIT
#pragma once

#include "Check.h"
#include "Completion.h"
#include "Diff.h"
#include "Doctor.h"
#include "Export.h"
#include "Golden.h"
#include "GoldenReport.h"
#include "GoldenState.h"
#include "List.h"
#include "Man.h"
#include "Merge.h"
#include "Play.h"
#include "Record.h"
#include "Shot.h"
#include "Ui.h"

#include <string>
#include <tuple>
#include <variant>
#include <vector>

/// The commands of the program, and the arguments that the user typed turned into one of them.
namespace boxreel
{

/// The options of every command, in the order of the help. This is the only list of commands. A
/// subcommand (`golden report`) follows its command.
using Commands =
    std::tuple<ListOptions, RecordOptions, MergeOptions, ShotOptions, DiffOptions, GoldenOptions,
               GoldenReportOptions, GoldenStateOptions, PlayOptions, UiOptions, CheckOptions,
               DoctorOptions, ExportOptions, CompletionOptions, ManOptions>;

/// `--help`, `--version`: text to print instead of doing anything.
struct TextRequest
{
    std::string text;
};

template <class List>
struct RequestFor;
template <class... Options>
struct RequestFor<std::tuple<Options...>>
{
    using Type = std::variant<TextRequest, Options...>;
};
using Request = RequestFor<Commands>::Type;

/// `arguments`: without the program's name. Opens nothing.
Result<Request> ParseCommandLine(const std::vector<std::string>& arguments);

} // namespace boxreel
