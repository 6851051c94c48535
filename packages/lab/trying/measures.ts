import type { Behaviour } from './doings.ts'

/** What a behaviour is judged by. */
const measures = ['cm', 'tiles', 'touching', 'bumps', 'free', 'near', 'line', 'ended'] as const
/**
 * - `cm`: way a minute · `tiles`: squares of 40 cm entered from a start · `touching`: percent of the time
 * - `bumps`, `free`, `near`, `line`: moves a minute in which it touched, came free, was near a thing, came onto black
 * - `ended`: starts from which a bump ended the try
 */
type Measure = (typeof measures)[number]

/** Numbers of a behaviour, rounded to tenths. */
export type Measures = { readonly [name in Measure]: number }

/** A robot cheats where each of these measures lies between these two, both included. */
export type Cheat = { readonly [name in Measure]?: readonly [least: number, most: number] }

export function measuresOf({ facts, tiles, touching, ended }: Behaviour): Measures {
  const { way: cm, bump: bumps, free, near, line } = facts
  const all: Measures = { cm, tiles, touching, bumps, free, near, line, ended }
  return Object.fromEntries(measures.map((name) => [name, tenths(all[name])])) as Measures
}

export const tenths = (value: number): number => Math.round(value * 10) / 10 + 0

/** Does a robot do what a cage is named after? */
export const judged = (cheats: Cheat, measured: Measures): boolean =>
  measures.every((name) => {
    const [least, most] = cheats[name] ?? [-Infinity, Infinity]
    return measured[name] >= least && measured[name] <= most
  })
