import type { LoadedCard } from '#content/cards.ts'
import { load, open, save } from '#storage/projects.ts'
import { cardProject } from '@botgarten/content/document'
import type { Progress } from '@botgarten/programs'

const none: Progress = { starts: [], hints: 0 }

/** How far this device has come with a card in the lab: from where it was solved, and how many hints were asked for. */
export const progressOf = async (card: string): Promise<Progress> =>
  (await open(card))?.project.progress ?? none

/**
 * Notes that so many hints of a card are seen: in the project that the lab opens for it. Where the device keeps nothing, or
 * another tab saves at this very moment, the hint is seen all the same.
 */
export async function noteHint({ card, world, start }: LoadedCard, shown: number): Promise<Progress> {
  const kept = await open(card.id)
  // What is damaged stays as it is.
  if (!kept && (await load(card.id))) return { starts: [], hints: shown }
  const project = kept?.project ?? cardProject(world, card, start, card.id)
  const before = project.progress ?? none
  const progress = { ...before, hints: Math.max(before.hints, shown) }
  await save(card.id, { ...project, progress }, kept?.revision ?? 0)
  return progress
}
