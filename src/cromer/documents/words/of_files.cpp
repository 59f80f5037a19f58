#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // Files read.
    {"cannot_be_read", clause, "cannot be read: {why}", "lässt sich nicht lesen: {why}"},
    {"cannot_be_read_but", clause, "cannot be read: {why}; did you mean \"{near}\"?",
     "lässt sich nicht lesen: {why}; ist „{near}“ gemeint?"},
    {"reads_no_folder", clause, "is a folder; name a file in it",
     "ist ein Ordner; bitte eine Datei darin nennen"},
    {"reads_no_device", clause, "is a device, not a file; - reads standard input",
     "ist ein Gerät, keine Datei; - liest die Standardeingabe"},
    {"nothing_but_zero_bytes", clause, "begins with nothing but zero bytes: a text or CSV file is expected",
     "beginnt mit lauter Nullbytes: erwartet wird eine Text- oder CSV-Datei"},
    // Files written.
    {"file_without_name", error, "cannot write a file without a name",
     "eine Datei ohne Namen lässt sich nicht schreiben"},
    {"cannot_write_folder", error, "cannot write {path}: it is a folder",
     "{path} lässt sich nicht schreiben: das ist ein Ordner"},
    {"cannot_write_without_folder", error, "cannot write {path}: there is no folder {folder}",
     "{path} lässt sich nicht schreiben: den Ordner {folder} gibt es nicht"},
    {"cannot_write_in_no_folder", error, "cannot write {path}: {folder} is no folder",
     "{path} lässt sich nicht schreiben: {folder} ist kein Ordner"},
    {"cannot_write_there", error, "cannot write {path}: {why}{cure}",
     "{path} lässt sich nicht schreiben: {why}{cure}"},
    {"cannot_open", error, "cannot open {path}: {why}{cure}", "{path} lässt sich nicht öffnen: {why}{cure}"},
    {"cannot_remove", error, "cannot remove {path}: {why}{cure}",
     "{path} lässt sich nicht entfernen: {why}{cure}"},
    {"finished_is_kept", clause, "; what is finished is kept: make room and go on with {--resume}",
     "; was fertig ist, bleibt: bitte Platz schaffen und mit {--resume} fortfahren"},
    {"disk_too_small", error,
     "{path} needs {needed:n}, but only {free:n} is free in {folder}; ask for fewer points or measures, or "
     "name a file on a larger disk",
     "{path} braucht {needed:n}, doch in {folder} sind nur {free:n} frei; bitte weniger Punkte oder Maße "
     "verlangen oder eine Datei auf einem größeren Datenträger nennen"},
    // Figures.
    {"no_panel", error, "{--panels}: there is no panel \"{panel}\"; there are {panels:and}",
     "{--panels}: ein Teilbild „{panel}“ gibt es nicht; es gibt {panels:and}"},
    {"no_panel_but", error,
     "{--panels}: there is no panel \"{panel}\"; did you mean {near}? There are {panels:and}",
     "{--panels}: ein Teilbild „{panel}“ gibt es nicht; ist {near} gemeint? Es gibt {panels:and}"},
    {"panel_twice", error, "{--panels}: {panel} stands there twice; name it once",
     "{--panels}: {panel} steht doppelt da; bitte nur einmal nennen"},
    {"names_no_figure", error, "\"{path}\" names no figure: end it with .svg, .png or .pdf",
     "„{path}“ nennt keine Abbildung: bitte mit .svg, .png oder .pdf enden lassen"},
    {"librsvg_is_missing", error,
     "PNG and PDF are drawn by librsvg, which cannot be loaded ({why}): install it (Debian's package "
     "librsvg2-2) or write .svg, which does without it",
     "PNG und PDF zeichnet librsvg, das sich nicht laden lässt ({why}): bitte installieren (bei Debian das "
     "Paket librsvg2-2) oder .svg schreiben, das ohne geht"},
    {"librsvg_failed", error, "librsvg could not draw the figure: {why}",
     "librsvg konnte die Abbildung nicht zeichnen: {why}"},
    {"no_reason_given", clause, "it gave no reason", "es nannte keinen Grund"},
    {"figure_of_two_axes", error,
     "{--plot}: {options} options are swept, and a figure has room for two; leave {--plot} out, or sweep "
     "fewer",
     "{--plot}: {options} Optionen haben mehrere Werte, und eine Abbildung hat Platz für zwei; bitte "
     "{--plot} weglassen oder weniger durchlaufen"},
    // HDF5 files and the modules that are loaded.
    {"module_not_there", error,
     "{what} need {module}, which is not there (looked in {looked_in}): this program was built without it; "
     "install {package} and build again, or set CROMER_MODULES to the folder that has it",
     "{what}: {module} fehlt (gesucht in {looked_in}), dieses Programm ist ohne das Modul gebaut; bitte "
     "{package} installieren und neu bauen oder CROMER_MODULES auf den Ordner setzen, in dem es liegt"},
    {"module_not_loaded", error,
     "{what} need {path}, which cannot be loaded: {why}; install what {package} brings",
     "{what}: {path} lässt sich nicht laden: {why}; bitte installieren, was {package} mitbringt"},
    {"module_of_other_version", error, "{module} is not of this version of cromer; install both together",
     "{module} gehört nicht zu dieser Version von cromer; bitte beide zusammen installieren"},
    {"or_use_csv", error, "{what}; or use -o FILE.csv", "{what}; oder bitte -o FILE.csv nehmen"},
    {"hdf5_files", clause, "HDF5 files", "HDF5-Dateien"},
    {"mpirun_and_srun", clause, "mpirun and srun", "mpirun und srun"},
    {"hdf5_not_made", clause, "cannot be made: {why}", "lässt sich nicht anlegen: {why}"},
    {"hdf5_part_not_made", clause, "{why}", "{why}"},
    {"hdf5_not_written", clause, "cannot be written: {why}", "das Schreiben misslingt: {why}"},
    {"hdf5_needs_a_file", error,
     "cannot write {path}: it is a device or a pipe, and HDF5 is written into files; name a file",
     "{path} lässt sich nicht schreiben: das ist ein Gerät oder eine Pipe, und HDF5 steht in Dateien; bitte "
     "eine Datei nennen"},
    {"hdf5_not_opened", clause, "cannot be opened as an HDF5 file: {why}",
     "lässt sich nicht als HDF5-Datei öffnen: {why}"},
    {"hdf5_not_read", clause, "cannot be read: {why}", "lässt sich nicht lesen: {why}"},
    // Going on with a file.
    {"cannot_resume", error, "{--resume}: {what}", "{--resume}: {what}"},
    {"cannot_resume_file", error, "{--resume}: {path} {what}", "{--resume}: {path} {what}"},
    {"resume_without_description", error, "{--resume}: {path} was not made by cromer: it has no description",
     "{--resume}: {path} ist nicht von cromer: es fehlt die Beschreibung"},
    {"resume_other_sweep", error,
     "{--resume}: {path} belongs to another sweep: {differences}; name another file, or ask for the same "
     "again",
     "{--resume}: {path} gehört zu einer anderen Reihe: {differences}; bitte eine andere Datei nennen oder "
     "dasselbe noch einmal verlangen"},
    {"resume_changed_file", error,
     "{--resume}: {path} has no {dataset} of {numbers} numbers; was it changed?",
     "{--resume}: {path} hat kein {dataset} mit {numbers} Zahlen; wurde die Datei geändert?"},
    {"file_is_unfinished", error, "{path} is unfinished; go on with {--resume}, or remove it to begin again",
     "{path} ist unfertig; bitte mit {--resume} fortfahren oder die Datei entfernen und neu beginnen"},
    {"another_is_writing", error, "another cromer is writing this file now (it holds {journal})",
     "ein anderes cromer schreibt gerade in diese Datei (es hält {journal})"},
    {"cannot_write_journal", error, "cannot write {journal}", "{journal} lässt sich nicht schreiben"},
    {"not_the_journal", error,
     "{journal} is not the journal of this work, or is damaged; to begin again, remove it and {file}",
     "{journal} ist nicht das Tagebuch dieser Arbeit oder beschädigt; um neu zu beginnen, bitte diese Datei "
     "und {file} entfernen"},
    {"interrupted_at_first", error, "interrupted before the first point; nothing was begun",
     "abgebrochen vor dem ersten Punkt; nichts ist begonnen"},
    {"described_otherwise", clause, "its description differs", "die Beschreibung ist eine andere"},
    {"missing_there", clause, "{name} is missing there", "{name} fehlt dort"},
    {"missing_here", clause, "{name} is missing here", "{name} fehlt hier"},
    {"differs", clause, "{name} is {there} there and {here} here", "{name} ist dort {there} und hier {here}"},
    {"and_more", clause, "and more", "und mehr"},
    // Ranks.
    {"mpi_sees_others", error,
     "{started} processes were started together, but MPI sees {seen}: start cromer with the mpirun of its "
     "MPI library, or with srun --mpi=pmix",
     "{started} Prozesse wurden zusammen gestartet, doch MPI sieht {seen}: bitte cromer mit dem mpirun "
     "seiner MPI-Bibliothek starten oder mit srun --mpi=pmix"},
    {"rank_computes_otherwise", error,
     "rank {rank} on {host} would compute something else (there: the first rank, here: rank {rank}): "
     "{differences}; use the same program, files and CROMER_SIMD everywhere",
     "Rang {rank} auf {host} würde etwas anderes rechnen (dort: der erste Rang, hier: Rang {rank}): "
     "{differences}; bitte überall dasselbe Programm, dieselben Dateien und dasselbe CROMER_SIMD nehmen"},
    {"rank_in_trouble", error, "rank {rank} on {host}: {what}", "Rang {rank} auf {host}: {what}"},
    {"said_in_words", clause, "{words}", "{words}"},
    {"chunk_not_made", error, "a chunk could not be made", "ein Stück ließ sich nicht rechnen"},
    {"no_memory_for_chunk", error, "not enough memory for this", "dafür reicht der Speicher nicht"},
};

}  // namespace

const std::span<const Entry> words_of_files = entries;

}  // namespace cromer::core
