/** Pale, gold, green: #FFF6D8 → #F5C64A → #6DBE76 (visual.md 2). Always with its number. */
const colours = [
  [255, 246, 216],
  [245, 198, 74],
  [109, 190, 118],
] as const

/** Colour of a share 0..1 of the highest value. */
export function heat(share: number): string {
  const x = Math.min(1, Math.max(0, share)) * 2
  const at = Math.min(1, Math.floor(x))
  const [from, to] = [colours[at]!, colours[at + 1]!]
  return `rgb(${from.map((one, k) => Math.round(one + (to[k]! - one) * (x - at))).join(' ')})`
}
