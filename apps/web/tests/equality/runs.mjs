// One simulation in both.
import { readFileSync } from 'node:fs'
import { join } from 'node:path'

import { onPage, run } from './program.mjs'

const share = 1e-12 // of the largest amplitude so far
const of_effect = 1e-11 // of the largest number beside it: eigenvalues are roots, and lose digits where they meet

const same = (a, b) => Object.is(a, b) || (a === 0 && b === 0)

/// What differs between two columns of numbers.
function column(name, ours, theirs, exactly) {
  if (ours.length !== theirs.length)
    return [`${name}: ${ours.length} values, the program has ${theirs.length}`]
  let largest = 0
  for (let i = 0; i < ours.length; ++i) {
    largest = Math.max(largest, Math.abs(theirs[i]))
    const near = exactly ? same(ours[i], theirs[i]) : Math.abs(ours[i] - theirs[i]) <= share * largest
    if (!near)
      return [
        `${name}[${i}]: ${ours[i]}, the program has ${theirs[i]} (off by ${(ours[i] - theirs[i]) / largest})`,
      ]
  }
  return []
}

/// Numbers, texts and lists that are near: numbers to `tolerance` of the largest in the same list or object.
export function differences(name, ours, theirs, tolerance, size = 0) {
  if (typeof ours === 'number' && typeof theirs === 'number')
    return Math.abs(ours - theirs) <= tolerance * Math.max(size, Math.abs(theirs))
      ? []
      : [`${name}: ${ours}, the program has ${theirs}`]
  if (ours && theirs && typeof ours === 'object' && typeof theirs === 'object') {
    const names = new Set([...Object.keys(ours), ...Object.keys(theirs)])
    const numbers = Object.values(theirs)
      .filter((value) => typeof value === 'number')
      .map(Math.abs)
    const largest = Math.max(0, ...numbers)
    return [...names].flatMap((each) =>
      differences(`${name}.${each}`, ours[each], theirs[each], tolerance, largest),
    )
  }
  return ours === theirs
    ? []
    : [`${name}: ${JSON.stringify(ours)}, the program has ${JSON.stringify(theirs)}`]
}

export function compareSimulation(core, cromer, folder, { options, exactly }) {
  const file = join(folder, 'run.json')
  const theirs = run(cromer, 'simulate', ['--quiet', '-o', file], options)
  const ours = core('simulate', options)
  if (ours.status !== theirs.status)
    return [`status ${ours.status}, the program's ${theirs.status}: ${theirs.message}`]
  if (theirs.status === 2)
    return ours.document.message === onPage(theirs.message)
      ? []
      : [`${ours.document.message}, the program says ${theirs.message}`]
  const document = JSON.parse(readFileSync(file))
  const found = differences('warnings', ours.document.warnings, document.warnings.map(onPage), 0)
  document.runs.forEach((program, i) => {
    const page = ours.document.runs[i]
    for (const name of ['t', 'x', 'v', 'energy'])
      found.push(...column(name, page.states[name], program.states[name], exactly || name === 't'))
    for (const name of ['status', 'counts', 'step', 'until', 'parameters', 'message', 'last_step'])
      if (exactly || name !== 'counts') found.push(...differences(name, page[name], program[name], 0))
    for (const name of ['effective', 'stable', 'stability_limit', 'transmissibility'])
      found.push(...differences(name, page[name], program[name], of_effect))
    for (const name of ['in_words']) found.push(...differences(name, page[name], program[name], 0))
    found.push(...differences('energy_balance', page.energy_balance, program.energy_balance, 1e-11))
  })
  return found
}
