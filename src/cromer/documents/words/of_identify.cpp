#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // The parameters that are fitted, by their names.
    {"angular_frequency", clause, "angular frequency", "Kreisfrequenz"},
    {"decay_rate", clause, "decay rate", "Abklingrate"},
    {"viscous_part", clause, "viscous part of the decay rate", "viskoser Anteil der Abklingrate"},
    {"drag", clause, "drag", "Luftwiderstand"},
    {"friction", clause, "friction", "trockene Reibung"},
    {"cubic", clause, "cubic", "kubische Feder"},
    {"quadratic", clause, "quadratic", "quadratische Feder"},
    {"odd_quadratic", clause, "odd quadratic", "ungerade quadratische Feder"},
    {"quintic", clause, "quintic", "Feder fünften Grades"},
    {"van_der_pol", clause, "van der pol", "Van-der-Pol-Dämpfung"},
    {"hysteresis_stiffness", clause, "hysteresis stiffness", "hysteretische Federkonstante"},
    {"hysteresis_beta", clause, "hysteresis beta", "Hysteresebeiwert beta"},
    {"hysteresis_gamma", clause, "hysteresis gamma", "Hysteresebeiwert gamma"},
    {"force_gain", clause, "force gain", "Verstärkung der Kraft"},
    {"force_offset", clause, "force offset", "Nullpunkt der Kraft"},
    {"drive_cosine", clause, "drive cosine", "Kosinus des Antriebs"},
    {"drive_sine", clause, "drive sine", "Sinus des Antriebs"},
    {"drive_frequency", clause, "drive frequency", "Frequenz des Antriebs"},
    {"drive_amplitude", clause, "drive amplitude", "Amplitude des Antriebs"},
    {"drive_phase", clause, "drive phase", "Phase des Antriebs"},
    {"equilibrium", clause, "equilibrium", "Ruhelage"},
    {"position", clause, "position", "Ort"},
    {"velocity", clause, "velocity", "Geschwindigkeit"},
    {"viscous_damping", clause, "viscous damping", "viskose Dämpfung"},
    {"pendulum", clause, "pendulum", "Pendel"},
    {"hysteresis", clause, "hysteresis", "Hysterese"},
    {"dry_friction", clause, "dry friction", "trockene Reibung"},

    // Why a record is not fitted.
    {"no_spring", error,
     "a body without a spring does not swing: only under a recorded force can its law be found",
     "ein Körper ohne Feder schwingt nicht: nur unter einer aufgenommenen Kraft lässt sich sein Gesetz "
     "finden"},
    {"too_few_samples", error,
     "{samples:sample is|samples are} too few: a fit of the law {law} needs at least {fewest}",
     "{samples:Messwert ist|Messwerte sind} zu wenige: das Gesetz {law} braucht mindestens {fewest}"},
    {"nothing_moves", error, "all values are the same: nothing moves",
     "alle Werte sind gleich: nichts bewegt sich"},
    {"overdamped", error,
     "the motion comes to rest without an oscillation that can be seen: it is overdamped or nearly so, or "
     "nothing pulls it back",
     "die Bewegung kommt zur Ruhe, ohne dass ein Schwingen zu sehen ist: sie ist überdämpft oder beinahe, "
     "oder nichts zieht sie zurück"},
    {"ends_before_an_oscillation", error,
     "the record ends before an oscillation can be seen, if there is one: a fit needs at least 1.5 periods",
     "die Aufnahme endet, bevor eine Schwingung zu sehen ist, falls es eine gibt: eine Anpassung braucht "
     "mindestens 1,5 Perioden"},
    {"too_few_periods", error,
     "the record holds {periods:.2g} periods of {period:.3g} s: a fit needs at least 1.5",
     "die Aufnahme hat {periods:.2g} Perioden von {period:.3g} s: gebraucht werden mindestens 1,5"},
    {"too_few_levels", error,
     "the values take only {levels:.0f} levels, {resolution:.3g} apart: the resolution is too coarse for a "
     "motion as small as this",
     "die Werte haben nur {levels:.0f} Stufen im Abstand {resolution:.3g}: die Auflösung ist zu grob für "
     "eine so kleine Bewegung"},
    {"too_noisy", error, "too noisy: a sinusoid accounts for only {percent:.1f} % of the variance",
     "zu viel Rauschen: eine Sinusschwingung erklärt nur {percent:.1f} % der Varianz"},
    {"noise_could_do_as_much", error,
     "no oscillation found: the best decaying sinusoid accounts for {percent:.1f} % of the variance, and "
     "noise like the residual could do as much; choose the part that oscillates with {|{--from} and "
     "{--to}|the handles}, or another {|{--column}|column}",
     "keine Schwingung gefunden: die beste abklingende Sinusschwingung erklärt {percent:.1f} % der Varianz, "
     "was Rauschen auch könnte; bitte mit {|{--from} und {--to}|den Griffen} den Teil wählen, der schwingt, "
     "oder {|mit {--column} eine|eine} andere Spalte"},
    {"no_single_decay", error,
     "no single decaying swing found: the best one accounts for {percent:.1f} % of the variance, and what "
     "it leaves is too large to find a law beside it; choose the part that swings freely with {|{--from} "
     "and {--to}|the handles}, or another {|{--column}|column}",
     "keine einzelne abklingende Schwingung gefunden: die beste erklärt {percent:.1f} % der Varianz, und "
     "was sie übrig lässt, ist zu viel, um daneben ein Gesetz zu finden; bitte mit {|{--from} und "
     "{--to}|den Griffen} den Teil wählen, der frei schwingt, oder {|mit {--column} eine|eine} andere "
     "Spalte"},
    {"tops_cut_off", error,
     "the motion's peaks are cut off at the same value again and again: the sensor was out of its range; "
     "choose the later part with {|{--from}|the handles}",
     "die Gipfel der Bewegung sind immer wieder beim selben Wert abgeschnitten: der Sensor war außerhalb "
     "seines Bereichs; bitte den späteren Teil mit {|{--from}|den Griffen} wählen"},
    {"no_line", error, "no oscillation found: the spectrum has no line",
     "keine Schwingung gefunden: das Spektrum hat keine Linie"},
    {"no_resonance", error, "no oscillation found: the force explains no resonance",
     "keine Schwingung gefunden: die Kraft erklärt keine Resonanz"},
    {"force_explains_too_little", error,
     "the force accounts for only {percent:.1f} % of the motion's variance",
     "die Kraft erklärt nur {percent:.1f} % der Varianz der Bewegung"},
    {"oscillations_explain_too_little", error,
     "a decaying and a steady oscillation account for only {percent:.1f} % of the variance",
     "eine abklingende und eine gleichbleibende Schwingung erklären nur {percent:.1f} % der Varianz"},
    {"only_a_harmonic", error,
     "a steady oscillation at {frequency:.6g} Hz and its harmonic of order {order:.0f}, which does not "
     "decay: rounding or a sensor that is not linear makes such a line, and the body's own swing is not seen",
     "eine gleichbleibende Schwingung bei {frequency:.6g} Hz und ihre {order:.0f}. Harmonische, die nicht "
     "abklingt: Rundung oder ein nicht linearer Sensor macht eine solche Linie, eine eigene Schwingung des "
     "Körpers ist nicht zu sehen"},
    {"frequency_hardly_known", error, "too noisy: the frequency is known only to {percent:.0f} %",
     "zu viel Rauschen: die Frequenz ist nur auf {percent:.0f} % bekannt"},
    {"frequency_unknown", error, "the law {law} fits so badly that the frequency is unknown",
     "das Gesetz {law} passt so schlecht, dass die Frequenz nicht bekannt ist"},

    // Why a fit has not converged.
    {"fit_not_settled", error, "the fit has not converged after {iterations} iterations",
     "die Anpassung ist nach {iterations} Schritten nicht konvergiert"},
    {"motion_runs_away", error, "this law's motion runs away from the recorded one",
     "die Bewegung dieses Gesetzes läuft der aufgenommenen davon"},
    {"law_undetermined", error, "the record does not determine this law: {what}",
     "die Aufnahme legt dieses Gesetz nicht fest: {what}"},
    {"terms_not_told_apart", clause, "its terms cannot be told apart",
     "seine Glieder lassen sich nicht trennen"},
    {"parameter_not_shown", clause, "the record does not show {parameters}",
     "sie zeigt nichts von {parameters}"},
    {"only_combination_known", clause, "only a combination of {parameters} is known",
     "nur eine Kombination von {parameters} ist bekannt"},
    {"only_ratio_known", clause, "only the ratio of {one} and {other} is known, {ratio:.6g} ± {error:.2g}",
     "nur das Verhältnis von {one} und {other} ist bekannt, {ratio:.6g} ± {error:.2g}"},
    {"and_also", clause, "{one} and {other}", "{one} und {other}"},
    {"and_the", clause, "{one} and the {other}", "{one} und {other}"},
    {"interrupted", clause, "interrupted", "abgebrochen"},
    {"too_many_steps", clause,
     "these laws need more integration steps than a record of this length is worth, as with hysteresis or "
     "where noise looks like a fast swing: stopped",
     "diese Gesetze brauchen mehr Rechenschritte, als eine Messung dieser Länge wert ist, wie bei Hysterese "
     "oder bei Rauschen, das nach schnellem Schwingen aussieht: beendet"},
    {"ended_before_fit_was_done", error, "{why} before the fit was done",
     "{why}, bevor die Anpassung fertig war"},
    {"ended_before_all_laws", error, "{why} before all laws were tried",
     "{why}, bevor alle Gesetze versucht waren"},
    {"ended_before_these_laws", error,
     "{why} before all laws were tried: {law} is only the best of {laws}; not compared yet: {missing}",
     "{why}, bevor alle Gesetze versucht waren: {law} ist nur das beste von {laws}; noch nicht verglichen: "
     "{missing}"},

    // How far a fit's numbers go.
    {"dampings_not_told_apart", worth_knowing,
     "the damping terms of {law} cannot be told apart here: their sum is known, {sum}, but not its parts, "
     "and the interval of the {parameters} is cut at its bound 0",
     "die Dämpfungsglieder von {law} lassen sich hier nicht trennen: bekannt ist ihre Summe, {sum}, nicht "
     "ihre Teile, und der Vertrauensbereich ist an der Grenze 0 abgeschnitten ({parameters})"},
    {"mean_decay_rate", clause, "decay rate {rate:n} at the swing's rms amplitude, {amplitude:.3g}{unit}",
     "Abklingrate {rate:n} bei der quadratisch gemittelten Amplitude der Schwingung, {amplitude:.3g}{unit}"},
    {"parameter_on_bound", worth_knowing, "the {parameter} is on its bound 0: the record shows no {damping}",
     "{parameter} liegt an der Grenze 0: die Aufnahme zeigt nichts davon ({damping})"},
    {"interval_cut_at_bound", worth_knowing,
     "the 95 % interval of the {parameter} is cut at its bound 0: the record does not show that there is "
     "any {damping}",
     "der 95-%-Bereich ist an der Grenze 0 abgeschnitten ({parameter}): die Aufnahme zeigt nicht, ob es das "
     "gibt ({damping})"},
    {"periods_in_gaps_unsure", wrong_if_ignored,
     "{rival:.5g} rad/s fits nearly as well as {frequency:.5g} rad/s: how many periods passed in the gaps "
     "is not certain",
     "{rival:.5g} rad/s passt fast so gut wie {frequency:.5g} rad/s: wie viele Perioden in den Lücken "
     "vergingen, ist nicht sicher"},
    {"frequency_changes", worth_knowing,
     "the frequency changes along the record: one decaying sinusoid accounts for only {percent:.0f} % of "
     "the variance",
     "die Frequenz ändert sich im Lauf der Aufnahme: eine abklingende Sinusschwingung erklärt nur "
     "{percent:.0f} % der Varianz"},
    {"half_swings_before_rest_unsure", worth_knowing,
     "the record does not tell after how many half swings the motion came to rest: another count has a "
     "probability of {percent:.0f} %, and the intervals are widened for it",
     "die Aufnahme sagt nicht, nach wie vielen halben Schwingungen die Bewegung zur Ruhe kam: eine andere "
     "Zahl ist zu {percent:.0f} % wahrscheinlich, die Bereiche sind dafür geweitet"},
    {"residuals_correlated", clause, "the residuals are correlated ({correlation:.3f} from sample to sample)",
     "die Residuen sind korreliert ({correlation:.3f} von Messwert zu Messwert)"},
    {"residuals_correlated_apart", clause,
     "the residuals are correlated ({correlation:.3f} at a lag of {samples} samples)",
     "die Residuen sind korreliert ({correlation:.3f} im Abstand von {samples} Messwerten)"},
    {"noise_is_uneven", detail,
     "the noise is uneven, up to {times:.2g} times as large at one time as at another: the uncertainties "
     "are those of such noise",
     "das Rauschen ist ungleich, bis zu {times:.2g}-mal so groß zu einer Zeit wie zu einer anderen: die "
     "Unsicherheiten sind die von solchem Rauschen"},
    {"uncertainties_hardly_widened", detail,
     "{correlated}, but not at the swing's frequency: the uncertainties of frequency and decay are hardly "
     "widened",
     "{correlated}, doch nicht bei der Frequenz der Schwingung: die Unsicherheiten von Frequenz und "
     "Abklingrate sind kaum geweitet"},
    {"uncertainties_widened", detail,
     "{correlated}: the uncertainties are widened to those of {independent_samples:.0f} independent samples",
     "{correlated}: die Unsicherheiten sind auf die von {independent_samples:.0f} unabhängigen Messwerte "
     "geweitet"},

    // The choice of a law.
    {"laws_compared_on_a_part", detail,
     "the laws were compared on {compared} of the {samples} samples, one in {stride} up to {time:.6g} s; "
     "the one chosen is fitted to all",
     "die Gesetze wurden an {compared} von {samples} Messwerten verglichen, jedem {stride}. bis {time:.6g} "
     "s; das gewählte ist an alle angepasst"},
    {"laws_compared_on_the_first", detail,
     "the laws were compared on the first {compared} of {samples} samples; the one chosen is fitted to all",
     "die Gesetze wurden an den ersten {compared} von {samples} Messwerten verglichen; das gewählte ist an "
     "alle angepasst"},
    {"rival_laws", worth_knowing,
     "this record cannot tell {law} from {rivals:or}: the uncertainties of single terms hold only if {law} "
     "is right; those of frequency, decay rate and any spring constant also cover how far these laws differ. "
     "Known best, whichever of them is right: {known}",
     "diese Aufnahme kann {law} und {rivals:or} nicht trennen: die Unsicherheiten der einzelnen Terme gelten "
     "nur, wenn {law} stimmt; die von Frequenz, Abklingrate und etwaiger Federkonstante enthalten auch, "
     "wie weit diese Gesetze auseinanderliegen. Am besten bekannt, welches auch stimmt: {known}"},
    {"rival_laws_of_a_fed_swing", worth_knowing,
     "this record cannot tell {law} from {rivals:or}: the uncertainties of single terms hold only if {law} "
     "is right; those of what these laws have in common, as frequency, decay rate and a drive's force, also "
     "cover how far they differ",
     "diese Aufnahme kann {law} und {rivals:or} nicht trennen: die Unsicherheiten der einzelnen Terme gelten "
     "nur, wenn {law} stimmt; die dessen, was diese Gesetze gemeinsam haben, wie Frequenz, Abklingrate und "
     "die "
     "Kraft eines Antriebs, enthalten auch, wie weit sie auseinanderliegen"},
    {"law_with_coefficients", clause, "{law} ({coefficients:,})", "{law} ({coefficients:,})"},
    {"coefficient", clause, "{parameter} {value:n}", "{parameter} {value:n}"},

    // What speaks against a fit that converged.
    {"amplitude_rises", wrong_if_ignored,
     "the amplitude rises {how} between {from:.4g} and {to:.4g} s: something drives or pushes it, two "
     "motions beat, or negative damping feeds it, as in viscous+van-der-pol. The frequency may then be the "
     "drive's, and the stiffness not the spring's",
     "die Amplitude steigt zwischen {from:.4g} und {to:.4g} s ({how}): etwas treibt sie, zwei Bewegungen "
     "schweben, oder eine negative Dämpfung nährt sie wie in viscous+van-der-pol. Frequenz und "
     "Federkonstante sind dann vielleicht nicht die der Feder"},
    {"by_percent", clause, "by {percent:.0f} %", "um {percent:.0f} %"},
    {"so_many_fold", clause, "{times:.2g}-fold", "auf das {times:.2g}-Fache"},
    {"swing_does_not_die_down", wrong_if_ignored,
     "the swing does not die down over {periods:.0f} periods. If something drives it, the frequency is the "
     "drive's, and the stiffness that follows from it is not the spring's",
     "die Schwingung klingt über {periods:.0f} Perioden nicht ab. Treibt sie etwas an, so sind Frequenz und "
     "Federkonstante nicht die der Feder"},
    {"swing_keeps_itself", wrong_if_ignored,
     "the swing sustains itself over {periods:.0f} periods: negative damping feeds it as much as the rest "
     "takes. A steady drive looks much the same: then the frequency is the drive's, and the stiffness that "
     "follows from it is not the spring's",
     "die Schwingung hält sich über {periods:.0f} Perioden selbst: eine negative Dämpfung gibt ihr, was der "
     "Rest nimmt. Ein gleichmäßiger Antrieb sähe fast genauso aus: dann sind Frequenz und Federkonstante "
     "nicht die der Feder"},
    {"swing_grows_by_itself", wrong_if_ignored,
     "the swing grows by itself, at {rate:n}: negative damping feeds it. A drive in step with it may look "
     "the same: then the frequency is the drive's, and the stiffness that follows from it is not the "
     "spring's",
     "die Schwingung wächst von selbst, mit {rate:n}: eine negative Dämpfung nährt sie. Ein Antrieb im Takt "
     "kann genauso aussehen: dann ist die Frequenz die des Antriebs, und die Steifigkeit, die daraus folgt, "
     "nicht die der Feder"},
    {"amplitude_hardly_falls", wrong_if_ignored,
     "the amplitude falls by only {percent:.2g} % over {periods:.0f} periods (quality factor "
     "{quality_factor:.2g}): a drive that is not quite steady looks the same. If something drives it, the "
     "frequency is the drive's, and the stiffness that follows from it is not the spring's",
     "die Amplitude fällt über {periods:.0f} Perioden nur um {percent:.2g} % (Güte {quality_factor:.2g}): "
     "ein nicht ganz gleichmäßiger Antrieb sähe genauso aus. Treibt sie etwas an, so sind Frequenz und "
     "Federkonstante nicht die der Feder"},
    {"coarse_levels", wrong_if_ignored,
     "the values take only {levels:.0f} levels, {resolution:.3g}{unit: } apart: the frequency follows from "
     "when they change, but amplitude and decay rate hardly show, and their uncertainties cannot be "
     "trusted; measure with a finer resolution",
     "die Werte haben nur {levels:.0f} Stufen im Abstand {resolution:.3g}{unit: }: die Frequenz folgt "
     "daraus, wann sie wechseln, doch Amplitude und Abklingrate zeigen sich kaum, und ihren Unsicherheiten "
     "ist nicht zu trauen; bitte feiner messen"},
    {"law_does_not_describe", wrong_if_ignored, "{what}, and the uncertainties cannot be trusted",
     "{what}, und den Unsicherheiten ist nicht zu trauen"},
    {"no_law_describes", wrong_if_ignored, "{what}, and the uncertainties cannot be trusted",
     "{what}, und den Unsicherheiten ist nicht zu trauen"},
    {"law_leaves_much", clause,
     "the law {law} does not describe this recording: the residual is {times:.0f} times the noise from "
     "sample to sample",
     "das Gesetz {law} beschreibt diese Aufnahme nicht: die Reste sind das {times:.0f}-Fache des Rauschens "
     "von Messwert zu Messwert"},
    {"every_law_leaves_much", clause,
     "no law tried describes this recording: the residual is {times:.0f} times the noise from sample to "
     "sample",
     "kein versuchtes Gesetz beschreibt diese Aufnahme: die Reste sind das {times:.0f}-Fache des Rauschens "
     "von Messwert zu Messwert"},
    {"zero_drifts", wrong_if_ignored,
     "the zero drifts, by {drift:.3g}{unit: } over the record: remove the drift, or choose a shorter part",
     "der Nullpunkt wandert, um {drift:.3g}{unit: } in der ganzen Aufnahme: bitte die Drift abziehen oder "
     "einen kürzeren Teil wählen"},
    {"zero_jumps", wrong_if_ignored,
     "the zero jumps by {jump:.3g}{unit: } at {time:.4g} s: choose one side of it with {|{--from} and "
     "{--to}|the handles}",
     "der Nullpunkt springt um {jump:.3g}{unit: } bei {time:.4g} s: bitte mit {|{--from} und {--to}|den "
     "Griffen} eine Seite wählen"},
    {"swing_stops", wrong_if_ignored,
     "the swing stops between {from:.4g} and {to:.4g} s, from an amplitude of {amplitude:.3g}{unit: } to "
     "less than a tenth of it, as when a hand catches it: end before with {|{--to}|the handles}",
     "die Schwingung endet zwischen {from:.4g} und {to:.4g} s, von einer Amplitude von "
     "{amplitude:.3g}{unit: } auf weniger als ein Zehntel davon, als hielte eine Hand sie an: bitte mit "
     "{|{--to}|den Griffen} vorher enden"},
    {"law_over_a_stop", wrong_if_ignored,
     "the law {law} is fitted to the swing and to what follows the stop, and leaves {rms:.3g}{unit: } "
     "(rms): its uncertainties cannot be trusted",
     "das Gesetz {law} ist an die Schwingung und an das angepasst, was nach ihrem Ende kommt, und lässt "
     "{rms:.3g}{unit: } (Effektivwert) übrig: seinen Unsicherheiten ist nicht zu trauen"},
    {"few_samples_in_a_period", wrong_if_ignored,
     "only {samples:.2g} samples in a period: sampled at {rate:.4g} Hz, a swing of {slower:.5g} or "
     "{faster:.5g} Hz would look the same as this one of {frequency:.5g} Hz; sample faster if it may be one "
     "of them",
     "nur {samples:.2g} Messwerte je Periode: bei {rate:.4g} Hz sähe eine Schwingung von {slower:.5g} oder "
     "{faster:.5g} Hz genauso aus wie diese von {frequency:.5g} Hz; schneller messen, wenn es eine davon "
     "sein kann"},
    {"turns_over", wrong_if_ignored,
     "the angle goes through {turns:.2g} turns: the pendulum turns over, which is no swing",
     "der Winkel durchläuft {turns:.2g} Umdrehungen: das Pendel überschlägt sich"},
    {"turns_over_at_first", wrong_if_ignored,
     "the angle goes through {turns:.2g} turns: the pendulum turns over, which is no swing; from {time:.4g} "
     "s on it only swings: choose that part with {|{--from}|the handles}",
     "der Winkel durchläuft {turns:.2g} Umdrehungen: das Pendel überschlägt sich; ab {time:.4g} s schwingt "
     "es nur noch: bitte diesen Teil mit {|{--from}|den Griffen} wählen"},
    {"perhaps_degrees", wrong_if_ignored,
     "the angle, taken in radians, goes through {turns:.2g} turns: if it is in degrees, the header must say "
     "so, by \"(°)\" behind the column's name",
     "in Radiant gelesen durchläuft der Winkel {turns:.2g} Umdrehungen: ist er in Grad angegeben, muss die "
     "Kopfzeile das sagen, mit „(°)“ hinter dem Namen der Spalte"},

    // What else oscillates.
    {"line_beside_swing", worth_knowing,
     "the residual oscillates at {frequency:.5g} Hz{when} an amplitude of {amplitude:.2g}{unit: } "
     "({percent:.2g} % of the swing's): {what}",
     "der Rest schwingt mit {frequency:.5g} Hz{when} einer Amplitude von {amplitude:.2g}{unit: } "
     "({percent:.2g} % der Schwingung): {what}"},
    {"at_first_with", clause, ", at first with", ", anfangs mit"},
    {"lasting_with", clause, " with", " und"},
    {"second_harmonic", clause,
     "twice the swing's frequency {frequencies?of|where that is} {swing:.5g} Hz: its second harmonic, from "
     "a restoring force or a sensor that is asymmetric in another way than the law",
     "das Doppelte ihrer Frequenz{frequencies? von|, wo diese} {swing:.5g} Hz{frequencies?| ist}: die "
     "zweite Harmonische, von einer Rückstellkraft oder einem Sensor, die anders asymmetrisch sind als das "
     "Gesetz"},
    {"third_harmonic", clause,
     "three times the swing's frequency {frequencies?of|where that is} {swing:.5g} Hz: its third harmonic, "
     "from a restoring force, a damping or a sensor that is nonlinear in another way than the law",
     "das Dreifache ihrer Frequenz{frequencies? von|, wo diese} {swing:.5g} Hz{frequencies?| ist}: die "
     "dritte Harmonische, von einer Rückstellkraft, einer Dämpfung oder einem Sensor, die auf andere Weise "
     "nichtlinear sind als das Gesetz"},
    {"higher_harmonic", clause,
     "{order} times the swing's frequency {frequencies?of|where that is} {swing:.5g} Hz: a harmonic of it, "
     "as from a motion with corners or cut-off peaks",
     "das {order}-Fache ihrer Frequenz{frequencies? von|, wo diese} {swing:.5g} Hz{frequencies?| ist}: eine "
     "Harmonische, wie von einer Bewegung mit Ecken oder abgeschnittenen Gipfeln"},
    {"line_among_others", clause,
     "not the largest part of the residual, and perhaps one peak of many in slow noise",
     "nicht der größte Teil des Rests, und vielleicht eine von vielen Spitzen eines langsamen Rauschens"},
    {"second_mode", clause,
     "a second mode, as from a coupled or a sideways swing, or something that shakes the mount",
     "eine zweite Bewegung, wie gekoppelt oder seitwärts, oder etwas rüttelt an der Halterung"},
    {"line_beside_drive", worth_knowing,
     "the residual oscillates at {frequency:.5g} Hz{when} an amplitude of {amplitude:.2g}{unit: }: {what}",
     "der Rest schwingt mit {frequency:.5g} Hz{when} einer Amplitude von {amplitude:.2g}{unit: }: {what}"},
    {"harmonic_of_drive", clause,
     "{order} times the drive's frequency, as from a spring or a sensor that is not linear",
     "das {order}-Fache der Antriebsfrequenz, wie von einer Feder oder einem Sensor, die nicht linear sind"},
    {"another_drive", clause, "another drive, or another swing",
     "ein anderer Antrieb oder eine andere Schwingung"},

    // From where on a motion is free.
    {"level_until", clause, "from {time:.4g} s on the amplitude only falls, as when a drive stops",
     "ab {time:.4g} s fällt die Amplitude nur noch, wie wenn ein Antrieb endet"},
    {"disturbed_until", clause,
     "what comes before {time:.4g} s does not belong to the swing after it, as while a hand still moves it",
     "was vor {time:.4g} s liegt, gehört nicht zur Schwingung danach, wie wenn eine Hand es noch bewegt"},
    {"held_still_until", clause, "it is held still until {time:.4g} s",
     "bis {time:.4g} s wird es festgehalten"},
    {"held_still_then_set_going", clause, "it does not swing until {time:.4g} s and is then set going",
     "bis {time:.4g} s schwingt es nicht, dann wird es in Gang gesetzt"},

    // Laws as they are typed.
    {"law_auto_in_sum", error,
     "{--law}: auto chooses the terms itself and stands alone; for a sum name its terms, for instance "
     "viscous+drag",
     "{--law}: auto wählt die Glieder selbst und steht allein; für eine Summe bitte ihre Glieder nennen, "
     "zum Beispiel viscous+drag"},
    {"law_term_unknown", error, "{--law}: \"{term}\" is not a term. A law is auto, or a sum of {terms:and}",
     "{--law}: „{term}“ ist kein Glied. Ein Gesetz ist auto oder eine Summe von {terms:and}"},
    {"law_term_unknown_suggestion", error,
     "{--law}: \"{term}\" is not a term; did you mean {suggestion}? A law is auto, or a sum of {terms:and}",
     "{--law}: „{term}“ ist kein Glied; ist {suggestion} gemeint? Ein Gesetz ist auto oder eine Summe von "
     "{terms:and}"},
    {"law_term_twice", error, "{--law}: the term {term} is named twice",
     "{--law}: das Glied {term} ist zweimal genannt"},
};

}  // namespace

const std::span<const Entry> words_of_identify = entries;

}  // namespace cromer::core
