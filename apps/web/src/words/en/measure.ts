export const measure = {
  soon: 'This page is not there yet.',
}
