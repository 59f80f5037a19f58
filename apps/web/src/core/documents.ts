// What the core's documents consist of: written by tests/documents/description_test.cpp from
// src/cromer/documents/described, with CROMER_WRITE_DESCRIPTIONS=1. SI units.
import type { Maybe, Numbers } from './numbers'
import type { NoticeObject, Said } from '../words/said'

export interface Column {
  /** its title, "Time (s)", as the option `column` takes it */
  name: string
  /** time, position, ... */
  quantity: string
  /** as the file has it */
  unit: string
  /** from 1 */
  run: number
  /** values that are not missing */
  samples: number
  /** the time it is taken with; null of a time, and where there is none */
  time_column: string | null
  /** [as the file has it] only in a file written as JSON */
  values?: Numbers
}

export interface Gap {
  /** [s] where samples begin to be missing */
  t: number
  /** [s] how long */
  length: number
  /** only where there are several */
  run?: number
}

export interface Outlier {
  /** [s] of a sample far from its neighbours */
  t: number
  /** [SI] what it says */
  value: Maybe
  /** of the file, from 1 */
  line: number
  /** only where there are several */
  run?: number
}

export interface InspectedFile {
  /** its name */
  file: string
  /** the logger that wrote it */
  dialect: string
  /** of its text */
  encoding: string
  /** between its columns */
  separator: string
  /** of its numbers */
  decimal: string
  /** all of them */
  columns: Column[]
  /** the one that the rest describes: that asked for, else what a fit would take, or the first of several alike */
  column: string | null
  /** rows of the longest run */
  samples: number
  /** [1/s] null where not known */
  rate: Maybe
  /** [s] null where not known */
  duration: Maybe
  /** the time of that column; null without */
  time_column: string | null
  /** standard deviation of the time steps over their median */
  jitter: Maybe
  /** where samples are missing */
  gaps: Gap[]
  /** samples far from their neighbours */
  outliers: Outlier[]
  /** what else there is to know, in sentences */
  warnings: Said[]
  /** the same with code, severity and values */
  notices: NoticeObject[]
}

export interface InspectedSeries {
  /** from 1 */
  run: number
  /** its name */
  column: string
  /** what it records */
  observed: string | null
  /** of x; "" where it has no name */
  unit: string
  /** [1/s] null where not even */
  rate: Maybe
  /** [s] rises; missing values are left out */
  t: Numbers
  /** [SI] the column */
  x: Numbers
}

export interface Inspection extends InspectedFile {
  /** the column, one for each run that has it */
  series: InspectedSeries[]
}

export interface Recording {
  /** where it was read from */
  file: string
  /** the column that was fitted, as the file spells it */
  column: string
  /** what it records: position, angle, velocity, ...; null where it is not known */
  observed: string | null
  /** which run of the file, from 1 */
  run: number
  /** how many the file has */
  samples: number
  /** how many of them were fitted */
  used: number
  /** [s] time of the first sample used */
  from: Maybe
  /** [s] time of the last one */
  to: Maybe
  /** [1/s] samples per second; null where they are not even */
  rate: Maybe
  /** [s] from the first sample used to the last */
  duration: Maybe
  /** how often samples are missing in between */
  gaps: number
  /** how many samples were set aside */
  outliers: number
}

export interface Estimate {
  /** the estimate */
  value: Maybe
  /** its standard error, widened for correlated residuals */
  standard_error: Maybe
  /** 95 % interval from Student's t */
  confidence_95: [Maybe, Maybe]
  /** of all of these, SI; 1 of a plain number */
  unit: string
}

export interface Residual {
  /** [of the column] root mean square of what the law leaves, over the samples used without outliers */
  rms: Maybe
  /** p of the Jarque-Bera test */
  normality: Maybe
  /** from sample to sample */
  autocorrelation: Maybe
  /** compatible with no correlation up to lag 20 (Ljung-Box, 1 %) */
  white: boolean
}

