import type { glossary as en } from '../en/glossary'

export const glossary: Record<keyof typeof en, string> = {
  law: 'Das Bewegungsgesetz: welche Kräfte auf die Masse wirken, und wie jede von Ort und Geschwindigkeit abhängt.',
  stiffness: 'Wie stark die Feder je Meter Dehnung zurückzieht.',
  damping: 'Zähe Dämpfung: eine Kraft gegen die Bewegung, proportional zur Geschwindigkeit, wie in langsamer Strömung. Die Amplitude fällt dann bei jeder Schwingung um denselben Anteil.',
  decay_rate: 'Nach der Zeit 1/γ ist die Amplitude auf 37 % gefallen. Ein kleines γ, mal hundert: um so viele Prozent fällt sie in einer Sekunde.',
  drag: 'Eine Kraft gegen die Bewegung, die mit dem Quadrat der Geschwindigkeit wächst, wie in schneller Strömung: große Schwingungen verlieren mehr als kleine.',
  friction: 'Trockene Reibung: eine gleich große Kraft gegen die Bewegung, wie von einer reibenden Führung. Die Amplitude fällt bei jeder Schwingung um dieselbe Länge, und die Bewegung hört auf.',
  cubic: 'Eine Feder, die steifer (oder weicher) wird, je weiter sie gedehnt ist.',
  drag_coefficient: 'Wie sehr die Form eines Körpers der Strömung widersteht: etwa 1 für eine Scheibe in stetigem Wind, mehr, wenn sie hin und her schwingt.',
  angular_frequency: 'Schwingungen je Sekunde mal 2π, in Radiant je Sekunde.',
  frequency: 'Schwingungen je Sekunde.',
  quality_factor: 'Nach wie vielen Schwingungen wenig übrig ist: nach Q davon ist die Energie auf wenige Tausendstel gefallen. Hohe Güte: es schwingt lange.',
  reynolds: 'Geschwindigkeit mal Größe durch die Zähigkeit der Luft. Klein: die Luft fließt glatt um den Körper. Über einigen Hundert wirbelt sie, und der Widerstand wächst mit dem Quadrat der Geschwindigkeit.',
  residual: 'Was bleibt, wenn man das Gesetz von der Aufnahme abzieht. Stimmt das Gesetz, so bleibt nur das Rauschen des Sensors, ohne Muster.',
  interval: 'In 95 von 100 solchen Aufnahmen liegt der wahre Wert in dem Bereich, den sie angeben.',
  chosen: 'Gesetze werden danach verglichen, wie gut sie die Aufnahme beschreiben und wie viele Zahlen sie dafür brauchen (Bayessches Informationskriterium, BIC): ein Glied muss seinen Platz verdienen.',
  simulated: 'Ein Verfahren hat eigene Dämpfung: es simuliert einen anderen Schwinger als den verlangten. Dies ist dessen Abklingrate.',
  free_part: 'Der Teil der Aufnahme, in dem nichts die Masse berührt oder antreibt: nur dort zeigt sie ihr eigenes Gesetz.',
}
