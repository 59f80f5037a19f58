// The address that the page wrote last. Any other address is a link that somebody opened, and the page has still to read it.
let written = location.hash

export const isOpened = (): boolean => location.hash !== written

/** The link that was opened. From here on it counts as read. */
export const takeOpened = (): string => (written = location.hash)

/** Writes the address, unless a link was opened that the page has still to read. */
export function write(address: string): void {
  if (isOpened()) return
  history.replaceState(null, '', address)
  written = location.hash
}
