#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    {"options_need_recognise", error,
     "options of the law, of columns and of reading a file are about a run: name its file with {--recognise}",
     "Optionen zum Gesetz, zu Spalten und zum Lesen einer Datei gelten einem Lauf: bitte seine Datei mit "
     "{--recognise} nennen"},
    {"unknown_choice", error, "{option:option}: \"{typed}\" is not known; it takes {words:or}{near}",
     "{option:option}: „{typed}“ ist unbekannt; erwartet wird {words:or}{near}"},
    {"perhaps_choice", clause, " (did you mean {near}?)", " (ist {near} gemeint?)"},
    {"motions_failed", clause, "{failed} of {all} motions did not succeed",
     "{failed} von {all} Bewegungen sind nicht gelungen"},
    // Any option
    {"option_is_wrong", error, "{option:option}: {what}", "{option:option}: {what}"},
    {"value_is_empty", clause, "the value is empty", "der Wert fehlt"},
    {"value_missing_in_list", clause, "a value is missing between two commas",
     "zwischen zwei Kommas fehlt ein Wert"},
    {"unit_missing_in_list", clause,
     "{value} has no unit, but others have: give each its unit, or give one to the last only, for all of "
     "them",
     "{value} hat keine Einheit, und andere haben eine: bitte jedem Wert seine Einheit geben oder nur dem "
     "letzten, dann gilt sie für alle"},
    {"not_whole_number", clause, "\"{text}\" is not a whole number", "„{text}“ ist keine ganze Zahl"},
    {"whole_number_too_large", clause, "\"{text}\" is a whole number too large to be used",
     "„{text}“ ist eine zu große ganze Zahl"},
    {"neither_true_nor_false", clause, "\"{text}\" is neither true nor false",
     "„{text}“ ist weder true noch false"},
    {"uncertainty_is_wrong", clause, "its uncertainty must be zero or more, not {uncertainty}",
     "die Unsicherheit darf nicht negativ sein: {uncertainty}"},
    {"no_option", error, "{option:option} is no option of {task}",
     "{option:option} gibt es bei {task} nicht"},
    {"no_option_but", error, "{option:option} is no option of {task}; did you mean {near:option}?",
     "{option:option} gibt es bei {task} nicht; ist {near:option} gemeint?"},

    // What a value must satisfy; help says it too.
    {"must_keep_to", clause, "it must {rule}, not {value:.9g}{unit: }",
     "das {rule}: {value:.9g}{unit: } geht nicht"},
    {"be_finite", clause, "be a finite number", "muss eine endliche Zahl sein"},
    {"be_positive", clause, "be positive", "muss größer als 0 sein"},
    {"not_be_negative", clause, "not be negative", "darf nicht negativ sein"},
    {"be_at_least_one", clause, "be at least 1", "muss mindestens 1 sein"},
    {"be_a_fraction", clause, "lie between 0 and 1", "muss zwischen 0 und 1 liegen"},
    {"be_a_tolerance", clause, "lie between 1e-15 and 1e-2", "muss zwischen 1e-15 und 1e-2 liegen"},
    {"be_an_accuracy", clause, "lie between 1e-9 and 0.5", "muss zwischen 1e-9 und 0,5 liegen"},
    {"be_an_air_temperature", clause, "lie between 100 K and 1900 K (for instance \"20 °C\")",
     "muss zwischen 100 K und 1900 K liegen (zum Beispiel „20 °C“)"},
    {"be_a_sampling_rate", clause, "lie between 1e-6 and 1e12 Hz", "muss zwischen 1e-6 und 1e12 Hz liegen"},
    {"be_a_number_of_trials", clause, "lie between 1000 and 10000000 trials",
     "muss zwischen 1000 und 10000000 Versuchen liegen"},

    // Options that belong together, of methods
    {"natural_frequency_needs_step", error,
     "{--natural-frequency}: it needs a {--step}, to say what each method simulates with it",
     "{--natural-frequency}: dazu gehört {--step}, um zu sagen, was jedes Verfahren daraus macht"},
    {"step_needs_natural_frequency", error,
     "{--step}: it needs a {--natural-frequency}, to say what each method simulates of it",
     "{--step}: dazu gehört {--natural-frequency}, um zu sagen, was jedes Verfahren daraus macht"},
    {"option_needs_frequency_and_step", error,
     "{option:option}: it needs a {--natural-frequency} and a {--step}",
     "{option:option}: dazu gehören {--natural-frequency} und {--step}"},
};

}  // namespace

const std::span<const Entry> words_of_options = entries;

}  // namespace cromer::core
