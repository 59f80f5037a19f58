// What values an address may give the state: it may be anybody's.
import { methods } from '../words/en/methods'

/** Of each field a test of its value, in the state read so far; fields without one take any value of their kind. */
export type Rules<State> = { [Key in keyof State]?: (value: State[Key], state: State) => boolean }

export const positive = (value: number): boolean => value > 0
export const notNegative = (value: number): boolean => value >= 0
export const oneOf =
  <Text extends string>(...texts: Text[]) =>
  (value: string): boolean =>
    (texts as string[]).includes(value)
/** A whole number from 1 to `most`. */
export const countTo = (most: number) => (value: number): boolean => Number.isInteger(value) && value >= 1 && value <= most
/** Each known, and none twice. */
export const areMethods = (names: string[]): boolean => new Set(names).size === names.length && names.every((name) => Object.hasOwn(methods, name))
