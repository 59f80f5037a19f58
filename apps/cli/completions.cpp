// Completions for the shell. The scripts ask the program itself for its commands and options, so they stay
// right when it changes.
#include "completions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "message.h"
#include "output.h"

namespace cromer::core::cli {
namespace {

struct Shell {
  std::string_view name, script;
};

constexpr Shell shells[] = {
    {"bash", R"shell(# Put this into ~/.bashrc:  source <(cromer completions bash)
_cromer() {
  local word=${COMP_WORDS[COMP_CWORD]} list=commands
  ((COMP_CWORD > 1)) && list=${COMP_WORDS[1]}
  COMPREPLY=()
  if ((COMP_CWORD == 1)) || [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(cromer completions "$list" 2>/dev/null | cut -f1)" -- "$word")
  fi
}
complete -o default -o bashdefault -F _cromer cromer
)shell"},
    {"zsh", R"shell(#compdef cromer
# Put this into ~/.zshrc, after compinit:  source <(cromer completions zsh)
_cromer() {
  local list=commands
  ((CURRENT > 2)) && list=$words[2]
  local -a found
  if ((CURRENT == 2)) || [[ $words[CURRENT] == -* ]]; then
    found=(${(f)"$(cromer completions $list 2>/dev/null | sed 's/:/\\:/g; s/\t/:/')"})
    _describe -t values cromer found
  else
    _files
  fi
}
if [[ $funcstack[1] == _cromer ]]; then _cromer "$@"; else compdef _cromer cromer; fi
)shell"},
    {"fish", R"shell(# Put this into a file:  cromer completions fish > ~/.config/fish/completions/cromer.fish
complete -c cromer -f -n __fish_use_subcommand -a '(cromer completions commands 2>/dev/null)'
complete -c cromer -n 'string match -q -- "-*" (commandline -ct)' \
  -a '(cromer completions (commandline -opc)[2] 2>/dev/null)'
)shell"},
};

}  // namespace

int run_completions(const Arguments& arguments, std::span<const Command> commands) {
  const std::string_view asked = arguments.size() == 1 ? std::string_view(arguments.front()) : "";
  for (const Shell& shell : shells)
    if (asked == shell.name) return print_all(std::string(shell.script));
  if (asked == "commands") {
    std::string list;
    for (const Command& command : commands)
      list += fmt::format("{}\t{}\n", command.name, command.description);
    return print_all(list);
  }
  for (const Command& command : commands)
    if (asked == command.name) return command.run({std::string(list_options)});
  return refuse("completions takes one word: bash, zsh or fish for a script to be sourced");
}

}  // namespace cromer::core::cli
