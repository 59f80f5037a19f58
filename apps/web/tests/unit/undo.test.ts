import { expect, test } from 'vitest'
import { page } from '../../src/state/page.svelte'
import { canUndo, change, forget, redo, settle, undo } from '../../src/state/undo.svelte'

const mass = (value: number, at: number) => change('mass', (state) => (state.simulate.mass = value), at)

test('what a slider does in one go is one change', () => {
  forget()
  mass(2, 0)
  mass(3, 100)
  mass(4, 5000)
  undo()
  expect(page.simulate.mass).toBe(3)
  undo()
  expect(page.simulate.mass).toBe(1)
  expect(canUndo()).toBe(false)
  redo()
  expect(page.simulate.mass).toBe(3)
})

test('changes of different controls are undone one by one', () => {
  forget()
  mass(5, 20_000)
  change('method', (state) => (state.simulate.methods = ['rk4']), 20_001)
  mass(6, 20_002)
  undo()
  expect(page.simulate.mass).toBe(5)
  undo()
  expect(page.simulate.methods).not.toEqual(['rk4'])
})

test('what is settled stays, whatever is undone', () => {
  forget()
  mass(7, 30_000)
  settle((state) => (state.measure.column = 'Position (m)'))
  mass(8, 30_001)
  undo()
  expect(page.simulate.mass).toBe(7)
  undo()
  expect(page.measure.column).toBe('Position (m)')
  redo()
  expect(page.measure.column).toBe('Position (m)')
})
