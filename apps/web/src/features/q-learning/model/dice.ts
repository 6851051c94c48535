/** Highest seed that a device throws: five digits can be read aloud. */
const HIGHEST = 99_999

/** A seed of this device's own, 1 to 99,999. `random`: 32 random bits. */
export const throwSeed = (random = crypto.getRandomValues(new Uint32Array(1))[0]!): number =>
  1 + (random % HIGHEST)

/** The seed that an address pins (`?dice=7`); null where it pins none. */
export function pinnedSeed(search: string): number | null {
  const text = new URLSearchParams(search).get('dice') ?? ''
  const seed = /^\d{1,9}$/.test(text) ? Number(text) : 0
  return seed > 0 ? seed : null
}

/** The address at which another device learns with this seed. */
export const seedLink = ({ origin, pathname }: Pick<Location, 'origin' | 'pathname'>, seed: number) =>
  `${origin}${pathname}?dice=${seed}`
