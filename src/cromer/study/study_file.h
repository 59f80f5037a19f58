// A study file (TOML): tasks to run, figures to draw, and the text between them, in the order of the file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cromer/read/place.h"
#include "cromer/report/figure.h"
#include "cromer/result.h"

namespace cromer::core {

/// A text of the page, with results in it.
struct StudyText {
  std::string text;
  Place place{};
};

/// One key of a task: the name of the option, with - for _, and one or more values as texts.
struct Setting {
  std::string option;
  std::vector<std::string> values;
  Place place;
};

/// [[task]]: the command and the name of its results, `simulate = "name"`, then the options of the command.
struct TaskSpec {
  std::string command;  ///< one of study_commands()
  std::string id;       ///< the name of its results
  std::vector<Setting> settings;
  bool may_fail = false;  ///< a fit that finds no law: the study goes on, with the recording
  bool quiet = false;     ///< its notices are not told
  std::string shows;      ///< part of the sentence of a notice that the task is meant to show; "" if none is
  Place place;
};

/// [[figure.panel.curve]] or [[figure.curve]]: columns x and y of a result.
struct CurveSpec {
  std::string of;     ///< "undamped.1"; x and y are its columns
  std::string minus;  ///< another result whose y is subtracted, row by row
  std::string x, y;   ///< columns; the panel's by default
  std::optional<double> from,
      to;  ///< [s] rows whose time (column t of the result) is outside are left out; the panel's by default
  Curve look;  ///< role, name, remark, mark, dashed, label places; no numbers yet
  Place place;
};

struct PanelSpec {
  std::string x, y;                ///< columns of the curves
  std::string x_unit, y_unit;      ///< units to draw them in; SI by default
  std::optional<double> from, to;  // [s]
  Panel look;  ///< title, axes, notes, phase_portrait; an axis without a name gets that of its column
  std::vector<CurveSpec> curves;
  Place place;
};

/// [[figure]]. `look.id` is the name of its file without the ending: letters, digits, - and _.
struct FigureSpec {
  Figure look;  ///< id, title, caption, size, columns
  std::vector<PanelSpec> panels;
  double width = 1;  ///< as a fraction of the page's column
  Place place;
};

/// A table whose cells are texts with results in them. `row` is repeated for every run of the tasks in
/// `each`; {.name} in it is relative to the run.
struct TableSpec {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> each, row;
  std::vector<int> text_columns{0};
  int answer_column = -1;
};

/// [[block]]: a part of the page.
struct BlockSpec {
  struct Heading {
    StudyText text;
  };
  struct Text {
    StudyText text;
  };
  struct Code {
    StudyText text, caption;
  };
  struct FigureName {
    std::string id;
  };
  std::variant<Heading, Text, Code, FigureName, TableSpec> content;
  Place place;
};

struct KeyFigureSpec {
  StudyText name, value, remark;
};

struct Study {
  std::string file;
  std::string folder;                     ///< paths in the study are relative to it
  Language language = Language::english;  ///< of its sentences and numbers
  StudyText title, byline, summary;
  std::vector<KeyFigureSpec> key_figures;
  std::vector<TaskSpec> tasks;
  std::vector<FigureSpec> figures;
  std::vector<BlockSpec> blocks;
};

/// Reads a study. Errors name file, line and column; of an unknown key the nearest known one is suggested.
Result<Study> read_study(std::string_view toml, const std::string& file);

}  // namespace cromer::core
