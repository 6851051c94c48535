import { replaceState } from '$app/navigation'
import { resolve } from '$app/paths'
import { placeOf } from '#content/cards.ts'
import type { Opened } from '#lab/opening.ts'

/** What could not be read here stays where it is: the new start has an address of its own from now on. */
export function leaveBroken({ id, project, damaged }: Opened): void {
  if (damaged)
    void replaceState(resolve(`/lab/[card]?p=${encodeURIComponent(id)}`, { card: placeOf(project) }), {})
}
