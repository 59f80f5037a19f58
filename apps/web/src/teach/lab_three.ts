// Two pendulums joined by a spring: what each step sets when it is entered, what it lets the student change, and its goal.
import { near } from '../look/numbers'
import { simulateDefaults, type SimulateState } from '../simulate/state'

const mass = 1 // [kg] of each
const stiffness = 9.81 // [N/m] m g / l of a string of 1 m
export const pairDefaults = { firstStart: 0, secondStart: 0, joint: 0.5, secondSpring: stiffness, implicit: false }
type Settings = typeof pairDefaults
export type ControlThree = Exclude<keyof Settings, 'implicit'>

export interface StepThree {
  set: Settings
  control: keyof Settings
  reached: (state: Settings) => boolean
}

const pulled = { ...pairDefaults, firstStart: 0.1 }

export const labThree: StepThree[] = [
  { set: pairDefaults, control: 'firstStart', reached: (s) => near(s.firstStart, 0.1, 0.0005) },
  { set: pulled, control: 'secondStart', reached: (s) => near(s.secondStart, 0.1, 0.0005) },
  { set: { ...pulled, secondStart: 0.1 }, control: 'secondStart', reached: (s) => near(s.secondStart, -0.1, 0.0005) },
  { set: pulled, control: 'joint', reached: (s) => near(s.joint, 1, 0.005) },
  { set: pulled, control: 'secondSpring', reached: (s) => near(s.secondSpring, 12, 0.05) },
  { set: pulled, control: 'implicit', reached: (s) => s.implicit },
]

/// What Simulate would hold.
export const pairOf = ({ firstStart, secondStart, joint, secondSpring, implicit }: Settings): SimulateState => ({
  ...simulateDefaults, second: true, mass, stiffness, secondMass: mass, secondStiffness: secondSpring, coupling: joint, damping: 0, driveAmplitude: 0,
  position: firstStart, secondPosition: secondStart, step: 0.02, until: 50, methods: [implicit ? 'implicit-euler' : 'exact'],
})
