import type { Chance } from './types.ts'

/** A list in random order (Fisher and Yates). */
export function shuffled<Thing>(list: readonly Thing[], chance: Chance): Thing[] {
  const mixed = [...list]
  for (let at = mixed.length - 1; at > 0; at -= 1) {
    const other = Math.floor(chance() * (at + 1))
    ;[mixed[at], mixed[other]] = [mixed[other]!, mixed[at]!]
  }
  return mixed
}
