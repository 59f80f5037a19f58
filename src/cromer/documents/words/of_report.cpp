#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // The report of one's own recordings: its head.
    {"report_file_head", clause,
     "# To make the report again: cromer report study.toml -o report\n# A second run updates the numbers, "
     "but not the choice of sentences, which the first run made. For\n# other recordings, another mass or "
     "another part start with: cromer report FILE... -o report",
     "# Der Bericht entsteht von neuem durch: cromer report study.toml -o bericht\n# Ein neuer Lauf setzt "
     "die Zahlen neu ein; welche Sätze hier stehen, hat der erste bestimmt. Für andere\n# Aufnahmen, eine "
     "andere Masse oder einen anderen Teil neu beginnen: cromer report DATEI... -o bericht"},
    {"report_title", clause, "The law of motion in {file}", "Das Bewegungsgesetz in {file}"},
    {"report_title_of_several", clause, "The laws of motion of {count} recordings",
     "Die Bewegungsgesetze von {count} Aufnahmen"},
    {"report_title_of_runs", clause, "The laws of motion in {file}", "Die Bewegungsgesetze in {file}"},
    {"report_run", clause, "Run {run}", "Lauf {run}"},
    {"report_run_of", clause, "{file}, run {run}", "{file}, Lauf {run}"},
    {"report_no_law", clause, "{file}: no law of motion is given. The reason: {why}.",
     "{file}: kein Bewegungsgesetz lässt sich angeben. Der Grund: {why}."},
    {"report_poorly_described", clause,
     "{file}: no law that was tried describes this motion. The nearest leaves {rms} (root mean square), "
     "more than a tenth of the swing: its numbers are not those of the motion.{why}",
     "{file}: kein Gesetz, das geprüft wurde, beschreibt diese Bewegung. Das nächste lässt {rms} "
     "(Effektivwert) übrig, mehr als ein Zehntel der Schwingung: seine Zahlen sind nicht die der "
     "Bewegung.{why}"},
    {"report_perhaps_a_part", clause, " A part that swings freely may have a law ({--from}, {--to}).",
     " Ein Teil, der frei schwingt, kann ein Gesetz haben ({--from}, {--to})."},
    {"report_swings_at", clause, "{file}: a free swing at {frequency}.",
     "{file}: eine freie Schwingung mit {frequency}."},
    {"report_swings_at_first", clause,
     "{file}: a free swing, at first at {frequency} with an amplitude of {amplitude}.",
     "{file}: eine freie Schwingung, zuerst mit {frequency} bei einer Amplitude von {amplitude}."},
    {"report_swings_from_to", clause,
     "{file}: a free swing, at first at {frequency} with an amplitude of {amplitude}, at last at {last} with "
     "{last_amplitude}.",
     "{file}: eine freie Schwingung, zuerst mit {frequency} bei einer Amplitude von {amplitude}, zuletzt mit "
     "{last} bei {last_amplitude}."},
    {"report_free_motion", clause, "{file}: a free motion.", "{file}: eine freie Bewegung."},
    {"report_driven_motion", clause, "{file}: a driven motion.", "{file}: eine angetriebene Bewegung."},
    {"report_swings_at_amplitude", clause,
     "{file}: a free swing at {frequency}, at an amplitude of {amplitude}.",
     "{file}: eine freie Schwingung mit {frequency} bei einer Amplitude von {amplitude}."},
    {"report_at_amplitude", clause,
     "amplitude that frequency, period, damping ratio, quality factor and decrement hold at",
     "Amplitude, bei der Frequenz, Periode, Dämpfungsgrad, Güte und Dekrement gelten"},
    {"report_zero", clause, "zero of the sensor", "Nullpunkt des Sensors"},
    {"report_record_with_zero", clause, "The recording, {used}, and the sensor's zero by the law, {level}.",
     "Die Aufnahme, {used}, und der Nullpunkt des Sensors nach dem Gesetz, {level}."},
    {"report_angular_velocity", clause, "angular velocity", "Winkelgeschwindigkeit"},
    {"report_driven_at", clause,
     "{file}: a driven motion of an oscillator whose own frequency is {frequency}.",
     "{file}: die angetriebene Bewegung eines Schwingers mit der Eigenfrequenz {frequency}."},
    {"report_driven_by", clause,
     "{file}: a motion driven at {drive}, of an oscillator whose own frequency is {frequency}.",
     "{file}: eine mit {drive} angetriebene Bewegung eines Schwingers mit der Eigenfrequenz {frequency}."},
    {"report_spring_constant", clause,
     "With a mass of {mass}{alone} the spring constant{swings} is {stiffness}.",
     "Mit einer Masse von {mass}{alone} ist die Federkonstante{swings} {stiffness}."},
    {"report_and_a_third_of_the_springs", clause, " and a third of the spring's {spring}",
     " und einem Drittel der {spring} der Feder"},
    {"report_without_the_springs_own", clause, ", without the spring's own,", " ohne die der Feder"},
    {"report_for_small_swings", clause, " for small swings", " für kleine Schwingungen"},
    {"report_rate_is", clause, "The decay rate is {rate}.", "Die Abklingrate ist {rate}."},
    {"report_rate_starts", clause, "The decay rate is {start} at the start.",
     "Die Abklingrate ist am Anfang {start}."},
    {"report_rate_falls", clause, "The decay rate falls from {start} at the start to {end} at the end.",
     "Die Abklingrate fällt von {start} am Anfang auf {end} am Ende."},
    {"report_rate_rises", clause, "The decay rate rises from {start} at the start to {end} at the end.",
     "Die Abklingrate steigt von {start} am Anfang auf {end} am Ende."},
    {"report_rate_at_both", clause,
     "The decay rate is {start} at the start and {end} at the end; the two cannot be told apart for sure.",
     "Die Abklingrate ist {start} am Anfang und {end} am Ende; sicher unterscheiden lassen sich beide "
     "nicht."},
    {"report_rate_by_the_law", clause,
     "By this law the decay rate would be {start} at the start and {end} at the end.",
     "Nach diesem Gesetz wäre die Abklingrate {start} am Anfang und {end} am Ende."},
    {"report_rate_of_stretches", clause,
     "The decay rate of parts of the recording, each fitted by itself, is {one} at an amplitude of "
     "{one_amplitude} and {other} at {other_amplitude}.",
     "Die Abklingrate von Teilen der Aufnahme, jeder für sich angepasst, ist {one} bei einer Amplitude "
     "von {one_amplitude} und {other} bei {other_amplitude}."},
    {"report_rate_between", clause,
     "The decay rate of parts of the recording, each fitted by itself, is between {one}, at an amplitude of "
     "{one_amplitude}, and {other}, at {other_amplitude}.",
     "Die Abklingrate von Teilen der Aufnahme, jeder für sich angepasst, liegt zwischen {one}, bei einer "
     "Amplitude von {one_amplitude}, und {other}, bei {other_amplitude}."},
    {"report_friction_makes_it_rise", clause,
     "Under this law it rises because dry friction, the same at every amplitude, weighs more in small "
     "swings.",
     "Unter diesem Gesetz steigt sie, weil trockene Reibung, die bei jeder Amplitude gleich groß ist, in "
     "kleinen Schwingungen mehr ausmacht."},
    {"report_drag_makes_it_fall", clause,
     "Under this law it falls because drag, which grows with the square of the velocity, weighs more in "
     "large "
     "swings.",
     "Unter diesem Gesetz fällt sie, weil der Luftwiderstand, der mit dem Quadrat der Geschwindigkeit "
     "wächst, "
     "in großen Schwingungen mehr ausmacht."},
    {"report_rate_common", clause,
     "The decay rate is {rate} at the swing's rms amplitude, {amplitude}; how it changes as the swing dies "
     "down depends "
     "on which of the laws that fit is right.",
     "Die Abklingrate ist {rate} bei der mittleren Amplitude (Effektivwert) der Schwingung, {amplitude}; wie "
     "sie sich beim "
     "Abklingen ändert, hängt davon ab, welches der passenden Gesetze stimmt."},
    {"report_at_rms_amplitude", clause, "at the rms amplitude, {amplitude}",
     "bei der mittleren Amplitude {amplitude}"},
    {"report_rate_at_first", clause, "decay rate of the first part", "Abklingrate des ersten Teils"},
    {"report_of_a_part", clause, "last part: {rate}", "letzter Teil: {rate}"},
    {"report_largest_reynolds", clause, "The Reynolds number reaches {largest}.",
     "Die Reynolds-Zahl erreicht {largest}."},
    {"report_period_is", clause, "period {period}", "Periode {period}"},
    {"report_of_amplitude", clause, "at an amplitude of {amplitude}", "bei einer Amplitude von {amplitude}"},
    {"report_interval", clause, "{low} to {high}", "{low} bis {high}"},
    {"report_at_least", clause, "at least {low}", "mindestens {low}"},
    {"report_rate_at_start", clause, "decay rate at the start", "Abklingrate am Anfang"},
    {"report_rate_at_end", clause, "decay rate at the end", "Abklingrate am Ende"},
    {"report_at_end", clause, "at the end {rate}", "am Ende {rate}"},
    {"report_reynolds_max", clause, "largest Reynolds number", "größte Reynolds-Zahl"},
    {"report_at", clause, "at {t}", "bei {t}"},
    {"report_recordings", clause,
     "What the recordings say. The digits in brackets are the standard uncertainty of the last digits.",
     "Was die Aufnahmen sagen. Die Ziffern in Klammern sind die Standardunsicherheit der letzten Stellen."},
    {"report_stiffness_agrees", clause,
     "The spring constants agree within their uncertainties, as those of one spring do.",
     "Die Federkonstanten stimmen im Rahmen ihrer Unsicherheiten überein, wie es die einer Feder tun."},
    {"report_stiffness_differs", clause,
     "The spring constants differ by more than their uncertainties: if it was one spring, a mass is off, or "
     "a part of the spring's own mass that was not counted.",
     "Die Federkonstanten unterscheiden sich um mehr als ihre Unsicherheiten: war es eine Feder, so stimmt "
     "eine Masse nicht, oder es fehlt ein Teil der Eigenmasse der Feder."},
    {"report_recordings_by_parts", clause,
     " Where no law describes a recording, the frequency is that of its first part, and the decay rates are "
     "those of its first and its last part, each fitted by itself.",
     " Wo kein Gesetz eine Aufnahme beschreibt, ist die Frequenz die ihres ersten Teils, und die "
     "Abklingraten "
     "sind die ihres ersten und ihres letzten Teils, jeder für sich angepasst."},
    {"report_recording", clause, "recording", "Aufnahme"},

    // What its writer adds.
    {"report_aim", clause, "Aim", "Ziel"},
    {"report_apparatus", clause, "Apparatus and procedure", "Aufbau und Durchführung"},
    {"report_conclusion", clause, "Conclusion", "Schluss"},

    // The recording and its law.
    {"report_measured", clause, "What was measured", "Was gemessen wurde"},
    {"report_samples", clause, "{file}{column}: {used}{part} in {duration}{rate}.{aside}",
     "{file}{column}: {used}{part} in {duration}{rate}.{aside}"},
    {"report_column", clause, ", column \"{column}\"", ", Spalte „{column}“"},
    {"report_not_used", clause, "not used", "nicht benutzt"},
    {"report_as_recorded", clause, "as recorded", "wie aufgezeichnet"},
    {"report_samples_used", clause, "{used} samples", "{used} Messwerte"},
    {"report_used_of", clause, "{used} of {samples} samples", "{used} von {samples} Messwerten"},
    {"report_part", clause, ", those from {from} to {to},", ", die von {from} bis {to},"},
    {"report_rate", clause, ", {rate} a second", ", {rate} pro Sekunde"},
    {"report_rate_given", clause, ", {rate} a second (given: the file has no times)",
     ", {rate} pro Sekunde (angegeben: die Datei hat keine Zeiten)"},
    {"report_gaps", clause, " Samples are missing at {gaps:place|places}.",
     " An {gaps:Stelle|Stellen} fehlen Messwerte."},
    {"report_outliers", clause,
     " {outliers:sample lies|samples lie} far from the motion and {outliers?is|are} set aside.",
     " {outliers:Messwert liegt|Messwerte liegen} weit neben der Bewegung und {outliers?wird|werden} "
     "beiseite gelassen."},
    {"report_record_title", clause, "Measured: {file}", "Gemessen: {file}"},
    {"report_record", clause, "The recording, {used}.", "Die Aufnahme, {used}."},
    {"report_record_with_level", clause, "The recording, {used}, and the rest position by the law, {level}.",
     "Die Aufnahme, {used}, und die Ruhelage nach dem Gesetz, {level}."},
    {"report_assumed", clause, "assumed", "angenommen"},
    {"report_is_measured", clause, "measured", "gemessen"},
    {"report_level", clause, "rest position", "Ruhelage"},
    {"report_time", clause, "time *t* (s)", "Zeit *t* (s)"},
    {"report_since_start", clause, "time since the first sample (s)", "Zeit seit dem ersten Messwert (s)"},
    {"report_position", clause, "position", "Ort"},
    {"report_angle", clause, "angle", "Winkel"},
    {"report_velocity", clause, "velocity *v*", "Geschwindigkeit *v*"},
    {"report_acceleration", clause, "acceleration", "Beschleunigung"},
    {"report_value", clause, "measured value", "Messwert"},
    {"report_its_value", clause, "value", "Wert"},
    {"report_position_at_start", clause, "displacement at the first sample",
     "Auslenkung beim ersten Messwert"},
    {"report_velocity_at_start", clause, "velocity at the first sample",
     "Geschwindigkeit beim ersten Messwert"},
    {"report_displacement", clause, "displacement *x*", "Auslenkung *x*"},
    {"report_law", clause, "The law of motion", "Das Bewegungsgesetz"},
    {"report_law_chosen", clause, "Of {laws} laws that were tried, {law} ({terms}) was chosen:",
     "Von {laws} Gesetzen, die geprüft wurden, ist {law} ({terms}) gewählt:"},
    {"report_law_asked", clause,
     "The law is {law} ({terms}), as asked for:", "Das Gesetz ist {law} ({terms}), wie verlangt:"},
    {"report_white", clause,
     "What it leaves of the measured values is {rms} (root mean square), and no pattern is found in it.",
     "Was es von den Messwerten übrig lässt, ist {rms} (Effektivwert), und ein Muster ist darin nicht zu "
     "finden."},
    {"report_not_white", clause,
     "What it leaves of the measured values is {rms} (root mean square), and there is a pattern in it: "
     "either the noise is not independent from sample to sample, or the law does not tell all.",
     "Was es von den Messwerten übrig lässt, ist {rms} (Effektivwert), und darin ist ein Muster: entweder "
     "ist das Rauschen nicht von Wert zu Wert unabhängig, oder das Gesetz sagt nicht alles."},
    {"report_rounding", clause,
     "What it leaves of the measured values is {rms} (root mean square), no more than rounding them to "
     "steps of {step:.3g}{unit: } makes. Rounding leaves a pattern of its own.",
     "Was es von den Messwerten übrig lässt, ist {rms} (Effektivwert), nicht mehr, als Runden auf Schritte "
     "von {step:.3g}{unit: } ausmacht. Runden hinterlässt ein eigenes Muster."},
    {"report_mostly_rounding", clause,
     "What it leaves of the measured values is {rms} (root mean square), most of it from rounding them to "
     "steps of {step:.3g}{unit: }. Rounding leaves a pattern of its own.",
     "Was es von den Messwerten übrig lässt, ist {rms} (Effektivwert), das meiste davon vom Runden auf "
     "Schritte von {step:.3g}{unit: }. Runden hinterlässt ein eigenes Muster."},
    {"report_how", clause,
     "The law was integrated and fitted to all samples in use by least squares, its start included{several}.",
     "Das Gesetz wurde integriert und mit seinem Anfang durch kleinste Quadrate an alle benutzten Messwerte "
     "angepasst{several}."},
    {"report_of_several_laws", clause,
     "; of several laws the one with the lowest Bayesian information criterion (BIC) is taken, a simpler "
     "one where the difference is small",
     "; von mehreren Gesetzen gilt das mit dem kleinsten Bayesschen Informationskriterium (BIC), bei "
     "kleinem Abstand ein einfacheres"},
    {"report_table", clause,
     "What the law says. ± is one standard uncertainty; the interval holds the true value in 95 % of such "
     "recordings, if the law is right.",
     "Was das Gesetz sagt. ± ist eine Standardunsicherheit; das Intervall enthält den wahren Wert in 95 % "
     "solcher Aufnahmen, falls das Gesetz stimmt."},
    {"report_table_covers_laws", clause,
     " Those of frequency, decay rate and what follows from them also cover how far other laws that fit "
     "nearly as well differ.",
     " Die von Frequenz, Abklingrate und was daraus folgt enthalten auch, wie weit andere, fast so gut "
     "passende Gesetze abweichen."},
    {"report_table_of_no_law", clause,
     "What the chosen law gives, without uncertainties, for no law that was tried describes this recording.",
     "Was das gewählte Gesetz ergibt, ohne Unsicherheiten, denn keines der geprüften beschreibt diese "
     "Aufnahme."},
    {"report_few_degrees", clause,
     "The 95 % intervals are wider than ± suggests, those of: {names:and}. What disturbs them is slow, so "
     "the record holds few independent values of it, or ± stands at a bound.",
     "Das 95-%-Intervall ist weiter, als ± vermuten lässt, bei: {names:and}. Was hier stört, ist langsam, "
     "und die Aufnahme enthält davon nur wenige unabhängige Werte, oder der Wert liegt an einer Grenze."},
    {"report_few_degrees_of_most", clause,
     "Most of the 95 % intervals are wider than ± suggests: what disturbs the motion is slow, so the record "
     "holds few independent values of it. They count, not ±.",
     "Die meisten 95-%-Intervalle sind weiter, als ± vermuten lässt: was die Bewegung stört, ist langsam, "
     "und die Aufnahme enthält davon nur wenige unabhängige Werte. Sie zählen, nicht ±."},
    {"report_energy_beside_amplitude", clause,
     "Damping ratio and quality factor are those of the linear damper that takes as much energy in a cycle; "
     "the decrement is that of the amplitude. Under this law the two are not tied as they are under viscous "
     "damping and a linear spring.",
     "Dämpfungsgrad und Güte sind die des linearen Dämpfers, der je Periode ebenso viel Energie nimmt; das "
     "Dekrement ist das der Amplitude. Nach diesem Gesetz hängen sie nicht so zusammen wie bei viskoser "
     "Dämpfung und linearer Feder."},
    {"report_quantity", clause, "quantity", "Größe"},
    {"report_term", clause, "term of the law", "Term des Gesetzes"},
    {"disc_diameter", clause, "disc's diameter", "Durchmesser der Scheibe"},
    {"report_small_swings", clause, "angular frequency of small swings *ω*_{{0}}",
     "Kreisfrequenz kleiner Schwingungen *ω*_{{0}}"},
    {"report_drive_angular_frequency", clause, "angular frequency of the drive",
     "Kreisfrequenz des Antriebs"},
    {"report_drag_per_mass", clause, "drag per mass *d*/*m*", "Luftwiderstand je Masse *d*/*m*"},
    {"report_drag_per_inertia", clause, "drag per moment of inertia *d*/*I*",
     "Luftwiderstand je Trägheitsmoment *d*/*I*"},
    {"report_damping_constant", clause, "damping constant *c*", "Dämpfungskonstante *c*"},
    {"report_swings_title", clause, "The first swings, measured and by the law",
     "Die ersten Schwingungen, gemessen und nach dem Gesetz"},
    {"report_swings", clause, "The first swings: measured, and by the law {law}.",
     "Die ersten Schwingungen: gemessen, und nach dem Gesetz {law}."},
    {"report_law_curve", clause, "law", "Gesetz"},
    {"report_residual_title", clause, "What the law leaves", "Was das Gesetz übrig lässt"},
    {"report_residual_caption", clause, "Measured minus fitted; root mean square {rms}.",
     "Messung minus Anpassung; Effektivwert {rms}."},
    {"report_residual", clause, "residual", "Residuum"},

    // How it dies down.
    {"report_dies_down", clause, "How the swing dies down", "Wie die Schwingung abklingt"},
    {"report_grows", clause, "How the swing grows", "Wie die Schwingung wächst"},
    {"report_segments", clause, "One decay rate for each part of the recording, fitted by itself.",
     "Eine Abklingrate für jeden Teil der Aufnahme, jeder für sich angepasst."},
    {"report_from", clause, "from", "von"},
    {"report_to", clause, "to", "bis"},
    {"report_decay_title", clause, "Decay rate against amplitude", "Abklingrate gegen Amplitude"},
    {"report_decay_caption", clause,
     "The decay rate of {stretches} stretches of the recording, each by a fit of its own (± one standard "
     "error), against the amplitude; the line is the law's.",
     "Die Abklingrate von {stretches} Abschnitten der Aufnahme, jede durch eine eigene Anpassung (± ein "
     "Standardfehler), gegen die Amplitude; die Linie ist die des Gesetzes."},
    {"report_frequencies_title", clause, "Frequency against amplitude", "Frequenz gegen Amplitude"},
    {"report_frequencies_caption", clause,
     "The frequency of the same {stretches} stretches (± one standard error); the line is the law's.",
     "Die Frequenz derselben {stretches} Abschnitte (± ein Standardfehler); die Linie ist die des Gesetzes."},
    {"report_frequency_axis", clause, "frequency (Hz)", "Frequenz (Hz)"},
    {"report_amplitude", clause, "amplitude", "Amplitude"},
    {"report_rate_axis", clause, "decay rate (1/s)", "Abklingrate (1/s)"},
    {"report_compared_title", clause, "Measured, and simulated with one decay rate and by the law",
     "Gemessen, und simuliert mit einer Abklingrate und nach dem Gesetz"},
    {"report_compared_two", clause,
     "The measured motion, and the envelopes of two simulations: one constant decay rate leaves {one} (root "
     "mean square), the law {law}.",
     "Die gemessene Bewegung und die Hüllkurven zweier Simulationen: eine feste Abklingrate lässt {one} "
     "übrig (Effektivwert), das Gesetz {law}."},
    {"report_compared_one", clause,
     "The measured motion, and the envelope of a simulation with one constant decay rate; it leaves {one} "
     "(root mean square).",
     "Die gemessene Bewegung und die Hüllkurve einer Simulation mit einer festen Abklingrate; sie lässt "
     "{one} übrig (Effektivwert)."},

    // Spring constant and Reynolds number.
    {"report_stiffness", clause, "How stiff the spring is", "Wie steif die Feder ist"},
    {"report_stiffness_is", clause,
     "From *ω*_{{0}} = {w}, the angular frequency of small swings without damping, and the mass of {mass}, "
     "*k* = *m ω*_{{0}}^{{2}} = {stiffness}; 95 %: {interval}.",
     "Aus *ω*_{{0}} = {w}, der Kreisfrequenz kleiner Schwingungen ohne Dämpfung, und der Masse von {mass} "
     "folgt *k* = *m ω*_{{0}}^{{2}} = {stiffness}; 95 %: {interval}."},
    {"report_without_spring_mass", clause,
     "The spring's own mass, a third of which moves along, is not counted ({--spring-mass}): with it the "
     "spring constant is larger.",
     "Die eigene Masse der Feder, von der ein Drittel mitschwingt, ist nicht gezählt ({--spring-mass}): mit "
     "ihr ist die Federkonstante größer."},
    {"report_stiffness_with_spring", clause,
     "From *ω*_{{0}} = {w}, the angular frequency of small swings without damping, the mass of {mass} and a "
     "third of the spring's {spring}, *k* = (*m* + *m*_{{s}}/3) *ω*_{{0}}^{{2}} = {stiffness}; 95 %: "
     "{interval}.",
     "Aus *ω*_{{0}} = {w}, der Kreisfrequenz kleiner Schwingungen ohne Dämpfung, der Masse von {mass} und "
     "einem Drittel der {spring} der Feder folgt *k* = (*m* + *m*_{{s}}/3) *ω*_{{0}}^{{2}} = {stiffness}; 95 "
     "%: {interval}."},
    {"report_small_swings_stiffness", clause,
     "That is its stiffness for small swings, as this law has them; the frequency of {frequency} is that of "
     "swings of {amplitude}, and does not give the same *k*.",
     "Das ist ihre Steife für kleine Schwingungen nach diesem Gesetz; die Frequenz von {frequency} ist die "
     "von Schwingungen von {amplitude} und ergibt nicht dasselbe *k*."},
    {"report_not_known", clause, "not known", "nicht bekannt"},
    {"report_other_stiffness", clause,
     "Another law, {law}, which leaves {rms} (rms) instead of {own}, gives {stiffness}.",
     "Ein anderes Gesetz, {law}, das {rms} statt {own} (Effektivwert) übrig lässt, ergibt {stiffness}."},
    {"report_without_error", clause, "Your {quantity} has no ±, so its part is not in the uncertainty.",
     "{quantity}: ohne ± angegeben; dieser Teil fehlt in der Unsicherheit."},
    {"report_most_from", clause, "{share} % of its variance comes from the {quantity}.",
     "{share} % der Varianz stammen von: {quantity}."},
    {"report_held_title", clause, "The spring constant from masses at rest: {file}",
     "Die Federkonstante aus ruhenden Massen: {file}"},
    {"report_held", clause,
     "{file}: {count} masses held at rest. From how far each stretches the spring, the spring constant is "
     "{stiffness}; 95 %: {interval}.",
     "{file}: {count} ruhende Massen. Daraus, wie weit jede die Feder dehnt, folgt die Federkonstante "
     "{stiffness}; 95 %: {interval}."},
    {"report_holds", clause,
     "{count} masses hung at rest, one after the other. Each position is the mean of its hold, without "
     "stray samples; its uncertainty allows for correlated samples, drift and rounding.",
     "{count} Massen hingen nacheinander in Ruhe. Jede Ruhelage ist das Mittel ihrer Messwerte, ohne "
     "Ausreißer; ihre Unsicherheit berücksichtigt korrelierte Messwerte, Wandern und Runden."},
    {"report_holds_table", clause,
     "The masses and where they hung, with standard uncertainties, and how far from the line that is.",
     "Die Massen und wo sie hingen, mit Standardunsicherheiten, und wie weit das von der Geraden entfernt "
     "ist."},
    {"report_mass", clause, "mass", "Masse"},
    {"report_mass_axis", clause, "mass *m* (g)", "Masse *m* (g)"},
    {"report_rest", clause, "position at rest", "Ruhelage"},
    {"report_off_line", clause, "measured minus line", "gemessen minus Gerade"},
    {"report_line", clause, "straight line", "Gerade"},
    {"report_held_stiffness", clause,
     "Each mass stretches the spring by *m g*/*k*: against the mass the position is a straight line of "
     "slope *g*/*k* (or −*g*/*k*, seen from below), whatever the spring's own mass. With *g* = {gravity}, "
     "*k* = {stiffness}; 95 %: {interval}.",
     "Jede Masse dehnt die Feder um *m g*/*k*: gegen die Masse ist der Ort eine Gerade der Steigung *g*/*k* "
     "(oder −*g*/*k*, von unten gesehen), unabhängig von der Masse der Feder. Mit *g* = {gravity} ist *k* = "
     "{stiffness}; 95 %: {interval}."},
    {"report_gravity_assumed", clause,
     "This *g* is the standard value, without an uncertainty ({--gravity}): between pole and equator it "
     "varies by 0.5 %.",
     "Dieses *g* ist der Normwert, ohne Unsicherheit ({--gravity}): zwischen Pol und Äquator ändert es sich "
     "um 0,5 %."},
    {"report_masses_without_error", clause,
     "The masses have no ±, so their part is not in the uncertainty beyond what shows as scatter.",
     "Die Massen sind ohne ± angegeben; ihr Anteil steckt in der Unsicherheit nur, soweit er als Streuung "
     "sichtbar ist."},
    {"report_held_line_title", clause, "Position at rest against mass", "Ruhelage gegen Masse"},
    {"report_held_line", clause, "The positions at rest, and the line through them.",
     "Die Ruhelagen und die Gerade durch sie."},
    {"report_held_residual_title", clause, "What the line leaves", "Was die Gerade übrig lässt"},
    {"report_held_residual", clause,
     "Measured minus line; bars: the standard uncertainties of the positions, with the scatter that was "
     "added.",
     "Gemessen minus Gerade; Balken: die Standardunsicherheiten der Ruhelagen mit der zugeschlagenen "
     "Streuung."},
    {"report_budget", clause, "Where the uncertainty of the spring constant comes from.",
     "Woher die Unsicherheit der Federkonstante kommt."},
    {"report_from_what", clause, "from", "aus"},
    {"report_its_part", clause, "part of the standard uncertainty", "Teil der Standardunsicherheit"},
    {"report_share", clause, "share of the variance", "Anteil an der Varianz"},
    {"report_flow", clause, "The air around the disc", "Die Luft um die Scheibe"},
    {"report_reynolds", clause,
     "The Reynolds number Re = *v D*/*ν* is {largest} at its largest, at {t}; in the last whole half second "
     "it reaches {last}.",
     "Die Reynolds-Zahl Re = *v D*/*ν* ist höchstens {largest}, bei {t}; in der letzten ganzen halben "
     "Sekunde erreicht sie {last}."},
    {"report_not_stokes", clause,
     "A drag in proportion to the velocity (Stokes) needs Re well below 1: at its fastest, no swing of this "
     "recording is so slow.",
     "Ein Widerstand proportional zur Geschwindigkeit (Stokes) braucht ein Re weit unter 1: an der "
     "schnellsten Stelle ist es bei keiner Schwingung dieser Aufnahme so klein."},
    {"report_disc", clause, "The disc has a diameter *D* of {diameter}.",
     "Die Scheibe hat einen Durchmesser *D* von {diameter}."},
    {"report_drag_coefficient", clause,
     "The drag coefficient is 2*d*/(*ρ A*) with the disc's area *A* and air of *ρ* = {density}.",
     "Der Widerstandsbeiwert ist 2*d*/(*ρ A*) mit der Fläche *A* der Scheibe und Luft von *ρ* = {density}."},
    {"report_air", clause, "The air has {temperature}, its kinematic viscosity *ν* is {viscosity}.",
     "Die Luft hat {temperature}, ihre kinematische Viskosität *ν* ist {viscosity}."},
    {"report_air_assumed", clause,
     "The air is taken to have {temperature}, its kinematic viscosity *ν* is then {viscosity} "
     "({--temperature}).",
     "Für die Luft sind {temperature} angenommen, ihre kinematische Viskosität *ν* ist dann {viscosity} "
     "({--temperature})."},
    {"report_reynolds_title", clause, "Reynolds number in windows of half a second",
     "Reynolds-Zahl in Fenstern von einer halben Sekunde"},
    {"report_reynolds_caption", clause,
     "The largest Reynolds number in each half second, from the fitted velocity and the disc's diameter.",
     "Die größte Reynolds-Zahl in jeder halben Sekunde, aus der angepassten Geschwindigkeit und dem "
     "Durchmesser der Scheibe."},
    {"report_reynolds_axis", clause, "Reynolds number Re", "Reynolds-Zahl Re"},

    // What two methods make of the law.
    {"report_methods", clause, "What forward Euler and Euler-Cromer make of this law",
     "Was Euler vorwärts und Euler-Cromer aus diesem Gesetz machen"},
    {"report_methods_text", clause,
     "The law, from the same start, by two methods with steps of {step}, about {steps:.0f} in a period, "
     "beside {reference}.",
     "Das Gesetz, vom selben Anfang aus, nach zwei Verfahren mit Schritten von {step}, etwa {steps:.0f} in "
     "einer Periode, neben {reference}."},
    {"report_leaves", clause,
     "They end at {t}, before forward Euler goes to where the spring gives way, or {times:g} times as far "
     "as the law.",
     "Sie enden bei {t}, bevor das Euler-Verfahren dorthin gelangt, wo die Feder nachgibt, oder "
     "{times:g}-mal so weit wie das Gesetz."},
    {"report_leaves_over_top", clause, "They end at {t}, before forward Euler swings over the top.",
     "Sie enden bei {t}, bevor das Euler-Verfahren sich überschlägt."},
    {"report_leaves_far", clause,
     "They end at {t}, before forward Euler goes {times:g} times as far as the law.",
     "Sie enden bei {t}, bevor das Euler-Verfahren {times:g}-mal so weit ausschlägt wie das Gesetz."},
    {"report_closed_form", clause, "the closed form", "der geschlossenen Form"},
    {"report_dormand_prince", clause, "the method of Dormand and Prince with a tolerance of 10^{{−10}}",
     "dem Verfahren von Dormand und Prince mit einer Toleranz von 10^{{−10}}"},
    {"report_method_does", clause, "It {what}.", "Es {what}."},
    {"report_energy_grew", clause,
     "After {t} its energy is {ratio} times the energy at the start; by the law it would be {exact} times "
     "that.",
     "Nach {t} ist seine Energie das {ratio}-Fache der Anfangsenergie; nach dem Gesetz wäre sie das "
     "{exact}-Fache."},
    {"report_exact", clause, "exact", "exakt"},
    {"report_position_title", clause, "Position by both methods", "Ort nach beiden Verfahren"},
    {"report_angle_title", clause, "Angle by both methods", "Winkel nach beiden Verfahren"},
    {"report_velocity_title", clause, "Velocity by both methods", "Geschwindigkeit nach beiden Verfahren"},
    {"report_by_both", clause, "By both methods, steps of {step}.",
     "Nach beiden Verfahren, Schritte von {step}."},
    {"report_measured_and_by_both", clause, "As measured and by both methods, steps of {step}.",
     "Gemessen und nach beiden Verfahren, Schritte von {step}."},
    {"report_portrait_title", clause, "Velocity against position by both methods",
     "Geschwindigkeit gegen Ort nach beiden Verfahren"},
    {"report_portrait_caption", clause, "Phase portrait of the same runs.", "Phasenbild derselben Läufe."},
    {"report_energy_title", clause, "Energy by both methods", "Energie nach beiden Verfahren"},
    {"report_energy_caption", clause, "The energy by both methods, steps of {step}.",
     "Die Energie nach beiden Verfahren, Schritte von {step}."},
    {"report_energy", clause, "energy *E*", "Energie *E*"},
    {"report_energy_per_mass", clause, "energy / inertia", "Energie / Trägheit"},
    {"report_phase_title", clause, "Phase of both methods less the exact one",
     "Phase beider Verfahren weniger der exakten"},
    {"report_phase_caption", clause,
     "By how much the phase of both methods runs ahead of the exact motion, steps of {step}.",
     "Um wie viel die Phase beider Verfahren der exakten Bewegung vorausläuft, Schritte von {step}."},
    {"report_phase_error", clause, "phase error (rad)", "Phasenfehler (rad)"},

    // Under other frequencies.
    {"report_resonance", clause, "The resonance of this law", "Die Resonanz dieses Gesetzes"},
    {"report_resonance_text", clause,
     "The drive of this recording has {drive}; the oscillator's own frequency is {natural}. The figures "
     "show the steady motion of the law under a drive of the same strength at other frequencies.",
     "Der Antrieb dieser Aufnahme hat {drive}; die eigene Frequenz des Schwingers ist {natural}. Die "
     "Abbildungen zeigen die eingeschwungene Bewegung des Gesetzes unter einem gleich starken Antrieb bei "
     "anderen Frequenzen."},
    {"report_resonance_of_rivals", clause,
     "Other laws fit as well and may give the peak another height; the height in the figure holds only if "
     "this law is right.",
     "Andere Gesetze passen ebenso gut und können dem Gipfel eine andere Höhe geben; die Höhe in der "
     "Abbildung gilt nur, wenn dieses Gesetz stimmt."},
    {"report_resonance_reach", clause,
     "The law was found in a motion whose steady amplitude is {amplitude}; far above it the figures are "
     "untested.",
     "Gefunden ist das Gesetz an einer Bewegung, die mit {amplitude} Amplitude eingeschwungen ist; weit "
     "darüber sind die Abbildungen nicht geprüft."},
    {"report_resonance_title", clause, "Amplitude against drive frequency",
     "Amplitude gegen Frequenz des Antriebs"},
    {"report_resonance_caption", clause, "The amplitude of the steady motion, by the law.",
     "Die Amplitude der eingeschwungenen Bewegung nach dem Gesetz."},
    {"report_drive_axis", clause, "drive frequency (Hz)", "Frequenz des Antriebs (Hz)"},
    {"report_lag_title", clause, "Phase lag against drive frequency",
     "Phasenverzug gegen Frequenz des Antriebs"},
    {"report_lag_caption", clause, "The lag of the steady motion behind the drive, by the law.",
     "Der Verzug der eingeschwungenen Bewegung hinter dem Antrieb nach dem Gesetz."},
    {"report_lag_axis", clause, "phase lag (rad)", "Phasenverzug (rad)"},

    // What could not be told.
    {"report_not_told", clause, "What to keep in mind, and what could not be told",
     "Was zu bedenken ist, und was sich nicht sagen lässt"},
    {"report_sentence", clause, "{what:A}.", "{what:A}."},
    {"report_give_mass", clause, "No spring constant: it follows with the mass ({--mass}).",
     "Keine Federkonstante: sie folgt mit der Masse ({--mass})."},
    {"report_give_disc", clause,
     "No Reynolds number: it follows with the diameter of a disc ({--disc-diameter}).",
     "Keine Reynolds-Zahl: sie folgt mit dem Durchmesser einer Scheibe ({--disc-diameter})."},

    // The words of a page.
    {"page_figure", clause, "Figure {number}", "Abbildung {number}"},
    {"page_table", clause, "Table {number}", "Tabelle {number}"},
    {"page_skip", clause, "Skip to the content", "Zum Inhalt"},
};

}  // namespace

const std::span<const Entry> words_of_report = entries;

}  // namespace cromer::core
