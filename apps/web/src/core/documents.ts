// What the core's documents consist of: written by tests/documents/description_test.cpp from
// src/cromer/documents/described, with CROMER_WRITE_DESCRIPTIONS=1. SI units.
import type { Maybe, Numbers } from './numbers'
import type { NoticeObject, Said } from '../words/said'

export interface Column {
  /** title of the column, "Time (s)", as the option `column` takes it */
  name: string
  /** the recorded quantity: time, position, ... */
  quantity: string
  /** unit, as in the file */
  unit: string
  /** number of the run, from 1 */
  run: number
  /** number of values that are not missing */
  samples: number
  /** the column of its times; null if there is none or if it is a time itself */
  time_column: string | null
  /** [as the file has it] its numbers; only in a file written as JSON */
  values?: Numbers
}

export interface Gap {
  /** [s] beginning of the gap */
  t: number
  /** [s] length of the gap */
  length: number
  /** number of the run; only if there are several */
  run?: number
}

export interface Outlier {
  /** [s] time of the sample */
  t: number
  /** [SI] its value */
  value: Maybe
  /** its line in the file, from 1 */
  line: number
  /** number of the run; only if there are several */
  run?: number
}

export interface InspectedFile {
  /** name of the file */
  file: string
  /** the logger that wrote it */
  dialect: string
  /** encoding of its text */
  encoding: string
  /** separator of its columns */
  separator: string
  /** decimal mark of its numbers */
  decimal: string
  /** all columns */
  columns: Column[]
  /** the column that the rest describes: the one asked for, else the one that a fit takes, or the first of several alike */
  column: string | null
  /** number of rows of the longest run */
  samples: number
  /** [1/s] samples per second; null if not known */
  rate: Maybe
  /** [s] duration of the recording; null if not known */
  duration: Maybe
  /** the column of its times; null if there is none */
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
  /** number of the run, from 1 */
  run: number
  /** title of the column */
  column: string
  /** the recorded quantity; null if not known */
  observed: string | null
  /** unit of x; "" if it has no name */
  unit: string
  /** [1/s] samples per second; null if their spacing is not even */
  rate: Maybe
  /** [s] times, increasing; missing values are left out */
  t: Numbers
  /** [SI] values of the column */
  x: Numbers
}

export interface Inspection extends InspectedFile {
  /** the column in each run that has it */
  series: InspectedSeries[]
}

export interface Recording {
  /** name of the file */
  file: string
  /** title of the fitted column, as in the file; only if it was read */
  column?: string
  /** the recorded quantity: position, angle, velocity, ...; null if not known */
  observed: string | null
  /** number of the run in the file, from 1 */
  run: number
  /** number of samples in the file */
  samples: number
  /** number of fitted samples */
  used: number
  /** [s] time of the first sample used */
  from: Maybe
  /** [s] time of the last sample used */
  to: Maybe
  /** [1/s] samples per second; null if their spacing is not even */
  rate: Maybe
  /** [s] from the first sample used to the last */
  duration: Maybe
  /** number of gaps, where samples are missing */
  gaps: number
  /** number of samples set aside */
  outliers: number
}

export interface Estimate {
  /** estimate */
  value: Maybe
  /** its standard error, with correlated residuals taken into account */
  standard_error: Maybe
  /** 95 % interval from Student's t */
  confidence_95: [Maybe, Maybe]
  /** SI unit of all of these; 1 for a plain number */
  unit: string
}

export interface Residual {
  /** [of the column] root mean square of the residuals, over the samples used without outliers */
  rms: Maybe
  /** p value of the Jarque-Bera test */
  normality: Maybe
  /** correlation of neighbouring residuals */
  autocorrelation: Maybe
  /** no correlation up to lag 20 is found (Ljung-Box test at 1 %) */
  white: boolean
}

export interface Candidate {
  /** a law that was tried */
  law: string
  /** [of the column] rms of its residuals; of a law that is clearly worse, fitted in coarse steps, to about a thousandth */
  rms: Maybe
  /** Bayesian information criterion; smaller is better */
  bic: Maybe
  /** interpolation of a recorded force; only with one */
  between_samples?: string
}

