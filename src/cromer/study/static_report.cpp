#include "cromer/study/static_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/extent.h"
#include "cromer/base/length_unit.h"
#include "cromer/documents/text/words.h"
#include "cromer/study/collect.h"

namespace cromer::core {
namespace {

constexpr const char* task_name = "lab";

class StaticReport {
 public:
  StaticReport(const StaticStiffness& found, const ReportFront& front)
      : found_(found), front_(front), written_(front), toml_(written_.page()) {
    std::vector<double> positions;
    double farthest = 0;
    for (const Hold& hold : found.holds) {
      positions.push_back(hold.position);
      farthest = std::max(farthest, std::abs(residual_of(found, hold)) + error_about_line(found, hold));
    }
    const auto [low, high] = extent_of(positions);
    unit_ = length_unit(high - low).symbol;
    constexpr double in_thousands = 3;  // ticks up to a few hundred are read best
    small_unit_ = length_unit(in_thousands * farthest).symbol;
  }

  std::string make(const std::vector<std::string>& paths, const std::vector<std::string>& files,
                   const std::vector<TypedOption>& options) {
    std::string called;
    for (const std::string& file : files) called += (called.empty() ? "" : ", ") + verbatim(file);
    written_.begin(words("report_held_title", {{"file", called}}),
                   words("report_held", {{"file", called},
                                         {"count", found_.holds.size()},
                                         {"stiffness", "{lab.stiffness}"},
                                         {"interval", interval()}}));
    toml_.key_figure(words("stiffness"), "{lab.stiffness, concise}", interval());
    written_.own_parts();
    task(paths, options);
    heading("report_measured");
    toml_.paragraph(words("report_holds", {{"count", found_.holds.size()}}));
    table();
    heading("report_stiffness");
    toml_.paragraph(
        words("report_held_stiffness",
              {{"gravity", "{lab.gravity}"}, {"stiffness", "{lab.stiffness}"}, {"interval", interval()}}));
    if (!given(options, "gravity")) toml_.paragraph(words("report_gravity_assumed"));
    const auto is_exact = [](const Hold& hold) { return hold.mass.uncertainty == 0; };
    if (std::all_of(found_.holds.begin(), found_.holds.end(), is_exact))
      toml_.paragraph(words("report_masses_without_error"));
    figures();
    if (!found_.notices.empty()) {
      heading("report_not_told");
      for (const Notice& notice : worst_first(found_.notices))
        toml_.paragraph(verbatim(words("report_sentence", {{"what", notice}})));
    }
    return written_.end();
  }

 private:
  Voice voice() const { return {front_.language}; }
  std::string words(std::string_view code, std::vector<NoticeValue> values = {}) const {
    Notice notice{std::string(code)};
    notice.values = std::move(values);
    return in_words(notice, voice());
  }
  std::string interval() const { return interval_of("lab.stiffness", found_.stiffness, front_.language); }

  static bool given(const std::vector<TypedOption>& options, std::string_view name) {
    return std::any_of(options.begin(), options.end(), [&](const auto& each) { return each.first == name; });
  }

  void heading(std::string_view code) { toml_.heading(words(code)); }

  void task(const std::vector<std::string>& paths, const std::vector<TypedOption>& options) {
    toml_.table("task");
    toml_.text("fit", task_name);
    std::vector<TypedOption> settings;
    for (const std::string& path : paths) settings.emplace_back("file", path);
    for (const TypedOption& each : options)
      settings.emplace_back(each.first, each.second.empty() ? "true" : each.second);
    toml_.raw(toml_settings(settings));
  }

  void table() {
    toml_.table("block");
    toml_.text("table", words("report_holds_table"));
    std::string header, rows;
    for (const char* code : {"report_recording", "report_mass", "report_rest", "report_off_line"})
      header += (header.empty() ? "" : ", ") + toml_text(words(code));
    toml_.bare("header", "[" + header + "]");
    toml_.bare("text_columns", "[0]");
    for (std::size_t i = 1; i <= found_.holds.size(); ++i)
      rows += fmt::format("  [{}, {}, {}, {}],\n", toml_text(fmt::format("{{lab.{}.label}}", i)),
                          toml_text(fmt::format("{{lab.{}.mass, g}}", i)),
                          toml_text(fmt::format("{{lab.{}.position, {}}}", i, unit_)),
                          toml_text(fmt::format("{{lab.{}.residual, {}, 2, signed}}", i, small_unit_)));
    toml_.bare("rows", "[\n" + rows + "]");
  }

  void figures() {
    FigureLines line{.id = "static",
                     .title = words("report_held_line_title"),
                     .caption = words("report_held_line"),
                     .size = "half",
                     .x = "mass",
                     .y = "position",
                     .x_name = words("report_mass_axis"),
                     .y_name = fmt::format("{} ({})", words("report_rest"), unit_),
                     .x_unit = "g",
                     .y_unit = std::string(unit_)};
    line.curves = {
        {.of = task_name, .role = "fitted", .name = words("report_line"), .x = "line_mass", .y = "line"},
        {.of = task_name, .role = "measured", .name = words("report_is_measured"), .dots = true}};
    toml_.figure(line);
    FigureLines rest = line;
    rest.id = "residuals";
    rest.title = words("report_held_residual_title");
    rest.caption = words("report_held_residual");
    rest.y = "residual";
    rest.y_name = fmt::format("{} ({})", words("report_residual"), small_unit_);
    rest.y_unit = small_unit_;
    rest.curves = {{.of = task_name, .role = "measured", .x = "bar_mass", .y = "bar_residual"},
                   {.of = task_name, .role = "measured", .dots = true}};
    toml_.figure(rest);
  }

  const StaticStiffness& found_;
  const ReportFront& front_;
  LabPage written_;
  StudyWriter& toml_;
  std::string_view unit_, small_unit_;
};

}  // namespace

std::string static_report(const StaticStiffness& found, const std::vector<std::string>& paths,
                          const std::vector<std::string>& files, const std::vector<TypedOption>& options,
                          const ReportFront& front) {
  return StaticReport(found, front).make(paths, files, options);
}

KnownResults known_results(const StaticStiffness& found) {
  return {{task_name, [&found](Results& results) { collect(task_name, found, results); }}};
}

}  // namespace cromer::core
