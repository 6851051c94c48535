import type { Outcome } from '@botgarten/maps/zoo'
import { readSetting, writeSetting } from '#storage/settings.ts'

/** What a child has done in a cage, on this device. */
interface Noted {
  readonly guess: Outcome
  readonly mended: boolean
}
type Notes = { readonly [cage: string]: Noted | undefined }

const notes = (): Notes => readSetting<Notes>('zoo', {})

export const notedOf = (cage: string): Noted | null => notes()[cage] ?? null

export const noteCage = (cage: string, noted: Noted): void =>
  writeSetting('zoo', { ...notes(), [cage]: noted })
