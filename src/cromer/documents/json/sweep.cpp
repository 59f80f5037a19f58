#include <cmath>

#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"

namespace cromer::core {

std::string to_json(const SweepResult& result, bool with_rows, const Voice& voice) {
  const SweepPlan& plan = result.plan;
  Json document;
  Json& swept = document["swept"] = Json::array();
  for (const SweptOption& option : plan.swept)
    swept.push_back({{"name", option.name}, {"column", option.column}, {"points", option.points}});
  document["method"] = plan.method;
  document["way"] = plan.way;
  document["steps"] = plan.steps;
  document["simd"] = plan.simd;
  document["points"] = plan.rows.rows;
  document["not_settled"] = result.counts.not_settled;
  document["not_finite"] = result.counts.not_finite;
  document["no_convergence"] = result.counts.no_convergence;
  document["unstable"] = result.counts.unstable;
  document["settled_by_own_damping"] = result.counts.own_damping;
  document["phase_outside"] = result.counts.phase_outside;
  if (result.check)
    document["check"] = {{"points", result.check->points},
                         {"difference", result.check->difference},
                         {"left_out", result.check->left_out}};
  const std::size_t width = plan.rows.columns.size() - 1;
  Json& columns = document["columns"] = Json::array();
  for (std::size_t i = 0; i < width; ++i) columns.push_back(plan.rows.columns[i]);
  if (with_rows) {
    Json& rows = document["rows"] = Json::array();
    for (std::size_t at = 0; at < result.rows.size(); at += width) {
      Json row = Json::array();
      for (std::size_t i = 0; i < width; ++i) row.push_back(result.rows[at + i]);
      rows.push_back(std::move(row));
    }
  }
  Json& statuses = document["statuses"] = Json::array();
  for (const unsigned char status : result.statuses) statuses.push_back(status_word(plan, status));
  add_notices(document, notices_of(result), voice);
  if (result.interrupted) document["message"] = "interrupted: rows that were not reached are null";
  return to_text(document, true);
}

}  // namespace cromer::core
