export const teach = {
  soon: 'This page is not there yet.',
}
