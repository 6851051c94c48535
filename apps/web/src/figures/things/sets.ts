import content from 'content:sets'
import type { ThingSet } from '@botgarten/content/things'

/** Every set of things of the content. */
export const { sets, pictureOf } = content

export const setOf = (id: string): ThingSet => sets.find((set) => set.id === id) ?? sets[0]!
