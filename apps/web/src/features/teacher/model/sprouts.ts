/** A sprout in a bed: where it stands, how large it is, and the colours of its two leaves. */
interface Sprout {
  readonly x: number
  readonly scale: number
  readonly left: string
  readonly right: string
}

const scales = [0.86, 1.02, 1.16, 0.9, 1.06, 0.84, 1, 1.14]
const leaves = [
  ['#7CC257', '#9AD56B'],
  ['#5B9A62', '#7CC257'],
  ['#9AD56B', '#B6E084'],
] as const
const [left, right] = [92, 1274]

/** So many sprouts, evenly in the bed; a new one never changes what the others look like. */
export const sproutsFor = (count: number): readonly Sprout[] =>
  Array.from({ length: Math.min(count, 60) }, (_, at) => ({
    x: count === 1 ? (left + right) / 2 : left + ((right - left) * at) / (count - 1),
    scale: scales[at % scales.length]! * Math.min(1, 26 / count + 0.25),
    left: leaves[at % leaves.length]![0],
    right: leaves[at % leaves.length]![1],
  }))
