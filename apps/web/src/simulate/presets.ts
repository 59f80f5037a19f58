// Things that swing, with numbers of their usual size.
import type { SimulateState } from './state'
import { terms } from './terms'

type Preset = Pick<SimulateState, 'mass' | 'stiffness' | 'damping' | 'driveAmplitude' | 'driveFrequency' | 'position' | 'step' | 'until'>

const free = { driveAmplitude: 0, driveFrequency: 1 }

/** A quarter of a car on its spring and damper; a child on a swing of 2.5 m; a seismograph of 1 Hz with 0.7 of the
    critical damping, shaken; a building of ten storeys in the wind; a tuning fork of 440 Hz. */
export const presets = {
  car: { mass: 350, stiffness: 20000, damping: 1500, ...free, position: 0.05, step: 0.01, until: 4 },
  swing: { mass: 30, stiffness: 117.7, damping: 0.9, ...free, position: 0.8, step: 0.05, until: 120 },
  seismograph: { mass: 1, stiffness: 39.48, damping: 8.8, driveAmplitude: 0.02, driveFrequency: 3, position: 0, step: 0.01, until: 12 },
  building: { mass: 6e6, stiffness: 2.37e8, damping: 1.5e6, driveAmplitude: 4e5, driveFrequency: 6.28, position: 0, step: 0.02, until: 60 },
  fork: { mass: 0.02, stiffness: 152900, damping: 0.05, ...free, position: 0.0005, step: 2e-5, until: 0.1 },
} satisfies Record<string, Preset>

export type PresetName = keyof typeof presets

export const withoutTerms: Partial<SimulateState> = Object.fromEntries(terms.map(({ key }) => [key, 0]))

/** All that a preset sets: also what it does not name. */
export const stateOf = (name: PresetName): Partial<SimulateState> => ({ ...withoutTerms, velocity: 0, second: false, ...presets[name] })

/** The one that is on; '' where there is none. */
export const presetOf = (s: SimulateState): PresetName | '' =>
  (Object.keys(presets) as PresetName[]).find((name) => Object.entries(stateOf(name)).every(([key, value]) => s[key as keyof SimulateState] === value)) ?? ''
