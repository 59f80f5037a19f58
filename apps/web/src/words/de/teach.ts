import type { teach as en } from '../en/teach'

export const teach: typeof en = {
  soon: 'Diese Seite gibt es noch nicht.',
}
