import type { Block } from '@botgarten/blocks'
import type { Answers } from './answers/index.ts'
import type { CageRows, SenseCage } from '@botgarten/experiments/cages'
import type { Cage } from '@botgarten/maps/zoo'
import type { Project } from '@botgarten/programs'
import type { Alignment } from './schema/alignment.ts'
import type { CageText } from './schema/cageText.ts'
import type { Card, CardProgram, CardText, Playground, WorldFile } from './schema/cardTypes.ts'
import type { FixedPack } from './schema/packs.ts'
import type { LoadedForm } from './schema/form.ts'
import type { Item, ItemText } from './schema/itemTypes.ts'
import type { Question, QuestionText } from './schema/questionTypes.ts'
import type { Reference } from './schema/references.ts'
import type { SenseCageText } from './schema/senseCageText.ts'
import type { ThingSet } from './schema/thingTypes.ts'

/** By language, as in `content/words`. */
export type Translated<Text> = { readonly [language: string]: Text }

/** What is known of a card without opening it: this travels with every page. */
export interface CardHead extends Pick<Card, 'id' | 'code' | 'group' | 'chapter' | 'grades' | 'minutes'> {
  /** Where it lies on the home page: the folder above its own. */
  readonly bed: Playground
  /** Number of its start poses. */
  readonly starts: number
  /** The asset that its floor lies on, where it lies on one. */
  readonly floor?: string
  /** The first line of its texts. */
  readonly title: Translated<string>
}

/** A card with all that the lab shows and runs. */
export interface LoadedCard {
  readonly card: Card
  readonly bed: Playground
  readonly world: WorldFile
  readonly start: CardProgram
  readonly text: Translated<CardText>
  /** Pictures of a card that somebody has made; cards of the house have none of their own. */
  readonly assets?: Project['assets']
}

export interface Cards {
  readonly cards: readonly CardHead[]
  /** Null where no card has this id. */
  readonly card: (id: string) => LoadedCard | null
  /** The sentence that says what a card is about, by its id. */
  readonly goals: () => { readonly [card: string]: Translated<string> | undefined }
  /** What a lab without a card begins with. */
  readonly freeLab: () => { readonly world: WorldFile; readonly start: CardProgram }
}

export interface Programs {
  /** A card's `start`, `solution` or `wrong/<name>`; null where it has none. A page has those that an item shows. */
  readonly program: (card: string, file: string) => CardProgram | null
  /** The blocks that stand on the front of each card, by its id. */
  readonly newBlocks: () => { readonly [card: string]: readonly Block[] | undefined }
}

export interface Worlds {
  readonly worlds: readonly string[]
  readonly world: (id: string) => WorldFile | null
}

export interface Maps {
  readonly maps: readonly string[]
  /** How many stations each map has. */
  readonly stations: { readonly [map: string]: number }
  /** Where a way begins and ends on each map. */
  readonly ends: { readonly [map: string]: readonly [start: number, goal: number] }
  /** Those that have roads and no rooms. */
  readonly drawn: readonly string[]
  /** The drawing of a map, as SVG. */
  readonly map: (id: string) => string | null
}

export interface Sets {
  /** Sets of things to sort. */
  readonly sets: readonly ThingSet[]
}

/** A cage with its words. */
export interface LoadedCage {
  readonly cage: Cage
  readonly text: Translated<CageText>
}

export interface Zoo {
  /** Rewards that cheat. */
  readonly cages: readonly LoadedCage[]
}

/** A cage in which Bo tries with its own sensors, with what was measured of it and its words. */
export interface LoadedSenseCage {
  readonly cage: SenseCage
  readonly rows: CageRows
  readonly text: Translated<SenseCageText>
}

export interface SenseZoo {
  /** Pays that Bo cheats with its sensors. */
  readonly senseCages: readonly LoadedSenseCage[]
}

/** A question about what Bo will do, with what is asked and what can be chosen. */
export interface AskedQuestion {
  readonly question: Question
  readonly text: Translated<Pick<QuestionText, 'question' | 'choices'>>
}

export interface Questionnaires {
  readonly forms: readonly LoadedForm[]
}

/** An item and the number of its folder, among those of its kind. */
export type NumberedItem = Item & { readonly number: number }

/** Learning materials. */
export interface Items {
  readonly items: readonly NumberedItem[]
  readonly questions: readonly Question[]
  readonly packs: readonly FixedPack[]
  /** The words of all items by `kind/id`, and of all questions by id. */
  readonly itemTexts: (language: string) => ItemTexts
  readonly alignment: () => Alignment
  /** What answers say in numbers. */
  readonly answers: () => Answers
  readonly references: () => readonly Reference[]
}

export interface ItemTexts {
  readonly items: { readonly [item: string]: ItemText | undefined }
  readonly questions: { readonly [id: string]: QuestionText | undefined }
  /** Words for the same thing, in groups. */
  readonly synonyms: readonly (readonly string[])[]
}

/**
 * What there is in content/, every list in the order of its folders. Files are read at once, a page loads what it asks
 * for: `Lazy`.
 */
export interface Catalogue extends Cards, Programs, Worlds, Maps, Sets, Zoo, SenseZoo, Items, Questionnaires {
  /** Folders of words. */
  readonly languages: readonly string[]
}

/** The same part of the catalogue on a page: lists are there, what is opened comes by a promise. */
export type Lazy<Part> = {
  readonly [Name in keyof Part]: Part[Name] extends (...args: infer Args) => infer Result
    ? (...args: Args) => Promise<Result>
    : Part[Name]
}
