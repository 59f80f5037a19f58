#include "cromer/study/lab_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "cromer/base/ascii.h"
#include "cromer/figures/panels.h"
#include "cromer/study/collect.h"
#include "cromer/study/lab_told.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/simulate/run_law.h"

namespace cromer::core {
namespace {

std::string typed(const Quantity& mass) {
  const std::string value = shortest(mass.value);
  return mass.uncertainty > 0 ? fmt::format("{} ± {} kg", value, shortest(mass.uncertainty)) : value + " kg";
}

/// Whether a notice belongs beside the numbers of the summary: without it they would be misread.
bool qualifies(std::string_view code) {
  return code == "beats_at_first" || code == "one_mass_for_unlike_runs" ||
         code == "one_mass_for_unlike_files";
}

/// Of a step of rounding: what is less is rounding alone.
constexpr double all_rounding = 0.3;

/// One recording's part of the study.
class Part : public LabTold {
 public:
  Part(const ReportedRecording& recording, std::string file, std::string id, bool alone,
       const ReportFront& front, StudyWriter& toml)
      : LabTold(recording, std::move(file), std::move(id), alone, front),
        methods_(id_ + "_methods"),
        forward_(methods_ + ".1"),
        cromer_(methods_ + ".2"),
        exact_(id_ + "_exact.1"),
        toml_(toml) {
    if (fitted_.succeeded() && simulates()) steps_ = steps_until_it_leaves();
  }

  void write(const std::vector<TypedOption>& options) {
    if (fitted_.wrong_input) return refused();
    task(options);
    if (fitted_.succeeded() && simulates()) simulation();
    heading("report_measured");
    paragraph(words("report_samples", {{"file", verbatim(title())},
                                       {"column", column()},
                                       {"used", used()},
                                       {"part", part()},
                                       {"duration", in_braces("duration, 4")},
                                       {"rate", rate()},
                                       {"aside", set_aside()}}));
    record_figure();
    if (const std::string read = sentences_of(of_the_record()); !read.empty()) paragraph(verbatim(read));
    if (!fitted_.succeeded()) return failed();
    law();
    // What follows from a law that does not describe the motion is not told.
    if (is_poorly_described()) return not_told();
    if (!fitted_.driven) decay();
    if (fitted_.find("stiffness")) stiffness();
    if (fitted_.reynolds_max) reynolds();
    if (simulates()) methods();
    if (fitted_.driven) resonance();
    not_told();
  }

  /// The lines of the summary.
  std::vector<std::string> summary() const {
    if (!fitted_.succeeded()) return {no_law()};
    if (is_poorly_described()) {
      const std::string round = sentence_of("sensor_turns_round");
      const std::string why = round.empty() ? words("report_perhaps_a_part") : " " + round;
      return {words("report_poorly_described", {{"file", verbatim(title())}, {"rms", rms()}, {"why", why}})};
    }
    std::vector<std::string> lines;
    const auto add = [&](std::string_view code, std::vector<NoticeValue> values) {
      lines.push_back(words(code, std::move(values)));
    };
    // Also where a velocity or an acceleration was measured this is a displacement.
    const bool harmonic = fitted_.find("drive_frequency") != nullptr;
    add(!is_known("frequency") ? fitted_.driven ? "report_driven_motion" : "report_free_motion"
        : harmonic             ? "report_driven_by"
        : fitted_.driven       ? "report_driven_at"
        : has_only_parts()
            ? has_another_frequency_at_last() ? "report_swings_from_to" : "report_swings_at_first"
        : has_amplitude() ? "report_swings_at_amplitude"
                          : "report_swings_at",
        {{"file", verbatim(title())},
         {"frequency", in_braces(has_only_parts() ? "first_stretch.frequency" : "frequency")},
         {"drive", in_braces("drive_frequency, Hz")},
         {"amplitude", has_only_parts() ? amplitude_of("first_stretch") : at_amplitude()},
         {"last", has_only_parts() ? in_braces("last_stretch.frequency") : ""},
         {"last_amplitude", has_only_parts() ? amplitude_of("last_stretch") : ""}});
    if (fitted_.find("stiffness"))
      add("report_spring_constant",
          {{"stiffness", as_far_as_known("stiffness")},
           {"mass", in_braces("mass, g")},
           {"alone", fitted_.options.spring_mass ? words("report_and_a_third_of_the_springs",
                                                         {{"spring", in_braces("spring_mass, g")}})
                                                 : words("report_without_the_springs_own")},
           {"swings", has_bent_spring() ? words("report_for_small_swings") : ""}});
    for (const Notice& notice : fitted_.notices)
      if (qualifies(notice.code)) lines.push_back(verbatim(words("report_sentence", {{"what", notice}})));
    if (const std::string ends = decay_ends(); !ends.empty()) lines.push_back(ends);
    if (fitted_.reynolds_max) add("report_largest_reynolds", {{"largest", as_far_as_known("reynolds.max")}});
    if (const Notice doubt = first_doubt(); !doubt.empty())
      lines.push_back(verbatim(words("report_sentence", {{"what", doubt}})));
    if (const std::string other = sentence_of("swings_alongside"); !other.empty()) lines.push_back(other);
    return lines;
  }