export interface Mode {
  /** [rad/s] damped angular frequency */
  angular_frequency: number
  /** [rad/s] its standard error */
  angular_frequency_standard_error: Maybe
  /** [1/s] decay rate; negative if the mode grows */
  decay_rate: number
  /** [1/s] its standard error */
  decay_rate_standard_error: Maybe
  /** [of the column] amplitude at the first sample */
  amplitude: number
  /** [of the column] its standard error */
  amplitude_standard_error: Maybe
}

export interface HeldOut {
  /** [s] time of the first sample held out */
  from: number
  /** [s] time of the last one */
  to: number
  /** number of samples held out */
  samples: number
  /** [of the column] rms of their residuals under the fitted law */
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
  /** [of the displacement] amplitude in the middle of the stretch */
  amplitude: number
  /** [1/s] decay rate by a fit to this stretch alone, beside the law's course within it */
  rate: Maybe
  /** [1/s] its standard error */
  standard_error: Maybe
  /** [1/s] 95 % interval */
  confidence_95: [Maybe, Maybe]
  /** [1/s] rate at which the fitted law's amplitude falls there, averaged over a cycle */
  law_rate: Maybe
  /** [rad/s] angular frequency by that fit */
  angular_frequency: Maybe
  /** [rad/s] its standard error */
  angular_frequency_standard_error: Maybe
  /** [rad/s] angular frequency of the fitted law's swings of that amplitude */
  law_angular_frequency: Maybe
  /** [s] where the stretch begins */
  from: number
  /** [s] where it ends */
  to: number
}

export interface ReynoldsWindow {
  /** [s] where the half second begins */
  t: number
  /** largest Reynolds number in it */
  value: number
}

export interface Contribution {
  /** what contributes: mass, spring_mass or angular_frequency */
  quantity: string
  /** [its own] value used */
  value: number
  /** [its own] standard uncertainty of that value */
  standard_uncertainty: Maybe
  /** unit of both */
  unit: string
  /** [N/m per its own] derivative of the spring constant by this quantity */
  sensitivity: Maybe
  /** [N/m] its part of the standard uncertainty of the spring constant */
  contribution: Maybe
  /** its share of the variance of the spring constant, 0 to 1 */
  share: Maybe
}

export interface MonteCarlo {
  /** the quantity of the trials */
  quantity: string
  /** number of trials */
  trials: number
  /** seed of the random numbers */
  seed: number
  /** [N/m] mean of the trials */
  mean: number
  /** [N/m] standard deviation of the trials */
  standard_deviation: number
  /** [N/m] interval with 95 % of the trials, and as many below it as above */
  interval_95: [number, number]
  /** the same by propagation of uncertainty */
  propagated: {
    /** [N/m] spring constant */
    value: Maybe
    /** [N/m] its standard error */
    standard_error: Maybe
    /** [N/m] 95 % interval */
    confidence_95: [Maybe, Maybe]
  }
  /** unit of all of these */
  unit: string
}

export interface RecordingPlan {
  /** the quantity of the goal */
  quantity: string
  /** its unit */
  unit: string
  /** [its own] wanted standard uncertainty */
  goal: number
  /** [its own] standard uncertainty of this record */
  now: number
  /** whether this record is long enough */
  met: boolean
  /** whether a longer record from the same start reaches the goal */
  possible: boolean
  /** [s] duration that reaches the goal; if none does, the duration beyond which nothing is gained */
  duration: Maybe
  /** [its own] only if it is not possible: standard uncertainty of the longest useful record */
  best: Maybe
  /** the plan in a sentence */
  text: Said
}

export interface PeakDecrement {
  /** logarithmic decrement per period, from the peaks */
  value: Maybe
  /** its standard error */
  standard_error: Maybe
  /** number of peaks above the noise */
  peaks: number
  /** what is wrong with this method */
  bias: Said
}

