import type { Said } from '../said'

// What the program names by options stands elsewhere in the page.
const inThePage: [RegExp, string][] = [
  [/ für fit --drive-frequency angeben, falls bekannt, oder mit --from und --to einen/, ' mit den Griffen einen'],
  [/ mit --from und --to| mit --from/, ' mit den Griffen'],
  [/bitte mit --rate die Messwerte je Sekunde angeben oder mit --time-column die Spalte nennen/, 'bitte die Messwerte je Sekunde angeben'],
  [/ oder mit --time-column eine andere Spalte nennen/, ''],
  [/bitte mit --column (?:eine )?nennen, zum Beispiel --column („[^“]*“)/, 'bitte eine wählen, zum Beispiel $1'],
  [/ oder mit --column eine andere Spalte/, ' oder eine andere Spalte'],
  [/eine Anpassung braucht --column/, 'für eine Anpassung bitte eine wählen'],
  [/mit --skip-bad-rows bleiben solche Zeilen weg/, 'bitte die Zeile in der Datei ausbessern oder entfernen'],
  [/^--drive-amplitude: /, ''],
]

export const core = (said: Said): string =>
  typeof said === 'string' ? said : inThePage.reduce((text, [option, page]) => text.replace(option, page), said.de)
