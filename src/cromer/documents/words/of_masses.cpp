#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // A mass for each file
    {"masses_unlike_files", error,
     "{--mass}: {masses:mass is|masses are} given for {files} files; give one for all, or one for each",
     "{--mass}: {masses} Massen für {files} Dateien; bitte eine für alle oder jeder ihre eigene"},
    {"one_mass_for_unlike_files", worth_knowing,
     "the frequency is {percent:.2g} % above that of {low}, and one mass is used for all; if the masses "
     "differ, give one for each: {--mass} \"0.1 kg, 0.2 kg\"",
     "die Frequenz liegt {percent:.2g} % über der von {low}, und für alle gilt eine Masse; sind es "
     "verschiedene, dann jede angeben: {--mass} \"0.1 kg, 0.2 kg\""},

    // Lines through several masses
    {"masses_unlike_recordings", error,
     "{--masses}: {masses:mass is|masses are} given for {recordings:recording|recordings}; each recording, "
     "and each run in one, needs its own",
     "{--masses}: {masses:Masse|Massen} für {recordings:Aufnahme|Aufnahmen}; jede Aufnahme und jeder Lauf "
     "darin braucht eine eigene"},
    {"run_left_out_of_line", worth_knowing, "{file}, run {run} is left out of the line: {why}",
     "{file}, Lauf {run} bleibt aus der Geraden weg: {why}"},
    {"mass_line_of_one_mass", error, "{--mass-line} needs at least two recordings of different masses",
     "{--mass-line} braucht mindestens zwei Aufnahmen verschiedener Massen"},
    {"period_does_not_grow", error,
     "{--mass-line}: the period does not grow with the mass; are {--masses} in the order of the recordings?",
     "{--mass-line}: die Periode wächst nicht mit der Masse; stehen {--masses} in der Reihenfolge der "
     "Aufnahmen?"},
    {"line_of_two", worth_knowing, "two masses always give a line: nothing shows whether it is one",
     "zwei Massen geben immer eine Gerade: nichts zeigt, ob es eine ist"},
    {"points_scatter", worth_knowing,
     "the points scatter about the line by more than their errors give on average: {scatter:.2g} s² is "
     "added to all errors, and the intervals are those of {degrees:degree|degrees} of freedom",
     "die Punkte streuen um die Gerade um mehr, als ihre Fehler im Mittel ergeben: {scatter:.2g} s² ist "
     "allen Fehlern zugeschlagen, und die Bereiche sind die von {degrees:Freiheitsgrad|Freiheitsgraden}"},

    // Masses at rest
    {"no_meaning_with_static", error,
     "{option:option} has no meaning with {--static}: a mass at rest has no motion; leave it out, or leave "
     "out {--static}",
     "{option:option} hat mit {--static} keinen Sinn: eine Masse in Ruhe bewegt sich nicht; bitte das eine "
     "oder das andere weglassen"},
    {"static_needs_positions", error,
     "{file}: {--static} needs positions, and column \"{column}\" holds {kind}",
     "{file}: {--static} braucht Orte, und die Spalte „{column}“ enthält {kind}"},
    {"run_has_no_values", error, "{file}: run {run} has no values", "{file}: Lauf {run} hat keine Werte"},
    {"holds_move", error,
     "{file}: {--static} needs masses at rest, and this moves nearly all the time, by {span:length} from one "
     "side to the other; leave {--static} out to fit its swing",
     "{file}: {--static} braucht Massen in Ruhe, und diese bewegt sich fast immer, um {span:length} von "
     "einer Seite zur anderen; ohne {--static} wird die Schwingung angepasst"},
    {"plateaus_unlike_masses", error,
     "{file}: {masses:mass is|masses are} given, and {found:plateau is|plateaus are} found{where}; choose "
     "the part with {|{--from} and {--to}|the handles}, or give each hold as a run or file of its own",
     "{file}: {masses} Massen sind angegeben und {found:Ruhelage|Ruhelagen} gefunden{where}; bitte mit "
     "{|{--from} und {--to}|den Griffen} den Teil wählen oder jede Ruhelage als eigenen Lauf oder eigene "
     "Datei geben"},
    {"stretches", clause, ": {stretches:,}", ": {stretches:,}"},
    {"stretch", clause, "{from:.4g} to {to:.4g} s", "{from:.4g} bis {to:.4g} s"},
    {"more_holds_than_masses", error,
     "{--masses}: {masses:mass is|masses are} given, and there are more holds: {file} has {runs:run|runs}",
     "{--masses}: {masses:Masse|Massen}, und es gibt mehr Ruhelagen: {file} hat {runs:Lauf|Läufe}"},
    {"more_masses_than_holds", error, "{--masses}: {masses:mass is|masses are} given for {holds:hold|holds}",
     "{--masses}: {masses:Masse|Massen} für {holds:Ruhelage|Ruhelagen}"},
    {"too_few_holds", error,
     "{--masses}: a line needs at least two holds of different masses, and three where their errors are not "
     "known",
     "{--masses}: eine Gerade braucht mindestens zwei Ruhelagen verschiedener Massen, und drei, wo ihre "
     "Fehler nicht bekannt sind"},
    {"perhaps_held", worth_knowing,
     "{how}: if different masses hung on one spring, {--static} {--masses} \"{example}\" gives its constant "
     "from where they rest",
     "{how}: hingen verschiedene Massen an einer Feder, so gibt {--static} {--masses} \"{example}\" deren "
     "Konstante aus den Ruhelagen"},
    {"runs_lie_apart", clause,
     "the runs lie apart by much more than they move ({least:length} to {most:length} each)",
     "die Läufe liegen viel weiter auseinander, als sie sich bewegen (je {least:length} bis {most:length})"},
    {"rests_at_levels", clause, "it rests at {levels} levels, one after the other",
     "es ruht nacheinander auf {levels} Höhen"},
    {"holds_scatter", worth_knowing,
     "the holds scatter about the line by more than their own errors give on average: {scatter:length} is "
     "added to all errors, and the interval is that of {degrees:degree|degrees} of freedom",
     "die Ruhelagen streuen um die Gerade um mehr, als ihre eigenen Fehler im Mittel ergeben: "
     "{scatter:length} ist allen Fehlern zugeschlagen, und der Bereich ist der von "
     "{degrees:Freiheitsgrad|Freiheitsgraden}"},
    {"hold_moves", wrong_if_ignored,
     "{file}, run {run}, {from:.4g} to {to:.4g} s is not at rest: it moves by {scatter:length} (rms), and "
     "its mean is taken; choose a quiet part with {|{--from} and {--to}|the handles}, or fit its swing "
     "without {--static}",
     "{file}, Lauf {run}, {from:.4g} bis {to:.4g} s ist nicht in Ruhe: es bewegt sich um {scatter:length} "
     "(Effektivwert), und der Mittelwert gilt; bitte mit {|{--from} und {--to}|den Griffen} einen ruhigen "
     "Teil wählen oder die Schwingung ohne {--static} anpassen"},
    {"hold_drifts", wrong_if_ignored,
     "{file}, run {run}, {from:.4g} to {to:.4g} s drifts by {drift:length}: its mean is taken and the drift "
     "is in its uncertainty; a drift from one hold to the next is not included; wait until the mass is at "
     "rest",
     "{file}, Lauf {run}, {from:.4g} bis {to:.4g} s wandert um {drift:length}: der Mittelwert gilt, und das "
     "Wandern steckt in seiner Unsicherheit, ein Wandern von einer Ruhelage zur nächsten nicht; bitte "
     "warten, bis die Masse ruht"},
    {"hold_with_outliers", worth_knowing,
     "{file}, run {run}, {from:.4g} to {to:.4g} s: {samples:sample lies|samples lie} far from all others "
     "and {samples?is|are} left out",
     "{file}, Lauf {run}, {from:.4g} bis {to:.4g} s: {samples:Messwert liegt|Messwerte liegen} weit von "
     "allen anderen und {samples?fehlt|fehlen} im Mittelwert"},
    {"holds_out_of_order", wrong_if_ignored,
     "the position does not move in one direction as the mass grows; {--masses} must be in the order of the "
     "holds",
     "der Ort ändert sich mit wachsender Masse nicht immer in dieselbe Richtung; {--masses} müssen in der "
     "Reihenfolge der Ruhelagen stehen"},
};

}  // namespace

const std::span<const Entry> words_of_masses = entries;

}  // namespace cromer::core
