#pragma once

#include <span>
#include <string>
#include <string_view>

#include "commands.h"
#include "syntax.h"

namespace cromer::core::cli {

/// The arguments that make a command print its part of the manual.
inline constexpr std::string_view as_man = "--as-man", as_markdown = "--as-markdown";

/// `cromer help --man` and `cromer help --markdown`: every command with all its options.
int print_manual(std::string_view form, std::span<const Command> commands);

std::string man_section(const Syntax& syntax);
std::string markdown_section(const Syntax& syntax);

}  // namespace cromer::core::cli
