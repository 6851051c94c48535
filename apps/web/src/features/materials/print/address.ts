import { getContext, setContext } from 'svelte'
import { resolve } from '$app/paths'
import { addressOf } from '../addresses.ts'

const key = Symbol('paper')

interface OnPaper {
  /** Where the lab lives, with a slash at its end; null: nobody said it, so nothing leads there. */
  readonly address: string | null
}

export const givePaper = (paper: OnPaper): OnPaper => setContext(key, paper)

/** Where the lab is open now. */
export const here = (): string => new URL(resolve('/'), location.href).href

const paperHere = () => getContext<OnPaper | undefined>(key)

/** Gives the whole address of `card:<id>` or `item:<id>`; null where nobody said where the lab lives. */
export function takeAddresses(): (to: string) => string | null {
  const { address: lab } = paperHere() ?? { address: here() }
  const below = (to: string) => addressOf(to).slice(resolve('/').length)
  return (to) => (lab === null ? null : new URL(below(to), lab).href)
}

/** Gives the address of a link of a text: within the lab on the screen, whole on paper; null where paper has none. */
export function takeLinks(): (to: string) => string | null {
  if (!paperHere()) return addressOf
  const whole = takeAddresses()
  return (to) => (/^(card|item):/.test(to) ? whole(to) : to)
}
