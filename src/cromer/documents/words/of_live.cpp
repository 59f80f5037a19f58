#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    // What is to be recorded.
    {"source_not_understood", error,
     "{--from} \"{source}\": {why}; it is one of serial:DEVICE[:BAUD], tcp:HOST:PORT, phyphox:HOST[:PORT] "
     "or - (standard input)",
     "{--from} „{source}“: {why}; möglich sind serial:GERÄT[:BAUD], tcp:HOST:PORT, phyphox:HOST[:PORT] und "
     "- (Standardeingabe)"},
    {"address_has_no_closing_bracket", clause, "the address has no closing bracket",
     "der Adresse fehlt die schließende Klammer"},
    {"colon_stands_before_the_port", clause, "a colon stands before the port",
     "vor dem Port steht ein Doppelpunkt"},
    {"host_is_missing", clause, "the host is missing", "der Host fehlt"},
    {"port_is_missing", clause, "the port is missing", "der Port fehlt"},
    {"no_port", clause, "a port is a number from 1 to 65535", "ein Port ist eine Zahl von 1 bis 65535"},
    {"no_kind_of_source_named", clause, "that names no kind of source", "das nennt keine Art von Quelle"},
    {"no_kind_of_source", clause, "\"{kind}\" is no kind of source", "„{kind}“ ist keine Art von Quelle"},
    {"device_is_missing", clause, "the device is missing", "das Gerät fehlt"},
    {"no_unit_of_time", error, "{--time-unit} \"{unit}\" is no unit of time; it is s, ms or us",
     "{--time-unit} „{unit}“ ist keine Zeiteinheit; möglich sind s, ms und us"},
    {"recording_needs_a_file", error, "-o FILE.csv is needed: where the recording is to go",
     "-o DATEI.csv fehlt: wohin die Aufnahme soll"},
    {"recording_is_csv", error, "{--output}: {path}: a recording is written as .csv",
     "{--output}: {path}: eine Aufnahme wird als .csv geschrieben"},
    {"recording_exists", error,
     "{path} exists and is not empty; a recording overwrites nothing: name another file, or move that one "
     "away",
     "{path} gibt es schon; eine Aufnahme überschreibt nichts: bitte einen anderen Namen wählen"},
    {"last_line_not_whole", error, "{what}; its last line is incomplete",
     "{what}; die letzte Zeile ist unvollständig"},

    // Connections.
    {"serial_speed_unknown", error,
     "serial:{device}: {baud} baud is not a speed of serial lines; 9600 and 115200 are usual",
     "serial:{device}: {baud} Baud ist keine Geschwindigkeit serieller Leitungen; üblich sind 9600 und "
     "115200"},
    {"serial_not_opened", error, "serial:{device}: {why}", "serial:{device}: {why}"},
    {"no_serial_line", error, "serial:{device}: that is no serial line ({why})",
     "serial:{device}: das ist keine serielle Leitung ({why})"},
    {"serial_speed_not_set", error, "serial:{device}: cannot be set to {baud} baud ({why})",
     "serial:{device}: lässt sich nicht auf {baud} Baud stellen ({why})"},
    {"host_not_found", error, "{host}: {why}", "{host}: {why}"},
    {"host_not_reached", error, "{host}:{port}: {why}", "{host}:{port}: {why}"},
    {"connection_closed", error, "the connection was closed", "die Verbindung wurde geschlossen"},
    {"no_answer_in_time", error, "no answer in time", "keine Antwort in der erlaubten Zeit"},
    {"no_answer", error, "no answer", "keine Antwort"},
    {"answer_broke_off", error, "the answer broke off", "die Antwort brach ab"},
    {"answer_is_no_http", error, "the answer is no HTTP ({why})", "die Antwort ist kein HTTP ({why})"},
    {"answer_of_status", error, "{target} is answered with status {status}",
     "auf {target} kommt der Status {status}"},
    {"source_is_gone", worth_knowing, "{source} is gone; it is tried again until it is back",
     "{source} ist weg; es wird weiter versucht, bis es wieder da ist"},
    {"source_is_back", worth_knowing, "{source} is back after {duration:.3g} s",
     "{source} ist nach {duration:.3g} s wieder da"},

    // The phone's app phyphox.
    {"phyphox_failed", error, "phyphox:{address}: {what}", "phyphox:{address}: {what}"},
    {"phyphox_config_unreadable", error, "the answer to /config is no JSON object; is this phyphox?",
     "die Antwort auf /config ist kein JSON-Objekt; ist das phyphox?"},
    {"phyphox_answer_unreadable", error, "the answer to /get holds no buffers; is this phyphox?",
     "die Antwort auf /get enthält keine Puffer; ist das phyphox?"},
    {"phyphox_experiment_without_times", error,
     "the phone's experiment \"{experiment}\" has no values with a time; choose one with raw data, such as "
     "Acceleration (without g)",
     "das Experiment „{experiment}“ des Telefons hat keine Werte mit Zeit; bitte eines mit Rohdaten wählen, "
     "zum Beispiel Beschleunigung (ohne g)"},
    {"phyphox_buffer_gone", error,
     "the phone has no buffer \"{buffer}\" any more: another experiment was opened",
     "das Telefon hat den Puffer „{buffer}“ nicht mehr: ein anderes Experiment wurde geöffnet"},
    {"phyphox_started", detail,
     "the phone was not measuring; its experiment \"{experiment}\" was started and is left running",
     "das Telefon maß nicht; sein Experiment „{experiment}“ wurde gestartet und läuft weiter"},
    {"phyphox_does_not_answer", worth_knowing,
     "phyphox at {address} does not answer: {what}; it is asked again",
     "phyphox auf {address} antwortet nicht ({what}); es wird weiter gefragt"},
    {"phyphox_is_back", worth_knowing, "phyphox at {address} is back after {duration:.3g} s",
     "phyphox auf {address} ist nach {duration:.3g} s wieder da"},
    {"phyphox_measures_again", detail, "the phone measures again", "das Telefon misst wieder"},
    {"phyphox_stopped", worth_knowing, "the measurement was stopped on the phone; start it there to go on",
     "die Messung wurde am Telefon angehalten; dort starten, um fortzufahren"},
    {"phyphox_cleared", worth_knowing, "the phone's data were cleared; its times begin anew",
     "die Daten des Telefons wurden gelöscht; seine Zeiten beginnen von vorn"},

    // Lines that a device sends.
    {"line_is_no_sample", detail, "{@line} is no sample: \"{text}\"", "{@line} ist kein Messwert: „{text}“"},
    {"first_line_left_out", detail, "what came first may be the end of a line, and is left out: \"{text}\"",
     "was zuerst kam, ist vielleicht das Ende einer Zeile und bleibt weg: „{text}“"},
    {"out_of_memory", worth_knowing, "this computer ran out of memory: samples may be missing",
     "der Speicher dieses Rechners war voll: vielleicht fehlen Messwerte"},
    {"no_such_column_to_fit_live", worth_knowing,
     "{--column} \"{column}\": there is no such column to be fitted live, only {columns:,}",
     "{--column} „{column}“: eine solche Spalte gibt es hier nicht, nur {columns:,}"},
    {"column_in_quotes", clause, "\"{column}\"", "„{column}“"},

    // Their times.
    {"nothing_came", worth_knowing, "nothing for {duration:.3g} s from {time:.6g} s on",
     "{duration:.3g} s lang nichts, ab {time:.6g} s"},
    {"samples_missing", worth_knowing, "{samples:sample is|samples are} missing after {time:.6g} s",
     "{samples:Messwert fehlt|Messwerte fehlen} nach {time:.6g} s"},
    {"device_paused", worth_knowing, "the device paused for {duration:.3g} s after {time:.6g} s",
     "das Gerät schwieg {duration:.3g} s lang nach {time:.6g} s"},
    {"steady_rate_from", worth_knowing,
     "a steady rate of {rate:.6g}/s from {time:.6g} s on: the times follow it",
     "ab {time:.6g} s gleichmäßig {rate:.6g} je Sekunde: die Zeiten folgen dem"},
    {"no_steady_rate_from", worth_knowing,
     "no steady rate from {time:.6g} s on: the times are those of arrival",
     "ab {time:.6g} s kein gleichmäßiger Takt: die Zeiten sind die der Ankunft"},
    {"device_gave_no_time", worth_knowing,
     "the device gave {given:.6g} s, which is no time; {taken:.6g} s is taken instead",
     "das Gerät nannte {given:.6g} s, was keine Zeit ist; stattdessen gilt {taken:.6g} s"},
    {"device_time_twice", worth_knowing, "the device gave the time {time:.6g} s twice",
     "das Gerät nannte die Zeit {time:.6g} s zweimal"},
    {"device_clock_jumped_back", worth_knowing,
     "the device's clock jumped back by {jump:.6g} s at {time:.6g} s; the times go on from the computer's "
     "clock",
     "die Uhr des Geräts sprang bei {time:.6g} s um {jump:.6g} s zurück; die Zeiten gehen nach dem Rechner "
     "weiter"},
    {"device_clock_jumped_forward", worth_knowing,
     "the device's clock jumped forward by {jump:.6g} s at {time:.6g} s; the times go on from the computer's "
     "clock",
     "die Uhr des Geräts sprang bei {time:.6g} s um {jump:.6g} s vorwärts; die Zeiten gehen nach dem Rechner "
     "weiter"},
    {"later_than_counted", worth_knowing,
     "at {time:.6g} s a sample came {difference:.3g} s later than {--rate} predicts; counting begins anew",
     "bei {time:.6g} s kam ein Messwert {difference:.3g} s später, als {--rate} erwarten lässt; die Zählung "
     "beginnt neu"},
    {"earlier_than_counted", worth_knowing,
     "at {time:.6g} s a sample came {difference:.3g} s earlier than {--rate} predicts; counting begins anew",
     "bei {time:.6g} s kam ein Messwert {difference:.3g} s früher, als {--rate} erwarten lässt; die Zählung "
     "beginnt neu"},
    {"device_times_pass_too_fast", wrong_if_ignored,
     "{duration:.4g} s of the device's times passed in {took:.2g} s: if they are milliseconds, give "
     "{--time-unit} ms",
     "nach der Uhr des Geräts vergingen {duration:.4g} s in {took:.2g} s: sind es Millisekunden, bitte "
     "{--time-unit} ms angeben"},
    {"device_times_run_fast", wrong_if_ignored,
     "the device's times run {pace:.4g} times as fast as the clock: give their unit with {--time-unit}",
     "die Zeiten des Geräts laufen {pace:.4g}-mal so schnell wie die Uhr: bitte ihre Einheit mit "
     "{--time-unit} angeben"},
    {"times_counted", worth_knowing, "times: counted, at the rate of {--rate}",
     "Zeiten: gezählt, im Takt von {--rate}"},
    {"times_by_rate", worth_knowing,
     "times: by the steady rate that was found, {rate:.7g}/s; delays up to {delay:.2g} s",
     "Zeiten: nach dem gleichmäßigen Takt, der gefunden wurde, {rate:.7g} je Sekunde; Verspätungen bis "
     "{delay:.2g} s"},
    {"times_by_rate_and_arrival", worth_knowing,
     "times: by the steady rate that was found, {rate:.7g}/s; delays up to {delay:.2g} s; {by_arrival} of "
     "{samples} by arrival",
     "Zeiten: nach dem gleichmäßigen Takt, der gefunden wurde, {rate:.7g} je Sekunde; Verspätungen bis "
     "{delay:.2g} s; {by_arrival} von {samples} nach der Ankunft"},
    {"times_by_arrival", worth_knowing, "times: those of arrival; no steady rate was found",
     "Zeiten: die der Ankunft; ein gleichmäßiger Takt wurde nicht gefunden"},
    {"times_by_arrival_and_rate", worth_knowing,
     "times: those of arrival; no steady rate was found for long; {by_rate} of {samples} samples follow one",
     "Zeiten: die der Ankunft; ein gleichmäßiger Takt hielt nie lange; {by_rate} von {samples} Messwerten "
     "folgen einem"},
};

}  // namespace

const std::span<const Entry> words_of_live = entries;

}  // namespace cromer::core
