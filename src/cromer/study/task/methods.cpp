#include "cromer/study/task/methods.h"

#include "cromer/methods/all.h"

namespace cromer {

std::vector<MethodRow> list_methods() {
  std::vector<MethodRow> rows;
  for (const MethodInfo& info : method_infos)
    rows.push_back({.name = info.name,
                    .order = info.order > 0 ? std::optional<int>(info.order) : std::nullopt,
                    .implicit = info.implicit,
                    .symplectic = info.symplectic,
                    .adaptive = info.error_order > 0,
                    .source = info.source});
  return rows;
}

}  // namespace cromer
