// The cursor's time, and how it runs.
import { looks } from '../state/looks.svelte'
import { page } from '../state/page.svelte'
import { period } from './law'
import { latest } from './results.svelte'

export const play = $state({ t: 0, on: !looks.plain, slow: 1 })

/** Simulated seconds a second: true to life, but that a period lasts between half a second and ten; and as slow as asked. */
export function pace(): number {
  const lasts = period(latest().linear)
  return play.slow * (lasts < 0.5 ? lasts / 0.5 : lasts > 10 ? lasts / 10 : 1)
}

export function setCursor(t: number): void {
  play.t = Math.max(0, Math.min(page.simulate.until, t))
}

/** Cursor set by hand: it then stands. */
export function holdCursor(t: number): void {
  play.on = false
  setCursor(t)
}

/** A tenth of a period on. */
export function stepCursor(): void {
  holdCursor(play.t + period(latest().linear) / 10)
}

/** Runs while `play.on`; call in an effect. */
export function run(): (() => void) | undefined {
  if (!play.on) return undefined
  let before = performance.now()
  let frame = requestAnimationFrame(function next(now) {
    const passed = Math.min(0.1, Math.max(0, (now - before) / 1000))
    before = now
    const t = play.t + passed * pace()
    play.t = t > page.simulate.until ? 0 : t
    frame = requestAnimationFrame(next)
  })
  return () => cancelAnimationFrame(frame)
}