  void key_figures() const {
    if (is_poorly_described()) return;
    const auto key = [&](std::string_view code, const std::string& value, const std::string& remark) {
      toml_.key_figure(words(code), in_braces(value + large()), remark);
    };
    // Of a swing whose frequency and damping change as it dies down.
    const std::string there = depends_on_amplitude() && !has_only_parts()
                                  ? words("report_of_amplitude", {{"amplitude", at_amplitude()}})
                                  : "";
    if (has_only_parts())
      toml_.key_figure(words("frequency"), in_braces("first_stretch.frequency, concise"),
                       words("report_of_amplitude", {{"amplitude", amplitude_of("first_stretch")}}));
    else if (is_known("frequency"))
      key("frequency", "frequency",
          there.empty() ? words("report_period_is", {{"period", in_braces("period, 4")}}) : there);
    if (const Estimate* k = fitted_.find("stiffness"))
      key("stiffness", "stiffness", ends_of("stiffness", *k));
    if (fitted_.find("drive_frequency")) key("drive_frequency", "drive_frequency, Hz", "");
    if (fitted_.driven && fitted_.find("decay_rate"))
      key("decay_rate", "decay_rate", ends_of("decay_rate", *fitted_.find("decay_rate")));
    if (const Parameter* start = named(fitted_.headline, "decay_rate_start")) key_rate(*start, key);
    if (fitted_.reynolds_max)
      key("report_reynolds_max", "reynolds.max", words("report_at", {{"t", in_braces("reynolds.t, 3")}}));
    else if (is_known("quality_factor") && !lacks_a_law() &&
             std::isfinite(fitted_.find("quality_factor")->high))
      key("quality_factor", "quality_factor", there);
  }

  /// The decay rate among them; `key` adds one by the law.
  template <class Key>
  void key_rate(const Parameter& start, const Key& key) const {
    if (has_only_parts())
      return toml_.key_figure(words("report_rate_at_first"), in_braces("first_stretch, concise"),
                              words("report_of_a_part", {{"rate", in_braces("last_stretch")}}));
    if (has_only_a_common_rate())
      return key("decay_rate", "common_decay",
                 words("report_at_rms_amplitude", {{"amplitude", amplitude_of("common_decay")}}));
    if (has_one_rate() || !named(fitted_.headline, "decay_rate_end"))
      return key(has_one_rate() ? "decay_rate" : "report_rate_at_start", "decay_rate_start",
                 ends_of("decay_rate_start", start.estimate));
    key("report_rate_at_start", "decay_rate_start",
        words("report_at_end", {{"rate", in_braces(is_doubted() ? "decay_rate_end, 3" : "decay_rate_end")}}));
  }

  /// The row of this recording in the table of all.
  std::vector<std::string> row() const {
    const auto known = [&](std::string_view name) {
      return named(fitted_.headline, name) ? in_braces(std::string(name) + large()) : std::string("–");
    };
    if (!fitted_.succeeded() || is_poorly_described()) return {verbatim(title()), "–", "–", "–", "–", "–"};
    const bool parts = has_only_parts();
    return {verbatim(title()),
            parts ? in_braces("first_stretch.frequency, concise") : known("frequency"),
            known("stiffness"),
            parts ? in_braces("first_stretch, concise") : known("decay_rate_start"),
            parts ? in_braces("last_stretch, concise") : known("decay_rate_end"),
            fitted_.reynolds_max ? in_braces("reynolds.max, concise") : "–"};
  }

  /// The spring constant, where its uncertainty holds.
  const Estimate* sure_stiffness() const {
    const bool holds = fitted_.succeeded() && !is_poorly_described() && !lacks_a_law() && !is_doubted();
    return holds ? fitted_.find("stiffness") : nullptr;
  }

 private:
  // An uncertainty that does not hold is not printed beside a large number.
  bool is_doubted() const { return !first_doubt().empty(); }
  std::string large() const { return is_doubted() ? ", 3" : ", concise"; }
  std::string ends_of(std::string_view name, const Estimate& estimate) const {
    return is_doubted() ? std::string() : interval(name, estimate);
  }

  bool has_amplitude() const { return !fitted_.driven && is_known("at_amplitude"); }
  /// Whether the frequency or the damping changes as the swing dies down.
  bool depends_on_amplitude() const { return has_amplitude() && !is_linear(fitted_.fit.law); }

  bool has_bent_spring() const { return core::has_bent_spring(fitted_.fit.law); }

  /// The amplitude of the fitted motion; "" where it is not known.
  std::string at_amplitude() const {
    const Parameter* at = named(fitted_.derived, "at_amplitude");
    if (!at) return "";
    const std::string unit = readable_unit(at->unit, of_position() ? spread_ : at->estimate.value);
    return in_braces(unit.empty() ? "at_amplitude, 3" : "at_amplitude, " + unit + ", 3");
  }

  /// Whether the law gives this number: a spring that softens so far has no frequency at its amplitude.
  bool is_known(std::string_view name) const {
    if (name == "at_amplitude" && !is_known("frequency")) return false;
    const Parameter* headline = named(fitted_.headline, name);
    const Estimate* found = headline ? &headline->estimate : fitted_.find(name);
    return found && std::isfinite(found->value);
  }

  void heading(std::string_view code) {
    toml_.heading(alone_ ? words(code) : verbatim(title()) + ": " + words(code));
  }
  void paragraph(const std::string& text) { toml_.paragraph(text); }

  /// The options, and the file; of a file with several runs also which. Of several masses, its own.
  void settings(std::vector<TypedOption> options) {
    toml_.text("file", verbatim(path_));
    std::size_t masses = 0;
    for (const TypedOption& each : options)
      if (each.first == "mass") masses += split(each.second, ',').size();
    if (masses > 1) {
      std::erase_if(options, [](const TypedOption& each) { return each.first == "mass"; });
      options.emplace_back("mass", typed(fitted_.options.mass.front()));
    }
    toml_.raw(toml_settings(options));
    const bool has_run =
        std::any_of(options.begin(), options.end(), [](const auto& each) { return each.first == "run"; });
    if (fitted_.one_of_several && !has_run) toml_.bare("run", std::to_string(fitted_.series.run));
  }

  void task(const std::vector<TypedOption>& options) {
    toml_.table("task");
    toml_.text(compared_ ? "compare" : "fit", id_);
    settings(options);
    if (compared_) toml_.text("method", report_method);
    if (!fitted_.succeeded()) toml_.bare("may_fail", "true");
  }

