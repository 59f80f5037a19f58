/// [m^2/s] The kinematic viscosity of air at 20 °C, as the core has it: what the text tells, and what answers by hand are held to.
export const airViscosity = 1.506e-5