export interface Candidate {
  /** a law that was tried */
  law: string
  /** [of the column] what it leaves */
  rms: Maybe
  /** Bayesian information criterion: the smaller, the better */
  bic: Maybe
  /** how a recorded force was read; only where there is one */
  between_samples?: string
}

export interface Mode {
  /** [rad/s] of the damped oscillation */
  angular_frequency: number
  /** [rad/s] its standard error */
  angular_frequency_standard_error: Maybe
  /** [1/s] below 0 where it grows */
  decay_rate: number
  /** [1/s] its standard error */
  decay_rate_standard_error: Maybe
  /** [of the column] at the first sample */
  amplitude: number
  /** [of the column] its standard error */
  amplitude_standard_error: Maybe
}

export interface HeldOut {
  /** [s] first time of the samples that were held out */
  from: number
  /** [s] their last time */
  to: number
  /** how many */
  samples: number
  /** [of the column] what the law, carried on, leaves of them */
  rms: Maybe
}

export interface DecaySegment {
  /** [s] where the segment begins */
  from: number
  /** [s] where it ends */
  to: number
  /** [1/s] decay rate fitted to this segment alone */
  rate: Maybe
  /** [1/s] its standard error */
  standard_error: Maybe
}

export interface AmplitudeRate {
  /** [of the displacement] in the middle of the stretch */
  amplitude: number
  /** [1/s] decay rate of one sinusoid fitted to this stretch alone */
  rate: Maybe
  /** [1/s] its standard error */
  standard_error: Maybe
  /** [1/s] 95 % interval */
  confidence_95: [Maybe, Maybe]
  /** [1/s] the law's at that amplitude, averaged over a cycle */
  law_rate: Maybe
  /** [s] where the stretch begins */
  from: number
  /** [s] where it ends */
  to: number
}

export interface ReynoldsWindow {
  /** [s] where the half second begins */
  t: number
  /** the largest Reynolds number in it */
  value: number
}

export interface Contribution {
  /** mass, spring_mass or angular_frequency */
  quantity: string
  /** [its own] what it was taken to be */
  value: number
  /** [its own] of the value */
  standard_uncertainty: Maybe
  /** its own unit */
  unit: string
  /** [N/m per its own] derivative of the spring constant */
  sensitivity: Maybe
  /** [N/m] what its uncertainty makes of the spring constant's */
  contribution: Maybe
  /** of the spring constant's variance, 0 to 1 */
  share: Maybe
}

export interface MonteCarlo {
  /** what was drawn */
  quantity: string
  /** how many */
  trials: number
  /** of the random numbers */
  seed: number
  /** [N/m] of the trials */
  mean: number
  /** [N/m] of the trials */
  standard_deviation: number
  /** [N/m] 95 % of the trials lie between, as many below as above */
  interval_95: [number, number]
  /** the same by the law of propagation */
  propagated: {
    /** [N/m] spring constant */
    value: Maybe
    /** [N/m] its standard error */
    standard_error: Maybe
    /** [N/m] 95 % interval */
    confidence_95: [Maybe, Maybe]
  }
  /** of all of these */
  unit: string
}

export interface RecordingPlan {
  /** what is to be known better */
  quantity: string
  /** its unit */
  unit: string
  /** [its own] standard uncertainty wanted */
  goal: number
  /** [its own] standard uncertainty of this record */
  now: number
  /** this record is enough */
  met: boolean
  /** a longer record from such a start reaches it */
  possible: boolean
  /** [s] that reaches it; where none does, beyond which nothing is gained */
  duration: Maybe
  /** [its own] where it is not possible: what the longest record gives */
  best: Maybe
  /** all this in a sentence */
  text: Said
}

export interface PeakDecrement {
  /** logarithmic decrement of a period, from the peaks */
  value: Maybe
  /** its standard error */
  standard_error: Maybe
  /** how many stand out of the noise */
  peaks: number
  /** what is wrong about it */
  bias: Said
}