export interface HalfPowerBandwidth {
  /** [rad/s] full width of the line in the spectrum */
  value: Maybe
  /** unit of the width */
  unit: string
  /** [1/s] half the width */
  decay_rate: Maybe
  /** decay rate over the frequency of the line */
  damping_ratio: Maybe
  /** [rad/s] width of an undamped line in a record of this length */
  narrowest: Maybe
  /** what is wrong with this method */
  bias: Said
}

export interface Textbook {
  /** by the peaks; null with fewer than 3 of them */
  logarithmic_decrement: PeakDecrement | null
  /** by the spectrum; null if the line does not fall to half its power on both sides */
  half_power_bandwidth: HalfPowerBandwidth | null
}

export interface FittedRecording {
  /** the fitted recording */
  recording: Recording
  /** terms of the law, "viscous+drag"; null if the recording could not be read */
  law: string | null
  /** converged, or why there is no fit */
  status: string
  /** why there is no fit; only then */
  message?: Said
  /** iterations of least squares */
  iterations: number
  /** interpolation of a recorded force: linear, hold or band-limited; null without one */
  between_samples: string | null
  /** what is looked for first, as far as it is known: frequency; stiffness (with a mass); decay_rate_start and decay_rate_end, by all terms of the law, of a free motion; reynolds_max (with a disc) */
  headline: Record<string, Estimate>
  /** fitted parameters by name, per unit mass; with a mass also those of the forces */
  parameters: Record<string, Estimate>
  /** covariance of the fitted parameters; its diagonal is the squares of their standard errors */
  covariance: {
    /** their names */
    parameters: string[]
    /** the covariance matrix, row by row */
    matrix: Numbers[]
  } | null
  /** quantities that follow from the law, by name */
  derived: Record<string, Estimate>
  /** command line that simulates this law, over the recording; null if there is none */
  simulate: string | null
  /** residuals: measured minus fitted */
  residual: Residual
  /** the laws that were tried */
  candidates: Candidate[]
  /** two oscillations, the larger first; empty if only one was found */
  modes: Mode[]
  /** samples that were kept out of the fit */
  held_out?: HeldOut
  /** a decay rate for each segment */
  decay_segments: DecaySegment[]
  /** [1/s] mean decay rate of the segments; null without segments */
  decay_rate_mean: Maybe
  /** [1/s] its standard error */
  decay_rate_mean_standard_error: Maybe
  /** decay rate and frequency against amplitude, stretch by stretch */
  decay_by_amplitude: AmplitudeRate[]
  /** Reynolds numbers; null without a disc */
  reynolds: {
    /** largest Reynolds number */
    max: number
    /** its standard error */
    standard_error: Maybe
    /** [s] when it is reached */
    t: number
    /** largest Reynolds number of each half second */
    windows: ReynoldsWindow[]
  } | null
  /** Keulegan-Carpenter number; null without a disc */
  keulegan_carpenter: {
    /** 2 pi A/D at the largest amplitude */
    max: number
    /** its standard error */
    standard_error: Maybe
    /** 95 % interval */
    confidence_95: [Maybe, Maybe]
  } | null
  /** contributions to the uncertainty of the spring constant */
  stiffness_budget: Contribution[]
  /** spring constant by Monte Carlo trials; null if not asked for */
  monte_carlo: MonteCarlo | null
  /** how long to record; null without a goal */
  plan: RecordingPlan | null
  /** damping by textbook methods; null if not asked for */
  textbook: Textbook | null
  /** what else there is to know, in sentences */
  warnings: Said[]
  /** the same with code, severity and values */
  notices: NoticeObject[]
}

export interface MotionUnits {
  /** unit of the column and of the residuals */
  measured: string
  /** unit of x and of amplitudes */
  displacement: string
  /** unit of v */
  velocity: string
  /** unit of energies: J, or per mass if no mass is known */
  energy: string
}

