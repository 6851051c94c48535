/** The twelve pictures of a pupil's secret, as they stand on the screen; their names and drawings are the page's. */
export const pictures = [
  'tree',
  'cup',
  'boat',
  'star',
  'house',
  'fish',
  'leaf',
  'key',
  'sun',
  'ball',
  'flag',
  'moon',
] as const

export type Picture = (typeof pictures)[number]
export type Secret = readonly [Picture, Picture, Picture]

/** Three different pictures in an order: one of 1,320. */
export function newSecret(random: (bytes: number) => Uint8Array): Secret {
  const left = [...pictures]
  const take = () => left.splice(below(left.length, random), 1)[0]!
  return [take(), take(), take()]
}

/** A whole number from 0 on, all equally likely: bytes of the last, incomplete round are drawn again. */
function below(count: number, random: (bytes: number) => Uint8Array): number {
  const whole = 256 - (256 % count)
  let byte = random(1)[0]!
  while (byte >= whole) byte = random(1)[0]!
  return byte % count
}
