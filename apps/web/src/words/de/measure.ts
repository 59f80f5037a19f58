import type { measure as en } from '../en/measure'

export const measure: typeof en = {
  title: 'Messen',
  drop: {
    title: 'Eine Aufnahme hier ablegen oder eine Datei wählen',
    now: 'Loslassen: Die Aufnahme wird hier gelesen und bleibt auf diesem Rechner.',
    caption:
      'Texttabellen von PASCO Capstone, DataStudio, Tracker, phyphox, Logger Pro, LabVIEW und anderen werden erkannt, mit Dezimalkomma, Läufen und Lücken. Nichts wird hochgeladen.',
    choose: 'Datei wählen',
    another: 'Andere Datei öffnen',
    paste: 'Tabelle einfügen',
    pasteHere: 'Die Tabelle hier einfügen, mit ihrer Kopfzeile',
    usePasted: 'Tabelle lesen',
    pasted: 'eingefuegt.csv',
    examples: 'Keine Aufnahme zur Hand? Diese drei sind synthetisch: simuliert, mit dem Rauschen eines Sensors.',
    tooLarge: (size) => `Die Datei hat ${size}; die Seite liest bis 250 MB. Für sie ist das Programm da.`,
    notRead: 'Diese Datei ließ sich nicht lesen.'
  },
  examples: {
    disc: { name: 'Scheibe in Luft', about: '217,6 g, Scheibe von 12 cm, 120 s: zähe Dämpfung und Luftwiderstand' },
    plain: { name: 'Einfache Dämpfung', about: '200,8 g, 40 s: eine Abklingrate beschreibt sie' },
    rubbing: { name: 'Trockene Reibung', about: '250 g, 12 s: reibt an einer Führung und bleibt stehen' }
  },
  synthetic: 'synthetisch: simuliert',
  dropped: 'eben gelesen',
  file: {
    title: 'Die Datei',
    dialect: 'Format',
    column: 'Spalte',
    run: 'Lauf',
    samples: 'Messwerte',
    repaired: 'Ausgebessert',
    rate: 'Messwerte je Sekunde',
    at: (count, rate) => `${count} mit ${rate}`,
    decimalComma: 'Dezimalkomma',
    nothing: 'nichts auszubessern',
    spikes: (count) => `${count} Ausreißer beiseitegelegt`,
    gaps: (count, longest) => (count === 1 ? `1 Lücke von ${longest}` : `${count} Lücken, bis ${longest}`),
    remarks: (count) => `${count} ${count === 1 ? 'Bemerkung' : 'Bemerkungen'} zur Datei`
  },
  recording: {
    title: 'Aufnahme',
    free: (from, to) => `Freier Teil ${from} bis ${to}: die Griffe ziehen oder mit den Pfeiltasten schieben.`,
    frame: 'Der Rahmen steht unten größer.',
    whole: 'Alles verwenden',
    amplitude: 'Amplitude des angepassten Gesetzes',
    spike: 'Ausreißer, beiseitegelegt',
    gap: (length) => `Lücke ${length}`,
    start: 'Anfang des freien Teils',
    end: 'Ende des freien Teils',
    frameName: 'Rahmen, der größer gezeigt wird',
    time: 'Zeit t (s)',
    timeSymbol: ['Zeit ', 't', ' (s)'],
    seen: (what, count, from, to) => `${what} gegen die Zeit: ${count} Messwerte von ${from} bis ${to}.`
  },
  fit: {
    title: 'Anpassung, und was sie übrig lässt',
    white: (rms) => `Ein Punkt je Messwert. Die Reste haben kein Muster: ${rms} quadratisches Mittel, das Rauschen des Sensors.`,
    pattern: (rms) => `Ein Punkt je Messwert. Die Reste haben ein Muster: ${rms} quadratisches Mittel, mehr als Rauschen.`,
    measured: 'gemessen',
    fitted: (law) => `angepasst: ${law}`,
    residual: (unit) => `gemessen − angepasst (${unit})`,
    missed: (most) =>
      `gestrichelt: was eine feste Abklingrate verfehlt, hier bis ${most}; Band: 95 % der Reste`,
    band: 'Band: 95 % der Reste',
    working: 'Die Gesetze werden verglichen; dies ist bisher das bessere von zweien.',
    workingFirst: 'Das Gesetz wird angepasst.',
    again: 'Mit dem neuen Teil neu angepasst.',
    none: 'Es gibt keine Anpassung.',
    overlay: 'Neben Simulationen',
    grows: 'wächst ohne Ende',
    narrower: 'Rahmen kürzer',
    wider: 'Rahmen länger',
    seen: (from, to, most) =>
      `Gemessene Punkte und das angepasste Gesetz, ${from} bis ${to}. Die Reste bleiben unter ${most}.`
  },
  law: {
    title: 'Das Gesetz dieses Schwingers',
    other: 'anderes wählen',
    auto: 'die Aufnahme entscheiden lassen',
    chosen: (others, term, before, after) =>
      `Unter ${others} anderen gewählt: ${term} senkt die Reste von ${before} auf ${after}.`,
    best: (others, rms) => `Unter ${others} anderen gewählt; übrig bleiben ${rms}.`,
    set: (law, rms) => `${law}, wie gewählt. Übrig bleiben ${rms}.`,
    term: {
      viscous: 'das zähe Glied',
      drag: 'der Luftwiderstand',
      friction: 'die trockene Reibung',
      cubic: 'die kubische Feder'
    },
    names: {
      viscous: 'zäh',
      drag: 'Luftwiderstand',
      friction: 'trockene Reibung',
      cubic: 'kubische Feder',
      pendulum: 'Pendel'
    },
    value: 'Wert',
    interval: '95-%-Bereich',
    to: 'bis',
    at: (time) => `bei ${time}`,
    mass: 'Masse',
    disc: 'Scheibe',
    air: 'Luft',
    change: 'ändern',
    done: 'fertig',
    none: 'fehlt',
    massHint: 'mit ihrem ±, wie „217,6 ± 0,3 g“',
    giveMass: 'Mit der Masse folgen Federkonstante und Dämpfung in kg/s.',
    wide: 'Die Unsicherheiten sind geweitet, denn die Reste haben ein Muster.'
  },
  quantities: {
    stiffness: ['Federkonstante', 'k'],
    damping: ['Dämpfung', 'c'],
    drag_constant: ['Luftwiderstand', 'd'],
    drag_coefficient: ['Widerstandsbeiwert', 'C'],
    friction_force: ['trockene Reibung', 'f'],
    friction: ['Reibung / Masse', 'f/m'],
    cubic: ['kubisch / Masse', 'k₃/m'],
    cubic_stiffness: ['kubische Steifigkeit', 'k₃'],
    angular_frequency: ['Kreisfrequenz', 'ω₀'],
    decay_rate: ['Abklingrate', 'γ'],
    drag: ['Widerstand / Masse', 'd/m'],
    frequency: ['Frequenz', 'f₀'],
    quality_factor: ['Güte', 'Q'],
    reynolds: ['größte Reynolds-Zahl', '']
  },
  observed: {
    position: 'Ort',
    angle: 'Winkel',
    velocity: 'Geschwindigkeit',
    'angular velocity': 'Winkelgeschwindigkeit',
    acceleration: 'Beschleunigung',
    voltage: 'Spannung',
    force: 'Kraft'
  },
  decay: {
    title: 'Abklingrate gegen Amplitude',
    rate: 'Abklingrate (1/s)',
    amplitude: (unit) => ['Amplitude ', 'A', ` (${unit})`],
    constant: (rate) => `eine feste Rate, ${rate}`,
    law: (text) => `Gesetz: ${text}`,
    lawOnly: 'angepasstes Gesetz',
    dots: 'Punkte: Stücke der Aufnahme, 95-%-Bereiche',
    none: 'Die Aufnahme ist zu kurz, um sie in Stücke zu teilen.',
    seen: (first, last, from, to) => `Abklingrate ${first} bei der Amplitude ${from}, ${last} bei ${to}.`
  },
  story: {
    notEnough: 'Eine Abklingrate genügt nicht.',
    falls: (from, to) => `Sie fällt von ${from} auf ${to} 1/s, während die Schwingung abklingt; anzugeben ist das Gesetz.`,
    rises: (from, to) => `Sie steigt von ${from} auf ${to} 1/s, während die Schwingung abklingt; anzugeben ist das Gesetz.`,
    enough: 'Eine Abklingrate genügt.',
    enoughWhy: (rate) => `Bei jeder Amplitude ist sie ${rate} im Rahmen ihrer Unsicherheit.`,
    limits: (of) => ['Die Masse begrenzt ', of, '.'],
    limitsWhy: (uncertainty, rest) => `Von ihren ± ${uncertainty} verursacht die Waage alles bis auf ${rest}.`,
    limitsAll: (uncertainty) => `Von ihren ± ${uncertainty} verursacht die Waage praktisch alles.`,
    timeLimits: 'Die Aufnahme begrenzt k.',
    timeLimitsWhy: (part) => `Die Waage verursacht ${part} der Unsicherheit.`,
    reynolds: 'Die Strömung ist nicht laminar.',
    reynoldsWhy: (largest) =>
      `Die Reynolds-Zahl erreicht ${largest}: ein Widerstand mit dem Quadrat der Geschwindigkeit ist zu erwarten.`,
    core: 'Der Rechenkern meldet',
    more: (count) => `${count} weitere`
  },
  overlay: {
    title: 'Das Gesetz, simuliert',
    caption: 'Das angepasste Gesetz, von zwei Verfahren vom selben Anfang aus gerechnet, neben der Aufnahme.',
    energy: 'Energie',
    phase: 'Phase',
    energyAxis: (unit) => ['Energie ', 'E', ` (${unit})`],
    velocityAxis: (unit) => ['Geschwindigkeit ', 'v', ` (${unit})`],
    displacementAxis: (unit) => ['Auslenkung ', 'x', ` (${unit})`],
    exact: 'exaktes Gesetz',
    show: 'Simulationen zeigen',
    hide: 'Simulationen ausblenden',
    says: (method, amplitude, phase) =>
      `${method}: Am Ende hat die Amplitude ${amplitude} von der des Gesetzes, die Phase weicht um ${phase} ab.`,
    grown: (method) => `${method} wächst bei diesem Schritt ohne Ende.`,
    constantEnd: (off) => `Mit einer festen Abklingrate liegt die Amplitude am Ende um ${off} daneben.`,
    step: (step) => `Schritt ${step}.`
  },
  command: 'Befehl kopieren',
  commandCopied: 'Der Befehl ist kopiert.',
  numbers: { show: 'Zahlen zeigen', hide: 'Zahlen ausblenden' }
}
