export type * from './types.ts'
export { readCard } from './card.ts'
export { cardDocument, cardProject, worldAt } from './cardDocument.ts'
export { readCardText } from './cardText.ts'