export interface FitCurves {
  /** [s] times of the samples used */
  t: Numbers
  /** [of the column] values of the column */
  measured: Numbers
  /** [of the column] measured minus fitted */
  residual: Numbers
  /** [of the displacement] displacement from the equilibrium, by the law */
  x: Numbers
  /** [of v] velocity, by the law */
  v: Numbers
  /** [J, or per mass] energy, by the law */
  energy: Numbers
  /** [of v] velocity from the samples alone; empty if they are no displacement, NaN within half a period of the ends */
  measured_velocity: Numbers
  /** [J, or per mass] energy from the samples alone; likewise */
  measured_energy: Numbers
  /** [s] times of the samples set aside as outliers */
  set_aside: Numbers
}

export interface Fit extends FittedRecording {
  /** the forces of the law, "c x'" */
  formulas: string[]
  /** names of the parameters that are the law's coefficients, in SI where a mass gives them */
  coefficients: string[]
  /** units of the curves; "" if one has no name */
  units: MotionUnits
  /** [of the displacement] rms of the residuals as a displacement */
  displacement_rms: Maybe
  /** the motion beside the law, sample by sample */
  curves: FitCurves | null
}

export interface ComparedCurve {
  /** one constant decay rate, the law, or the law by a method */
  label: string
  /** terms of the law */
  law: string
  /** method of the simulation; `exact`: none, the law itself */
  method: string
  /** [of the column] rms of measured minus simulated */
  rms: Maybe
  /** explained share of the measured variance */
  r_squared: Maybe
  /** simulated over measured amplitude at the end; null if the measured motion has stopped */
  amplitude_ratio_end: Maybe
  /** [rad] simulated minus measured phase at the end; null if the measured motion has stopped */
  phase_drift: Maybe
  /** [s] step of the method */
  step: Maybe
  /** [of the column] rms of measured minus the exact solution of the law */
  law_rms: Maybe
  /** simulated over exact amplitude at the end */
  method_amplitude_ratio: Maybe
  /** [rad] simulated minus exact phase at the end */
  method_phase: Maybe
  /** whether the method is unstable at this step */
  diverged: boolean
}

export interface ComparedRecording {
  /** the measured recording */
  recording: Recording
  /** status of the fit */
  status: string
  /** why there is no fit, or why a simulation ended early; only then */
  message?: Said
  /** one constant decay rate and the law, without a method's error, then the law by each method */
  curves: ComparedCurve[]
  /** whether the measured motion is below the noise at the end */
  measured_at_rest?: boolean
  /** whether one decay rate is enough */
  explanation?: Said
  /** the same as from `fit` */
  fit: FittedRecording
  /** what else there is to know, in sentences */
  warnings: Said[]
  /** the same with code, severity and values */
  notices: NoticeObject[]
}

export interface CurveStates {
  /** [s] times of the samples used */
  t: Numbers
  /** [of the displacement] simulated displacement from the fitted equilibrium */
  x: Numbers
  /** [of v] simulated velocity */
  v: Numbers
  /** [J, or per mass] energy, as in the curves of a fit */
  energy: Numbers
}

export interface Comparison extends ComparedRecording {
  /** states of each of the curves */
  states: CurveStates[]
}

export interface Parameters {
  /** [kg] mass that swings */
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
  /** exponent of the hysteretic force */
  hysteresis_exponent: number
  /** [N] friction that holds the mass at rest */
  static_friction: number
  /** kind of the drive */
  drive: string
  /** [N] amplitude of the drive */
  drive_amplitude: number
  /** [rad/s] angular frequency of the drive; at the beginning of a chirp */
  drive_frequency: number
  /** [rad] phase of the drive */
  drive_phase: number
  /** [rad/s] angular frequency at the end of a chirp */
  drive_to?: Maybe
  /** [s] beginning of a pulse or a chirp */
  drive_start?: Maybe
  /** [s] duration of a pulse or a chirp; a step has none */
  drive_duration?: Maybe
  /** [kg] mass of an unbalance */
  unbalance_mass?: Maybe
  /** [m] eccentricity of an unbalance */
  eccentricity?: Maybe
  /** [m] amplitude of a shaking base */
  base_displacement?: Maybe
  /** file of a recorded drive */
  drive_file?: string
  /** interpolation of a recorded drive */
  between_samples?: string
  /** [m] position at the start */
  position: number
  /** [m/s] velocity at the start */
  velocity: number
}

