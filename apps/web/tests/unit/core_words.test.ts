// What the core says on the page is German where the page is, and names no options: its catalogue is tested in
// tests/documents, here what the page asks.
import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { read, start } from '../../src/core/core'
import type { Options, Task } from '../../src/core/types'
import { english as inEnglish, type Said } from '../../src/words/said'

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))

const built = path('../../../../build/page/core.wasm')
describe.skipIf(!existsSync(built))('what the core says of bad input, in German', async () => {
  const core = existsSync(built) ? await start(await WebAssembly.compile(readFileSync(built))) : undefined!
  /// English words that no German sentence has.
  const english = /\b(the|is|are|not|with|of|it|must|there|for|and)\b/
  const german = (said: Said) => (typeof said === 'string' ? said : said.de)
  const withoutQuotes = (text: string) => text.replace(/"[^"]*"|[„“][^“”]*[“”]/g, '""')

  function said(task: Task, options: Options, file?: string | Uint8Array): Said[] {
    const bytes = typeof file === 'string' ? new TextEncoder().encode(file) : file
    const answer = read(core.answer(task, bytes ? [...options, ['file-name', 'lab.csv']] : options, bytes))
    if (answer.status === 2) return [answer.document.message]
    const document = answer.document as { warnings?: Said[]; fits?: { message?: Said; warnings?: Said[] }[] }
    const all = task === 'simulate' ? [] : [...(document.warnings ?? [])] // those are not shown
    for (const fit of document.fits ?? []) all.push(...(fit.message ? [fit.message] : []), ...(fit.warnings ?? []))
    return all
  }
  const speaks = (messages: Said[], least = 1) => {
    if (process.env.CROMER_SAY) for (const each of messages) console.log(`${inEnglish(each)}\n    ${german(each)}`)
    expect(messages.length).toBeGreaterThanOrEqual(least)
    expect(messages.map(german).filter((text) => english.test(withoutQuotes(text)))).toEqual([])
    // the page has handles and buttons, no options
    expect([...messages.map(german), ...messages.map(inEnglish)].filter((text) => /(^|[^\w-])--[a-z]/.test(text))).toEqual([])
  }

  it('numbers, units and signs', () => {
    const typed = ['', 'abc', '3 parsecs', '2 s', '-1', '1e999', '1,5 kg', '0.2 ± -0.1', '(2', '1 ± 0.1', '3 x 10', '0.2176(', 'nan']
    const options = ['mass', 'stiffness', 'damping', 'drag', 'friction', 'cubic', 'drive-amplitude', 'position', 'velocity', 'step']
    speaks(options.flatMap((option) => typed.flatMap((text) => said('simulate', [[option, text], ['method', 'rk4'], ['until', '1e-3'], ...(option === 'step' ? [] : [['step', '1e-3'] as [string, string]])]))), 60)
  })

  const rows = (count: number, x: (t: number, i: number) => number | string, head = 'Time (s),Position (m)', step = 0.02) =>
    `${head}\n${Array.from({ length: count }, (_, i) => `${(i * step).toFixed(4)},${x(i * step, i)}`).join('\n')}\n`
  const noise = (i: number) => ((Math.imul(i + 1, 2654435761) >>> 0) / 2 ** 32 - 0.5) * 4e-4
  const swing = (t: number, i: number) => 0.2 + 0.03 * Math.exp(-0.05 * t) * Math.cos(9.42 * t) + noise(i)

  it('mass, disc, air and free part', () => {
    const file = rows(600, swing)
    const settings: [string, string][] = [
      ['mass', '217 parsnips'], ['mass', '-2 g'], ['mass', '0'], ['disc-diameter', '12 s'], ['disc-diameter', '-1 cm'], ['temperature', '20'],
      ['temperature', 'warm'], ['rate', '-4'], ['from', 'x'], ['from', '900'], ['to', '-3'], ['column', 'speed'], ['run', '7'], ['law', 'pendulum'],
    ]
    speaks(settings.flatMap((option) => said('fit', [option, ...(option[0] === 'temperature' ? [['disc-diameter', '12 cm'] as [string, string]] : [])], file)), 13)
    speaks(said('fit', [['from', '9'], ['to', '3']], file))
  })

  it('files that are none', () => {
    const files = [
      '', 'no table\njust words\n', 'Time (s),Position (m)\n0,1\n0.1,2\n0.2,abc\n0.3,1\n', 'Time (s),Position (m)\n0,1\n0.1,2\n2020-01-02,3\n0.3,1\n',
      'Time (s),Position (m)\n0,1\n0.1,2\n12:30:01,3\n0.3,1\n', 'Time (s);Position (m)\n0,0;1,5\n0,1;2.5\n0,2;3,5\n0,3;3,5\n', 'Time (s),Position (m)\n0,1,4,4\n0.1,2,2,2,2,2\n0.2,3\n',
      'Time (s),Position (m)\n1,1\n1,2\n1,3\n1,4\n1,5\n', 'Time (s),Position (m)\n5,1\n4,2\n3,3\n2,4\n1,5\n', 'Time (parsec),Position (m)\n0,1\n1,2\n2,3\n3,3\n',
      'Position (m)\n1\n2\n3\n2\n', 'Time (s)\n1\n2\n3\n4\n', 'x,y\n1,2\n3,4\n', 'Time (s),Position (m)\n0,"1,000,5"\n1,2\n2,3\n3,4\n',
      new Uint8Array([1, 0, 2, 0, 0, 5]), new TextEncoder().encode('PK\u0003\u0004 broken'), new Uint8Array([0xff, 0xfe, 0x31, 0xd8, 0x31]),
      `Vernier Format 2\nlab\n`,
    ]
    speaks(files.flatMap((file) => [...said('inspect', [], file), ...said('fit', [], file)]), 20)
  })

  it('what is repaired, and what is doubtful', () => {
    const files = [
      rows(600, (t, i) => (i === 300 ? 5 : swing(t, i))), rows(600, (t, i) => (i > 200 && i < 230 ? '' : swing(t, i))), rows(600, (t) => 0.2 + 0.03 * Math.cos(9.42 * t)),
      rows(600, (t, i) => swing(t, i) + 0.002 * t), rows(600, (t, i) => swing(t, i) + (i > 300 ? 0.05 : 0)), rows(600, (_, i) => noise(i)), rows(600, () => 1), rows(7, swing),
      rows(600, (t, i) => 0.2 + 0.001 * t * Math.cos(9.42 * t) + noise(i)), rows(600, (t, i) => Math.min(0.215, swing(t, i))), rows(600, (t, i) => 0.2 + Math.exp(-3 * t) + noise(i)),
      rows(600, (t, i) => swing(t, i) + 0.004 * Math.cos(15 * t)), rows(600, (t, i) => (i < 150 ? 0.23 : swing(t - 3, i))), rows(600, swing, 'Time,Position'), rows(600, swing, 'Time (s),Quark (qq)'),
      rows(600, (t, i) => swing(t, i), 'Time (s),Position (furlong)'), rows(600, (t, i) => `${swing(t, i)},${swing(t, i)}`, 'Time (s),x (m),y (m)'), rows(600, swing, 'Time (s),Angle (rad)'),
      rows(600, (t, i) => 10 * t + noise(i), 'Time (s),Angle (rad)'), rows(600, (t, i) => swing(t, i), 'Time (s),Acceleration (m/s^2)'), rows(40, swing), rows(120, (t, i) => swing(t, i), 'Time (s),Position (m)', 0.3),
      rows(600, (t, i) => (i > 400 ? 0.2 : swing(t, i))), rows(300, swing) + rows(300, swing).split('\n').slice(1).join('\n'), rows(600, (t, i) => 0.2 + 0.03 * Math.cos(9.42 * t + 0.05 * t * t) + noise(i)),
    ]
    const all = files.flatMap((file) => [[], [['mass', '217.6 g'], ['disc-diameter', '12 cm'], ['temperature', '20 °C']] as Options].flatMap((options) => [...said('inspect', [], file), ...said('fit', options, file), ...said('fit', [...options, ['law', 'viscous+drag+friction']], file)]))
    speaks(all, 40)
  }, 120_000)
})
