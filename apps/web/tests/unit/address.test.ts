import { expect, test } from 'vitest'
import { addressOf, documentOf, readAddress } from '../../src/state/address'
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

test.each([
  'simulate?mass=-1', 'simulate?drag=-1', 'simulate?forces=maybe', 'simulate?quantity=foo', 'simulate?methods=rk4;curl%20evil|sh', 'simulate?methods=rk4,rk4',
  'simulate?methods=toString', 'simulate?step=1e-9', 'simulate?until=1e9', 'simulate?step=0', 'teach?one=99', 'teach?one=1.5', 'teach?lab=four', 'teach?three=7', 'simulate?quantity=second', 'simulate?secondMass=0',
  'teach?doneOne=1,x', 'teach?methods=nothing', 'teach?step=1e-9', 'measure?run=0',
])('what breaks a rule keeps its default: %s', (address) => {
  const tab = address.split('?')[0] as 'simulate' | 'measure' | 'teach'
  const { document, replaced } = readAddress(`#${address}`)
  expect(document).toEqual({ ...defaults(), tab })
  expect(replaced.map(({ key, text }) => `${tab}?${key}=${text}`)).toEqual([decodeURIComponent(address)])
})

test('step and end are judged together, whichever comes first', () => {
  for (const address of ['#simulate?step=0.00001&until=5', '#simulate?until=5&step=0.00001'])
    expect(documentOf(address).simulate).toMatchObject({ step: 0.00001, until: 5 })
})

test('the damping may be negative, as the program takes it', () => {
  expect(readAddress('#simulate?damping=-0.1')).toMatchObject({ document: { simulate: { damping: -0.1 } }, replaced: [] })
})

test('what stands in place of an impossible value is known', () => {
  expect(readAddress('#simulate?mass=-1&drag=heavy&stiffness=4&measure.run=0&nothing=1').replaced).toEqual([
    { key: 'mass', text: '-1', by: '1' }, { key: 'drag', text: 'heavy', by: '0' }, { key: 'measure.run', text: '0', by: '1' },
  ])
})
