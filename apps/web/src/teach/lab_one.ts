// Lab one: what each step sets when it is entered, what it lets the student change, and its goal.
import type { Options } from '../core/types'
import { near } from '../look/numbers'
import type { TeachState } from './state'

export type Control = 'position' | 'damping' | 'driveFrequency' | 'step'
type Settings = Pick<TeachState, 'position' | 'damping' | 'driveAmplitude' | 'driveFrequency' | 'step' | 'methods'>

export interface StepOne {
  set: Settings
  happens?: number // which answer of its prediction
  control: Control | 'implicit' | 'table'
  reached: (state: TeachState) => boolean
  until: number // [s]
  limits?: [number, number] // of the plot [m]
  reach?: boolean // how far it would get without damping
  steady?: boolean // where it settles
}

const mass = 1 // [kg]
const stiffness = 9 // [N/m]

const rest: Settings = {
  position: 0, damping: 0, driveAmplitude: 1, driveFrequency: 3, step: 0.01, methods: ['euler-cromer']
}

export const labOne: StepOne[] = [
  {
    set: { ...rest, driveAmplitude: 0 },
    happens: 1,
    control: 'position',
    reached: (state) => near(state.position, 1, 0.005),
    until: 25,
    limits: [-2, 2]
  },
  {
    set: { ...rest, driveFrequency: 1 },
    happens: 1,
    control: 'driveFrequency',
    reached: (state) => near(state.driveFrequency, 3, 0.005),
    until: 50,
    limits: [-10, 10]
  },
  {
    set: rest,
    happens: 1,
    control: 'damping',
    reached: (state) => near(state.damping, 0.2, 0.001),
    until: 50,
    limits: [-4, 4],
    reach: true,
    steady: true
  },
  {
    set: { ...rest, damping: 0.2 },
    happens: 2,
    control: 'driveFrequency',
    reached: (state) => near(state.driveFrequency, 2, 0.005),
    until: 50,
    limits: [-2, 2],
    steady: true
  },
  {
    set: { ...rest, damping: 0.2, step: 0.025 },
    happens: 1,
    control: 'implicit',
    reached: (state) => state.methods.includes('implicit-euler'),
    until: 50,
    limits: [-2, 2],
    steady: true
  },
  {
    set: { ...rest, damping: 0.2, step: 0.025, methods: ['exact', 'forward-euler'] },
    happens: 0,
    control: 'step',
    reached: (state) => state.methods.includes('forward-euler') && state.step < 0.2 / stiffness,
    until: 50,
    limits: [-6, 6]
  },
  {
    set: { ...rest, damping: 0.2 },
    control: 'table',
    reached: () => false, // done by copying the table
    until: 50,
    limits: [-2, 2],
    steady: true
  }
]

type Run = Pick<TeachState, 'position' | 'damping' | 'driveAmplitude' | 'driveFrequency' | 'step' | 'methods'>

export function simulateOptions(state: Run, until: number): Options {
  const options: [string, string][] = [
    ['mass', String(mass)],
    ['stiffness', String(stiffness)],
    ['damping', String(state.damping)],
    ['position', String(state.position)]
  ]
  if (state.driveAmplitude > 0)
    options.push(['drive-amplitude', String(state.driveAmplitude)], ['drive-frequency', String(state.driveFrequency)])
  for (const method of state.methods) options.push(['method', method])
  options.push(['step', String(state.step)], ['until', String(until)])
  return options
}

/// How far the swing gets without damping at resonance, per second: F/(2 m omega) [m/s].
export const growth = (state: Run): number => state.driveAmplitude / (2 * mass * state.driveFrequency)

/// The runs whose numbers stand in the table of the last step.
export const tableRuns: Run[] = [
  { ...rest, driveAmplitude: 0, position: 1 },
  { ...rest, damping: 0.2 },
  { ...rest, damping: 0.2, driveFrequency: 2 },
  { ...rest, damping: 0.2, step: 0.025, methods: ['implicit-euler'] },
  { ...rest, damping: 0.2, step: 0.025, methods: ['forward-euler'] }
]
