import { isSaid, say } from '#lib/words/say.ts'
import type { Project } from '@botgarten/programs'
import { placeOf } from './cards.ts'

/** What a card or the free lab is called, in the language of now; null where nobody has named it. */
export const nameOf = (place: string): string | null =>
  isSaid(`home.${place}`) ? say(`home.${place}`) : null

/** A project that nobody has named bears its card's id, and is called like its card. */
export function shownName({ project }: { readonly project: Project }): string {
  const place = placeOf(project)
  return ((project.name === place || project.name === 'free') && nameOf(place)) || project.name
}
