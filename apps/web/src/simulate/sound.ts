// A motion to be heard: its positions played so fast that its own frequency is a tone of 220 Hz.
import type { States } from '../core/types'
import { valueAtX } from '../plot/decimate'

const tone = 220 // [Hz]
const rate = 22050 // [1/s]
const longest = 8 // [s]

/** Samples between −1 and 1. `period` [s] of the motion. */
export function soundOf(states: Pick<States, 't' | 'x'>, period: number): Float32Array<ArrayBuffer> {
  const { t, x } = states
  const pace = tone * period // motion's seconds a second
  const end = t.at(-1) ?? 0
  const count = Math.floor(Math.min(longest, end / pace) * rate)
  let largest = 0
  for (const value of x) if (Math.abs(value) > largest) largest = Math.abs(value)
  const samples = new Float32Array(count)
  const fade = Math.min(400, count / 4)
  for (let i = 0; i < count; ++i) {
    const loud = Math.min(1, i / fade, (count - 1 - i) / fade)
    samples[i] = largest > 0 ? (0.5 * loud * (valueAtX(t, x, (i / rate) * pace) || 0)) / largest : 0
  }
  return samples
}

let playing: AudioBufferSourceNode | null = null

export function stopSound(): void {
  playing?.stop()
  playing = null
}

/** Plays once; what was playing ends. `done`: when it has ended. */
export function playSound(samples: Float32Array<ArrayBuffer>, done: () => void): void {
  stopSound()
  if (samples.length === 0) return done()
  const context = new AudioContext()
  const buffer = context.createBuffer(1, samples.length, rate)
  buffer.copyToChannel(samples, 0)
  const source = new AudioBufferSourceNode(context, { buffer })
  source.connect(context.destination)
  source.addEventListener('ended', () => {
    void context.close()
    if (playing === source) playing = null
    done()
  })
  playing = source
  source.start()
}
