// Messages on standard error, all beginning with "cromer: ".
#pragma once

#include <string_view>
#include <vector>

#include "cromer/notice.h"
#include "cromer/result.h"

namespace cromer::core::cli {

/// From here on this process says nothing, on neither stream: another one says the same.
void fall_silent();

/// Says what went wrong.
void complain(std::string_view message);
void complain(const Error& error);

/// complain, and the exit status for wrong input.
int refuse(std::string_view message);
int refuse(const Error& error);

/// Says the notices that go with an answer, after it: worst first, each as "cromer: warning: ..." or, of a
/// detail, "cromer: note: ...". On a terminal no more than three unless `all`, wrapped to its width.
void tell(const std::vector<Notice>& notices, bool all);

}  // namespace cromer::core::cli
