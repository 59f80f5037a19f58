// The recording that the server of this page makes, and what is ordered of it. It goes on whichever tab is shown.
import { readQuantity } from '../core/quantity'
import { say } from '../state/notices.svelte'
import type { Said } from '../words/said'
import { told, words } from '../words/words.svelte'
import { after, momentOf, noLive, progressOf, type Live, type LiveEvent } from './live'
import { listen, order, recordingNamed, statusOfServer } from './live_server'
import { openFile } from './session.svelte'

class LiveRecording {
  live: Live = $state.raw(noLive)
  /// Under way to the server.
  ordering = $state(false)
  /// What was ordered to start and is not told of yet.
  awaited: string | null = $state(null)
  trouble: Said = $state.raw('')
  length = $state('') // as typed; nothing: as long as the server was told
  badLength = $state('')

  running = $derived(this.live.status?.running ?? false)
  name = $derived(this.live.status?.recording ?? '')
}

export const recording = new LiveRecording()

const w = () => words().measure.live
/// Started or stopped here: its file is opened here at its end.
let mine = false
let listening = false

/// Asks for the server once; where there is one its recording is told from then on.
export async function followServer(): Promise<void> {
  if (listening) return
  listening = true
  const status = await statusOfServer()
  if (!status) return
  tell({ is: 'status', data: status })
  listen(tell)
}

function tell(event: LiveEvent): void {
  const before = recording.live
  recording.live = after(before, event)
  if (recording.live.away || recording.name === recording.awaited) recording.awaited = null
  const moment = momentOf(before, recording.live)
  if (moment?.is === 'started') say(w().started(recording.name))
  else if (moment?.is === 'away') say(w().away)
  else if (moment?.is === 'lost') say(told(moment.text))
  else if (moment?.is === 'ended') {
    say(w().ended(recording.name, progressOf(recording.live).samples))
    if (mine && !recording.ordering) void openRecording() // a stop ordered here is answered once the file is whole
  }
}

/// The length typed [s], null for none; undefined where it is bad, which is said beside it.
async function lengthTyped(): Promise<number | null | undefined> {
  recording.badLength = ''
  const text = recording.length.trim()
  if (!text) return null
  const read = await readQuantity('until', text)
  if ('value' in read && read.value > 0) return read.value
  recording.badLength = 'message' in read && read.message ? told(read.message) : w().badLength
  return undefined
}

/// False where the length is bad.
export async function startOrStop(): Promise<boolean> {
  const what = recording.running ? 'stop' : 'record'
  recording.ordering = true
  recording.trouble = ''
  try {
    const seconds = what === 'record' ? await lengthTyped() : null
    if (seconds === undefined) return false
    const answer = await order(what, seconds)
    if ('refused' in answer) {
      recording.trouble = answer.refused
      return true
    }
    mine = true
    // The start is taken from the events alone: samples of the last recording may still be under way.
    if (what === 'record') {
      if (recording.name !== answer.recording) recording.awaited = answer.recording
      else if (!recording.running) await openRecording() // it is over already
    } else {
      tell({ is: 'status', data: answer })
      await openRecording()
    }
  } catch {
    recording.trouble = w().away
  } finally {
    recording.ordering = false
  }
  return true
}

export async function openRecording(): Promise<void> {
  mine = false
  const { name } = recording
  if (!name || progressOf(recording.live).samples === 0) return
  try {
    await openFile({ name, bytes: await recordingNamed(name), origin: 'file' })
  } catch {
    recording.trouble = w().notHad(name)
  }
}
