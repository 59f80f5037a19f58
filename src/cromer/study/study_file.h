// A study file (TOML): tasks to run, figures to draw, and the text between them, in the order of the file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cromer/report/figure.h"
#include "cromer/result.h"

namespace cromer::core {

/// Where something stands in the study file.
struct Place {
  std::string file;
  unsigned line = 0, column = 0;

  Error error(const Notice& what) const {
    return Error{"at_place", {{"file", file}, {"line", line}, {"column", column}, {"what", what}}};
  }
};

/// One key of a task: the option's name with - for _, and one or more values as texts.
struct Setting {
  std::string option;
  std::vector<std::string> values;
  Place place;
};

/// [[task]] with its command as key: `simulate = "name"`, then the command's options.
struct TaskSpec {
  std::string command;  ///< simulate, fit, compare, resonance, local-error, method-map,
                        ///< work-precision, spectrum, sweep, difference
  std::string id;       ///< what its results are called
  std::vector<Setting> settings;
  std::string shows;  ///< part of a notice's words, of what the task is to show; "" where nothing is
  Place place;
};

/// [[figure.panel.curve]] or [[figure.curve]]: columns x and y of a result.
struct CurveSpec {
  std::string of;     ///< "undamped.1"; x and y are its columns
  std::string minus;  ///< another result whose y is taken off, row by row
  std::string x, y;   ///< columns; the panel's by default
  std::optional<double> from,
      to;  ///< [s] rows whose time (the result's column t) lies outside are left out; the panel's by default
  Curve look;  ///< role, name, remark, mark, dashed, label places; no numbers yet
  Place place;
};

struct PanelSpec {
  std::string x, y;                ///< columns of the curves
  std::string x_unit, y_unit;      ///< what to draw them in; SI by default
  std::optional<double> from, to;  // [s]
  Panel look;  ///< title, axes, notes, phase_portrait; names of axes made from column and unit where empty
  std::vector<CurveSpec> curves;
  Place place;
};

/// `look.id` is the name of its file without ending: letters, digits, - and _.
struct FigureSpec {
  Figure look;  ///< id, title, caption, size, columns
  std::vector<PanelSpec> panels;
  double width = 1;  ///< of the page's column
  Place place;
};

/// A table whose cells are texts with results in them. `each` repeats `row` for every run of the tasks named,
/// with {.name} relative to the run.
struct TableSpec {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> each, row;
  std::vector<int> text_columns{0};
  int answer_column = -1;
};

/// [[block]]: what the page shows, in order.
struct BlockSpec {
  struct Heading {
    std::string text;
  };
  struct Text {
    std::string text;
  };
  struct Code {
    std::string text, caption;
  };
  struct FigureName {
    std::string id;
  };
  std::variant<Heading, Text, Code, FigureName, TableSpec> content;
  Place place;
};

struct KeyFigureSpec {
  std::string name, value, remark;
};

struct Study {
  std::string file;
  std::string folder;  ///< paths in the study are relative to it
  std::string title, byline, summary;
  std::vector<KeyFigureSpec> key_figures;
  std::vector<TaskSpec> tasks;
  std::vector<FigureSpec> figures;
  std::vector<BlockSpec> blocks;
};

/// Reads a study. Errors name file, line and column; an unknown key gets the nearest right one suggested.
Result<Study> read_study(std::string_view toml, const std::string& file);

}  // namespace cromer::core
