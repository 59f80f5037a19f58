#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // Options that set the same thing, or the law
    {"spring_set_twice", error,
     "{--stiffness} and {--natural-frequency} both set the spring; give one of them",
     "{--stiffness} und {--natural-frequency} legen beide die Feder fest; bitte nur eines davon angeben"},
    {"damping_set_twice", error,
     "{--damping}, {--damping-ratio} and {--quality-factor} all set the damping; give one of them",
     "{--damping}, {--damping-ratio} und {--quality-factor} legen alle die Dämpfung fest; bitte nur eines "
     "davon angeben"},
    {"step_set_twice", error, "{--step} and {--accuracy} both set the step; give one of them",
     "{--step} und {--accuracy} legen beide den Schritt fest; bitte nur eines davon angeben"},
    {"static_friction_too_small", error,
     "{--static-friction}: it must be at least {--friction} ({friction} N), not {static_friction} N",
     "{--static-friction}: das muss mindestens {--friction} sein ({friction} N), nicht {static_friction} N"},
    {"damping_ratio_without_spring", error,
     "{--damping-ratio}: it needs a positive stiffness, not {stiffness} N/m; give {--damping} instead",
     "{--damping-ratio}: dazu gehört eine Federkonstante über 0, nicht {stiffness} N/m; bitte stattdessen "
     "{--damping} angeben"},
    {"quality_factor_without_spring", error,
     "{--quality-factor}: it needs a positive stiffness, not {stiffness} N/m; give {--damping} instead",
     "{--quality-factor}: dazu gehört eine Federkonstante über 0, nicht {stiffness} N/m; bitte stattdessen "
     "{--damping} angeben"},
    {"law_too_large", error,
     "{--natural-frequency}: with this mass the stiffness or the damping is beyond the largest number",
     "{--natural-frequency}: mit dieser Masse übersteigt die Federkonstante oder die Dämpfung die größte "
     "Zahl"},
    {"start_energy_too_large", error,
     "{option:option}: the energy at the start (x = {x} m, v = {v} m/s) is beyond the largest number",
     "{option:option}: die Energie am Anfang (x = {x} m, v = {v} m/s) übersteigt die größte Zahl"},

    // Step, end and method
    {"no_period_for_until", error,
     "this law has no natural period ({terms:,}) and no periodic drive: give {--until}",
     "dieses Gesetz hat keine Eigenperiode ({terms:,}) und keinen periodischen Antrieb: bitte {--until} "
     "angeben"},
    {"no_period_for_step", error,
     "this law has no natural period ({terms:,}) and no periodic drive: give {--step}",
     "dieses Gesetz hat keine Eigenperiode ({terms:,}) und keinen periodischen Antrieb: bitte {--step} "
     "angeben"},
    {"no_period_for_step_and_until", error,
     "this law has no natural period ({terms:,}) and no periodic drive: give {--step} and {--until}",
     "dieses Gesetz hat keine Eigenperiode ({terms:,}) und keinen periodischen Antrieb: bitte {--step} und "
     "{--until} angeben"},
    {"coefficient_in_unit", clause, "{name} {value} {unit}", "{name} {value} {unit}"},
    {"run_of_too_many_steps", error,
     "{--step}: {step} s up to {until} s are {steps:.3g} steps, too many to be told apart; take a longer "
     "step",
     "{--step}: {step} s bis {until} s sind {steps:.3g} Schritte, zu viele, um sie zu unterscheiden; bitte "
     "längere Schritte nehmen"},
    {"states_beyond_memory", error,
     "{--step}: keeping {states:.3g} states needs {needed:n} of memory, but there are only {memory:n}; take "
     "a longer {--step}, a shorter {--until}, or keep every Nth state with {--every} N",
     "{--step}: {states:.3g} Zustände zu behalten braucht {needed:n} Speicher, aber nur {memory:n} sind da; "
     "bitte {--step} verlängern, {--until} verkürzen oder mit {--every} N nur jeden N-ten behalten"},
    {"accuracy_out_of_reach", error,
     "{--accuracy}: {accuracy} would need steps below {step:.3g} s, more than {steps:.0e} up to {until} s; "
     "ask for less, take a method of higher order, or a shorter {--until}",
     "{--accuracy}: {accuracy} brauchte Schritte unter {step:.3g} s, mehr als {steps:.0e} bis {until} s; "
     "bitte weniger verlangen, ein Verfahren höherer Ordnung nehmen oder {--until} verkürzen"},
    {"accuracy_of_adaptive_method", error,
     "{--accuracy}: {method} chooses its own steps; give {--tolerance} instead",
     "{--accuracy}: {method} wählt seine Schritte selbst; bitte stattdessen {--tolerance} angeben"},
    {"method_is_wrong", error, "{--method}: {what}", "{--method}: {what}"},
    {"exact_with_friction", error,
     "{--method} exact: with friction ({friction} N) there is no closed form under a drive; leave one of "
     "them out or choose another method, for instance dormand-prince",
     "{--method} exact: mit trockener Reibung ({friction} N) gibt es unter einem Antrieb keine geschlossene "
     "Lösung; bitte eines weglassen oder ein anderes Verfahren wählen, zum Beispiel dormand-prince"},
    {"exact_with_friction_under", error,
     "{--method} exact: with friction there is no closed form under a drive ({drive}); leave one out or "
     "choose another method",
     "{--method} exact: mit trockener Reibung gibt es unter einem Antrieb ({drive}) keine geschlossene "
     "Lösung; bitte eines weglassen oder ein anderes Verfahren wählen"},
    {"exact_with_term", error,
     "{--method} exact: there is no closed form with {term} ({value} {unit}); leave it out or choose "
     "another method, for instance rk4 with a short step",
     "{--method} exact: mit {term} ({value} {unit}) gibt es keine geschlossene Lösung; bitte weglassen oder "
     "ein anderes Verfahren wählen, zum Beispiel rk4 mit einem kurzen Schritt"},
    {"exact_under_chirp", error,
     "{--method} exact: there is no closed form for {--drive} {drive}; choose another method, for instance "
     "dormand-prince or rk4 with a short step",
     "{--method} exact: zu {--drive} {drive} gibt es keine geschlossene Lösung; bitte ein anderes Verfahren "
     "wählen, zum Beispiel dormand-prince oder rk4 mit einem kurzen Schritt"},
    {"hysteresis_on_page", error,
     "{--hysteresis-stiffness}: the page does not run a force with memory; take cromer simulate",
     "{--hysteresis-stiffness}: eine Kraft mit Gedächtnis rechnet die Seite nicht; bitte cromer simulate "
     "nehmen"},
    {"hysteresis_with_other", error,
     "{--hysteresis-stiffness} and {option:option} do not go together in one run; leave one of them out",
     "{--hysteresis-stiffness} und {option:option} gehen nicht in einem Lauf; bitte eines davon weglassen"},
    {"compensated_of_adaptive_method", error,
     "{--compensated}: {method} chooses its own steps, whose errors are larger than those of the sums; "
     "leave it out or choose another method, for instance euler-cromer",
     "{--compensated}: {method} wählt seine Schritte selbst, deren Fehler größer sind als die der Summen; "
     "bitte weglassen oder ein anderes Verfahren wählen, zum Beispiel euler-cromer"},
    {"compensated_of_exact_method", error,
     "{--compensated}: {method} adds nothing up, it takes each state from the closed form; leave it out or "
     "choose another method, for instance euler-cromer",
     "{--compensated}: {method} summiert nichts, es nimmt jeden Zustand aus der geschlossenen Lösung; bitte "
     "weglassen oder ein anderes Verfahren wählen, zum Beispiel euler-cromer"},
    {"compensated_with_friction", error,
     "{--compensated}: with {--friction} ({friction} N) steps end where the mass stops; leave one of them "
     "out",
     "{--compensated}: mit {--friction} ({friction} N) enden Schritte, wo die Masse stehen bleibt; bitte "
     "eines davon weglassen"},
    {"compensated_under_drive", error,
     "{--compensated}: under {drive} steps end where the drive jumps or bends; leave one of them out",
     "{--compensated}: unter {drive} enden Schritte, wo der Antrieb springt oder knickt; bitte eines davon "
     "weglassen"},
    {"compensated_with_event", error,
     "{--compensated}: {--event} \"{event}\" is looked for in ordinary sums; leave one of them out",
     "{--compensated}: {--event} „{event}“ wird in gewöhnlichen Summen gesucht; bitte eines davon weglassen"},

    // Events
    {"event_is_wrong", error,
     "{--event} \"{event}\": {what}; expected position=VALUE, velocity=VALUE or turning-point, then any of "
     ":rising, :falling and :stop, for instance \"position=1 cm:falling:stop\"",
     "{--event} „{event}“: {what}; erwartet wird position=WERT, velocity=WERT oder turning-point, danach "
     ":rising, :falling und :stop nach Belieben, zum Beispiel „position=1 cm:falling:stop“"},
    {"no_such_event", clause, "\"{event}\" is no event that can be watched",
     "„{event}“ ist kein Ereignis, das sich beobachten lässt"},
    {"turning_point_has_no_value", clause, "a turning point has no value", "ein Umkehrpunkt hat keinen Wert"},
    {"event_value_missing", clause, "the value is missing", "der Wert fehlt"},
    {"rising_and_falling", clause, "give only one of rising and falling; without them both count",
     "bitte nur eines von rising und falling; ohne sie zählt beides"},
    {"event_word_unknown", clause, "\"{word}\" is not known", "„{word}“ ist unbekannt"},
    {"events_not_listed", worth_knowing, "{run}: only the first {listed} of {events} events are listed",
     "{run}: nur die ersten {listed} von {events} Ereignissen sind aufgeführt"},

    // The drive
    {"drive_option", clause, "{--drive} {drive}", "{--drive} {drive}"},
    {"drive_file_option", clause, "{--drive-file}", "{--drive-file}"},
    {"base_motion_option", clause, "{--base-motion}", "{--base-motion}"},
    {"no_effect_with_drive", error, "{option:option} has no effect with {drive}; leave one of them out",
     "{option:option} bewirkt mit {drive} nichts; bitte eines davon weglassen"},
    {"drive_needs_option", error, "{drive} needs {option:option}", "zu {drive} gehört {option:option}"},
    {"nothing_to_read", error,
     "{--rate}, {--time-column}, {--delimiter}, {--decimal} and {--skip-bad-rows} are for reading a "
     "{--drive-file} or a {--base-motion}, and none is given",
     "{--rate}, {--time-column}, {--delimiter}, {--decimal} und {--skip-bad-rows} gelten für {--drive-file} "
     "oder {--base-motion}, und keines ist angegeben"},
    {"two_recorded_drives", error, "{--drive-file} and {--base-motion} both drive; give one of them",
     "{--drive-file} und {--base-motion} treiben beide an; bitte nur eines davon angeben"},
    {"recording_and_drive", error, "{recording} and {--drive} {drive} both drive; give one of them",
     "{recording} und {--drive} {drive} treiben beide an; bitte nur eines davon angeben"},
    {"no_such_between_samples", error,
     "{--between-samples}: \"{word}\" is none of linear, hold, band-limited",
     "{--between-samples}: „{word}“ ist weder linear noch hold noch band-limited"},
    {"samples_not_read", error, "{recording}: the file's samples were not read",
     "{recording}: die Messwerte der Datei wurden nicht gelesen"},
    {"no_drive", error, "{--drive}: there is no drive \"{drive}\" ({drives})",
     "{--drive}: einen Antrieb „{drive}“ gibt es nicht ({drives})"},
    {"no_drive_but", error, "{--drive}: there is no drive \"{drive}\"; did you mean {near}? ({drives})",
     "{--drive}: einen Antrieb „{drive}“ gibt es nicht; ist {near} gemeint? ({drives})"},
    {"drive_needs_frequency", error,
     "{--drive-amplitude}: {amplitude} N needs a {--drive-frequency} (0 is a constant force)",
     "{--drive-amplitude}: zu {amplitude} N gehört {--drive-frequency} (0 ist eine gleichbleibende Kraft)"},
    {"logarithmic_chirp_not_positive", error,
     "{--drive} logarithmic-chirp: {--drive-frequency} and {--drive-to} must be positive; a sweep from or "
     "to 0 is {--drive} chirp",
     "{--drive} logarithmic-chirp: {--drive-frequency} und {--drive-to} müssen größer als 0 sein; von 0 an "
     "oder bis 0 geht {--drive} chirp"},
    {"unbalance_heavier_than_mass", error,
     "{--unbalance-mass}: it is part of {--mass} ({mass} kg), and cannot be {unbalance} kg",
     "{--unbalance-mass}: die Unwucht ist ein Teil von {--mass} ({mass} kg), und {unbalance} kg gehen nicht"},
    {"drive_too_large", error,
     "{--drive} {drive}: the force at {frequency} rad/s is beyond the largest number",
     "{--drive} {drive}: die Kraft bei {frequency} rad/s übersteigt die größte Zahl"},
    {"chirp_begins_after_end", error,
     "{--drive-start}: the chirp begins at {start} s, and the run ends at {until} s; give {--until}",
     "{--drive-start}: der Chirp beginnt bei {start} s, und der Lauf endet bei {until} s; bitte {--until} "
     "angeben"},
    {"recording_ends_before_run", error,
     "{recording}: the recording ends at {end:.6g} s, before the run does ({until} s); shorten {--until}",
     "{recording}: die Aufnahme endet bei {end:.6g} s, vor dem Lauf ({until} s); bitte {--until} verkürzen"},

    // The file of a recorded drive
    {"drive", clause, "drive", "Antrieb"},
    {"spectrum", clause, "spectrum", "Spektrum"},
    {"quoted", clause, "\"{text}\"", "„{text}“"},
    {"which_column_is_the_force", error,
     "which column is the force? {columns:,}; say it with {option:option}",
     "welche Spalte ist die Kraft? {columns:,}; bitte mit {option:option} sagen"},
    {"which_column_is_the_acceleration", error,
     "which column is the acceleration? {columns:,}; say it with {option:option}",
     "welche Spalte ist die Beschleunigung? {columns:,}; bitte mit {option:option} sagen"},
    {"times_not_even", error,
     "{@line}: the times are not evenly spaced ({t:.6g} s where {even:.6g} s is expected, one sample every "
     "{spacing:.6g} s); a {use} needs even samples: resample it first",
     "{@line}: die Zeiten sind nicht gleichmäßig ({t:.6g} s, wo {even:.6g} s erwartet wird, alle "
     "{spacing:.6g} s ein Messwert); ein {use} braucht gleichmäßige Messwerte: bitte erst neu abtasten"},
    {"no_column_of_numbers", error, "there is no column of numbers", "es gibt keine Spalte mit Zahlen"},
    {"column_holds_no_force", error,
     "column \"{column}\" holds {kind}, not a force (N); choose another with {option:option}",
     "die Spalte „{column}“ enthält {kind}, keine Kraft (N); bitte mit {option:option} eine andere "
     "wählen"},
    {"column_holds_no_acceleration", error,
     "column \"{column}\" holds {kind}, not an acceleration (m/s^2 or g); choose another with "
     "{option:option}",
     "die Spalte „{column}“ enthält {kind}, keine Beschleunigung (m/s^2 oder g); bitte mit {option:option} "
     "eine andere wählen"},
    {"column_has_no_sample", error,
     "column \"{column}\" has no sample, and a {use} needs at least two samples",
     "die Spalte „{column}“ hat keinen Messwert, und ein {use} braucht mindestens zwei"},
    {"column_has_one_sample", error,
     "column \"{column}\" has one sample, and a {use} needs at least two samples",
     "die Spalte „{column}“ hat einen Messwert, und ein {use} braucht mindestens zwei"},
    {"samples_have_a_gap", error,
     "the samples have a gap of {length:.6g} s after t = {t:.6g} s; a {use} needs even samples without "
     "gaps: fill in what is missing, or cut or resample the recording",
     "die Messwerte haben nach t = {t:.6g} s eine Lücke von {length:.6g} s; ein {use} braucht gleichmäßige "
     "ohne Lücken: bitte das Fehlende ergänzen, die Aufnahme kürzen oder neu abtasten"},
    {"samples_have_gaps", error,
     "the samples have {gaps} gaps, the first of {length:.6g} s after t = {t:.6g} s; a {use} needs even "
     "samples without gaps: fill in what is missing, or cut or resample the recording",
     "die Messwerte haben {gaps} Lücken, die erste von {length:.6g} s nach t = {t:.6g} s; ein {use} braucht "
     "gleichmäßige ohne Lücken: bitte das Fehlende ergänzen, die Aufnahme kürzen oder neu abtasten"},
    {"over_is_no_position", error,
     "{--over}: a run is laid over positions or angles, and column \"{column}\" holds {kind}; choose one by "
     "{--over-column}",
     "{--over}: ein Lauf wird über Orte oder Winkel gelegt, und die Spalte „{column}“ enthält {kind}; bitte "
     "mit {--over-column} wählen"},
    {"over_has_no_samples", error,
     "{--over-from}: column \"{column}\" has no sample from {from:.6g} to {to:.6g} s, where the runs are",
     "{--over-from}: die Spalte „{column}“ hat von {from:.6g} bis {to:.6g} s, wo die Läufe sind, keinen "
     "Messwert"},
    {"run_beside_recording", detail,
     "{run}: the recording lies {rms:n} (rms) from it, over {samples:sample|samples} of {column}",
     "{run}: Die Aufnahme liegt {rms:n} (Effektivwert) daneben, über {samples:Messwert|Messwerte} von "
     "{column}"},
    {"drive_is_of_run", worth_knowing, "{file}: the drive is run {run} of {runs}",
     "{file}: der Antrieb ist Lauf {run} von {runs}"},
    {"spectrum_is_of_run", worth_knowing,
     "{file}: the spectrum is that of run {run} of {runs}; {--run} chooses another",
     "{file}: das Spektrum ist das von Lauf {run} der {runs}; {--run} wählt einen anderen"},
    {"recording_starts_elsewhere", worth_knowing,
     "{file}: its first sample, at {t:.6g} s, acts at the run's start, t = 0",
     "{file}: ihr erster Messwert, bei {t:.6g} s, wirkt am Anfang des Laufs, t = 0"},

    // What has no effect or is not exact
    {"drive_frequency_alone", wrong_if_ignored,
     "{--drive-frequency} has no effect without a {--drive-amplitude}",
     "{--drive-frequency} bewirkt ohne {--drive-amplitude} nichts"},
    {"no_effect_without", wrong_if_ignored, "{option:option} has no effect without {needed:option}",
     "{option:option} bewirkt ohne {needed:option} nichts"},
    {"no_effect_on_method", worth_knowing, "{option:option} has no effect on {method}",
     "{option:option} bewirkt bei {method} nichts"},
    {"drive_begins_after_end", wrong_if_ignored,
     "{--drive-start}: the drive begins at {start} s, and the run ends at {until} s",
     "{--drive-start}: der Antrieb beginnt bei {start} s, und der Lauf endet bei {until} s"},
    {"last_step_is_shorter", worth_knowing,
     "{until} s are not a whole number of steps of {step} s: the last step is {last:.6g} s",
     "{until} s sind keine ganze Zahl von Schritten von {step} s: der letzte Schritt ist {last:.6g} s"},
    {"states_too_far_apart", worth_knowing,
     "a state every {kept:.4g} s is less than two in a period of {period:.4g} s: drawn, they show a slower "
     "swing that is not there; a shorter {--step} or a smaller {--every} shows the real one",
     "ein Zustand alle {kept:.4g} s ist weniger als zwei je Periode von {period:.4g} s: gezeichnet zeigen "
     "sie eine langsamere Schwingung, die es nicht gibt; ein kürzerer {--step} oder ein kleineres {--every} "
     "zeigt die wirkliche"},
    {"unstable_at_any_step", wrong_if_ignored,
     "{method} is unstable for this law whatever the step: the motion will grow",
     "{method} ist bei diesem Gesetz mit jedem Schritt instabil: die Bewegung wird wachsen"},
    {"step_beyond_stability", wrong_if_ignored,
     "{--step}: {step} s is beyond the stability limit of {method} for this law, {limit:.6g} s: the motion "
     "will grow",
     "{--step}: {step} s liegt über der Stabilitätsgrenze von {method} bei diesem Gesetz, {limit:.6g} s: "
     "die Bewegung wird wachsen"},
    {"motions_unstable_at_any_step", wrong_if_ignored,
     "{method} is unstable for {motions} under this law whatever the step: the motion may grow",
     "{method} ist für {motions} bei diesem Gesetz mit jedem Schritt instabil: die Bewegung kann wachsen"},
    {"step_beyond_stability_of_motions", wrong_if_ignored,
     "{--step}: {step} s is beyond the stability limit of {method} for {motions} under this law, "
     "{limit:.6g} s: the motion may grow",
     "{--step}: {step} s liegt über der Stabilitätsgrenze von {method} für {motions} bei diesem Gesetz, "
     "{limit:.6g} s: die Bewegung kann wachsen"},
    {"small_motions", clause, "small motions", "kleine Bewegungen"},
    {"motions_as_at_start", clause, "motions as wide as at the start", "so weite Bewegungen wie am Anfang"},

    // How a run ended
    {"run_interrupted", error, "interrupted after t = {t:.6g} s (step {step})",
     "abgebrochen nach t = {t:.6g} s (Schritt {step})"},
    {"run_at_step_limit", error, "the step limit was reached at t = {t:.6g} s (step {step})",
     "die Höchstzahl der Schritte war bei t = {t:.6g} s erreicht (Schritt {step})"},
    {"run_step_too_small", error,
     "the step became too small to go on at t = {t:.6g} s (step {step}): the motion runs away there, or "
     "{--tolerance} asks for too much",
     "der Schritt wurde bei t = {t:.6g} s zu klein (Schritt {step}): die Bewegung läuft dort davon, oder "
     "{--tolerance} verlangt zu viel"},
    {"run_without_convergence", error,
     "no convergence in Newton's iteration after t = {t:.6g} s (step {step}); take a shorter {--step}",
     "die Newton-Iteration kommt nach t = {t:.6g} s (Schritt {step}) nicht ans Ziel; bitte {--step} "
     "verkürzen"},
    {"run_diverged", error, "diverged: not finite after t = {t:.6g} s (step {step})",
     "divergiert: nicht mehr endlich nach t = {t:.6g} s (Schritt {step})"},
    {"no_harmonic_drive", error, "no steady oscillation: there is no harmonic drive",
     "keine stationäre Schwingung: es gibt keinen harmonischen Antrieb"},
    {"too_few_states_for_steady", error, "no steady oscillation: the run kept fewer than eight states",
     "keine stationäre Schwingung: der Lauf behielt weniger als acht Zustände"},
    {"run_shorter_than_two_periods", error,
     "no steady oscillation: the run is shorter than two periods of the drive",
     "keine stationäre Schwingung: der Lauf ist kürzer als zwei Perioden des Antriebs"},
    {"too_few_states_a_period", error,
     "no steady oscillation: the run kept fewer than four states a period of the drive",
     "keine stationäre Schwingung: der Lauf behielt weniger als vier Zustände je Periode des Antriebs"},

    // The methods, by their names
    {"forward-euler", clause, "forward Euler", "Euler vorwärts"},
    {"euler-cromer", clause, "Euler-Cromer", "Euler-Cromer"},
    {"implicit-euler", clause, "implicit Euler", "Euler rückwärts"},
    {"verlet", clause, "Verlet", "Verlet"},
    {"newmark", clause, "Newmark", "Newmark"},
    {"implicit-midpoint", clause, "implicit midpoint", "implizite Mittelpunktregel"},
    {"generalized-alpha", clause, "generalized-α", "Generalized-α"},
    {"heun", clause, "Heun", "Heun"},
    {"rk4", clause, "RK4", "RK4"},
    {"yoshida4", clause, "Yoshida 4", "Yoshida 4"},
    {"gauss-legendre4", clause, "Gauss-Legendre 4", "Gauß-Legendre 4"},
    {"dormand-prince", clause, "Dormand-Prince", "Dormand-Prince"},
    {"exact", clause, "exact", "exakt"},

    // What a method makes of the law
    {"of_run", clause, "{run} {what}", "{run} {what}"},
    {"both", clause, "{first}; {second}", "{first}; {second}"},
    {"damping_and_frequency", clause, "{damping} and {frequency}", "{damping} und {frequency}"},
    {"adds_no_damping", clause, "adds no damping", "fügt keine Dämpfung hinzu"},
    {"adds_growth", clause, "adds growth of {rate:.4g} 1/s", "fügt ein Anwachsen mit {rate:.4g} 1/s hinzu"},
    {"adds_damping", clause, "adds damping of {rate:.4g} 1/s", "fügt eine Dämpfung von {rate:.4g} 1/s hinzu"},
    {"keeps_damping", clause, "keeps your damping of {rate:.4g} 1/s",
     "behält die Dämpfung von {rate:.4g} 1/s"},
    {"keeps_damping_nearly", clause, "nearly keeps your damping of {rate:.4g} 1/s ({simulated:.4g})",
     "behält beinahe die Dämpfung von {rate:.4g} 1/s ({simulated:.4g})"},
    {"turns_damping_into", clause, "turns your damping of {rate:.4g} 1/s into {simulated:.4g} 1/s",
     "macht aus der Dämpfung von {rate:.4g} 1/s eine von {simulated:.4g} 1/s"},
    {"turns_damping_into_growth", clause,
     "turns your damping of {rate:.4g} 1/s into growth of {simulated:.4g} 1/s",
     "macht aus der Dämpfung von {rate:.4g} 1/s ein Anwachsen mit {simulated:.4g} 1/s"},
    {"keeps_growth", clause, "grows at the {rate:.4g} 1/s of your law",
     "wächst mit den {rate:.4g} 1/s des Gesetzes"},
    {"keeps_growth_nearly", clause, "grows at {simulated:.4g} 1/s, nearly the {rate:.4g} 1/s of your law",
     "wächst mit {simulated:.4g} 1/s, beinahe den {rate:.4g} 1/s des Gesetzes"},
    {"turns_growth_into", clause, "turns your law's growth of {rate:.4g} 1/s into {simulated:.4g} 1/s",
     "macht aus dem Anwachsen des Gesetzes mit {rate:.4g} 1/s eines mit {simulated:.4g} 1/s"},
    {"turns_growth_into_damping", clause,
     "turns your law's growth of {rate:.4g} 1/s into damping of {simulated:.4g} 1/s",
     "macht aus dem Anwachsen des Gesetzes mit {rate:.4g} 1/s eine Dämpfung von {simulated:.4g} 1/s"},
    {"keeps_frequency", clause, "keeps your {frequency:.4g} rad/s", "behält die {frequency:.4g} rad/s"},
    {"swings_too_fast", clause, "swings at {frequency:.6g} rad/s, {percent:.2g} % too fast",
     "schwingt mit {frequency:.6g} rad/s, {percent:.2g} % zu schnell"},
    {"swings_too_slow", clause, "swings at {frequency:.6g} rad/s, {percent:.2g} % too slow",
     "schwingt mit {frequency:.6g} rad/s, {percent:.2g} % zu langsam"},
    {"keeps_damping_and_frequency", clause,
     "keeps your damping of {rate:.4g} 1/s and your {frequency:.4g} rad/s",
     "behält die Dämpfung von {rate:.4g} 1/s und die {frequency:.4g} rad/s"},
    {"swings_unlike_the_law", clause, "swings at {frequency:.4g} rad/s, where your law creeps back",
     "schwingt mit {frequency:.4g} rad/s, wo das Gesetz zurückkriecht"},
    {"grows_hopping", clause, "grows and changes sign at each step",
     "wächst und wechselt bei jedem Schritt das Vorzeichen"},
    {"grows_without_swinging", clause, "grows without swinging", "wächst, ohne zu schwingen"},
    {"dies_down_hopping", clause, "dies down and changes sign at each step, which your law does not do",
     "klingt ab und wechselt bei jedem Schritt das Vorzeichen, was das Gesetz nicht tut"},
    {"creeps_unlike_the_law", clause, "creeps back without swinging, where your law swings",
     "kriecht zurück, ohne zu schwingen, wo das Gesetz schwingt"},
    {"creeps_as_the_law", clause, "creeps back without swinging, as your law does",
     "kriecht zurück, ohne zu schwingen, wie das Gesetz auch"},
    {"grows_at_shorter_steps", clause, "{what}; at some shorter steps it grows",
     "{what}; bei manchen kürzeren Schritten wächst es"},
    {"settles", clause, "settles at {amplitude:.6g} m, {lag:.4g} rad behind the drive{law}",
     "kommt auf {amplitude:.6g} m, {lag:.4g} rad hinter dem Antrieb{law}"},
    {"settles_from_base", clause,
     "settles at {amplitude:.6g} m from the base, {lag:.4g} rad behind the drive{law}",
     "kommt auf {amplitude:.6g} m vom Fußpunkt aus, {lag:.4g} rad hinter dem Antrieb{law}"},
    {"where_the_law_settles", clause, " (your law: {amplitude:.6g} m, {lag:.4g} rad)",
     " (das Gesetz: {amplitude:.6g} m, {lag:.4g} rad)"},
    {"conserves_modified_energy", clause,
     "{run} conserves a modified energy, m/2 (v^2 + w^2 x^2 - h w^2 x v) = {energy:.6g} J, to {drift:.2g} "
     "of itself over {states} kept states{sums}; the energy swings by {swing:.3g} % about its mean",
     "{run} erhält eine abgewandelte Energie, m/2 (v^2 + w^2 x^2 - h w^2 x v) = {energy:.6g} J, auf "
     "{drift:.2g} ihrer selbst über {states} behaltene Zustände{sums}; die Energie schwankt um {swing:.3g} "
     "% um ihr Mittel"},
    {"of_compensated_sums", clause, " (compensated sums)", " (kompensierte Summen)"},

    // Where the energy went
    {"swung_evenly", clause, "swung at {frequency:.6g} rad/s on average, {amplitude:.4g} m to each side",
     "schwang im Mittel mit {frequency:.6g} rad/s, {amplitude:.4g} m nach jeder Seite"},
    {"swung_less_and_less", clause,
     "swung at {frequency:.6g} rad/s on average, from {first:.4g} m between its first two turning points "
     "down to {last:.4g} m",
     "schwang im Mittel mit {frequency:.6g} rad/s, von {first:.4g} m zwischen den ersten zwei Umkehrpunkten "
     "herunter auf {last:.4g} m"},
    {"swung_more_and_more", clause,
     "swung at {frequency:.6g} rad/s on average, from {first:.4g} m between its first two turning points up "
     "to {last:.4g} m",
     "schwang im Mittel mit {frequency:.6g} rad/s, von {first:.4g} m zwischen den ersten zwei Umkehrpunkten "
     "hinauf auf {last:.4g} m"},
    {"kept_its_energy", clause, "kept its {energy:.4g} J", "behielt seine {energy:.4g} J"},
    {"energy_comes_back", clause,
     "had {energy:.4g} J and at the end {percent:.2g} % less, which comes and goes",
     "hatte {energy:.4g} J und am Ende {percent:.2g} % weniger, was kommt und geht"},
    {"energy_goes_again", clause,
     "had {energy:.4g} J and at the end {percent:.2g} % more, which comes and goes",
     "hatte {energy:.4g} J und am Ende {percent:.2g} % mehr, was kommt und geht"},
    {"method_alone_took", clause, "had {energy:.4g} J, of which the method itself took {percent:.2g} %",
     "hatte {energy:.4g} J, von denen das Verfahren selbst {percent:.2g} % nahm"},
    {"method_alone_added", clause, "had {energy:.4g} J, to which the method itself added {percent:.2g} %",
     "hatte {energy:.4g} J, zu denen das Verfahren selbst {percent:.2g} % hinzufügte"},
    {"energy_went_to", clause, "had {energy:.4g} J{givers}, of which {takers:,}, the method itself {method}",
     "hatte {energy:.4g} J{givers}; davon nahm {takers:,}, das Verfahren selbst {method}"},
    {"energy_turned_over", clause,
     "began with {energy:.4g} J{givers}; measured by that, {takers:,}, the method itself {method}",
     "begann mit {energy:.4g} J{givers}; gemessen daran nahm {takers:,}, das Verfahren selbst {method}"},
    {"with_what_gave", clause, " with what the {givers} gave", " mit dem Beitrag von {givers}"},
    {"first_taker", clause, "{what} took {percent:.3g} %", "{what} {percent:.3g} %"},
    {"next_taker", clause, "{what} {percent:.3g} %", "{what} {percent:.3g} %"},
    {"damping", clause, "damping", "Dämpfung"},
    {"term", clause, "{name}", "{name}"},
    {"nothing", clause, "nothing", "nichts"},
    {"took_percent", clause, "{percent:.3g} %", "{percent:.3g} %"},
    {"added_percent", clause, "added {percent:.3g} %", "fügte {percent:.3g} % hinzu"},
    {"took_about", clause, "about {percent:.1g} %", "etwa {percent:.1g} %"},
    {"added_about", clause, "added about {percent:.1g} %", "fügte etwa {percent:.1g} % hinzu"},
    {"and_comes_and_goes", clause, "{lasting}, beside {percent:.2g} % that come and go",
     "{lasting}, neben {percent:.2g} %, die kommen und gehen"},
};

}  // namespace

const std::span<const Entry> words_of_simulate = entries;

}  // namespace cromer::core
