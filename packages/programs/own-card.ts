import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Pose } from '@botgarten/simulation'
import type { Program } from './types.ts'

/** A card that somebody has made, in the project whose world and program it is about. */
export interface OwnCard {
  /** By language; one at least. */
  readonly text: { readonly [language in CardLanguage]?: OwnCardText }
  /** From each of these places it has to be solved. */
  readonly starts: readonly Pose[]
  readonly checks: readonly OwnCheck[]
  /** Youngest and oldest grade. */
  readonly grades: readonly [number, number]
  readonly minutes: number
  /** Families of blocks that are offered, from the plain toolbox or from all of it; not given: every one. */
  readonly blocks: { readonly level: 'plain' | 'all'; readonly families?: readonly Family[] }
  /** It is being made: nobody plays it yet, and what is missing may be missing. */
  readonly draft?: true
  /** With what a child begins, while it is made; later that is the project's own program. */
  readonly start?: OwnProgram
  /** How it is solved, for colleagues. While it is made that is the project's own program. */
  readonly solution?: OwnProgram
  /** Typical wrong answers, which the checks refuse. */
  readonly wrong?: readonly WrongAnswer[]
}

export const cardLanguages = ['de', 'en'] as const
export type CardLanguage = (typeof cardLanguages)[number]

/** Plain text; an empty line begins a paragraph. */
export interface OwnCardText {
  readonly title: string
  readonly story: string
  /** What Bo should do, in one sentence. */
  readonly task: string
  readonly hints: readonly [string, string, string]
}

/** As in `card.json`: what is asked of each kind stands in `ownKinds`. */
export interface OwnCheck {
  readonly id: string
  readonly kind: string
  readonly numbers: { readonly [name: string]: number | string }
  readonly seconds: number
}

export interface OwnProgram {
  readonly programs: { readonly [id: string]: Program }
  readonly brains: { readonly [networkId: string]: Brain }
}

export interface WrongAnswer extends OwnProgram {
  readonly name: string
}

/** Families of blocks, as the toolbox has them. */
export const families = [
  'control',
  'action',
  'sensors',
  'logic',
  'math',
  'text',
  'lists',
  'variables',
  'functions',
  'messages',
  'network',
  'q-learning',
  'sorting',
] as const
export type Family = (typeof families)[number]

/** Limits of a card; letters of its texts as they fit on A5. */
export const mostOfCard = {
  ...{ title: 40, story: 420, task: 140, hint: 240 },
  ...{ starts: 8, checks: 5, wrong: 8, name: 40, points: 12, seconds: 120, minutes: 90, grade: 13 },
} as const

/**
 * What a number of a check may be: a range, a thing of the world by its id, one of the colours that a sensor tells apart,
 * several of them, a light, another check of the card (or none), a place on one axis, or places ("x y, x y").
 */
export type Asked =
  | readonly [least: number, most: number]
  | 'thing'
  | 'colour'
  | 'colours'
  | 'lamp'
  | 'check'
  | 'x'
  | 'y'
  | 'points'

/** A kind of check that somebody can choose. `lasts`: how long it has to hold is asked, in seconds. */
interface OwnKind {
  readonly asks: { readonly [name: string]: Asked }
  readonly lasts: boolean
}

const percent = [0, 100] as const
const cm = [1, 400] as const
const standing = [1, 30] as const

/** Kinds of checks about what Bo does; those about maps and examples belong to cards of their own. */
export const ownKinds: { readonly [kind: string]: OwnKind } = {
  near: { asks: { obstacle: 'thing', cm }, lasts: false },
  stays: { asks: { obstacle: 'thing', cm, percent: standing }, lasts: true },
  neverTouches: { asks: { obstacle: 'thing', until: 'check' }, lasts: true },
  turnsAway: { asks: { obstacle: 'thing', near: cm, far: cm }, lasts: true },
  arrives: { asks: { x: 'x', y: 'y', cm, after: 'check' }, lasts: true },
  visits: { asks: { points: 'points', cm }, lasts: false },
  laps: { asks: { gates: 'points', cm, laps: [1, 10] }, lasts: false },
  cruises: { asks: { cm: [1, 3000], bumps: [0, 20] }, lasts: true },
  led: { asks: { colour: 'colour', lamp: 'lamp' }, lasts: true },
  speedOn: { asks: { colour: 'colour', least: percent, most: percent }, lasts: true },
  neverSees: { asks: { colour: 'colour', until: 'check' }, lasts: true },
  says: { asks: { colour: 'colour', others: 'colours' }, lasts: true },
  silent: { asks: { colour: 'colour' }, lasts: true },
  rests: { asks: { light: [1, 100], percent: standing }, lasts: true },
  turnsBack: { asks: { near: cm, far: cm }, lasts: false },
  sings: { asks: { near: cm, far: cm, hertz: [10, 2000] }, lasts: false },
}

/** Colours that a sensor tells apart. */
export const cardColours = [
  '#000000',
  '#0057A6',
  '#00642E',
  '#F7D117',
  '#B30006',
  '#FFFFFF',
  '#532115',
] as const

/** '' is dark. */
export const cardLamps = ['green', 'orange', 'red', ''] as const

/** Text that a browser could take for a tag. */
export const looksLikeTag = (text: string): boolean => /<\s*[a-z/!?]/i.test(text)

/** What keeps a card from being played, part by part; the first is said. */
export type CardLack = 'words' | 'hints' | 'checks'

const filled = (text: string) => text.trim() !== ''

/** Languages in which all words are there. */
export const languagesOf = ({ text }: Pick<OwnCard, 'text'>): readonly CardLanguage[] =>
  cardLanguages.filter((language) => {
    const words = text[language]
    return words && [words.title, words.story, words.task, ...words.hints].every(filled)
  })

/** What a card lacks before anybody can play it; null: nothing. */
export function lackOf(card: Pick<OwnCard, 'text' | 'checks'>): CardLack | null {
  const begun = cardLanguages.flatMap((language) => card.text[language] ?? [])
  const worded = begun.some(({ title, story, task }) => [title, story, task].every(filled))
  if (!worded) return 'words'
  if (languagesOf(card).length === 0) return 'hints'
  return card.checks.length === 0 ? 'checks' : null
}
