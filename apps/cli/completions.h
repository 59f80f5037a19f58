#pragma once

#include <span>
#include <string_view>

#include "commands.h"

namespace cromer::core::cli {

/// The argument that makes a command list its options, a line each: "--mass", a tab, what it is.
inline constexpr std::string_view list_options = "--list-options";

/// `cromer completions bash|zsh|fish`, which is a script; "commands" and the name of a command, which the
/// scripts ask for.
int run_completions(const Arguments& arguments, std::span<const Command> commands);

}  // namespace cromer::core::cli
