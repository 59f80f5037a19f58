import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { compile, read, start } from '../../src/core/core'
import type { Options, Task } from '../../src/core/types'
import { core as german } from '../../src/words/de/core'
import { coreSources, messagesOf } from './core_messages'

const table = readFileSync(fileURLToPath(new URL('../../src/words/de/core.ts', import.meta.url)), 'utf8')
const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))

describe('what the core says, in German', () => {
  it('keeps what was put in, with a decimal comma', () => {
    expect(german('lab.csv:17: column "Position (m)": "abc" is not a number; --skip-bad-rows drops such rows')).toBe(
      'lab.csv:17: Spalte „Position (m)“: „abc“ ist keine Zahl; bitte die Zeile in der Datei ausbessern oder entfernen',
    )
    expect(german('too noisy: the frequency is known to 12.5 % only')).toBe(
      'zu viel Rauschen: die Frequenz ist nur auf 12,5 % bekannt',
    )
    expect(german('"3 parsecs": unknown unit "parsecs"; expected a mass, for instance 217.6 g')).toBe(
      '„3 parsecs“: die Einheit „parsecs“ ist unbekannt; erwartet wird eine Masse, zum Beispiel 217,6 g',
    )
    expect(german('2.gap.csv:3: the time jumps')).toBe('2.gap.csv:3: the time jumps')
  })

  it('puts in no more than it was given', () => {
    const lines = table.split('\n').filter((line) => !line.startsWith('//') && line.includes('⇒') && !line.includes('split('))
    expect(lines.length).toBeGreaterThan(150)
    for (const line of lines) {
      const [words, ours] = line.replace('const lines = `', '').split('⇒')
      const given = words!.match(/\{\}|#/g)?.length ?? 0
      const places = [...ours!.matchAll(/\{(\d?)\}/g)].map(([, place]) => Number(place || 1))
      expect(places.length, line).toBeLessThanOrEqual(given)
      expect(Math.max(0, ...places), line).toBeLessThanOrEqual(given)
    }
  })

  it('leaves what it does not know', () => expect(german('a new message')).toBe('a new message'))
})

// Not reached by the page's questions, which set steps, methods and drives themselves; or of loggers' files too
// rare for the table.
const elsewhere =
  /tasks\/(sweep|spectrum|record|curves|simulate|compare)\/|tasks\/fit\/(options|static_|fit_static|masses|mass_line|force_grid|forced_|fit_forced|plan_recording|decay_segments)|methods\/|forced_|driven_|base\/grid|steady_state|uff|peer|labview|number_stream|column_kind/
const left = new RegExp(
  [
    'interrupted', // the page ends a fit by ending its worker
    '--(spring-mass|monte-carlo|seed|law|delimiter|decimal|force-column)', // no fields of the page
    'J/\\(kg m²', // a unit
    '^cromer simulate', '^zero or more', 'neither true nor false', // no sentences of its own
    'between 1e-', 'lie between 0 and 1', // options without a field
    'no power of ten', 'Fortran', 'too unequal', 'tables of the file', 'tables: ', 'numbers end at', 'names of the columns of set',
    'samples per second, for', 'a number in', // of options whose unit is always named
    // parts of sentences, which the questions below put together
    '^[{]} this recording', '^[{]} A law', '^: [{]} is only', '^[{]} [{]} far', 'from sample to sample[)]$', 'samples apart[)]$', '^noise lifts small peaks', 's[{]}$', '^it must [{]}', '^be positive', '^not be', '^lie between', 'run [{]}$', '^[{]}: the uncert', '^[{]} ± ',
    '^no drive is seen', '^nothing is seen', '^a free law leaves', // of a drive that was named
    'swing.s own', 'a second mode', '--[{]}', // said in one
  ].join('|'),
)

describe.skipIf(!existsSync(path('../../../../src/cromer')))('the messages in the core’s sources', () => {
  const all = coreSources(path('../../../../src/cromer'), elsewhere).flatMap(({ file, text }) =>
    messagesOf(text).map((message) => ({ file, message })),
  )
  const filled = (message: string) => message.replace(/^[:; ]+/, '').replaceAll('{}', '7')

  it('are found', () => {
    expect(all.length).toBeGreaterThan(150)
    const messages = all.map(({ message }) => message)
    expect(messages).toContain('the zero jumps by {} at {} s: choose one side of it with --from and --to')
    expect(messages).toContain('column "{}" has no unit: {} is assumed')
    expect(messages).toContain('{}: {}, the first in line {}')
  })

  it('have their German', () => {
    const missing = all.filter(({ message }) => !left.test(message) && german(filled(message)) === filled(message))
    expect(missing.map(({ file, message }) => `${file}: ${message}`)).toEqual([])
  })
})

const built = path('../../../../build/page/core.wasm.gz')
describe.skipIf(!existsSync(built))('what the core says of bad input, in German', async () => {
  const core = existsSync(built) ? await start(await compile(readFileSync(built))) : undefined!
  /// English words that no German sentence has.
  const english = /\b(the|is|are|not|with|of|it|must|there|for|and)\b/
  const withoutQuotes = (text: string) => text.replace(/"[^"]*"|[„“][^“”]*[“”]/g, '""')

  function said(task: Task, options: Options, file?: string | Uint8Array): string[] {
    const bytes = typeof file === 'string' ? new TextEncoder().encode(file) : file
    const answer = read(core.answer(task, bytes ? [...options, ['file-name', 'lab.csv']] : options, bytes))
    if (answer.status === 2) return [answer.document.message]
    const document = answer.document as { warnings?: string[]; fits?: { message?: string; warnings?: string[] }[] }
    const all = task === 'simulate' ? [] : [...(document.warnings ?? [])] // those are not shown
    for (const fit of document.fits ?? []) all.push(...(fit.message ? [fit.message] : []), ...(fit.warnings ?? []))
    return all
  }
  const speaks = (messages: string[], least = 1) => {
    if (process.env.CROMER_SAY) for (const each of new Set(messages)) console.log(`${each}\n    ${german(each)}`)
    expect(messages.length).toBeGreaterThanOrEqual(least)
    expect(messages.map(german).filter((text) => english.test(withoutQuotes(text)))).toEqual([])
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
