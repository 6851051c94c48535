import programs from 'content:programs'
import { loadCard, type LoadedCard } from '#content/cards.ts'
import type { CardProgram } from '@botgarten/content'
import { learningIn, type LearningOutline } from '@botgarten/programs'

export interface ShownProgram {
  readonly card: LoadedCard
  readonly program: CardProgram
}

/** A card with one of its programs: `start`, `solution`, `wrong/<name>`. @throws Error for what no item names */
export async function programOf(id: string, file: string): Promise<ShownProgram> {
  const [card, shown] = await Promise.all([
    loadCard(id),
    file === 'start' ? null : programs.program(id, file),
  ])
  const program = file === 'start' ? card?.start : shown
  if (!card || !program) throw new Error(`There is no "${file}" of "${id}".`)
  return { card, program }
}

/** What one of a card's programs lets Bo learn by trying; nothing where it does not. */
export async function learningOf(id: string, file: string): Promise<LearningOutline | undefined> {
  const { program } = await programOf(id, file)
  return Object.values(program.programs).flatMap((one) => learningIn(one) ?? [])[0]
}
