// The page's own address: what it wrote there last. Anything else there was opened by somebody and is still to be read.
let written = location.hash

export const isOpened = (): boolean => location.hash !== written

/** The link that was opened, and that is known from here on. */
export const takeOpened = (): string => (written = location.hash)

/** A link that was opened and is still to be read is left as it is. */
export function write(address: string): void {
  if (isOpened()) return
  history.replaceState(null, '', address)
  written = location.hash
}
