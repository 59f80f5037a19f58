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
    {"must_keep_to", clause, "it must {rule}, not {value}{unit: }", "das {rule}: {value}{unit: } geht nicht"},
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

    // Options that belong together, of methods and of their curves
    {"natural_frequency_needs_step", error,
     "{--natural-frequency}: it needs a {--step}, to say what each method simulates with it",
     "{--natural-frequency}: dazu gehört {--step}, um zu sagen, was jedes Verfahren daraus macht"},
    {"step_needs_natural_frequency", error,
     "{--step}: it needs a {--natural-frequency}, to say what each method simulates of it",
     "{--step}: dazu gehört {--natural-frequency}, um zu sagen, was jedes Verfahren daraus macht"},
    {"option_needs_frequency_and_step", error,
     "{option:option}: it needs a {--natural-frequency} and a {--step}",
     "{option:option}: dazu gehören {--natural-frequency} und {--step}"},
    {"from_not_positive", error, "{--from}: it must be positive", "{--from}: das muss größer als 0 sein"},
    {"to_not_above_from", error, "{--to}: it must be above {--from}",
     "{--to}: das muss über {--from} liegen"},
    {"too_few_points", error, "{--points}: at least 2", "{--points}: mindestens 2"},
    {"method_map_not_linear", error,
     "{option:option}: only a linear law has one frequency and one decay rate",
     "{option:option}: nur ein lineares Gesetz hat eine einzige Frequenz und eine einzige Abklingrate"},
    {"law_does_not_oscillate", error, "{--damping}: this law does not oscillate",
     "{--damping}: dieses Gesetz schwingt nicht"},
    {"frequency_from_not_positive", error, "{--frequency-from}: it must be positive",
     "{--frequency-from}: das muss größer als 0 sein"},
    {"frequency_to_not_above_from", error, "{--frequency-to}: it must be above {--frequency-from}",
     "{--frequency-to}: das muss über {--frequency-from} liegen"},
    {"resonance_without_force", error, "{--drive-amplitude}: a resonance curve needs a force",
     "{--drive-amplitude}: eine Resonanzkurve braucht eine Kraft"},
    {"resonance_of_other_drive", error,
     "{option:option}: a resonance curve needs a harmonic force, an unbalance or a shaking base",
     "{option:option}: eine Resonanzkurve gibt es zu einer harmonischen Kraft, einer Unwucht oder einem "
     "schwingenden Fußpunkt"},
    {"resonance_not_linear", error, "{option:option}: this resonance curve is for the linear law only",
     "{option:option}: diese Resonanzkurve ist die des linearen Gesetzes"},
    {"resonance_without_damping", error,
     "{--damping}: without damping no transient dies down, and there is no steady amplitude",
     "{--damping}: ohne Dämpfung klingt kein Einschwingen ab, und es gibt keine stationäre Amplitude"},
    {"resonance_without_spring", error, "{--stiffness}: without a spring there is no resonance",
     "{--stiffness}: ohne Feder gibt es keine Resonanz"},
    {"damping_ratios_and_damping", error,
     "{--damping-ratios}: the damping is set by {--damping}, {--damping-ratio} or {--quality-factor} "
     "already; give one of them",
     "{--damping-ratios}: die Dämpfung ist durch {--damping}, {--damping-ratio} oder {--quality-factor} "
     "schon festgelegt; bitte nur eines davon angeben"},
    {"local_error_under_drive", error,
     "{--drive}: the error of a step is measured on a smooth motion, free or under a harmonic drive",
     "{--drive}: der Fehler eines Schritts wird an einer glatten Bewegung gemessen, frei oder unter einem "
     "harmonischen Antrieb"},
    {"local_error_without_closed_form", error,
     "{option:option}: the error of a step is measured against the closed form, and this law has none",
     "{option:option}: der Fehler eines Schritts wird an der geschlossenen Lösung gemessen, die dieses "
     "Gesetz nicht hat"},
    {"local_error_without_period", error,
     "{--stiffness}: the steps are parts of a natural period, and this law has none",
     "{--stiffness}: die Schritte sind Teile einer Eigenperiode, die dieses Gesetz nicht hat"},
    {"longest_not_positive", error, "{--longest}: it must be positive",
     "{--longest}: das muss größer als 0 sein"},
    {"halvings_out_of_range", error, "{--halvings}: 1 to 30", "{--halvings}: 1 bis 30"},
};

}  // namespace

const std::span<const Entry> words_of_options = entries;

}  // namespace cromer::core
