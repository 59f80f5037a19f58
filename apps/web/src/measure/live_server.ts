// The server that gave this page, where it is one that records: `cromer serve --from`. Opened from disk there is
// none, and nothing is asked.
import type { Said } from '../words/said'
import { messageOf, type LiveEvent, type LiveStatus } from './live'

const served = () => location.protocol === 'http:' || location.protocol === 'https:'

/// What can be recorded from; null where nothing can, or no such server is there.
export async function statusOfServer(): Promise<LiveStatus | null> {
  if (!served()) return null
  try {
    const answer = await fetch('/api/status')
    if (!answer.ok || !answer.headers.get('content-type')?.startsWith('application/json')) return null
    const status = (await answer.json()) as LiveStatus
    return typeof status.source === 'string' ? status : null
  } catch {
    return null
  }
}

const pause = 3000 // [ms]

/// Tells what happens until the returned function is called. A lost connection is tried again by the browser, one that
/// the server refuses (too many listeners, another token) here, after a pause.
export function listen(tell: (event: LiveEvent) => void): () => void {
  let events: EventSource
  let again: ReturnType<typeof setTimeout> | undefined
  const connect = () => {
    events = new EventSource('/api/events')
    events.onopen = () => tell({ is: 'open' })
    events.onerror = () => {
      tell({ is: 'away' })
      if (events.readyState === EventSource.CLOSED) again = setTimeout(connect, pause)
    }
    for (const is of ['status', 'samples', 'notices', 'fit'] as const)
      events.addEventListener(is, (event) => tell({ is, data: JSON.parse(event.data as string) } as LiveEvent))
  }
  connect()
  return () => {
    clearTimeout(again)
    events.close()
  }
}

/// Starts, for so many seconds or as long as the server was told, or stops. The status then; where it was refused,
/// the server's message.
export async function order(what: 'record' | 'stop', seconds: number | null = null): Promise<LiveStatus | { refused: Said }> {
  const wish = seconds === null ? {} : { body: JSON.stringify({ for: seconds }), headers: { 'content-type': 'application/json' } }
  const answer = await fetch(`/api/${what}`, { method: 'POST', ...wish })
  const said = (await answer.json()) as LiveStatus
  return answer.ok ? said : { refused: messageOf(said) || String(answer.status) }
}

/// A finished recording, as it is in its file. Throws where it cannot be had.
export async function recordingNamed(name: string): Promise<Uint8Array> {
  const answer = await fetch(`/api/recordings/${encodeURIComponent(name)}`)
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`)
  return new Uint8Array(await answer.arrayBuffer())
}
