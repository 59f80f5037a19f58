// Two hundred simulations, the same ones every time: every method on every kind of law, with steps from fine
// to beyond what is stable.

const methods = [
  'forward-euler',
  'euler-cromer',
  'implicit-euler',
  'verlet',
  'newmark',
  'implicit-midpoint',
  'generalized-alpha',
  'heun',
  'rk4',
  'yoshida4',
  'gauss-legendre4',
  'dormand-prince',
  'exact',
]

/// Numbers from 0 to 1 (Lehmer's generator, W. H. Payne et al., 1969).
function random(seed) {
  let state = seed
  return () => (state = (state * 48271) % 2147483647) / 2147483647
}

export function simulations() {
  const next = random(6)
  const between = (low, high) => low + (high - low) * next()
  const some = (low, high) => Number((low * (high / low) ** next()).toPrecision(4))

  const laws = {
    undamped: () => ({ stiffness: some(1, 100) }),
    damped: () => ({ stiffness: some(1, 100), damping: some(0.001, 1) }),
    overdamped: () => ({ stiffness: some(1, 20), damping: some(20, 60) }),
    massless_spring: () => ({ stiffness: 0, damping: some(0.1, 2), velocity: some(0.1, 2) }),
    cubic: () => ({ stiffness: some(1, 50), cubic: some(1, 200), position: some(0.1, 2) }),
    softening: () => ({
      stiffness: some(5, 50),
      cubic: -some(0.01, 1),
      damping: some(0.01, 0.3),
      position: 0.5,
    }),
    double_well: () => ({
      stiffness: -some(1, 5),
      cubic: some(1, 20),
      damping: some(0.01, 0.5),
      position: 0.3,
    }),
    repelling: () => ({ stiffness: -some(0.1, 2), position: 0.01 }),
    drag: () => ({ stiffness: some(1, 100), drag: some(0.001, 1), position: some(0.1, 2) }),
    all_smooth: () => ({
      stiffness: some(1, 100),
      damping: some(0.01, 1),
      drag: some(0.01, 1),
      cubic: some(0.1, 50),
    }),
    friction: () => ({ stiffness: some(5, 100), friction: some(0.01, 1) }),
    sticking: () => ({
      stiffness: some(5, 100),
      damping: some(0.01, 1),
      friction: 0.3,
      'static-friction': some(0.3, 2),
    }),
    rubbing: () => ({
      stiffness: some(5, 100),
      friction: some(0.01, 0.3),
      drag: some(0.01, 1),
      cubic: some(0.1, 10),
    }),
    driven: () => ({
      stiffness: some(1, 100),
      damping: some(0.01, 2),
      'drive-amplitude': some(0.1, 10),
      'drive-frequency': some(0.5, 20),
      'drive-phase': some(0.1, 3),
    }),
    resonant: () => ({ stiffness: 16, 'drive-amplitude': 1, 'drive-frequency': 4, position: 0.2 }),
    duffing: () => ({
      stiffness: some(1, 20),
      cubic: some(0.1, 10),
      damping: some(0.1, 1),
      'drive-amplitude': some(0.1, 3),
      'drive-frequency': some(1, 6),
    }),
    driven_friction: () => ({
      stiffness: some(5, 50),
      friction: some(0.01, 0.5),
      damping: some(0.01, 1),
      'drive-amplitude': some(0.5, 3),
      'drive-frequency': some(1, 8),
    }),
    base: () => ({
      stiffness: some(5, 50),
      damping: some(0.1, 1),
      drive: 'base',
      'base-displacement': 0.02,
      'drive-frequency': some(1, 8),
    }),
    unbalance: () => ({
      stiffness: some(5, 50),
      damping: some(0.1, 1),
      drive: 'unbalance',
      'unbalance-mass': 0.05,
      eccentricity: 0.1,
      'drive-frequency': some(1, 8),
    }),
  }

  /// Only + - * / and square roots: the same bits are due. A sine, a power or an exponential may differ by its
  /// last digit from one mathematical library to another.
  const arithmetic = (law, method) =>
    method !== 'exact' && method !== 'dormand-prince' && !('drive-frequency' in law)
  const closed_form = (law) =>
    !law.drag && !law.cubic && !(law.friction && ('drive-frequency' in law || 'static-friction' in law))

  const names = Object.keys(laws)
  const cases = []
  for (let i = 0; cases.length < 200; ++i) {
    const name = names[i % names.length]
    const method = methods[(i + Math.floor(i / names.length)) % methods.length]
    const law = { mass: some(0.1, 3), ...laws[name]() }
    if (method === 'exact' && !closed_form(law)) continue
    // Mostly 1/20 to 1/300 of the period; one in six is too long for the explicit methods.
    const period = (2 * Math.PI) / Math.sqrt(Math.abs(law.stiffness) / law.mass || 1)
    const per_period = i % 6 === 5 ? between(1.5, 3.2) : between(20, 300)
    const step = Number((period / per_period).toPrecision(5))
    const steps = Math.round(between(200, 1500)) + (i % 4 === 3 ? 0.4 : 0)
    cases.push({
      name: `${i} ${name} by ${method}`,
      exactly: arithmetic(law, method),
      options: Object.entries({ ...law, method, step, until: Number((steps * step).toPrecision(12)) }).map(
        ([option, value]) => [option, String(value)],
      ),
    })
  }
  return cases
}
