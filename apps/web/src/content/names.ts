import { isSaid, say } from '#words/say.ts'
import type { Project } from '@botgarten/programs'
import { placeOf } from './cards.ts'

/** What a card or the free lab is called, in the language of now; null where nobody has named it. */
export const nameOf = (place: string): string | null =>
  isSaid(`home.${place}`) ? say(`home.${place}`) : null

/** A project that nobody has named bears its card's id, and is called like its card. */
export function shownName({ project }: { readonly project: Pick<Project, 'name' | 'card'> }): string {
  const place = placeOf(project)
  return ((project.name === place || project.name === 'free') && nameOf(place)) || project.name
}

/** The same for a project of which nothing else can be read; null where even that is missing. */
export function damagedName(name: string | null, raw: unknown): string | null {
  if (name === null) return null
  const card = (raw as { readonly card?: unknown } | null)?.card
  return shownName({ project: { name, card: String(card) } })
}
