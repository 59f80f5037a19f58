#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // Where
    {"in_line", clause, "{@line}: {what}", "{@line}: {what}"},
    {"in_file", clause, "{file}: {what}", "{file}: {what}"},
    {"in_file_line", clause, "{file}:{line}: {what}", "{file}:{line}: {what}"},
    {"in_member", clause, "\"{member}\": {what}", "„{member}“: {what}"},
    {"in_member_line", clause, "\"{member}\":{line}: {what}", "„{member}“:{line}: {what}"},
    {"in_run", clause, "run {run}: {what}", "Lauf {run}: {what}"},
    {"in_runs", clause, "runs {runs:and}: {what}", "Läufe {runs:and}: {what}"},
    {"in_column", clause, "column \"{column}\": {what}", "Spalte „{column}“: {what}"},
    {"column_named", clause, "column \"{column}\"", "Spalte „{column}“"},
    {"column_of_run", clause, "column \"{column}\" of run {run}", "Spalte „{column}“ im Lauf {run}"},

    // Files that are no text, and archives
    {"empty_file", error, "the file is empty", "die Datei ist leer"},
    {"binary_file", error,
     "this is a binary file (a zero byte at offset {offset}): a text or CSV file is expected",
     "das ist eine Binärdatei (Nullbyte an Stelle {offset}): erwartet wird eine Text- oder CSV-Datei"},
    {"archive_or_spreadsheet", error,
     "this is a ZIP archive or a spreadsheet: unpack it, or export the sheet as CSV",
     "das ist ein ZIP-Archiv oder ein Tabellenblatt: bitte auspacken oder als CSV ausgeben"},
    {"spreadsheet", error, "this is a spreadsheet: export the sheet as CSV",
     "das ist ein Tabellenblatt: bitte als CSV ausgeben"},
    {"file_of_a_program", error, "this is a file of {program}'s own: there, choose {menu}",
     "das ist eine eigene Datei von {program}: dort bitte {menu} wählen"},
    {"archive_damaged", error, "the ZIP archive is damaged or not complete: export it again",
     "das ZIP-Archiv ist beschädigt oder nicht vollständig: bitte neu ausgeben"},
    {"archive_of_many_files", error, "the ZIP archive holds more than {most} files: unpack it",
     "das ZIP-Archiv enthält mehr als {most} Dateien: bitte auspacken"},
    {"archive_locked", error, "the ZIP archive is locked with a password: export it without",
     "das ZIP-Archiv ist mit einem Kennwort verschlossen: bitte ohne ausgeben"},
    {"archive_method", error, "the ZIP archive is packed by a method other than deflate: unpack it",
     "das ZIP-Archiv ist anders als mit deflate gepackt: bitte auspacken"},
    {"archive_too_large", error, "the ZIP archive claims to hold far more than its size: unpack it by hand",
     "das ZIP-Archiv gibt vor, weit mehr zu enthalten, als es groß ist: bitte von Hand auspacken"},
    {"archive_without_csv", error, "the ZIP archive holds no CSV file",
     "das ZIP-Archiv enthält keine CSV-Datei"},
    {"left_out_of_archive", worth_knowing, "left out of the archive: {what}",
     "aus dem Archiv weggelassen: {what}"},
    {"has_no_times", clause, "it has no times", "ohne Zeiten"},
    {"damaged_utf16", error,
     "the UTF-16 text is damaged: {what} at byte {byte}, in {@line}: export it again, as UTF-8",
     "der UTF-16-Text ist beschädigt: {what} an Stelle {byte}, in {@line}: bitte neu als UTF-8 ausgeben"},
    {"half_surrogate_pair", clause, "half a surrogate pair", "ein halbes Surrogatpaar"},
    {"half_character", clause, "half a character", "ein halbes Zeichen"},
    {"a_zero", clause, "a zero", "eine Null"},

    // Cells that are no numbers
    {"not_a_number_but", error, "\"{text}\" is not a number; {what}", "„{text}“ ist keine Zahl; {what}"},
    {"is_date", clause, "it is a date: write the seconds since the start",
     "das ist ein Datum: gebraucht werden Sekunden seit dem Anfang"},
    {"is_clock_time", clause, "it is a clock time: write the seconds since the start",
     "das ist eine Uhrzeit: gebraucht werden Sekunden seit dem Anfang"},
    {"has_thousands_separators", clause, "it has thousands separators: write {cure}",
     "Tausendertrennzeichen sind nicht erlaubt: bitte {cure} schreiben"},
    {"has_fortran_exponent", clause, "it has Fortran's exponent: write {cure}",
     "das ist ein Exponent wie in Fortran: bitte {cure} schreiben"},
    {"is_too_large", clause, "it is too large: numbers end at 1.8e308",
     "das ist zu groß: Zahlen enden bei 1,8e308"},
    {"decimal_mark_is_point", clause, "the decimal mark of this file is a point",
     "das Dezimalzeichen dieser Datei ist ein Punkt"},
    {"decimal_mark_is_comma", clause, "the decimal mark of this file is a comma",
     "das Dezimalzeichen dieser Datei ist ein Komma"},

    // Rows
    {"unknown_delimiter", error,
     "{--delimiter} \"{given}\" is not known: comma, semicolon, tab or blank is expected",
     "{--delimiter} „{given}“ ist unbekannt: erwartet wird comma, semicolon, tab oder blank"},
    {"unknown_decimal", error, "{--decimal} \"{given}\" is not known: point or comma is expected",
     "{--decimal} „{given}“ ist unbekannt: erwartet wird point oder comma"},
    {"no_rows_of_numbers", error, "no rows of numbers are found: a table of numbers in columns is expected",
     "keine Zeilen mit Zahlen gefunden: erwartet wird eine Tabelle mit Zahlen in Spalten"},
    {"no_rows_of_numbers_but", error, "no rows of numbers are found: \"{cell}\" is not a number; {what}",
     "keine Zeilen mit Zahlen gefunden: „{cell}“ ist keine Zahl; {what}"},
    {"no_rows_with_option", error,
     "no rows of numbers are found with this {option:option}; without it there are some",
     "keine Zeilen mit Zahlen gefunden mit dieser Angabe: {option:option}; ohne sie gibt es welche"},
    {"rows_read_in_two_ways", error,
     "the rows can be read in two ways: \"{row}\" as {whole} whole numbers or as {decimal} with a decimal "
     "comma; {--delimiter} comma says the one, {--decimal} comma the other",
     "die Zeilen lassen sich auf zwei Arten lesen: „{row}“ als {whole} ganze Zahlen oder als {decimal} mit "
     "Dezimalkomma; {--delimiter} comma sagt das eine, {--decimal} comma das andere"},
    {"bad_row", error,
     "{what}; {|{--skip-bad-rows} drops such rows|mend the row in the file, or leave such rows out}",
     "{what}; {|mit {--skip-bad-rows} bleiben solche Zeilen weg|bitte die Zeile in der Datei ausbessern "
     "oder solche Zeilen weglassen}"},
    {"bad_cell", error, "column \"{column}\": \"{cell}\" is not a number",
     "Spalte „{column}“: „{cell}“ ist keine Zahl"},
    {"bad_cell_but", error, "column \"{column}\": \"{cell}\" is not a number; {what}",
     "Spalte „{column}“: „{cell}“ ist keine Zahl; {what}"},
    {"commas_open", error,
     "\"{row}\": it is open which commas are decimal marks; write the file with another separator, or with "
     "points",
     "„{row}“: offen ist, welche Kommas Dezimalzeichen sind; bitte mit einem anderen Trennzeichen oder mit "
     "Punkten schreiben"},
    {"more_values_than_columns", error, "there are more values than the {columns} columns",
     "das sind mehr Werte als die {columns} Spalten"},
    {"too_many_columns", error, "there are more than {most} columns", "das sind mehr als {most} Spalten"},
    {"rows_far_shorter", error, "most rows are far shorter than the widest, which has {columns} columns",
     "die meisten Zeilen sind weit kürzer als die breiteste mit {columns} Spalten"},
    {"text_columns_left_out", worth_knowing,
     "{columns?column|columns} {columns} {columns?holds|hold} text and {columns?is|are} left out",
     "{columns?die Spalte|die Spalten} {columns} {columns?enthält|enthalten} Text und "
     "{columns?bleibt|bleiben} weg"},
    {"bad_rows_left_out", detail, "{rows:bad row|bad rows} left out, the first in {@line}",
     "{rows:schlechte Zeile|schlechte Zeilen} weggelassen, die erste Stelle in {@line}"},
    {"most_rows_lost", wrong_if_ignored,
     "MOST ROWS ARE LOST: {rows:bad row|bad rows} left out, {kept:row|rows} kept, the first in {@line} "
     "({what})",
     "DIE MEISTEN ZEILEN FEHLEN: {rows:schlechte Zeile|schlechte Zeilen} weggelassen, {kept} behalten, die "
     "erste Stelle in {@line} ({what})"},
    {"no_rows_left", error, "no rows of numbers are left", "keine Zeilen mit Zahlen bleiben übrig"},
    {"no_rows_left_but", error, "no rows of numbers are left: {what}, in {@line}",
     "keine Zeilen mit Zahlen bleiben übrig: {what}, in {@line}"},
    {"last_line_cut", detail, "the last line, {line}, seems cut within a number, \"{text}\": it is left out",
     "die letzte Zeile, {line}, bricht wohl in einer Zahl ab, „{text}“: sie bleibt weg"},
    {"last_line_without_end", worth_knowing,
     "the last line, {line}, has no end and may end within a number, \"{text}\": it is kept",
     "die letzte Zeile, {line}, hat kein Ende und bricht vielleicht in einer Zahl ab, „{text}“: sie bleibt"},
    {"line_counts_rows", worth_knowing,
     "the line \"{text}\" counts the rows: {step:n} s is taken as their step",
     "die Zeile „{text}“ nennt die Zahl der Zeilen: {step:n} s gelten als ihr Schritt"},

    // Columns
    {"no_such_column", error, "no column is called \"{name}\"; there are {columns}",
     "keine Spalte heißt „{name}“; es gibt {columns}"},
    {"no_such_column_but", error,
     "no column is called \"{name}\"; there are {columns}; did you mean \"{near}\"?",
     "keine Spalte heißt „{name}“; es gibt {columns}; ist „{near}“ gemeint?"},
    {"several_columns_fit", error, "\"{name}\" fits several columns; there are {columns}",
     "„{name}“ passt auf mehrere Spalten; es gibt {columns}"},
    {"columns_alike", error,
     "several columns are alike: {columns}; {|say which with {--column}, for instance {--column}|choose "
     "one, for instance} \"{first}\"{|; \"modes\" finds the natural frequencies of coupled motions from all "
     "of them|}",
     "mehrere Spalten gleichen einander: {columns}; bitte {|mit {--column} eine nennen, zum Beispiel "
     "{--column}|eine wählen, zum Beispiel} „{first}“{|; „modes“ findet die Eigenfrequenzen gekoppelter "
     "Bewegungen aus allen|}"},
    {"angle_about_pivot", worth_knowing,
     "{x} and {y} lie on an arc of radius {radius:n}, as the bob of a filmed pendulum does: the angle about "
     "its centre is taken, from the middle of the swing{|; {--column} {x} takes {x} alone|}",
     "{x} und {y} liegen auf einem Bogen mit dem Radius {radius:n}, wie bei einem gefilmten Pendel: "
     "genommen wird der Winkel um dessen Mittelpunkt, von der Mitte der Schwingung aus{|; {--column} {x} "
     "nimmt {x} allein|}"},
    {"no_arc", error,
     "{x} and {y} do not lie on an arc whose radius can be told, so no angle about its centre can be "
     "computed",
     "{x} und {y} liegen auf keinem Bogen, dessen Radius sich bestimmen lässt; ein Winkel um dessen "
     "Mittelpunkt lässt sich nicht berechnen"},
    {"no_one_point", error,
     "{x} and {y} are not of one quantity, or not measured at the same times: they are no point on an arc",
     "{x} und {y} sind nicht dieselbe Größe oder nicht zu denselben Zeiten gemessen: sie sind kein Punkt "
     "auf einem Bogen"},
    {"liveliest_axis_taken", worth_knowing,
     "of the axes \"{column}\" is taken: it swings most clearly, by {amplitude:.2g}{unit} in its liveliest "
     "quarter "
     "of the recording (\"{other}\" by {less:.2g} there); {|{--column} names another|another one can be "
     "chosen}",
     "von den Achsen wird „{column}“ genommen: sie schwingt am deutlichsten, um {amplitude:.2g}{unit} in "
     "ihrem "
     "lebhaftesten Viertel der Aufnahme („{other}“ dort um {less:.2g}); {|{--column} nennt eine andere|eine "
     "andere ist wählbar}"},
    {"axes_alike", worth_knowing,
     "of the axes \"{column}\" is taken, which swings by {amplitude:.2g}{unit} in its liveliest quarter of "
     "the "
     "recording; \"{other}\" swings about as far there, by {less:.2g}; {|{--column} names another|another "
     "one "
     "can be chosen}",
     "von den Achsen wird „{column}“ genommen, die in ihrem lebhaftesten Viertel der Aufnahme um "
     "{amplitude:.2g}{unit} schwingt; „{other}“ schwingt dort etwa ebenso weit, um {less:.2g}; {|{--column} "
     "nennt "
     "eine andere|eine andere ist wählbar}"},
    {"no_motion_known", error,
     "no column is known to be a position, angle or velocity: {columns}; {|say which with {--column}, for "
     "instance {--column}|choose one, for instance} \"{first}\"",
     "keine Spalte ist als Ort, Winkel oder Geschwindigkeit bekannt: {columns}; bitte {|mit {--column} eine "
     "nennen, zum Beispiel {--column}|eine wählen, zum Beispiel} „{first}“"},
    {"only_column_taken", worth_knowing,
     "no column is known to be a position, angle or velocity: \"{column}\" is taken",
     "keine Spalte ist als Ort, Winkel oder Geschwindigkeit bekannt: „{column}“ wird genommen"},
    {"first_column_taken", worth_knowing,
     "no column is known to be a position, angle or velocity: of {columns}, \"{column}\" is taken; "
     "{|{--column} names another|another one can be chosen}",
     "keine Spalte ist als Ort, Winkel oder Geschwindigkeit bekannt: von {columns} wird „{column}“ "
     "genommen; {|{--column} nennt eine andere|eine andere ist wählbar}"},
    {"frequencies_only", error,
     "there is no motion beside the time: {columns} {columns?holds a frequency|hold frequencies}; to fit "
     "one all the same, {|name it with {--column}, for instance {--column}|choose it, for instance} "
     "\"{first}\"",
     "neben der Zeit gibt es keine Bewegung: {columns} {columns?enthält eine Frequenz|enthalten "
     "Frequenzen}; soll sie dennoch angepasst werden, bitte {|mit {--column} nennen, zum Beispiel "
     "{--column}|wählen, zum Beispiel} „{first}“"},
    {"no_column_beside_time", error, "there is no column beside the time",
     "neben der Zeit gibt es keine Spalte"},
    {"column_without_values", error, "column \"{column}\" of run {run} has no values",
     "die Spalte „{column}“ im Lauf {run} hat keine Werte"},
    {"column_never_changes", worth_knowing, "column \"{column}\" never changes",
     "die Spalte „{column}“ ändert sich nie"},
    {"column_tops_cut_off", wrong_if_ignored,
     "column \"{column}\": the motion's peaks are cut off at the same value again and again, as when a "
     "sensor is out of its range",
     "Spalte „{column}“: die Gipfel der Bewegung sind immer wieder beim selben Wert abgeschnitten: der "
     "Sensor war außerhalb seines Bereichs"},
    {"column_of_frequency", wrong_if_ignored,
     "column \"{column}\" holds a frequency, which is no motion: its numbers are taken as they are, in Hz",
     "die Spalte „{column}“ enthält eine Frequenz, keine Bewegung: ihre Zahlen gelten, wie sie sind, in Hz"},
    {"column_without_unit", worth_knowing,
     "column \"{column}\" has no unit: its values are taken as they are",
     "die Spalte „{column}“ hat keine Einheit: ihre Werte gelten, wie sie sind"},
    {"unit_assumed", worth_knowing,
     "column \"{column}\" has no unit: {unit} is assumed; the header can name another, in brackets behind "
     "the column's name",
     "die Spalte „{column}“ hat keine Einheit: {unit} wird angenommen; die Kopfzeile kann eine andere "
     "nennen, in Klammern hinter dem Namen der Spalte"},
    {"unit_not_known", worth_knowing,
     "unit \"{unit}\" of column \"{column}\" is not known: its values are taken as they are",
     "die Einheit „{unit}“ der Spalte „{column}“ ist unbekannt: ihre Werte gelten, wie sie sind"},
    {"unit_of_something_else", wrong_if_ignored,
     "\"{unit}\" of column \"{column}\" is no unit of {kind}: its values are taken as they are",
     "„{unit}“ der Spalte „{column}“ ist keine Einheit für {kind}: ihre Werte gelten, wie sie sind"},
    {"missing_values", detail, "{column}: {values:missing value|missing values}, the first in {@line}",
     "{column}: {values:fehlender Wert|fehlende Werte}, die erste Stelle in {@line}"},
    {"measured_in_some_rows", detail, "{column} is measured only in every {stride}{ending} row",
     "{column} steht nur in jeder {stride}{ending} Zeile"},
    {"ordinal_th", clause, "th", "."},
    {"ordinal_st", clause, "st", "."},
    {"ordinal_nd", clause, "nd", "."},
    {"ordinal_rd", clause, "rd", "."},
    {"samples_stick_out", worth_knowing,
     "{samples:sample sticks|samples stick} out alone, the first in {@line}",
     "{samples:Messwert ragt allein|Messwerte ragen einzeln} heraus, die erste Stelle in {@line}"},
    {"samples_in_drop_outs", worth_knowing,
     "{samples:sample|samples} in {drop_outs:drop-out|drop-outs} of the sensor, the first in {@line}",
     "{samples:Messwert|Messwerte} in {drop_outs:Aussetzer|Aussetzern} des Sensors, die erste Stelle in "
     "{@line}"},

    // Times
    {"rate_no_number", error, "{--rate} must be a number of samples per second above 0",
     "{--rate} muss eine Zahl von Messwerten je Sekunde über 0 sein"},
    {"rate_not_used", worth_knowing, "{--rate} is not used: the times stand in \"{column}\"",
     "{--rate} wird nicht gebraucht: die Zeiten stehen in „{column}“"},
    {"no_time_column", error,
     "there is no time column: give the samples per second{| with {--rate}, or name the column with "
     "{--time-column}|}",
     "eine Zeitspalte fehlt: bitte {|mit {--rate} die Messwerte je Sekunde angeben oder mit {--time-column} "
     "die Spalte nennen|die Messwerte je Sekunde angeben}"},
    {"column_is_the_time", error,
     "column \"{column}\" is the time; {|name the column that moves with it with {--column}|choose the "
     "column that moves with it}: {others:or}",
     "die Spalte „{column}“ ist die Zeit; bitte {|mit {--column} nennen|wählen}, was sich mit ihr bewegt: "
     "{others:or}"},
    {"time_column_refused", error, "{--time-column}: {what}", "{--time-column}: {what}"},
    {"bad_time_unit", error,
     "column \"{column}\": the unit \"{unit}\" {fault}: write s, ms, us, min or h after the time's name "
     "(seconds need none)",
     "Spalte „{column}“: die Einheit „{unit}“ {fault}: bitte s, ms, us, min oder h hinter den Namen der "
     "Zeit schreiben (Sekunden brauchen keine)"},
    {"bad_time_unit_or_column", error,
     "column \"{column}\": the unit \"{unit}\" {fault}: write s, ms, us, min or h after the time's name "
     "(seconds need none){|, or name another column with {--time-column}|}",
     "Spalte „{column}“: die Einheit „{unit}“ {fault}: bitte s, ms, us, min oder h hinter den Namen der "
     "Zeit schreiben (Sekunden brauchen keine){| oder mit {--time-column} eine andere Spalte nennen|}"},
    {"is_not_known", clause, "is not known", "ist unbekannt"},
    {"is_no_unit_of_time", clause, "is no unit of time", "ist keine Zeiteinheit"},
    {"taken_as_time", worth_knowing, "\"{column}\" runs evenly upward: it is taken as the time in seconds",
     "„{column}“ steigt gleichmäßig: das gilt als Zeit in Sekunden"},
    {"first_taken_as_time", worth_knowing,
     "the first column runs evenly upward: it is taken as the time in seconds",
     "die erste Spalte steigt gleichmäßig: sie gilt als Zeit in Sekunden"},
    {"no_step_of_time", error,
     "column \"{column}\": from {from:n} to {to:n} is no step of time: seconds are expected, or a unit "
     "after the name",
     "Spalte „{column}“: von {from:n} nach {to:n} ist kein Zeitschritt; erwartet werden Sekunden oder eine "
     "Einheit hinter dem Namen"},
    {"time_runs_backward", error, "the time runs backward from the first row to the last",
     "die Zeit läuft rückwärts, von der ersten Zeile bis zur letzten"},
    {"time_mostly_backward", error, "the time runs backward in most rows",
     "die Zeit läuft in den meisten Zeilen rückwärts"},
    {"time_stands_still", error, "the time stands still: all its values are equal",
     "die Zeit steht still: alle ihre Werte sind gleich"},
    {"time_starts_again", worth_knowing,
     "the time starts again in {@line}: the {rows:row|rows} from there on are left out",
     "die Zeit beginnt in {@line} von vorn: was dann kommt, {rows:Zeile|Zeilen}, bleibt weg"},
    {"repeated_times", detail, "{rows:row|rows} with a repeated time left out, the first in {@line}",
     "{rows:Zeile|Zeilen} weggelassen: die Zeit ist wiederholt, die erste Stelle in {@line}"},
    {"backward_times", detail, "{rows:row|rows} with a backward time left out, the first in {@line}",
     "{rows:Zeile|Zeilen} weggelassen: die Zeit ist rückläufig, die erste Stelle in {@line}"},
    {"times_made_even", detail,
     "the times are rounded to {rounding:n} s and agree with even times {spacing:n} s apart, which are used "
     "instead",
     "die Zeiten sind auf {rounding:n} s gerundet und passen zu gleichmäßigen im Abstand {spacing:n} s: "
     "stattdessen gelten diese"},
    {"gaps_in_times", worth_knowing, "{gaps:gap|gaps} between samples, the longest {longest:n} s at {at:n} s",
     "{gaps:Lücke|Lücken} zwischen den Messwerten, die längste {longest:n} s bei {at:n} s"},

    // Runs and tables
    {"no_such_run", error, "there is no run {run}: the file has {runs:run|runs}",
     "einen Lauf {run} gibt es nicht: die Datei hat {runs:Lauf|Läufe}"},
    {"choose_one_run", error,
     "{file} has {runs} runs: choose one with {--run}. Columns of one name count as runs: if they are of one "
     "run, give each a name of its own",
     "{file} hat {runs} Läufe: bitte mit {--run} einen wählen. Spalten eines Namens zählen als Läufe: gehören "
     "sie zu einem, bitte jeder einen eigenen Namen geben"},
    {"run_called", detail, "run {run} is called \"{label}\" in the file",
     "Lauf {run} heißt in der Datei „{label}“"},
    {"read_as_runs", detail, "the time starts again in {@line}: the file is read as {runs} runs",
     "die Zeit beginnt in {@line} von vorn: die Datei wird als {runs} Läufe gelesen"},
    {"read_as_runs_again", detail,
     "the time starts again in {@line} and {times:more time|more times}: the file is read as {runs} runs",
     "die Zeit beginnt in {@line} und noch {times:Mal|Mal} von vorn: die Datei wird als {runs} Läufe "
     "gelesen"},
    {"too_many_tables", error, "the file holds {tables} tables: {most} at most are read",
     "die Datei enthält {tables} Tabellen: höchstens {most} werden gelesen"},
    {"tables_too_unequal", error,
     "the {tables} tables of the file are too unequal in length to be laid side by side",
     "die {tables} Tabellen der Datei sind zu ungleich lang, um nebeneinander zu stehen"},
    {"tables_too_wide", error, "the tables of the file have {columns} columns: {most} at most are read",
     "die Tabellen der Datei haben {columns} Spalten: höchstens {most} werden gelesen"},
    {"no_set_of_rows", error, "the file holds no set of rows", "die Datei enthält keinen Satz von Zeilen"},
    {"set_without_rows", detail, "set \"{set}\" has no rows", "der Satz „{set}“ hat keine Zeilen"},
    {"set_without_names", error, "the names of the columns of set \"{set}\" are missing",
     "die Namen der Spalten des Satzes „{set}“ fehlen"},

    // LabVIEW
    {"labview_without_times", error,
     "the rows carry no X_Value and the header no Delta_X above 0: the times are not known",
     "die Zeilen haben keinen X_Value und der Kopf kein Delta_X über 0: die Zeiten sind nicht bekannt"},
    {"labview_without_channel", error, "no channel is named", "kein Kanal ist genannt"},
    {"labview_without_rows", error, "the file holds no segment with rows",
     "die Datei enthält keinen Abschnitt mit Zeilen"},
    {"labview_samples", worth_knowing,
     "the header says {promised:n} samples per channel, but there are {rows} rows: the rows are taken",
     "der Kopf nennt {promised:n} Messwerte je Kanal, doch es sind {rows} Zeilen: die Zeilen gelten"},
    {"labview_step", worth_knowing,
     "the header says Delta_X {promised:n}, but X_Value goes in steps of {step:n}: X_Value is taken",
     "der Kopf nennt Delta_X {promised:n}, doch X_Value geht in Schritten von {step:n}: X_Value gilt"},

    // PEER
    {"peer_step", error, "DT is not a step above 0", "DT ist kein Schritt über 0"},
    {"peer_count", error, "NPTS is not a number of values above 0", "NPTS ist keine Zahl von Werten über 0"},
    {"peer_without_values", error, "no values follow", "es folgen keine Werte"},
    {"peer_fewer_values", worth_knowing, "NPTS says {promised:n} values, the file holds {values}",
     "NPTS nennt {promised:n} Werte, die Datei enthält {values}"},
    {"peer_more_values", worth_knowing, "{more:value|values} after the {values} that NPTS announces left out",
     "{more:Wert|Werte} nach den {values}, die NPTS ankündigt, weggelassen"},

    // Universal files
    {"dataset_not_ieee", error, "its binary numbers are not IEEE 754: convert the file to dataset 58 as text",
     "seine binären Zahlen sind nicht nach IEEE 754: bitte in Datensätze 58 als Text umwandeln"},
    {"dataset_byte_order", error, "its byte order is neither 1 nor 2",
     "seine Bytereihenfolge ist weder 1 noch 2"},
    {"dataset_bytes", error, "its number of bytes is not valid", "die Zahl seiner Bytes ist ungültig"},
    {"dataset_points", worth_knowing,
     "the dataset in {@line} announces {promised:n} points and holds {points}",
     "der Datensatz in {@line} kündigt {promised:n} Punkte an und enthält {points}"},
    {"dataset_left_out", worth_knowing, "{datasets:dataset|datasets} left out: {what}, in {@line}",
     "{datasets:Datensatz|Datensätze} weggelassen: {what}, in {@line}"},
    {"datasets_left_out", worth_knowing, "{datasets:dataset|datasets} left out: {what}, the first in {@line}",
     "{datasets:Datensatz|Datensätze} weggelassen: {what}, der erste in {@line}"},
    {"dataset_without_step", clause, "it has no time step above 0", "ohne Zeitschritt über 0"},
    {"dataset_without_values", clause, "it has no values", "ohne Werte"},
    {"dataset_no_time_response", clause, "it is no time response (a spectrum or a frequency response)",
     "kein Zeitverlauf (ein Spektrum oder ein Frequenzgang)"},
    {"dataset_of_other_kind", clause, "its kind \"{kind}\" is not 58", "von der Art „{kind}“, nicht 58"},
    {"dataset_complex", clause, "its values are complex", "mit komplexen Werten"},
    {"no_time_response", error, "the universal file holds no time response of a dataset 58",
     "die Universaldatei enthält keinen Zeitverlauf in einem Datensatz 58"},
    {"no_time_response_but", error, "the universal file holds no time response of a dataset 58; {what}",
     "die Universaldatei enthält keinen Zeitverlauf in einem Datensatz 58; {what}"},
};

}  // namespace

const std::span<const Entry> words_of_read = entries;

}  // namespace cromer::core
