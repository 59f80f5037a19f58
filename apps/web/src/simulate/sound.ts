// A motion to be heard: the pitch follows the position, an octave up and down from 330 Hz, as fast as it is played.
import type { States } from '../core/types'
import { valueAtX } from '../plot/decimate'

const middle = 330 // [Hz] at rest
const rate = 22050 // [1/s]
const longest = 8 // [s]

/** Samples between −1 and 1. `pace`: seconds of the motion in a second. */
export function soundOf({ t, x }: Pick<States, 't' | 'x'>, pace: number): Float32Array<ArrayBuffer> {
  const count = Math.floor(Math.min(longest, (t.at(-1) ?? 0) / pace) * rate)
  let largest = 0
  for (const value of x) if (Math.abs(value) > largest) largest = Math.abs(value)
  const samples = new Float32Array(count)
  const fade = Math.min(400, count / 4)
  for (let i = 0, phase = 0; i < count; ++i) {
    const height = largest > 0 ? (valueAtX(t, x, (i / rate) * pace) || 0) / largest : 0
    phase += (2 * Math.PI * middle * 2 ** height) / rate
    samples[i] = 0.3 * Math.min(1, i / fade, (count - 1 - i) / fade) * Math.sin(phase)
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
