// The names of styles' scopes stand hundreds of times in the page: five letters instead of thirteen.
const scopes = new Map()

function cssHash({ hash, css }) {
  const name = `s${hash(css).slice(0, 4)}`
  if ((scopes.get(name) ?? css) !== css) throw new Error(`two styles have the scope ${name}: take more letters`)
  scopes.set(name, css)
  return name
}

export default { compilerOptions: { discloseVersion: false, cssHash } }
