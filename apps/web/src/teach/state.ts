// What the Teach page keeps in the address: the place in the tours, the class, and the answers.
import { areMethods, countTo, notNegative, oneOf, positive, type Rules } from '../state/rules'
import { labOne } from './lab_one'
import { labThree, pairDefaults } from './lab_three'
import { labTwo } from './lab_two'
import { isTolerance, optionsDefaults, unpacked } from './options'
import { isPrediction } from './predictions'

export const teachDefaults = {
  lab: 'one',
  /// The step shown, from 1, of each lab; and those whose goal was reached, as "1,2".
  one: 1,
  two: 1,
  three: 1,
  doneOne: [] as string[],
  doneTwo: [] as string[],
  doneThree: [] as string[],
  /// What was expected of the steps, before they were seen: see predictions.ts.
  expected: [] as string[],
  expectedTwo: [] as string[],
  course: '',
  student: '',
  ...optionsDefaults,
  /// The recording of lab two is the student's own, which is made anew when the page is opened again.
  taken: false,
  /// Answer and ± of lab two's questions in their order, joined by ; for a comma may be a decimal one; and the answers
  /// of lab one and of the class's own tasks.
  values: '',
  uncertainties: '',
  valuesOne: '',
  valuesTasks: '',
  /// Everything larger.
  projector: false,
  // What the steps of lab one set.
  position: 0,
  damping: 0,
  driveAmplitude: 0,
  driveFrequency: 1,
  step: 0.01,
  methods: ['euler-cromer'] as string[],
  forces: false, // shown on the mass
  ...pairDefaults // those of the two pendulums
}
export type TeachState = typeof teachDefaults

const steps = (count: number) => (names: string[]): boolean => names.every((name) => countTo(count)(Number(name)))
const arePredictions = (all: string[]): boolean => all.every(isPrediction)
export const teachRules: Rules<TeachState> = {
  lab: oneOf('one', 'two', 'three'),
  one: countTo(labOne.length), two: countTo(labTwo.length), three: countTo(labThree.length),
  doneOne: steps(labOne.length), doneTwo: steps(labTwo.length), doneThree: steps(labThree.length), secondSpring: positive,
  expected: arePredictions, expectedTwo: arePredictions,
  labs: (labs) => new Set(labs).size === labs.length && labs.every(oneOf('one', 'two')),
  tolerance: isTolerance, tasks: (tasks) => unpacked(tasks) !== null,
  damping: notNegative, driveAmplitude: notNegative, driveFrequency: positive, methods: areMethods,
  step: (step) => step >= 1e-4 // the longest step of lab one runs for 50 s
}
