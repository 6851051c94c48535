import { starterChoice, type PracticeChoice } from '@botgarten/learning/neural-network/examples'

/** What practice begins with where nobody has chosen and the card says nothing. */
const explorer: PracticeChoice = {
  ...starterChoice,
  settings: { ...starterChoice.settings, rate: 0.03, momentum: 0.9, batch: 16, keepBack: 0.2 },
}

export const presets = { starter: starterChoice, explorer, expert: explorer }

/** What can be chosen. Steps of 1 run away, which is there to be found out. */
export const rates = [0.01, 0.03, 0.1, 0.3, 1] as const
export const roundChoices = [60, 200, 1000] as const
export const batches = [1, 4, 16, 64] as const
export const momenta = [0, 0.5, 0.9] as const
export const decays = [0, 0.0001, 0.001, 0.01] as const
/** Rounds a second. */
export const paces = [1, 10, 60, Infinity] as const
