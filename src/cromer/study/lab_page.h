// The study file of a page of own recordings: what the writer says stands around what was found.
#pragma once

#include <string>
#include <string_view>

#include "cromer/documents/words/words.h"
#include "cromer/quantity.h"
#include "cromer/study/study_writer.h"

namespace cromer::core {

/// What stands on the page beside the results.
struct ReportFront {
  std::string title;  ///< "" for one that names the recordings
  std::string author, course;
  // The writer's own, in the markup of reports: under the summary, in parts of their own before the results,
  // and behind them.
  std::string text, aim, apparatus, conclusion;
  Language language = Language::english;
};

/// Tasks, figures and blocks are written to page(). begin() comes first, own_parts() before the results.
class LabPage {
 public:
  explicit LabPage(const ReportFront& front) : front_(front) {}

  /// `title` where the writer gives none.
  void begin(const std::string& title, const std::string& summary);
  void own_parts();
  StudyWriter& page() { return page_; }
  /// The whole study, with a first line that tells whether it was changed since.
  std::string end();

 private:
  void own(const std::string& text, std::string_view heading);

  const ReportFront& front_;
  StudyWriter head_, page_;
};

/// "3.21 to 3.25": the 95 % interval of the result `name`, whose estimate this is; "at least 3.21" where it
/// has no upper end.
std::string interval_of(const std::string& name, const Estimate& estimate, Language language);

/// Whether a study file is as LabPage made it.
bool is_as_made(std::string_view study);

}  // namespace cromer::core
