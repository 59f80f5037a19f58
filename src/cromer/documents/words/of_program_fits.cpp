#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

// What only the program's fits say: of recorded forces, of times that slip, of pendulums, and of a motion
// that does not lie along one column.
constexpr Entry entries[] = {
    {"sensor_turns_round", wrong_if_ignored,
     "\"{axis}\" keeps turning at {mean:.2g} rad/s: the sensor itself turns round, and its other two axes "
     "see in "
     "turn what does not turn with it; what they record is then no swing of its own",
     "„{axis}“ dreht sich mit {mean:.2g} rad/s immer weiter: der Sensor selbst dreht sich, und seine beiden "
     "anderen Achsen sehen abwechselnd, was sich nicht mitdreht; was sie aufzeichnen, ist dann keine eigene "
     "Schwingung"},
    {"swings_alongside", worth_knowing,
     "\"{other}\" swings at the same frequency, and is neither \"{column}\" again nor its rate of change: "
     "the motion may not lie along \"{column}\" alone, and its decay not be that of one free swing",
     "„{other}“ schwingt mit derselben Frequenz und ist weder „{column}“ noch einmal noch deren "
     "Änderungsrate: die Bewegung verläuft vielleicht nicht nur entlang „{column}“, und ihr Abklingen ist "
     "dann nicht das einer freien Schwingung"},
    {"arc_as_pendulum", worth_knowing,
     "a simple pendulum with this frequency of small swings is {length:n} long where g is 9.80665 m/s², "
     "which agrees with the arc's radius {radius:n}",
     "ein mathematisches Pendel mit dieser Frequenz kleiner Schwingungen ist {length:n} lang, wo g 9,80665 "
     "m/s² ist, was zum Radius {radius:n} des Bogens passt"},
    {"arc_beside_pendulum", worth_knowing,
     "a simple pendulum with this frequency of small swings is {length:n} long where g is 9.80665 m/s², "
     "{off:.2g} % {which} than the radius {radius:n} of the arc: perhaps the bob's centre of mass is not at "
     "the "
     "tracked point, the film's scale is wrong, or the arc is too short to give its radius well",
     "ein mathematisches Pendel mit dieser Frequenz kleiner Schwingungen ist {length:n} lang, wo g 9,80665 "
     "m/s² ist, {off:.2g} % "
     "{which} als der Radius {radius:n} des Bogens: vielleicht liegt der Schwerpunkt nicht am verfolgten "
     "Punkt, stimmt der Maßstab des Films nicht, oder ist der Bogen zu kurz für seinen Radius"},
    {"cubic_of_a_pendulum", worth_knowing,
     "the cubic of a simple pendulum with this frequency of small swings, −ω0²/6 = −{size:.4g} 1/(rad² s²), "
     "lies within the 95 % interval of the fitted one: it may be a pendulum",
     "der kubische Beiwert eines mathematischen Pendels mit dieser Frequenz kleiner Schwingungen, −ω0²/6 = "
     "−{size:.4g} 1/(rad² s²), liegt im 95-%-Intervall des gefundenen: es kann ein Pendel sein"},
    {"longer", clause, "longer", "länger"},
    {"shorter", clause, "shorter", "kürzer"},
    // A recorded force
    {"no_spring_without_force", error,
     "{--no-spring} needs {--force-column}: a body without a spring does not swing, and only a recorded "
     "force shows its law",
     "{--no-spring} braucht {--force-column}: ein Körper ohne Feder schwingt nicht, und nur eine "
     "aufgenommene Kraft zeigt sein Gesetz"},
    {"two_drives", error,
     "{--force-column} and {--drive-frequency} exclude each other: the drive is recorded, or it is harmonic",
     "{--force-column} und {--drive-frequency} schließen einander aus: der Antrieb ist aufgenommen oder "
     "harmonisch"},
    {"between_samples_without_force", error,
     "{--between-samples} needs {--force-column}: it says what a recorded force did between its samples",
     "{--between-samples} braucht {--force-column}: es sagt, was eine aufgenommene Kraft zwischen ihren "
     "Messwerten tat"},
    {"between_samples_unknown", error,
     "{--between-samples}: \"{typed}\" is none of linear, hold, band-limited and auto",
     "{--between-samples}: „{typed}“ ist weder linear noch hold, band-limited oder auto"},
    {"hold_out_without_force", error,
     "{--hold-out} needs {--force-column}: only a motion whose force is known can be predicted",
     "{--hold-out} braucht {--force-column}: nur eine Bewegung, deren Kraft bekannt ist, lässt sich "
     "vorhersagen"},
    {"hold_out_outside", error, "{--hold-out} {share}: it must lie above 0 and at most at 90 %",
     "{--hold-out} {share}: das muss über 0 und höchstens bei 90 % liegen"},
    {"of_force_column", error, "{--force-column}: {what}", "{--force-column}: {what}"},
    {"of_the_force", clause, "force: {what}", "Kraft: {what}"},
    {"force_is_the_motion", error,
     "{--force-column}: \"{column}\" is the column that is fitted; say which holds the motion with "
     "{--column}",
     "{--force-column}: „{column}“ ist die Spalte, die angepasst wird; bitte mit {--column} sagen, welche "
     "die Bewegung enthält"},
    {"force_is_too_short", error, "force column \"{column}\" has fewer than two values",
     "die Kraftspalte „{column}“ hat weniger als zwei Werte"},
    {"force_never_changes", error,
     "force column \"{column}\" is {value:n} throughout: a force that never changes drives nothing; leave "
     "out {--force-column} to fit the free motion",
     "die Kraftspalte „{column}“ ist durchweg {value:n}: eine Kraft, die sich nie ändert, treibt nichts an; "
     "bitte {--force-column} weglassen und die freie Bewegung anpassen"},
    {"force_has_a_gap", error,
     "force column \"{column}\" has a gap, {length:.6g} s long at {t:.6g} s: what the force did there is "
     "not known; choose one side of it with {|{--from} and {--to}|the handles}, or fill it in",
     "die Kraftspalte „{column}“ hat eine Lücke, {length:.6g} s lang bei {t:.6g} s: was die Kraft da tat, "
     "ist nicht bekannt; bitte mit {|{--from} und {--to}|den Griffen} eine Seite wählen oder sie füllen"},
    {"force_has_gaps", error,
     "force column \"{column}\" has {gaps} gaps, the first {length:.6g} s long at {t:.6g} s: what the force "
     "did there is not known; choose a part without gaps with {|{--from} and {--to}|the handles}, or fill "
     "them in",
     "die Kraftspalte „{column}“ hat {gaps} Lücken, die erste {length:.6g} s lang bei {t:.6g} s: was die "
     "Kraft da tat, ist nicht bekannt; bitte mit {|{--from} und {--to}|den Griffen} einen Teil ohne Lücken "
     "wählen oder sie füllen"},
    {"force_is_uneven", error,
     "{@line}: the times are not evenly spaced ({t:.6g} s where {expected:.6g} s is expected, one sample "
     "every {spacing:.6g} s); a recorded force needs even samples: resample the recording first",
     "{@line}: die Zeiten haben nicht gleiche Abstände ({t:.6g} s, wo {expected:.6g} s erwartet wird, ein "
     "Messwert je {spacing:.6g} s); eine aufgenommene Kraft braucht gleichmäßige Messwerte: bitte die "
     "Aufnahme erst auf solche umrechnen"},
    {"force_ends", error,
     "force column \"{force}\" goes from {from:.6g} to {to:.6g} s, and column \"{column}\" has a value at "
     "{t:.6g} s; choose the part that both have with {|{--from} and {--to}|the handles}",
     "die Kraftspalte „{force}“ geht von {from:.6g} bis {to:.6g} s, und die Spalte „{column}“ hat einen "
     "Wert bei {t:.6g} s; bitte mit {|{--from} und {--to}|den Griffen} den Teil wählen, den beide haben"},
    {"force_at_other_times", error,
     "force column \"{force}\" has other times than column \"{column}\": {t:.9g} s lies between two of its "
     "samples; resample one of them first",
     "die Kraftspalte „{force}“ hat andere Zeiten als die Spalte „{column}“: {t:.9g} s liegt zwischen zwei "
     "ihrer Messwerte; bitte erst eine von beiden umrechnen"},
    {"force_taken_as_exact", worth_knowing,
     "the recorded force is taken as exact: what noise of its sensor does to the motion is not in the "
     "uncertainties, and near the resonance that is much",
     "die aufgezeichnete Kraft gilt als genau: was das Rauschen ihres Sensors mit der Bewegung macht, "
     "steckt nicht in den Unsicherheiten, und nahe der Resonanz ist es viel"},
    {"force_is_noisy", worth_knowing,
     "what the law leaves looks like noise of {noise:.2g}{unit: } in each sample of the recorded force; the "
     "uncertainties include it",
     "was das Gesetz übrig lässt, sieht aus wie ein Rauschen von {noise:.2g}{unit: } in jedem Messwert der "
     "Kraft; die Unsicherheiten enthalten es"},
    {"force_may_be_noisy", detail,
     "noise of the recorded force may hide in what the law leaves; the uncertainties allow for it",
     "in dem, was das Gesetz übrig lässt, kann sich ein Rauschen der aufgezeichneten Kraft verbergen; die "
     "Unsicherheiten berücksichtigen das"},
    {"force_between_samples_open", worth_knowing,
     "what the force did between its samples is not certain: read as {reading} the rms residual is "
     "{rms:.4g}, read as {other_reading} it is {other_rms:.4g}, too close to decide; the uncertainties are "
     "widened for it. If it is known, give {--between-samples}",
     "was die Kraft zwischen ihren Messwerten tat, ist offen: als {reading} gelesen ist der Effektivwert "
     "der Reste {rms:.4g}, als {other_reading} gelesen {other_rms:.4g}: zu nah beieinander für eine "
     "Entscheidung; die Unsicherheiten sind dafür geweitet. Ist es bekannt, bitte {--between-samples} "
     "angeben"},
    {"force_between_samples_open_and_matters", worth_knowing,
     "what the force did between its samples is not certain: read as {reading} the rms residual is "
     "{rms:.4g}, read as {other_reading} it is {other_rms:.4g}, too close to decide; the other reading "
     "would make the {differences:,}; the uncertainties are widened for it. If it is known, give "
     "{--between-samples}",
     "was die Kraft zwischen ihren Messwerten tat, ist offen: als {reading} gelesen ist der Effektivwert "
     "der Reste {rms:.4g}, als {other_reading} gelesen {other_rms:.4g}: zu nah beieinander für eine "
     "Entscheidung; die andere Lesart gäbe {differences:,}; die Unsicherheiten sind dafür geweitet. Ist es "
     "bekannt, bitte {--between-samples} angeben"},
    {"parameter_elsewhere", clause,
     "{parameter} {value:.6g} ({errors:.1f} of the stated standard errors away)",
     "{parameter} {value:.6g} ({errors:.1f} Standardfehler entfernt)"},

    // Times that slip
    {"times_slip", wrong_if_ignored,
     "times that slip by {slip:.2g} s at {t:.4g} s explain the recording as well as this law does, or "
     "better: the recorder may have {how} there; fit the parts before and after with {|{--from} and "
     "{--to}|the handles}",
     "Zeiten, die bei {t:.4g} s um {slip:.2g} s springen, erklären die Aufnahme ebenso gut wie dieses Gesetz "
     "oder besser: dort können Messwerte {how} sein; bitte die Teile davor und danach mit {|{--from} und "
     "{--to}|den Griffen} anpassen"},
    {"slip_taken_out", worth_knowing,
     "the times slip by {slip:.2g} s at {t:.4g} s, as if the recorder had {how} there (a knock looks alike): "
     "later times are {shift} by as much, and the uncertainties include that of this slip. With the times as "
     "recorded the fit gives {law} and {frequency:.5g} Hz for small swings",
     "die Zeiten springen bei {t:.4g} s um {slip:.2g} s, als wären dort Messwerte {how} (ein Stoß sieht "
     "ebenso aus): spätere Zeiten sind um so viel {shift}, und die Unsicherheiten enthalten die dieses "
     "Sprungs. Mit den Zeiten wie aufgezeichnet ergibt die Anpassung {law} und {frequency:.5g} Hz bei "
     "kleinen Schwingungen"},
    {"samples_lost", clause, "lost samples", "verloren"},
    {"samples_repeated", clause, "repeated samples", "wiederholt"},
    {"shifted_later", clause, "put later", "nach hinten verschoben"},
    {"shifted_earlier", clause, "put earlier", "nach vorn verschoben"},
};

}  // namespace

const std::span<const Entry> words_of_program_fits = entries;

}  // namespace cromer::core
