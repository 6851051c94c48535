import type { Decay, Settings } from '@botgarten/learning/q-learning'

/** One row of a sweep. Decays are texts, as a call and a table have them. */
export interface Setting {
  readonly alpha: number
  readonly gamma: number
  readonly nu: number
  readonly rho: number
  readonly alphaDecay?: string
  readonly rhoDecay?: string
}

/** The values to be combined; '' among the decays: none. */
export interface Lists {
  readonly alpha: readonly number[]
  readonly gamma: readonly number[]
  readonly nu: readonly number[]
  readonly rho: readonly number[]
  readonly alphaDecay?: readonly string[]
  readonly rhoDecay?: readonly string[]
}

/** All combinations; the last list turns fastest. */
export function settingsOf({ alpha, gamma, nu, rho, alphaDecay = [''], rhoDecay = [''] }: Lists): Setting[] {
  const texts = (name: 'alphaDecay' | 'rhoDecay', values: readonly string[]) =>
    values.map((value) => (value === '' ? {} : { [name]: value }))
  return combined([
    ...[named('alpha', alpha), named('gamma', gamma), named('nu', nu), named('rho', rho)],
    ...[texts('alphaDecay', alphaDecay), texts('rhoDecay', rhoDecay)],
  ]) as Setting[]
}

const named = (name: string, values: readonly number[]) => values.map((value) => ({ [name]: value }))

const combined = (lists: readonly (readonly object[])[]): object[] =>
  lists.reduce<object[]>((all, list) => all.flatMap((one) => list.map((more) => ({ ...one, ...more }))), [{}])

/** A setting's own name: streams hang on it, so that more settings change no run of another. */
export const nameOf = (setting: Setting): string => JSON.stringify(setting)

/** `0.999`: times so much after every episode; `visits`: times 10 / (9 + n) at the n-th update; nothing: as it is. */
export function decayOf(text: string | undefined): Decay {
  if (text === undefined) return { kind: 'constant' }
  return text === 'visits' ? { kind: 'visits' } : { kind: 'episodes', factor: Number(text) }
}

export const learnerSettings = (
  { alpha, gamma, nu, rho, alphaDecay, rhoDecay }: Setting,
  { rules, algorithm }: Pick<Settings, 'rules' | 'algorithm'>,
): Settings => ({
  ...{ rules, algorithm, alpha, gamma, nu, rho },
  alphaDecay: decayOf(alphaDecay),
  rhoDecay: decayOf(rhoDecay),
})
