#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // The study file.
    {"at_place", clause, "{file}:{line}:{column}: {what}", "{file}:{line}:{column}: {what}"},
    {"not_toml", error,
     "{why}. A line is name = value, with quotes about all but numbers, true and false: mass = \"217.6 g\"",
     "kein gültiges TOML: {why}. Eine Zeile ist Name = Wert, mit Anführungszeichen um alles außer Zahlen, "
     "true und false: mass = \"217.6 g\""},
    {"study_without_task", error, "{file}: there is nothing to do: a study has at least one [[task]]",
     "{file}: nichts ist zu tun: eine Studie hat mindestens eine [[task]]"},
    {"task_without_command", error,
     "a [[task]] needs its command and a name for its results: simulate = \"name\" (or fit, compare, "
     "resonance, local_error, method_map, work_precision, spectrum, sweep, difference)",
     "eine [[task]] braucht ihren Befehl und einen Namen für ihre Ergebnisse: simulate = \"name\" (oder "
     "fit, compare, resonance, local_error, method_map, work_precision, spectrum, sweep, difference)"},
    {"task_name_taken", error, "each task needs a name of its own",
     "jede [[task]] braucht einen eigenen Namen"},
    {"figure_id_taken", error, "each figure needs an id of its own", "jede Abbildung braucht eine eigene id"},
    {"figure_id_is_file_name", error, "the id \"{id}\" becomes a file's name: letters, digits, - and _ only",
     "die id „{id}“ wird ein Dateiname: nur Buchstaben, Ziffern, - und _"},
    {"figure_without_curves", error,
     "a figure or panel needs curves: write [[figure.curve]] or [[figure.panel.curve]]",
     "eine Abbildung oder ein Feld braucht Kurven: bitte [[figure.curve]] oder [[figure.panel.curve]] "
     "schreiben"},
    {"no_such_figure", error, "\"{id}\" is no figure of this study",
     "„{id}“ ist keine Abbildung dieser Studie"},
    {"key_not_known", error, "\"{key}\" is not known here{near}", "„{key}“ ist hier unbekannt{near}"},
    {"perhaps_quoted", clause, "; did you mean \"{near}\"?", "; ist „{near}“ gemeint?"},
    {"key_is_one_of", error, "\"{key}\" is one of {names}", "„{key}“ ist eines von {names}"},
    {"key_takes_text", error, "\"{key}\" takes a text in quotes",
     "„{key}“ nimmt einen Text in Anführungszeichen"},
    {"key_takes_number", error, "\"{key}\" takes a number", "„{key}“ nimmt eine Zahl"},
    {"key_takes_whole_number", error, "\"{key}\" takes a whole number", "„{key}“ nimmt eine ganze Zahl"},
    {"key_takes_true_or_false", error, "\"{key}\" takes true or false", "„{key}“ nimmt true oder false"},
    {"key_takes_numbers_or_texts", error, "\"{key}\" takes numbers or texts",
     "„{key}“ nimmt Zahlen oder Texte"},
    {"key_takes_one_or_several", error, "\"{key}\" takes a number, a text or a list of them",
     "„{key}“ nimmt eine Zahl, einen Text oder eine Liste davon"},
    {"key_takes_counts", error, "\"{key}\" takes a list of whole numbers from 0 to {most}",
     "„{key}“ nimmt eine Liste ganzer Zahlen von 0 bis {most}"},
    {"key_takes_whole_numbers", error, "\"{key}\" takes a list of whole numbers",
     "„{key}“ nimmt eine Liste ganzer Zahlen"},
    {"key_takes_rows", error, "\"{key}\" takes a list of rows", "„{key}“ nimmt eine Liste von Zeilen"},
    {"key_takes_one_value", error, "\"{key}\" takes one value, not a list",
     "„{key}“ nimmt einen Wert, keine Liste"},
    {"key_is_list_of_tables_so", error, "\"{key}\" is a list of tables: write [[{key}]]",
     "„{key}“ ist eine Liste von Tabellen: bitte [[{key}]] schreiben"},
    {"key_is_list_of_tables", error, "\"{key}\" is a list of tables", "„{key}“ ist eine Liste von Tabellen"},
    {"row_is_list", error, "a row is a list of texts", "eine Zeile ist eine Liste von Texten"},
    {"cell_is_text_or_number", error, "a cell is a text or a number",
     "eine Zelle ist ein Text oder eine Zahl"},
    // Tasks.
    {"no_option_of_task", error, "\"{key}\" is no option of {task}{more}",
     "„{key}“ ist keine Option von {task}{more}"},
    {"option_of_other", clause, "; it is one of {owner}", "; es ist eine von {owner}"},
    {"no_command_of_study", error, "\"{command}\" is no command of a study",
     "„{command}“ ist kein Befehl einer Studie"},
    {"task_needs_file", error, "\"{command}\" needs file = \"a recording\"",
     "„{command}“ braucht file = \"eine Aufnahme\""},
    {"rows_not_alike", error, "\"{of}\" and \"{minus}\" do not have the same number of rows",
     "„{of}“ und „{minus}“ haben nicht gleich viele Zeilen"},
    {"of_task", clause, "{task}: {what}", "{task}: {what}"},
    {"task_failed", error, "{command} {task}: {what}", "{command} {task}: {what}"},
    {"task_does_not_show", wrong_if_ignored, "{command} {task} should show \"{shows}\", but does not",
     "{command} {task} soll „{shows}“ zeigen, zeigt es aber nicht"},
    {"run_ended_early", clause, "{run}: {what}", "{run}: {what}"},
    {"task_interrupted", clause, "interrupted", "abgebrochen"},
    {"no_point_settled", clause, "no point settled", "kein Punkt hat sich eingeschwungen"},
    // Results in texts and figures.
    {"no_such_result", error, "\"{name}\" is no result of this study{near}",
     "„{name}“ ist kein Ergebnis dieser Studie{near}"},
    {"no_such_result_column", error, "\"{name}\" is no column of this study{near}",
     "„{name}“ ist keine Spalte dieser Studie{near}"},
    {"brace_not_closed", error, "\"{text}\": the brace is not closed",
     "„{text}“: die Klammer ist nicht geschlossen"},
    {"in_braces", error, "{{{braces}}}: {what}", "{{{braces}}}: {what}"},
    {"no_way_to_write", error, "\"{part}\" is neither a unit nor a way to write a number",
     "„{part}“ ist weder eine Einheit noch eine Art, eine Zahl zu schreiben"},
    {"value_not_written_in", error, "a value in \"{from}\" cannot be written in \"{to}\"",
     "ein Wert in „{from}“ lässt sich nicht in „{to}“ schreiben"},
    {"column_not_drawn_in", error, "a column in \"{from}\" cannot be drawn in \"{to}\"",
     "eine Spalte in „{from}“ lässt sich nicht in „{to}“ zeichnen"},
    {"range_needs_times", error, "\"{result}\": from and to need a column t as long as the ones drawn",
     "„{result}“: from und to brauchen eine Spalte t, so lang wie die gezeichneten"},
    {"rows_not_subtracted", error,
     "\"{minus}\" has {minus_rows} rows, \"{of}\" has {of_rows}: they cannot be subtracted",
     "„{minus}“ hat {minus_rows} Zeilen, „{of}“ hat {of_rows}: voneinander abziehen lassen sie sich nicht"},
    {"no_runs_to_list", error, "\"{task}\" has no runs to list",
     "„{task}“ hat keine Läufe, die aufzuzählen wären"},
    {"interrupted_before", error, "interrupted before {figure}", "abgebrochen vor {figure}"},
    {"page_of_others", error, "{file} is a page that Cromer did not write, and is kept: name another folder",
     "{file} ist nicht von Cromer geschrieben und bleibt: bitte einen anderen Ordner nennen"},
    {"file_is_no_folder", error, "{file} is a file: name a folder",
     "{file} ist eine Datei: bitte einen Ordner nennen"},
    {"folder_not_made", error, "{folder}: cannot be made: {why}", "{folder} lässt sich nicht anlegen: {why}"},
};

}  // namespace

const std::span<const Entry> words_of_study = entries;

}  // namespace cromer::core
