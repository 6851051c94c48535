import type { Chance } from '@botgarten/answers'

/** Chance that nobody can foretell. */
export const chanceOf =
  (random: (bytes: number) => Uint8Array): Chance =>
  () =>
    Buffer.from(random(4)).readUInt32BE() / 0x1_0000_0000
