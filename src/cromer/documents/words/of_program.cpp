#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    {"study_was_changed", error,
     "{file} was changed by hand and is kept: run it by cromer report {file} -o {folder}, or name another "
     "folder",
     "{file} ist von Hand geändert und bleibt: bitte cromer report {file} -o {folder} aufrufen, oder einen "
     "anderen Ordner nennen"},
    // apps/cli
    {"folder_unreadable", error, "{folder}: cannot be read: {reason}",
     "{folder}: lässt sich nicht lesen: {reason}"},
    {"folder_without_recordings", error,
     "{folder}: the folder holds no recording (a file ending in one of {endings}; folders in it are not "
     "searched)",
     "{folder}: der Ordner enthält keine Aufnahme (eine Datei mit der Endung {endings}; Ordner darin werden "
     "nicht durchsucht)"},
    {"entries_left_aside", detail,
     "{folder}: {left} of {all} entries are not recordings by their endings and are left aside",
     "{folder}: {left} von {all} Einträgen sind nach ihrer Endung keine Aufnahmen und bleiben weg"},
    {"no_memory_for_file", error, "not enough memory for this file",
     "für diese Datei reicht der Speicher nicht"},
    {"tripartite_without_plot", error, "{--tripartite} is a way to draw; name the file with {--plot}",
     "{--tripartite} ist eine Art zu zeichnen; in welche Datei, sagt {--plot}"},
    {"tripartite_of_shock", error,
     "{--tripartite} draws pseudo-velocities; for those of a shock, give {--shock-response} pseudo-velocity",
     "{--tripartite} zeichnet Pseudogeschwindigkeiten; für die eines Schocks bitte {--shock-response} "
     "pseudo-velocity angeben"},
    {"panels_without_plot", error, "{--panels} says what to draw; name the file with {--plot}",
     "{--panels} sagt, was zu zeichnen ist; in welche Datei, sagt {--plot}"},
    {"fourier_is_csv", error, "{--fourier}: {file}: the amplitudes are written as .csv",
     "{--fourier}: {file}: die Amplituden werden als .csv geschrieben"},
    {"nothing_to_write", error, "{file} is not written: there is nothing to write into it",
     "{file} wird nicht geschrieben: es gibt nichts hineinzuschreiben"},
    {"motion_is_csv", error, "{--motion}: {file}: the motion is written as .csv",
     "{--motion}: {file}: die Bewegung wird als .csv geschrieben"},
    {"two_outputs_one_file", error, "{first} and {second} both name {file}",
     "{first} und {second} nennen beide {file}"},
    {"no_hdf5_here", error,
     "{--output}: {file}: only simulate, sweep and spectrum write HDF5 files; use .csv or .json",
     "{--output}: {file}: nur simulate, sweep und spectrum schreiben HDF5-Dateien; bitte .csv oder .json"},
    {"unknown_ending", error,
     "{--output}: {file}: the ending says the format, and \"{ending}\" is neither .csv nor .json",
     "{--output}: {file}: die Endung bestimmt das Format, und „{ending}“ ist weder .csv noch .json"},
    {"unknown_ending_hdf5", error,
     "{--output}: {file}: the ending says the format, and \"{ending}\" is none of .csv, .json and .h5",
     "{--output}: {file}: die Endung bestimmt das Format, und „{ending}“ ist weder .csv noch .json noch .h5"},
    {"output_is_the_input", error, "{option} {file}: that is the file to be read; it would be lost",
     "{option} {file}: das ist die Datei, die gelesen wird; sie ginge verloren"},
    // documents/text
    {"methods_with_step", clause,
     "With {--natural-frequency} and {--step}: what each of them really simulates",
     "Mit {--natural-frequency} und {--step}: was jede von ihnen wirklich simuliert"},
    {"list_goes_on", clause, "and {more} more: {--json} lists all",
     "und {more} weitere: {--json} nennt alle"},
    // apps/cli
    {"two_on_standard_output", error, "{--json} and -o - both want standard output; give -o a file name",
     "{--json} und -o - wollen beide auf die Standardausgabe; bitte bei -o eine Datei nennen"},
    {"static_or_mass_line", error, "{--static} and {--mass-line} are two ways; give one of them",
     "{--static} und {--mass-line} sind zwei Wege; bitte einen wählen"},
    {"gravity_without_static", error, "{--gravity} is for {--static} only",
     "{--gravity} gehört nur zu {--static}"},
    {"masses_without_line", error, "{--masses} goes with {--static} or {--mass-line}",
     "{--masses} gehört zu {--static} oder {--mass-line}"},
    {"masses_without_static", error, "{--masses} goes with {--static}", "{--masses} gehört zu {--static}"},
    {"masses_needed", error,
     "{way:option} needs {--masses}, for instance {--masses} \"48.4 g, 67.95 g, 87.96 g\"",
     "zu {way:option} gehört {--masses}, zum Beispiel {--masses} \"48.4 g, 67.95 g, 87.96 g\""},
    {"two_masses_needed", error, "{--masses}: {way:option} needs at least two masses",
     "{--masses}: {way:option} braucht mindestens zwei Massen"},
    {"no_mass_line", error, "there is no line of T² against mass: {what}",
     "es gibt keine Gerade von T² über der Masse: {what}"},
    {"standard_output_not_written", error, "standard output cannot be written",
     "die Standardausgabe lässt sich nicht beschreiben"},
    {"given_several_times", error, "{option:option} is given {times} times; it takes one value",
     "{option:option} steht {times}-mal da und hat nur einen Wert"},
    {"trajectories_are_csv", error,
     "{--trajectories} {file}: trajectories are written as CSV; name it FILE.csv",
     "{--trajectories} {file}: Bahnen werden als CSV geschrieben; bitte DATEI.csv nennen"},
    {"trajectories_do_not_fit", error, "{--trajectories} {what}, or a larger {--every}",
     "{--trajectories} {what}, oder ein größeres {--every}"},
    {"trajectories_size", detail,
     "{--trajectories}: {points:point|points}, about {states:.3g} states, at most some {size:n}, in {file}",
     "{--trajectories}: {points:Punkt|Punkte}, etwa {states:.3g} Zustände, höchstens rund {size:n}, in "
     "{file}"},
    {"trajectories_ended_early", error,
     "{--trajectories}: {failed} of {points} points did not reach their end; what came before is there",
     "{--trajectories}: {failed} von {points} Punkten kamen nicht bis ans Ende; was davor kam, ist da"},
    {"trajectories_interrupted", error, "{--trajectories}: interrupted after {done} of {points} points",
     "{--trajectories}: abgebrochen nach {done} von {points} Punkten"},
    {"output_without_source", error, "-o names the recording, but there is no {--from} SOURCE to record",
     "-o nennt die Aufnahme, doch mit {--from} fehlt die Quelle"},

    {"lines_no_samples", worth_knowing, "{lines} lines were no samples",
     "{lines} Zeilen waren keine Messwerte"},
    {"no_sample_came", error, "no sample came from {source}", "von {source} kam kein Messwert"},
    {"file_lists_more", detail, "the end of the file lists more", "am Ende der Datei stehen weitere"},

    // apps/serve
    {"body_is_no_object", error, "the body is no JSON object such as {{\"for\": \"20 s\"}}",
     "der Inhalt ist kein JSON-Objekt wie {{\"for\": \"20 s\"}}"},
    {"duration_asked", error, "\"for\": {what}", "die Dauer: {what}"},
    {"must_be_positive_plain", clause, "it must be positive", "sie muss größer als 0 sein"},
    {"nothing_to_record_from", error,
     "cromer serve was started without {--from}: there is nothing to record from",
     "cromer serve läuft ohne {--from}: es gibt keine Quelle zum Aufnehmen"},
    {"recording_goes_on", error, "a recording is going on; stop it first",
     "eine Aufnahme läuft; bitte zuerst anhalten"},
    {"stopped_while_starting", error, "the recording was stopped while it was starting",
     "die Aufnahme wurde beim Beginnen angehalten"},
    {"no_ip_address", error,
     "{--address} \"{address}\" is no IP address; 0.0.0.0 stands for all of this computer",
     "{--address} „{address}“ ist keine IP-Adresse; 0.0.0.0 steht für alle dieses Rechners"},
    {"cannot_serve", error, "cannot serve at {address} port {port}: {reason}",
     "unter {address}, Port {port}, lässt sich nichts anbieten: {reason}"},
    {"not_settled", worth_knowing,
     "{method} did not settle at {unsettled} of {frequencies} frequencies: its own damping is negative or "
     "its steps are too long there",
     "{method} kam bei {unsettled} von {frequencies} Frequenzen nicht zur Ruhe: seine eigene Dämpfung ist "
     "dort negativ, oder seine Schritte sind zu lang"},
    {"over_options_without_over", error,
     "{option:option} is about the recording of {--over}; name the file with that",
     "{option:option} gilt der Aufnahme von {--over}; bitte die Datei damit nennen"},
    {"base_motion_not_read", error, "{--base-motion}: {what}", "{--base-motion}: {what}"},
    {"drive_file_not_read", error, "{--drive-file}: {what}", "{--drive-file}: {what}"},
    {"no_room", clause, "{why}; make room, or name a file on another disk",
     "{why}; bitte Platz schaffen oder eine Datei auf einem anderen Datenträger nennen"},
    {"cannot_write", error, "cannot write {path}: {why}", "{path} lässt sich nicht schreiben: {why}"},
    {"no_reader_of_pipe", clause, "nobody reads from this pipe", "niemand liest aus dieser Pipe"},
};

}  // namespace

const std::span<const Entry> words_of_program = entries;

}  // namespace cromer::core
