/** Above this limit (s) the tries end first: what is left of it says nothing. */
const MOST_LEFT = 1000

/** The clock of a learning: what is left of a short limit, else what has passed. A move is a second. */
export const timeShown = (
  limit: number,
  moves: number,
): { key: 'timeLeft' | 'timePassed'; seconds: number } =>
  limit > MOST_LEFT
    ? { key: 'timePassed', seconds: moves }
    : { key: 'timeLeft', seconds: Math.max(0, limit - moves) }
