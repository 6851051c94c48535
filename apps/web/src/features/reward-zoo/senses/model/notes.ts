import type { SenseGuess } from '@botgarten/content/sense-cage'
import { readSetting, writeSetting } from '#storage/settings.ts'

/** What a child has done in a cage, on this device. */
interface Noted {
  readonly guess: SenseGuess
  readonly watched: boolean
  readonly mended: boolean
}
type Notes = { readonly [cage: string]: Noted | undefined }

const notes = (): Notes => readSetting<Notes>('zoo-senses', {})

export const notedOf = (cage: string): Noted | null => notes()[cage] ?? null

export const noteCage = (cage: string, noted: Noted): void =>
  writeSetting('zoo-senses', { ...notes(), [cage]: noted })

export const mendedCages = (): number => Object.values(notes()).filter((one) => one?.mended).length
