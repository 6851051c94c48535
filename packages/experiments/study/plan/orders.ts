import { draw, stream } from '@botgarten/numbers'

/** How the order of modules comes about. `fixed`: as they stand · `random`: drawn for each group · `balanced`: in blocks. */
export const orderings = ['fixed', 'random', 'balanced'] as const
export type Ordering = (typeof orderings)[number]

/**
 * A Williams square over 0 to n − 1: in its rows every number stands at every place equally often, and comes equally often right
 * after every other one. n rows where n is even, else 2n. (E. J. Williams, Experimental designs balanced for the estimation of
 * residual effects of treatments, 1949.)
 */
export function williams(n: number): readonly (readonly number[])[] {
  const first = Array.from({ length: n }, (_, at) => (at % 2 === 0 ? n - at / 2 : (at + 1) / 2) % n)
  const square = first.map((_, row) => first.map((one) => (one + row) % n))
  return n % 2 === 0 || n === 1 ? square : [...square, ...square.map((row) => row.toReversed())]
}

/**
 * The order of modules of a group: equal for all in it. Balanced: groups come in blocks in which every row of a Williams square
 * stands once, shuffled by the seed.
 * @param group from 1
 */
export function orderOf<Module>(
  modules: readonly Module[],
  ordering: Ordering,
  seed: number,
  group: number,
): readonly Module[] {
  if (ordering === 'fixed') return modules
  if (ordering === 'random') return shuffled(modules, seed, `order/group/${group}`)
  const rows = williams(modules.length)
  const block = Math.floor((group - 1) / rows.length)
  const row = shuffled(rows, seed, `order/block/${block}`)[(group - 1) % rows.length]!
  return row.map((at) => modules[at]!)
}

/** A list in an order of chance (Fisher and Yates), always the same for a seed and a name. */
function shuffled<Thing>(list: readonly Thing[], seed: number, name: string): readonly Thing[] {
  const chance = stream(seed, name)
  const mixed = [...list]
  for (let at = mixed.length - 1; at > 0; at -= 1) {
    const other = Math.floor(draw(chance) * (at + 1))
    ;[mixed[at], mixed[other]] = [mixed[other]!, mixed[at]!]
  }
  return mixed
}
