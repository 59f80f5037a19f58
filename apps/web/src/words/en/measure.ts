export const measure = {
  title: 'Measure',
  drop: {
    title: 'Drop a recording here, or choose a file',
    now: 'Let go: the recording is read here and stays on this computer.',
    caption:
      'Text tables of PASCO Capstone, DataStudio, Tracker, phyphox, Logger Pro, LabVIEW and others are recognised, with their decimal comma, runs and gaps. Nothing is uploaded.',
    choose: 'Choose a file',
    another: 'Open another file',
    paste: 'Paste a table',
    pasteHere: 'Paste the table here, with its heading',
    usePasted: 'Read the table',
    pasted: 'pasted.csv',
    examples: 'No recording at hand? These three are synthetic: simulated, with a sensor’s noise.',
    tooLarge: (size: string) => `The file has ${size}; the page reads up to 250 MB. Use the program for it.`,
    notRead: 'This file could not be read.'
  },
  examples: {
    disc: { name: 'Disc in air', about: '217.6 g, disc of 12 cm, 120 s: viscous damping and drag' },
    plain: { name: 'Plain damping', about: '200.8 g, 40 s: one decay rate describes it' },
    rubbing: { name: 'Dry friction', about: '250 g, 12 s: rubs on a guide, and stops' }
  },
  synthetic: 'synthetic: simulated',
  dropped: 'read just now',
  file: {
    title: 'The file',
    dialect: 'Dialect',
    column: 'Column used',
    run: 'Run',
    samples: 'Samples',
    repaired: 'Repaired',
    rate: 'Samples per second',
    at: (count: string, rate: string) => `${count} at ${rate}`,
    decimalComma: 'decimal comma',
    nothing: 'nothing to repair',
    spikes: (count: number) => `${count} ${count === 1 ? 'spike' : 'spikes'} set aside`,
    gaps: (count: number, longest: string) => (count === 1 ? `1 gap of ${longest}` : `${count} gaps, up to ${longest}`),
    remarks: (count: number) => `${count} ${count === 1 ? 'remark' : 'remarks'} on the file`
  },
  recording: {
    title: 'Recording',
    free: (from: string, to: string) => `Free part ${from} to ${to}: drag the handles, or use the arrow keys.`,
    frame: 'The frame is shown larger below.',
    whole: 'Use all of it',
    amplitude: 'amplitude of the fitted law',
    spike: 'spike, set aside',
    gap: (length: string) => `gap ${length}`,
    start: 'start of the free part',
    end: 'end of the free part',
    frameName: 'frame that is shown larger',
    time: 'time t (s)',
    timeSymbol: ['time ', 't', ' (s)'],
    seen: (what: string, count: string, from: string, to: string) =>
      `${what} against time: ${count} samples from ${from} to ${to}.`
  },
  fit: {
    title: 'Fit, and what it leaves',
    white: (rms: string) => `One dot per sample. The residuals keep no pattern: rms ${rms}, the sensor’s own noise.`,
    pattern: (rms: string) => `One dot per sample. The residuals keep a pattern: rms ${rms}, more than noise alone.`,
    measured: 'measured',
    fitted: (law: string) => `fitted law: ${law}`,
    residual: (unit: string) => `measured − fitted (${unit})`,
    missed: (most: string) =>
      `dashed: what one constant decay rate misses, up to ${most} here; band: 95 % of what is left`,
    band: 'band: 95 % of what is left',
    working: 'The laws are being compared; this is the best of two so far.',
    workingFirst: 'The law is being fitted.',
    again: 'Fitted again with the new part.',
    none: 'There is no fit.',
    overlay: 'Beside simulations',
    grows: 'grows without end',
    narrower: 'Shorter frame',
    wider: 'Longer frame',
    seen: (from: string, to: string, most: string) =>
      `Measured dots and the fitted law, ${from} to ${to}. What is left stays below ${most}.`
  },
  law: {
    title: 'The law of this oscillator',
    other: 'choose another',
    auto: 'let the recording decide',
    chosen: (others: number, term: string, before: string, after: string) =>
      `Chosen over ${others} others: ${term} lowers the residual from ${before} to ${after}.`,
    best: (others: number, rms: string) => `Chosen over ${others} others; it leaves ${rms}.`,
    set: (law: string, rms: string) => `${law}, as you chose. It leaves ${rms}.`,
    term: {
      viscous: 'the viscous term',
      drag: 'the drag term',
      friction: 'dry friction',
      cubic: 'the cubic spring'
    } as Record<string, string>,
    names: {
      viscous: 'viscous',
      drag: 'drag',
      friction: 'dry friction',
      cubic: 'cubic spring',
      pendulum: 'pendulum'
    } as Record<string, string>,
    value: 'value',
    interval: '95 % interval',
    to: 'to',
    at: (time: string) => `at ${time}`,
    mass: 'mass',
    disc: 'disc',
    air: 'air',
    change: 'change',
    done: 'done',
    none: 'not given',
    massHint: 'with its ±, as “217.6 ± 0.3 g”',
    giveMass: 'Give the mass to get the spring constant and damping in kg/s.',
    wide: 'The uncertainties are widened, for the residuals keep a pattern.'
  },
  quantities: {
    stiffness: ['spring constant', 'k'],
    damping: ['damping', 'c'],
    drag_constant: ['drag', 'd'],
    drag_coefficient: ['drag coefficient', 'C'],
    friction_force: ['dry friction', 'f'],
    friction: ['friction / mass', 'f/m'],
    cubic: ['cubic / mass', 'k₃/m'],
    cubic_stiffness: ['cubic stiffness', 'k₃'],
    angular_frequency: ['angular frequency', 'ω₀'],
    decay_rate: ['decay rate', 'γ'],
    drag: ['drag / mass', 'd/m'],
    frequency: ['frequency', 'f₀'],
    quality_factor: ['quality factor', 'Q'],
    reynolds: ['Reynolds number, largest', '']
  } as Record<string, [string, string]>,
  observed: {
    position: 'position',
    angle: 'angle',
    velocity: 'velocity',
    'angular velocity': 'angular velocity',
    acceleration: 'acceleration',
    voltage: 'voltage',
    force: 'force'
  } as Record<string, string>,
  decay: {
    title: 'Decay rate against amplitude',
    rate: 'decay rate (1/s)',
    amplitude: (unit: string) => ['amplitude ', 'A', ` (${unit})`],
    constant: (rate: string) => `one constant rate, ${rate}`,
    law: (text: string) => `law: ${text}`,
    lawOnly: 'fitted law',
    dots: 'dots: pieces of the recording, 95 % intervals',
    none: 'The recording is too short to be cut into pieces.',
    seen: (first: string, last: string, from: string, to: string) =>
      `Decay rate ${first} at amplitude ${from}, ${last} at ${to}.`
  },
  story: {
    notEnough: 'One decay rate is not enough.',
    falls: (from: string, to: string) => `It falls from ${from} to ${to} 1/s as the swing dies down; quote the law instead.`,
    rises: (from: string, to: string) => `It rises from ${from} to ${to} 1/s as the swing dies down; quote the law instead.`,
    enough: 'One decay rate is enough.',
    enoughWhy: (rate: string) => `At every amplitude it is ${rate} within its uncertainty.`,
    limits: (of: string) => ['The mass limits ', of, '.'],
    limitsWhy: (uncertainty: string, rest: string) => `Of its ± ${uncertainty}, the balance causes all but ${rest}.`,
    limitsAll: (uncertainty: string) => `Of its ± ${uncertainty}, the balance causes practically all.`,
    timeLimits: 'The recording limits k.',
    timeLimitsWhy: (part: string) => `The balance causes ${part} of its uncertainty.`,
    reynolds: 'The flow is not the laminar one.',
    reynoldsWhy: (largest: string) =>
      `The Reynolds number reaches ${largest}: drag with the square of the speed is to be expected.`,
    core: 'The core says',
    more: (count: number) => `${count} more`
  },
  overlay: {
    title: 'The law, simulated',
    caption: 'The fitted law stepped by two methods from the same start, beside the recording.',
    energy: 'Energy',
    phase: 'Phase',
    energyAxis: (unit: string) => ['energy ', 'E', ` (${unit})`],
    velocityAxis: (unit: string) => ['velocity ', 'v', ` (${unit})`],
    displacementAxis: (unit: string) => ['displacement ', 'x', ` (${unit})`],
    exact: 'exact law',
    show: 'Show simulations',
    hide: 'Hide the simulations',
    says: (method: string, amplitude: string, phase: string) =>
      `${method}: the amplitude at the end is ${amplitude} of the law’s, its phase off by ${phase}.`,
    grown: (method: string) => `${method} grows without end at this step.`,
    constantEnd: (off: string) => `With one constant decay rate the amplitude at the end is off by ${off}.`,
    step: (step: string) => `Step ${step}.`
  },
  command: 'Copy command',
  commandCopied: 'The command is copied.',
  numbers: { show: 'Show numbers', hide: 'Hide numbers' }
}