export interface HalfPowerBandwidth {
  /** [rad/s] full width of the spectrum's line */
  value: Maybe
  /** of the width */
  unit: string
  /** [1/s] half the width */
  decay_rate: Maybe
  /** that over the line's frequency */
  damping_ratio: Maybe
  /** [rad/s] an undamped line's width in a record of this length */
  narrowest: Maybe
  /** what is wrong about it */
  bias: Said
}

export interface Textbook {
  /** null with fewer than 3 peaks */
  logarithmic_decrement: PeakDecrement | null
  /** null where the line does not fall to half its power on both sides */
  half_power_bandwidth: HalfPowerBandwidth | null
}

export interface FittedRecording {
  /** what was fitted */
  recording: Recording
  /** its terms, "viscous+drag"; null where the recording could not be read */
  law: string | null
  /** converged, or why there is no fit */
  status: string
  /** why, where it did not converge */
  message?: Said
  /** of least squares */
  iterations: number
  /** linear, hold or band-limited: how a recorded force is read; null without one */
  between_samples: string | null
  /** as fitted, per unit mass, by name; then, with a mass, what they are as forces */
  parameters: Record<string, Estimate>
  /** of the fitted parameters; its diagonal is the squares of their standard errors */
  covariance: {
    /** their names */
    parameters: string[]
    /** row by row */
    matrix: Numbers[]
  } | null
  /** what follows from the law, by name */
  derived: Record<string, Estimate>
  /** the command line that simulates this law; null where there is none */
  simulate: string | null
  /** what the law leaves */
  residual: Residual
  /** the laws that were tried */
  candidates: Candidate[]
  /** where two oscillations were found, the larger first */
  modes: Mode[]
  /** the samples that were kept from the fit */
  held_out?: HeldOut
  /** a decay rate for each segment */
  decay_segments: DecaySegment[]
  /** [1/s] of the segments; null without */
  decay_rate_mean: Maybe
  /** [1/s] its standard error */
  decay_rate_mean_standard_error: Maybe
  /** the decay rate of each stretch against its amplitude */
  decay_by_amplitude: AmplitudeRate[]
  /** null without a disc */
  reynolds: {
    /** the largest Reynolds number */
    max: number
    /** its standard error */
    standard_error: Maybe
    /** [s] where it is */
    t: number
    /** half a second each */
    windows: ReynoldsWindow[]
  } | null
  /** null without a disc */
  keulegan_carpenter: {
    /** 2 pi A/D at the largest amplitude */
    max: number
    /** its standard error */
    standard_error: Maybe
    /** 95 % interval */
    confidence_95: [Maybe, Maybe]
  } | null
  /** what the spring constant's uncertainty comes from */
  stiffness_budget: Contribution[]
  /** the spring constant by trials; null where none were asked for */
  monte_carlo: MonteCarlo | null
  /** how long to record; null where no goal was given */
  plan: RecordingPlan | null
  /** what textbooks would say; null where that was not asked for */
  textbook: Textbook | null
  /** what else there is to know, in sentences */
  warnings: Said[]
  /** the same with code, severity and values */
  notices: NoticeObject[]
}

export interface MotionUnits {
  /** of the column, and of the residuals */
  measured: string
  /** of x, and of amplitudes */
  displacement: string
  /** of v */
  velocity: string
  /** J, or per mass where none is known */
  energy: string
}

export interface FitCurves {
  /** [s] of the samples used */
  t: Numbers
  /** [of the column] the column */
  measured: Numbers
  /** [of the column] measured less the fitted law */
  residual: Numbers
  /** [of the displacement] the law's displacement from its equilibrium */
  x: Numbers
  /** [of v] the law's velocity */
  v: Numbers
  /** [J, or per mass] the law's */
  energy: Numbers
  /** [of v] from the samples alone; empty where they are no displacement, NaN within half a period of the ends */
  measured_velocity: Numbers
  /** [J, or per mass] likewise */
  measured_energy: Numbers
  /** [s] times of the samples set aside as outliers */
  set_aside: Numbers
}

