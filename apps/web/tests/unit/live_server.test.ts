import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { listen } from '../../src/measure/live_server'

/// Stands in for the browser's.
class Source extends EventTarget {
  static readonly CLOSED = 2
  static all: Source[] = []
  readyState = 0
  onopen = () => {}
  onerror = () => {}
  constructor(readonly url: string) {
    super()
    Source.all.push(this)
  }
  close() {
    this.readyState = Source.CLOSED
  }
  fail(readyState: number) {
    this.readyState = readyState
    this.onerror()
  }
}

describe('a listener', () => {
  const told: string[] = []
  beforeEach(() => {
    Source.all = []
    told.length = 0
    vi.useFakeTimers()
    vi.stubGlobal('EventSource', Source)
  })
  afterEach(() => {
    vi.useRealTimers()
    vi.unstubAllGlobals()
  })
  const begin = () => listen(({ is }) => told.push(is))

  it('asks again after a refusal, until it is heard', () => {
    begin()
    for (let i = 1; i <= 2; ++i) {
      Source.all.at(-1)!.fail(Source.CLOSED)
      expect(Source.all.length).toBe(i)
      vi.advanceTimersByTime(10_000)
      expect(Source.all.length).toBe(i + 1)
    }
    Source.all.at(-1)!.onopen()
    Source.all.at(-1)!.dispatchEvent(new MessageEvent('status', { data: '{}' }))
    vi.advanceTimersByTime(100_000)
    expect(Source.all.length).toBe(3)
    expect(told).toEqual(['away', 'away', 'open', 'status'])
  })
  it('leaves a lost connection to the browser', () => {
    begin()
    Source.all[0]!.fail(0)
    vi.advanceTimersByTime(100_000)
    expect([Source.all.length, told]).toEqual([1, ['away']])
  })
  it('is quiet once it is told to end', () => {
    const end = begin()
    Source.all[0]!.fail(Source.CLOSED)
    end()
    vi.advanceTimersByTime(100_000)
    expect(Source.all.length).toBe(1)
    expect(Source.all[0]!.readyState).toBe(Source.CLOSED)
  })
})
