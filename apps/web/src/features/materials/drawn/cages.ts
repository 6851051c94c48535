import zoo from 'content:zoo'
import { readMap } from '@botgarten/maps'
import { isMended, settingsOf, type Cage } from '@botgarten/maps/zoo'
import { writeNumber } from '@botgarten/messages'
import { language } from '#words/language.svelte.ts'

/** The settings at which the wish of a cage comes true, by value iteration. */
export async function goodSettings(cage: Cage): Promise<readonly number[]> {
  const { map } = readMap(await zoo.map(cage.id))
  if (!map) throw new Error(`The map of the cage "${cage.id}" cannot be read.`)
  return settingsOf(cage.mend).filter((setting) => isMended(cage, map, setting))
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

/** `+20: each time at the fountain · +50: at the school` */
export const paidIn = ({ pay }: Cage, words: readonly string[]): string =>
  pay.map(({ reward }, index) => `${signed(reward)}: ${words[index]}`).join(' · ')

const signed = (reward: number) => writeNumber(reward, language.locale, { plus: true })