export interface Fit extends FittedRecording {
  /** "" where one has no name */
  units: MotionUnits
  /** [of the displacement] what the law leaves */
  displacement_rms: Maybe
  /** the motion beside the law, sample by sample */
  curves: FitCurves | null
}

export interface ComparedCurve {
  /** one constant decay rate, or the law */
  label: string
  /** its terms */
  law: string
  /** that simulated it */
  method: string
  /** [of the column] measured less simulated */
  rms: Maybe
  /** share of the measured variance that is explained */
  r_squared: Maybe
  /** simulated over measured, at the end; null where the measured motion has stopped */
  amplitude_ratio_end: Maybe
  /** [rad] simulated minus measured, at the end; likewise */
  phase_drift: Maybe
  /** [s] of the method */
  step: number
  /** [of the column] the same without the method's error */
  law_rms: Maybe
  /** simulated over the law itself, at the end */
  method_amplitude_ratio: Maybe
  /** [rad] simulated minus the law itself, at the end */
  method_phase: Maybe
  /** the method is not stable at this step */
  diverged: boolean
}

export interface ComparedRecording {
  /** what it is compared with */
  recording: Recording
  /** of the fit */
  status: string
  /** why, where there is no fit or a simulation ended early */
  message?: Said
  /** the simulations */
  curves: ComparedCurve[]
  /** the measured swing is below the noise at the end */
  measured_at_rest?: boolean
  /** whether one decay rate is enough */
  explanation?: Said
  /** the fit, as `fit` gives it */
  fit: FittedRecording
  /** what else there is to know, in sentences */
  warnings: Said[]
  /** the same with code, severity and values */
  notices: NoticeObject[]
}

export interface CurveStates {
  /** [s] of the samples used */
  t: Numbers
  /** [of the displacement] from the fitted equilibrium */
  x: Numbers
  /** [of v] simulated */
  v: Numbers
  /** [J, or per mass] as of a fit's curves */
  energy: Numbers
}

export interface Comparison extends ComparedRecording {
  /** one for each of the curves */
  states: CurveStates[]
}

export interface Parameters {
  /** [kg] that swings */
  mass: number
  /** [N/m] spring constant k; negative with a cubic is a double well */
  stiffness: Maybe
  /** [kg/s] viscous damping c */
  damping: Maybe
  /** [kg/m] quadratic drag d */
  drag: Maybe
  /** [N] dry friction f while it slides */
  friction: Maybe
  /** [N/m^3] cubic stiffness k3 */
  cubic: Maybe
  /** [N/m^2] quadratic stiffness k2 */
  quadratic: Maybe
  /** [N/m^2] odd quadratic stiffness ka, of x|x| */
  odd_quadratic: Maybe
  /** [N/m^5] quintic stiffness k5 */
  quintic: Maybe
  /** [kg/(m^2 s)] damping e of x^2 x' */
  van_der_pol: Maybe
  /** [N/m] stiffness A of the hysteretic force where it begins */
  hysteresis_stiffness: Maybe
  /** [1/m] how soon the hysteretic force gives way, beta (N^(1-n)/m with an exponent n) */
  hysteresis_beta: Maybe
  /** [1/m] what sets the shape of its loops, gamma (N^(1-n)/m) */
  hysteresis_gamma: Maybe
  /** [N] force p of p sin x, x an angle */
  pendulum: Maybe
  /** of the hysteretic force */
  hysteresis_exponent: number
  /** [N] that holds it at rest */
  static_friction: number
  /** its kind */
  drive: string
  /** [N] of the drive */
  drive_amplitude: number
  /** [rad/s] of the drive; where a chirp begins */
  drive_frequency: number
  /** [rad] of the drive */
  drive_phase: number
  /** [rad/s] where a chirp ends */
  drive_to?: Maybe
  /** [s] of pulses and chirps */
  drive_start?: Maybe
  /** [s] of pulses and chirps; a step has none */
  drive_duration?: Maybe
  /** [kg] of an unbalance */
  unbalance_mass?: Maybe
  /** [m] of an unbalance */
  eccentricity?: Maybe
  /** [m] amplitude of a shaking base */
  base_displacement?: Maybe
  /** of a recorded drive */
  drive_file?: string
  /** how a recorded drive is read */
  between_samples?: string
  /** [m] at the start */
  position: number
  /** [m/s] at the start */
  velocity: number
}

