import { resolve } from '$app/paths'
import { loadedFrom } from '#content/own-card.ts'
import type { LoadedCard } from '#content/cards.ts'
import { packs } from '#features/editor/feature.ts'
import { writeLink } from '#storage/link.ts'
import { open } from '#storage/projects.ts'
import { fetchWords } from '#words/message.ts'

/** A card of this device, as it is printed. */
interface PrintedCard {
  readonly loaded: LoadedCard
  /** With it anybody opens the card; null: it is too large for a link. */
  readonly address: string | null
}

/** Null where this device has no such card, or it is still being made. */
export async function ownCardNamed(id: string): Promise<PrintedCard | null> {
  const { project } = (await open(id)) ?? {}
  const { ownCard } = project ?? {}
  if (!project || !ownCard || ownCard.draft) return null
  await Promise.all([fetchWords('own-card', 'materials', 'network'), packs.loadFor(project)])
  const link = await writeLink(project)
  const address = link && `${new URL(resolve('/open'), location.href).href}#${link}`
  return { loaded: loadedFrom({ ...project, ownCard }), address }
}
