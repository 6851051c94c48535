export type * from '../schema/itemTypes.ts'
export type { Embed } from '../schema/embed.ts'
export { readItem } from '../schema/item.ts'
export { readItemText } from '../schema/itemText.ts'
export { readAlignment, type Alignment } from '../schema/alignment.ts'
export { readReferences, type Reference } from '../schema/references.ts'
export type { Checked } from '../schema/checked.ts'
export { plainOf } from '../schema/markdown.ts'
export { cardWords } from './cardWords.ts'
export { gradeOf } from './readability.ts'
export { nodesOf, wordsOf } from './walk.ts'
export type * from '../schema/planTypes.ts'
export { beginningsOf, planParts, timesOf } from './plan.ts'
export type { FixedPack } from '../schema/packs.ts'
export { partOf, type Part } from './part.ts'
export { passagesOf, scoreOf, search, type Hit, type Passage, type Synonyms } from './search.ts'
export {
  atGrade,
  codeOfAll,
  linesFor,
  printingOf,
  sidesIn,
  timesIn,
  whoGets,
  type PackLine,
  type Printing,
} from './pack.ts'
