// What the overview draws of a file: times and values of the chosen run, in SI units, as the core took them.
import type { Column, InspectedSeries, Inspection } from '../core/types'
import type { measure } from '../words/en/measure'
import { pyramidOf, type Pyramid } from './pyramid'

export interface Series extends InspectedSeries {
  pyramid: Pyramid
  spacing: number // [s] between samples
}

/// The columns that a fit may use.
export const columnsOf = (file: Inspection): Column[] => file.columns.filter((column) => column.quantity !== 'time')

/// The names, each once; runs share them. What was computed of columns stands behind them.
export const namesOf = (file: Inspection): string[] => {
  const names = [...new Set(columnsOf(file).map((column) => column.name))]
  const taken = file.column ? nameIn(names, file.column) : ''
  return names.length > 1 && taken && !names.includes(taken) ? [...names, taken] : names
}

/// The name of a column that is given by its name or its heading.
export const nameIn = (names: string[], heading: string): string => (names.includes(heading) ? heading : partsOf(heading).name)

export const runsOf = (file: Inspection): number => Math.max(1, ...file.columns.map((column) => column.run))

/// Whether columns of one kind were recorded together, and are no x and y of one point.
export const moveTogether = (file: Inspection, run: number): boolean => {
  if (namesOf(file).length > new Set(columnsOf(file).map((column) => column.name)).size) return false
  const kinds = columnsOf(file).flatMap((column) => (column.run === run && column.quantity ? [column.quantity] : []))
  return new Set(kinds).size < kinds.length
}

/// No column has times: the rate has to be given.
export const isTimeless = (file: Inspection): boolean => file.columns.every((column) => column.time_column === null)

/// Of the run, else of the first that has the column.
export function seriesOf(file: Inspection, run: number): Series | null {
  const found = file.series.find((each) => each.run === run) ?? file.series[0]
  return found ? { ...found, pyramid: pyramidOf(found.x), spacing: found.rate ? 1 / found.rate : 1 } : null
}

/// "Position" and "mm" of "Position (mm)".
export function partsOf(heading: string): { name: string; unit: string } {
  const found = /^(.*?)\s*\(([^()]*)\)\s*$/.exec(heading)
  return { name: found?.[1] ?? heading, unit: found?.[2] ?? '' }
}

/// What was measured, in words; of an unknown quantity its column's name. The file's unit is not that of what is shown.
export const measuredName = (of: { observed: string | null; column?: string } | null, words: typeof measure): string =>
  words.observed[of?.observed ?? ''] ?? partsOf(of?.column ?? '').name
