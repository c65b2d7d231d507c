// The only place where text from the command line becomes types.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "harness/commands.h"

namespace mda {

using Command = std::variant<ListCommand, RunCommand, ExportCommand, SolveCommand, CertifyCommand,
                             FlowCommand, VerifyCommand, DoctorCommand>;

/// The command, or nothing if --help or --version was asked for and printed to stdout. Throws
/// InputError.
[[nodiscard]] std::optional<Command> parse_command_line(int argc, const char* const* argv);

}  // namespace mda
