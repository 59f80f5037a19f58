import { airViscosity } from '../../teach/air'

/// One step of a tour. **bold** and *italic* are marked.
export interface StepWords {
  title: string
  /// Asked before anything is shown; `told` once the goal is reached.
  predict?: { ask: string; options: string[]; told: string }
  /// Where the law is hidden.
  byHand?: Partial<Pick<StepWords, 'title' | 'text' | 'goal' | 'done' | 'whyTitle' | 'why'>>
  text: string
  goal: string
  done: string
  whyTitle: string
  why: string
  next: string
}

export const teach = {
  labs: 'Labs',
  lab: { one: 'Lab one', two: 'Lab two', three: 'Pendulums' },
  oneTitle: 'Driven resonance',
  twoTitle: 'Damping in air',
  threeTitle: 'Coupled pendulums',
  about: (steps: number, minutes: number) =>
    `${steps} steps, about ${minutes} minutes. Your place is kept in the address of this page.`,
  stepOf: (step: number, of: number) => `Step ${step} of ${of}`,
  stepDone: 'done',
  predictFirst: 'First, what do you expect?',
  expected: (what: string) => `You expect: ${what}.`,
  asExpected: 'As you expected.',
  withoutGuess: 'Go on without a guess',
  noGuess: 'You went on without a guess.',
  compare: 'Compare it with what you see.',
  beforeStep: (title: string) => `Asked before “${title}”, which would give it away.`,
  otherThanExpected: (what: string) => `You expected: ${what}.`,
  back: 'Back',
  nextAlone: 'Next',
  next: (title: string) => `Next: ${title}`,
  controls: {
    position: ['position', 'x₀', 'm', 'metres'],
    damping: ['damping', 'c', 'kg/s', 'kilograms per second'],
    driveFrequency: ['drive frequency', 'ω', 'rad/s', 'radians per second'],
    step: ['step', 'h', 's', 'seconds'],
    firstStart: ['first pendulum', 'x₁', 'm', 'metres'],
    secondStart: ['second pendulum', 'x₂', 'm', 'metres'],
    joint: ['coupling', 'κ', 'N/m', 'newtons per metre'],
    secondSpring: ['second stiffness', 'k₂', 'N/m', 'newtons per metre']
  },
  plot: {
    position: 'Position',
    x: 'position',
    t: 'time',
    caption: (drive: string, start: string, step: string) => `${drive}, ${start}, step ${step}`,
    noDrive: 'no drive',
    drive: (frequency: string) => `drive at ${frequency}`,
    rest: 'from rest',
    from: (position: string) => `from ${position}`,
    reach: 'reach of the swing without damping: no end',
    steady: (value: string) => `steady amplitude ${value}`,
    grows: 'grows without end'
  },
  one: [
    {
      title: 'A mass on a spring',
      predict: { ask: 'Pulled twice as far, how long does a swing take?', options: ['twice as long', 'just as long', 'half as long'], told: 'Just as long: the period does not depend on how far it was pulled.' },
      text: 'A mass of 1 kg hangs on a spring of 9 N/m. Lift it and let go: drag **position *x*₀** to **1 m** and count the swings. Then try 2 m.',
      goal: 'To do: *x*₀ is 1 m',
      done: 'Done: *x*₀ is 1.00 m',
      whyTitle: 'Why does a swing take 2.09 s?',
      why: 'The spring pulls with *k x*, the mass answers with *m x*″. So *ω*₀ = √(*k*/*m*) = √(9 N/m / 1 kg) = 3 rad/s, and *T* = 2π/*ω*₀ = 2.09 s, however far it was pulled.',
      next: 'push it'
    },
    {
      title: 'Push it at its own rhythm',
      predict: { ask: 'What will it do when it is pushed at its own rhythm?', options: ['swing by the same amount all the time', 'grow without end', 'grow, and stop at some amplitude'], told: 'It grows without end: nothing takes the energy away.' },
      text: 'Now it starts from rest and a force of 1 N pushes it to and fro. Drag the **drive frequency *ω*** from 1 to **3 rad/s**, its own, and watch how far it gets.',
      goal: 'To do: *ω* is 3 rad/s',
      done: 'Done: *ω* is 3.00 rad/s',
      whyTitle: 'Why does it grow without end?',
      why: 'At its own rhythm the force always pushes the way the mass moves, and nothing takes the energy away. The swing gains *F*/(2*mω*) = 0.167 m every second.',
      next: 'add damping'
    },
    {
      title: 'Add damping',
      predict: { ask: 'What does a little damping change?', options: ['nothing: it grows as before', 'the growth stops at some amplitude', 'the swing dies out'], told: 'The growth stops where damping takes as much as the drive gives.' },
      text: 'Without damping the swing grew without end. Drag **damping *c*** from 0 to **0.2 kg/s** and watch where the growth stops.',
      goal: 'To do: *c* is 0.2 kg/s',
      done: 'Done: *c* is 0.200 kg/s',
      whyTitle: 'Why does it stop at 1.67 m?',
      why: 'At resonance the drive only replaces what damping takes: *F* = *cωA*. So *A* = 1 N / (0.2 kg/s · 3 rad/s).',
      next: 'move away'
    },
    {
      title: 'Move away from resonance',
      predict: { ask: 'Pushed more slowly than its own rhythm, how far does it swing in the end?', options: ['farther', 'about as far', 'much less far'], told: 'Much less far: the spring holds against the force.' },
      text: 'Push it more slowly than it likes: drag the **drive frequency *ω*** down to **2 rad/s**. The first swings beat; wait until they are over.',
      goal: 'To do: *ω* is 2 rad/s',
      done: 'Done: *ω* is 2.00 rad/s',
      whyTitle: 'Why only 0.20 m?',
      why: 'Away from resonance the spring holds against the force: *A* = *F*/√((*k* − *mω*²)² + (*cω*)²) = 1 N / 5.02 N/m. That is an eighth of the swing at resonance.',
      next: 'another method'
    },
    {
      title: 'Two methods, one law',
      predict: { ask: 'Two methods solve one law in the same steps. Where do they settle?', options: ['at the same amplitude', 'implicit Euler lower', 'implicit Euler higher'], told: 'Implicit Euler settles lower: it adds damping of its own.' },
      text: 'Back at 3 rad/s, now in steps of 0.025 s. Switch on **implicit Euler** beside Euler-Cromer. Both solve the same law.',
      goal: 'To do: implicit Euler is shown',
      done: 'Done: implicit Euler is shown',
      whyTitle: 'Why does it settle at 0.79 m?',
      why: 'Implicit Euler takes the force at the end of each step, where the mass is not yet. That acts as a damper of its own: it simulates a decay rate of 0.211 1/s where 0.100 was asked for.',
      next: 'the step'
    },
    {
      title: 'What the step does',
      predict: { ask: 'What becomes of forward Euler’s swing in smaller steps?', options: ['below some step it settles', 'nothing: it always grows', 'it settles at any step'], told: 'Below some step it settles: the law’s damping then outweighs what the method takes away.' },
      text: 'Forward Euler takes the force where the step begins. At *h* = 0.025 s its swing grows without end, though the law has damping. Drag **step *h*** below **0.0222 s**.',
      goal: 'To do: *h* is below 0.0222 s',
      done: 'Done: its swing has an end now; with smaller steps it comes sooner',
      whyTitle: 'Why at 0.0222 s?',
      why: 'Each step takes *ω*₀²*h*/2 off the decay rate *c*/2*m* = 0.1 1/s. Nothing is left of it at *h* = *c*/*k* = 0.0222 s. Without damping Euler-Cromer holds out up to *h* = 2/*ω*₀, implicit Euler at any step.',
      next: 'write it up'
    },
    {
      title: 'Write it up',
      text: 'These are the numbers of this lab, read from the core’s own runs. Copy the table into your report with a sentence on each line. Then answer the questions for an **oscillator of your own**.',
      goal: 'To do: the table is copied',
      done: 'Done: the table is copied',
      whyTitle: 'What belongs into the report?',
      why: 'The law with its numbers, the step and the method of each curve, and what the method added to the law. A simulation without its step cannot be repeated.',
      next: ''
    }
  ] as StepWords[],
  three: [
    {
      title: 'One drives the other',
      text: 'Two pendulums of 1 kg and 1 m, joined by a soft spring of 0.5 N/m. Of small swings each is a mass on a spring of *m g*/*l* = 9.81 N/m, and so they are drawn. Pull the **first** to **0.1 m**, and watch the second.',
      goal: 'To do: the first starts at 0.1 m',
      done: 'Done: the first starts at 0.100 m',
      whyTitle: 'Why does the first come to rest?',
      why: 'The spring pushes the second along and holds the first back. After 20.2 s the second has all the energy; then it drives the first.',
      next: 'both together'
    },
    {
      title: 'Side by side',
      text: 'Now pull the **second** as well, the same way: to **0.1 m**. Do they still take turns?',
      goal: 'To do: the second starts at 0.1 m',
      done: 'Done: the second starts at 0.100 m',
      whyTitle: 'Why do they not take turns?',
      why: 'Side by side they never stretch the spring. Each swings as if it were alone, at *ω*₁ = √(9.81 N/m / 1 kg) = 3.13 rad/s. A motion in which all keep one rhythm is a **normal mode**.',
      next: 'against each other'
    },
    {
      title: 'Against each other',
      text: 'Pull the **second** the other way: to **−0.1 m**. They swing faster now.',
      goal: 'To do: the second starts at −0.1 m',
      done: 'Done: the second starts at −0.100 m',
      whyTitle: 'Why faster?',
      why: 'Both stretch the spring, each from its end, so it pulls twice as hard: *ω*₂ = √((9.81 + 2 · 0.5) N/m / 1 kg) = 3.29 rad/s. Two masses have two normal modes, and every motion is a sum of them.',
      next: 'beats'
    },
    {
      title: 'Beats',
      text: 'The first alone once more: that is both modes at once. Drag the **coupling *κ*** from 0.5 to **1 N/m** and watch how long it takes until the first stands still.',
      goal: 'To do: *κ* is 1 N/m',
      done: 'Done: *κ* is 1.00 N/m',
      whyTitle: 'Why in half the time?',
      why: 'The modes start in step and are against each other after π/(*ω*₂ − *ω*₁): 20.2 s at 0.5 N/m, 10.3 s at 1 N/m. In the first pendulum they then cancel.',
      next: 'two that differ'
    },
    {
      title: 'Two that differ',
      text: 'Shorten the string of the second to 0.82 m: drag its **stiffness *k*₂** from 9.81 to **12 N/m**. Does the first still come to rest?',
      goal: 'To do: *k*₂ is 12 N/m',
      done: 'Done: *k*₂ is 12.0 N/m',
      whyTitle: 'Why does the first keep most of its energy?',
      why: 'In each mode now one pendulum swings far and the other little. Of the energy at most 4*κ*²/((*k*₂ − *k*)² + 4*κ*²) = 17 % goes over.',
      next: 'a method'
    },
    {
      title: 'What a method makes of the modes',
      text: 'Equal again, in steps of 0.02 s. Switch from the exact solution to **implicit Euler**.',
      goal: 'To do: implicit Euler is on',
      done: 'Done: implicit Euler is on',
      whyTitle: 'Why do they die down?',
      why: 'Implicit Euler adds a decay rate of *ω*²*h*/2 to each mode: 0.098 1/s to the slow one, 0.108 1/s to the fast one. The faster a mode, the more a method errs. On the Simulate page, *Add a second mass* has more.',
      next: ''
    }
  ] as StepWords[],
  table: {
    quantity: 'quantity',
    value: 'value',
    rows: [
      'period of the free swing',
      'steady amplitude at resonance, Euler-Cromer, h = 0.01 s',
      'steady amplitude at 2 rad/s, Euler-Cromer, h = 0.01 s',
      'steady amplitude at resonance, implicit Euler, h = 0.025 s',
      'largest step at which forward Euler settles'
    ],
    copy: 'Copy the table',
    copied: 'The table is copied.'
  },
  two: [
    {
      title: 'Record',
      text: 'A disc on a spring, let go once, watched by a sensor for 120 s. Take **your recording**, or drop one that you made.',
      goal: 'To do: a recording is open',
      done: 'Done: the recording is open',
      whyTitle: 'Why 120 s?',
      why: 'Damping is read from how the swing dies down. The longer it is watched, the better: an uncertainty falls faster than with the root of the number of samples.',
      next: 'read it'
    },
    {
      title: 'Read what is in it',
      text: 'Look how many samples there are and what was repaired. Then type the **mass** with its ±, and the **diameter of the disc**, both with units.',
      goal: 'To do: mass with ±, and disc',
      done: 'Done: mass and disc are known',
      whyTitle: 'Why the mass with its ±?',
      why: 'The recording alone gives *k*/*m*. What the balance leaves open stays open in *k*: 0.1 % of the mass is 0.1 % of *k*.',
      next: 'the free part'
    },
    {
      title: 'The free part',
      predict: { ask: 'How fast does the swing die down from 30 to 60 s, beside the first 30 s?', options: ['just as fast', 'more slowly', 'faster'], told: 'More slowly: the swing is smaller there, and the air takes less of it.' },
      byHand: {
        text: 'Move both **handles** to the part from **30 s** to **60 s**. Read the amplitude at its start and at its end, and work out the **decay rate**: *γ* = ln(*A*₁/*A*₂) / 30 s. Several peaks are better than two.',
        goal: 'To do: the decay rate is answered, with its ±', done: 'Done: the decay rate is answered',
        why: 'One decay rate over 30 s is nearly constant. Work it out for 0 to 30 s too, and compare.',
      },
      text: 'Only what swings freely may be fitted, and a part of it can be fitted alone. Move both **handles**: the part from **30 s** to **60 s**.',
      goal: 'To do: the part is 30 to 60 s',
      done: 'Done: the part is 30 to 60 s',
      whyTitle: 'Why a part?',
      why: 'One decay rate over 30 s is nearly constant. Note it with its ±: it is asked for at the right. Then move the handles to 0 and 30 s and compare.',
      next: 'fit all'
    },
    {
      title: 'Fit all of it',
      predict: { ask: 'Will one constant decay rate describe all 120 s?', options: ['yes, up to the noise', 'no: the rate falls as the swing dies down', 'no: the rate rises as the swing dies down'], told: 'No: the rate falls as the swing dies down. Each dot is a piece of the recording.' },
      byHand: {
        title: 'Use all of it', text: 'Now **use all of the recording**: count the swings from its first to its last passage through the middle. That gives *f*, and with the mass *k* = *m*(2π*f*)².',
        goal: 'To do: frequency and spring constant are answered', done: 'Done: frequency and spring constant are answered',
        whyTitle: 'Why from end to end?', why: 'A passage is known to a hundredth of a second, whether it is the second or the hundredth: the more swings lie between, the smaller is the part of it in *f*.',
      },
      text: 'Now **use all of the recording** and let it decide which law describes it. Wait until all laws are compared.',
      goal: 'To do: all of it is fitted',
      done: 'Done: all of it is fitted',
      whyTitle: 'Which law is chosen?',
      why: 'The one with the fewest terms that leaves only the noise of the sensor. A further term always fits a little better; it must do so by more than chance.',
      next: 'one rate'
    },
    {
      title: 'One rate for all of it',
      predict: { ask: 'The law with one constant rate is fitted to all of it. What will it leave?', options: ['only the noise of the sensor', 'a pattern beside the noise', 'nothing'], told: 'A pattern beside the noise: the law lacks something.' },
      byHand: {
        text: 'Move the **handles** to the last 30 s, **90 s** to the end, and work out the decay rate there. Compare it with that of 30 to 60 s.',
        goal: 'To do: the part is 90 s to the end', done: 'Done: the part is 90 s to the end',
        whyTitle: 'Why is it smaller at the end?', why: 'A force with the square of the speed, as of air that has to be moved aside, takes a smaller part of a smaller swing. So no one rate describes all of it.',
      },
      text: 'Choose the law **viscous**: one constant decay rate. Look at what it leaves, and at the decay rate against the amplitude.',
      goal: 'To do: the viscous law is fitted',
      done: 'Done: the viscous law is fitted',
      whyTitle: 'Why do its residuals keep a pattern?',
      why: 'Its rate is too small at first and too large at the end. A force with the square of the speed, as of air that has to be moved aside, makes the rate grow with the amplitude.',
      next: 'Reynolds'
    },
    {
      title: 'The Reynolds number',
      predict: { ask: 'The disc moves by some centimetres, about once a second. How large is its Reynolds number at most?', options: ['about 1: calm, as in syrup', 'about 100', 'above 1000'], told: 'Above 1000: the air is moved aside, not sheared.' },
      byHand: {
        text: `Work out the **largest Reynolds number**: *Re* = *vD*/*ν*, with the largest speed *v* = 2π*f A* at the start, the diameter *D* and, for air, *ν* = ${(airViscosity * 1e5).toFixed(3)} · 10⁻⁵ m²/s. Is the air’s flow about the disc a calm one?`,
        goal: 'To do: the Reynolds number is answered', done: 'Done: the Reynolds number is answered',
      },
      text: 'Choose the law with **drag** again and read the **largest Reynolds number**. Is the air’s flow about the disc a calm one?',
      goal: 'To do: the law has drag, the disc is known',
      done: 'Done: the Reynolds number is known',
      whyTitle: 'What does it say?',
      why: '*Re* = *vD*/*ν* compares the air’s inertia with its viscosity. From about a thousand on inertia wins: drag with the square of the speed is what theory expects.',
      next: 'write it up'
    },
    {
      title: 'Write it up',
      text: 'Give all the answers, each with an honest **±**, and check them. The last: how far is the amplitude at 120 s off, if one constant rate is taken for all of it?',
      goal: 'To do: all answers are right',
      done: 'Done: all answers are right',
      byHand: { text: 'Give all the answers, each with an honest **±**, and check them.' },
      whyTitle: 'What is an honest ±?',
      why: 'One that you can say where it comes from: the balance, the samples, the law. Too small claims what you do not know; too large hides what you do.',
      next: ''
    }
  ] as StepWords[],
  take: (name: string) => (name ? `Take recording ${name}` : 'Take the practice recording'),
  lawHidden: 'In this class the fitted law is hidden: you work by hand. Read the recording here, or save it as a table for a spreadsheet.',
  saveRecording: (name: string) => `Save ${name}`,
  takeOwn: 'Take your recording',
  numberFirst: 'Type your number or name in the class first: it decides which recording is yours.',
  forTeachers: 'For teachers',
  forTeachersText: 'One link gives every student numbers of their own.',
  projector: 'Projector mode',
  projectorHelp: 'Everything larger, for the wall',
  makeLink: 'Make a class link',
  course: 'Class',
  link: 'Link for the class',
  linkHelp: 'Hand out this one link. Every student types a number or name of their own, and gets the recording or the oscillator that belongs to it.',
  onDisk: (course: string) => `This page is open from a disk, so the link only works where the file lies in the same place. Put the page on a web server, or hand out the file with the part of the link from # on: class ${course}.`,
  qr: 'The link as a QR code',
  noQr: 'The link is too long for a QR code.',
  copyLink: 'Copy the class link',
  linkCopied: 'The class link is copied.',
  close: 'Close',
  options: {
    title: 'A class',
    labs: 'Labs',
    lab: { one: 'Lab one', two: 'Lab two', both: 'Both' },
    hide: 'Hide the fitted law',
    hideHelp: 'Students work by hand: nothing is fitted to the recordings of this class. The last question of lab two, which needs a fit, is left out.',
    tolerance: 'Tolerance in %',
    toleranceHelp: 'So near a value is right whatever its ±. Empty: lab two goes by the ±, lab one and tasks of your own by 2 %.',
    toleranceBad: 'A tolerance is between 0.1 and 50 %, or empty.',
    numberBad: 'Answer and ± are numbers; the unit has a field of its own.',
    tasks: 'Tasks of your own',
    tasksHelp: 'Without an answer a task is a text for you to read. Answers stand in the link, out of sight at a glance, but no secret.',
    task: (number: number) => `Task ${number}`,
    text: 'Question',
    answer: 'Answer',
    unit: 'Unit',
    own: '± %',
    add: 'Add a task',
    remove: (number: number) => `Remove task ${number}`,
    projector: 'A link for the wall',
    projectorLink: 'Copy the link in projector mode',
    key: 'Answer key',
  },
  student: 'Your number or name in the class',
  studentHelp: 'It decides which numbers are yours.',
  handIn: {
    title: 'Hand in',
    text: 'One file with your name, answers, predictions, the law that is fitted and the link. Give it to your teacher.',
    name: 'Your name',
    save: 'Save the hand-in',
  },
  marking: {
    title: 'Hand-ins',
    open: 'Mark hand-ins',
    students: 'Students, numbered from 1 to',
    makeKey: 'Answer key',
    left: (count: number) => `${count} still to be worked out`,
    done: (count: number) => (count === 1 ? 'one hand-in' : `${count} hand-ins`),
    refused: (names: string) => `no hand-in: ${names}. A hand-in is a file “hand-in-….json”, saved below the answers.`,
    save: 'Save as CSV',
    file: 'hand-ins.csv',
    close: 'Close the table',
    name: 'Name',
    nameless: 'without a name',
    recording: 'Recording',
    student: 'Student',
    right: 'Right',
    predictions: 'Predicted',
    foreseen: (right: number, of: number) => `${right} of ${of}`,
    without: (count: number) => `${count} without a guess`,
    otherOptions: 'answered under other class options',
    hidden: 'hidden',
    law: 'Law fitted',
    key: 'Answer key: what is right, and the ± that a careful evaluation has',
  },
  check: {
    title: 'Check your answers',
    about: (name: string, mass: string, disc: string, time: string) =>
      `Lab two, recording **${name}**, made for you alone: ${mass}, disc of ${disc}, ${time}.`,
    aboutOne: (name: string, values: string) => `Lab one, oscillator **${name}**, yours alone: ${values}.`,
    practiceOne: (values: string) => `Lab one, an oscillator to practise, the same for all: ${values}.`,
    tasks: 'From your teacher',
    practice: (mass: string, disc: string, time: string) =>
      `Lab two, practice recording, the same for all: ${mass}, disc of ${disc}, ${time}.`,
    questions: {
      resonance: ['Angular frequency of resonance ', 'ω', ''],
      amplitude: ['Steady amplitude at resonance ', 'A', ''],
      forwardLimit: ['Largest step at which forward Euler settles ', 'h', ''],
      cromerLimit: ['Largest step of Euler-Cromer without damping ', 'h', ''],
      growth: ['Forward Euler without damping: energy after one swing over that before', '', ''],
      simulatedRate: ['Decay rate that implicit Euler simulates', '', ''],
      frequency: ['Frequency ', 'f', ''],
      stiffness: ['Spring constant ', 'k', ''],
      rate: ['Decay rate, 30 to 60 s', '', ''],
      reynolds: ['Largest Reynolds number', '', ''],
      off: ['How far is one constant rate off at the end?', '', '']
    },
    /// Headings of the teacher's tables.
    short: {
      resonance: 'Resonance ω', amplitude: 'Amplitude A', forwardLimit: 'Limit of forward Euler', cromerLimit: 'Limit of Euler-Cromer',
      growth: 'Growth of forward Euler', simulatedRate: 'Rate of implicit Euler', frequency: 'Frequency f', stiffness: 'Spring k',
      rate: 'Decay rate, 30 to 60 s', reynolds: 'Largest Re', off: 'One rate off at the end'
    } as Record<string, string>,
    value: (question: string) => `${question}, value`,
    uncertainty: (question: string) => `${question}, uncertainty`,
    verdicts: {
      empty: 'not answered',
      right: 'right',
      tooSmall: 'right, ± too small',
      tooLarge: 'right, ± too large',
      notYet: 'not yet',
      noUncertainty: '± missing',
      noNumber: 'no number',
      given: 'for your teacher'
    },
    within: (part: string) => `Within three times your ±: off by ${part} of it.`,
    near: (part: string) => (part === '' ? 'Exactly it.' : `Off by ${part}, within the tolerance.`),
    given: 'Your teacher reads it.',
    beyond: 'This recording hardly brings anyone nearer; your ± promises more.',
    massLimits: 'The mass is what limits it.',
    tooSmall: {
      frequency: 'The value is good. Its uncertainty is not: the recording does not give that many digits.',
      stiffness: 'The value is good. Its uncertainty is not: the mass alone is known to about 0.1 %. Which ± follows from that?',
      rate: 'The value is good. Its uncertainty is not: these 30 s do not give that many digits.',
      reynolds: 'The value is good. Its uncertainty is not: the amplitude at the start is not known that well.',
      off: 'The value is good. Its uncertainty is not: the noise at the end alone is more.'
    },
    tooLarge: 'The value is good. Its uncertainty says less than the recording knows.',
    farAbove: '**Too large by far more than your ±.**',
    farBelow: '**Too small by far more than your ±.**',
    above: (part: string) => `**Too large by ${part} of your ±.**`,
    below: (part: string) => `**Too small by ${part} of your ±.**`,
    over: (part: string) => `**Too large by ${part}.**`,
    under: (part: string) => `**Too small by ${part}.**`,
    slips: {
      periodFor: 'Is this the period, 2π/*ω*₀?',
      squared: 'Is this *k*/*m*? *ω* is its root.',
      static: 'Is this *F*/*k*, where it would rest? At resonance it swings much farther.',
      noOmega: 'Is this *F*/*c*? The speed is *ωA*: divide by *ω* too.',
      hertzFor: 'Is *f* taken for *ω*? *A* = *F*/(*cω*) with *ω* in rad/s.',
      doubled: 'Is this from top to bottom? The amplitude is half of it.',
      halved: 'Is *A* = *F*/(*cω*) halved?',
      cromersOwn: 'Is this 2/*ω*₀, the limit of Euler-Cromer?',
      forwardsOwn: 'Is this *c*/*k*, the limit of forward Euler?',
      twice: 'Is this 2*c*/*k*? The damping must outweigh *ω*₀²*h*/2.',
      half: 'Is this 1/*ω*₀? It is twice that.',
      milliseconds: 'Is this in ms? It is asked for in s.',
      ofAmplitude: 'Is this the ratio of amplitudes? The energy goes with their square.',
      added: 'Is this what is added? Asked for is after over before, which is one more.',
      percent: 'Is this in %? Asked for is a plain ratio.',
      oneStep: 'Is this of one step? Asked for is a whole swing.',
      asked: 'Is this *c*/2*m*, what the law asks for? The method adds damping of its own.',
      addedOnly: 'Is this only what the method adds? The damping of the law belongs to it.',
      ofEnergy: 'Is this taken for the energy? The rate of the amplitude is half of it.',
      angular: 'Is this *ω* in rad/s? The frequency is *ω*/2π.',
      period: 'Is this the period in s? The frequency is its inverse.',
      grams: 'Is the mass taken in g? In N/m it is taken in kg.',
      hertz: 'Is *f* taken for *ω*? *ω* = 2π*f*.',
      first: 'Is this the rate of the first 30 s? Asked for is 30 to 60 s.',
      whole: 'Is this the rate of the whole recording? Asked for is 30 to 60 s.',
      viscousOnly: 'Is this the rate of the law with drag? That one leaves out what drag takes: choose the viscous law for this part.',
      perCycle: 'Is this the loss of one swing? Divide it by the period.',
      radius: 'Is the radius taken for the diameter of the disc?',
      centimetres: 'Is the diameter taken in cm? *Re* needs m.',
      thousands: 'A comma or point is read as the decimal mark: type thousands without one.',
      fraction: 'Is this a part of one? It is asked for in %.',
      ratio: 'Is this what is left? Asked for is how far it is off.'
    } as Record<string, string>,
    hintsByHand: {
      frequency: 'Count the swings between two passages far apart, and divide by the time between them.',
      stiffness: '*k* = *m*(2π*f*)², with the mass in kg.',
      rate: 'Read peaks at about 30 and 60 s: *γ* = ln(*A*₁/*A*₂)/(*t*₂ − *t*₁). Amplitudes count from the position at rest.',
      reynolds: '*Re* = *vD*/*ν* with *v* = 2π*f A*, the first amplitude *A*, and all lengths in m.'
    } as Record<string, string>,
    hints: {
      resonance: '*ω*₀ = √(*k*/*m*); or find the peak of the resonance curve in Simulate.',
      amplitude: 'At resonance the drive replaces what damping takes: *F* = *cωA*.',
      forwardLimit: 'Each step takes *ω*₀²*h*/2 off the decay rate *c*/2*m*. When is nothing left?',
      cromerLimit: 'It holds out up to *h* = 2/*ω*₀.',
      growth: 'Each step multiplies the energy by 1 + *ω*₀²*h*². How many steps has a swing?',
      simulatedRate: 'To *c*/2*m* implicit Euler adds about *ω*₀²*h*/2.',
      frequency: 'Read it from the table of the law in Measure.',
      stiffness: 'Is the mass typed in, with its unit?',
      rate: 'Set both handles to 30 and 60 s in Measure, choose the viscous law, and fit.',
      reynolds: 'Is the disc typed in, and all of the recording used?',
      off: 'Show the simulations in Measure: they say what one constant rate makes of the last swing.'
    } as Record<string, string>,
    addUncertainty: 'Give your ± too: a number without it cannot be checked.',
    noNumber: (unit: string) => (unit ? `Type a number in ${unit}.` : 'Type a number.'),
    open: 'Open this part in Measure',
    openOscillator: 'Open my oscillator in Simulate',
    answer: (question: string) => `${question}, answer`,
    openAll: 'Open my recording in Measure',
    check: 'Check answers',
    checking: 'Checking …',
    score: (right: number, of: number) => `${right} of ${of} right. Check as often as you like.`,
    failed: 'The answers could not be checked: the core did not answer.'
  }
}
