// The cursor's time of this page, and how it runs.
import { Player } from '../plot/player.svelte'
import { page } from '../state/page.svelte'
import { period } from './law'
import { latest } from './results.svelte'

export const play = new Player(() => page.simulate.until, () => period(latest().linear))

export const pace = (): number => play.pace()
export const setCursor = (t: number): void => play.set(t)
export const holdCursor = (t: number): void => play.hold(t)
export const run = (): (() => void) | undefined => play.run()

/** A tenth of a period on. */
export function stepCursor(): void {
  holdCursor(play.t + period(latest().linear) / 10)
}
