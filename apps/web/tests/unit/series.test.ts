import { describe, expect, it } from 'vitest'
import type { Inspection } from '../../src/core/types'
import { isTimeless, measuredName, moveTogether, nameIn, namesOf, partsOf, seriesOf } from '../../src/measure/series'
import { scaleFor } from '../../src/measure/units'
import { measure as en } from '../../src/words/en/measure'

const series = (run: number, rate: number | null) =>
  ({ run, column: 'Acceleration (g)', observed: 'acceleration', unit: 'm/s²', rate, t: Float64Array.of(0, 0.5), x: Float64Array.of(1, -2) })
const file = (of: Partial<Inspection>) => ({ columns: [], series: [], ...of }) as unknown as Inspection

describe('the series of a run', () => {
  it('is what the core took', () => {
    const found = seriesOf(file({ series: [series(1, 2), series(2, 4)] }), 2)!
    expect(found).toMatchObject({ run: 2, unit: 'm/s²', spacing: 0.25 })
    expect([...found.x]).toEqual([1, -2])
  })
  it('is that of the first run where the run has none', () => {
    expect(seriesOf(file({ series: [series(1, null)] }), 3)).toMatchObject({ run: 1, spacing: 1 })
    expect(seriesOf(file({}), 1)).toBeNull()
  })
})

describe('a file', () => {
  const column = (time_column: string | null) => ({ name: 'x', quantity: '', unit: '', run: 1, samples: 2, time_column })
  it('is timeless where no column has times', () => {
    expect(isTimeless(file({ columns: [column(null), column(null)] }))).toBe(true)
    expect(isTimeless(file({ columns: [column(null), column('t (s)')] }))).toBe(false)
  })
  it('names its columns, and what was computed of them', () => {
    const columns = [column(null), { ...column(null), name: 'y' }, { ...column(null), name: 't', quantity: 'time' }]
    expect(namesOf(file({ columns, column: 'y (m)' }))).toEqual(['x', 'y'])
    expect(namesOf(file({ columns, column: 'angle(x,y) (rad)' }))).toEqual(['x', 'y', 'angle(x,y)'])
    expect(namesOf(file({ columns, column: null }))).toEqual(['x', 'y'])
    expect(nameIn(['x', 'angle(x,y)'], 'angle(x,y) (rad)')).toBe('angle(x,y)')
    expect(nameIn(['Position (left)'], 'Position (left)')).toBe('Position (left)')
  })
  it('has columns that move together where two of one run are of one kind', () => {
    const columns = (...of: [run: number, quantity: string | null][]) =>
      file({ columns: of.map(([run, quantity]) => ({ ...column(null), run, quantity })) } as Partial<Inspection>)
    expect(moveTogether(columns([1, 'time'], [1, 'position'], [1, 'position']), 1)).toBe(true)
    expect(moveTogether(columns([1, 'time'], [1, 'position'], [1, 'velocity']), 1)).toBe(false)
    expect(moveTogether(columns([1, 'position'], [2, 'position']), 1)).toBe(false)
    const point = [{ ...column(null), quantity: 'position' }, { ...column(null), name: 'y', quantity: 'position' }]
    expect(moveTogether(file({ columns: point, column: 'y (m)' }), 1)).toBe(true)
    expect(moveTogether(file({ columns: point, column: 'angle(x,y) (rad)' }), 1)).toBe(false)
    expect(moveTogether(columns([1, null], [1, null]), 1)).toBe(false)
    expect(moveTogether(columns([1, 'time'], [1, 'time'], [1, 'position']), 1)).toBe(false)
  })
})

describe('what was measured', () => {
  it('has the quantity’s name, else the column’s without its unit', () => {
    expect(measuredName({ observed: 'acceleration', column: 'a (g)' }, en)).toBe('acceleration')
    expect(measuredName({ observed: null, column: 'Pressure (kPa)' }, en)).toBe('Pressure')
    expect(measuredName(null, en)).toBe('')
  })
  it('parts a heading', () => {
    expect(partsOf('Position (mm)')).toEqual({ name: 'Position', unit: 'mm' })
    expect(partsOf('x (a) b')).toEqual({ name: 'x (a) b', unit: '' })
  })
  it('has factors of ten for lengths and their speeds alone', () => {
    expect(scaleFor(0.003, 'm')).toEqual({ factor: 1000, unit: 'mm' })
    expect(scaleFor(0.03, 'm/s')).toEqual({ factor: 100, unit: 'cm/s' })
    expect(scaleFor(0.003, 'm/s²')).toEqual({ factor: 1, unit: 'm/s²' })
    expect(scaleFor(0.003, 'rad')).toEqual({ factor: 1, unit: 'rad' })
  })
})
