import { expect, test } from 'vitest'
import { addressOf, documentOf } from '../../src/state/address'
import { defaults } from '../../src/state/page.svelte'

test('the defaults need no words', () => {
  expect(addressOf(defaults())).toBe('#simulate')
  expect(documentOf('')).toEqual(defaults())
})

test('every state comes back from its address', () => {
  const state = defaults()
  state.simulate.mass = 0.2176
  state.simulate.damping = 1e-9
  state.simulate.position = -0.1 + 0.3
  state.simulate.methods = ['exact', 'rk4']
  state.simulate.quantity = 'difference'
  expect(documentOf(addressOf(state))).toEqual(state)
  state.tab = 'teach'
  expect(addressOf(state)).toContain('simulate.mass=0.2176')
  expect(documentOf(addressOf(state))).toEqual(state)
  state.simulate.methods = []
  expect(documentOf(addressOf(state))).toEqual(state)
})

test('what cannot be read keeps its default', () => {
  expect(documentOf('#simulate?mass=heavy&__proto__=1&toString=2&nothing=3')).toEqual(defaults())
  expect(documentOf('#elsewhere?mass=2')).toEqual(defaults())
  expect(documentOf('#simulate?mass=2').simulate.mass).toBe(2)
})
