import type { measure as en } from '../en/measure'

export const measure: typeof en = {
  soon: 'Diese Seite gibt es noch nicht.',
}
