// A recording in progress, as the events of `cromer serve` tell it: docs/recording.md. Pure: no request is made here.
import type { Estimate } from '../core/types'
import type { Said } from '../words/said'

/// What GET /api/status answers, and each `status` event.
export interface LiveStatus {
  source: string | null // null: nothing to record from
  recording: string | null
  running: boolean
  samples: number
  from: number // [s]
  to: number // [s]
  duration: number // [s]
  rate: number | null // [1/s]
  for?: number | null // [s] length of this recording, or of the next where none is given; null: until stopped
  times?: LiveTimes | null // null: nothing came
  columns: string[] // that of the times first
  message?: string
  message_german?: string
}

/// Where the times came from; the numbers are of samples without times of their own.
export interface LiveTimes {
  by: 'device' | 'count' | 'rate' | 'arrival'
  rate?: number | null // [1/s] that was found
  longest_delay?: number // [s]
}

export interface LiveSamples {
  first: number // index of the first row, counted from the recording's begin
  t: number[] // [s]
  values: number[][] // a list for each column
}

export interface LiveNotice {
  kind: string
  text: string
  german: string
}

export interface LiveFit {
  column: string
  status: string
  law?: string
  coefficients?: string[] // the law's own of the parameters
  parameters?: Record<string, Estimate>
  derived?: Record<string, Estimate>
  message?: string
  message_german?: string
}

export type LiveEvent =
  | { is: 'open' } // connected, maybe again: the recording's last seconds are told, and all its notices
  | { is: 'away' } // the server does not answer
  | { is: 'status'; data: LiveStatus }
  | { is: 'samples'; data: LiveSamples }
  | { is: 'notices'; data: { notices: LiveNotice[] } }
  | { is: 'fit'; data: LiveFit }

export interface Live {
  status: LiveStatus | null
  away: boolean
  t: number[] // the last seconds
  values: number[][]
  seen: number // index of the next row
  notices: LiveNotice[]
  fit: LiveFit | null
}

const nothing = { t: [], values: [], seen: 0, notices: [], fit: null }
export const noLive: Live = { status: null, away: false, ...nothing }

/// How much is kept to be plotted [s].
export const shownSeconds = 10
const mostRows = 20_000

/// The state after `event`. Another recording, a new connection, or samples that do not follow the last ones
/// begin anew: of each recording the server tells the status first.
export function after(live: Live, event: LiveEvent): Live {
  switch (event.is) {
    case 'open':
      return { ...live, away: false, ...nothing }
    case 'away':
      return { ...live, away: true }
    case 'status': {
      const other = event.data.recording !== live.status?.recording
      return { ...live, ...(other ? nothing : {}), away: false, status: event.data }
    }
    case 'samples':
      return withSamples(event.data.first === live.seen ? live : { ...live, t: [], values: [] }, event.data)
    case 'notices':
      return { ...live, notices: [...live.notices, ...event.data.notices] }
    case 'fit':
      return { ...live, fit: event.data }
  }
}

function withSamples(live: Live, { first, t, values }: LiveSamples): Live {
  const times = [...live.t, ...t]
  const end = times.at(-1) ?? 0
  const within = times.findIndex((time) => time >= end - shownSeconds)
  const cut = Math.max(within, times.length - mostRows, 0)
  const columns = values.map((column, i) => [...(live.values[i] ?? []), ...column].slice(cut))
  return { ...live, t: times.slice(cut), values: columns, seen: first + t.length }
}

/// Samples and their duration [s]: samples come ten times a second, a status once. At the end only the status
/// counts: a disk that is full does not hold all that was told.
export function progressOf({ status, seen, t }: Live): { samples: number; duration: number } {
  const newest = t.at(-1)
  if (!status || !status.running || seen <= status.samples || newest === undefined)
    return { samples: status?.samples ?? 0, duration: status?.duration ?? 0 }
  return { samples: seen, duration: Math.max(status.duration, newest - status.from) }
}

/// Which list of values is plotted: that of the fit, else the first.
export function plotted({ status, fit, values }: Live): number {
  const found = (status?.columns.indexOf(fit?.column ?? '') ?? -1) - 1
  return found >= 0 && found < values.length ? found : 0
}

/// The time axis: the last seconds, and a full frame from the begin on.
export function frameOf({ t }: Live): [number, number] {
  const end = t.at(-1) ?? 0
  const begin = t.length && end - t[0]! >= 0.95 * shownSeconds ? end - shownSeconds : (t[0] ?? 0)
  return [begin, begin + shownSeconds]
}

/// A notice in both languages.
export const saidOf = ({ text, german }: LiveNotice): Said => ({ en: text, de: german })

/// Of a status or a fit; '' where there is none.
export const messageOf = (of: { message?: string; message_german?: string } | null): Said =>
  of?.message ? { en: of.message, de: of.message_german ?? of.message } : ''

export type Moment = { is: 'started' | 'ended' | 'away' } | { is: 'lost'; text: Said }

/// What is worth a sentence between two states: start, end, a device or server that is gone or back.
export function momentOf(before: Live, now: Live): Moment | null {
  const [was, is] = [before.status?.running ?? false, now.status?.running ?? false]
  if (now.away !== before.away && now.away) return { is: 'away' }
  if (before.status && is && (!was || before.status.recording !== now.status!.recording)) return { is: 'started' }
  // A short one may be over before it is first told of.
  const other = before.status !== null && before.status.recording !== now.status?.recording
  if ((was || other) && !is) return { is: 'ended' }
  const fresh = now.notices.slice(before.notices.length).filter(({ kind }) => kind === 'connection' || kind === 'device')
  return fresh.length ? { is: 'lost', text: saidOf(fresh.at(-1)!) } : null
}
