import type { Embed } from './embed.ts'
import type { Claim, Plan } from './planTypes.ts'

/** `item.json` of a folder `content/materials/<kind>/<nn-id>/`: what is the same in every language. */
export interface Item {
  readonly id: string
  readonly kind: ItemKind
  /** What it is called on paper, in plans and in packs: `3.1`, `P 3`, `K 5`. */
  readonly code?: string
  /** Who reads it. What teachers read is not held to a grade's readability. */
  readonly audience: 'pupils' | 'teachers'
  /** Youngest and oldest grade. */
  readonly grades: readonly [number, number]
  readonly minutes: number
  readonly way: 'supervised' | 'unsupervised' | 'reinforcement' | 'all'
  readonly social: 'alone' | 'pairs' | 'groups' | 'class'
  /** 1 to 4; 0: before, after or across all of them. */
  readonly module: number
  readonly paper: Paper
  /** Pages it takes, where that is more than its `::page` say, by language or in each: a test prints and counts. */
  readonly sides?: number | { readonly [language: string]: number }
  /** Ids in `content/materials/alignment.json`. */
  readonly competences: readonly string[]
  /** Does it need a screen? */
  readonly unplugged: boolean
  /**
   * Grades of the reading levels beside the middle one, whose text lies in the folder itself: `a` (3 to 4) and
   * `c` (10 to 12), each in a folder of its own. Every level is an item: `3.1b` is `my-knobs`, `3.1a` is `my-knobs-a`.
   */
  readonly levels?: { readonly [level in Level]?: readonly [number, number] }
  /** A text that is harder than its youngest grade, by language, and why it has to be. */
  readonly harder?: { readonly [language: string]: { readonly upTo: number; readonly reason: string } }
  /** Of answers: what Bo does as they say; the contract test runs it. */
  readonly claims?: readonly Claim[]
  /** Of a lesson plan. */
  readonly plan?: Plan
}

export type Level = 'a' | 'c'

export type ItemKind =
  | 'curriculum'
  | 'plan'
  | 'slides'
  | 'card'
  | 'observation'
  | 'sheet'
  | 'kit'
  | 'worksheet'
  | 'observer'
  | 'checklist'
  | 'solution'
  | 'links'

export type Paper = 'a4' | 'a5' | '16:9'

/** An item in one language: `# Title`, what stands before the first `##`, then a section (a slide) for every `##`. */
export interface ItemText {
  readonly title: string
  readonly lead: ItemMarkdown
  readonly sections: readonly Section[]
}

export interface Section {
  readonly title: string
  readonly body: ItemMarkdown
  /** What only the teacher sees: all that follows `### Notes` (named so in every language); empty where there is none. */
  readonly notes: ItemMarkdown
}

export type ItemMarkdown = readonly ItemNode[]

/** What an item may hold, as a syntax tree (shapes of mdast where it has them). */
export type ItemNode =
  | { readonly type: 'text'; readonly value: string }
  | {
      readonly type: 'paragraph' | 'strong' | 'emphasis' | 'listItem' | 'blockquote'
      readonly children: ItemMarkdown
    }
  | { readonly type: 'heading'; readonly depth: number; readonly children: ItemMarkdown }
  | { readonly type: 'list'; readonly ordered: boolean; readonly children: ItemMarkdown }
  /** `item:<id>`, `card:<id>` or an https address. */
  | { readonly type: 'link'; readonly href: string; readonly children: ItemMarkdown }
  /** A file beside the text. */
  | { readonly type: 'image'; readonly file: string; readonly alt: string }
  /** Cells hold words; an empty cell is there to be written into. */
  | { readonly type: 'table'; readonly head: readonly ItemMarkdown[]; readonly rows: readonly Row[] }
  | { readonly type: 'embed'; readonly embed: Embed }

export type Row = readonly ItemMarkdown[]
