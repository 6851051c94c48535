import { writeNumber } from '@botgarten/messages'

/** Ticks as seconds with exactly so many digits behind the comma: a number that runs keeps its width. */
export const inSeconds = (ticks: number, locale: string, digits: number): string =>
  writeNumber(ticks / 60, locale, { least: digits, most: digits })
