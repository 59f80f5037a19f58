#include "message.h"

#include <cstdio>

#include "cromer/base/utf8.h"
#include "exit_status.h"

namespace cromer::core::cli {
namespace {

bool silent = false;

}  // namespace

void fall_silent() {
  silent = true;
  if (!std::freopen("/dev/null", "w", stdout)) std::fclose(stdout);
}

void complain(std::string_view message) {
  if (silent) return;
  std::fprintf(stderr, "cromer: %s\n", printable(message).c_str());
}

int refuse(std::string_view message) {
  complain(message);
  return wrong_input;
}

void warn(const std::vector<std::string>& warnings, bool quiet) {
  if (quiet) return;
  for (const auto& warning : warnings) complain("warning: " + warning);
}

}  // namespace cromer::core::cli
