// What the overview draws of a file: times and values of the chosen column and run, in SI units.
import type { Column, Inspection } from '../core/types'
import { pyramidOf, type Pyramid } from './pyramid'

export interface Series {
  column: Column
  unit: string // SI, or the file's own where there is none
  t: Float64Array
  x: Float64Array
  pyramid: Pyramid
  spacing: number // [s] between samples
}

const toSi: Record<string, [number, string]> = {
  mm: [1e-3, 'm'],
  cm: [1e-2, 'm'],
  km: [1e3, 'm'],
  ms: [1e-3, 's'],
  min: [60, 's'],
  deg: [Math.PI / 180, 'rad'],
  '°': [Math.PI / 180, 'rad'],
  mV: [1e-3, 'V']
}
const fitted = ['position', 'angle', 'angular velocity', 'velocity', 'acceleration']

/// The columns that a fit may use.
export const columnsOf = (file: Inspection): Column[] => file.columns.filter((column) => column.quantity !== 'time')

/// The names, each once; runs share them.
export const namesOf = (file: Inspection): string[] => [...new Set(columnsOf(file).map((column) => column.name))]

export const runsOf = (file: Inspection): number => Math.max(1, ...file.columns.map((column) => column.run))

/// What is taken where nothing was chosen, as the core does: a position, else an angle and so on, else the first.
export function columnTaken(file: Inspection): string {
  for (const quantity of fitted) {
    const found = columnsOf(file).find((column) => column.quantity === quantity)
    if (found) return found.name
  }
  return columnsOf(file)[0]?.name ?? ''
}

function inSi(column: Column): { values: Float64Array; unit: string } {
  const [factor, unit] = toSi[column.unit] ?? [1, column.unit]
  return { values: factor === 1 ? column.values : column.values.map((value) => value * factor), unit }
}

export function seriesOf(file: Inspection, name: string, run: number, rate: number): Series | null {
  const wanted = name || columnTaken(file)
  const column =
    columnsOf(file).find((each) => each.name === wanted && each.run === run) ??
    columnsOf(file).find((each) => each.name === wanted)
  if (!column) return null
  const time = file.columns.find((each) => each.name === column.time_column && each.run === column.run) ??
    file.columns.find((each) => each.name === column.time_column)
  const spacing = 1 / (rate > 0 ? rate : (file.rate ?? 1))
  const all = time ? inSi(time).values : Float64Array.from(column.values, (_, i) => i * spacing)
  const { values, unit } = inSi(column)
  // Runs side by side may differ in length: the rest of a column is empty.
  let end = Math.min(all.length, values.length)
  while (end > 0 && !(Number.isFinite(all[end - 1]!) && Number.isFinite(values[end - 1]!))) --end
  const x = values.subarray(0, end)
  return { column, unit, t: all.subarray(0, end), x, pyramid: pyramidOf(x), spacing }
}
