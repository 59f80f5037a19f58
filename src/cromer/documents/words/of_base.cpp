#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // Quantities and units
    {"quantity_refused", error, "{what}; {expected}", "{what}; {expected}"},
    {"not_a_number", error, "\"{text}\" is not a number", "„{text}“ ist keine Zahl"},
    {"too_large", error, "\"{text}\" is too large", "„{text}“ ist zu groß"},
    {"has_decimal_comma", error, "\"{text}\" has a decimal comma: write \"{cure}\"",
     "„{text}“ hat ein Dezimalkomma: bitte „{cure}“ schreiben"},
    {"bad_concise_uncertainty", error,
     "\"{text}\" is not a number with its uncertainty; write it as 0.2176(3)",
     "„{text}“ ist keine Zahl mit Unsicherheit; bitte wie 0.2176(3) schreiben"},
    {"negative_uncertainty", error, "\"{text}\" has a negative uncertainty",
     "„{text}“ hat eine negative Unsicherheit"},
    {"uncertainty_not_used", error,
     "\"{text}\" has an uncertainty, which is not used here; give the value alone",
     "„{text}“ hat eine Unsicherheit, die hier nicht gebraucht wird; bitte nur den Wert angeben"},
    {"no_closing_bracket", error, "\"{text}\" lacks a closing bracket",
     "in „{text}“ fehlt die schließende Klammer"},
    {"no_power_of_ten", error, "\"{text}\" has no power of ten after the 10",
     "in „{text}“ fehlt hinter der 10 die Potenz"},
    {"unknown_unit", error, "unknown unit \"{unit}\"", "die Einheit „{unit}“ ist unbekannt"},
    {"in_text", error, "\"{text}\": {what}", "„{text}“: {what}"},
    {"of_other_kind", error, "\"{text}\" is {kind}", "„{text}“ ist {kind}"},
    {"in_unit", clause, "in {unit}", "in {unit}"},
    {"expected_kind", clause, "expected {kind}, for instance {examples:or}",
     "erwartet wird {kind}, zum Beispiel {examples:or}"},
    {"expected_rate", clause, "expected a number of samples per second, for instance 100 Hz",
     "erwartet wird eine Zahl von Messwerten je Sekunde, zum Beispiel 100 Hz"},
    {"expected_in_unit", clause, "expected a number in {unit}", "erwartet wird eine Zahl in {unit}"},
    {"a_plain_number", clause, "a plain number", "eine bloße Zahl"},
    {"a_mass", clause, "a mass", "eine Masse"},
    {"a_stiffness", clause, "a stiffness", "eine Federkonstante"},
    {"a_damping", clause, "a damping", "eine Dämpfung"},
    {"a_drag", clause, "a drag", "ein Luftwiderstand"},
    {"a_force", clause, "a force", "eine Kraft"},
    {"a_cubic_stiffness", clause, "a cubic stiffness", "eine kubische Federkonstante"},
    {"a_quadratic_stiffness", clause, "a quadratic stiffness", "eine quadratische Federkonstante"},
    {"a_quintic_stiffness", clause, "a quintic stiffness", "eine Federkonstante fünfter Ordnung"},
    {"a_growing_damping", clause, "a damping that grows with the displacement",
     "eine Dämpfung, die mit der Auslenkung wächst"},
    {"a_length", clause, "a length", "eine Länge"},
    {"a_velocity", clause, "a velocity", "eine Geschwindigkeit"},
    {"an_acceleration", clause, "an acceleration", "eine Beschleunigung"},
    {"a_time", clause, "a time", "eine Zeit"},
    {"an_angle", clause, "an angle", "ein Winkel"},
    {"a_frequency", clause, "a frequency", "eine Frequenz"},
    {"a_rate", clause, "a rate", "eine Rate"},
    {"a_temperature", clause, "a temperature", "eine Temperatur"},
    {"an_energy", clause, "an energy", "eine Energie"},
    {"a_voltage", clause, "a voltage", "eine Spannung"},
    {"a_pressure", clause, "a pressure", "ein Druck"},

    // Grids
    {"no_grid", error,
     "\"{text}\" {what}; a grid is low:high:points, low:high:points:log, or a list with commas",
     "„{text}“ {what}; ein Gitter ist von:bis:Punkte, von:bis:Punkte:log oder eine Liste mit Kommas"},
    {"grid_without_points", clause, "has no number of points", "nennt keine Zahl von Punkten"},
    {"grid_of_pieces", clause, "has {pieces} pieces", "hat {pieces} Teile"},
    {"grid_ends_with", clause, "ends with \"{end}\", where only log can stand",
     "endet mit „{end}“, wo nur log stehen kann"},
    {"grid_points_not_whole", clause, "asks for \"{points}\" points, which is no whole number",
     "verlangt „{points}“ Punkte, was keine ganze Zahl ist"},
    {"grid_of_no_points", clause, "asks for no points", "verlangt keine Punkte"},
    {"grid_points_not_told_apart", clause, "asks for more points than can be told apart",
     "verlangt mehr Punkte, als sich unterscheiden lassen"},
    {"grid_points_with_unit", clause, "asks for \"{points}\" points; the unit stands at the end",
     "verlangt „{points}“ Punkte; die Einheit steht am Ende"},
    {"grid_of_one_point", clause, "asks for one point, but both ends are included: give at least 2",
     "verlangt einen Punkt, doch beide Enden gehören dazu: bitte mindestens 2 angeben"},
    {"grid_ends_not_positive", clause, "is logarithmic, so both ends must be positive",
     "ist logarithmisch, also müssen beide Enden größer als 0 sein"},
    {"grid_value_empty", error, "\"{text}\" has an empty value between its commas",
     "in „{text}“ fehlt ein Wert zwischen den Kommas"},
    {"grid_empty", error, "the grid is empty; give a value, a list with commas, or low:high:points",
     "das Gitter ist leer; bitte einen Wert, eine Liste mit Kommas oder von:bis:Punkte angeben"},
    {"points_too_many", error, "{points:.6g} points need {needed:n} of memory; ask for fewer",
     "{points:.6g} Punkte brauchen {needed:n} Speicher; bitte weniger verlangen"},
    {"points_beyond_memory", error,
     "{points:.6g} points need {needed:n} of memory, but there are only {memory:n}; ask for fewer",
     "{points:.6g} Punkte brauchen {needed:n} Speicher, aber nur {memory:n} sind da; bitte weniger "
     "verlangen"},

    // Names
    {"no_method", error, "there is no method \"{method}\" ({methods})",
     "ein Verfahren „{method}“ gibt es nicht ({methods})"},
    {"no_method_but", error, "there is no method \"{method}\"; did you mean {near:or}? ({methods})",
     "ein Verfahren „{method}“ gibt es nicht; ist {near:or} gemeint? ({methods})"},

    // Files
};

}  // namespace

const std::span<const Entry> words_of_base = entries;

}  // namespace cromer::core
