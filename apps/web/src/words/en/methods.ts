// The methods as sentences name them. The order is that of the page's list.
export const methods: Record<string, string> = {
  exact: 'exact',
  'forward-euler': 'forward Euler',
  'euler-cromer': 'Euler-Cromer',
  'implicit-euler': 'implicit Euler',
  verlet: 'Verlet',
  rk4: 'RK4',
  heun: 'Heun',
  yoshida4: 'Yoshida 4',
  'implicit-midpoint': 'implicit midpoint',
  newmark: 'Newmark',
  'generalized-alpha': 'generalized-α',
  'gauss-legendre4': 'Gauss-Legendre 4',
  'dormand-prince': 'Dormand-Prince',
}
