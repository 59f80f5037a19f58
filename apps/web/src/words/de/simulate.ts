import type { simulate as en } from '../en/simulate'

export const simulate: typeof en = {
  oscillator: 'Schwinger',
}