  void refused() {
    heading("report_measured");
    paragraph(no_law());
  }

  void record_figure() {
    const std::string id = figure_id("record");
    const bool known = fitted_.succeeded() && !is_poorly_described(),
               has_level = known && (is_zero() || is_known("equilibrium"));
    const auto [low, high] = extent_of(fitted_.series.y);
    // Of a swing far from zero the ticks have few places before those that change.
    constexpr double far = 50;
    const double size = std::max((high - low) / 2, std::max(high, -low) / far);
    const std::string unit = readable_unit(unit_of(fitted_.series), size);
    FigureLines figure{.id = id,
                       .title = words("report_record_title", {{"file", verbatim(title())}}),
                       .caption = words(!has_level  ? "report_record"
                                        : is_zero() ? "report_record_with_zero"
                                                    : "report_record_with_level",
                                        {{"used", used()}, {"level", level(unit)}}),
                       .size = "wide",
                       .x = "t",
                       .y = "measured",
                       .x_name = time_axis(),
                       .y_name = with_own_unit(quantity(), unit),
                       .y_unit = unit};
    if (!fitted_.left_out.t.empty())
      figure.curves.push_back({.of = id_,
                               .role = "set-aside",
                               .name = words("report_not_used"),
                               .x = "left_out_t",
                               .y = "left_out",
                               .dots = true});
    figure.curves.push_back(
        {.of = id_, .role = "measured", .name = words("report_is_measured"), .dots = true});
    if (has_level)
      figure.curves.push_back({.of = id_,
                               .role = "fitted",
                               .name = words(is_zero() ? "report_zero" : "report_level"),
                               .y = "mean"});
    toml_.figure(figure);
  }

  void failed() {
    if (!alone_) paragraph(no_law());
    not_told();
  }

  void law() {
    heading("report_law");
    std::string text =
        fitted_.candidates.size() > 1
            ? words("report_law_chosen", {{"law", in_braces("law")},
                                          {"terms", in_braces("law_terms")},
                                          {"laws", fitted_.candidates.size()}})
            : words("report_law_asked", {{"law", in_braces("law")}, {"terms", in_braces("law_terms")}});
    text += " `" + equation() + "`. ";
    const Residual& residual = fitted_.fit.residual;
    const double step = fitted_.series.resolution;
    const LengthUnit length = length_unit(step);
    const bool is_length = si() == "m";
    text += words(residual.white ? "report_white"
                  : is_rounding(residual.rms, step)
                      ? residual.rms < all_rounding * step ? "report_rounding" : "report_mostly_rounding"
                      : "report_not_white",
                  {{"rms", rms()},
                   {"step", is_length ? step / length.metres : step},
                   {"unit", is_length ? length.symbol : si()}});
    paragraph(text);
    const std::string several = fitted_.candidates.size() > 1 ? words("report_of_several_laws") : "";
    paragraph(words("report_how", {{"several", several}}));
    if (!is_poorly_described()) table();
    for (const Notice& notice : fitted_.notices)
      if (!lacks_a_law() &&
          (notice.code == "uncertainties_widened" || notice.code == "uncertainties_hardly_widened"))
        paragraph(verbatim(words("report_sentence", {{"what", notice}})));
    wide_intervals();
    energy_beside_amplitude();
    swings_figure();
    residual_figure();
  }

  void table() {
    toml_.table("block");
    const bool by_other_laws = std::any_of(fitted_.law_doubts.begin(), fitted_.law_doubts.end(),
                                           [](const LawDoubt& each) { return each.name == "frequency"; });
    toml_.text("table", lacks_a_law() ? words("report_table_of_no_law")
                                      : words("report_table") +
                                            (by_other_laws ? words("report_table_covers_laws") : ""));
    // Without a law there are no intervals.
    toml_.bare("header",
               fmt::format("[{}, {}, {}{}]", toml_text(words("report_quantity")),
                           toml_text(words("report_its_value")),
                           lacks_a_law() ? "" : toml_text("95 %") + ", ", toml_text(words("report_term"))));
    toml_.bare("text_columns", lacks_a_law() ? "[0, 2]" : "[0, 3]");
    std::string rows;
    std::vector<std::string_view> listed;
    for (const auto* list : {&fitted_.headline, &fitted_.parameters, &fitted_.derived})
      for (const Parameter& each : *list) {
        if (std::find(listed.begin(), listed.end(), each.name) != listed.end() || !is_known(each.name) ||
            (each.name == "at_amplitude" && is_linear(fitted_.fit.law)) ||
            ((has_one_rate() || has_only_parts()) && each.name.starts_with("decay_rate_")))
          continue;
        listed.push_back(each.name);
        rows += row_of(each);
      }
    toml_.bare("rows", "[\n" + rows + "]");
  }

