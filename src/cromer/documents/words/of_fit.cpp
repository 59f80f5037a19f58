#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // What follows from a law, by its names.
    {"stiffness", clause, "spring constant", "Federkonstante"},
    {"drag_constant", clause, "drag constant", "Konstante des Luftwiderstands"},
    {"friction_force", clause, "friction", "trockene Reibung"},
    {"cubic_stiffness", clause, "cubic stiffness", "kubische Steifigkeit"},
    {"quadratic_stiffness", clause, "quadratic stiffness", "quadratische Steifigkeit"},
    {"odd_quadratic_stiffness", clause, "odd quadratic stiffness", "Steifigkeit von x|x|"},
    {"quintic_stiffness", clause, "quintic stiffness", "Steifigkeit fünften Grades"},
    {"van_der_pol_constant", clause, "van der Pol constant", "Van-der-Pol-Dämpfung"},
    {"hysteresis_force_stiffness", clause, "hysteresis stiffness", "hysteretische Federkonstante"},
    {"frequency", clause, "frequency", "Frequenz"},
    {"period", clause, "period", "Periode"},
    {"damping_ratio", clause, "damping ratio", "Dämpfungsgrad"},
    {"quality_factor", clause, "quality factor", "Güte"},
    {"logarithmic_decrement", clause, "logarithmic decrement", "logarithmisches Dekrement"},
    {"limit_cycle_amplitude", clause, "limit cycle amplitude", "Amplitude des Grenzzyklus"},
    {"pendulum_length", clause, "pendulum length at 9.80665 m/s²", "Pendellänge bei 9,80665 m/s²"},
    {"drive_force", clause, "drive force", "Kraft des Antriebs"},
    {"drag_coefficient", clause, "drag coefficient", "Widerstandsbeiwert"},
    {"mass", clause, "mass", "Masse"},
    {"spring_mass", clause, "mass of the spring", "Masse der Feder"},

    // What the options ask of each other
    {"spring_mass_alone", error, "{--spring-mass} needs {--mass} as well",
     "{--spring-mass} braucht auch {--mass}"},
    {"monte_carlo_without_mass", error,
     "{--monte-carlo} needs {--mass}: it checks the uncertainty of the spring constant",
     "{--monte-carlo} braucht {--mass}: damit wird die Unsicherheit der Federkonstante geprüft"},
    {"temperature_without_disc", error,
     "{--temperature} needs {--disc-diameter}: the air's temperature matters only to the Reynolds number and "
     "the drag coefficient of a disc",
     "zu {--temperature} gehört {--disc-diameter}: die Lufttemperatur zählt nur für die Reynolds-Zahl und "
     "den Widerstandsbeiwert einer Scheibe"},
    {"seed_without_monte_carlo", error, "{--seed} needs {--monte-carlo}: it is the seed of its trials",
     "{--seed} braucht {--monte-carlo}: damit beginnen dessen Versuche"},
    {"pendulum_without_spring", error,
     "{--no-spring} and {--law} pendulum exclude each other: a pendulum's weight is its spring",
     "{--no-spring} und {--law} pendulum schließen einander aus: beim Pendel ist das Gewicht die Feder"},
    {"from_behind_to", error, "{--from} {from} must lie before {--to} {to}",
     "{--from} {from} muss vor {--to} {to} liegen"},
    {"not_of_a_driven_motion", error,
     "{option:option} is not for a driven motion, whose amplitude the drive keeps up; fit a free decay, for "
     "instance a part of the record after the drive has stopped, with {|{--from} and {--to}|the handles}",
     "{option:option} gibt es nicht zu einer angetriebenen Bewegung, deren Amplitude der Antrieb erhält; "
     "bitte ein freies Abklingen anpassen, zum Beispiel den Teil nach dem Ende des Antriebs, mit {|{--from} "
     "und {--to}|den Griffen}"},
    {"drive_frequency_or_auto", error, "{--drive-frequency}: {what}; or auto, to find it in the record",
     "{--drive-frequency}: {what}; oder auto, dann wird sie in der Aufnahme gesucht"},
    {"drive_frequency_not_positive", error, "{--drive-frequency} {frequency}: it must be positive",
     "{--drive-frequency} {frequency}: das muss größer als 0 sein"},
    {"drive_not_seen", error,
     "{--drive-frequency}: {asked:.6g} Hz cannot be seen in {rate:.4g} samples per second, only frequencies "
     "up to {highest:.4g} Hz",
     "{--drive-frequency}: {asked:.6g} Hz sind in {rate:.4g} Messwerten je Sekunde nicht zu sehen, nur "
     "Frequenzen bis {highest:.4g} Hz"},
    {"pendulum_without_angle", error,
     "{--law} {law}: a pendulum's law needs an angle, but column \"{column}\" holds {kind}; use cubic, or "
     "choose {|an angle with {--column}|a column that holds an angle}",
     "{--law} {law}: das Pendelgesetz braucht einen Winkel, doch die Spalte „{column}“ enthält {kind}; bitte "
     "cubic nehmen oder {|mit {--column} einen|eine Spalte mit einem} Winkel wählen"},

    // Which samples
    {"nothing_left_from", error,
     "{--from} {from}: no sample is left, the recording goes from {first:.6g} to {last:.6g} s",
     "{--from} {from}: kein Messwert bleibt, die Aufnahme geht von {first:.6g} bis {last:.6g} s"},
    {"nothing_left_to", error,
     "{--to} {to}: no sample is left, the recording goes from {first:.6g} to {last:.6g} s",
     "{--to} {to}: kein Messwert bleibt, die Aufnahme geht von {first:.6g} bis {last:.6g} s"},
    {"nothing_left_between", error,
     "{--from} {from} {--to} {to}: no sample is left, the recording goes from {first:.6g} to {last:.6g} s",
     "{--from} {from} {--to} {to}: kein Messwert bleibt, die Aufnahme geht von {first:.6g} bis {last:.6g} s"},
    {"column_has_no_values", error, "column \"{column}\" has no values",
     "die Spalte „{column}“ hat keine Werte"},
    {"values_too_small", error,
     "column \"{column}\": values like {value:.3g} are too small to be squared; give them in another unit",
     "Spalte „{column}“: Werte wie {value:.3g} lassen sich nicht quadrieren; bitte in einer anderen Einheit "
     "angeben"},
    {"values_too_large", error,
     "column \"{column}\": values like {value:.3g} are too large to be squared; give them in another unit",
     "Spalte „{column}“: Werte wie {value:.3g} lassen sich nicht quadrieren; bitte in einer anderen Einheit "
     "angeben"},
    {"time_jumps", error,
     "{@line}: the time jumps from {from:.9g} to {to:.9g} s; choose one side of it with {|{--from} and "
     "{--to}|the handles}",
     "{@line}: die Zeit springt von {from:.9g} auf {to:.9g} s; bitte mit {|{--from} und {--to}|den Griffen} "
     "eine Seite wählen"},
    {"all_set_aside", error, "all values of column \"{column}\" are set aside",
     "alle Werte der Spalte „{column}“ sind beiseitegelegt"},
    {"free_part_taken", worth_knowing,
     "{reason}: what follows from {from:.4g} s, {kept} of {samples} samples, is taken for a free motion; "
     "{|{--from} and {--to}|the handles} choose another part",
     "{reason}: was ab {from:.4g} s folgt, {kept} von {samples} Messwerten, gilt als freie Bewegung; mit "
     "{|{--from} und {--to}|den Griffen} lässt sich ein anderer Teil wählen"},
    {"free_middle_taken", worth_knowing,
     "what comes before {from:.4g} s and after {to:.4g} s does not belong to the swing between, as while a "
     "hand moves or stops it: the {kept} of {samples} samples between are taken for a free motion; "
     "{|{--from} and {--to}|the handles} choose another part",
     "was vor {from:.4g} s und nach {to:.4g} s liegt, gehört nicht zur Schwingung dazwischen, wie wenn eine "
     "Hand sie stört oder anhält: die {kept} von {samples} Messwerten dazwischen gelten als freie Bewegung; "
     "mit {|{--from} und {--to}|den Griffen} lässt sich ein anderer Teil wählen"},
    {"swing_until_caught", worth_knowing,
     "the swing stops between {from:.4g} and {to:.4g} s, from an amplitude of {amplitude:.3g}{unit: } to "
     "less than a tenth of it, as when a hand catches it: only what comes before, to {until:.4g} s, {kept} "
     "of {samples} samples, is fitted; {|{--from} and {--to}|the handles} choose another part",
     "die Schwingung endet zwischen {from:.4g} und {to:.4g} s, von einer Amplitude von "
     "{amplitude:.3g}{unit: } auf weniger als ein Zehntel davon, als hielte eine Hand sie an: das Gesetz "
     "wird nur an den Teil davor angepasst, bis {until:.4g} s, {kept} von {samples} Messwerten; mit "
     "{|{--from} und {--to}|den Griffen} lässt sich ein anderer wählen"},
    {"driven_until_stop", worth_knowing,
     "the motion stops between {from:.4g} and {to:.4g} s, as when its drive ends: only what comes before, "
     "to {until:.4g} s, {kept} of {samples} samples, is fitted; {|{--from} and {--to}|the handles} choose "
     "another part",
     "die Bewegung endet zwischen {from:.4g} und {to:.4g} s, wie wenn der Antrieb aufhört: das Gesetz wird "
     "nur an den Teil davor angepasst, bis {until:.4g} s, {kept} von {samples} Messwerten; mit {|{--from} "
     "und {--to}|den Griffen} lässt sich ein anderer wählen"},
    {"sensor_loses_motion", worth_knowing,
     "the sensor loses the motion at {from:.6g} s: from there on the column stays at {value:.4g}{unit: } in "
     "full swing, in {share:.3g} % of the samples. Only what comes before, {seen} of {samples} samples, is "
     "fitted; {|{--from} and {--to}|the handles} choose another part",
     "der Sensor verliert die Bewegung bei {from:.6g} s: mitten im Schwingen bleibt die Spalte von da an bei "
     "{value:.4g}{unit: }, in {share:.3g} % der Messwerte. Angepasst wird nur, was davor liegt, {seen} von "
     "{samples} Messwerten; mit {|{--from} und {--to}|den Griffen} lässt sich ein anderer Teil wählen"},
    {"cut_tops_aside", worth_knowing,
     "the motion's peaks are cut off at the same value again and again: {samples} samples there, the first "
     "at {first:.6g} s, are set aside",
     "die Gipfel der Bewegung sind immer wieder beim selben Wert abgeschnitten: {samples} Messwerte dort, "
     "der erste bei {first:.6g} s, sind beiseitegelegt"},
    {"drop_outs_aside", detail,
     "{samples} samples in flat runs far outside the motion, the first at {first:.6g} s, are taken for "
     "drop-outs of the sensor and set aside",
     "{samples:Messwert|Messwerte} in flachen Stücken weit außerhalb der Bewegung, der erste bei "
     "{first:.6g} s, {samples?ist|sind} als Aussetzer des Sensors beiseitegelegt"},
    {"sample_aside", detail,
     "one sample, at {first:.6g} s, lies far from the fitted motion and from its neighbours and is set aside",
     "ein Messwert, bei {first:.6g} s, liegt weit von Bewegung und Nachbarn und ist beiseitegelegt"},
    {"samples_aside", detail,
     "{samples} samples, the first at {first:.6g} s, lie far from the fitted motion and from their "
     "neighbours and are set aside",
     "{samples} Messwerte, der erste bei {first:.6g} s, liegen weit von Bewegung und Nachbarn und sind "
     "beiseitegelegt"},
    {"fitted_as_it_is", worth_knowing,
     "column \"{column}\" holds {kind} and is fitted as such: all results are those of the displacement, "
     "except the equilibrium, which is the sensor's offset",
     "die Spalte „{column}“ enthält {kind} und wird so angepasst: alle Ergebnisse gelten für die Auslenkung, "
     "nur die Ruhelage ist der Nullpunkt des Sensors"},
    {"fitted_as_it_is_of_angle", worth_knowing,
     "column \"{column}\" holds {kind} and is fitted as such: all results are those of the angle, except the "
     "equilibrium, which is the sensor's offset",
     "die Spalte „{column}“ enthält {kind} und wird so angepasst: alle Ergebnisse gelten für den Winkel, nur "
     "die Ruhelage ist der Nullpunkt des Sensors"},
    {"kind_position", clause, "position", "Orte"},
    {"kind_angle", clause, "angle", "Winkel"},
    {"kind_velocity", clause, "velocity", "Geschwindigkeiten"},
    {"kind_angular_velocity", clause, "angular velocity", "Winkelgeschwindigkeiten"},
    {"kind_acceleration", clause, "acceleration", "Beschleunigungen"},
    {"kind_angular_acceleration", clause, "angular acceleration", "Winkelbeschleunigungen"},
    {"kind_force", clause, "force", "Kräfte"},
    {"kind_voltage", clause, "voltage", "Spannungen"},
    {"kind_frequency", clause, "frequency", "Frequenzen"},
    {"kind_time", clause, "time", "Zeiten"},
    {"kind_unknown", clause, "no known quantity", "keine bekannte Größe"},
    {"kind_of_its_own", clause, "{quantity}", "{quantity}"},

    // What a fit says
    {"mass_gives_no_stiffness", worth_knowing,
     "{--mass} gives no stiffness here: column \"{column}\" is no length",
     "aus {--mass} folgt hier keine Federkonstante: die Spalte „{column}“ ist keine Länge"},
    {"no_reynolds_number", worth_knowing,
     "no Reynolds number: column \"{column}\" is neither a position nor a velocity",
     "keine Reynolds-Zahl: die Spalte „{column}“ ist weder Ort noch Geschwindigkeit"},
    {"long_period_for_reynolds", worth_knowing,
     "each Reynolds number is the largest of half a second, less than half the period of {period:.3g} s: "
     "where the swing's fastest moment lies outside, the number is smaller than that of the swing",
     "jede Reynolds-Zahl ist die größte einer halben Sekunde, weniger als die halbe Periode von {period:.3g} "
     "s: liegt der schnellste Augenblick der Schwingung außerhalb, ist die Zahl kleiner als die der "
     "Schwingung"},
    {"fit_interrupted", error,
     "interrupted: the law is fitted, but some results that follow from it are missing",
     "abgebrochen: das Gesetz ist angepasst, doch manches, was daraus folgt, fehlt"},
    {"may_be_the_force", worth_knowing,
     "if column \"{column}\" holds what drives the motion, give fit {--force-column} \"{column}\"",
     "falls die Spalte „{column}“ enthält, was die Bewegung antreibt: mit cromer fit {--force-column} "
     "anpassen"},
    {"hysteresis_from_zero", wrong_if_ignored,
     "the hysteretic force is taken as 0 at the first sample used, {--from}: if the body had moved before, "
     "its coefficients and the stiffness are off, and their uncertainties do not hold",
     "die hysteretische Kraft gilt beim ersten benutzten Messwert, {--from}, als 0: hat der Körper sich "
     "vorher bewegt, so stimmen ihre Beiwerte und die Federkonstante nicht, und ihre Unsicherheiten gelten "
     "nicht"},
    {"exponent_without_hysteresis", worth_knowing,
     "{--hysteresis-exponent} has no effect on the law {law}, which has no hysteresis",
     "{--hysteresis-exponent} bewirkt beim Gesetz {law} nichts: es hat keine Hysterese"},
    {"fits_failed", clause, "{failed} of {all} fits did not succeed",
     "{failed} von {all} Anpassungen sind nicht gelungen"},
    {"decrement_bias", clause,
     "too low if noise lifts the small peaks; a mean if the damping changes with the amplitude",
     "zu klein, wenn Rauschen die kleinen Gipfel hebt; ein Mittelwert, wenn die Dämpfung von der Amplitude "
     "abhängt"},
    {"bandwidth_bias", clause, "too wide unless the record lasts until the swing has died down",
     "zu breit, wenn die Aufnahme nicht dauert, bis die Schwingung abgeklungen ist"},

    // Segments
    {"segment_too_short", worth_knowing,
     "no decay rates by segment: those of {--segment} {length:.3g} would be {length:.3g} s long, but a "
     "segment must hold 1.5 periods and 8 samples, here {shortest:.3g} s",
     "keine Abklingraten nach Abschnitten: die von {--segment} {length:.3g} wären {length:.3g} s lang, doch "
     "ein Abschnitt muss 1,5 Perioden und 8 Messwerte enthalten, hier {shortest:.3g} s"},
    {"segments_too_short", worth_knowing,
     "no decay rates by segment: those of {--segments} {count} would be {length:.3g} s long, but a segment "
     "must hold 1.5 periods and 8 samples, here {shortest:.3g} s",
     "keine Abklingraten nach Abschnitten: die von {--segments} {count} wären {length:.3g} s lang, doch ein "
     "Abschnitt muss 1,5 Perioden und 8 Messwerte enthalten, hier {shortest:.3g} s"},
    {"fewer_segments", worth_knowing,
     "the record of {duration:.6g} s holds {whole} of the {count} segments of {length:.6g} s",
     "in die Aufnahme von {duration:.6g} s passen {whole} der {count} Abschnitte von {length:.6g} s"},
    {"rest_in_no_segment", detail,
     "the last {rest:.6g} s are shorter than a segment of {length:.6g} s and belong to none",
     "die letzten {rest:.6g} s sind kürzer als ein Abschnitt von {length:.6g} s und gehören zu keinem"},
    {"shorter_than_a_segment", worth_knowing,
     "the record of {duration:.6g} s is shorter than one segment of {length:.6g} s",
     "die Aufnahme von {duration:.6g} s ist kürzer als ein Abschnitt von {length:.6g} s"},
    {"segments_interrupted", worth_knowing, "interrupted after {done} of the {count} segments",
     "abgebrochen nach {done} von {count} Abschnitten"},
    {"segment_left_out", worth_knowing, "the segment from {from:.6g} to {to:.6g} s is left out: {why}",
     "der Abschnitt von {from:.6g} bis {to:.6g} s bleibt weg: {why}"},
    {"segments_left_out", worth_knowing,
     "{left_out} of the {count} segments are left out; the first, from {from:.6g} to {to:.6g} s: {why}",
     "{left_out} von {count} Abschnitten bleiben weg; der erste, von {from:.6g} bis {to:.6g} s: {why}"},

    // What drives it
    {"unused_if_driven", worth_knowing, "{option:option} is not used: the motion is driven",
     "{option:option} wird nicht gebraucht: die Bewegung ist angetrieben"},
    {"driven_has_no_reynolds", worth_knowing, "{--disc-diameter} gives no Reynolds number of a driven motion",
     "aus {--disc-diameter} folgt keine Reynolds-Zahl einer angetriebenen Bewegung"},
    {"driven_has_no_drag_number", worth_knowing,
     "{--disc-diameter} gives no Reynolds number of a driven motion; and no drag coefficient: that needs "
     "{--mass} and drag in the law",
     "aus {--disc-diameter} folgt keine Reynolds-Zahl einer angetriebenen Bewegung; auch kein "
     "Widerstandsbeiwert: der braucht {--mass} und den Luftwiderstand im Gesetz"},
    {"overdamped_law", worth_knowing, "the law is overdamped: it has no frequency and no period of its own",
     "das Gesetz ist überdämpft: es hat keine eigene Frequenz und Periode"},
    {"something_else_drives", wrong_if_ignored,
     "the law accounts for {share:.0f} % of the motion's variance, and the rest is not noise: something else "
     "drives the motion as well or instead, or it has another law",
     "das Gesetz erklärt {share:.0f} % der Varianz, und der Rest ist kein Rauschen: etwas anderes treibt "
     "die Bewegung auch oder stattdessen, oder sie hat ein anderes Gesetz"},
    {"drive_is_another", wrong_if_ignored,
     "the steady oscillation has {found:.6g} Hz, not the {asked:.6g} Hz of {--drive-frequency}",
     "die gleichbleibende Schwingung hat {found:.6g} Hz, nicht die {asked:.6g} Hz von {--drive-frequency}"},

    // Driven, free or two swings at once
    {"motion_is_driven", worth_knowing,
     "the motion is driven, at {frequency:.6g} Hz, and fitted as driven: a free law would leave an rms "
     "residual of {free:.3g}{unit: }, the driven one leaves {driven:.3g}{unit: }; {|where the drive's "
     "frequency is known, {--drive-frequency} names it; |}a part that swings freely is chosen with "
     "{|{--from} and {--to}|the handles}",
     "die Bewegung ist angetrieben, mit {frequency:.6g} Hz, und so angepasst: ein freies Gesetz ließe einen "
     "Effektivwert der Reste von {free:.3g}{unit: }, das angetriebene lässt {driven:.3g}{unit: }; {|ist die "
     "Frequenz des Antriebs bekannt, nennt sie {--drive-frequency}; |}einen Teil, der frei schwingt, wählt "
     "man mit {|{--from} und {--to}|den Griffen}"},
    {"perhaps_on_a_string", worth_knowing,
     "x and y of the point lie on an arc: if it hangs on a string or a rod, its law is that of the angle, "
     "and a law of {column} alone is only approximate; {|{--column} \"angle(x,y)\" fits the angle about the "
     "pivot|angle(x,y) as the column is the angle about the pivot}",
     "x und y des Punkts liegen auf einem Bogen: hängt er an einem Faden oder einer Stange, ist sein Gesetz "
     "das des Winkels, und ein Gesetz von {column} allein gilt nur ungefähr; {|{--column} \"angle(x,y)\" "
     "passt den Winkel um den Aufhängepunkt an|die Spalte angle(x,y) ist der Winkel um den Aufhängepunkt}"},
    {"beats_at_first", detail,
     "the motion beats at first, every {beat:.3g} s: beside the {drive:.5g} Hz of the drive the body swings "
     "at {own:.5g} Hz, its own frequency, and that dies down at {rate:n}",
     "die Bewegung schwebt anfangs, mit einer Periode von {beat:.3g} s: neben den {drive:.5g} Hz des "
     "Antriebs schwingt der Körper mit {own:.5g} Hz, seiner eigenen Frequenz, und das klingt mit {rate:n} "
     "ab"},
    {"mode", clause, "{frequency:n} (amplitude {amplitude:.3g}{unit: }, decay rate {decay_rate:n})",
     "{frequency:n} (Amplitude {amplitude:.3g}{unit: }, Abklingrate {decay_rate:n})"},
    {"two_steady_lines", wrong_if_ignored,
     "two oscillations hardly decay, at {one} and {other}: a drive on a swing without damping, two drives, "
     "or two modes, as of coupled pendulums, look the same",
     "zwei Schwingungen klingen kaum ab, mit {one} und {other}: ein Antrieb auf eine Schwingung ohne "
     "Dämpfung, zwei Antriebe und gekoppelte Pendel sehen gleich aus"},
    {"line_beside_the_drive", wrong_if_ignored,
     "beside the drive something oscillates at {line} and does not decay: another drive and an undamped body "
     "look the same",
     "neben dem Antrieb schwingt etwas mit {line} und klingt nicht ab: ein anderer Antrieb und ein Körper "
     "ohne Dämpfung sehen so aus"},
    {"two_readings", error,
     "the record has two readings: {readings}. The numbers here are those of a body of {own:n} without "
     "damping, driven at {drive:n}",
     "die Aufnahme lässt sich auf zwei Arten lesen: {readings}. Die Zahlen hier sind die eines Körpers von "
     "{own:n} ohne Dämpfung, angetrieben mit {drive:n}"},
    {"two_modes", clause,
     "two modes swing here, and both decay, like those of coupled pendulums: {one} and {other}; they beat "
     "every {beat:.3g} s",
     "hier schwingen zwei Moden, die beide abklingen, wie bei gekoppelten Pendeln: {one} und {other}; sie "
     "schweben mit einer Periode von {beat:.3g} s"},
    {"no_single_swing", error,
     "no single swing: {modes}. Let one of them swing alone, or choose another {|{--column}|column}.{| If "
     "masses are coupled, cromer modes finds each mode; if something drives it, try {--drive-frequency} "
     "auto|}",
     "keine einzelne Schwingung: {modes}. Bitte eine allein schwingen lassen oder {|mit {--column} "
     "eine|eine} andere Spalte wählen.{| Sind Massen gekoppelt, findet cromer modes jede Eigenschwingung; "
     "treibt etwas an, hilft {--drive-frequency} auto|}"},
    {"modes_beside_the_law", wrong_if_ignored,
     "{modes}; together they leave an rms residual of {together:.3g}, the law leaves {law:.3g}",
     "{modes}; zusammen lassen sie einen Effektivwert der Reste von {together:.3g}, das Gesetz {law:.3g}"},
    {"free_beside_driven", clause,
     "a free law leaves an rms residual of {free:.4g}{unit: }, the driven one {driven:.4g}{unit: }",
     "ein freies Gesetz lässt einen Effektivwert der Reste von {free:.4g}{unit: }, das angetriebene "
     "{driven:.4g}{unit: }"},
    {"no_drive_found", worth_knowing,
     "no drive is seen at any frequency ({compared}): fitted as a free motion",
     "bei keiner Frequenz ist ein Antrieb zu sehen ({compared}): als freie Bewegung angepasst"},
    {"no_drive_there", worth_knowing,
     "nothing is seen to drive this motion at {asked:.6g} Hz ({compared}): fitted as a free motion; "
     "{--drive-frequency} auto looks for a drive elsewhere",
     "mit {asked:.6g} Hz treibt nichts diese Bewegung, soweit zu sehen ist ({compared}): als freie Bewegung "
     "angepasst; {--drive-frequency} auto sucht anderswo nach einem Antrieb"},
    {"axis_holds_gravity", worth_knowing,
     "the values lie about {mean:.3g} m/s²: this axis holds gravity. Along a pendulum's string a sensor "
     "shows twice the frequency and twice the decay rate; an axis across the string shows the swing itself",
     "die Werte liegen um {mean:.3g} m/s²: diese Achse enthält die Schwerkraft. Längs eines Pendelfadens "
     "zeigt ein Sensor das Doppelte der Frequenz und der Abklingrate; eine Achse quer zum Faden zeigt die "
     "Schwingung selbst"},
    {"settled_or_free", wrong_if_ignored,
     "the motion of {frequency:.6g} Hz does not die down: driven and settled, or free and without damping, "
     "it looks the same, and no drive is told from it; fitted as a free motion. Record from where a drive "
     "is switched on or off",
     "die Bewegung mit {frequency:.6g} Hz klingt nicht ab: angetrieben und eingeschwungen oder frei und "
     "ungedämpft sieht sie gleich aus, und ein Antrieb ist daran nicht zu erkennen; als freie Bewegung "
     "angepasst. Bitte von dort aufnehmen, wo ein Antrieb ein- oder ausgeschaltet wird"},
    {"motion_has_settled", error,
     "the motion of {frequency:.6g} Hz does not die down: once it has settled, a driven motion shows the "
     "drive's frequency, and neither the body's own nor its damping. Record from where the drive is switched "
     "on or off; without {--drive-frequency} the motion is taken for a free one",
     "die Bewegung mit {frequency:.6g} Hz klingt nicht ab: eingeschwungen zeigt eine angetriebene Bewegung "
     "die Frequenz des Antriebs, weder die des Körpers noch seine Dämpfung. Bitte von dort aufnehmen, wo der "
     "Antrieb ein- oder ausgeschaltet wird; ohne {--drive-frequency} gilt die Bewegung als freie"},
    {"neither_driven_nor_free", error,
     "no drive is seen at {asked:.6g} Hz, and no free law describes the motion either ({compared}); "
     "{--drive-frequency} auto looks for a drive",
     "mit {asked:.6g} Hz ist kein Antrieb zu sehen, und auch kein freies Gesetz beschreibt die Bewegung "
     "({compared}); {--drive-frequency} auto sucht nach einem Antrieb"},

    // How long to record
    {"of_goal", error, "{--goal}: {what}", "{--goal}: {what}"},
    {"goal_unknown", error,
     "{--goal}: \"{typed}\" is no quantity of a fit; {hint} Give a name and its standard uncertainty, for "
     "instance \"decay_rate 0.5 %\"",
     "{--goal}: „{typed}“ ist keine Größe einer Anpassung; {hint} Bitte einen Namen und die "
     "Standardunsicherheit angeben, zum Beispiel „decay_rate 0.5 %“"},
    {"quantity_meant", clause, "did you mean {quantity}?", "ist {quantity} gemeint?"},
    {"quantities_there_are", clause, "there are {quantities}.", "es gibt {quantities}."},
    {"goal_without_uncertainty", error,
     "{--goal}: how well should {quantity} be known? For instance \"{quantity} 0.5 %\"",
     "{--goal}: wie genau soll {quantity} bekannt sein? Zum Beispiel „{quantity} 0.5 %“"},
    {"goal_not_positive", error,
     "{--goal}: the uncertainty of {quantity} must be positive, not {uncertainty}",
     "{--goal}: die Unsicherheit von {quantity} muss größer als 0 sein, nicht {uncertainty}"},
    {"goal_not_in_fit", error, "{--goal}: there is no {quantity} in this fit: {why}",
     "{--goal}: {quantity} gibt es in dieser Anpassung nicht: {why}"},
    {"term_not_in_law", clause, "its law is {law}; fit one with {term} by {--law}",
     "ihr Gesetz ist {law}; bitte mit {--law} eines mit {term} anpassen"},
    {"quantity_needs_more", clause,
     "its law is {law}; quantities of force need a position (or velocity, acceleration) and {--mass}, and a "
     "drag coefficient needs {--disc-diameter} as well",
     "ihr Gesetz ist {law}; Größen der Kraft brauchen einen Ort (oder eine Geschwindigkeit, eine "
     "Beschleunigung) und {--mass}, ein Widerstandsbeiwert auch {--disc-diameter}"},
    {"goal_with_hysteresis", error,
     "{--goal}: how soon a swing with hysteresis dies down is not predicted; give another {--law}",
     "{--goal}: wie bald eine Schwingung mit Hysterese abklingt, wird nicht vorhergesagt; bitte ein anderes "
     "{--law} angeben"},
    {"plan_met", clause,
     "the goal is met: {quantity} is known to {now:n}, and {goal:n} was asked for; the first {duration:n} "
     "would do",
     "das Ziel ist erreicht: {quantity} ist auf {now:n} bekannt, verlangt war {goal:n}; die ersten "
     "{duration:n} hätten genügt"},
    {"plan_possible", clause,
     "{quantity} is known to {now:n} from {present:n}; for {goal:n} record {duration:n} from such a start "
     "({samples:.0f} samples at {rate:.6g} a second)",
     "{quantity} ist aus {present:n} auf {now:n} bekannt; für {goal:n} bitte {duration:n} von einem solchen "
     "Anfang an aufnehmen ({samples:.0f} Messwerte, {rate:.6g} je Sekunde)"},
    {"plan_limited_by_values", clause,
     "a longer record does not reach {goal:n}: {quantity} is known to {now:n}, and what limits it are the "
     "values given, such as the mass",
     "eine längere Aufnahme erreicht {goal:n} nicht: {quantity} ist auf {now:n} bekannt, und was das "
     "begrenzt, sind die angegebenen Werte, etwa die Masse"},
    {"plan_out_of_reach", clause,
     "{limits}; it takes {noise:.2g} times less noise{start}, or {rate:.2g} times the samples per second if "
     "their noise is white",
     "{limits}; dazu gehört {noise:.2g}-mal weniger Rauschen{start} oder {rate:.2g}-mal so viele Messwerte "
     "je Sekunde, wenn ihr Rauschen weiß ist"},
    {"swing_dies_down_before", clause,
     "a longer record does not reach {goal:n}: after {duration:n} the swing has died down, and {quantity} "
     "is known to {best:n} however long one records",
     "eine längere Aufnahme erreicht {goal:n} nicht: nach {duration:n} ist die Schwingung abgeklungen, und "
     "{quantity} ist auf {best:n} bekannt, wie lange man auch aufnimmt"},
    {"record_never_long_enough", clause,
     "not even a record of {duration:n} reaches {goal:n}: {quantity} is then known to {best:n}",
     "nicht einmal eine Aufnahme von {duration:n} erreicht {goal:n}: {quantity} ist dann auf {best:n} "
     "bekannt"},
    {"or_a_start_so_much_larger", clause, " or a start {times:.2g} times as large",
     " oder ein {times:.2g}-mal so großer Anfang"},
    {"or_a_larger_start", clause, " or a larger start", " oder ein größerer Anfang"},

    // Masses of runs
    {"masses_unlike_runs", error,
     "{file}: {masses:mass is|masses are} given for {runs:run|runs}; {option:option} needs one for each",
     "{file}: {masses:Masse|Massen} für {runs:Lauf|Läufe}; {option:option} braucht eine für jeden"},
    {"one_mass_for_unlike_runs", worth_knowing,
     "the runs' frequencies differ by {percent:.2g} %, and one mass is used for all; if the masses differ, "
     "give one for each: {--mass} \"0.1 kg, 0.2 kg\"",
     "die Frequenzen der Läufe unterscheiden sich um {percent:.2g} %, und für alle gilt eine Masse; sind es "
     "verschiedene, dann jede angeben: {--mass} \"0.1 kg, 0.2 kg\""},

    // Simulations beside a recording
    {"compared_is_driven", error, "something drives this motion; compare lays free motions side by side",
     "etwas treibt diese Bewegung an; verglichen werden freie Bewegungen"},
    {"compare_has_no_drive", error,
     "{--force-column} and {--drive-frequency} are options of fit: compare lays free motions side by side",
     "{--force-column} und {--drive-frequency} gehören zu fit: verglichen werden freie Bewegungen"},
    {"compared_is_no_position", error,
     "compare needs a position or an angle, and column \"{column}\" holds {kind}; choose {|one by "
     "{--column}|another column}",
     "ein Vergleich braucht Orte oder Winkel, und die Spalte „{column}“ enthält {kind}; bitte {|mit "
     "{--column} wählen|eine andere wählen}"},
    {"compared_step", error,
     "{--step} {step}: it must be positive, at most the recording's {duration:.6g} s, and give at most "
     "{most:.0e} steps over them",
     "{--step} {step}: das muss größer als 0 sein, höchstens so lang wie die Aufnahme ({duration:.6g} s), "
     "und darf in ihr höchstens {most:.0e} Schritte geben"},
    {"compared_has_no_closed_form", error,
     "{--method} exact: there is no closed form with {term}; choose rk4 or another method, or {--law} "
     "viscous",
     "{--method} exact: mit {term} gibt es keine geschlossene Lösung; bitte rk4 oder ein anderes Verfahren "
     "wählen oder {--law} viscous"},
    {"interrupted_before_simulating", worth_knowing, "interrupted before anything was simulated",
     "abgebrochen, bevor etwas simuliert war"},
    {"law_by_name", clause, "{law}", "{law}"},
    {"law_by_method", clause, "{law} by {method}", "{law} mit {method}"},
    {"one_constant_decay_rate", clause, "one constant decay rate", "eine feste Abklingrate"},
    {"curve_interrupted", worth_knowing, "{law}: interrupted at {t:.6g} s",
     "{law}: abgebrochen bei {t:.6g} s"},
    {"curve_ended", wrong_if_ignored,
     "{law}: {method} ended at {t:.6g} s with {status}; a smaller {--step} may help",
     "{law}: {method} endet bei {t:.6g} s mit {status}; ein kleineres {--step} kann helfen"},
    {"curve_grows", wrong_if_ignored,
     "{law}: {method} with a step of {step:.6g} s grows to {times:.3g} times the amplitude that it started "
     "from: it is unstable there, and the figures say nothing of the law; take a smaller {--step} or "
     "another {--method}",
     "{law}: {method} wächst mit Schritten von {step:.6g} s auf das {times:.3g}-Fache der Amplitude am "
     "Anfang: es ist da instabil, und die Zahlen sagen nichts über das Gesetz; bitte ein kleineres {--step} "
     "oder ein anderes {--method} nehmen"},
    {"law_runs_away", error,
     "{law}: started as the recording was, this law's motion runs away; choose another {--law}",
     "{law}: vom Anfang der Aufnahme aus läuft die Bewegung dieses Gesetzes davon; bitte ein anderes {--law} "
     "wählen"},

    // Whether one decay rate is enough
    {"one_then_another", clause, "{one}{another}", "{one}{another}"},
    {"simulation_runs_away", clause,
     " Simulated by {method} in steps of {step:n}\u00a0s the motion runs away: that step is too long for the "
     "method. Take a smaller {--step} or another {--method}.",
     " Mit {method} in Schritten von {step:n}\u00a0s simuliert läuft die Bewegung davon: dieser Schritt ist "
     "zu lang für das Verfahren. Bitte ein kleineres {--step} oder ein anderes {--method} nehmen."},
    {"no_verdict", clause, "{doubt:A}. No verdict on the damping: {one_rate}.",
     "{doubt:A}. Kein Urteil über die Dämpfung: {one_rate}."},
    {"no_verdict_with_law", clause, "{doubt:A}. No verdict on the damping: {one_rate}, {with_law}.",
     "{doubt:A}. Kein Urteil über die Dämpfung: {one_rate}, {with_law}."},
    {"parts_have_other_rates", clause,
     "{doubt:A}. One decay rate is not enough, whatever the law: {parts}; {one_rate}, {with_law}.",
     "{doubt:A}. Eine Abklingrate genügt nicht, welches Gesetz auch gilt: {parts}; {one_rate}, {with_law}."},
    {"rates_of_parts", clause,
     "parts of the recording, each fitted by itself, have {first:n} at an amplitude of {from:n} and {last:n} "
     "at {to:n}",
     "Teile der Aufnahme, jeder für sich angepasst, haben {first:n} bei einer Amplitude von {from:n} und "
     "{last:n} bei {to:n}"},
    {"one_rate_is_enough", clause, "One decay rate is enough: {one_rate}, and {end}.{method}",
     "Eine Abklingrate genügt: {one_rate}, und {end}.{method}"},
    {"one_rate_fits", clause,
     "One decay rate fits: {one_rate}, and {end}. So do laws whose rate changes: this recording cannot tell "
     "them apart.{method}",
     "Eine Abklingrate passt: {one_rate}, und {end}. Gesetze, deren Rate sich ändert, passen auch: diese "
     "Aufnahme kann sie nicht trennen.{method}"},
    {"viscous_is_enough", clause,
     "Viscous damping alone is enough: {one_rate}, and {end}. The amplitude's own rate goes from {first:n} "
     "to {last:n}\u00a01/s, as the restoring force is not proportional to the displacement.{method}",
     "Viskose Dämpfung allein genügt: {one_rate}, und {end}. Die Rate der Amplitude selbst geht von "
     "{first:n} auf {last:n}\u00a01/s, da die Rückstellkraft nicht proportional zur Auslenkung ist.{method}"},
    {"one_rate_is_best", clause,
     "No law that was tried tells more than one decay rate: {one_rate}, but {end}.{method}",
     "Kein versuchtes Gesetz sagt mehr als eine Abklingrate: {one_rate}, aber {end}.{method}"},
    {"viscous_is_best", clause,
     "No law that was tried tells more than viscous damping alone: {one_rate}, but {end}. The amplitude's "
     "own rate goes from {first:n} to {last:n}\u00a01/s, as the restoring force is not proportional to the "
     "displacement.{method}",
     "Kein versuchtes Gesetz sagt mehr als viskose Dämpfung allein: {one_rate}, aber {end}. Die Rate der "
     "Amplitude selbst geht von {first:n} auf {last:n}\u00a01/s, da die Rückstellkraft der Auslenkung nicht "
     "proportional ist.{method}"},
    {"one_rate_while_stretches_scatter", clause,
     "No law that was tried tells more than one decay rate: {one_rate}. But the rates of single stretches, "
     "{least:n} to {largest:n}\u00a01/s, scatter by more than the noise explains, and their errors are "
     "widened by that: something else takes part.{method}",
     "Kein versuchtes Gesetz sagt mehr als eine Abklingrate: {one_rate}. Die Raten einzelner Abschnitte, "
     "{least:n} bis {largest:n}\u00a01/s, streuen aber mehr, als das Rauschen erklärt, und ihre Fehler sind "
     "darum geweitet: etwas anderes wirkt mit.{method}"},
    {"no_other_law_tried", clause, "No other law was tried: {one_rate}, and {end}.{method}",
     "Kein anderes Gesetz wurde versucht: {one_rate}, und {end}.{method}"},
    {"one_rate_is_not_enough", clause, "One decay rate is not enough: {one_rate}, {with_law}.{method}",
     "Eine Abklingrate genügt nicht: {one_rate}, {with_law}.{method}"},
    {"one_rate_but_not_the_motion", clause,
     "One decay rate describes the amplitude, but not the motion: {one_rate}, {with_law}. The frequency "
     "changes as the swing dies down.{method}",
     "Eine Abklingrate beschreibt die Amplitude, aber nicht die Bewegung: {one_rate}, {with_law}. Die "
     "Frequenz ändert sich, während die Schwingung abklingt.{method}"},
    {"rate_changes_with_amplitude", clause,
     "One decay rate is not enough. By the law it {goes} from {first:n} to {last:n}\u00a01/s as the swing "
     "{swing} from "
     "{from:n} to {to:n}; {one_rate}, {with_law}; by one rate {end}. Quote the law instead.{method}",
     "Eine Abklingrate genügt nicht. Nach dem Gesetz {goes} sie von {first:n} auf {last:n}\u00a01/s, während "
     "die Schwingung "
     "von {from:n} auf {to:n} {swing}; {one_rate}, {with_law}; mit nur einer Rate gilt: {end}. Bitte das "
     "Gesetz "
     "angeben.{method}"},
    {"falls", clause, "falls", "fällt"},
    {"rises", clause, "rises", "steigt"},
    {"swing_grows", clause, "grows", "wächst"},
    {"swing_dies_down", clause, "dies down", "abklingt"},
    {"one_rate_leaves", clause, "with one rate for all damping {left:n} (rms) are left",
     "mit einer Rate für alle Dämpfung bleiben {left:n} (Effektivwert) übrig"},
    {"mean_rate_leaves", clause, "with one rate, the mean of the segments', {left:n} (rms) are left",
     "mit einer Rate, der mittleren der Abschnitte, bleiben {left:n} (Effektivwert) übrig"},
    {"law_leaves", clause, "with {law} {left:n}", "mit {law} {left:n}"},
    {"both_have_died_down", clause, "the swing has died down where the measured one has",
     "die Schwingung ist abgeklungen, wo die gemessene es ist"},
    {"it_still_swings", clause, "it still swings where the measured motion has died down",
     "es schwingt noch, wo die gemessene Bewegung abgeklungen ist"},
    {"end_is_right", clause, "the amplitude at the end is right to 0.05\u00a0%",
     "die Amplitude am Ende stimmt auf 0,05\u00a0%"},
    {"end_is_right_within_noise", clause,
     "the amplitude at the end is right within what the noise lets see, {noise:n}\u00a0%",
     "die Amplitude am Ende stimmt, soweit das Rauschen es sehen lässt, auf {noise:n}\u00a0%"},
    {"end_is_near_the_noise", clause, "the amplitude at the end is too near the noise to test it",
     "die Amplitude am Ende ist dem Rauschen zu nah, um etwas zu prüfen"},
    {"end_too_large", clause, "the amplitude at the end is {off:n}\u00a0% too large",
     "die Amplitude am Ende ist um {off:n}\u00a0% zu groß"},
    {"end_too_small", clause, "the amplitude at the end is {off:n}\u00a0% too small",
     "die Amplitude am Ende ist um {off:n}\u00a0% zu klein"},
    {"method_leaves", clause,
     " Simulated by {method} in steps of {step:n}\u00a0s the same law leaves {left:n}; the rest is the "
     "method's.",
     " Mit {method} in Schritten von {step:n}\u00a0s simuliert lässt dasselbe Gesetz {left:n} übrig; der "
     "Rest ist vom Verfahren."},
    {"method_adds", clause,
     " Simulated by {method} in steps of {step:n}\u00a0s the same law leaves {left:n}: the method "
     "{adds:and} by the end.",
     " Mit {method} in Schritten von {step:n}\u00a0s simuliert lässt dasselbe Gesetz {left:n} übrig: bis "
     "zum Ende {adds:and}."},
    {"adds_a_phase", clause, "adds a phase of {phase:n}\u00a0rad",
     "verschiebt das Verfahren die Phase um {phase:n}\u00a0rad"},
    {"makes_it_larger", clause, "makes the amplitude {change:n}\u00a0% larger",
     "macht es die Amplitude um {change:n}\u00a0% größer"},
    {"makes_it_smaller", clause, "makes the amplitude {change:n}\u00a0% smaller",
     "macht es die Amplitude um {change:n}\u00a0% kleiner"},

    // What is in a file
    {"inspected_one_of_several", worth_knowing,
     "several columns may be meant: times and outliers are those of \"{column}\"; a fit needs "
     "{|{--column}|one to be chosen}",
     "mehrere Spalten kommen infrage: Zeiten und Ausreißer sind die von „{column}“; {|eine Anpassung braucht "
     "{--column}|für eine Anpassung bitte eine wählen}"},
    {"outliers_in_column", worth_knowing,
     "column \"{column}\": {outliers:outlier|outliers}, the first in {@line}: {value:n}",
     "Spalte „{column}“: {outliers:Ausreißer|Ausreißer}, der erste in {@line}: {value:n}"},
};

}  // namespace

const std::span<const Entry> words_of_fit = entries;

}  // namespace cromer::core
