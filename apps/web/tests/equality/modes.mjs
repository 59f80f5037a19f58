// The modes of a recording in both: each number agrees to 1e-3 of its standard error, and texts are the same.
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'

import { onPage, run, sameWords } from './program.mjs'
import { differences } from './runs.mjs'

const share = 1e-3

/// Two carts on springs that are let go, 60 s at 50 Hz, with noise of 0.3 mm.
function twoCarts() {
  let state = 1
  const even = () => (state = (state * 48271) % 2147483647) / 2147483647
  const noise = () => 3e-4 * Math.sqrt(-2 * Math.log(even())) * Math.cos(2 * Math.PI * even())
  const mode = (t, frequency, decay) => 0.03 * Math.exp(-decay * t) * Math.cos(2 * Math.PI * frequency * t)
  const rows = Array.from({ length: 3000 }, (_, i) => {
    const [slow, fast] = [mode(i / 50, 0.8, 0.02), mode(i / 50, 1.3, 0.05)]
    return [i / 50, slow + fast + noise(), 0.9 * slow - 1.1 * fast + noise()].map((value) => value.toFixed(6)).join(',')
  })
  return `Time (s),Left (m),Right (m)\n${rows.join('\n')}\n`
}

/// `{name, bytes, options}` each.
export const modesOf = (data) => [
  { name: 'two_carts', bytes: Buffer.from(twoCarts()), options: [] },
  { name: 'two_carts_part', bytes: Buffer.from(twoCarts()), options: [['from', '5'], ['to', '40']] },
  { name: 'floors', bytes: readFileSync(join(data, 'networks', 'floors_in_wind.csv')), options: [] },
  { name: 'one_column', bytes: readFileSync(join(data, 'recording2.csv')), options: [] },
  { name: 'too_short', bytes: Buffer.from('Time (s),A (m),B (m)\n0,1,2\n1,2,1\n2,1,2\n'), options: [] },
  { name: 'by_method', bytes: Buffer.from(twoCarts()), options: [['of-method', 'newmark'], ['step', '0.02']], pageOnly: 'run it with the program' },
]

export function compareModes(core, cromer, folder, { name, bytes, options, pageOnly }) {
  const file = join(folder, `${name}.modes.csv`)
  writeFileSync(file, bytes)
  const ours = core('modes', [...options, ['file-name', file]], bytes)
  if (pageOnly)
    return ours.status === 2 && ours.document.message.includes(pageOnly) ? [] : [`${ours.status}: ${ours.document.message}, and not "${pageOnly}"`]
  const theirs = run(cromer, 'modes', [file, '--json', '--quiet'], options)
  if (ours.status !== theirs.status) return [`status ${ours.status} (${ours.document.message}), the program's ${theirs.status}: ${theirs.message}`]
  if (theirs.status === 2) return sameWords(ours.document.message, theirs.message) ? [] : [`"${ours.document.message}", the program says "${theirs.message}"`]
  const page = ours.document
  const program = JSON.parse(theirs.output)
  const facts = ({ names, recording, notices, warnings, message }) => ({
    names, motion: recording.motion, quantity: recording.quantity, unit: recording.unit, order: recording.highest_order,
    codes: notices.map(({ code, severity }) => `${code}, ${severity}`), texts: [message ?? '', ...warnings].map(onPage),
  })
  const found = differences('facts', facts(page), facts(program), 0)
  found.push(...differences('modes', page.modes.length, program.modes.length, 0))
  const near = (what, a, b, error) => (Math.abs(a - b) <= share * error ? [] : [`${what}: ${a}, the program has ${b} ± ${error}`])
  for (const [i, mode] of program.modes.entries()) {
    for (const each of ['frequency', 'damping_ratio']) {
      const [a, b] = [page.modes[i]?.[each], mode[each]]
      found.push(...near(`${each} ${i + 1}`, a?.value, b.value, b.standard_error))
      found.push(...near(`error of ${each} ${i + 1}`, a?.standard_error, b.standard_error, b.standard_error))
    }
    for (const [k, part] of mode.shape.entries())
      for (const j of [0, 1]) found.push(...near(`shape ${i + 1}`, page.modes[i]?.shape[k][j], part[j], mode.shape_standard_error[k][j] + 1e-9))
  }
  return found
}