  /// Of few degrees of freedom a 95 % interval is much wider than twice the standard uncertainty.
  void wide_intervals() {
    if (lacks_a_law()) return;
    std::vector<std::string> names;
    std::size_t all = 0;
    for (const auto* list : {&fitted_.headline, &fitted_.parameters, &fitted_.derived})
      for (const Parameter& each : *list) {
        const Estimate& e = each.estimate;
        if (!std::isfinite(reach(e)) || !(e.standard_error > 0)) continue;
        if (each.name == "quality_factor") continue;  // one over the damping ratio: its interval is skewed
        ++all;
        const std::string name = name_in_table(each.name);
        if (is_wider(e) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      }
    if (names.empty()) return;
    paragraph(2 * names.size() > all ? words("report_few_degrees_of_most")
                                     : words("report_few_degrees", {{"names", names}}));
  }

  /// Where the spring is bent, or damping is not viscous, the quality factor and the decrement need not
  /// agree.
  void energy_beside_amplitude() {
    const Estimate *ratio = fitted_.find("damping_ratio"), *decrement = fitted_.find("logarithmic_decrement");
    constexpr double alike = 0.02;
    if (!ratio || !decrement || !(ratio->value > 0) || is_linear(fitted_.fit.law)) return;
    if (std::abs(decrement->value / (two_pi * ratio->value) - 1) > alike)
      paragraph(words("report_energy_beside_amplitude"));
  }

  /// The first periods, as the law has them and as they were measured.
  void swings_figure() {
    const double until = swings(drawn_periods);
    const bool simulated = simulates() && (of_position() || of_velocity());
    FigureLines figure{.id = {},
                       .title = words("report_swings_title"),
                       .caption = words("report_swings", {{"law", in_braces("law")}}),
                       .size = "half",
                       .x = simulated ? "t" : "since_start",
                       .y = !simulated      ? "fitted_displacement"
                            : of_position() ? "x"
                                            : "v",
                       .x_name = words("report_since_start"),
                       .y_name = with_own_unit(from_level(), shown()),
                       .y_unit = shown()};
    const std::string id = figure_id("swings");
    figure.id = id;
    CurveLines law{.of = simulated ? exact_ : id_, .role = "fitted", .name = words("report_law_curve")};
    law.to = simulated ? until : begin() + until;
    figure.curves = {law, measured_swing(until)};
    toml_.figure(figure);
  }

  void residual_figure() {
    const std::string id = figure_id("residuals");
    const std::string unit = readable_unit(si(), 4 * fitted_.fit.residual.rms);
    FigureLines figure{.id = id,
                       .title = words("report_residual_title"),
                       .caption = words("report_residual_caption", {{"rms", rms()}}),
                       .size = "half",
                       .x = "t",
                       .y = "residual",
                       .x_name = time_axis(),
                       .y_name = with_own_unit(words("report_residual"), unit),
                       .y_unit = unit};
    figure.curves.push_back({.of = id_, .role = "measured", .dots = true});
    toml_.figure(figure);
  }

  void decay() {
    const auto& stretches = fitted_.decay_by_amplitude;
    const Parameter* start = named(fitted_.headline, "decay_rate_start");
    const bool grows = !stretches.empty() && stretches.front().rate.high < 0 &&
                       stretches.back().rate.high < 0 && (!start || start->estimate.value < 0);
    const bool compared = compared_ && !explanation(*compared_).empty(),
               several = compared_ && compared_->curves.size() > 1;
    const std::string ends = decay_ends();
    if (!compared && !several && ends.empty() && fitted_.segments.empty() && stretches.size() <= 2) return;
    heading(grows ? "report_grows" : "report_dies_down");
    if (compared)
      paragraph(in_braces("explanation"));
    else if (!ends.empty())
      paragraph(first_doubt().empty()
                    ? ends
                    : verbatim(words("report_sentence", {{"what", first_doubt()}})) + " " + ends);
    if (const std::string why = why_the_rate_changes(); !why.empty()) paragraph(why);
    if (!fitted_.segments.empty()) segments();
    if (stretches.size() > 2) stretches_figures();
    if (several) compare_figure();
  }

  void segments() {
    toml_.table("block");
    toml_.text("table", words("report_segments"));
    toml_.bare("header", fmt::format("[{}, {}, {}]", toml_text(words("report_from")),
                                     toml_text(words("report_to")), toml_text(words("decay_rate"))));
    toml_.bare("text_columns", "[]");
    std::string rows;
    for (std::size_t i = 1; i <= fitted_.segments.size(); ++i)
      rows += fmt::format("  [{}, {}, {}],\n", toml_text(in_braces(fmt::format("segment.{}.from, 4", i))),
                          toml_text(in_braces(fmt::format("segment.{}.to, 4", i))),
                          toml_text(in_braces(fmt::format("segment.{}.rate", i))));
    toml_.bare("rows", "[\n" + rows + "]");
  }

  /// What is measured of the stretches against their amplitude, with the law's curve.
  void stretches_figure(FigureLines figure, std::string_view law, std::string_view bar) {
    const std::string id = figure_id(figure.id);
    const auto& all = fitted_.decay_by_amplitude;
    const auto [smallest, largest] = std::minmax_element(
        all.begin(), all.end(),
        [](const AmplitudeRate& a, const AmplitudeRate& b) { return a.amplitude < b.amplitude; });
    figure.id = id;
    figure.x = "amplitude";
    figure.x_unit = readable_unit(units_.displacement, largest->amplitude);
    figure.x_name =
        with_unit(words("report_amplitude"), figure.x_unit.empty() ? units_.displacement : figure.x_unit);
    constexpr double worth_a_zero = 0.5;  // else an axis from 0 is half empty
    figure.x_logarithmic = span_a_decade(all);
    figure.x_from_zero = !figure.x_logarithmic && smallest->amplitude < worth_a_zero * largest->amplitude;
    figure.curves = {
        {.of = id_, .role = "fitted", .name = words("report_law_curve"), .x = "law_amplitude", .y = law},
        {.of = id_, .role = "measured", .x = "bar_amplitude", .y = bar},
        {.of = id_, .role = "measured", .name = words("report_is_measured"), .dots = true}};
    toml_.figure(figure);
  }

  void stretches_figures() {
    const auto& all = fitted_.decay_by_amplitude;
    const bool both = has_bent_spring() || has_another_frequency_at_last();
    const std::string_view size = both ? "half" : "wide";
    stretches_figure({.id = "decay",
                      .title = words("report_decay_title"),
                      .caption = words("report_decay_caption", {{"stretches", in_braces("stretches, bare")}}),
                      .size = size,
                      .y = "rate",
                      .y_name = words("report_rate_axis"),
                      .y_from_zero = std::all_of(all.begin(), all.end(),
                                                 [](const AmplitudeRate& each) {
                                                   return each.law_rate >= 0 &&
                                                          each.rate.value >= each.rate.standard_error;
                                                 })},
                     "law_curve", "bar_rate");
    if (both)
      stretches_figure(
          {.id = "frequencies",
           .title = words("report_frequencies_title"),
           .caption = words("report_frequencies_caption", {{"stretches", in_braces("stretches, bare")}}),
           .size = size,
           .y = "stretch_frequency",
           .y_name = words("report_frequency_axis")},
          "law_frequency", "bar_frequency");
  }

  void compare_figure() {
    const std::string id = figure_id("compared"), one = id_ + ".1", law = id_ + ".2";
    const bool other = !(compared_->curves[0].law == compared_->curves[1].law);
    const std::string unit = readable_unit(si(), compared_->curves.front().rms);
    const std::string left = unit.empty() ? std::string("rms, 3") : fmt::format("rms, {}, 3", unit);
    FigureLines figure{.id = id,
                       .title = words("report_compared_title"),
                       .caption = words(other ? "report_compared_two" : "report_compared_one",
                                        {{"one", in_braces("1." + left)}, {"law", in_braces("2." + left)}}),
                       .size = "wide",
                       .x = "t",
                       .y = "displacement",
                       .x_name = time_axis(),
                       .y_name = with_own_unit(from_level(), shown()),
                       .y_unit = shown()};
    figure.curves.push_back(
        {.of = id_, .role = "measured", .name = words("report_is_measured"), .dots = true});
    const auto envelope = [&](std::string_view of, std::string_view role, const std::string& name,
                              bool dashed) {
      figure.curves.push_back(
          {.of = of, .role = role, .name = name, .x = "top_t", .y = "top", .dashed = dashed});
      figure.curves.push_back({.of = of, .role = role, .x = "bottom_t", .y = "bottom", .dashed = dashed});
    };
    if (other) envelope(law, "fitted", words("report_law_curve"), false);
    envelope(one, "constant-rate", words("one_constant_decay_rate"), true);
    toml_.figure(figure);
  }

  void stiffness() {
    heading("report_stiffness");
    const Estimate& k = *fitted_.find("stiffness");
    std::string text =
        words(fitted_.options.spring_mass ? "report_stiffness_with_spring" : "report_stiffness_is",
              {{"stiffness", as_far_as_known("stiffness")},
               {"w", as_far_as_known("angular_frequency")},
               {"mass", in_braces("mass, g")},
               {"spring", in_braces("spring_mass, g")},
               {"interval", lacks_a_law() ? words("report_not_known") : interval("stiffness", k)}});
    if (!fitted_.options.spring_mass) text += " " + words("report_without_spring_mass");
    if (depends_on_amplitude() && has_bent_spring())
      text += " " + words("report_small_swings_stiffness",
                          {{"frequency", as_far_as_known("frequency")}, {"amplitude", at_amplitude()}});
    if (const auto other = other_stiffness(fitted_))
      text += " " + words("report_other_stiffness", {{"law", to_text(other->law)},
                                                     {"rms", rms("other_stiffness.rms", other->rms)},
                                                     {"own", rms()},
                                                     {"stiffness", in_braces("other_stiffness, 5")}});
    if (const std::string lasts = sentence_of("swing_does_not_die_down"); !lasts.empty()) text += " " + lasts;
    if (lacks_a_law()) return paragraph(text);
    double most = 0;
    std::string_view source;
    for (const Contribution& each : fitted_.stiffness_budget)
      if (each.share > most) most = each.share, source = each.quantity;
    std::size_t known = 0;
    for (const Contribution& each : fitted_.stiffness_budget)
      if (each.standard_uncertainty > 0)
        ++known;
      else
        text += " " + words("report_without_error", {{"quantity", name_of(each.quantity)}});
    if (known > 1 && most > 0.5)
      text += " " + words("report_most_from", {{"quantity", name_of(std::string(source))},
                                               {"share", fmt::format("{:.0f}", 100 * most)}});
    paragraph(text);
    if (known > 1) budget();
  }
  void budget() {
    toml_.table("block");
    toml_.text("table", words("report_budget"));
    toml_.bare("header", fmt::format("[{}, {}, {}]", toml_text(words("report_from_what")),
                                     toml_text(words("report_its_part")), toml_text(words("report_share"))));
    std::string rows;
    for (std::size_t i = 0; i < fitted_.stiffness_budget.size(); ++i) {
      const Contribution& each = fitted_.stiffness_budget[i];
      if (each.standard_uncertainty > 0)
        rows += fmt::format("  [{}, {}, {}],\n", toml_text(name_of(each.quantity)),
                            toml_text(in_braces(fmt::format("budget.{}.contribution, 2", i + 1))),
                            toml_text(in_braces(fmt::format("budget.{}.share, %, 2", i + 1))));
    }
    toml_.bare("rows", "[\n" + rows + "]");
  }

  void reynolds() {
    heading("report_flow");
    std::string text = words("report_reynolds", {{"largest", as_far_as_known("reynolds.max")},
                                                 {"t", in_braces("reynolds.t, 3")},
                                                 {"last", in_braces("reynolds_last, 3")}});
    if (!fitted_.reynolds.empty() && fitted_.reynolds.back().value > 10)
      text += " " + words("report_not_stokes");
    text += " " + words("report_disc", {{"diameter", in_braces("disc_diameter, cm")}});
    text += " " + words(fitted_.options.temperature ? "report_air" : "report_air_assumed",
                        {{"temperature", in_braces("air_temperature")},
                         {"viscosity", in_braces("air_viscosity, 3")}});
    if (fitted_.find("drag_coefficient"))
      text += " " + words("report_drag_coefficient", {{"density", in_braces("air_density, 3")}});
    if (fitted_.options.disc_diameter && !lacks_a_law() && !(fitted_.options.disc_diameter->uncertainty > 0))
      text += " " + words("report_without_error", {{"quantity", name_of("disc_diameter")}});
    paragraph(text);
    const std::string id = figure_id("reynolds");
    FigureLines figure{.id = id,
                       .title = words("report_reynolds_title"),
                       .caption = words("report_reynolds_caption"),
                       .size = "wide",
                       .x = "window_t",
                       .y = "reynolds",
                       .x_name = time_axis(),
                       .y_name = words("report_reynolds_axis")};
    figure.curves.push_back({.of = id_, .role = "measured", .dots = true});
    toml_.figure(figure);
  }

  long long steps_of_most_periods() const {
    return static_cast<long long>(std::floor(swings(most_periods) / step()));
  }

  /// A free swing by forward Euler ends where a spring gives way, or a pendulum goes over its top: what
  /// follows is no swing.
  long long steps_until_it_leaves() const {
    const long long steps = steps_of_most_periods();
    const Parameter* at = named(fitted_.derived, "at_amplitude");
    if (fitted_.driven || !at) return steps;
    const Motion& motion = fitted_.fit.motion;
    return steps_within_swing(motion.per_mass, {motion.position, motion.velocity}, at->estimate.value,
                              most_times_as_far, step(), steps);
  }

  /// Where forward Euler goes to when steps_until_it_leaves() ends.
  std::string_view why_it_leaves() const {
    const Law law = fitted_.fit.law;
    if (!core::has_bent_spring(law)) return "report_leaves_far";
    if (!law.has<Pendulum>()) return "report_leaves";
    return most_times_as_far * fitted_.find("at_amplitude")->value > pi ? "report_leaves_over_top"
                                                                        : "report_leaves_far";
  }

  double until() const { return std::stod(fmt::format("{:.12g}", static_cast<double>(steps_) * step())); }

  // Forward Euler and Euler-Cromer beside the exact motion.
  void simulation() {
    const auto of = [&](const std::string& task, std::string_view method) {
      toml_.table("task");
      toml_.text("simulate", task);
      for (const auto& [option, value] : fitted_.simulate)
        if (option != "method" && option != "step" && option != "until")
          toml_.text(with_underscores(option),
                     fmt::format("{{{}.simulate.{}}}", id_, with_underscores(option)));
      toml_.bare("method", method);
      toml_.bare("step", shortest(step()));
      toml_.bare("until", shortest(until()));
      toml_.bare("quiet", "true");  // its text tells what the methods do
    };
    of(methods_, "[\"forward-euler\", \"euler-cromer\"]");
    of(id_ + "_exact", exactly() ? "\"exact\"" : "\"dormand-prince\"");
    if (!exactly()) toml_.bare("tolerance", "1e-10");
  }

  FigureLines method_figure(std::string_view id, std::string_view title, std::string_view caption,
                            std::string_view y, std::string y_name, const std::string& y_unit) const {
    return {.id = id,
            .title = words(title),
            .caption = words(caption, {{"step", fmt::format("{{{}.1.step, 2}}", methods_)}}),
            .size = "half",
            .x = "t",
            .y = y,
            .x_name = words("report_since_start"),
            .y_name = std::move(y_name),
            .y_unit = y_unit};
  }
  void add_methods(FigureLines& figure, bool with_exact) {
    if (with_exact) figure.curves.push_back({.of = exact_, .role = "exact", .name = words("report_exact")});
    figure.curves.push_back({.of = forward_, .role = "forward-euler", .name = words("forward-euler")});
    figure.curves.push_back({.of = cromer_, .role = "euler-cromer", .name = words("euler-cromer")});
  }

  /// What a method did to the energy and to the law; the parts of the law's terms are in J only with a mass.
  std::string of_method(const std::string& run, const std::string& name) const {
    std::string text = "\n\n**" + name + "**: ";
    if (!fitted_.driven)
      text += words("report_energy_grew", {{"t", fmt::format("{{{}.final.t, 3}}", run)},
                                           {"ratio", fmt::format("{{{}.energy_ratio, 3}}", run)},
                                           {"exact", fmt::format("{{{}.energy_ratio, 3}}", exact_)}}) +
              " ";
    if (exactly() || (fitted_.find("stiffness") && units_.displacement == "m"))
      text += fmt::format("{{{}.effect}}", run);
    return text;
  }

  void methods() {
    heading("report_methods");
    paragraph(words("report_methods_text",
                    {{"step", fmt::format("{{{}.1.step, 2}}", methods_)},
                     {"steps", steps_per_period},
                     {"reference", words(exactly() ? "report_closed_form" : "report_dormand_prince")}}) +
              (steps_ < steps_of_most_periods()
                   ? " " + words(why_it_leaves(), {{"t", fmt::format("{{{}.final.t, 3}}", forward_)},
                                                   {"times", most_times_as_far}})
                   : "") +
              of_method(forward_, words("forward-euler")) + of_method(cromer_, words("euler-cromer")));
    const bool length = si() == "m" || si() == "m/s";
    const Motion& motion = fitted_.fit.motion;
    // A driven motion may begin from rest.
    const double w = two_pi / period_, amplitude = std::max(std::hypot(motion.position, motion.velocity / w),
                                                            of_position() ? spread_ : 0);
    const std::string x_unit = length ? readable_unit("m", amplitude) : "";
    const std::string v_unit = length ? readable_unit("m/s", w * amplitude) : "";
    const std::string& x_shown = length ? x_unit : units_.displacement;
    const std::string& v_shown = length ? v_unit : units_.velocity;
    const std::string position = with_unit(displacement(), x_shown),
                      velocity = with_unit(
                          words(units_.displacement == "rad" ? "report_angular_velocity" : "report_velocity"),
                          v_shown);
    const std::string ids[] = {figure_id("position"), figure_id("velocity"), figure_id("portrait"),
                               figure_id("energy"), figure_id("phase")};

    FigureLines figure = method_figure(ids[0], turns() ? "report_angle_title" : "report_position_title",
                                       "report_by_both", "x", position, x_unit);
    if (of_position()) {
      figure.curves.push_back(measured_swing(until()));
      figure.caption =
          words("report_measured_and_by_both", {{"step", fmt::format("{{{}.1.step, 2}}", methods_)}});
    }
    add_methods(figure, !of_position());
    figure.size = "wide";
    toml_.figure(figure);

    figure = method_figure(ids[1], "report_velocity_title", "report_by_both", "v", velocity, v_unit);
    if (of_velocity()) {
      figure.curves.push_back(measured_swing(until()));
      figure.caption =
          words("report_measured_and_by_both", {{"step", fmt::format("{{{}.1.step, 2}}", methods_)}});
    }
    add_methods(figure, !of_velocity());
    figure.size = "tall";
    toml_.figure(figure);

    figure = method_figure(ids[2], "report_portrait_title", "report_portrait_caption", "v", velocity, v_unit);
    figure.size = "phase";
    figure.x = "x";
    figure.x_name = position;
    figure.x_unit = x_unit;
    add_methods(figure, true);
    toml_.figure(figure);

    if (fitted_.driven) return;
    const bool with_mass = fitted_.find("stiffness") != nullptr,
               in_joules = with_mass && units_.displacement == "m";
    const double mass = with_mass ? fitted_.find("stiffness")->value / (w * w) : 1;
    const std::string joules(energy_unit(mass * w * w * amplitude * amplitude / 2).symbol);
    figure = method_figure(ids[3], "report_energy_title", "report_energy_caption", "energy",
                           in_joules   ? with_unit(words("report_energy"), joules)
                           : with_mass ? with_unit(words("report_energy"), units_.energy)
                           : length    ? with_unit(words("report_energy_per_mass"), joules + "/kg")
                                       : with_unit(words("report_energy_per_mass"), units_.energy),
                           length || in_joules ? joules : "");
    figure.y_from_zero = true;
    add_methods(figure, true);
    toml_.figure(figure);

    figure = method_figure(ids[4], "report_phase_title", "report_phase_caption", "phase",
                           words("report_phase_error"), "");
    figure.curves.push_back(
        {.of = forward_, .role = "forward-euler", .name = words("forward-euler"), .minus = exact_});
    figure.curves.push_back(
        {.of = cromer_, .role = "euler-cromer", .name = words("euler-cromer"), .minus = exact_});
    toml_.figure(figure);
  }

  // The steady motion under other frequencies, of a linear law.
  void resonance() {
    const LawFit& fit = fitted_.fit;
    if (fit.drive.kind != DriveKind::harmonic || !simulates() || !(fit.law == law_of("viscous"))) return;
    heading("report_resonance");
    const std::string task = id_ + "_resonance";
    const double own = fit.motion.angular_frequency() / two_pi, drive = fit.motion.drive_frequency / two_pi;
    toml_.table("task");
    toml_.text("resonance", task);
    for (const std::string_view option : {"mass", "stiffness", "drive_amplitude"})
      toml_.text(option, fmt::format("{{{}.simulate.{}}}", id_, option));
    toml_.text("frequency_from", fmt::format("{:.3g} Hz", 0.5 * std::min(own, drive)));
    toml_.text("frequency_to", fmt::format("{:.3g} Hz", 1.5 * std::max(own, drive)));
    toml_.text("method", "exact");
    toml_.bare("points", "2000");
    toml_.text("damping_ratios", in_braces("damping_ratio, si"));
    paragraph(words("report_resonance_text",
                    {{"drive", in_braces("drive_frequency, Hz")}, {"natural", in_braces("frequency")}}) +
              (fitted_.says("rival_laws_of_a_fed_swing") ? " " + words("report_resonance_of_rivals") : "") +
              (at_amplitude().empty()
                   ? ""
                   : " " + words("report_resonance_reach", {{"amplitude", at_amplitude()}})));
    const std::string curve = task + ".1";
    const std::string ids[] = {figure_id("resonance"), figure_id("lag")};
    FigureLines figure{
        .id = ids[0],
        .title = words("report_resonance_title"),
        .caption = words("report_resonance_caption"),
        .size = "half",
        .x = "frequency",
        .y = "amplitude",
        .x_name = words("report_drive_axis"),
        .y_name = with_unit(words("report_amplitude"), si() == "m" ? "cm" : units_.displacement),
        .x_unit = "Hz",
        .y_unit = si() == "m" ? "cm" : ""};
    figure.curves.push_back({.of = curve, .role = "fitted"});
    toml_.figure(figure);
    figure.id = ids[1];
    figure.title = words("report_lag_title");
    figure.caption = words("report_lag_caption");
    figure.y = "phase";
    figure.y_name = words("report_lag_axis");
    figure.y_unit = "";
    toml_.figure(figure);
  }

  /// What is said of the recording itself: what was taken of it, assumed and repaired.
  std::vector<Notice> of_the_record() const {
    return {fitted_.notices.begin(),
            fitted_.notices.begin() + static_cast<std::ptrdiff_t>(fitted_.of_record)};
  }

  /// A sentence of each that is no detail, the worst first.
  std::string sentences_of(const std::vector<Notice>& notices) const {
    std::string text;
    for (const Notice& notice : worst_first(notices))
      if (severity(notice) != Severity::detail)
        text += (text.empty() ? "" : "\n\n") +
                words("report_sentence", {{"what", without_uncertainties(notice)}});
    return text;
  }

  /// What a notice of this code says; "" where there is none.
  std::string sentence_of(std::string_view code) const {
    for (const Notice& notice : fitted_.notices)
      if (notice.code == code) return verbatim(words("report_sentence", {{"what", notice}}));
    return "";
  }

  void not_told() {
    std::vector<Notice> open = compared_ ? compared_->notices : fitted_.notices;
    const std::vector<Notice> told = of_the_record();
    std::erase_if(open, [&](const Notice& notice) {
      const bool supposes_a_law = notice.code == "dampings_not_told_apart" ||
                                  notice.code == "parameter_on_bound" ||
                                  notice.code == "interval_cut_at_bound";
      return (lacks_a_law() && supposes_a_law) || std::find(told.begin(), told.end(), notice) != told.end();
    });
    std::string text = sentences_of(open);
    const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : "\n\n") + sentence; };
    const bool of_length = !fitted_.series.quantity.empty() && is_linear_quantity(fitted_.series.quantity);
    if (fitted_.succeeded() && of_length && fitted_.options.mass.empty() && fitted_.fit.law.shares(springs))
      add(words("report_give_mass"));
    if (fitted_.succeeded() && fitted_.series.quantity == "position" && !fitted_.options.disc_diameter)
      add(words("report_give_disc"));
    if (text.empty()) return;
    heading("report_not_told");
    paragraph(verbatim(text));
  }

