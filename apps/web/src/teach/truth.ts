// What a student's own recording was made of: a mass on a spring with a disc in air, as in the second lab.
import type { Options } from '../core/types'
import { numbersOf } from './seed'

/// SI units.
export interface Truth {
  seed: number
  mass: number // [kg] what swings
  massRead: number // [kg] what the balance showed, off by less than its ±
  massUncertainty: number // [kg]
  disc: number // [m] diameter
  stiffness: number // [N/m]
  damping: number // [kg/s]
  drag: number // [kg/m]
  start: number // [m]
  offset: number // [m] distance from the sensor at rest
  until: number // [s]
}

const airDensity = 1.204 // [kg/m^3] at 20 °C; only sets the size of the drag

const kept = (value: number, digits: number) => Number(value.toPrecision(digits))

/// Of a seed of seed.ts: mass 0.18 to 0.28 kg, k 12 to 20 N/m, c 0.5 to 1.2 g/s, drag coefficient 2.4 to 3.4,
/// disc of 10 to 13 cm, start at 3 to 4 cm: the decay rate falls to about a half within 120 s.
export function truthOf(seed: number): Truth {
  const next = numbersOf(seed)
  const between = (low: number, high: number) => low + (high - low) * next()
  const massRead = kept(between(0.18, 0.28), 4)
  const massUncertainty = 0.0003
  const mass = massRead + kept(between(-0.00024, 0.00024), 2)
  const disc = Math.round(between(20, 26)) / 200
  const coefficient = between(2.4, 3.4)
  return {
    seed,
    massRead,
    massUncertainty,
    mass: kept(mass, 6),
    disc,
    stiffness: kept(between(12, 20), 4),
    damping: kept(between(0.0005, 0.0012), 3),
    drag: kept((airDensity * coefficient * Math.PI * disc * disc) / 8, 4),
    start: kept(between(0.03, 0.04), 3),
    offset: kept(between(0.18, 0.32), 3),
    until: 120
  }
}

/// The options of the task "synthetic" that make the student's recording: 100 samples a second, noise of
/// 0.3 mm, rounded to 0.1 mm. `noise` [m] other than that is for what the answers are checked with.
export function recordingOptions(truth: Truth, noise?: number): Options {
  const fine = noise !== undefined
  return [
    ['mass', `${truth.mass} kg`],
    ['stiffness', `${truth.stiffness} N/m`],
    ['damping', `${truth.damping} kg/s`],
    ['drag', `${truth.drag} kg/m`],
    ['position', `${truth.start} m`],
    ['until', `${truth.until} s`],
    ['method', 'rk4'],
    ['step', '1 ms'],
    ['every', fine ? '20' : '10'],
    ['sensor-noise', fine ? `${noise} m` : '0.3 mm'],
    ['sensor-resolution', fine ? '0 m' : '0.1 mm'],
    ['sensor-offset', `${truth.offset} m`],
    ['seed', String(truth.seed % 1_000_000_007)]
  ]
}

/// "217.6 ± 0.3 g" and "12 cm": what the student is told, and types.
export const massText = (truth: Truth): string =>
  `${(truth.massRead * 1000).toFixed(1)} ± ${(truth.massUncertainty * 1000).toFixed(1)} g`
export const discText = (truth: Truth): string => `${Number((truth.disc * 100).toFixed(1))} cm`
