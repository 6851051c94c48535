import { resolve } from '$app/paths'
import type { Project } from '@botgarten/programs'
import { placeOf } from './cards.ts'
import { titleOf } from './names.ts'

interface Placed {
  readonly id: string
  readonly project: Pick<Project, 'card'>
}

/** The name of the card a project belongs to, in the language of now; null in the free lab. */
export function cardName({ project }: Pick<Placed, 'project'>): string | null {
  const place = placeOf(project)
  return place === 'free' ? null : titleOf(place)
}

/** Where a project is opened; one under its card's own name is what the card's address opens. */
export function addressOf({ id, project }: Placed): string {
  const card = placeOf(project)
  return id === card
    ? resolve('/lab/[card]', { card })
    : resolve(`/lab/[card]?p=${encodeURIComponent(id)}`, { card })
}
