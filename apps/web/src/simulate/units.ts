// Units that suit the size: what swings by millimetres is plotted in mm.
import type { Curve } from '../plot/curve'
import { extentOf } from '../plot/extent'

const lengths = [
  { name: 'm', factor: 1, least: 0.1 },
  { name: 'cm', factor: 100, least: 0.01 },
  { name: 'mm', factor: 1e3, least: 1e-4 },
  { name: 'µm', factor: 1e6, least: 0 },
]
const energies = [
  { name: 'MJ', factor: 1e-6, least: 1e7 },
  { name: 'kJ', factor: 1e-3, least: 1e4 },
  { name: 'J', factor: 1, least: 0.1 },
  { name: 'mJ', factor: 1e3, least: 1e-4 },
  { name: 'µJ', factor: 1e6, least: 0 },
]
const forces = [
  { name: 'kN', factor: 1e-3, least: 1e4 },
  { name: 'N', factor: 1, least: 0.1 },
  { name: 'mN', factor: 1e3, least: 0 },
]
export interface Unit {
  name: string
  factor: number
}

function fit(curves: Curve[], units: (Unit & { least: number })[]): Unit {
  let most = 0
  for (const curve of curves)
    if (!curve.unbounded || curves.every((each) => each.unbounded))
      most = Math.max(most, extentOf(curve.y).size)
  return suiting(most, units)
}

/** Nothing has the unit without a prefix. */
const suiting = (size: number, units: (Unit & { least: number })[]): Unit => units.find(({ factor, least }) => (size > 0 ? size >= least : factor === 1))!

export const lengthUnit = (curves: Curve[]): Unit => fit(curves, lengths)
export const energyUnit = (curves: Curve[]): Unit => fit(curves, energies)
/** Of one size [J], [N]. */
export const energyUnitOf = (size: number): Unit => suiting(size, energies)
export const forceUnitOf = (size: number): Unit => suiting(size, forces)

/** y times `factor`. */
export const scaled = (curves: Curve[], factor: number): Curve[] =>
  factor === 1 ? curves : curves.map((curve) => ({ ...curve, ...times(curve, factor), data: curve.data && (() => times(curve.data!(), factor)) }))
const times = ({ x, y }: { x: Float64Array; y: Float64Array }, factor: number) => ({ x, y: y.map((value) => value * factor) })
