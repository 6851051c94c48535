import type { Item, ItemText, Level } from '../schema/itemTypes.ts'
import type { Copies, Plan } from '../schema/planTypes.ts'
import { timesOf } from './plan.ts'

/** A line of what is printed together: how often for a class, or `times`, where somebody said how often. */
export interface PackLine extends Copies {
  readonly times?: number | undefined
}

export const timesIn = (line: PackLine, children: number): number => line.times ?? timesOf(line, children)

/** What a lesson needs, in the order in which it lies on the desk: what is only for the teacher's eyes comes last. */
export const linesFor = ({ copies }: Plan, isAnswers: (of: string) => boolean): readonly PackLine[] => [
  ...copies.filter(({ of }) => !isAnswers(of)),
  ...copies.filter(({ of }) => isAnswers(of)),
]

/** The grades that reading levels are written for: `a` to 4, the middle one, `c` from 10 on. */
const levelFor = (grade: number): Level | null => (grade <= 4 ? 'a' : grade >= 10 ? 'c' : null)

/** Of an item with reading levels the id of the one for a grade; the item's own id where it has no other for it. */
export function atGrade({ id, levels }: Pick<Item, 'id' | 'levels'>, grade: number | null): string {
  const level = grade === null ? null : levelFor(grade)
  return level !== null && levels?.[level] ? `${id}-${level}` : id
}

/** How an item is called where all its reading levels are meant: `2.1`, not `2.1b`. */
export const codeOfAll = ({ code, levels }: Pick<Item, 'code' | 'levels'>): string | undefined =>
  levels ? code?.slice(0, -1) : code

/** For whom an item is printed where no plan says it. */
export function whoGets({
  audience,
  social,
  kind,
}: Pick<Item, 'audience' | 'social' | 'kind'>): Copies['for'] {
  if (audience === 'teachers' || kind === 'slides' || social === 'class') return 'teacher'
  return social === 'alone' ? 'child' : social === 'pairs' ? 'pair' : 4
}

/** Pages that an item takes on paper: as it says, where its text flows over more than `::page` parts. */
export const sidesIn = (
  { sides }: Pick<Item, 'sides'>,
  { lead, sections }: ItemText,
  language: string,
): number => {
  const nodes = [...lead, ...sections.flatMap(({ body }) => body)]
  const said = typeof sides === 'object' ? sides[language] : sides
  return said ?? 1 + nodes.filter((node) => node.type === 'embed' && node.embed.kind === 'page').length
}

/** How something is printed so and so often. */
export interface Printing {
  /** Pages in the file: of A4, or of A5 alone. */
  readonly pages: number
  /** How often these pages are printed. */
  readonly prints: number
  /** Sheets of A4 that are used up. */
  readonly sheets: number
}

/**
 * Pages of something with so many sides, and how often they are printed for so many copies. Of a single card two lie on a
 * sheet of A4; a set of cards is printed as often as it is needed, and where its cards are odd in number the last one
 * lies there twice. Slides are small pictures, their `sides` pages full of them.
 */
export function printingOf(paper: Item['paper'], sides: number, times: number, twoOnSheet = true): Printing {
  const sheetsOnce = Math.ceil(sides / 2)
  if (paper !== 'a5') return { pages: sides, prints: times, sheets: times * sheetsOnce }
  if (!twoOnSheet) return { pages: sides, prints: times, sheets: Math.ceil((times * sheetsOnce) / 2) }
  if (sides <= 2) {
    const prints = Math.ceil(times / 2)
    return { pages: sides, prints, sheets: prints }
  }
  const sheets = Math.ceil(sheetsOnce / 2)
  return { pages: 2 * sheets, prints: times, sheets: times * sheets }
}
