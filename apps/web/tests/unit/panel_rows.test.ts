import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import { read, start } from '../../src/core/core'
import { rowsOf, sentenceOf } from '../../src/simulate/panel_rows'
import { methods } from '../../src/words/en/methods'
import { simulate } from '../../src/words/en/simulate'
import type { Words } from '../../src/words/words.svelte'

const built = fileURLToPath(new URL('../../../../build/page/core.wasm', import.meta.url))

// ./dev page builds the core.
describe.skipIf(!existsSync(built))('the sentence on the worst method', () => {
  it.each([
    ['-0.1', ['euler-cromer', 'implicit-euler'], /^Implicit Euler makes 0\.06\d+ of the decay rate of −0\.05\d* 1\/s\.$/],
    ['-0.1', ['rk4'], /^The damping is negative: the motion grows by the law itself\.$/],
    ['-7', ['rk4'], /^The damping is negative/],
    ['0', ['forward-euler'], /^Forward Euler adds growth of .* where there is no damping/],
    ['0.2', ['implicit-euler'], /^Implicit Euler adds damping of its own/],
  ])('is true of a damping of %s kg/s', async (damping, names, wanted) => {
    const core = await start(await WebAssembly.compile(readFileSync(built)))
    const answer = read<'motion'>(core.answer('motion', [
      ['mass', '1'], ['stiffness', '9'], ['damping', damping], ['position', '1'], ['step', '0.025'], ['until', '5'], ...names.map((name) => ['method', name] as const),
    ]))
    if (answer.status === 2) throw new Error('refused')
    const { runs, linear_part } = answer.document
    expect(sentenceOf(rowsOf(runs, linear_part), linear_part, { simulate, methods } as unknown as Words).text).toMatch(wanted)
  })
})
