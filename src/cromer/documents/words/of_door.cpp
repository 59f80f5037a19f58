#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // Arrays
    {"no_times", error, "t has no values: a record needs samples",
     "t hat keine Werte: eine Aufnahme braucht Messwerte"},
    {"time_not_finite", error, "t[{index}] is {value}: times must be finite",
     "t[{index}] ist {value}: Zeiten müssen endlich sein"},
    {"times_do_not_increase", error, "t must increase strictly: t[{index}] = {time} s follows {before} s",
     "t muss stets wachsen: t[{index}] = {time} s folgt auf {before} s"},
    {"lengths_differ", error,
     "{argument} has {values} values and {other} has {others}: both need the same number",
     "{argument} hat {values} Werte und {other} hat {others}: es müssen gleich viele sein"},
    {"no_columns_given", error, "{argument} has no columns: give at least one",
     "{argument} hat keine Spalten: bitte mindestens eine angeben"},
    {"too_few_values", error, "{argument} needs at least {least} values, not {values}",
     "{argument} braucht mindestens {least} Werte, nicht {values}"},
    {"value_not_finite", error, "{argument}[{index}] is {value}: all values must be finite",
     "{argument}[{index}] ist {value}: alle Werte müssen endlich sein"},
    {"value_not_positive", error, "{argument}[{index}] is {value}: all values must be above 0",
     "{argument}[{index}] ist {value}: alle Werte müssen über 0 liegen"},
    {"value_is_infinite", error, "{argument}[{index}] is {value}: a missing value is NaN",
     "{argument}[{index}] ist {value}: ein fehlender Wert ist NaN"},
    {"spacing_not_positive", error, "spacing {spacing}: it must be positive, in seconds",
     "spacing {spacing}: das muss größer als 0 sein, in Sekunden"},
    {"array_without_name_or_values", error, "an array needs a name and its values",
     "zu einem Feld gehören ein Name und seine Werte"},
    {"array_given_twice", error, "there are two arrays {array}", "das Feld {array} steht zweimal da"},
    {"array_and_argument", error, "the array {array} and the argument {argument} say the same; leave one out",
     "das Feld {array} und das Argument {argument} sagen dasselbe; bitte eines weglassen"},
    {"array_is_missing", error, "the array {array} is missing", "das Feld {array} fehlt"},
    {"not_an_array_of", error, "{verb} takes no array {array}", "{verb} nimmt kein Feld {array}"},
    {"not_an_array_here", error, "{verb} takes no array {array} here", "{verb} nimmt hier kein Feld {array}"},
    {"spacing_of_nothing", error,
     "spacing belongs to the arrays force and acceleration, but neither is given; leave it out",
     "spacing gehört zu den Feldern force und acceleration, doch keines ist angegeben; bitte weglassen"},
    {"spacing_is_missing", error, "{array} needs its spacing as well, in seconds",
     "zu {array} gehört spacing, der Abstand der Werte in Sekunden"},
    {"spacing_of_a_file", error, "spacing is that of arrays, but a file is given; leave it out",
     "spacing gehört zu Feldern, doch eine Datei ist angegeben; bitte weglassen"},
    {"force_and_acceleration", error, "force and acceleration both drive the mass; leave one of them out",
     "force und acceleration treiben beide die Masse an; bitte eines weglassen"},

    // What is fitted, and what was
    {"file_and_arrays", error, "file and the arrays both give a record; leave one of them out",
     "file und die Felder nennen beide eine Aufnahme; bitte eines weglassen"},
    {"said_of_a_file", error, "{argument} is for a file, but arrays are given; leave it out",
     "{argument} gehört zu einer Datei, doch Felder sind angegeben; bitte weglassen"},
    {"observed_of_file", error,
     "observed is for the array y; a file's columns say what they hold, so leave it out",
     "observed gehört zum Feld y; die Spalten einer Datei sagen selbst, was sie enthalten; bitte weglassen"},
    {"no_record", error, "there is nothing to {verb}: give the arrays t and y, or a file",
     "für {verb} fehlt eine Aufnahme: bitte die Felder t und y oder eine Datei angeben"},
    {"no_file", error, "there is nothing to read: give a file",
     "es gibt nichts zu lesen: bitte eine Datei angeben"},
    {"no_acceleration", error, "there is no acceleration: give the array, or a file",
     "eine Beschleunigung fehlt: bitte das Feld oder eine Datei angeben"},
    {"recording_is_empty", error, "the recording is empty: read() or read_file() fills one",
     "die Aufnahme ist leer: read() oder read_file() füllt eine"},
    {"force_is_a_column", error,
     "force: the force of a recording is one of its columns, force_column of the selection",
     "force: die Kraft einer Aufnahme ist eine ihrer Spalten, force_column der Auswahl"},
    {"fit_is_empty", error, "the fit is empty: fit() fills one", "die Anpassung ist leer: fit() füllt eine"},
    {"fit_without_values", error, "the fit has no values: {what}", "die Anpassung hat keine Werte: {what}"},
    {"fit_without_law", error, "the fit has no law to be compared: {what}",
     "die Anpassung hat kein Gesetz zum Vergleichen: {what}"},
    {"motion_known_at_samples", error,
     "a recorded force drives this motion, so it is known only at the samples: use motion()",
     "eine aufgenommene Kraft treibt diese Bewegung, deshalb ist sie nur an den Messwerten bekannt: bitte "
     "motion() nehmen"},
    {"times_before_the_first", error,
     "t begins at {begin} s, before the first used sample, {first} s: the law says nothing about earlier "
     "times",
     "t beginnt bei {begin} s, vor dem ersten benutzten Messwert bei {first} s: über frühere Zeiten sagt das "
     "Gesetz nichts"},
    {"times_too_late", error, "t ends at {end} s, too many steps after the record to be computed",
     "t endet bei {end} s, zu viele Schritte nach der Aufnahme, um sie zu rechnen"},

    // Arguments
    {"no_enumerator", error, "{argument}: there is no enumerator {number}",
     "{argument}: einen Aufzählungswert {number} gibt es nicht"},
    {"drive_amplitude_not_positive", error, "drive_amplitude must be positive, not {amplitude}",
     "drive_amplitude muss größer als 0 sein, nicht {amplitude}"},
    {"too_few_threads", error, "threads must be 0 (one for each processor) or more",
     "threads muss 0 (einer je Prozessor) oder mehr sein"},
    {"period_of_too_many_steps", error,
     "a period of the drive takes more steps than can be held: take a longer step, or a higher frequency",
     "eine Periode des Antriebs braucht mehr Schritte, als in den Speicher gehen: bitte einen längeren "
     "Schritt oder eine höhere Frequenz wählen"},
    {"network_is_object", error,
     "network must be the path of a file, or an object of that form: {{\"mass\": [...], \"link\": [...]}}",
     "network muss der Pfad einer Datei sein oder ein Objekt in deren Form: {{\"mass\": [...], \"link\": "
     "[...]}}"},
    {"term_given_twice", error, "network: a link has {term} twice", "network: ein Link hat {term} zweimal"},

    // Requests
    {"no_verb", error, "there is no verb \"{verb}\"; there are {verbs:and}",
     "das Verb „{verb}“ gibt es nicht; es gibt {verbs:and}"},
    {"request_is_no_object", error, "the request is no JSON object", "die Anfrage ist kein JSON-Objekt"},
    {"request_is_no_json", error, "the request is no JSON: it cannot be read from byte {byte} on",
     "die Anfrage ist kein JSON: von Byte {byte} an lässt sie sich nicht lesen"},
    {"request_number_too_large", error,
     "the request holds a number that is too large: numbers end at 1.8e308",
     "die Anfrage enthält eine zu große Zahl: Zahlen enden bei 1,8e308"},
    {"must_be_text", error, "{argument} must be a text", "{argument} muss ein Text sein"},
    {"must_be_number", error, "{argument} must be a number", "{argument} muss eine Zahl sein"},
    {"must_be_value", error, "{argument} must be a number, a text or a list of them",
     "{argument} muss eine Zahl, ein Text oder eine Liste davon sein"},
    {"takes_one_value", error, "{argument} takes one value, not a list of {count}",
     "{argument} nimmt einen Wert, keine Liste von {count}"},
    {"word_not_known", error, "{argument} \"{word}\" is not known; it takes {known:or}",
     "{argument} „{word}“ ist nicht bekannt; es nimmt {known:or}"},
    {"unknown_argument", error, "{verb} has no argument \"{argument}\"",
     "{verb} hat kein Argument „{argument}“"},
    {"unknown_argument_but", error, "{verb} has no argument \"{argument}\"; did you mean {near}?",
     "{verb} hat kein Argument „{argument}“; ist {near} gemeint?"},
    {"no_result", error, "there is no result to be written", "es gibt kein Ergebnis zum Aufschreiben"},
    {"no_such_form", error, "this result cannot be written as \"{form}\"",
     "dieses Ergebnis lässt sich nicht als „{form}“ schreiben"},
    {"no_fit_of_that_run", error, "there is no fit of run {run}", "es gibt keine Anpassung von Lauf {run}"},
    {"call_failed", error, "the call failed: {what}", "der Aufruf ist gescheitert: {what}"},
};

}  // namespace

const std::span<const Entry> words_of_door = entries;

}  // namespace cromer::core
