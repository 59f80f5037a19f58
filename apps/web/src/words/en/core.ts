/// What the core and the server say is English already.
export const core = (text: string): string => text
