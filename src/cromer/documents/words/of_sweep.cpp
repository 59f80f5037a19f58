#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // What a sweep does not take.
    {"sweep_takes_no_pulse", error,
     "{option:option}: a sweep takes drives that go on (harmonic, unbalance, base); run pulses and chirps "
     "with simulate",
     "{option:option}: eine Reihe nimmt Antriebe, die andauern (harmonic, unbalance, base); Stöße und "
     "Chirps laufen mit simulate"},
    {"sweep_takes_no_record", error,
     "{option:option}: a sweep takes drives that go on (harmonic, unbalance, base); run recorded ones with "
     "simulate",
     "{option:option}: eine Reihe nimmt Antriebe, die andauern (harmonic, unbalance, base); aufgenommene "
     "laufen mit simulate"},
    {"sweep_has_no_sensor", error,
     "{option:option}: a sweep measures the motion itself, not a sensor's samples; leave it out, or take "
     "simulate",
     "{option:option}: eine Reihe misst die Bewegung selbst, nicht die Messwerte eines Sensors; bitte "
     "weglassen oder simulate nehmen"},
    {"sweep_takes_the_step", error,
     "{--accuracy}: a sweep needs the step itself, which may be a grid: {--step} 0.001:0.1:20:log",
     "{--accuracy}: eine Reihe braucht den Schritt selbst, auch mehrere: {--step} 0.001:0.1:20:log"},
    {"sweep_has_no_event", error, "{--event}: a sweep measures whole runs; look for events with simulate",
     "{--event}: eine Reihe misst ganze Läufe; Ereignisse sucht simulate"},
    {"sweep_keeps_no_states", error,
     "{--every}: a sweep keeps measures and no states, so there is nothing to thin out; leave it out",
     "{--every}: eine Reihe behält Maße und keine Zustände, auszudünnen ist nichts; bitte weglassen"},
    {"sweep_runs_are_short", error,
     "{--compensated}: a sweep's runs are too short to need it; take simulate for millions of steps",
     "{--compensated}: die Läufe einer Reihe sind zu kurz dafür; für Millionen Schritte ist simulate da"},
    {"sweep_has_no_memory", error,
     "{option:option}: a sweep steps position and velocity alone, not a force with memory; run it with "
     "simulate, once for each value",
     "{option:option}: eine Reihe rechnet mit Ort und Geschwindigkeit allein, nicht mit einer Kraft mit "
     "Gedächtnis; bitte simulate nehmen, einmal für jeden Wert"},
    {"settle_is_no_grid", error,
     "{--settle}: \"{typed}\" looks like a grid, but this is one number for all points; it says how they are "
     "found, not what they are",
     "{--settle}: „{typed}“ sieht nach mehreren Werten aus, das hier ist eine Zahl für alle Punkte; sie "
     "sagt, wie sie gefunden werden, nicht, was sie sind"},
    {"threads_are_no_grid", error,
     "{--threads}: \"{typed}\" looks like a grid, but this is one number for all points",
     "{--threads}: „{typed}“ sieht nach mehreren Werten aus, das hier ist eine Zahl für alle Punkte"},
    {"sweep_drives_go_on", error,
     "{--drive} {drive}: a sweep takes drives that go on: harmonic, unbalance or base; run the others with "
     "simulate",
     "{--drive} {drive}: eine Reihe nimmt Antriebe, die andauern: harmonic, unbalance oder base; die "
     "anderen laufen mit simulate"},
    // A loss factor.
    {"loss_factor_in_closed_form", error,
     "{--loss-factor} is for the settled motion of a linear law, in closed form; leave {option:option} out",
     "{--loss-factor} gilt für die eingeschwungene Bewegung eines linearen Gesetzes, in geschlossener Form; "
     "bitte {option:option} weglassen"},
    {"loss_factor_of_base", error,
     "{--loss-factor} is for the settled motion of a linear law, in closed form; leave {--drive} base out",
     "{--loss-factor} gilt für die eingeschwungene Bewegung eines linearen Gesetzes, in geschlossener Form; "
     "bitte {--drive} base weglassen"},
    {"loss_factor_not_stepped", error,
     "{--loss-factor} has no law in time that {method} could step; leave {--method} out",
     "{--loss-factor} hat kein Gesetz in der Zeit, das {method} rechnen könnte; bitte {--method} weglassen"},
    {"loss_factor_undriven", error,
     "{--loss-factor}: nothing drives the motion; give {--drive-amplitude} and {--drive-frequency}",
     "{--loss-factor}: nichts treibt die Bewegung an; bitte {--drive-amplitude} und {--drive-frequency} "
     "angeben"},
    {"loss_factor_measure", error,
     "{--loss-factor} is for the settled motion; {--measure} {measure} looks at another",
     "{--loss-factor} gilt für die eingeschwungene Bewegung; {--measure} {measure} betrachtet eine andere"},
    // Grids and points.
    {"nothing_swept", error,
     "nothing is swept: give at least one numeric option a grid, for instance {--drive-amplitude} 1 "
     "{--drive-frequency} 0.1:10:1000, or {--position} 0.5,1,1.5 {--until} 20",
     "nichts wird durchlaufen: bitte mindestens einer Zahl mehrere Werte geben, zum Beispiel "
     "{--drive-amplitude} 1 {--drive-frequency} 0.1:10:1000 oder {--position} 0.5,1,1.5 {--until} 20"},
    {"too_many_points", error,
     "the grids multiply to {points:.3g} points, too many to be told apart; take coarser ones",
     "zusammen sind das {points:.3g} Punkte, mehr, als sich unterscheiden lassen; bitte gröber teilen"},
    {"point_cannot_run", error, "{axis:option} {value:n}{unit: }: {what}",
     "{axis:option} {value:n}{unit: }: {what}"},
    {"nothing_swings", error, "{axis:option}: at {low:n} nothing swings, so nothing settles; begin above it",
     "{axis:option}: bei {low:n} schwingt nichts, also schwingt sich nichts ein; bitte darüber beginnen"},
    {"one_method", error, "{--method}: a sweep uses one method, not {methods}; run it once for each",
     "{--method}: eine Reihe hat ein Verfahren, nicht {methods}; bitte für jedes einmal rechnen"},
    {"rows_can_stream", error, "{what}, or let them stream to a file: -o FILE.h5",
     "{what}, oder bitte gleich in eine Datei schreiben lassen: -o FILE.h5"},
    // Measures.
    {"no_such_measure", error, "{--measure}: there is no measure \"{typed}\"{near} ({measures})",
     "{--measure}: ein Maß „{typed}“ gibt es nicht{near} ({measures})"},
    {"perhaps_measure", clause, "; did you mean {near}?", "; ist {near} gemeint?"},
    {"measure_twice", error, "{--measure}: {measure} is asked for twice",
     "{--measure}: {measure} ist zweimal verlangt"},
    {"measure_undriven", error,
     "{--measure} {measure}: without a drive the motion dies away; measure peak, final or energy, or give "
     "{--drive-amplitude} and {--drive-frequency}",
     "{--measure} {measure}: ohne Antrieb klingt die Bewegung ab; bitte peak, final oder energy messen, "
     "oder {--drive-amplitude} und {--drive-frequency} angeben"},
    {"measure_of_base", error,
     "{--measure} {measure} compares the mass with the base that shakes it; give {--drive} base and "
     "{--base-displacement}",
     "{--measure} {measure} vergleicht die Masse mit dem Fußpunkt, der sie schüttelt; bitte {--drive} base "
     "und {--base-displacement} angeben"},
    // How points are found.
    {"no_such_direction", error, "{--direction}: \"{typed}\" is none of up, down and both",
     "{--direction}: „{typed}“ ist weder up noch down noch both"},
    {"direction_along_nothing", error,
     "{--direction}: the points follow each other along {--drive-frequency} or {--drive-amplitude}, and "
     "neither has a grid",
     "{--direction}: die Punkte folgen einander entlang {--drive-frequency} oder {--drive-amplitude}, und "
     "beide haben nur einen Wert"},
    {"direction_and_until", error,
     "{--direction}: points follow each other where the motion has settled; leave {--until} out",
     "{--direction}: Punkte folgen einander, wo die Bewegung eingeschwungen ist; bitte {--until} weglassen"},
    {"direction_one_by_one", error,
     "{--direction}: with {what} each point is a run of its own; take a method of fixed steps, for instance "
     "rk4, and no friction",
     "{--direction}: mit {what} ist jeder Punkt ein eigener Lauf; bitte ein Verfahren mit festen Schritten "
     "nehmen, zum Beispiel rk4, und keine trockene Reibung"},
    {"sweep_with_friction", clause, "friction", "trockener Reibung"},
    {"until_of_settled_motion", error,
     "{--until}: {measure} belongs to the settled motion, which has no end; leave {--until} out, or measure "
     "peak, final or energy",
     "{--until}: {measure} gehört zur eingeschwungenen Bewegung, und die hat kein Ende; bitte {--until} "
     "weglassen oder peak, final oder energy messen"},
    {"settle_and_until", error,
     "{--settle}: a run to its end drops no cycles; leave {--settle} or {--until} out",
     "{--settle}: ein Lauf bis zu seinem Ende lässt keine Perioden aus; bitte {--settle} oder {--until} "
     "weglassen"},
    {"trajectories_have_no_end", error,
     "{--trajectories}: this sweep looks for settled motion, which has no end; say with {--until} how long "
     "the runs are",
     "{--trajectories}: diese Reihe sucht die eingeschwungene Bewegung, und die hat kein Ende; bitte mit "
     "{--until} sagen, wie lang die Läufe sind"},
    // Closed form and stepping side by side.
    {"nothing_to_check", worth_knowing, "{--check}: there is no closed form to check at any point: {why}",
     "{--check}: an keinem Punkt gibt es eine geschlossene Form zu prüfen: {why}"},
    {"nothing_to_check_by", worth_knowing,
     "{--check}: {method} is the closed form of the law itself and takes no steps to check it by; take "
     "another method",
     "{--check}: {method} ist die geschlossene Form des Gesetzes selbst und hat keine Schritte, sie zu "
     "prüfen; bitte ein anderes Verfahren nehmen"},
    {"each_goes_on", clause, "with {--direction} each starts where the one before ended",
     "mit {--direction} beginnt jeder, wo der vorige endete"},
    {"settle_asks_for_steps", clause, "{--settle} asks for stepping", "{--settle} verlangt Schritte"},
    {"stepped_to_an_end", clause, "they are stepped to an end, not settled under a drive",
     "sie laufen bis zu einem Ende und schwingen sich nicht unter einem Antrieb ein"},
    {"measure_by_steps", clause, "{measure} comes from stepping alone", "{measure} kommt nur aus Schritten"},
    {"chooses_its_steps", clause, "{method} chooses its own steps", "{method} wählt seine Schritte selbst"},
    {"law_not_linear", clause, "the law is not linear", "das Gesetz ist nicht linear"},
    {"grows_without_end", clause, "its motion grows without end", "seine Bewegung wächst ohne Ende"},
    {"undamped_never_settles", clause, "without damping it has no settled motion",
     "ohne Dämpfung schwingt es sich nie ein"},
    {"stepped_not_settled", clause, "when stepped it does not settle in time",
     "in Schritten schwingt es sich nicht rechtzeitig ein"},
    {"stepped_runs_away", clause, "when stepped it runs away", "in Schritten läuft es davon"},
    // What the numbers rest on.
    {"few_steps_in_a_cycle", wrong_if_ignored,
     "{--step}: at an end of the grid a cycle of the drive has only {steps:.2g} steps: the result there is "
     "the method's, not the law's",
     "{--step}: am Rand hat eine Periode des Antriebs nur {steps:.2g} Schritte: das Ergebnis dort kommt vom "
     "Verfahren, nicht vom Gesetz"},
    {"settles_by_own_damping", wrong_if_ignored,
     "{points} of {all} points have no damping in the law: what settles there settles by {method}'s own "
     "damping alone{number}; give {--damping} or {--damping-ratio}, or {--until} to see the motion that does "
     "not settle",
     "{points} von {all} Punkten haben nach dem Gesetz keine Dämpfung: was sich dort einschwingt, tut es "
     "allein durch die Dämpfung des Verfahrens {method}{number}; bitte {--damping} oder {--damping-ratio} "
     "angeben, oder {--until}, um die Bewegung zu sehen, die sich nicht einschwingt"},
    {"own_decay_rate", clause, ": decay rate {rate:.2g} 1/s at {place:n}, {cycles:.2g} cycles of the drive",
     ": Abklingrate {rate:.2g} 1/s bei {place:n}, {cycles:.2g} Perioden des Antriebs"},
    {"lag_outside", wrong_if_ignored,
     "the lag of {points} of {all} points lies outside 0 to pi, by {excess:.2g} rad at {place:n}: "
     "{why}{method}'s own error feeds the motion there, where a damper only takes energy; a shorter "
     "{--step} brings the lag back",
     "die Phase von {points} von {all} Punkten liegt außerhalb von 0 bis pi, um {excess:.2g} rad bei "
     "{place:n}: {why}der Fehler von {method} nährt dort die Bewegung, wo ein Dämpfer nur Energie nimmt; "
     "ein kürzerer Schritt, {--step}, bringt sie zurück"},
    {"free_motion_may_be_there", clause,
     "after {cycles:.6g} cycles the free motion may still be there (drop more), or ",
     "nach {cycles:.6g} Perioden ist die freie Bewegung vielleicht noch da (bitte mehr auslassen), oder "},
    {"settling_leaves", clause, "settling leaves {left:.6g}, or ",
     "das Einschwingen lässt {left:.6g} übrig, oder "},
    {"points_in_trouble", error, "{points}", "{points}"},
    {"points_not_settled", worth_knowing,
     "{points} of {all} points never settled; {--settle} N measures them as they are after N cycles",
     "{points} von {all} Punkten schwingen sich nie ein; {--settle} N misst sie, wie sie nach N Perioden "
     "sind"},
    {"points_not_settled_undamped", worth_knowing,
     "{points} of {all} points never settled: the law has no damping, so the free motion stays; give "
     "{--damping}",
     "{points} von {all} Punkten schwingen sich nie ein: das Gesetz hat keine Dämpfung, so bleibt die freie "
     "Schwingung; {--damping} angeben"},
    {"points_unstable", worth_knowing,
     "{points} of {all} points are unstable: the free motion of the law, as {method} has it, grows without "
     "end",
     "{points} von {all} Punkten sind instabil: die freie Schwingung des Gesetzes wächst mit {method} ohne "
     "Ende"},
    {"points_ran_away", worth_knowing, "{points} of {all} points ran away",
     "{points} von {all} Punkten liefen davon"},
    {"points_without_solution", worth_knowing,
     "at {points} of {all} points an implicit step found no solution",
     "an {points} von {all} Punkten fand ein impliziter Schritt keine Lösung"},
    {"rows_not_reached", clause, "interrupted: rows that were not reached are null",
     "abgebrochen: Zeilen, die nicht erreicht wurden, sind null"},
    // How points are found, and in which steps.
    {"closed_form", clause, "closed form", "geschlossene Form"},
    {"stepped_until_settled", clause, "stepped until settled", "in Schritten bis zum Einschwingen"},
    {"stepped_to_the_end", clause, "stepped to the end", "in Schritten bis zum Ende"},
    {"run_one_by_one", clause, "run one by one", "einzeln gerechnet"},
    {"cycles_dropped", clause, "stepped, {cycles} cycles dropped",
     "in Schritten, {cycles} Perioden ausgelassen"},
    {"steps_of", clause, "steps of {step} s", "Schritte von {step} s"},
    {"steps_in_a_natural_period", clause, "{steps} steps in a natural period",
     "{steps} Schritte in einer Eigenperiode"},
    {"steps_in_the_shorter_period", clause,
     "{steps} steps in a natural or a drive period, whichever is shorter",
     "{steps} Schritte in der kürzeren von Eigenperiode und Periode des Antriebs"},
    {"to_the_time", clause, "to {until} s", "bis {until} s"},
    {"for_natural_periods", clause, "for {periods} natural periods", "{periods} Eigenperioden lang"},
    {"steps_and_end", clause, "{steps}, {end}", "{steps}, {end}"},

    // The machine.
    {"simd_not_here", error, "CROMER_SIMD={name}: this machine has no such instructions",
     "CROMER_SIMD={name}: solche Befehle hat dieser Rechner nicht"},
    {"simd_unknown", error, "CROMER_SIMD={name}: baseline, avx2 or avx512 is expected",
     "CROMER_SIMD={name}: erwartet wird baseline, avx2 oder avx512"},
};

}  // namespace

const std::span<const Entry> words_of_sweep = entries;

}  // namespace cromer::core
