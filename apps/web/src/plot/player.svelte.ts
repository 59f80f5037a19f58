// A cursor's time, and how it runs.
import { looks } from '../state/looks.svelte'

export class Player {
  t = $state(0)
  on = $state(!looks.plain)
  slow = $state(1)

  /// `until` [s]: the end, from which it begins anew; `period` [s]: of what is seen.
  constructor(private until: () => number, private period: () => number) {}

  /// Simulated seconds a second: true to life, but that a period lasts between half a second and ten; and as slow as asked.
  pace(): number {
    const lasts = this.period()
    return this.slow * (lasts < 0.5 ? lasts / 0.5 : lasts > 10 ? lasts / 10 : 1)
  }
  set(t: number): void {
    this.t = Math.max(0, Math.min(this.until(), t))
  }
  /// Set by hand: it then stands.
  hold(t: number): void {
    this.on = false
    this.set(t)
  }
  /// From the start, running: what is let go.
  release(): void {
    this.set(0)
    this.on = true
  }
  /// Runs while it is on; call in an effect.
  run(): (() => void) | undefined {
    if (!this.on) return undefined
    let before = performance.now()
    let frame = requestAnimationFrame(function next(this: Player, now: number) {
      const passed = Math.min(0.1, Math.max(0, (now - before) / 1000))
      before = now
      const t = this.t + passed * this.pace()
      this.t = t > this.until() ? 0 : t
      frame = requestAnimationFrame(next.bind(this))
    }.bind(this))
    return () => cancelAnimationFrame(frame)
  }
}
