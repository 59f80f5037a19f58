// What a plot is given.
import type { Pen } from './pen'

export interface Curve {
  meaning: string // gives the colour: a method's name, exact, measured, fitted, model, other (of another mass)
  name: string // the word at its end
  x: Float64Array // rising, but in phase plots
  y: Float64Array
  road?: boolean // drawn as the exact solution is: wide, grey, lowest
  dots?: boolean // measured: ink dots, a band where they are dense
  dashed?: boolean // keeps its colour
  smooth?: boolean // between its points it bends as they do; else a line joins them
  steps?: boolean // its points are the steps of a method: dots where they can be told apart
  note?: string // second line of its word: "grows without end"
  unbounded?: boolean // leaves the limits, which do not follow it
  data?: () => { x: Float64Array; y: Float64Array } // where x and y are a picture of it: what is saved, and read as numbers
}

/** The curve's own numbers. */
export const withData = (curve: Curve): Curve => (curve.data ? { ...curve, ...curve.data() } : curve)

export interface Axis {
  name: string // "position *x*"
  plain: string // "position", as spoken and in tables
  unit: string
}

export type Limits = [from: number, to: number]

/** Where things are on a plot [px]. */
export interface Frame {
  left: number
  right: number
  top: number
  bottom: number
  x: Limits
  y: Limits
  toX(value: number): number
  toY(value: number): number
}

/** Draws beside or over a plot with its axes; called for every picture of a moving plot. */
export type Decoration = (pen: Pen, frame: Frame, curves: Curve[]) => void

export function frameOf(left: number, right: number, top: number, bottom: number, x: Limits, y: Limits): Frame {
  const perX = (right - left) / (x[1] - x[0])
  const perY = (bottom - top) / (y[1] - y[0])
  return {
    left, right, top, bottom, x, y,
    toX: (value) => left + (value - x[0]) * perX,
    toY: (value) => bottom - (value - y[0]) * perY,
  }
}
