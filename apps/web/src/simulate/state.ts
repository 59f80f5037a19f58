// What the Simulate page keeps: the law, its drive, the start and the run, in SI units.
import { areMethods, notNegative, oneOf, positive, type Rules } from '../state/rules'

export type Quantity = 'position' | 'velocity' | 'difference' | 'second'
export type PhonePlot = 'motion' | 'energy' | 'phase' | 'resonance'

export const simulateDefaults = {
  mass: 1,
  stiffness: 9,
  damping: 0.2,
  drag: 0,
  friction: 0,
  cubic: 0,
  quadratic: 0,
  oddQuadratic: 0,
  quintic: 0,
  vanDerPol: 0,
  pendulum: 0,
  driveAmplitude: 1,
  driveFrequency: 3,
  position: 0,
  velocity: 0,
  step: 0.025,
  until: 25,
  methods: ['exact', 'forward-euler', 'euler-cromer', 'implicit-euler'] as string[],
  quantity: 'position' as Quantity,
  forces: true, // shown on the mass
  // a second mass on a spring of its own, and the spring between both
  second: false,
  secondMass: 1,
  secondStiffness: 9,
  coupling: 1,
  secondPosition: 0,
}
export type SimulateState = typeof simulateDefaults

export const mostSteps = 1_000_000

/** What an address may hold. */
export const simulateRules: Rules<SimulateState> = {
  mass: positive, drag: notNegative, friction: notNegative, driveAmplitude: notNegative,
  driveFrequency: notNegative, methods: areMethods, secondMass: positive,
  quantity: (quantity, state) => oneOf('position', 'velocity', 'difference', state.second ? 'second' : '')(quantity),
  step: (step, state) => step > 0 && state.until / step <= mostSteps,
  until: (until, state) => until > 0 && until / state.step <= mostSteps,
}
