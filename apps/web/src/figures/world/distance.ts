import { formatNumber } from '#drawing/numbers.ts'
import { language } from '#words/language.svelte.ts'
import { m } from '#words/message.ts'

/** A length in cm as a child reads it: whole centimetres, from a metre on in tenths of a metre. */
export function distance(cm: number): string {
  if (Math.round(cm) < 100) return m['world.centimetres']({ length: Math.round(cm) })
  return m['world.metres']({ length: formatNumber(cm / 100, language.locale, 1) })
}
