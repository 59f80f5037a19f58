#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // What is wrong with the options, or with the file.
    {"law_without_spring", error,
     "the law has no spring: give {--stiffness} or {--natural-frequency} as well (or nothing of the law: "
     "then spring and damping are fitted)",
     "dem Gesetz fehlt die Feder: bitte auch {--stiffness} oder {--natural-frequency} angeben (oder nichts "
     "vom Gesetz: dann werden Feder und Dämpfung angepasst)"},
    {"law_is_needed", error,
     "the rows do not swing for long enough to find their law: give it, by {--mass}, {--stiffness} and "
     "{--damping}",
     "die Zeilen schwingen nicht lange genug, um ihr Gesetz zu finden: bitte angeben, mit {--mass}, "
     "{--stiffness} und {--damping}"},
    {"too_many_steps_a_row", error,
     "{--step}: the rows are {steps} steps apart; under a law that is not linear at most {most} are tried",
     "{--step}: die Zeilen liegen {steps} Schritte auseinander; bei einem Gesetz, das nicht linear ist, "
     "werden höchstens {most} versucht"},
    {"step_not_part_of_spacing", error,
     "{--step}: the rows are {spacing:.6g} s apart, which is no whole number of steps of {step:.6g} s",
     "{--step}: die Zeilen liegen {spacing:.6g} s auseinander, das ist keine ganze Zahl von Schritten von "
     "{step:.6g} s"},
    {"run_stands_still", error, "nothing moves: position and velocity must not stay 0",
     "nichts bewegt sich: Ort und Geschwindigkeit dürfen nicht 0 bleiben"},
    {"which_column_is_the_position", error,
     "which column is the position? There are {columns:,}; say it with {--column}",
     "welche Spalte ist der Ort? Es gibt {columns:,}; bitte mit {--column} sagen"},
    {"which_column_is_the_velocity", error,
     "which column is the velocity? There are {columns:,}; say it with {--velocity-column}. A method is told "
     "by position and velocity together",
     "welche Spalte ist die Geschwindigkeit? Es gibt {columns:,}; bitte mit {--velocity-column} sagen. Ein "
     "Verfahren erkennt man an Ort und Geschwindigkeit zusammen"},
    {"which_run", error, "the file has {runs} runs: say which with {--run}",
     "die Datei hat {runs} Läufe: bitte einen mit {--run} nennen"},
    {"state_is_missing", error,
     "{@line}: a time, position or velocity is missing; rows without one are to be taken out first",
     "{@line}: eine Zeit, ein Ort oder eine Geschwindigkeit fehlt; bitte solche Zeilen vorher entfernen"},
    {"too_few_states", error, "{rows:row|rows}, and at least {fewest} are needed",
     "{rows:Zeile|Zeilen}, nötig sind mindestens {fewest}"},
    {"states_not_even", error,
     "{@line}: the times are not evenly spaced ({t:.9g} s where {even:.9g} s is expected, a row every "
     "{spacing:.6g} s); only equal steps can be recognised",
     "{@line}: die Zeiten sind nicht gleichmäßig ({t:.9g} s, wo {even:.9g} s erwartet wird, alle "
     "{spacing:.6g} s eine Zeile); nur gleiche Schritte lassen sich erkennen"},

    // The answer.
    {"maker_with_step", clause, "{method} with a step of {step:.6g} s",
     "{method} mit einem Schritt von {step:.6g} s"},
    {"maker_with_velocity_ahead", clause,
     "{method} with a step of {step:.6g} s (each velocity is one step later than its position, as where the "
     "position is stepped first)",
     "{method} mit einem Schritt von {step:.6g} s (jede Geschwindigkeit ist einen Schritt später als ihr "
     "Ort, wie dort, wo erst der Ort weitergeht)"},
    {"maker_without_step", clause, "{method}", "{method}"},
    {"the_same_map", clause, " (the same map: {methods:and})", " (dieselbe Abbildung: {methods:and})"},
    {"or_others_alike", clause, ", or {count:other|others} below it that the digits do not tell from it,",
     ", oder {count:weiteres|weitere} darunter, die sich an den Stellen nicht unterscheiden,"},
    {"method_added", clause,
     ". It added {rate:.4g} 1/s to the decay rate of the law and {shift:.4g} rad/s to its frequency",
     ". Zur Abklingrate des Gesetzes kamen {rate:.4g} 1/s hinzu, zu seiner Frequenz {shift:.4g} rad/s"},
    {"rows_made_by", clause, "{maker}{same}{others} made these rows{added}",
     "{maker}{same}{others} hat diese Zeilen gemacht{added}"},
    {"rows_follow_the_law", clause,
     "these rows follow the law itself: their digits show no error of a method. {methods:or} gives them, and "
     "so does any method with steps short enough",
     "diese Zeilen folgen dem Gesetz selbst: ihre Stellen zeigen keinen Fehler eines Verfahrens. "
     "{methods:or} ergibt sie, ebenso jedes Verfahren mit genügend kurzen Schritten"},
    {"rows_follow_the_law_nearly", clause,
     "these rows follow the law itself ({methods:or}) to {percent:.2g} % of the motion, and none of the "
     "methods known here made them by equal steps: so does another method, an adaptive one with such a "
     "tolerance, or a law that is a little different",
     "diese Zeilen folgen dem Gesetz selbst ({methods:or}) bis auf {percent:.2g} % der Bewegung, und keines "
     "der hier bekannten Verfahren hat sie mit gleichen Schritten gemacht: so tut es ein anderes Verfahren, "
     "ein adaptives mit solcher Toleranz oder ein wenig anderes Gesetz"},
    {"rows_made_from_other_law", clause,
     "no method made these rows from the law given. From a natural frequency of {frequency:.8g} rad/s and a "
     "damping ratio of {ratio:.5g}, {maker}{same}{others} makes them: check the law, or it is another "
     "variant of a method",
     "kein Verfahren hat diese Zeilen aus dem gegebenen Gesetz gemacht. Aus einer Eigenfrequenz von "
     "{frequency:.8g} rad/s und einem Dämpfungsgrad von {ratio:.5g} macht {maker}{same}{others} sie: bitte "
     "das Gesetz prüfen, oder es ist eine andere Spielart eines Verfahrens"},
    {"rows_made_by_none", clause,
     "none of the methods made these rows: it may be another method, another law, or noise. The nearest, "
     "{maker}, is off by {percent:.2g} % of the motion, {times:.2g} times what rounding does",
     "keines der Verfahren hat diese Zeilen gemacht: es mag ein anderes Verfahren sein, ein anderes Gesetz "
     "oder Rauschen. Das nächste, {maker}, weicht um {percent:.2g} % der Bewegung ab, das {times:.2g}-Fache "
     "der Rundung"},
    {"rows_made_by_none_of_all_alike", clause,
     "none of the methods made these rows. The nearest, {maker}, is off by {percent:.2g} % of the motion, "
     "{times:.2g} times what rounding does, and others are as far off: the law is likely to be another one, "
     "or the rows hold noise",
     "keines der Verfahren hat diese Zeilen gemacht. Das nächste, {maker}, weicht um {percent:.2g} % der "
     "Bewegung ab, das {times:.2g}-Fache der Rundung, und andere ebenso: wahrscheinlich ist das Gesetz ein "
     "anderes, oder die Zeilen enthalten Rauschen"},
    {"no_method_gets_through", clause, "no method gets through with this law",
     "mit diesem Gesetz kommt kein Verfahren durch"},
    {"law_was_fitted", worth_knowing,
     "no law was given: a natural frequency of {frequency:.8g} rad/s and a damping ratio of {ratio:.5g} were "
     "fitted together with the method",
     "kein Gesetz war gegeben: eine Eigenfrequenz von {frequency:.8g} rad/s und ein Dämpfungsgrad von "
     "{ratio:.5g} wurden zusammen mit dem Verfahren angepasst"},
    {"more_is_left_than_rounding", worth_knowing,
     "what is left of the rows is {times:.2g} times what rounding makes, though far less than by any other "
     "method: the numbers of the law may be off a little",
     "von den Zeilen bleibt das {times:.2g}-Fache der Rundung übrig, wenn auch viel weniger als bei jedem "
     "anderen Verfahren: die Zahlen des Gesetzes sind vielleicht ein wenig falsch"},
    {"recognising_was_interrupted", clause, "interrupted: not all methods were tried",
     "abgebrochen: nicht alle Verfahren sind versucht"},
    {"what_distances_are", clause,
     "distance: rms of what is left of {rows} rows over the rms of the motion; rounding alone makes "
     "{rounding:.2g}.",
     "distance: Effektivwert dessen, was von {rows} Zeilen übrig bleibt, über dem der Bewegung; Rundung "
     "allein ergibt {rounding:.2g}."},
    {"answer_as_sentence", clause, "{what:A}.", "{what:A}."},
};

}  // namespace

const std::span<const Entry> words_of_recognise = entries;

}  // namespace cromer::core