  std::string methods_, forward_, cromer_, exact_;  ///< runs of the two methods, and without one
  long long steps_ = 0;                             ///< of the two methods
  StudyWriter& toml_;
};

/// Whether one spring constant would do for all recordings: chi square about their weighted mean (Birge 1932)
/// below what chance exceeds in one case of twenty, by its mean and two standard deviations.
Notice stiffness_of_all(const std::vector<Part>& parts) {
  double weights = 0, sum = 0, squares = 0;
  for (const Part& part : parts) {
    const Estimate* k = part.sure_stiffness();
    if (!k || !(k->standard_error > 0)) return {};
    const double weight = 1 / (k->standard_error * k->standard_error);
    weights += weight;
    sum += weight * k->value;
    squares += weight * k->value * k->value;
  }
  const double degrees = static_cast<double>(parts.size()) - 1, chi = squares - sum * sum / weights;
  const bool agree = chi <= degrees + 2 * std::sqrt(2 * degrees);
  return Notice{agree ? "report_stiffness_agrees" : "report_stiffness_differs"};
}

/// The name of a recording's task.
std::string task_of(std::size_t i, std::size_t count) {
  return count == 1 ? "lab" : fmt::format("lab_{}", i + 1);
}

}  // namespace

std::string lab_report(std::span<const ReportedRecording> recordings, const std::vector<TypedOption>& options,
                       const ReportFront& front) {
  const Voice voice{front.language};
  LabPage written(front);
  StudyWriter& page = written.page();
  const bool alone = recordings.size() == 1;
  std::vector<std::string> files;
  for (const ReportedRecording& each : recordings) files.push_back(each.fitted.file);
  std::vector<std::string> names = short_names(files);
  const std::string first = names.front();
  const bool of_one_file =
      !alone && std::all_of(recordings.begin(), recordings.end(), [&](const ReportedRecording& each) {
        return each.path == recordings.front().path;
      });
  if (of_one_file) std::fill(names.begin(), names.end(), "");
  std::vector<Part> parts;
  for (std::size_t i = 0; i < recordings.size(); ++i)
    parts.emplace_back(recordings[i], names[i], task_of(i, recordings.size()), alone, front, page);

  std::string summary;
  for (const Part& part : parts) {
    std::string lines;
    for (const std::string& line : part.summary()) lines += (lines.empty() ? "" : " ") + line;
    summary += (summary.empty() ? "" : "\n\n") + lines;
  }
  const Notice title = alone         ? Notice{"report_title", {{"file", verbatim(parts[0].title())}}}
                       : of_one_file ? Notice{"report_title_of_runs", {{"file", verbatim(first)}}}
                                     : Notice{"report_title_of_several", {{"count", recordings.size()}}};
  written.begin(in_words(title, voice), summary);
  if (alone && recordings[0].fitted.succeeded()) parts[0].key_figures();
  written.own_parts();
  if (!alone) {
    page.table("block");
    std::string caption = in_words(Notice{"report_recordings"}, voice);
    if (std::any_of(parts.begin(), parts.end(), [](const Part& part) { return part.has_only_parts(); }))
      caption += in_words(Notice{"report_recordings_by_parts"}, voice);
    page.text("table", caption);
    constexpr const char* codes[] = {"report_recording",     "frequency",          "stiffness",
                                     "report_rate_at_start", "report_rate_at_end", "report_reynolds_max"};
    std::string header;
    std::vector<std::string> rows(parts.size());
    for (std::size_t column = 0; column < std::size(codes); ++column) {
      // A column that no recording has a value for is left out.
      const auto known = [&](const Part& part) { return part.row()[column] != "–"; };
      if (std::none_of(parts.begin(), parts.end(), known)) continue;
      const char* between = header.empty() ? "" : ", ";
      header += between + toml_text(in_words(Notice{codes[column]}, voice));
      for (std::size_t i = 0; i < parts.size(); ++i) rows[i] += between + toml_text(parts[i].row()[column]);
    }
    std::string table;
    for (const std::string& row : rows) table += "  [" + row + "],\n";
    page.bare("header", "[" + header + "]");
    page.bare("rows", "[\n" + table + "]");
    if (const Notice all = stiffness_of_all(parts); !all.empty()) page.paragraph(in_words(all, voice));
  }
  for (Part& part : parts) part.write(options);
  return written.end();
}

KnownResults known_results(std::span<const ReportedRecording> recordings) {
  KnownResults known;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const std::string id = task_of(i, recordings.size());
    const ReportedRecording& each = recordings[i];
    known[id] = [id, &each](Results& results) {
      if (each.compared)
        collect(id, *each.compared, results);
      else
        collect(id, each.fitted, results);
    };
  }
  return known;
}

}  // namespace cromer::core
