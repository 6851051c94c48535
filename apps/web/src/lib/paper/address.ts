import { getContext, setContext } from 'svelte'
import { resolve } from '$app/paths'
import { addressOf } from '#lib/materials/addresses.ts'

const key = Symbol('paper')

interface OnPaper {
  /** Where the lab lives, with a slash at its end; null: nobody said it, so nothing leads there. */
  readonly address: string | null
}

export const givePaper = (paper: OnPaper): OnPaper => setContext(key, paper)

/** Where the lab is open now. */
export const here = (): string => new URL(resolve('/'), location.href).href

const labAddress = () => (getContext<OnPaper | undefined>(key) ?? { address: here() }).address

/** Gives the whole address of `card:<id>` or `item:<id>`; null where nobody said where the lab lives. */
export function takeAddresses(): (to: string) => string | null {
  const lab = labAddress()
  const below = (to: string) => addressOf(to).slice(resolve('/').length)
  return (to) => (lab === null ? null : new URL(below(to), lab).href)
}
