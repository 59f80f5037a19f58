import type { StepWords, teach as en } from '../en/teach'

export const teach: typeof en = {
  labs: 'Praktika',
  lab: { one: 'Versuch eins', two: 'Versuch zwei' },
  oneTitle: 'Angetriebene Resonanz',
  twoTitle: 'Dämpfung in Luft',
  about: (steps, minutes) =>
    `${steps} Schritte, etwa ${minutes} Minuten. Ihr Stand bleibt in der Adresse dieser Seite.`,
  stepOf: (step, of) => `Schritt ${step} von ${of}`,
  stepDone: 'erledigt',
  predictFirst: 'Zuerst: was erwarten Sie?',
  expected: (what) => `Sie erwarten: ${what}.`,
  asExpected: 'Wie erwartet.',
  otherThanExpected: (what) => `Erwartet war: ${what}.`,
  back: 'Zurück',
  next: (title) => `Weiter: ${title}`,
  controls: {
    position: ['Ort', 'x₀', 'm', 'Meter'],
    damping: ['Dämpfung', 'c', 'kg/s', 'Kilogramm je Sekunde'],
    driveFrequency: ['Antriebsfrequenz', 'ω', 'rad/s', 'Radiant je Sekunde'],
    step: ['Schritt', 'h', 's', 'Sekunden']
  },
  plot: {
    position: 'Ort',
    x: 'Ort',
    t: 'Zeit',
    caption: (drive, start, step) => `${drive}, ${start}, Schritt ${step}`,
    noDrive: 'ohne Antrieb',
    drive: (frequency) => `Antrieb mit ${frequency}`,
    rest: 'aus der Ruhe',
    from: (position) => `ab ${position}`,
    reach: 'Reichweite ohne Dämpfung: kein Ende',
    steady: (value) => `Amplitude am Ende ${value}`,
    grows: 'wächst ohne Ende'
  },
  one: [
    {
      title: 'Eine Masse an einer Feder',
      predict: { ask: 'Doppelt so weit gezogen: wie lange dauert eine Schwingung?', options: ['doppelt so lange', 'genauso lange', 'halb so lange'], right: 1, told: 'Genauso lange: die Periode hängt nicht davon ab, wie weit gezogen wurde.' },
      text: 'Eine Masse von 1 kg hängt an einer Feder von 9 N/m. Anheben und loslassen: **Ort *x*₀** auf **1 m** schieben und die Schwingungen zählen. Dann 2 m versuchen.',
      goal: 'Zu tun: *x*₀ ist 1 m',
      done: 'Erledigt: *x*₀ ist 1,00 m',
      whyTitle: 'Warum dauert eine Schwingung 2,09 s?',
      why: 'Die Feder zieht mit *k x*, die Masse antwortet mit *m x*″. Also *ω*₀ = √(*k*/*m*) = √(9 N/m / 1 kg) = 3 rad/s und *T* = 2π/*ω*₀ = 2,09 s, wie weit auch gezogen wurde.',
      next: 'anstoßen'
    },
    {
      title: 'Im eigenen Takt anstoßen',
      predict: { ask: 'Was geschieht, wenn sie im eigenen Takt angestoßen wird?', options: ['sie schwingt immer gleich weit', 'sie wächst ohne Ende', 'sie wächst bis zu einer bestimmten Amplitude'], right: 1, told: 'Sie wächst ohne Ende: nichts nimmt die Energie weg.' },
      text: 'Jetzt beginnt sie in Ruhe, und eine Kraft von 1 N schiebt sie hin und her. Die **Antriebsfrequenz *ω*** von 1 auf **3 rad/s** schieben, ihre eigene, und sehen, wie weit sie kommt.',
      goal: 'Zu tun: *ω* ist 3 rad/s',
      done: 'Erledigt: *ω* ist 3,00 rad/s',
      whyTitle: 'Warum wächst sie ohne Ende?',
      why: 'Im eigenen Takt schiebt die Kraft immer in Richtung der Bewegung, und nichts nimmt die Energie wieder fort. Die Schwingung gewinnt *F*/(2*mω*) = 0,167 m in jeder Sekunde.',
      next: 'dämpfen'
    },
    {
      title: 'Dämpfung dazu',
      predict: { ask: 'Was ändert ein wenig Dämpfung?', options: ['nichts: sie wächst wie zuvor', 'das Wachsen endet bei einer Amplitude', 'die Schwingung stirbt aus'], right: 1, told: 'Das Wachsen endet, wo die Dämpfung so viel nimmt, wie der Antrieb gibt.' },
      text: 'Ohne Dämpfung wuchs die Schwingung ohne Ende. Die **Dämpfung *c*** von 0 auf **0,2 kg/s** schieben und sehen, wo das Wachsen aufhört.',
      goal: 'Zu tun: *c* ist 0,2 kg/s',
      done: 'Erledigt: *c* ist 0,200 kg/s',
      whyTitle: 'Warum hört es bei 1,67 m auf?',
      why: 'In der Resonanz ersetzt der Antrieb nur, was die Dämpfung nimmt: *F* = *cωA*. Also *A* = 1 N / (0,2 kg/s · 3 rad/s).',
      next: 'weg davon'
    },
    {
      title: 'Weg von der Resonanz',
      predict: { ask: 'Langsamer angestoßen als im eigenen Takt: wie weit schwingt sie am Ende?', options: ['weiter', 'etwa gleich weit', 'viel weniger weit'], right: 2, told: 'Viel weniger weit: die Feder hält der Kraft stand.' },
      text: 'Langsamer anstoßen, als ihr lieb ist: die **Antriebsfrequenz *ω*** auf **2 rad/s** schieben. Die ersten Schwingungen schweben; warten, bis sie vorbei sind.',
      goal: 'Zu tun: *ω* ist 2 rad/s',
      done: 'Erledigt: *ω* ist 2,00 rad/s',
      whyTitle: 'Warum nur 0,20 m?',
      why: 'Neben der Resonanz hält die Feder gegen die Kraft: *A* = *F*/√((*k* − *mω*²)² + (*cω*)²) = 1 N / 5,02 N/m. Das ist ein Achtel der Schwingung in der Resonanz.',
      next: 'anderes Verfahren'
    },
    {
      title: 'Ein Verfahren, das dämpft',
      predict: { ask: 'Zwei Verfahren rechnen dasselbe Gesetz in gleichen Schritten. Wo enden sie?', options: ['bei derselben Amplitude', 'Euler implizit niedriger', 'Euler implizit höher'], right: 1, told: 'Euler implizit endet niedriger: es fügt eigene Dämpfung hinzu.' },
      text: 'Wieder bei 3 rad/s, jetzt in Schritten von 0,025 s. **Euler implizit** neben Euler-Cromer einschalten. Beide lösen dasselbe Gesetz.',
      goal: 'Zu tun: Euler implizit ist zu sehen',
      done: 'Erledigt: Euler implizit ist zu sehen',
      whyTitle: 'Warum bleibt es bei 0,79 m?',
      why: 'Euler implizit nimmt die Kraft am Ende jedes Schrittes, wo die Masse noch nicht ist. Das wirkt wie ein eigener Dämpfer: Simuliert wird die Abklingrate 0,211 1/s, verlangt waren 0,100.',
      next: 'der Schritt'
    },
    {
      title: 'Was der Schritt ausmacht',
      predict: { ask: 'Was wird aus der Schwingung von Euler vorwärts in kleineren Schritten?', options: ['unter einem gewissen Schritt schwingt sie sich ein', 'nichts: sie wächst immer', 'sie schwingt sich bei jedem Schritt ein'], right: 0, told: 'Unter einem gewissen Schritt schwingt sie sich ein: dann überwiegt die Dämpfung des Gesetzes.' },
      text: 'Euler vorwärts nimmt die Kraft am Anfang des Schrittes. Bei *h* = 0,025 s wächst seine Schwingung ohne Ende, obwohl das Gesetz dämpft. Den **Schritt *h*** unter **0,0222 s** schieben.',
      goal: 'Zu tun: *h* ist unter 0,0222 s',
      done: 'Erledigt: sein Ausschlag hat nun ein Ende; mit kleineren Schritten kommt es früher',
      whyTitle: 'Warum bei 0,0222 s?',
      why: 'Jeder Schritt nimmt *ω*₀²*h*/2 von der Abklingrate *c*/2*m* = 0,1 1/s weg. Nichts bleibt von ihr bei *h* = *c*/*k* = 0,0222 s. Ein kleinerer Schritt hilft; ein besseres Verfahren hilft mehr.',
      next: 'aufschreiben'
    },
    {
      title: 'Aufschreiben',
      text: 'Das sind die Zahlen dieses Versuchs, aus den Läufen des Rechenkerns. Die Tabelle in den Bericht kopieren und zu jeder Zeile einen Satz schreiben: was es ist, und warum.',
      goal: 'Zu tun: die Tabelle ist kopiert',
      done: 'Erledigt: die Tabelle ist kopiert',
      whyTitle: 'Was gehört in den Bericht?',
      why: 'Das Gesetz mit seinen Zahlen, Schritt und Verfahren jeder Kurve, und was das Verfahren dem Gesetz hinzufügt. Eine Simulation ohne ihren Schritt lässt sich nicht wiederholen.',
      next: ''
    }
  ] as StepWords[],
  table: {
    quantity: 'Größe',
    value: 'Wert',
    rows: [
      'Periode der freien Schwingung',
      'Amplitude am Ende in Resonanz, Euler-Cromer, h = 0,01 s',
      'Amplitude am Ende bei 2 rad/s, Euler-Cromer, h = 0,01 s',
      'Amplitude am Ende in Resonanz, Euler implizit, h = 0,025 s',
      'größter Schritt, bei dem Euler vorwärts nicht wächst'
    ],
    copy: 'Tabelle kopieren',
    copied: 'Die Tabelle ist kopiert.'
  },
  two: [
    {
      title: 'Aufnehmen',
      text: 'Eine Scheibe an einer Feder, einmal losgelassen, 120 s lang von einem Sensor beobachtet. **Ihre Aufnahme** nehmen oder eine eigene ablegen.',
      goal: 'Zu tun: eine Aufnahme ist offen',
      done: 'Erledigt: die Aufnahme ist offen',
      whyTitle: 'Warum 120 s?',
      why: 'Die Dämpfung zeigt sich darin, wie die Schwingung abklingt. Je länger man zusieht, desto besser: Die Unsicherheit fällt schneller als mit der Wurzel der Zahl der Messwerte.',
      next: 'lesen'
    },
    {
      title: 'Lesen, was darin ist',
      text: 'Sehen, wie viele Messwerte es sind und was ausgebessert wurde. Dann die **Masse** mit ihrem ± und den **Durchmesser der Scheibe** eintragen, beide mit Einheit.',
      goal: 'Zu tun: Masse mit ±, und Scheibe',
      done: 'Erledigt: Masse und Scheibe sind bekannt',
      whyTitle: 'Warum die Masse mit ihrem ±?',
      why: 'Die Aufnahme allein gibt *k*/*m*. Was die Waage offen lässt, bleibt in *k* offen: 0,1 % der Masse sind 0,1 % von *k*.',
      next: 'der freie Teil'
    },
    {
      title: 'Der freie Teil',
      text: 'Angepasst werden darf nur, was frei schwingt, und ein Teil davon auch allein. Beide **Griffe** schieben: der Teil von **30 s** bis **60 s**.',
      goal: 'Zu tun: der Teil ist 30 bis 60 s',
      done: 'Erledigt: der Teil ist 30 bis 60 s',
      whyTitle: 'Warum ein Teil?',
      why: 'Über 30 s ist eine Abklingrate beinahe fest. Sie mit ihrem ± notieren: Rechts wird nach ihr gefragt. Dann die Griffe auf 0 und 30 s schieben und vergleichen.',
      next: 'alles anpassen'
    },
    {
      title: 'Alles anpassen',
      text: 'Jetzt **die ganze Aufnahme verwenden** und sie entscheiden lassen, welches Gesetz sie beschreibt. Warten, bis alle Gesetze verglichen sind.',
      goal: 'Zu tun: alles ist angepasst',
      done: 'Erledigt: alles ist angepasst',
      whyTitle: 'Welches Gesetz wird gewählt?',
      why: 'Das mit den wenigsten Gliedern, das nur das Rauschen des Sensors übrig lässt. Ein weiteres Glied passt immer etwas besser; es muss das um mehr als den Zufall tun.',
      next: 'eine Rate'
    },
    {
      title: 'Eine Rate genügt nicht',
      text: 'Das Gesetz **zäh** wählen: eine feste Abklingrate. Sehen, was es übrig lässt, und die Abklingrate gegen die Amplitude.',
      goal: 'Zu tun: das zähe Gesetz ist angepasst',
      done: 'Erledigt: das zähe Gesetz ist angepasst',
      whyTitle: 'Warum haben seine Reste ein Muster?',
      why: 'Seine Rate ist zuerst zu klein und am Ende zu groß. Eine Kraft mit dem Quadrat der Geschwindigkeit, wie von Luft, die beiseitegeschoben wird, lässt die Rate mit der Amplitude wachsen.',
      next: 'Reynolds'
    },
    {
      title: 'Die Reynolds-Zahl',
      text: 'Wieder das Gesetz mit **Luftwiderstand** wählen und die **größte Reynolds-Zahl** ablesen. Strömt die Luft ruhig um die Scheibe?',
      goal: 'Zu tun: Gesetz mit Luftwiderstand, Scheibe bekannt',
      done: 'Erledigt: die Reynolds-Zahl ist bekannt',
      whyTitle: 'Was sagt sie?',
      why: '*Re* = *vD*/*ν* vergleicht die Trägheit der Luft mit ihrer Zähigkeit. Von etwa tausend an gewinnt die Trägheit: Dann erwartet die Theorie einen Widerstand mit dem Quadrat der Geschwindigkeit.',
      next: 'aufschreiben'
    },
    {
      title: 'Aufschreiben',
      text: 'Rechts die fünf Antworten geben, jede mit einem ehrlichen **±**, und prüfen. Die letzte: Wie weit liegt die Amplitude bei 120 s daneben, wenn für alles eine feste Rate genommen wird?',
      goal: 'Zu tun: alle fünf sind richtig',
      done: 'Erledigt: alle fünf sind richtig',
      whyTitle: 'Was ist ein ehrliches ±?',
      why: 'Eines, von dem man sagen kann, woher es kommt: von der Waage, den Messwerten, dem Gesetz. Zu klein behauptet, was man nicht weiß; zu groß verschweigt, was man weiß.',
      next: ''
    }
  ] as StepWords[],
  take: (name) => `Aufnahme ${name} nehmen`,
  practice: 'Übungsaufnahme',
  takeOwn: 'Eigene Aufnahme nehmen',
  numberFirst: 'Bitte zuerst die eigene Nummer oder den Namen eintragen: danach richtet sich, welche Aufnahme Ihre ist.',
  forTeachers: 'Für Lehrende',
  forTeachersText: 'Ein Link gibt allen eine eigene Aufnahme, deren Wahrheit nur der Startwert kennt.',
  makeLink: 'Link für die Klasse',
  course: 'Klasse',
  link: 'Link für die Klasse',
  linkHelp: 'Diesen einen Link austeilen. Alle tragen ihre eigene Nummer oder ihren Namen ein und erhalten die Aufnahme, die dazu gehört.',
  onDisk: (course) => `Diese Seite ist von einem Datenträger geöffnet: der Link führt nur dort zum Ziel, wo die Datei am selben Ort liegt. Die Seite auf einen Webserver stellen, oder die Datei austeilen und den Teil des Links ab # dazu: Klasse ${course}.`,
  qr: 'Der Link als QR-Code',
  copyLink: 'Link kopieren',
  linkCopied: 'Der Link für die Klasse ist kopiert.',
  close: 'Schließen',
  student: 'Ihre Nummer oder Ihr Name in der Klasse',
  studentHelp: 'Danach richtet sich, welche Aufnahme Ihre ist.',
  handIn: {
    title: 'Abgeben',
    text: 'Eine Datei mit Ihrem Namen, den Antworten, dem angepassten Gesetz und dem Link. Geben Sie sie der Lehrkraft.',
    name: 'Ihr Name',
    save: 'Abgabe sichern',
  },
  marking: {
    title: 'Abgaben',
    open: 'Abgaben auswerten',
    students: 'Teilnehmende, gezählt von 1 bis',
    makeKey: 'Lösungen',
    left: (count) => `noch ${count} zu rechnen`,
    done: (count) => (count === 1 ? 'eine Abgabe' : `${count} Abgaben`),
    refused: (names) => `keine Abgabe: ${names}. Eine Abgabe ist eine Datei „hand-in-….json“, die unter den Antworten gesichert wird.`,
    save: 'Als CSV sichern',
    file: 'abgaben.csv',
    close: 'Tabelle schließen',
    name: 'Name',
    nameless: 'ohne Namen',
    recording: 'Aufnahme',
    student: 'Nummer',
    right: 'Richtig',
    law: 'Angepasstes Gesetz',
    key: 'Lösungen: was richtig ist, und das ± einer sorgfältigen Auswertung',
  },
  check: {
    title: 'Antworten prüfen',
    about: (name, mass, disc, time) =>
      `Versuch zwei, Aufnahme **${name}**, für Sie allein gemacht: ${mass}, Scheibe von ${disc}, ${time}.`,
    practice: (mass, disc, time) =>
      `Versuch zwei, Übungsaufnahme, für alle dieselbe: ${mass}, Scheibe von ${disc}, ${time}.`,
    questions: {
      frequency: ['Frequenz ', 'f', ''],
      stiffness: ['Federkonstante ', 'k', ''],
      rate: ['Abklingrate, 30 bis 60 s', '', ''],
      reynolds: ['Größte Reynolds-Zahl', '', ''],
      off: ['Wie weit liegt eine feste Rate am Ende daneben?', '', '']
    },
    value: (question) => `${question}, Wert`,
    uncertainty: (question) => `${question}, Unsicherheit`,
    verdicts: {
      empty: 'ohne Antwort',
      right: 'richtig',
      tooSmall: 'richtig, ± zu klein',
      tooLarge: 'richtig, ± zu groß',
      notYet: 'noch nicht',
      noUncertainty: '± fehlt',
      noNumber: 'keine Zahl'
    },
    within: (part) => `Innerhalb des Doppelten Ihrer Unsicherheit: um ${part} Ihres ± daneben.`,
    beyond: 'Näher kommt man mit dieser Aufnahme kaum; Ihr ± verspricht mehr.',
    massLimits: 'Begrenzt wird sie durch die Masse.',
    tooSmall: {
      frequency: 'Der Wert ist gut. Seine Unsicherheit nicht: So viele Stellen gibt die Aufnahme nicht her.',
      stiffness: 'Der Wert ist gut. Seine Unsicherheit nicht: Allein die Masse ist auf etwa 0,1 % bekannt. Welches ± folgt daraus?',
      rate: 'Der Wert ist gut. Seine Unsicherheit nicht: Was sagt die Anpassung dieser 30 s?',
      reynolds: 'Der Wert ist gut. Seine Unsicherheit nicht: Was sagt die Anpassung der ganzen Aufnahme?',
      off: 'Der Wert ist gut. Seine Unsicherheit nicht: Allein das Rauschen am Ende ist mehr.'
    },
    tooLarge: 'Der Wert ist gut. Seine Unsicherheit sagt weniger, als die Aufnahme weiß: auf den Bereich der Anpassung sehen.',
    farAbove: '**Zu groß um weit mehr als Ihr ±.**',
    farBelow: '**Zu klein um weit mehr als Ihr ±.**',
    above: (part) => `**Zu groß um ${part} Ihres ±.**`,
    below: (part) => `**Zu klein um ${part} Ihres ±.**`,
    slips: {
      angular: 'Ist das *ω* in rad/s? Die Frequenz ist *ω*/2π.',
      period: 'Ist das die Periode in s? Die Frequenz ist ihr Kehrwert.',
      grams: 'Ist die Masse in g genommen? Für N/m gilt sie in kg.',
      hertz: 'Ist *f* statt *ω* genommen? *k* = *mω*² mit *ω* = 2π*f*.',
      first: 'Ist das die Rate der ersten 30 s? In „Messen“ beide Griffe schieben und neu anpassen.',
      whole: 'Ist das die Rate der ganzen Aufnahme? In „Messen“ beide Griffe schieben und neu anpassen.',
      viscousOnly: 'Ist das die Rate aus dem Gesetz mit Luftwiderstand? In ihr fehlt, was der Widerstand nimmt: für diesen Teil das zähe Gesetz wählen.',
      perCycle: 'Ist das der Verlust einer Schwingung? Durch die Periode teilen.',
      radius: 'Ist der Radius statt des Durchmessers genommen?',
      centimetres: 'Ist der Durchmesser in cm genommen? *Re* braucht m.',
      thousands: 'Komma oder Punkt gelten als Dezimalzeichen: Tausender bitte ohne eingeben.',
      fraction: 'Ist das ein Teil von eins? Gefragt ist in %.',
      ratio: 'Ist das, was übrig bleibt? Gefragt ist, wie weit es daneben liegt.'
    },
    hints: {
      frequency: 'Sie steht in „Messen“ in der Tabelle des Gesetzes.',
      stiffness: 'Ist die Masse eingetragen, mit ihrer Einheit?',
      rate: 'In „Messen“ beide Griffe auf 30 und 60 s setzen, das zähe Gesetz wählen und anpassen.',
      reynolds: 'Ist die Scheibe eingetragen und die ganze Aufnahme verwendet?',
      off: 'In „Messen“ die Simulationen zeigen: Sie sagen, was eine feste Rate aus der letzten Schwingung macht.'
    },
    addUncertainty: 'Auch das ± angeben: Ohne es lässt sich eine Zahl nicht prüfen.',
    noNumber: (unit) => (unit ? `Bitte eine Zahl in ${unit} eingeben.` : 'Bitte eine Zahl eingeben.'),
    open: 'Diesen Teil in „Messen“ öffnen',
    openAll: 'Meine Aufnahme in „Messen“ öffnen',
    check: 'Antworten prüfen',
    checking: 'Wird geprüft …',
    score: (right, of) => `${right} von ${of} richtig. Prüfen geht beliebig oft.`,
    failed: 'Die Antworten ließen sich nicht prüfen: Der Rechenkern hat nicht geantwortet.'
  }
}
