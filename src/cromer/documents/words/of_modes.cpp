#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    {"no_channel_moves", error, "{file}: no channel moves: each is constant or empty",
     "{file}: kein Kanal bewegt sich: jeder ist konstant oder leer"},
    {"too_few_samples_for_modes", error,
     "{file}: {samples:sample|samples} are too few to look for modes: {fewest} at least",
     "{file}: {samples:Messwert|Messwerte} sind zu wenig, um Eigenschwingungen zu suchen: mindestens "
     "{fewest}"},
    {"no_modes_found", error,
     "no mode was found: no pole keeps its frequency, damping and shape as the model grows; a longer "
     "recording, or one with fewer missing values, shows more; with large angles or dry friction no pole "
     "keeps them",
     "keine Eigenschwingung gefunden: kein Pol behält Frequenz, Dämpfung und Form, wenn das Modell wächst; "
     "eine längere Aufnahme oder eine mit weniger fehlenden Werten zeigt mehr; bei großen Winkeln oder "
     "trockener Reibung behält sie keiner"},
    {"no_modes_in_band", error,
     "no mode was found from {from:.4g} to {to:.4g} Hz; sampled as it is, the recording can show up to "
     "{highest:.4g} Hz: {--from-frequency} and {--to-frequency} choose another band",
     "keine Eigenschwingung von {from:.4g} bis {to:.4g} Hz gefunden; so abgetastet kann die Aufnahme bis "
     "{highest:.4g} Hz zeigen: {--from-frequency} und {--to-frequency} wählen ein anderes Band"},
    {"channel_dies", error,
     "\"{column}\" stops in full swing and keeps one value from {time:.6g} s on, as where a sensor or its "
     "cable fails: {--to} {time:.6g} takes what comes before",
     "„{column}“ bleibt mitten in der Schwingung stehen und behält ab {time:.6g} s einen Wert, wie wenn ein "
     "Sensor oder sein Kabel versagt: {--to} {time:.6g} nimmt, was davor liegt"},
    {"rests_at_the_end", worth_knowing,
     "the motion has died down by {time:.4g} s: the result is for what comes before",
     "die Bewegung ist bei {time:.4g} s abgeklungen: das Ergebnis gilt für den Teil davor"},
    {"too_short_for_modes", error, "no mode was found: the recording is too short for its slowest motion",
     "keine Eigenschwingung gefunden: die Aufnahme ist zu kurz für ihre langsamste Bewegung"},
    {"still_before_motion", worth_knowing,
     "for the first {length:.3g} s hardly anything moves, or it is held: the result is for the motion from "
     "{from:.4g} s on; {--from} takes another beginning",
     "in den ersten {length:.3g} s bewegt sich kaum etwas, oder es wird gehalten: das Ergebnis gilt für die "
     "Bewegung ab {from:.4g} s; {--from} wählt einen anderen Anfang"},
    {"let_go_slowly", worth_knowing,
     "the first {length:.3g} s are no part of the free motion after them (held, let go slowly, or pushed "
     "once more): the result is for the motion from {from:.4g} s on; {--from} takes another beginning",
     "die ersten {length:.3g} s gehören nicht zur freien Bewegung danach (gehalten, langsam losgelassen oder "
     "noch einmal angestoßen): das Ergebnis gilt für die Bewegung ab {from:.4g} s; {--from} wählt einen "
     "anderen Anfang"},
    {"channel_left_out_still", wrong_if_ignored, "{column} is left out: its value never changes",
     "{column} bleibt weg: der Wert ändert sich nie"},
    {"channel_left_out_empty", wrong_if_ignored,
     "{column} is left out: more than half of its values are missing",
     "{column} bleibt weg: mehr als die Hälfte der Werte fehlt"},
    {"samples_not_in_all_channels", worth_knowing,
     "{samples:sample is|samples are} left out: some channel has no value there",
     "{samples:Messwert bleibt|Messwerte bleiben} weg: dort hat ein Kanal keinen Wert"},
    {"one_channel", worth_knowing, "there is one channel, {column}: modes have no shape",
     "es gibt einen Kanal, {column}: Eigenschwingungen haben keine Form"},
    {"clock_drifts", wrong_if_ignored,
     "from the first third to the last the steps between samples change by {percent:.2g} %: if the sensor's "
     "clock drifts, frequencies are off by about as much",
     "vom ersten zum letzten Drittel ändern sich die Abstände der Messwerte um {percent:.2g} %: läuft die "
     "Uhr des Sensors ungleich, sind Frequenzen um etwa so viel falsch"},
    {"modes_of_random_forces", clause,
     "no free decay accounts for the motion from the first used sample on: these are modes under random "
     "forces, by subspace identification (orders to {order}, correlations over {reach:.3g} s)",
     "kein freies Ausschwingen erklärt die Bewegung vom ersten benutzten Messwert an: dies sind "
     "Eigenschwingungen unter zufälligen Kräften, durch Unterraum-Identifikation (Ordnungen bis {order}, "
     "Korrelationen über {reach:.3g} s)"},
    {"modes_of_free_decay", clause,
     "the motion decays from the first used sample on: a free decay, fitted by least squares, accounts for "
     "{percent:.3g} % of the power about these modes",
     "die Bewegung klingt vom ersten benutzten Messwert an ab: ein freies Ausschwingen, durch kleinste "
     "Quadrate angepasst, erklärt {percent:.3g} % der Leistung um diese Eigenschwingungen"},
    {"modes_of_free_motion", clause,
     "the motion is free from the first used sample on and does not die away: a free motion, fitted by least "
     "squares, accounts for {percent:.3g} % of the power about these modes",
     "die Bewegung ist vom ersten benutzten Messwert an frei und klingt nicht ab: eine freie Bewegung, durch "
     "kleinste Quadrate angepasst, erklärt {percent:.3g} % der Leistung um diese Eigenschwingungen"},
    {"mode_grows", wrong_if_ignored,
     "the mode at {frequency:.4g} Hz grows: its damping ratio is negative, something feeds it",
     "die Eigenschwingung bei {frequency:.4g} Hz wächst: ihr Dämpfungsgrad ist negativ, etwas speist sie"},
    {"modes_leave_a_motion", wrong_if_ignored,
     "about {frequency:.4g} Hz the fit leaves {times:.2g} times the noise: something else acts on the "
     "motion (a push, the wind), or its frequency or damping depends on the amplitude; the intervals are "
     "widened for that",
     "um {frequency:.4g} Hz lässt der Fit das {times:.2g}-Fache des Rauschens übrig: noch etwas wirkt auf "
     "die Bewegung (ein Stoß, der Wind), oder ihre Frequenz oder Dämpfung hängt von der Amplitude ab; die "
     "Intervalle sind dafür verbreitert"},
    {"mode_does_not_decay", worth_knowing,
     "the oscillation at {frequency:.4g} Hz does not decay measurably: a mode almost without damping, or a "
     "machine's",
     "die Schwingung bei {frequency:.4g} Hz klingt nicht messbar ab: eine Eigenschwingung fast ohne "
     "Dämpfung, oder die einer Maschine"},
    {"steady_line", worth_knowing,
     "the line at {frequency:.4g} Hz is steady, as a machine's is, and was taken out before the modes were "
     "sought; a mode that hardly decays within the recording looks the same",
     "die Linie bei {frequency:.4g} Hz ist gleichbleibend, wie die einer Maschine, und wurde vor der Suche "
     "nach Eigenschwingungen abgezogen; eine Eigenschwingung, die in der Aufnahme kaum abklingt, sieht "
     "genauso aus"},
    {"more_modes_than_channels", wrong_if_ignored,
     "there are {modes} modes and {channels} channels: if each channel is a mass, some of them are no modes "
     "but part of a motion that is not linear (dry friction, large angles, a nonlinear spring)",
     "es gibt {modes} Eigenschwingungen und {channels} Kanäle: ist jeder Kanal eine Masse, so gehören "
     "einige zu keiner Eigenschwingung, sondern zu einer nichtlinearen Bewegung (trockene Reibung, große "
     "Winkel, nichtlineare Feder)"},
    {"fewer_modes_than_channels", worth_knowing,
     "there are {channels} channels and {modes:mode|modes}: if each channel is a mass, the others were "
     "hardly excited, or they lie above half the rate",
     "es gibt {channels} Kanäle und {modes:Eigenschwingung|Eigenschwingungen}: ist jeder Kanal eine Masse, "
     "so wurden die anderen kaum angeregt, oder sie liegen über der halben Abtastrate"},
    {"few_decay_times", worth_knowing,
     "the recording holds only {times:.2g} decay times of the mode at {frequency:.4g} Hz: a longer one "
     "would make its intervals surer",
     "die Aufnahme enthält nur {times:.2g} Abklingzeiten der Eigenschwingung bei {frequency:.4g} Hz: eine "
     "längere macht ihre Vertrauensbereiche sicherer"},
    {"peak_without_mode", worth_knowing,
     "the spectrum has a peak at {frequency:.4g} Hz where no mode was found: it may be a strongly damped "
     "mode, two modes too close to be told apart, or a machine",
     "das Spektrum hat bei {frequency:.4g} Hz einen Gipfel, wo keine Eigenschwingung gefunden wurde: "
     "vielleicht eine stark gedämpfte, zwei zu nah beieinander, oder eine Maschine"},
};

}  // namespace

const std::span<const Entry> words_of_modes = entries;

}  // namespace cromer::core
