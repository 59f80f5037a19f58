#include "cromer/study/write_report.h"

#include "cromer/study/results.h"

namespace cromer::core {
namespace {

/// A column in the unit it is drawn in.
struct DrawnColumn {
  std::vector<double> values;
  std::string axis;  ///< "position x (cm)"
};

Result<double> conversion(const std::string& from, const std::string& to) {
  if (to.empty() || to == from) return 1.0;
  const auto source = parse_unit(from);
  const auto target = parse_unit(to);
  if (!source) return source.error();
  if (!target) return target.error();
  if (!(source->dimension == target->dimension))
    return Error{"column_not_drawn_in", {{"from", from}, {"to", to}}};
  return source->factor / target->factor;
}

Result<DrawnColumn> drawn(const Results& results, const std::string& name, const std::string& unit) {
  const auto column = results.column(name);
  if (!column) return column.error();
  const auto factor = conversion((*column)->unit, unit);
  if (!factor) return factor.error();
  DrawnColumn out{(*column)->values, (*column)->name};
  for (double& value : out.values) value *= *factor;
  const std::string& shown = unit.empty() ? (*column)->unit : unit;
  if (!shown.empty()) out.axis += " (" + shown + ")";
  return out;
}

std::string column_name(const std::string& of, const std::string& column) {
  return of.empty() ? column : of + "." + column;
}

Result<void> fill_in(std::string& text, const Results& results, bool enhanced) {
  auto filled = fill(text, results);
  if (!filled) return filled.error();
  text = enhanced ? to_enhanced(*filled) : *filled;
  return {};
}

/// Leaves out the rows whose time lies outside [from, to].
Result<void> keep_range(Curve& curve, const CurveSpec& spec, const PanelSpec& panel, const Results& results) {
  const auto from = spec.from ? spec.from : panel.from;
  const auto to = spec.to ? spec.to : panel.to;
  if (!from && !to) return {};
  const auto time = results.column(column_name(spec.of, "t"));
  if (!time) return time.error();
  const std::vector<double>& t = (*time)->values;
  if (t.size() != curve.x.size()) return Error{"range_needs_times", {{"result", spec.of}}};
  std::vector<double> x, y;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if ((from && t[i] < *from) || (to && t[i] > *to)) continue;
    x.push_back(curve.x[i]);
    y.push_back(curve.y[i]);
  }
  curve.x = std::move(x);
  curve.y = std::move(y);
  return {};
}

Result<void> subtract(DrawnColumn& y, const Results& results, const CurveSpec& spec,
                      const std::string& column, const std::string& unit) {
  const auto other = drawn(results, column_name(spec.minus, column), unit);
  if (!other) return other.error();
  if (other->values.size() != y.values.size())
    return Error{"rows_not_subtracted",
                 {{"minus", spec.minus},
                  {"minus_rows", other->values.size()},
                  {"of", spec.of},
                  {"of_rows", y.values.size()}}};
  for (std::size_t i = 0; i < y.values.size(); ++i) y.values[i] -= other->values[i];
  return {};
}

Result<Curve> make_curve(const CurveSpec& spec, const PanelSpec& panel, Panel& made, const Results& results) {
  const std::string& x_column = spec.x.empty() ? panel.x : spec.x;
  const std::string& y_column = spec.y.empty() ? panel.y : spec.y;
  auto x = drawn(results, column_name(spec.of, x_column), panel.x_unit);
  if (!x) return x.error();
  auto y = drawn(results, column_name(spec.of, y_column), panel.y_unit);
  if (!y) return y.error();
  if (!spec.minus.empty())
    if (const auto done = subtract(*y, results, spec, y_column, panel.y_unit); !done) return done.error();

  Curve curve = spec.look;
  curve.x = std::move(x->values);
  curve.y = std::move(y->values);
  if (const auto done = keep_range(curve, spec, panel, results); !done) return done.error();
  if (made.x.name.empty()) made.x.name = to_enhanced(x->axis);
  if (made.y.name.empty()) made.y.name = to_enhanced(y->axis);
  for (std::string* text : {&curve.name, &curve.remark})
    if (const auto done = fill_in(*text, results, true); !done) return done.error();
  return curve;
}

}  // namespace

std::string to_enhanced(const std::string& markup) {
  std::string out;
  bool italic = false;
  for (std::size_t i = 0; i < markup.size(); ++i) {
    if (markup[i] == '*') {
      out += italic ? "}" : "{/:Italic ";
      italic = !italic;
    } else {
      out += markup[i];
    }
  }
  return italic ? markup : out;
}

Result<Figure> make_figure(const FigureSpec& spec, const Results& results) {
  Figure figure = spec.look;
  for (std::string* text : {&figure.title, &figure.caption})
    if (const auto done = fill_in(*text, results, false); !done) return spec.place.error(done.error().notice);
  for (const PanelSpec& panel_spec : spec.panels) {
    Panel panel = panel_spec.look;
    for (std::string* text : {&panel.title, &panel.x.name, &panel.y.name})
      if (const auto done = fill_in(*text, results, true); !done)
        return panel_spec.place.error(done.error().notice);
    for (const CurveSpec& curve_spec : panel_spec.curves) {
      auto curve = make_curve(curve_spec, panel_spec, panel, results);
      if (!curve) return curve_spec.place.error(curve.error().notice);
      panel.curves.push_back(std::move(*curve));
    }
    for (Note& note : panel.notes)
      if (const auto done = fill_in(note.text, results, true); !done)
        return panel_spec.place.error(done.error().notice);
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

}  // namespace cromer::core
