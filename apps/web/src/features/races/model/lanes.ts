import type { Lane, Racer } from '@botgarten/experiments/race'

/** Choices for each setting of a learner; the values are those of the blocks. */
export const choices = {
  alpha: [
    { value: 0.1, word: 'slowly' },
    { value: 0.5, word: 'medium' },
    { value: 0.9, word: 'fast' },
  ],
  gamma: [
    { value: 0.2, word: 'aLittle' },
    { value: 0.8, word: 'aLot' },
    { value: 1, word: 'all' },
  ],
  rho: [
    { value: 0.9, word: 'rarely' },
    { value: 0.5, word: 'sometimes' },
    { value: 0.1, word: 'often' },
  ],
  nu: [
    { value: 0, word: 'never' },
    { value: 0.1, word: 'rarely' },
    { value: 0.9, word: 'often' },
  ],
} as const
export type Setting = keyof typeof choices

/** Settings of a kind of learner: one that always explores, or never does, has no choice of how much. */
export const settingsOf = (racer: Racer): readonly Setting[] =>
  racer === 'q' || racer === 'sarsa' ? ['rho', 'alpha', 'gamma', 'nu'] : ['alpha', 'gamma', 'nu']

const usual = { alpha: 0.5, gamma: 0.8, nu: 0, rho: 0.1 }
export const laneOf = (racer: Racer): Lane => ({ racer, ...usual })

/** Colour and shape of each lane: they differ in both, for users who do not see the colours. */
export const looks = [
  { colour: '#1F67B3', mark: 'M0 -9a9 9 0 1 0 .01 0z' },
  { colour: '#C2335F', mark: 'M0 -10L10 8H-10z' },
  { colour: '#5B7A12', mark: 'M-8 -8H8V8H-8z' },
  { colour: '#8C6A00', mark: 'M0 -11L11 0 0 11 -11 0z' },
  { colour: '#6F55C4', mark: 'M0 10L-10 -8H10z' },
  { colour: '#B25A00', mark: 'M-3.5 -10h7v6.5h6.5v7h-6.5v6.5h-7v-6.5h-6.5v-7h6.5z' },
  { colour: '#0B7C88', mark: 'M-5 -9H5L10 0 5 9H-5L-10 0z' },
  { colour: '#3A2A20', mark: 'M0 -11l3 7.5 8 .5-6 5 2 8-7-4.5-7 4.5 2-8-6-5 8-.5z' },
] as const
