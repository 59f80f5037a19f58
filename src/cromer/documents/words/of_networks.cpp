#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // The file of a network.
    {"value_of_key", error, "{key}: {what}", "{key}: {what}"},
    {"network_without_masses", error, "{file}: a network has at least one [[mass]]",
     "{file}: ein Netz hat mindestens eine [[mass]]"},
    {"not_a_network", error,
     "{file} is no network: {--network} takes a file that ends in .toml, with [[mass]] and [[link]]",
     "{file} ist kein Netz: {--network} nimmt eine Datei, die auf .toml endet, mit [[mass]] und [[link]]"},
    {"mass_without_name", error, "a [[mass]] needs a name: name = \"floor 1\"",
     "eine [[mass]] braucht einen Namen: name = \"floor 1\""},
    {"mass_name_is_no_name", error,
     "\"{name}\" is no name for a mass: it must not be empty, and \"ground\" is the ground",
     "„{name}“ ist kein Name für eine Masse: er darf nicht leer sein, und „ground“ ist der Boden"},
    {"mass_name_taken", error, "there are two masses \"{name}\": each needs a name of its own",
     "es gibt zwei Massen „{name}“: jede braucht einen eigenen Namen"},
    {"mass_or_inertia", error,
     "\"{name}\" has no mass: give mass = \"1200 kg\", or of an angle inertia = \"0.05 kg m^2\"",
     "„{name}“ hat keine Masse: bitte mass = \"1200 kg\" angeben, oder bei einem Winkel inertia = \"0.05 kg "
     "m^2\""},
    {"mass_and_inertia", error, "\"{name}\" has a mass and an inertia: give one of them",
     "„{name}“ hat eine Masse und ein Trägheitsmoment: bitte eines davon angeben"},
    {"masses_and_inertias", error,
     "a network has masses or moments of inertia, not both: positions are all lengths or all angles",
     "ein Netz hat Massen oder Trägheitsmomente, nicht beides: Orte sind alle Längen oder alle Winkel"},
    {"mass_without_link", error,
     "nothing holds \"{name}\": give it a [[link]] to another mass or to \"ground\"",
     "nichts hält „{name}“: bitte mit einem [[link]] an eine andere Masse oder an \"ground\" binden"},
    {"mass_is_open", error,
     "{key}: it must be given, \"?\" is for values of a link",
     "{key}: bitte angeben, „?“ ist für Werte eines [[link]]"},
    {"value_cannot_be_open", error,
     "{key}: \"?\" is only for {keys:or} of a link; give a value, or leave {key} out",
     "{key}: „?“ ist nur für {keys:or} eines [[link]]; bitte einen Wert angeben oder {key} weglassen"},
    {"there_are_masses", clause, "; the network has {names}", "; das Netz hat {names}"},
    {"no_such_mass", error, "there is no mass \"{name}\"{near}", "die Masse „{name}“ gibt es nicht{near}"},
    {"link_to_itself", error, "the link joins \"{name}\" to itself: give it two ends",
     "der [[link]] verbindet „{name}“ mit sich selbst: bitte zwei Enden angeben"},
    {"link_without_term", error, "the link has no force: give it a term, such as stiffness = \"20 N/m\"",
     "der [[link]] hat keine Kraft: bitte einen Term angeben, etwa stiffness = \"20 N/m\""},
    {"amplitude_without_frequency", error,
     "drive_amplitude needs a drive_frequency; of a constant force it is 0",
     "drive_amplitude braucht eine drive_frequency; bei einer festen Kraft ist sie 0"},
    {"static_friction_below_friction", error,
     "static_friction: it must be at least friction ({friction} {unit}), not {static_friction} {unit}",
     "static_friction: das muss mindestens friction sein ({friction} {unit}), nicht {static_friction} "
     "{unit}"},
    // Options.
    {"step_needs_method", error, "{--step} needs a {--method}", "{--step} braucht eine {--method}"},
    {"method_needs_step", error, "{--method} needs a {--step}", "{--method} braucht einen {--step}"},
    {"option_needs_method_and_step", error, "{option:option} needs {method:option} and {--step}",
     "{option:option} braucht {method:option} und {--step}"},
    {"method_without_steps", error, "{option:option}: {method} chooses its own steps",
     "{option:option}: {method} wählt seine Schritte selbst"},
    {"too_many_masses_for_modes", error, "{file}: {masses} masses; modes are found for at most {most}",
     "{file}: {masses} Massen; Eigenschwingungen werden für höchstens {most} gesucht"},
    {"option_of_recordings", error, "{file}: {option:option} is for recordings, and this is a network",
     "{file}: {option:option} gilt für Aufnahmen, und dies ist ein Netz"},
    {"method_of_networks", error,
     "{file}: {--method} is for networks; if this recording was simulated, name its method by {--of-method}",
     "{file}: {--method} gilt für Netze; wurde diese Aufnahme simuliert, bitte ihre Methode mit "
     "{--of-method} nennen"},
    {"step_needs_of_method", error,
     "for a recording, {--step} needs {--of-method}, the method that simulated it",
     "bei einer Aufnahme braucht {--step} die {--of-method}, die sie simulierte"},
    {"of_method_needs_step", error, "{--of-method} needs {--step}, the step that it was simulated with",
     "{--of-method} braucht {--step}, den Schritt, mit dem simuliert wurde"},
    {"frequencies_reversed", error, "{--from-frequency} must be less than {--to-frequency}",
     "{--from-frequency} muss kleiner sein als {--to-frequency}"},
    // Runs.
    {"term_not_in_networks", error, "{file}: {term} is not fitted in a network; leave it out",
     "{file}: {term} wird in einem Netz nicht angepasst; bitte weglassen"},
    {"exact_of_linear_networks", error,
     "{file}: exact takes linear networks, and a link has the term {term}; take another {--method}",
     "{file}: exact nimmt lineare Netze, und ein [[link]] hat den Term {term}; bitte eine andere {--method} "
     "nehmen"},
    {"too_many_masses_for_exact", error,
     "{--method}: exact takes networks of at most {most} masses, and there are {masses}",
     "{--method}: exact nimmt Netze von höchstens {most} Massen, und es sind {masses}"},
    {"one_method_of_networks", error,
     "{--method} is given {methods} times; here a network runs with one method",
     "{--method} ist {methods}-mal angegeben; hier läuft ein Netz mit einer"},
    {"large_network_needs_step", error,
     "the periods of {masses} masses are not sought (of at most {most} they are): give {--step} and "
     "{--until}",
     "die Perioden von {masses} Massen werden nicht gesucht (nur von höchstens {most}): bitte {--step} und "
     "{--until} angeben"},
    {"network_without_period", error, "{file}: nothing swings: give {--step} and {--until}",
     "{file}: nichts schwingt: bitte {--step} und {--until} angeben"},
    {"network_stands_still", error, "{file}: nothing moves: give a mass a position, a velocity or a drive",
     "{file}: nichts bewegt sich: bitte einer Masse position, velocity oder drive_amplitude geben"},
    {"option_not_of_networks", error, "{option:option} does not go with {--network}",
     "{option:option} geht nicht mit {--network}"},
    {"network_without_hdf5", error, "{--output}: {file}: the states of a network go into .csv or .json",
     "{--output}: {file}: die Zustände eines Netzes kommen in .csv oder .json"},
    {"network_not_alone", error, "{--network} does not go with {--over}",
     "{--network} geht nicht mit {--over}"},
    // Fits.
    {"fit_option_not_of_networks", error,
     "{option:option} does not go with {--network}: the network says what is fitted",
     "{option:option} geht nicht mit {--network}: das Netz sagt, was gesucht wird"},
    {"network_fit_of_one_file", error, "{--network} is fitted to one recording, and there are {files}",
     "{--network} wird an eine Aufnahme angepasst, und es sind {files}"},
    {"value_is_open", error,
     "{key} is \"?\": fit with {--network} finds it from a recording; here it needs a value",
     "{key} ist \"?\": fit mit {--network} findet es aus einer Aufnahme; hier braucht es einen Wert"},
    {"network_seeks_nothing", error,
     "{file}: no value is open: write stiffness = \"?\" for each value that a fit is to find",
     "{file}: kein Wert ist offen: bitte stiffness = \"?\" für jeden Wert schreiben, den der Fit finden "
     "soll"},
    {"too_much_sought", error,
     "{file}: {sought:value is|values are} open; with {masses:mass|masses} at most {most} are found from one "
     "recording",
     "{file}: {sought:Wert ist|Werte sind} offen; bei {masses:Masse|Massen} werden höchstens {most} aus "
     "einer Aufnahme gefunden"},
    {"columns_for_masses", error,
     "{file}: {columns:column|columns} of the motion ({names}), and the network has {masses:mass|masses}: "
     "each mass needs its column, in the order of the network's file",
     "{file}: {columns:Spalte|Spalten} der Bewegung ({names}), und das Netz hat {masses:Masse|Massen}: jede "
     "Masse braucht ihre Spalte, in der Reihenfolge der Datei des Netzes"},
    {"columns_in_another_order", error,
     "{file}: the column \"{column}\" has the name of the mass \"{mass}\" and the place of \"{place}\": "
     "columns belong to masses by their order; put the [[mass]] tables in the order of the columns",
     "{file}: die Spalte „{column}“ hat den Namen der Masse „{mass}“ und den Platz von „{place}“: Spalten "
     "gehören zu Massen nach ihrer Reihenfolge; bitte die [[mass]]-Tabellen in die Reihenfolge der Spalten "
     "bringen"},
    {"network_of_another_quantity", error,
     "{file}: the columns of the motion are of another quantity ({quantity}); masses need columns of "
     "positions, moments of inertia columns of angles",
     "{file}: die Spalten der Bewegung sind von einer anderen Größe ({quantity}); Massen brauchen Spalten "
     "von Orten, Trägheitsmomente Spalten von Winkeln"},
    {"value_of_link", clause, "{value} of {from}–{to}", "{value} von {from}–{to}"},
    {"network_record_too_short", error,
     "the record does not determine the values: it needs one and a half swings of each mass about its rest, "
     "few gaps, and three samples for each number that is sought",
     "die Aufnahme bestimmt die Werte nicht: sie braucht anderthalb Schwingungen jeder Masse um ihre "
     "Ruhelage, wenige Lücken und drei Messwerte für jede gesuchte Zahl"},
    {"columns_may_be_swapped", clause, "cromer modes {--network} names columns that look swapped or reversed",
     "cromer modes {--network} nennt Spalten, die vertauscht oder umgekehrt scheinen"},
    {"network_explains_little", error,
     "the network accounts for {percent:.2g} % of the variance of \"{column}\" only: it lacks a link, a term "
     "or a drive, or the columns stand in another order than the masses; {hint}",
     "das Netz erklärt nur {percent:.2g} % der Varianz von „{column}“: ihm fehlt eine Verbindung, ein Term "
     "oder ein Antrieb, oder die Spalten stehen in anderer Reihenfolge als die Massen; {hint}"},
    {"network_values_undetermined", error,
     "the record tells these values in combination only, not each by itself: {values}; give some of them",
     "die Aufnahme bestimmt diese Werte nur gemeinsam, nicht einzeln: {values}; bitte einige davon angeben"},
    {"network_value_undetermined", error, "the record does not tell the {value}: give it, or leave it out",
     "die Aufnahme bestimmt nicht: {value}; bitte angeben oder weglassen"},
    {"network_not_converged", error,
     "the fit has not converged after {iterations:iteration|iterations}: perhaps the network lacks a link "
     "or a term, or the columns stand in another order than the masses; {hint}",
     "der Fit hat nach {iterations:Iteration|Iterationen} nicht konvergiert: vielleicht fehlt dem Netz eine "
     "Verbindung oder ein Term, oder die Spalten stehen in anderer Reihenfolge als die Massen; {hint}"},
    {"network_runs_away", error,
     "with the values tried the network's motion runs away from the recorded one: perhaps the network lacks "
     "a link or a term, or the columns stand in another order than the masses; {hint}",
     "mit den versuchten Werten läuft die Bewegung des Netzes der aufgenommenen davon: vielleicht fehlt dem "
     "Netz eine Verbindung oder ein Term, oder die Spalten stehen in anderer Reihenfolge als die Massen; "
     "{hint}"},
    {"network_leaves_a_motion", wrong_if_ignored,
     "the network leaves a motion: in \"{column}\" {times:.2g} times the noise from sample to sample; a "
     "link or a term is missing, a value that the file gives is wrong, or something else acts, as a push "
     "does; the uncertainties cannot be trusted",
     "das Netz lässt eine Bewegung übrig: in „{column}“ das {times:.2g}-Fache des Rauschens von Messwert "
     "zu Messwert; eine Verbindung oder ein Term fehlt, ein Wert in der Datei ist falsch, oder noch etwas "
     "wirkt, wie ein Stoß; den Unsicherheiten ist nicht zu trauen"},
    {"network_leaves_a_line", wrong_if_ignored,
     "what the network leaves of \"{column}\" swings at {frequency:.4g} Hz, as the network does and noise "
     "does not: a link or a term is missing, a value that the file gives is wrong, or something else acts, "
     "as a push does; the uncertainties cannot be trusted",
     "was das Netz von „{column}“ übrig lässt, schwingt mit {frequency:.4g} Hz, wie das Netz und anders "
     "als Rauschen: eine Verbindung oder ein Term fehlt, ein Wert in der Datei ist falsch, oder noch etwas "
     "wirkt, wie ein Stoß; den Unsicherheiten ist nicht zu trauen"},
    {"network_pushes_apart", worth_knowing,
     "{what} is negative: the link pushes its masses apart, or one of the columns is reversed",
     "{what} ist negativ: die Verbindung drückt ihre Massen auseinander, oder eine Spalte ist umgekehrt"},
    {"network_lacks_a_mode", wrong_if_ignored,
     "the recording swings at {frequency:.4g} Hz, and no mode of the fitted network does: the fit has ended "
     "beside the best values, or a link or a term is missing, and the uncertainties cannot be trusted",
     "die Aufnahme schwingt mit {frequency:.4g} Hz, aber keine Mode des angepassten Netzes: der Fit endete "
     "neben den besten Werten, oder eine Verbindung oder ein Term fehlt, und den Unsicherheiten ist nicht zu "
     "trauen"},
    {"network_above_half_rate", wrong_if_ignored,
     "the fitted network swings at {frequency:.4g} Hz, above half the rate ({half:.4g} Hz): the samples cannot "
     "tell that from {mirror:.4g} Hz, and the values may be those of the wrong one; record faster, or give the "
     "values of the stiff links",
     "das angepasste Netz schwingt mit {frequency:.4g} Hz, über der halben Rate ({half:.4g} Hz): die Messwerte "
     "unterscheiden das nicht von {mirror:.4g} Hz, und die Werte können die falschen sein; bitte schneller "
     "aufnehmen oder die Werte der steifen Verbindungen angeben"},
    {"network_value_may_be_zero", worth_knowing, "{what} may be 0: its interval holds 0",
     "{what} kann 0 sein: 0 liegt in seinem Intervall"},
    // Modes.
    {"modes_of_small_motions", worth_knowing,
     "the modes are those of small motions about rest: the law is not linear ({terms:and})",
     "die Eigenschwingungen sind die kleiner Bewegungen um die Ruhelage: das Gesetz ist nicht linear "
     "({terms:and})"},
    {"modes_without_friction", worth_knowing, "dry friction is left out of the modes",
     "trockene Reibung ist in den Eigenschwingungen nicht enthalten"},
    {"modes_of_free_bodies", worth_knowing,
     "{modes:mode has|modes have} the frequency 0: in small motions nothing pulls all masses back to the "
     "ground",
     "{modes:Eigenschwingung hat|Eigenschwingungen haben} die Frequenz 0: kleine Bewegungen zieht nichts an "
     "den Boden zurück"},
    {"slow_modes_lost", wrong_if_ignored,
     "{modes:slow mode is|slow modes are} lost in rounding, at the frequency 0: the stiffnesses are too far "
     "apart; join what is stiff to one mass",
     "{modes:langsame Eigenschwingung geht|langsame Eigenschwingungen gehen} im Runden verloren, bei der "
     "Frequenz 0: die Steifigkeiten liegen zu weit auseinander; bitte Starres zu einer Masse verbinden"},
    {"modes_that_fall_away", worth_knowing,
     "{modes:mode falls|modes fall} away from rest: a stiffness is negative there",
     "{modes:Eigenschwingung fällt|Eigenschwingungen fallen} von der Ruhelage weg: dort ist eine Steifigkeit "
     "negativ"},
    {"channels_look_swapped", wrong_if_ignored,
     "\"{first}\" and \"{second}\" look swapped: if they are, the shapes agree with the network's (mean MAC "
     "{swapped:.2f}), and as they stand they do not ({mac:.2f}); columns are to stand in the order of the "
     "masses",
     "„{first}“ und „{second}“ scheinen vertauscht zu sein: tauscht man sie, stimmen die Formen mit denen "
     "des Netzes überein (mittlerer MAC {swapped:.2f}), so wie sie stehen nicht ({mac:.2f}); Spalten sollen "
     "in der Reihenfolge der Massen stehen"},
    {"channel_looks_reversed", wrong_if_ignored,
     "\"{column}\" looks reversed against the other channels: with its sign changed the shapes agree with "
     "the network's (mean MAC {reversed:.2f}), and as it stands they do not ({mac:.2f}); see which way the "
     "sensors point",
     "„{column}“ scheint das falsche Vorzeichen zu haben: umgekehrt passen die Formen zu denen des Netzes "
     "(mittlerer MAC {reversed:.2f}), so wie die Spalte ist nicht ({mac:.2f}); bitte die Richtungen der "
     "Sensoren prüfen"},
    {"mode_unlike_network", worth_knowing,
     "the mode at {frequency:.4g} Hz matches none of the network's remaining modes: none has a similar "
     "shape and a frequency within a factor of two",
     "zur Eigenschwingung bei {frequency:.4g} Hz passt keine der übrigen des Netzes: keine hat eine ähnliche "
     "Form und eine Frequenz zwischen der halben und der doppelten"},
    {"network_mode_not_found", worth_knowing,
     "the network's mode {mode}, at {frequency:.4g} Hz, was not found in the recording",
     "die Eigenschwingung {mode} des Netzes, bei {frequency:.4g} Hz, wurde in der Aufnahme nicht gefunden"},
    {"step_not_of_record", error,
     "{--step}: the rows are {spacing} s apart, which is no whole number of steps of {step:.6g} s",
     "{--step}: die Zeilen liegen {spacing} s auseinander, das ist keine ganze Zahl von Schritten von "
     "{step:.6g} s"},
    {"method_couples_modes", wrong_if_ignored,
     "damping couples the modes: what {method} made of each is taken off as of a single oscillator, and the "
     "damping ratios are further from the law than their intervals say",
     "die Dämpfung koppelt die Eigenschwingungen: was {method} aus jeder machte, ist wie bei einem einzelnen "
     "Oszillator abgezogen, und die Dämpfungsgrade liegen weiter vom Gesetz, als ihre Intervalle sagen"},
    {"no_law_before_method", wrong_if_ignored,
     "no linear law simulated by {method} with a step of {step:.6g} s swings at {frequency:.6g} Hz as this "
     "mode does: it is given as recorded",
     "kein lineares Gesetz schwingt, mit {method} und einem Schritt von {step:.6g} s simuliert, bei "
     "{frequency:.6g} Hz wie diese Eigenschwingung: sie ist so angegeben, wie sie aufgezeichnet ist"},
    {"method_unstable_on_network", wrong_if_ignored,
     "{method} with a step of {step:.6g} s is unstable on this network",
     "{method} mit einem Schritt von {step:.6g} s ist auf diesem Netz instabil"},
    {"method_finds_no_solution", wrong_if_ignored,
     "{method} with a step of {step:.6g} s finds no solution of its equation",
     "{method} mit einem Schritt von {step:.6g} s findet keine Lösung seiner Gleichung"},
    {"does_not_swing_as_the_law", clause, "does not swing, as your law does not",
     "schwingt nicht, wie das Gesetz auch nicht"},
};

}  // namespace

const std::span<const Entry> words_of_networks = entries;

}  // namespace cromer::core
