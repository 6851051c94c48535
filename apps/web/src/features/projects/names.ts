import type { Project } from '@botgarten/programs'
import { placeOf } from '#content/cards.ts'
import { shownName, titleOf } from '#content/names.ts'

/** The name of a project of which nothing else can be read; null if even that is missing. */
export const damagedName = (name: string | null, raw: unknown): string | null =>
  name === null ? null : shownName({ project: { name, ...placedIn(raw) } })

/** Where a project belongs of which nothing else can be read. */
export function placedIn(raw: unknown): Pick<Project, 'card' | 'playground'> {
  const { card, playground } = (raw ?? {}) as { readonly card?: unknown; readonly playground?: unknown }
  return { card: String(card), ...(playground === 'sorting' && { playground }) }
}

/** The name of the card a project belongs to, in the current language; null without a card. */
export const cardName = (project: Pick<Project, 'card' | 'playground'>): string | null =>
  project.card !== undefined && project.card === placeOf(project) ? titleOf(project.card) : null
