// What the core and the server say, in German: their words before ⇒, ours behind it. {} is what they put in, # a
// number; they stand in ours in the same order, or as {2}. … is what ours leaves out. Earlier lines come first.
const lines = `{} is not a number with…⇒{} ist keine Zahl mit Unsicherheit, wie es 0.2176(3) ist
{} has a decimal comma…⇒{} hat ein Dezimalkomma: bitte einen Punkt schreiben
{} has a negative uncertainty⇒{} hat eine negative Unsicherheit
{} lacks a closing bracket⇒in {} fehlt die schließende Klammer
{} has no power of ten…⇒in {} fehlt die Zehnerpotenz
{} is too large⇒{} ist zu groß
unknown unit {}⇒die Einheit {} ist unbekannt
expected a number of samples…⇒erwartet wird eine Zahl von Messwerten je Sekunde, zum Beispiel 100 Hz
expected {}, for instance {} or {}⇒erwartet wird {}, zum Beispiel {} oder {}
expected {}, for instance {}⇒erwartet wird {}, zum Beispiel {}
a mass⇒eine Masse
a stiffness⇒eine Federkonstante
a cubic stiffness⇒eine kubische Federkonstante
a damping⇒eine Dämpfung
a drag⇒ein Luftwiderstand
a force⇒eine Kraft
a length⇒eine Länge
a velocity⇒eine Geschwindigkeit
a time⇒eine Zeit
a frequency⇒eine Frequenz
a temperature⇒eine Temperatur
it must be positive, not {}⇒das muss größer als 0 sein, nicht {}
it must not be negative without --van-der-pol, not {}⇒das darf ohne --van-der-pol nicht negativ sein: {}
it must not be negative, not {}⇒das darf nicht negativ sein: {}
it must lie between 100 K and 1900 K…⇒das muss zwischen 100 K und 1900 K liegen, zum Beispiel bei "20 °C"
it must lie between {} and {}, not {}⇒das muss zwischen {} und {} liegen, nicht bei {}
the value is empty⇒der Wert fehlt
{} has an uncertainty…⇒{} hat eine Unsicherheit, die hier nicht gebraucht wird
give the value alone⇒bitte nur den Wert angeben
{} is not a whole…⇒{} ist keine ganze Zahl
--from {} must lie before --to {}⇒der Anfang, {} s, muss vor dem Ende, {} s, liegen
{}: no sample is left, the recording goes from {} to {} s⇒{}: kein Messwert bleibt, die Aufnahme geht von {} bis {} s
--temperature needs --disc-diameter:…⇒zur Lufttemperatur gehört der Durchmesser einer Scheibe
--rate is not a number…⇒die Messwerte je Sekunde müssen eine Zahl über 0 sein
--rate is not used: the times stand in {}⇒die Messwerte je Sekunde werden nicht gebraucht: die Zeiten stehen in {}
there is no time column:…⇒eine Zeitspalte fehlt: bitte die Messwerte je Sekunde angeben
--mass gives no stiffness here: column {} is no…⇒aus der Masse folgt hier keine Federkonstante: die Spalte {} ist keine Länge
no Reynolds number: column {} is neither…⇒keine Reynolds-Zahl: die Spalte {} ist weder Ort noch Geschwindigkeit
the period of {} s is longer than two windows…⇒die Periode von {} s ist lang für die Fenster der Reynolds-Zahl
--law {}: a pendulum's law is…⇒das Pendelgesetz ist eines für Winkel: bitte die kubische Feder oder einen Winkel wählen
position⇒Orte
angle⇒Winkel
angular velocity⇒Winkelgeschwindigkeiten
velocity⇒Geschwindigkeiten
acceleration⇒Beschleunigungen
the file is empty⇒die Datei ist leer
no rows of numbers are found: {} is not a number⇒keine Zeilen mit Zahlen gefunden: {} ist keine Zahl
no rows of numbers are found:…⇒keine Zeilen mit Zahlen gefunden: erwartet wird eine Tabelle mit Zahlen in Spalten
no rows of numbers are left…⇒keine Zeilen mit Zahlen bleiben übrig
this is a ZIP archive or…⇒das ist ein ZIP-Archiv oder ein Tabellenblatt: bitte auspacken oder als CSV ausgeben
this is a spreadsheet…⇒das ist ein Tabellenblatt: bitte als CSV ausgeben
this is a binary file (a zero byte at offset {})…⇒das ist eine Binärdatei (Nullbyte an Stelle {}): erwartet wird eine Text- oder CSV-Datei
the ZIP archive is locked…⇒das ZIP-Archiv ist mit einem Kennwort verschlossen: bitte ohne ausgeben
the ZIP archive claims…⇒das ZIP-Archiv gibt vor, weit mehr zu enthalten, als es groß ist
the ZIP archive holds no…⇒das ZIP-Archiv enthält keine CSV-Datei
the ZIP archive…⇒das ZIP-Archiv lässt sich nicht lesen: bitte auspacken
left out of the archive⇒aus dem Archiv weggelassen
it has no times⇒ohne Zeiten
MOST ROWS ARE LOST⇒DIE MEISTEN ZEILEN FEHLEN
the UTF-16 text is damaged:…⇒der UTF-16-Text ist beschädigt: bitte neu als UTF-8 ausgeben
it is a date: write the…⇒das ist ein Datum: gebraucht werden Sekunden seit dem Anfang
it is a clock time: write…⇒das ist eine Uhrzeit: gebraucht werden Sekunden seit dem Anfang
it has thousands separators…⇒Tausendertrennzeichen sind keine erlaubt
the decimal mark of this file is a point⇒das Dezimalzeichen dieser Datei ist ein Punkt
the decimal mark of this…⇒das Dezimalzeichen dieser Datei ist ein Komma
--skip-bad-rows drops…⇒bitte die Zeile in der Datei ausbessern oder entfernen
column {}: {} is not a number⇒Spalte {}: {} ist keine Zahl
{} is not a number⇒{} ist keine Zahl
there are more than {} columns⇒das sind mehr als {} Spalten
there are more values than the {} columns…⇒das sind mehr Werte als die {} Spalten
most rows are far shorter…⇒die meisten Zeilen sind weit kürzer als die breiteste
{}: it is open which commas…⇒{}: offen ist, welche Kommas Dezimalzeichen sind; bitte mit einem anderen Trennzeichen oder mit Punkten schreiben
the rows can be read in two ways:…⇒die Zeilen lassen sich auf zwei Arten lesen, mit Dezimalkomma und ohne: bitte mit Semikolon oder Tabulator trennen
column {}: the unit {} is no…⇒Spalte {}: {} ist keine Zeiteinheit: bitte s, ms, us, min oder h hinter den Namen schreiben
no column is called {}; there are {}⇒keine Spalte heißt {}; es gibt {}
{} fits several columns; there are {}⇒{} passt auf mehrere Spalten; es gibt {}
several columns are alike: {}; …⇒mehrere Spalten gleichen einander: {}; bitte eine wählen
several columns may be meant: what is said of times and outliers is that of {}…⇒mehrere Spalten kommen infrage: von Zeiten und Ausreißern ist die Rede in {}
there is no column beside…⇒neben der Zeit gibt es keine Spalte
there is no motion beside the time: {} {}; to fit one…⇒neben der Zeit gibt es keine Bewegung: {} {}; soll sie dennoch angepasst werden, bitte wählen
the last line, {}, seems cut within a number, {}: it is left out⇒die letzte Zeile, {}, bricht wohl in einer Zahl ab, {}: sie bleibt weg
the last line, {}, has no end and may end within a number, {}: it is kept⇒die letzte Zeile, {}, hat kein Ende und bricht vielleicht in einer Zahl ab, {}: sie bleibt
these laws need more integration steps than a record of this length is worth, as when noise looks like a fast swing: stopped before all laws were tried…⇒diese Gesetze brauchen mehr Rechenschritte, als eine Messung dieser Länge wert ist, wie bei Rauschen, das nach schnellem Schwingen aussieht: beendet, bevor alle Gesetze versucht waren
these laws need more integration steps than a record of this length is worth, as when noise looks like a fast swing: stopped before the fit was done⇒diese Gesetze brauchen mehr Rechenschritte, als eine Messung dieser Länge wert ist, wie bei Rauschen, das nach schnellem Schwingen aussieht: beendet, bevor die Anpassung fertig war
column {}: {} outliers, the first in line {}: {}⇒Spalte {}: {} Ausreißer, der erste in Zeile {}: {}
column {}: {} outlier, the first in line {}: {}⇒Spalte {}: {} Ausreißer, der erste in Zeile {}: {}
if what column {} holds drives the motion…⇒falls die Spalte {} enthält, was die Bewegung antreibt: mit cromer fit --force-column anpassen
holds a frequency⇒enthält eine Frequenz
hold frequencies⇒enthalten Frequenzen
no column is known to be a position, angle or velocity: {} is taken⇒keine Spalte ist als Ort, Winkel oder Geschwindigkeit bekannt: {} wird genommen
no column is known to be a position, angle or velocity: {}; …⇒keine Spalte ist als Ort, Winkel oder Geschwindigkeit bekannt: {}; bitte eine wählen
unit {} of column {} is not…⇒die Einheit {} der Spalte {} ist unbekannt: ihre Werte gelten, wie sie sind
column {} has no unit: its values…⇒die Spalte {} hat keine Einheit: ihre Werte gelten, wie sie sind
column {} has no unit: {} is assumed⇒die Spalte {} hat keine Einheit: {} wird angenommen
column {} of run {} has no values⇒die Spalte {} im Lauf {} hat keine Werte
column {} has no values⇒die Spalte {} hat keine Werte
column {} never changes⇒die Spalte {} ändert sich nie
column {}: from {} to {} is no step of time…⇒Spalte {}: von {} nach {} ist kein Zeitschritt; erwartet werden Sekunden
column {}: the motion's tops are cut…⇒Spalte {}: die Gipfel der Bewegung sind immer wieder beim selben Wert abgeschnitten: der Sensor war außerhalb seines Bereichs
column {}: values like {} are too…⇒Spalte {}: Werte wie {} lassen sich nicht quadrieren; bitte in einer anderen Einheit angeben
column {} holds {}: it is fitted…⇒die Spalte {} enthält {} und wird so angepasst
column {} holds a frequency, which is no…⇒die Spalte {} enthält eine Frequenz, keine Bewegung: ihre Zahlen gelten, wie sie sind, in Hz
the first column runs evenly…⇒die erste Spalte steigt gleichmäßig: sie gilt als Zeit in Sekunden
{} runs evenly…⇒{} steigt gleichmäßig: das gilt als Zeit in Sekunden
the line {} counts the rows: {} s is taken as their step⇒die Spalte {} zählt die Zeilen: {} s gelten als ihr Schritt
{} is measured in every {} row only⇒{} steht nur in jeder {} Zeile
there is no run {}: the file has …⇒einen Lauf {} gibt es nicht
run {} is called {} in the…⇒Lauf {} heißt in der Datei {}
the time starts again in line {}: the {} from there on are left…⇒die Zeit beginnt in Zeile {} von vorn: was dann kommt, {}, bleibt weg
the time starts again in line {}: the file is read as {} runs⇒die Zeit beginnt in Zeile {} von vorn: die Datei wird als {} Läufe gelesen
the time runs backward…⇒die Zeit läuft rückwärts
the time stands still:…⇒die Zeit steht still: alle ihre Werte sind gleich
{} in the times, the longest {} s at {} s⇒{} in den Zeiten, die längste {} s bei {} s
the times are rounded to {} s and agree with even ones {} s apart, which…⇒die Zeiten sind auf {} s gerundet und passen zu gleichmäßigen im Abstand {} s: diese gelten
{} with a {} time left out⇒{} weggelassen: die Zeit ist {}
repeated⇒wiederholt
missing⇒nicht da
backward⇒rückläufig
{} left out, {} kept⇒{} weggelassen, {} behalten
{} left out⇒{} weggelassen
{} sticks out alone⇒{} ragt allein heraus
{} stick out alone⇒{} ragen einzeln heraus
{} in {} of the sensor⇒{} in {} des Sensors
{}, the first in line {}⇒{}, die erste Stelle in Zeile {}
1 gap⇒eine Lücke
# gaps⇒{} Lücken
1 row⇒1 Zeile
# rows⇒{} Zeilen
1 bad row⇒1 schlechte Zeile
# bad rows⇒{} schlechte Zeilen
1 sample⇒1 Messwert
# samples⇒{} Messwerte
1 missing value⇒1 fehlender Wert
# missing values⇒{} fehlende Werte
1 drop-out⇒1 Aussetzer
# drop-outs⇒{} Aussetzern
set {} has no rows⇒der Satz {} hat keine Zeilen
the file holds no set of rows⇒die Datei enthält keinen Satz von Zeilen
{} samples are too few: a fit of the law {} needs at least {}⇒{} Messwerte sind zu wenige: das Gesetz {} braucht mindestens {}
all values are the same:…⇒alle Werte sind gleich: nichts bewegt sich
the motion comes to rest without oscillating: it is…⇒die Bewegung kommt zur Ruhe, ohne zu schwingen: sie ist überdämpft, oder nichts zieht sie zurück
the record ends before an oscillation…⇒die Aufnahme endet, bevor eine Schwingung zu sehen ist, wenn es eine ist: eine Anpassung braucht mindestens 1,5 Perioden
the record holds {} periods of {} s:…⇒die Aufnahme hat {} Perioden von {} s: gebraucht werden mindestens 1,5
too noisy: a sinusoid accounts for {} %…⇒zu viel Rauschen: eine Sinusschwingung erklärt nur {} % der Streuung
too noisy: the frequency is known to {} % only⇒zu viel Rauschen: die Frequenz ist nur auf {} % bekannt
the law {} fits so badly…⇒das Gesetz {} passt so schlecht, dass die Frequenz nicht bekannt ist
no oscillation found: the spectrum…⇒keine Schwingung gefunden: das Spektrum hat keine Linie
no oscillation found: the best decaying sinusoid accounts for {} % of…⇒keine Schwingung gefunden: die beste abklingende Sinusschwingung erklärt {} % der Streuung, was Rauschen auch könnte; bitte mit den Griffen den Teil wählen, der schwingt, oder eine andere Spalte
the motion's tops are cut…⇒die Gipfel der Bewegung sind immer wieder beim selben Wert abgeschnitten: der Sensor war außerhalb seines Bereichs; bitte den späteren Teil wählen
the values take {} levels only, {} apart: the resolution…⇒die Werte haben nur {} Stufen im Abstand {}: die Auflösung ist zu grob für eine so kleine Bewegung
the values take {} levels only, {} apart: the frequency follows…⇒die Werte haben nur {} Stufen im Abstand {}: die Frequenz folgt daraus, wann sie wechseln, doch Amplitude und Abklingrate zeigen sich kaum, und ihren Unsicherheiten ist nicht zu trauen; bitte feiner messen
this law's motion runs…⇒die Bewegung dieses Gesetzes läuft der aufgenommenen davon
the laws were compared on the first {} of {} samples; the one chosen…⇒die Gesetze wurden an den ersten {} von {} Messwerten verglichen; das gewählte ist an alle angepasst
what the force did between its samples is open: as {} the rms residual is {}, as {} it is {}: too close…⇒was die Kraft zwischen ihren Messwerten tat, ist offen: als {} gelesen ist der Effektivwert der Reste {}, als {} gelesen {}: zu nah beieinander für eine Entscheidung; die Unsicherheiten sind dafür geweitet
{} ({} of the stated standard errors away)⇒{} ({} Standardfehler entfernt)
the record does not show {}⇒die Aufnahme zeigt nichts von {}
only the ratio of {} and {} is known, {} ± {}⇒nur das Verhältnis von {} und {} ist bekannt, {} ± {}
only a combination of {} is known⇒nur eine Kombination von {} ist bekannt
dry friction⇒trockene Reibung
a body without a spring does not swing: only under a recorded force…⇒ein Körper ohne Feder schwingt nicht: nur unter einer aufgenommenen Kraft lässt sich sein Gesetz finden
a steady oscillation at {} Hz and its harmonic of order {}, which does not decay:…⇒eine gleichbleibende Schwingung bei {} Hz und ihre {}. Harmonische, die nicht abklingt: Rundung oder ein nicht linearer Sensor macht eine solche Linie, eine eigene Schwingung des Körpers ist nicht zu sehen
a decaying and a steady oscillation account for {} % of the variance only⇒eine abklingende und eine gleichbleibende Schwingung erklären nur {} % der Varianz
{} rad/s fits nearly as well as {} rad/s: how many periods passed in the gaps…⇒{} rad/s passt fast so gut wie {} rad/s: wie viele Perioden in den Lücken vergingen, ist nicht sicher
it must be at least 1, not {}⇒das muss mindestens 1 sein, nicht {}
its uncertainty must be zero or more, not {}⇒die Unsicherheit darf nicht negativ sein: {}
be at least 1⇒mindestens 1 sein
the record has two readings: {}⇒die Aufnahme lässt sich auf zwei Arten lesen: {}
the record does not determine this law: only a combination of {} is…⇒die Aufnahme legt dieses Gesetz nicht fest: nur eine Kombination von {} ist bekannt
the record does not determine this law: only the ratio of {} and {} is known, {} ± {}⇒die Aufnahme legt dieses Gesetz nicht fest: nur das Verhältnis von {} und {} ist bekannt, {} ± {}
the record does not determine this law: the record does not show {}⇒die Aufnahme legt dieses Gesetz nicht fest: sie zeigt nichts von {}
the record does not determine…⇒die Aufnahme legt dieses Gesetz nicht fest: seine Glieder lassen sich nicht trennen
the fit has not settled after {} iterations⇒die Anpassung kommt nach {} Schritten nicht zur Ruhe
line {}: the time jumps from {} to {} s;…⇒Zeile {}: die Zeit springt von {} auf {} s; bitte mit den Griffen eine Seite wählen
{}: only what follows, {} of {} samples, is taken…⇒{}: nur was folgt, {} von {} Messwerten, gilt als freie Bewegung
the motion is driven, at {} Hz: a free motion would leave {}, this leaves {};…⇒die Bewegung ist angetrieben, mit {} Hz: eine freie ließe {} übrig, diese {}; bitte mit den Griffen einen freien Teil wählen
two oscillations whose decay hardly shows, at {} and {}:…⇒zwei Schwingungen, deren Abklingen sich kaum zeigt, mit {} und {}: ein Antrieb ohne Dämpfung, zwei Antriebe und gekoppelte Pendel sehen so aus
beside the drive something oscillates at {} and does not decay:…⇒neben dem Antrieb schwingt etwas mit {} und klingt nicht ab: ein anderer Antrieb und ein Körper ohne Dämpfung sehen so aus; die Zahlen hier gelten für den Körper
no single swing: {}. Let one…⇒keine einzelne Schwingung: {}. Bitte eine allein schwingen lassen oder eine andere Spalte wählen
two modes swing here, and both decay, as of coupled pendulums: {} and {}; they beat every {} s; together…⇒hier schwingen zwei Moden, die beide abklingen, wie bei gekoppelten Pendeln: {} und {}; sie schweben mit einer Periode von {} s
two modes swing here, and both decay, as of coupled pendulums: {} and {}; they beat every {} s⇒hier schwingen zwei Moden, die beide abklingen, wie bei gekoppelten Pendeln: {} und {}; sie schweben mit einer Periode von {} s
{}; together they leave {}, and the law {}⇒{}; zusammen lassen sie {} übrig, das Gesetz {}
{} (amplitude {}, decay rate {})⇒{} (Amplitude {}, Abklingrate {})
--disc-diameter gives no Reynolds number…⇒zu einer angetriebenen Bewegung gibt es keine Reynolds-Zahl
the amplitude stays level until {} s…⇒die Amplitude bleibt bis {} s gleich und fällt erst dann, wie wenn ein Antrieb endet
it is held still until {} s and then…⇒bis {} s wird festgehalten, dann losgelassen
it is held still until {} s⇒bis {} s wird festgehalten
the sensor loses the motion at {} s: in full swing the column stays at {} from there on, in {} % of the samples. Only what comes before, {} of {} samples, is…⇒der Sensor verliert die Bewegung bei {} s: mitten im Schwingen bleibt die Spalte von da an bei {}, in {} % der Messwerte. Angepasst wird nur, was davor liegt, {} von {} Messwerten
the zero drifts, by {} over…⇒der Nullpunkt wandert, um {} in der ganzen Aufnahme: bitte einen kürzeren Teil wählen
the zero jumps by {} at {} s…⇒der Nullpunkt springt um {} bei {} s: bitte mit den Griffen eine Seite wählen
the swing stops between {} and {} s,…⇒die Schwingung endet zwischen {} und {} s binnen einer Periode, wie von einer Hand gehalten: bitte vorher enden
only {} samples in a period: sampled at {} Hz, a swing of {} or {} Hz would…⇒nur {} Messwerte je Periode: bei {} Hz sähe eine Schwingung von {} oder {} Hz genauso aus; schneller messen, wenn es eine davon sein kann
the angle goes through {} turns:…⇒der Winkel durchläuft {} Umdrehungen: das Pendel überschlägt sich
the swing does not die down over {} periods.…⇒die Schwingung klingt über {} Perioden nicht ab. Treibt sie etwas an, so sind Frequenz und Federkonstante nicht die der Feder
the amplitude falls by {} % only over {} periods (quality factor {}): a drive…⇒die Amplitude fällt über {2} Perioden nur um {1} % (Güte {3}): ein nicht ganz gleichmäßiger Antrieb sähe genauso aus. Treibt sie etwas an, so sind Frequenz und Federkonstante nicht die der Feder
the frequency is the drive's, and the stiffness that follows…⇒Frequenz und Federkonstante sind dann nicht die der Feder
the law {} does not describe this recording: what is left is {} times…⇒das Gesetz {} beschreibt diese Aufnahme nicht: übrig bleibt das {}-Fache des Rauschens, und den Unsicherheiten ist nicht zu trauen
no law tried describes this recording: what is left is {} times…⇒kein Gesetz beschreibt diese Aufnahme: übrig bleibt das {}-Fache des Rauschens, und den Unsicherheiten ist nicht zu trauen
the amplitude rises {} between {} and {} s: something…⇒die Amplitude steigt zwischen {2} und {3} s ({1}): etwas treibt sie, zwei Bewegungen schweben, oder eine negative Dämpfung nährt sie wie in viscous+van-der-pol. Frequenz und Federkonstante sind dann vielleicht nicht die der Feder
the swing keeps itself over {} periods: negative…⇒die Schwingung hält sich über {} Perioden selbst: eine negative Dämpfung gibt ihr, was der Rest nimmt. Ein gleichmäßiger Antrieb sähe fast genauso aus: dann sind Frequenz und Federkonstante nicht die der Feder
the hysteretic force is taken as 0 at the first sample…⇒die hysteretische Kraft gilt beim ersten benutzten Messwert, --from, als 0: hat der Körper sich vorher bewegt, so stimmen ihre Beiwerte und die Federkonstante nicht, und ihre Unsicherheiten gelten nicht
--hysteresis-exponent has no effect on the law {}, which…⇒--hysteresis-exponent bewirkt beim Gesetz {} nichts: es hat keine Hysterese
by {} %⇒um {} %
{}-fold⇒auf das {}-Fache
the last {} s are shorter than a segment of {} s, and in none⇒die letzten {} s sind kürzer als ein Abschnitt von {} s und gehören zu keinem
the residuals are correlated ({} at {} samples apart), but…⇒die Reste hängen zusammen ({} im Abstand von {} Messwerten), doch nicht bei der Frequenz der Schwingung: die Unsicherheiten von Frequenz und Abklingrate sind kaum geweitet
the residuals are correlated ({} at {} samples apart): the…of {} independent…⇒die Reste hängen zusammen ({} im Abstand von {} Messwerten): die Unsicherheiten sind geweitet, wie von {} unabhängigen Messwerten
the residuals are correlated ({} from sample to sample), but…⇒die Reste hängen zusammen ({} von Messwert zu Messwert), doch nicht bei der Frequenz der Schwingung: die Unsicherheiten von Frequenz und Abklingrate sind kaum geweitet
the residuals are correlated ({} from sample to sample): the…of {} independent…⇒die Reste hängen zusammen ({} von Messwert zu Messwert): die Unsicherheiten sind geweitet, wie von {} unabhängigen Messwerten
the frequency changes along the record: one decaying sinusoid accounts for {} %…⇒die Frequenz ändert sich im Lauf der Aufnahme: eine abklingende Sinusschwingung erklärt nur {} % der Streuung
the record does not tell after…probability of {} %, …⇒die Aufnahme sagt nicht, nach wie vielen halben Schwingungen die Bewegung zur Ruhe kam: eine andere Zahl ist zu {} % wahrscheinlich, die Bereiche sind dafür geweitet
this record cannot tell {} from {}:…Known whichever it is: {}⇒diese Aufnahme kann {} und {} nicht trennen: die Unsicherheiten gelten nur, wenn das Gesetz stimmt. In jedem Fall bekannt: {}
this record cannot tell {} from {}: the uncertainties hold only if the law is right⇒diese Aufnahme kann {} und {} nicht trennen: die Unsicherheiten gelten nur, wenn das Gesetz stimmt
the laws were compared on {} of the {} samples…⇒die Gesetze wurden an {} von {} Messwerten verglichen; das gewählte ist an alle angepasst
the {} is on its bound 0: the…⇒{} liegt an der Grenze 0: die Aufnahme zeigt nichts davon
the 95 % interval of the {} is cut at its bound 0:…⇒der 95-%-Bereich ist an der Grenze 0 abgeschnitten ({}): die Aufnahme zeigt nicht, ob es das gibt
the damping terms of {} cannot be told apart here: their sum is known, {}, its…⇒die Dämpfungsglieder von {} lassen sich hier nicht trennen: bekannt ist ihre Summe, {}, nicht ihre Teile
decay rate {} at the record's…⇒Abklingrate {} bei der mittleren Amplitude der Aufnahme
decay rate⇒Abklingrate
friction⇒trockene Reibung
drag⇒Luftwiderstand
what the law leaves oscillates at {} Hz, at first with an amplitude of {} ({} % of…⇒was das Gesetz übrig lässt, schwingt mit {} Hz, anfangs mit einer Amplitude von {} ({} % der Schwingung): eine Oberschwingung oder eine zweite Bewegung, oder die Halterung rüttelt
what the law leaves oscillates at {} Hz, at first with an amplitude of {}: {}⇒was das Gesetz übrig lässt, schwingt mit {} Hz, anfangs mit einer Amplitude von {}: {}
{} times the drive's, as of a…⇒das {}-Fache des Antriebs, wie bei einer Feder oder einem Sensor, die nicht linear sind
another drive, or another swing⇒ein anderer Antrieb oder eine andere Schwingung
one sample lies far…at {} s,…⇒ein Messwert liegt weit von Bewegung und Nachbarn, bei {} s, und ist beiseitegelegt
{} lie far…at {} s,…⇒{} liegen weit von Bewegung und Nachbarn, der erste bei {} s, und sind beiseitegelegt
{} in flat runs…at {} s,…⇒{} in flachen Stücken weit außerhalb der Bewegung, das erste bei {} s, sind als Aussetzer des Sensors beiseitegelegt
--position: the energy…⇒die Energie am Anfang übersteigt die größte Zahl: bitte Ort oder Geschwindigkeit verkleinern
--step: {} s up to {} s are {} steps, too many to be…⇒{} s bis {} s sind {} Schritte, zu viele: bitte länger schreiten
did you mean {}?⇒ist {} gemeint?
{} is gone; it is tried…⇒{} ist weg; es wird weiter versucht, bis es wieder da ist
{} is back after {} s⇒{} ist nach {} s wieder da
nothing for {} s from {} s on⇒{} s lang nichts, ab {} s
line {} is no sample: {}⇒Zeile {} ist kein Messwert: {}
# lines were no samples⇒{} Zeilen waren keine Messwerte
the device gave {} s, which is no time; {} s is taken instead⇒das Gerät nannte {} s, was keine Zeit ist; stattdessen gilt {} s
the device gave the time {} s twice⇒das Gerät nannte die Zeit {} s zweimal
the device's clock jumped {} by {} s at {} s;…⇒die Uhr des Geräts sprang {} um {} s bei {} s; die Zeiten gehen nach dem Rechner weiter
forward⇒vorwärts
back⇒zurück
the device's times run {} times as fast…⇒die Zeiten des Geräts laufen {}-mal so schnell wie die Uhr: --time-unit sagt, worin sie stehen
phyphox at {} does not answer: {}; …⇒phyphox auf {} antwortet nicht ({}); es wird weiter gefragt
no answer in time⇒zu spät
no answer⇒nichts kommt
the connection was closed⇒die Verbindung wurde geschlossen
the phone was not measuring; its experiment {} was started…⇒das Telefon maß nicht; sein Experiment {} wurde gestartet
the phone measures again⇒das Telefon misst wieder
the measurement was stopped…⇒die Messung wurde am Telefon angehalten; dort starten, um fortzufahren
the phone's data were cleared;…⇒die Daten des Telefons wurden gelöscht; seine Zeiten beginnen von vorn
the phone has no buffer {} any more: another⇒das Telefon hat den Puffer {} nicht mehr: ein anderes Experiment wurde geöffnet
{} exists and is not empty…⇒{} gibt es schon; eine Aufnahme überschreibt nichts: bitte einen anderen Namen wählen
cannot write {}: {}⇒{} lässt sich nicht schreiben: {}
"for": it must be positive⇒die Dauer muss größer als 0 sein
there is no such recording⇒diese Aufnahme gibt es nicht
the recording is gone⇒die Aufnahme ist weg
column {}⇒Spalte {}
"{}" is {}⇒"{}" ist {}`

    interface Entry {
  pattern: RegExp
  german: string
}
let table: Entry[] | undefined

