#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // Options.
    {"damping_said_twice", error,
     "{--damping-ratio} and {--loss-factor} both say how the springs are damped; leave one of them out",
     "{--damping-ratio} und {--loss-factor} sagen beide, wie die Federn gedämpft sind; bitte eines davon "
     "weglassen"},
    {"damping_out_of_range", error,
     "{option:option}: it must lie between {least:n} and {most:n}, not {value:n}",
     "{option:option}: das muss zwischen {least:n} und {most:n} liegen, nicht bei {value:n}"},
    {"oscillators_said_twice", error,
     "{--periods} and {--frequencies} both say which oscillators there are; leave one of them out",
     "{--periods} und {--frequencies} sagen beide, welche Schwinger es gibt; bitte eines davon weglassen"},
    {"oscillator_not_positive", error, "{option:option}: it must be positive, not {value:n}",
     "{option:option}: das muss größer als 0 sein, nicht {value:n}"},
    {"period_too_short", error,
     "{option:option}: {value:n} is a period below a thousandth of the sampling step ({spacing:.6g} s): "
     "such an oscillator moves with the ground, its PSA is the ground's own peak; ask for longer ones",
     "{option:option}: {value:n} ist eine Periode unter einem Tausendstel des Abstands der Messwerte "
     "({spacing:.6g} s): ein solcher Schwinger geht mit dem Boden, seine PSA ist die Spitze des Bodens "
     "selbst; bitte längere wählen"},
    {"period_too_long", error,
     "{option:option}: {value:n} is a period of more than a million times the recording ({duration:.6g} s); "
     "ask for shorter ones",
     "{option:option}: {value:n} ist eine Periode von mehr als dem Millionenfachen der Aufnahme "
     "({duration:.6g} s); bitte kürzere wählen"},
    {"peer_joins_samples", error,
     "{--peaks} peer joins the samples by straight lines; leave {--between-samples} out",
     "{--peaks} peer verbindet die Messwerte durch Geraden; bitte {--between-samples} weglassen"},
    {"one_recording", error,
     "{option:option} takes one recording; ask for the components one after the other",
     "{option:option} nimmt eine Aufnahme; bitte die Komponenten nacheinander"},
    {"loss_factor_sums_steady_states", error,
     "{--loss-factor} sums steady states of a band-limited ground; leave {option:option} out",
     "{--loss-factor} summiert eingeschwungene Zustände über einem bandbegrenzten Boden; bitte "
     "{option:option} weglassen"},
    {"yielding_is_followed", error,
     "{--ductility} follows one motion, straight between its samples, until its last sample; leave "
     "{option:option} out",
     "{--ductility} folgt einer Bewegung, gerade zwischen den Messwerten, bis zum letzten; bitte "
     "{option:option} weglassen"},
    {"yield_spectrum", worth_knowing,
     "SD, PSV and PSA are those of yielding, of the strongest spring that reaches the ductility until the "
     "last sample; its largest displacement is SD times the ductility",
     "SD, PSV und PSA sind die beim Fließen, bei der stärksten Feder, die bis zum letzten Messwert die "
     "Duktilität erreicht; ihre größte Auslenkung ist SD mal Duktilität"},
    {"ductility_not_reached", worth_knowing,
     "a ductility of {ductility} is not reached at {count:period|periods}, however weak the spring: NaN",
     "eine Duktilität von {ductility} wird bei {count:Periode|Perioden} nicht erreicht, wie schwach die "
     "Feder auch ist: NaN"},
    {"loss_factor_takes_long", error,
     "{--loss-factor}: until the slowest oscillator rests, {what}: take shorter periods or more damping",
     "{--loss-factor}: bis der langsamste Schwinger ruht, {what}: bitte kürzere Perioden oder mehr Dämpfung"},
    {"response_without_shock", error,
     "{--shock-response} says of what {--shock} is a spectrum; give that too",
     "{--shock-response} sagt, wovon {--shock} ein Spektrum ist; bitte auch das angeben"},
    // Corrections.
    {"no_band", error, "{--band-pass}: \"{typed}\": {what}", "{--band-pass}: „{typed}“: {what}"},
    {"band_has_two_corners", clause,
     "two corners with a colon between them are expected, \"0.1:25 Hz\", or one of them, \"0.1 Hz:\", \":25 "
     "Hz\"",
     "erwartet werden zwei Ecken mit Doppelpunkt, „0.1:25 Hz“, oder eine davon, „0.1 Hz:“, „:25 Hz“"},
    {"band_rises", clause, "the corners must be positive, and the second one the higher",
     "die Ecken müssen größer als 0 sein, und die zweite die höhere"},
    {"without_band_pass", error, "{option:option} says how {--band-pass} filters; give that too",
     "{option:option} sagt, wie {--band-pass} filtert; bitte auch das angeben"},
    {"order_out_of_range", error, "{--band-pass-order}: it must lie between 1 and {most}, not {order}",
     "{--band-pass-order}: das muss zwischen 1 und {most} liegen, nicht bei {order}"},
    {"band_above_half_rate", error,
     "{--band-pass}: {file}: a corner of {corner:.6g} Hz is not below half the sampling rate, {most:.6g} Hz: "
     "the recording holds nothing that fast; leave the high corner out",
     "{--band-pass}: {file}: eine Ecke von {corner:.6g} Hz liegt nicht unter der halben Abtastrate von "
     "{most:.6g} Hz: so Schnelles enthält die Aufnahme nicht; bitte die obere Ecke weglassen"},
    {"band_too_slow", error,
     "{--band-pass}: {file}: a corner of {corner:.6g} Hz is far slower than the recording of {duration:.6g} "
     "s shows; take a higher one",
     "{--band-pass}: {file}: eine Ecke von {corner:.6g} Hz ist weit langsamer, als die Aufnahme von "
     "{duration:.6g} s zeigt; bitte eine höhere wählen"},
    {"too_few_for_baseline", error,
     "{--baseline}: {file}: {samples} samples are too few for this polynomial; take a lower degree",
     "{--baseline}: {file}: {samples} Messwerte sind zu wenig für dieses Polynom; bitte einen kleineren "
     "Grad"},
    {"ground_ends_moving", worth_knowing,
     "{file}: the integrated velocity ends at {velocity:.3g} m/s, {percent:.0f} % of its largest: the "
     "recording ends while the ground moves, or its baseline drifts; {--baseline} and {--band-pass} take a "
     "drift off",
     "{file}: die integrierte Geschwindigkeit endet bei {velocity:.3g} m/s, {percent:.0f} % ihrer größten: "
     "die Aufnahme endet, während der Boden sich bewegt, oder ihre Nulllinie driftet; {--baseline} und "
     "{--band-pass} nehmen eine Drift weg"},
    // Recordings.
    {"like_of_others", clause, "{what} (the like of {others} more of {all} motions)",
     "{what} (ähnlich bei {others} weiteren von {all} Bewegungen)"},
    {"no_memory_for_motion", error, "not enough memory for its spectra",
     "für ihre Spektren reicht der Speicher nicht"},
    {"no_pairs", error,
     "{--files} pairs: {files:file does|files do} not come in pairs; name the two components of each motion "
     "one after the other",
     "{--files} pairs: {files:Datei ergibt|Dateien ergeben} keine Paare; bitte die zwei Komponenten jeder "
     "Bewegung nacheinander nennen"},
    {"file_of_one_motion", error,
     "{option:option} writes a file of one motion; ask for the motions one after the other",
     "{option:option} schreibt eine Datei einer einzigen Bewegung; bitte die Bewegungen nacheinander"},
    {"too_many_components", error,
     "spectrum takes one recording, or the two components of one motion; {given} are given",
     "ein Spektrum nimmt eine Aufnahme oder die zwei Komponenten einer Bewegung; gegeben sind {given}"},
    {"unit_is_there", error, "{--unit}: {file}: column \"{column}\" has its unit already; leave {--unit} out",
     "{--unit}: {file}: die Spalte „{column}“ hat ihre Einheit schon; bitte {--unit} weglassen"},
    {"no_unit_of_acceleration", error,
     "{--unit}: \"{typed}\" is no unit of acceleration; for instance g, m/s^2 or cm/s^2",
     "{--unit}: „{typed}“ ist keine Einheit einer Beschleunigung; zum Beispiel g, m/s^2 oder cm/s^2"},
    {"nothing_shakes_so", error,
     "{file}: column \"{column}\" has {acceleration:.4g} m/s^2 at sample {sample}: nothing shakes like "
     "that; mend the recording",
     "{file}: die Spalte „{column}“ hat {acceleration:.4g} m/s^2 beim Messwert {sample}: so bebt nichts; "
     "bitte die Aufnahme ausbessern"},
    {"not_sampled_alike", error,
     "{first} has a sample every {first_spacing:.6g} s and {second} one every {second_spacing:.6g} s; the "
     "components of one motion must be sampled alike: resample one of them",
     "{first} hat alle {first_spacing:.6g} s einen Messwert und {second} alle {second_spacing:.6g} s; die "
     "Komponenten einer Bewegung müssen gleich abgetastet sein: bitte eine umrechnen"},
    {"acceleration_unit_assumed", wrong_if_ignored,
     "{file}: column \"{column}\" has no unit of acceleration and is taken as m/s^2; {--unit} names another",
     "{file}: die Spalte „{column}“ hat keine Einheit der Beschleunigung und gilt als m/s^2; {--unit} nennt "
     "eine andere"},
    {"two_motions", wrong_if_ignored,
     "{first} is of \"{first_motion}\" and {second} of \"{second_motion}\": components of two motions, "
     "whose RotD50 means nothing",
     "{first} ist von „{first_motion}“ und {second} von „{second_motion}“: Komponenten zweier Bewegungen, "
     "deren RotD50 nichts bedeutet"},
    {"same_component_twice", wrong_if_ignored,
     "{first} and {second} hold the same samples: one component given twice, so RotD50 is its own spectrum "
     "and RotD100 sqrt(2) times that",
     "{first} und {second} enthalten dieselben Messwerte: eine Komponente, zweimal gegeben; RotD50 ist ihr "
     "eigenes Spektrum und RotD100 das sqrt(2)-Fache davon"},
    {"longer_component", detail, "{longer} is longer than {shorter}: its last {samples} samples are left out",
     "{longer} ist länger als {shorter}: die letzten {samples} Messwerte bleiben weg"},
    // How far the spectrum goes.
    {"one_period_too_fast", wrong_if_ignored,
     "{option:option}: one period is below {fastest:.6g} s, twice the sampling step of {spacing:.6g} s: the "
     "recording holds nothing that fast, and what is shown there comes from how its samples were joined",
     "{option:option}: eine Periode liegt unter {fastest:.6g} s, dem Doppelten des Abstands der Messwerte "
     "von {spacing:.6g} s: so Schnelles enthält die Aufnahme nicht, und was dort steht, kommt daher, wie "
     "ihre Messwerte verbunden sind"},
    {"periods_too_fast", wrong_if_ignored,
     "{option:option}: {periods} periods are below {fastest:.6g} s, twice the sampling step of "
     "{spacing:.6g} s: the recording holds nothing that fast, and what is shown there comes from how its "
     "samples were joined",
     "{option:option}: {periods} Perioden liegen unter {fastest:.6g} s, dem Doppelten des Abstands der "
     "Messwerte von {spacing:.6g} s: so Schnelles enthält die Aufnahme nicht, und was dort steht, kommt "
     "daher, wie ihre Messwerte verbunden sind"},
    {"recording_ends_early", wrong_if_ignored,
     "{--peaks} {peaks}: the recording ({duration:.6g} s) is shorter than the longest period ({longest:.6g} "
     "s), whose peak may come after its end; continuous counts that too",
     "{--peaks} {peaks}: die Aufnahme ({duration:.6g} s) ist kürzer als die längste Periode ({longest:.6g} "
     "s), deren Spitze nach dem Ende kommen kann; continuous zählt auch die"},
    {"peaks_after_the_end", worth_knowing,
     "from a period of {period:.4g} s on, some peaks come after the recording's end, where the ground is "
     "taken to go on at the speed it has then; {--peaks} samples looks no further than the recording",
     "von einer Periode von {period:.4g} s an kommen manche Spitzen nach dem Ende der Aufnahme; der Boden "
     "gilt dann als mit seiner letzten Geschwindigkeit weiterbewegt; {--peaks} samples sieht nicht weiter "
     "als die Aufnahme"},
    {"intensity_too_small", worth_knowing,
     "{file}: its Arias intensity, about 10^{decades:.0f} m/s, is below any number that a computer holds",
     "{file}: die Arias-Intensität, etwa 10^{decades:.0f} m/s, ist kleiner als jede Zahl, die ein Rechner "
     "hält"},
};

}  // namespace

const std::span<const Entry> words_of_spectrum = entries;

}  // namespace cromer::core
