// The page computes what the program computes: simulations, fits and modes in both, and compared.
//
//   node equality.mjs core.wasm path/to/cromer path/to/data
//
// Bit for bit where only + - * / and square roots are involved; else to 1e-12 of the largest amplitude so
// far. Of fits see fits.mjs, of modes modes.mjs.
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'

import { openCore } from './core.mjs'
import { compareFit } from './fits.mjs'
import { compareModes, modesOf } from './modes.mjs'
import { recordings } from './recordings.mjs'
import { compareSimulation } from './runs.mjs'
import { simulations } from './simulations.mjs'

const [wasm, cromer, data] = process.argv.slice(2)
const folder = mkdtempSync(join(tmpdir(), 'cromer-equality-'))
let wrong = 0
const report = (name, differences) => {
  if (differences.length === 0) return
  ++wrong
  console.log(`${name}:\n  ${differences.slice(0, 5).join('\n  ')}`)
}
try {
  const core = openCore(wasm)
  const cases = simulations()
  for (const each of cases) report(each.name, compareSimulation(core, cromer, folder, each))
  const fits = recordings(cromer, data, folder)
  for (const each of fits) report(each.name, compareFit(core, cromer, folder, each))
  const modes = modesOf(data)
  for (const each of modes) report(each.name, compareModes(core, cromer, folder, each))
  const exactly = cases.filter((each) => each.exactly).length
  console.log(
    `${cases.length} simulations (${exactly} to the bit), ${fits.length} fits and the modes of ${modes.length} recordings compared, ${wrong} differ`,
  )
} finally {
  rmSync(folder, { recursive: true })
}
process.exit(wrong === 0 ? 0 : 1)
