export const simulate = {
  oscillator: 'Oscillator',
}
