/** Whole minutes until a moment, the last one counted; 0 where it is over or there is none. */
export const minutesLeft = (until: number | null, now: number): number =>
  until === null || until <= now ? 0 : Math.ceil((until - now) / 60_000)
