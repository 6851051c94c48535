import { goto } from '$app/navigation'
import { resolve } from '$app/paths'
import { houseIdOf } from '#content/cards.ts'
import { ownCards } from '#features/own-cards/feature.ts'
import { loadPart } from '#parts/feature.ts'
import type { LabScreenState } from './screen.svelte.ts'

/** Goes on with the card that is being made of this project, or begins one: the project stays as it is. */
export async function makeCard({ session, card, title, named, ui }: LabScreenState): Promise<void> {
  await session.autosave.flush()
  const isDraft = session.project.ownCard?.draft === true
  const like = houseIdOf(card) === null ? undefined : card?.card
  const id = isDraft ? session.autosave.id : await (await loadPart(ownCards)).beginCard(named, title, like)
  if (id === null) ui.announce('problem.notKept.title', 'problem.notKept.text')
  else await goto(resolve(`/cards?p=${encodeURIComponent(id)}`))
}
