import { describe, expect, it } from 'vitest'
import { after, frameOf, momentOf, noLive, plotted, progressOf, type Live, type LiveEvent, type LiveStatus } from '../../src/measure/live'

const status = (more: Partial<LiveStatus> = {}): LiveEvent => ({
  is: 'status',
  data: {
    source: 'tcp:127.0.0.1:1', recording: 'a.csv', running: true, samples: 0, from: 0, to: 0, duration: 0, rate: null,
    columns: ['Time (s)', 'x', 'y'], ...more,
  },
})
const samples = (first: number, t: number[], columns = 2): LiveEvent => ({
  is: 'samples',
  data: { first, t, values: Array.from({ length: columns }, (_, i) => t.map((time) => time + i)) },
})
const run = (...events: LiveEvent[]): Live => events.reduce(after, noLive)

describe('a recording in progress', () => {
  it('keeps the last ten seconds and counts all', () => {
    const t = Array.from({ length: 1501 }, (_, i) => i / 100)
    const live = run(status(), samples(0, t.slice(0, 700)), samples(700, t.slice(700)))
    expect([live.t[0], live.t.at(-1)]).toEqual([5, 15])
    expect(live.values.map((column) => column.length)).toEqual([1001, 1001])
    expect(live.values[1]![0]).toBe(6)
    expect(progressOf(live)).toEqual({ samples: 1501, duration: 15 })
    expect(frameOf(live)).toEqual([5, 15])
  })
  it('counts what the status says where it knows more', () => {
    const live = run(status(), samples(0, [0, 1]), status({ samples: 900, duration: 9 }))
    expect(progressOf(live)).toEqual({ samples: 900, duration: 9 })
  })
  it('begins anew with another recording and with a new connection', () => {
    const before = run(status(), samples(0, [0, 1]), { is: 'notices', data: { notices: [{ kind: 'gap', text: 'a gap', german: 'eine Lücke' }] } })
    const other = after(before, status({ recording: 'a-2.csv' }))
    expect([other.t.length, other.seen, other.notices.length]).toEqual([0, 0, 0])
    const again = [{ is: 'away' } as const, { is: 'open' } as const, status(), samples(0, [0, 1, 2])].reduce(after, before)
    expect([again.away, again.t.length, again.notices.length]).toEqual([false, 3, 0])
  })
  it('begins where it is told from, in a recording that goes on', () => {
    const late = run(status({ samples: 30000, duration: 300 }), { is: 'open' }, samples(29000, [290, 291]), samples(29002, [292]))
    expect([late.t, late.seen]).toEqual([[290, 291, 292], 29003])
    expect(late.values).toEqual([[290, 291, 292], [291, 292, 293]])
  })
  it('leaves nothing of before in front of samples that do not follow', () => {
    const torn = run(status(), samples(0, [0, 1, 2]), samples(500, [5, 6]))
    expect([torn.t, torn.values, torn.seen]).toEqual([[5, 6], [[5, 6], [6, 7]], 502])
  })
  it('counts at its end what is in the file', () => {
    const full = run(status(), samples(0, [0, 1, 2]), status({ running: false, samples: 2, duration: 1 }))
    expect(progressOf(full)).toEqual({ samples: 2, duration: 1 })
  })
  it('does not count what came late of the last one', () => {
    const late = run(status({ running: false }), { is: 'open' }, samples(0, [0, 1, 2]))
    expect(progressOf(after(late, status({ recording: 'a-2.csv' }))).samples).toBe(0)
  })
  it('plots the column that is fitted', () => {
    const live = run(status(), samples(0, [0]))
    expect(plotted(live)).toBe(0)
    expect(plotted(after(live, { is: 'fit', data: { column: 'y', status: 'converged' } }))).toBe(1)
    expect(plotted(after(live, { is: 'fit', data: { column: 'Time (s)', status: 'converged' } }))).toBe(0)
  })
})

describe('a sentence', () => {
  const idle = run(status({ running: false, recording: null }))
  it('is said at the start, at the end, and where a device is lost', () => {
    const going = after(idle, status())
    expect(momentOf(idle, going)).toEqual({ is: 'started' })
    expect(momentOf(going, after(going, status({ samples: 5 })))).toBeNull()
    expect(momentOf(idle, after(idle, status({ recording: 'short.csv', running: false, samples: 3 })))).toEqual({ is: 'ended' })
    expect(momentOf(going, after(going, status({ running: false })))).toEqual({ is: 'ended' })
    const gone: LiveEvent = { is: 'notices', data: { notices: [{ kind: 'connection', text: 'it is gone', german: 'es ist weg' }] } }
    expect(momentOf(going, after(going, gone))).toEqual({ is: 'lost', text: { en: 'it is gone', de: 'es ist weg' } })
    const bad: LiveEvent = { is: 'notices', data: { notices: [{ kind: 'garbage', text: 'line 3', german: 'Zeile 3' }] } }
    expect(momentOf(going, after(going, bad))).toBeNull()
  })
  it('is said once where the server is away, and not where a page finds a recording going on', () => {
    const away = after(idle, { is: 'away' })
    expect(momentOf(idle, away)).toEqual({ is: 'away' })
    expect(momentOf(away, after(away, { is: 'away' }))).toBeNull()
    expect(momentOf(noLive, run(status()))).toBeNull()
  })
})
