import { writeNumber } from '@botgarten/messages'
/** Whole minutes until a moment, the last one counted; 0 where it is over or there is none. */
export const minutesLeft = (until: number | null, now: number): number =>
  until === null || until <= now ? 0 : Math.ceil((until - now) / 60_000)

/** Milliseconds as seconds with the digits that count: 0.04, 1.3, 12. */
export function secondsLabel(ms: number, locale: string): string {
  const digits = ms < 1000 ? 2 : ms < 10_000 ? 1 : 0
  return writeNumber(ms / 1000, locale, { least: digits, most: digits })
}
