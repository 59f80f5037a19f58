/// One step of a tour. **bold** and *italic* are marked.
export interface StepWords {
  title: string
  /// Asked before anything is shown; `told` once the goal is reached.
  predict?: { ask: string; options: string[]; right: number; told: string }
  text: string
  goal: string
  done: string
  whyTitle: string
  why: string
  next: string
}

export const teach = {
  labs: 'Labs',
  lab: { one: 'Lab one', two: 'Lab two' },
  oneTitle: 'Driven resonance',
  twoTitle: 'Damping in air',
  about: (steps: number, minutes: number) =>
    `${steps} steps, about ${minutes} minutes. Your place is kept in the address of this page.`,
  stepOf: (step: number, of: number) => `Step ${step} of ${of}`,
  stepDone: 'done',
  predictFirst: 'First, what do you expect?',
  expected: (what: string) => `You expect: ${what}.`,
  asExpected: 'As you expected.',
  otherThanExpected: (what: string) => `You expected: ${what}.`,
  back: 'Back',
  next: (title: string) => `Next: ${title}`,
  controls: {
    position: ['position', 'x₀', 'm', 'metres'],
    damping: ['damping', 'c', 'kg/s', 'kilograms per second'],
    driveFrequency: ['drive frequency', 'ω', 'rad/s', 'radians per second'],
    step: ['step', 'h', 's', 'seconds']
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
      predict: { ask: 'Pulled twice as far, how long does a swing take?', options: ['twice as long', 'just as long', 'half as long'], right: 1, told: 'Just as long: the period does not depend on how far it was pulled.' },
      text: 'A mass of 1 kg hangs on a spring of 9 N/m. Lift it and let go: drag **position *x*₀** to **1 m** and count the swings. Then try 2 m.',
      goal: 'To do: *x*₀ is 1 m',
      done: 'Done: *x*₀ is 1.00 m',
      whyTitle: 'Why does a swing take 2.09 s?',
      why: 'The spring pulls with *k x*, the mass answers with *m x*″. So *ω*₀ = √(*k*/*m*) = √(9 N/m / 1 kg) = 3 rad/s, and *T* = 2π/*ω*₀ = 2.09 s, however far it was pulled.',
      next: 'push it'
    },
    {
      title: 'Push it at its own rhythm',
      predict: { ask: 'What will it do when it is pushed at its own rhythm?', options: ['swing by the same amount all the time', 'grow without end', 'grow, and stop at some amplitude'], right: 1, told: 'It grows without end: nothing takes the energy away.' },
      text: 'Now it starts from rest and a force of 1 N pushes it to and fro. Drag the **drive frequency *ω*** from 1 to **3 rad/s**, its own, and watch how far it gets.',
      goal: 'To do: *ω* is 3 rad/s',
      done: 'Done: *ω* is 3.00 rad/s',
      whyTitle: 'Why does it grow without end?',
      why: 'At its own rhythm the force always pushes the way the mass moves, and nothing takes the energy away. The swing gains *F*/(2*mω*) = 0.167 m every second.',
      next: 'add damping'
    },
    {
      title: 'Add damping',
      predict: { ask: 'What does a little damping change?', options: ['nothing: it grows as before', 'the growth stops at some amplitude', 'the swing dies out'], right: 1, told: 'The growth stops where damping takes as much as the drive gives.' },
      text: 'Without damping the swing grew without end. Drag **damping *c*** from 0 to **0.2 kg/s** and watch where the growth stops.',
      goal: 'To do: *c* is 0.2 kg/s',
      done: 'Done: *c* is 0.200 kg/s',
      whyTitle: 'Why does it stop at 1.67 m?',
      why: 'At resonance the drive only replaces what damping takes: *F* = *cωA*. So *A* = 1 N / (0.2 kg/s · 3 rad/s).',
      next: 'move away'
    },
    {
      title: 'Move away from resonance',
      predict: { ask: 'Pushed more slowly than its own rhythm, how far does it swing in the end?', options: ['farther', 'about as far', 'much less far'], right: 2, told: 'Much less far: the spring holds against the force.' },
      text: 'Push it more slowly than it likes: drag the **drive frequency *ω*** down to **2 rad/s**. The first swings beat; wait until they are over.',
      goal: 'To do: *ω* is 2 rad/s',
      done: 'Done: *ω* is 2.00 rad/s',
      whyTitle: 'Why only 0.20 m?',
      why: 'Away from resonance the spring holds against the force: *A* = *F*/√((*k* − *mω*²)² + (*cω*)²) = 1 N / 5.02 N/m. That is an eighth of the swing at resonance.',
      next: 'another method'
    },
    {
      title: 'A method that adds damping',
      predict: { ask: 'Two methods solve one law in the same steps. Where do they settle?', options: ['at the same amplitude', 'implicit Euler lower', 'implicit Euler higher'], right: 1, told: 'Implicit Euler settles lower: it adds damping of its own.' },
      text: 'Back at 3 rad/s, now in steps of 0.025 s. Switch on **implicit Euler** beside Euler-Cromer. Both solve the same law.',
      goal: 'To do: implicit Euler is shown',
      done: 'Done: implicit Euler is shown',
      whyTitle: 'Why does it settle at 0.79 m?',
      why: 'Implicit Euler takes the force at the end of each step, where the mass is not yet. That acts as a damper of its own: it simulates a decay rate of 0.211 1/s where 0.100 was asked for.',
      next: 'the step'
    },
    {
      title: 'What the step does',
      predict: { ask: 'What becomes of forward Euler’s swing in smaller steps?', options: ['below some step it settles', 'nothing: it always grows', 'it settles at any step'], right: 0, told: 'Below some step it settles: the law’s damping then outweighs what the method takes away.' },
      text: 'Forward Euler takes the force where the step begins. At *h* = 0.025 s its swing grows without end, though the law has damping. Drag **step *h*** below **0.0222 s**.',
      goal: 'To do: *h* is below 0.0222 s',
      done: 'Done: its swing has an end now; with smaller steps it comes sooner',
      whyTitle: 'Why at 0.0222 s?',
      why: 'Each step takes *ω*₀²*h*/2 off the decay rate *c*/2*m* = 0.1 1/s. Nothing is left of it at *h* = *c*/*k* = 0.0222 s. A smaller step helps; a better method helps more.',
      next: 'write it up'
    },
    {
      title: 'Write it up',
      text: 'These are the numbers of this lab, read from the core’s own runs. Copy the table into your report, and write one sentence on each line: what it is, and why.',
      goal: 'To do: the table is copied',
      done: 'Done: the table is copied',
      whyTitle: 'What belongs into the report?',
      why: 'The law with its numbers, the step and the method of each curve, and what the method added to the law. A simulation without its step cannot be repeated.',
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
      text: 'Only what swings freely may be fitted, and a part of it can be fitted alone. Move both **handles**: the part from **30 s** to **60 s**.',
      goal: 'To do: the part is 30 to 60 s',
      done: 'Done: the part is 30 to 60 s',
      whyTitle: 'Why a part?',
      why: 'One decay rate over 30 s is nearly constant. Note it with its ±: it is asked for at the right. Then move the handles to 0 and 30 s and compare.',
      next: 'fit all'
    },
    {
      title: 'Fit all of it',
      text: 'Now **use all of the recording** and let it decide which law describes it. Wait until all laws are compared.',
      goal: 'To do: all of it is fitted',
      done: 'Done: all of it is fitted',
      whyTitle: 'Which law is chosen?',
      why: 'The one with the fewest terms that leaves only the noise of the sensor. A further term always fits a little better; it must do so by more than chance.',
      next: 'one rate'
    },
    {
      title: 'One rate is not enough',
      text: 'Choose the law **viscous**: one constant decay rate. Look at what it leaves, and at the decay rate against the amplitude.',
      goal: 'To do: the viscous law is fitted',
      done: 'Done: the viscous law is fitted',
      whyTitle: 'Why do its residuals keep a pattern?',
      why: 'Its rate is too small at first and too large at the end. A force with the square of the speed, as of air that has to be moved aside, makes the rate grow with the amplitude.',
      next: 'Reynolds'
    },
    {
      title: 'The Reynolds number',
      text: 'Choose the law with **drag** again and read the **largest Reynolds number**. Is the air’s flow about the disc a calm one?',
      goal: 'To do: the law has drag, the disc is known',
      done: 'Done: the Reynolds number is known',
      whyTitle: 'What does it say?',
      why: '*Re* = *vD*/*ν* compares the air’s inertia with its viscosity. From about a thousand on inertia wins: drag with the square of the speed is what theory expects.',
      next: 'write it up'
    },
    {
      title: 'Write it up',
      text: 'Give the five answers at the right, each with an honest **±**, and check them. The last: how far is the amplitude at 120 s off, if one constant rate is taken for all of it?',
      goal: 'To do: all five are right',
      done: 'Done: all five are right',
      whyTitle: 'What is an honest ±?',
      why: 'One that you can say where it comes from: the balance, the samples, the law. Too small claims what you do not know; too large hides what you do.',
      next: ''
    }
  ] as StepWords[],
  take: (name: string) => `Take recording ${name}`,
  practice: 'practice recording',
  takeOwn: 'Take your recording',
  numberFirst: 'Type your number or name in the class first: it decides which recording is yours.',
  forTeachers: 'For teachers',
  forTeachersText: 'One link gives every student a recording of their own, with a truth that only the seed knows.',
  makeLink: 'Make a class link',
  course: 'Class',
  link: 'Link for the class',
  linkHelp: 'Hand out this one link. Every student types a number or name of their own, and gets the recording that belongs to it.',
  onDisk: (course: string) => `This page is open from a disk, so the link only works where the file lies in the same place. Put the page on a web server, or hand out the file with the part of the link from # on: class ${course}.`,
  qr: 'The link as a QR code',
  copyLink: 'Copy the class link',
  linkCopied: 'The class link is copied.',
  close: 'Close',
  student: 'Your number or name in the class',
  studentHelp: 'It decides which recording is yours.',
  handIn: {
    title: 'Hand in',
    text: 'One file with your name, your answers, the law that is fitted and the link. Give it to your teacher.',
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
    law: 'Law fitted',
    key: 'Answer key: what is right, and the ± that a careful evaluation has',
  },
  check: {
    title: 'Check your answers',
    about: (name: string, mass: string, disc: string, time: string) =>
      `Lab two, recording **${name}**, made for you alone: ${mass}, disc of ${disc}, ${time}.`,
    practice: (mass: string, disc: string, time: string) =>
      `Lab two, practice recording, the same for all: ${mass}, disc of ${disc}, ${time}.`,
    questions: {
      frequency: ['Frequency ', 'f', ''],
      stiffness: ['Spring constant ', 'k', ''],
      rate: ['Decay rate, 30 to 60 s', '', ''],
      reynolds: ['Largest Reynolds number', '', ''],
      off: ['How far is one constant rate off at the end?', '', '']
    },
    value: (question: string) => `${question}, value`,
    uncertainty: (question: string) => `${question}, uncertainty`,
    verdicts: {
      empty: 'not answered',
      right: 'right',
      tooSmall: 'right, ± too small',
      tooLarge: 'right, ± too large',
      notYet: 'not yet',
      noUncertainty: '± missing',
      noNumber: 'no number'
    },
    within: (part: string) => `Within twice your uncertainty: off by ${part} of your ±.`,
    beyond: 'This recording hardly brings anyone nearer; your ± promises more.',
    massLimits: 'The mass is what limits it.',
    tooSmall: {
      frequency: 'The value is good. Its uncertainty is not: the recording does not give that many digits.',
      stiffness: 'The value is good. Its uncertainty is not: the mass alone is known to about 0.1 %. Which ± follows from that?',
      rate: 'The value is good. Its uncertainty is not: what does the fit of these 30 s say?',
      reynolds: 'The value is good. Its uncertainty is not: what does the fit of the whole recording say?',
      off: 'The value is good. Its uncertainty is not: the noise at the end alone is more.'
    },
    tooLarge: 'The value is good. Its uncertainty says less than the recording knows: look at the interval of the fit.',
    farAbove: '**Too large by far more than your ±.**',
    farBelow: '**Too small by far more than your ±.**',
    above: (part: string) => `**Too large by ${part} of your ±.**`,
    below: (part: string) => `**Too small by ${part} of your ±.**`,
    slips: {
      angular: 'Is this *ω* in rad/s? The frequency is *ω*/2π.',
      period: 'Is this the period in s? The frequency is its inverse.',
      grams: 'Is the mass taken in g? In N/m it is taken in kg.',
      hertz: 'Is *f* taken for *ω*? *k* = *mω*² with *ω* = 2π*f*.',
      first: 'Is this the rate of the first 30 s? Move both handles in Measure and fit again.',
      whole: 'Is this the rate of the whole recording? Move both handles in Measure and fit again.',
      viscousOnly: 'Is this the rate of the law with drag? That one leaves out what drag takes: choose the viscous law for this part.',
      perCycle: 'Is this the loss of one swing? Divide it by the period.',
      radius: 'Is the radius taken for the diameter of the disc?',
      centimetres: 'Is the diameter taken in cm? *Re* needs m.',
      thousands: 'A comma or point is read as the decimal mark: type thousands without one.',
      fraction: 'Is this a part of one? It is asked for in %.',
      ratio: 'Is this what is left? Asked for is how far it is off.'
    } as Record<string, string>,
    hints: {
      frequency: 'Read it from the table of the law in Measure.',
      stiffness: 'Is the mass typed in, with its unit?',
      rate: 'Set both handles to 30 and 60 s in Measure, choose the viscous law, and fit.',
      reynolds: 'Is the disc typed in, and all of the recording used?',
      off: 'Show the simulations in Measure: they say what one constant rate makes of the last swing.'
    },
    addUncertainty: 'Give your ± too: a number without it cannot be checked.',
    noNumber: (unit: string) => (unit ? `Type a number in ${unit}.` : 'Type a number.'),
    open: 'Open this part in Measure',
    openAll: 'Open my recording in Measure',
    check: 'Check answers',
    checking: 'Checking …',
    score: (right: number, of: number) => `${right} of ${of} right. Check as often as you like.`,
    failed: 'The answers could not be checked: the core did not answer.'
  }
}