export interface Counts {
  /** steps taken */
  accepted: number
  /** steps tried and thrown away, of adaptive methods */
  rejected: number
  /** of the acceleration */
  evaluations: number
  /** over all steps */
  newton_iterations: number
}

export interface FoundEvent {
  /** as it was asked for */
  event: string
  /** [s] when */
  t: number
  /** [m] position then */
  x: number
  /** [m/s] velocity then */
  v: number
}

export interface Accuracy {
  /** largest relative error */
  asked: number
  /** [s] that keeps to it */
  step: number
  /** null where the motion is driven */
  frequency_error: Maybe
  /** likewise, and where nothing is damped */
  decay_error: Maybe
  /** of the steady amplitude, or of the whole motion */
  amplitude_error: number
}

export interface EnergyBalance {
  /** [J] stored at the start */
  start: Maybe
  /** [J] stored at the end */
  end: Maybe
  /** [J] work done by the drive, either sign */
  drive: Maybe
  /** [J] taken by this resistance */
  damping: Maybe
  /** [J] taken by this resistance */
  drag: Maybe
  /** [J] taken by this resistance */
  friction: Maybe
  /** [J] taken by this resistance */
  van_der_pol: Maybe
  /** [J] made (+) or lost (-) by the method itself */
  method: Maybe
}

export interface ModifiedEnergy {
  /** [J] that the method conserves */
  start: Maybe
  /** [J] the same at the end */
  end: Maybe
  /** the largest change over the start */
  drift: Maybe
  /** looked at */
  states: number
  /** of the energy itself: half of what lies between its extremes, over their mean */
  energy_swing: Maybe
}

export interface Measured {
  /** [rad/s] half turns over the time they took */
  angular_frequency: number
  /** [1/s] fitted to the logarithm of the amplitudes */
  decay_rate: number
  /** [m] from the first turning point to the second, half */
  first_amplitude: number
  /** [m] likewise at the end */
  last_amplitude: number
  /** turning points less one */
  half_cycles: number
}

export interface SteadyState {
  /** [m] where the method's own driven motion settles */
  amplitude: Maybe
  /** [rad] its lag behind the force */
  phase: Maybe
}

export interface Effective {
  /** [1/s] simulated; null where nothing oscillates */
  decay_rate: Maybe
  /** [rad/s] simulated; likewise */
  angular_frequency: Maybe
  /** largest modulus of the eigenvalues */
  spectral_radius: Maybe
  /** of one step, real and imaginary part; the physical pair first */
  eigenvalues: [number, number][]
  /** only of a driven motion that settles */
  steady_state?: SteadyState
}

export interface SimulatedTransmission {
  /** of the method's motion */
  ratio: Maybe
  /** [rad] its lag */
  phase_lag: Maybe
  /** of the ratio, relative */
  error: Maybe
}

export interface Transmissibility {
  /** what is transmitted: force or displacement */
  of: string
  /** drive over undamped natural frequency */
  frequency_ratio: number
  /** what comes out over what goes in; null at undamped resonance */
  ratio: Maybe
  /** [rad] of what comes out */
  phase_lag: Maybe
  /** [m or N] amplitude of what goes in */
  sent: number
  /** [m or N] amplitude of what comes out */
  transmitted: Maybe
  /** by the method; null where its motion does not settle, and of adaptive methods */
  simulated: SimulatedTransmission | null
}

