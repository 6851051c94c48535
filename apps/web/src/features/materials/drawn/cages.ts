import zoo from 'content:zoo'
import { readMap } from '@botgarten/maps'
import { isMended, provedOf, settingsOf, untouched, type Cage } from '@botgarten/maps/zoo'

/** What value iteration says of a cage: what Bo does, and the settings at which its wish comes true. */
export interface Proved {
  readonly outcomes: ReturnType<typeof provedOf>
  readonly settings: readonly number[]
}

export async function provedIn(cage: Cage): Promise<Proved> {
  const { map } = readMap(await zoo.map(cage.id))
  if (!map) throw new Error(`The map of the cage "${cage.id}" cannot be read.`)
  const settings = settingsOf(cage.mend).filter((setting) => isMended(cage, map, setting))
  return { outcomes: provedOf(cage, map, untouched(cage)), settings }
}

/** Good settings as a teacher reads them: `1–17`, or the words of the options. */
export const mendedAt = (
  { mend }: Cage,
  settings: readonly number[],
  options: { readonly [id: string]: string },
): string =>
  'options' in mend
    ? settings.map((index) => options[mend.options[index]!.id]).join(' ')
    : `${settings[0]}–${settings.at(-1)}`

/** `20 ★ each time at the fountain · 50 ★ at the school` */
export const paidIn = ({ pay }: Cage, words: readonly string[]): string =>
  pay.map(({ stars }, index) => `${String(stars).replace('-', '−')} ★ ${words[index]}`).join(' · ')
