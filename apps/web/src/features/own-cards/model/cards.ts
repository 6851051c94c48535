import { draftOf } from '@botgarten/content/own-card'
import type { Card } from '@botgarten/content'
import type { OwnCard, Project } from '@botgarten/programs'
import type { Floor } from '@botgarten/simulation'
import { floorToRun, type Packs } from '#lab/opening.ts'
import { freshId, list, open, save, type Listed } from '#storage/projects.ts'
import { language } from '#words/language.svelte.ts'

/** A card that stands on this device. */
export type Standing = Listed & { readonly project: Project & { readonly ownCard: OwnCard } }

const isCard = (one: Listed): one is Standing => one.project.ownCard !== undefined

/** The cards of this device, the last changed first. */
export const cardsHere = async (): Promise<readonly Standing[]> => (await list()).projects.filter(isCard)

/** A card that is being made. */
export interface OpenedDraft {
  readonly id: string
  readonly revision: number
  readonly project: Project & { readonly ownCard: OwnCard }
  readonly floor: Floor
}

/** Null where this device has no such card. */
export async function openDraft(id: string, packs: Packs): Promise<OpenedDraft | null> {
  const found = await open(id)
  if (!found?.project.ownCard?.draft) return null
  const { project, revision } = found
  const { ownCard } = found.project
  return { id, revision, project: { ...project, ownCard }, floor: await floorToRun(project, packs) }
}

const languageHere = () => (language.locale === 'de' ? 'de' : 'en')

/**
 * Makes a card of a project, which itself stays as it is.
 * @param like the card of the house to which the project belongs
 * @returns the id of the project that holds the card; null where this device keeps nothing
 */
export async function beginCard(project: Project, title: string, like?: Card): Promise<string | null> {
  const id = freshId('card')
  const saved = await save(id, draftOf(project, title, languageHere(), like), 0)
  return saved.kind === 'saved' ? id : null
}

/** Puts a card that is finished among the others of this device. Returns its id; null where there is no room. */
export async function keepCard(project: Project): Promise<string | null> {
  const id = freshId('card')
  const saved = await save(id, project, 0)
  return saved.kind === 'saved' ? id : null
}