export interface Sensor {
  /** [m] standard deviation */
  noise: number
  /** [m] 0: not rounded */
  resolution: number
  /** [m] added to the position */
  offset: number
  /** of the noise */
  seed: number
}

export interface States {
  /** [s] time */
  t: Numbers
  /** [m] position */
  x: Numbers
  /** [m/s] velocity */
  v: Numbers
  /** [J] kinetic and potential */
  energy: Numbers
  /** [m] what a simulated sensor says; only with one */
  sensor?: Numbers
}

export interface Run {
  /** its name */
  method: string
  /** what tells this run from the others */
  label: string
  /** what it was made with */
  parameters: Parameters
  /** [s] of the method */
  step: number
  /** [s] end of the run */
  until: number
  /** relative to the motion's scale */
  tolerance: number
  /** each of so many states is kept */
  every: number
  /** states in compensated sums */
  compensated: boolean
  /** how it ended */
  status: string
  /** why it ended early */
  message?: Said
  /** by its user */
  interrupted: boolean
  /** [s] shorter where the steps do not fill the run */
  last_step: number
  /** what it took */
  counts: Counts
  /** the last state */
  final: {
    /** [s] when */
    t: number
    /** [m] position */
    x: Maybe
    /** [m/s] velocity */
    v: Maybe
    /** [J] kinetic and potential */
    energy: Maybe
  }
  /** that were watched for, in order of time */
  events: FoundEvent[]
  /** only where it was asked for */
  accuracy?: Accuracy
  /** end - start = drive - resistances + method; null where the states are too few */
  energy_balance: EnergyBalance | null
  /** only where the method conserves one */
  modified_energy?: ModifiedEnergy
  /** only of a free motion under a law that is not linear */
  measured?: Measured
  /** only of newmark */
  beta?: Maybe
  /** only of newmark */
  gamma?: Maybe
  /** only of generalized-alpha */
  rho_inf?: Maybe
  /** what the method makes of the law */
  in_words?: Said
  /** what the method really simulates; null where the law is not linear */
  effective: Effective | null
  /** the motion stays bounded */
  stable?: boolean
  /** [s] the longest stable step, only where this one is longer; null where there is none */
  stability_limit?: Maybe
  /** of the simulated motion; null where nothing oscillates */
  energy_factor_per_cycle?: Maybe
  /** only of a driven linear law with a spring */
  transmissibility?: Transmissibility
  /** the simulated sensor; null without */
  sensor: Sensor | null
  /** only in a file written as JSON */
  states?: States
}

export interface Method {
  /** as typed */
  name: string
  /** null for exact */
  order: number | null
  /** an equation is solved in each step */
  implicit: boolean
  /** said of the undamped law */
  symplectic: boolean
  /** it chooses its own steps */
  adaptive: boolean
  /** a step back undoes a step */
  reversible: boolean
  /** stable at any step where the law is */
  a_stable: boolean
  /** where it is published */
  source: string
  /** what it really simulates; only with a step */
  effective?: Effective
  /** the motion stays bounded */
  stable?: boolean
  /** [s] the longest stable step; null where there is none, 0 where no step is stable */
  stability_limit?: Maybe
  /** of the simulated motion; null where nothing oscillates */
  energy_factor_per_cycle?: Maybe
  /** the same in a sentence */
  in_words?: Said
}

export interface ResonanceCurve {
  /** its name */
  method: string
  /** false: the motion grows, never settles or was not tried, and the lists are empty */
  settled: boolean
  /** why it was not tried: a curve of a law that is not linear is stepped */
  too_many_steps: boolean
  /** [rad/s] of the drive */
  frequency: Numbers
  /** [m] steady */
  amplitude: Numbers
  /** [rad] lag behind the force */
  phase: Numbers
}