export interface Counts {
  /** number of steps taken */
  accepted: number
  /** number of steps rejected by an adaptive method */
  rejected: number
  /** evaluations of the acceleration */
  evaluations: number
  /** Newton iterations over all steps */
  newton_iterations: number
}

export interface FoundEvent {
  /** the event, as it was asked for */
  event: string
  /** [s] time of the event */
  t: number
  /** [m] position then */
  x: number
  /** [m/s] velocity then */
  v: number
}

export interface Accuracy {
  /** largest relative error that was asked for */
  asked: number
  /** [s] longest step that keeps to it */
  step: number
  /** relative error of the frequency; null if the motion is driven */
  frequency_error: Maybe
  /** relative error of the decay rate; null if the motion is driven or not damped */
  decay_error: Maybe
  /** relative error of the steady amplitude, or of the whole motion */
  amplitude_error: number
}

export interface EnergyBalance {
  /** [J] energy stored at the start */
  start: Maybe
  /** [J] energy stored at the end */
  end: Maybe
  /** [J] work done by the drive, of either sign */
  drive: Maybe
  /** [J] taken by this resistance */
  damping: Maybe
  /** [J] taken by this resistance */
  drag: Maybe
  /** [J] taken by this resistance */
  friction: Maybe
  /** [J] taken by this resistance */
  van_der_pol: Maybe
  /** [J] energy gained (+) or lost (-) by the error of the method */
  method: Maybe
}

export interface ModifiedEnergy {
  /** [J] modified energy, which the method conserves, at the start */
  start: Maybe
  /** [J] modified energy at the end */
  end: Maybe
  /** its largest change, relative to the start */
  drift: Maybe
  /** number of states that were compared */
  states: number
  /** swing of the energy itself: half the difference of its extremes over their mean */
  energy_swing: Maybe
}

export interface Measured {
  /** [rad/s] angular frequency, from the times of the turning points */
  angular_frequency: number
  /** [1/s] decay rate, fitted to the logarithms of the amplitudes */
  decay_rate: number
  /** [m] half the distance of the first two turning points */
  first_amplitude: number
  /** [m] half the distance of the last two */
  last_amplitude: number
  /** number of half cycles: turning points less one */
  half_cycles: number
}

export interface SteadyState {
  /** [m] amplitude of the steady motion as the method simulates it */
  amplitude: Maybe
  /** [rad] its lag behind the force */
  phase: Maybe
}

export interface Effective {
  /** [1/s] decay rate of the simulated motion; null if nothing oscillates */
  decay_rate: Maybe
  /** [rad/s] angular frequency of the simulated motion; null if nothing oscillates */
  angular_frequency: Maybe
  /** largest modulus of the eigenvalues */
  spectral_radius: Maybe
  /** eigenvalues of one step, real and imaginary parts; the physical pair first */
  eigenvalues: [number, number][]
  /** steady motion; only of a driven motion that settles */
  steady_state?: SteadyState
}

export interface SimulatedTransmission {
  /** ratio in the simulated motion */
  ratio: Maybe
  /** [rad] phase lag in the simulated motion */
  phase_lag: Maybe
  /** relative error of the ratio */
  error: Maybe
}

export interface Transmissibility {
  /** the transmitted quantity: force or displacement */
  of: string
  /** drive frequency over undamped natural frequency */
  frequency_ratio: number
  /** transmitted over applied amplitude; null at undamped resonance */
  ratio: Maybe
  /** [rad] phase lag of the transmitted quantity */
  phase_lag: Maybe
  /** [m or N] applied amplitude */
  sent: number
  /** [m or N] transmitted amplitude */
  transmitted: Maybe
  /** the same by the method; null if its motion does not settle or the method is adaptive */
  simulated: SimulatedTransmission | null
}