const entryOf = (line: string): Entry => {
  const [words, german] = line.split('⇒') as [string, string]
  const pattern = words
    .replace(/[.*+?^$()|[\]\\]/g, '\\$&')
    .replaceAll('{}', '((?:(?![;:] ).)+?)')
    .replaceAll('#', '([\\d.]+)')
    .replaceAll('…', '.*')
  return { pattern: new RegExp(`^${pattern}$`, 's'), german }
}

/// The whole text by one line of the table; null where none has it.
function whole(text: string): string | null {
  table ??= lines.split('\n').map(entryOf)
  for (const { pattern, german } of table) {
    const found = pattern.exec(text)
    if (!found) continue
    let next = 0
    return german.replace(/\{(\d?)\}/g, (_, given: string) => put(found[given ? Number(given) : ++next]!))
  }
  return null
}

/// What was put in: words are translated, numbers get their comma; names and what was typed stay.
const put = (text: string): string =>
  whole(text) ??
  (/^"|[a-z]\.[a-z]/i.test(text)
    ? text
    : text.replace(/(\d)\.(?=\d)/g, '$1,').replaceAll('decay rate', 'Abklingrate').replaceAll(' or ', ' oder '))

/// Clause by clause, if the first one is known; else what follows a colon, if that is.
function part(text: string): string | null {
  const all = whole(text)
  if (all !== null) return all
  const [first, ...others] = text.split('; ')
  const begun = others.length > 0 ? part(first!) : null
  if (begun !== null) return [begun, ...others.map((each) => part(each) ?? each)].join('; ')
  for (let colon = text.indexOf(': '); colon > 0; colon = text.indexOf(': ', colon + 1)) {
    const rest = part(text.slice(colon + 2))
    const head = whole(text.slice(0, colon))
    if (head !== null || rest !== null) return `${head ?? text.slice(0, colon)}: ${rest ?? text.slice(colon + 2)}`
  }
  return null
}

/// A message; one that is not in the table stays as it is.
export const core = (text: string): string => part(text)?.replace(/"([^"]*)"/g, '„$1“') ?? text
