import type { methods as en } from '../en/methods'

export const methods: typeof en = {
  exact: 'exakt',
  'forward-euler': 'Euler vorwärts',
  'euler-cromer': 'Euler-Cromer',
  'implicit-euler': 'Euler implizit',
  verlet: 'Verlet',
  rk4: 'RK4',
  heun: 'Heun',
  yoshida4: 'Yoshida 4',
  'implicit-midpoint': 'implizite Mittelpunktregel',
  newmark: 'Newmark',
  'generalized-alpha': 'generalized-α',
  'gauss-legendre4': 'Gauß-Legendre 4',
  'dormand-prince': 'Dormand-Prince',
}