export interface Sensor {
  /** [m] standard deviation of the noise */
  noise: number
  /** [m] resolution; 0: not rounded */
  resolution: number
  /** [m] offset, added to the position */
  offset: number
  /** seed of the noise */
  seed: number
}

export interface States {
  /** [s] time */
  t: Numbers
  /** [m] position */
  x: Numbers
  /** [m/s] velocity */
  v: Numbers
  /** [J] kinetic and potential energy */
  energy: Numbers
  /** [m] readings of the simulated sensor; only with one */
  sensor?: Numbers
}

export interface Run {
  /** name of the method */
  method: string
  /** label that tells this run from the others */
  label: string
  /** law, drive and start */
  parameters: Parameters
  /** [s] step of the method */
  step: number
  /** [s] end of the run */
  until: number
  /** tolerance, relative to the scale of the motion */
  tolerance: number
  /** every n-th state is kept */
  every: number
  /** whether states are compensated sums */
  compensated: boolean
  /** how the run ended */
  status: string
  /** why the run ended early; only then */
  message?: Said
  /** whether its user interrupted it */
  interrupted: boolean
  /** [s] last step; shorter if the steps do not fill the run */
  last_step: number
  /** numbers of steps and evaluations */
  counts: Counts
  /** the last state */
  final: {
    /** [s] time */
    t: number
    /** [m] position */
    x: Maybe
    /** [m/s] velocity */
    v: Maybe
    /** [J] kinetic and potential energy */
    energy: Maybe
  }
  /** events that were asked for, in order of time */
  events: FoundEvent[]
  /** the step for the accuracy asked for; only then */
  accuracy?: Accuracy
  /** energies: end - start = drive - resistances + method; null if there are too few states */
  energy_balance: EnergyBalance | null
  /** energy that the method conserves; only if there is one */
  modified_energy?: ModifiedEnergy
  /** oscillation of the simulated motion; only of a free motion under a law that is not linear */
  measured?: Measured
  /** beta of newmark; only of this method */
  beta?: Maybe
  /** gamma of newmark; only of this method */
  gamma?: Maybe
  /** rho_inf of generalized-alpha; only of this method */
  rho_inf?: Maybe
  /** what the method makes of the law, in words */
  in_words?: Said
  /** what the method really simulates; null if the law is not linear */
  effective: Effective | null
  /** whether the simulated motion stays bounded */
  stable?: boolean
  /** [s] longest stable step, only if this one is longer; null if there is none */
  stability_limit?: Maybe
  /** factor of the energy over a cycle of the simulated motion; null if nothing oscillates */
  energy_factor_per_cycle?: Maybe
  /** transmissibility; only of a driven linear law with a spring */
  transmissibility?: Transmissibility
  /** the simulated sensor; null without one */
  sensor: Sensor | null
  /** kept states; only in a file written as JSON */
  states?: States
}

export interface Method {
  /** name, as typed */
  name: string
  /** order; null for exact */
  order: number | null
  /** whether each step solves an equation */
  implicit: boolean
  /** whether it is symplectic for the undamped law */
  symplectic: boolean
  /** whether it chooses its own steps */
  adaptive: boolean
  /** whether a step back undoes a step */
  reversible: boolean
  /** whether it is stable at any step if the law is */
  a_stable: boolean
  /** publication */
  source: string
  /** what it really simulates; only if a step was given */
  effective?: Effective
  /** whether the simulated motion stays bounded */
  stable?: boolean
  /** [s] longest stable step; null if there is no limit, 0 if no step is stable */
  stability_limit?: Maybe
  /** factor of the energy over a cycle of the simulated motion; null if nothing oscillates */
  energy_factor_per_cycle?: Maybe
  /** the same in words */
  in_words?: Said
}

export interface ResonanceCurve {
  /** name of the method */
  method: string
  /** false if the motion grows, never settles or was not tried; the lists are then empty */
  settled: boolean
  /** true if it was not tried because it takes too many steps */
  too_many_steps: boolean
  /** [rad/s] angular frequencies of the drive */
  frequency: Numbers
  /** [m] steady amplitudes */
  amplitude: Numbers
  /** [rad] phase lags behind the force */
  phase: Numbers
  /** [m] steady amplitude at the drive's own frequency; null if there is none */
  at_drive: Maybe
}

export interface ModeOfNetwork {
  /** from 1, by rising frequency */
  mode: number
  /** [Hz] the network's */
  frequency: number
  /** the network's */
  damping_ratio: number
  /** modal assurance criterion of the two shapes, 0.5 to 1: 1 for the same */
  mac: number
}

export interface ModeByMethod {
  /** name, as typed */
  method: string
  /** [s] its time step */
  step: number
  /** [Hz] |eigenvalue|/2 pi of what it simulates; null if nothing oscillates */
  frequency: Maybe
  /** likewise; negative if the mode grows */
  damping_ratio: Maybe
  /** whether the mode stays bounded */
  stable: boolean
  /** the same in words */
  in_words: Said
}

export interface NaturalMode {
  /** |eigenvalue|/2 pi, 0 of a free body; null if the mode falls away from rest */
  frequency: Estimate
  /** minus the eigenvalue's real part over its size; null where the frequency is 0 or null */
  damping_ratio: Estimate
  /** of each of `names`, as [re, im]; the largest is 1 */
  shape: [Maybe, Maybe][]
  /** of the parts of `shape`, likewise; empty of a network */
  shape_standard_error: [Maybe, Maybe][]
  /** effective modal mass over the whole mass, for ground that shakes all the same; null for recordings */
  participation: Maybe
  /** the network's mode that matches this one; null without one */
  of_network: ModeOfNetwork | null
  /** what each method really simulates of it */
  methods: ModeByMethod[]
}

export interface Beat {
  /** difference of the two frequencies */
  frequency: Estimate
  /** time from one beat to the next */
  period: Estimate
  /** difference of the squared frequencies over their sum */
  coupling: Estimate
}

export interface SpectralPeak {
  /** [Hz] where it stands */
  frequency: number
  /** its height over the median around it */
  prominence: number
}

export interface StabilityPole {
  /** of the model */
  order: number
  /** [Hz] |eigenvalue|/2 pi */
  frequency: number
  /** of the pole */
  damping_ratio: number
  /** frequency within 1 %, damping ratio within a half and shape within a MAC of 0.95 of a pole of the order before */
  stable: boolean
}

export interface ModalSource {
  /** free_decay (it was let go, or grows by itself) or ambient (random forces keep it moving) */
  motion: string
  /** run of the file, from 1 */
  run: number
  /** what the channels measure */
  quantity: string
  /** SI unit of the channels */
  unit: string
  /** that all channels have */
  samples: number
  /** [1/s] samples per second */
  rate: number
  /** [s] from the first sample to the last */
  duration: number
  /** how many */
  gaps: number
  /** of the models; 0 if the recording is too short for any */
  highest_order: number
  /** [Hz] steady oscillations among random forces: of machines, no modes */
  lines: Numbers
  /** of the largest singular value of the spectral matrix (frequency domain decomposition) */
  peaks: SpectralPeak[]
  /** the stabilisation diagram: the poles of all orders */
  poles: StabilityPole[]
  /** what kind of motion it is, and how its modes were found */
  in_words: Said
}

export interface Modes {
  /** the file */
  file: string
  /** the masses or channels, in the order of the components of shapes */
  names: string[]
  /** by rising frequency */
  modes: NaturalMode[]
  /** how two modes beat and are coupled; null unless there are two that swing and whose frequencies surely differ */
  beat: Beat | null
  /** what the modes were found in; null of a network */
  recording: ModalSource | null
  /** why no mode was found */
  message?: Said
  /** what else there is to know, in sentences */
  warnings: Said[]
  /** the same with code, severity and values */
  notices: NoticeObject[]
}
